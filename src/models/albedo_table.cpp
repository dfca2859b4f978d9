#include "models/albedo_table.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <mutex>
#include <utility>

#include "core/parallel.hpp"
#include "models/albedo_nodes.hpp"

namespace burnish {
namespace {

// Of the models that the build makes no tables of.
constexpr std::uint32_t kSamples = 768;

float sampled_albedo(int brdf, int mdf, const AlbedoNode& node) {
    const f32::vec3 up{0.0f, 0.0f, 1.0f};
    const f32::Perturbation flat = f32::perturb_make(f32::kMethodNone, up, true, false);
    const f32::Lobe lobe = f32::lobe_from_alpha(mdf, node.along, node.across);
    const f32::vec3 wo{std::sqrt(1.0f - node.cosine * node.cosine), 0.0f, node.cosine};
    double sum = 0;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
        float pdf = 0;
        const f32::vec3 wi = f32::brdf_sample(brdf, lobe, flat, wo, albedo_point(i), 0.5f, pdf);
        if (!(pdf > 0.0f) || !(wi.z > 0.0f)) continue;
        sum += static_cast<double>(f32::brdf_eval(brdf, lobe, flat, wi, wo) * wi.z / pdf);
    }
    return static_cast<float>(sum / kSamples);
}

std::vector<std::array<float, 3>> read_nodes(std::span<const std::int16_t> made) {
    std::vector<std::array<float, 3>> nodes(kAlbedoNodes);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            nodes[i][c] = static_cast<float>(made[3 * i + c]) / kAlbedoScale;
    return nodes;
}

std::vector<std::array<float, 3>> sample_nodes(int brdf, int mdf) {
    std::vector<std::array<float, 3>> nodes(kAlbedoNodes);
    parallel_for(nodes.size(), kAlbedoAlphas, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            nodes[i][0] = sampled_albedo(brdf, mdf, albedo_node(mdf, static_cast<int>(i)));
    });
    return nodes;
}

// The cell below a coordinate of `count` nodes, and the position in it.
std::pair<int, double> cell_of(double coordinate, int count) {
    const double at = std::clamp(coordinate, 0.0, 1.0) * (count - 1);
    const int cell = std::min(static_cast<int>(at), count - 2);
    return {cell, at - cell};
}

}  // namespace

AlbedoTable::AlbedoTable(Brdf brdf, Mdf mdf) {
    const int model = static_cast<int>(brdf);
    const int distribution = f32::brdf_mdf(model, static_cast<int>(mdf));
    nodes_ = f32::brdf_masks(model)
                 ? read_nodes(made_albedos(brdf == Brdf::microfacet_separable, distribution))
                 : sample_nodes(model, distribution);
}

double AlbedoTable::at(const f64::AlbedoPlace& place) const {
    const auto [x, fx] = cell_of(place.at.x, kAlbedoAlphas);
    const auto [y, fy] = cell_of(place.at.y, kAlbedoAlphas);
    const auto [z, fz] = cell_of(place.at.z, kAlbedoCosines);
    f64::vec3 sum(0, 0, 0);
    for (int corner = 0; corner < 8; ++corner) {
        const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
        const double weight = (dx ? fx : 1 - fx) * (dy ? fy : 1 - fy) * (dz ? fz : 1 - fz);
        const int index = ((z + dz) * kAlbedoAlphas + y + dy) * kAlbedoAlphas + x + dx;
        const std::array<float, 3>& c = nodes_[static_cast<std::size_t>(index)];
        sum = sum + f64::vec3(double{c[0]}, double{c[1]}, double{c[2]}) * weight;
    }
    return f64::albedo_value(place, sum);
}

f64::SurfaceMaterial compensated(const f64::SurfaceMaterial& material, const AlbedoTable& table,
                                 const f64::Perturbation& p, f64::vec3 wo) {
    const f64::AlbedoPlace place = f64::albedo_place_of(material.lobe, p, wo);
    return f64::surface_compensated(material, table.at(place));
}

std::shared_ptr<const AlbedoTable> albedo_table(Brdf brdf, Mdf mdf) {
    static std::mutex mutex;
    static std::map<std::pair<int, int>, std::shared_ptr<const AlbedoTable>> tables;
    const int model = static_cast<int>(brdf);
    const std::pair<int, int> key{model, f32::brdf_mdf(model, static_cast<int>(mdf))};
    {
        const std::scoped_lock lock(mutex);
        if (const auto found = tables.find(key); found != tables.end()) return found->second;
    }
    // Not under the lock: a thread that waits for the parallel loop may run a task that comes here.
    auto table = std::make_shared<const AlbedoTable>(brdf, mdf);
    const std::scoped_lock lock(mutex);
    return tables.emplace(key, std::move(table)).first->second;
}

}  // namespace burnish
