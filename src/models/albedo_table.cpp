#include "models/albedo_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "burnish/f32.hpp"
#include "core/parallel.hpp"

namespace burnish {
namespace {

constexpr std::uint32_t kSamples = 1024;
constexpr float kLow = 0.01f;

float unit_of(std::uint32_t bits) {
    return static_cast<float>(bits >> 8) * (1.0f / 16777216.0f);
}

// The R2 sequence of shaders/lib/random.glsl.
float albedo(int brdf, const f32::Lobe& lobe, float cosine) {
    const f32::vec3 up{0.0f, 0.0f, 1.0f};
    const f32::Perturbation flat = f32::perturb_make(f32::kMethodNone, up, true, false);
    const f32::vec3 wo{std::sqrt(1.0f - cosine * cosine), 0.0f, cosine};
    double sum = 0;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
        const f32::vec2 xi{unit_of(i * 3242174889u + 0x80000000u),
                           unit_of(i * 2447445414u + 0x80000000u)};
        float pdf = 0;
        const f32::vec3 wi = f32::brdf_sample(brdf, lobe, flat, wo, xi, 0.5f, pdf);
        if (!(pdf > 0.0f) || !(wi.z > 0.0f)) continue;
        sum += static_cast<double>(f32::brdf_eval(brdf, lobe, flat, wi, wo) * wi.z / pdf);
    }
    return static_cast<float>(sum / kSamples);
}

float node(int i, int count) {
    return static_cast<float>(i) / static_cast<float>(count - 1);
}

}  // namespace

std::vector<float> albedo_table(Brdf brdf, Mdf mdf) {
    const int model = static_cast<int>(brdf);
    const int distribution = f32::brdf_mdf(model, static_cast<int>(mdf));
    std::vector<float> table(static_cast<std::size_t>(kAlbedoAlphas) * kAlbedoAlphas *
                             kAlbedoCosines);
    parallel_for(table.size(), kAlbedoAlphas, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const int index = static_cast<int>(i);
            const float along = node(index % kAlbedoAlphas, kAlbedoAlphas);
            const float across = node(index / kAlbedoAlphas % kAlbedoAlphas, kAlbedoAlphas);
            const float cosine = node(index / (kAlbedoAlphas * kAlbedoAlphas), kAlbedoCosines);
            const f32::Lobe lobe = f32::lobe_from_alpha(distribution, std::max(along * along, kLow),
                                                        std::max(across * across, kLow));
            table[i] = albedo(model, lobe, std::max(cosine, kLow));
        }
    });
    return table;
}

}  // namespace burnish
