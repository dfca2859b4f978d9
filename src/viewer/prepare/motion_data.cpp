#include "viewer/prepare/motion_data.hpp"

#include <algorithm>
#include <chrono>

#include "gpu/device/albedo_tables.hpp"
#include "gpu/device/cloth_store.hpp"

namespace burnish::viewer {

bool MotionTables::ready(gpu::Context& context, const std::vector<std::pair<Brdf, Mdf>>& models) {
    if (work_.valid() && work_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        work_.get();
        context.albedos().require(computed_.first, computed_.second);
    }
    for (const std::pair<Brdf, Mdf>& model : models) {
        if (context.albedos().has(model.first, model.second)) continue;
        if (!work_.valid()) {
            computed_ = model;
            work_ = std::async(std::launch::async,
                               [model] { return albedo_table(model.first, model.second); });
        }
        return false;
    }
    return true;
}

void MotionMeshes::follow(const Scene& scene, std::size_t most) {
    stale_ = work_.valid();
    next_.reset();
    double total = 0;
    for (const Instance& instance : scene.instances)
        if (instance.mesh >= 0)
            total += static_cast<double>(
                scene.meshes[static_cast<std::size_t>(instance.mesh)].indices.size() / 3);
    const double share = static_cast<double>(most) / std::max(total, 1.0);
    // A mesh of a fifth more triangles is as quick as a coarse one.
    if (share > 0.8) return;
    // Fewer triangles than these save no time.
    constexpr std::size_t kFewest = 64;
    next_.emplace();
    wanted_.clear();
    for (const Mesh& mesh : scene.meshes) {
        Mesh& copy = next_->emplace_back();
        copy.positions = mesh.positions;
        copy.indices = mesh.indices;
        const auto part = static_cast<double>(mesh.indices.size() / 3) * share;
        wanted_.push_back(std::max(static_cast<std::size_t>(part), kFewest));
    }
    if (!work_.valid()) begin();
}

void MotionMeshes::begin() {
    work_ = std::async(std::launch::async, [meshes = std::move(*next_), wanted = wanted_] {
        Coarse coarse;
        for (std::size_t i = 0; i < meshes.size(); ++i)
            coarse.push_back(coarse_indices(meshes[i], wanted[i]));
        return coarse;
    });
    next_.reset();
    stale_ = false;
}

bool MotionMeshes::give(gpu::Renderer& renderer) {
    if (!work_.valid() || work_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return false;
    const Coarse coarse = work_.get();
    const bool good = !stale_;
    stale_ = false;
    if (next_) begin();
    if (!good) return false;
    for (std::size_t i = 0; i < coarse.size(); ++i)
        renderer.set_coarse_mesh(static_cast<int>(i), coarse[i]);
    return true;
}

bool MotionCloths::any() const {
    return context_.cloths().coarse_one().has_value();
}

void MotionCloths::begin() {
    if (work_.valid()) return;
    const std::optional<ClothLobe> next = context_.cloths().coarse_one();
    if (!next) return;
    computed_ = *next;
    work_ = std::async(std::launch::async,
                       [lobe = *next] { return cloth_means(lobe, WeaveDetail::full); });
}

bool MotionCloths::give(gpu::Renderer& renderer) {
    gpu::ClothStore& store = context_.cloths();
    if (work_.valid() && work_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
        store.put(computed_, work_.get());
    // Those of another renderer of the context count too.
    if (given_ == store.version()) return false;
    given_ = store.version();
    renderer.refine_cloths();
    return true;
}

void MotionCloths::finish(gpu::Renderer& renderer) {
    if (work_.valid()) work_.wait();
    give(renderer);
    while (const std::optional<ClothLobe> next = context_.cloths().coarse_one()) {
        context_.cloths().put(*next, cloth_means(*next, WeaveDetail::full));
        give(renderer);
    }
}

std::vector<std::pair<Brdf, Mdf>> models_with_tables(const Scene& scene) {
    std::vector<std::pair<Brdf, Mdf>> models;
    for (const Material& material : scene.materials) {
        const std::pair model{material.brdf, material.mdf};
        if (tabulated_of(material) == nullptr && has_half_vectors(material.brdf) &&
            std::ranges::find(models, model) == models.end())
            models.push_back(model);
    }
    return models;
}

}  // namespace burnish::viewer
