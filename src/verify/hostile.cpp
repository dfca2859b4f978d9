#include "verify/hostile.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "burnish/f32.hpp"
#include "burnish/f64.hpp"

namespace burnish::verify {
namespace {

// Unit to rounding; the last ones stand at the horizon, the very last lies below it.
template <typename Vec3, typename Float>
std::vector<Vec3> hostile_directions() {
    const Float tiny = std::numeric_limits<Float>::denorm_min() * 4;
    const Float s = std::sqrt(Float(0.5));
    const Float grazing = std::sin(Float(0.001745329));  // 0.1 degrees
    return {{0, 0, 1},
            {Float(0.6), 0, Float(0.8)},
            {0, Float(-0.6), Float(0.8)},
            {1, 0, grazing},
            {0, -1, grazing},
            {-s, s, grazing},
            {1, 0, 0},
            {0, 1, 0},
            {1, 0, tiny},
            {-1, 0, tiny},
            {0, -1, tiny},
            {s, s, Float(1e-8)},
            {-s, -s, Float(1e-8)},
            {tiny, 0, 1},
            {tiny, -tiny, 1},
            {Float(1e-20), Float(-1e-20), 1},
            {0, -s, -s}};
}

// Perturbed normals: nz >= 0, the last ones as near the horizon as it gets.
template <typename Vec3, typename Float>
std::vector<Vec3> hostile_normals() {
    const Float tiny = std::numeric_limits<Float>::denorm_min() * 4;
    const Float s = std::sqrt(Float(0.5));
    const Float grazing = std::sin(Float(0.001745329));
    return {{0, 0, 1},
            {tiny, 0, 1},
            {1, 0, grazing},
            {0, 1, grazing},
            {-s, s, grazing},
            {1, 0, Float(1e-4)},
            {0, -1, Float(1e-4)},
            {1, 0, tiny},
            {0, 1, tiny},
            {s, s, tiny},
            {1, 0, 0},
            {0, -1, 0}};
}

#define BURNISH_HOSTILE_FAILURES(ns)                                                        \
    int failures_##ns(int mdf, double x, double y, int method) {                            \
        using Float = ns::Float;                                                            \
        const auto p0 = static_cast<Float>(x), p1 = static_cast<Float>(y);                  \
        const ns::Lobe own = ns::lobe_make(mdf, p0, p1);                                    \
        const ns::Lobe beckmann =                                                           \
            ns::lobe_make(ns::kMdfBeckmann, ns::lobe_alpha_x(own), ns::lobe_alpha_y(own));  \
        const bool along_x = ns::lobe_grooves_along_x(mdf, p0, p1);                         \
        const ns::vec3 odd{Float(-10), Float(0), Float(0.3)};                               \
        const std::vector<ns::CosineLobe> cosine_lobes = {                                  \
            ns::cosine_lobe_make(ns::kBrdfPhong, Float(-1), odd, Float(1e5)),               \
            ns::cosine_lobe_make(ns::kBrdfPhong, Float(1e6), odd, Float(0)),                \
            ns::cosine_lobe_make(ns::kBrdfLafortune, Float(1e6), odd, Float(1e5)),          \
            ns::cosine_lobe_make(ns::kBrdfLafortune, Float(-1), odd * Float(0), Float(3))}; \
        int failures = 0;                                                                   \
        const auto expect = [&](Float v) { failures += v >= 0 && v < HUGE_VALF ? 0 : 1; };  \
        std::vector<ns::vec3> directions = hostile_directions<ns::vec3, Float>();           \
        for (const ns::vec3& n : hostile_normals<ns::vec3, Float>()) {                      \
            const ns::Perturbation p = ns::perturb_make(method, n, along_x, true);          \
            directions.back() = n;                                                          \
            for (const ns::vec3& wi : directions) {                                         \
                expect(ns::lobe_D(own, p, wi));                                             \
                Float pdf = 0;                                                              \
                const ns::vec3 drawn =                                                      \
                    ns::brdf_sample(ns::kBrdfMicrofacet, own, p, wi,                        \
                                    {Float(0.3), Float(0.999999)}, Float(0.7), pdf);        \
                expect(pdf);                                                                \
                expect(ns::dot(drawn, drawn));                                              \
                for (const ns::vec3& wo : directions) {                                     \
                    expect(ns::brdf_pdf(ns::kBrdfMicrofacet, own, p, wi, wo));              \
                    for (int brdf = 0; brdf <= ns::kBrdfCookTorrance; ++brdf) {             \
                        const bool has_own = ns::brdf_mdf(brdf, mdf) == mdf;                \
                        expect(ns::brdf_eval(brdf, has_own ? own : beckmann, p, wi, wo));   \
                    }                                                                       \
                    for (const ns::CosineLobe& lobe : cosine_lobes) {                       \
                        expect(ns::cosine_lobe_eval(lobe, p, wi, wo));                      \
                        expect(ns::cosine_lobe_pdf(lobe, p, wi, wo));                       \
                    }                                                                       \
                }                                                                           \
            }                                                                               \
        }                                                                                   \
        return failures;                                                                    \
    }
BURNISH_HOSTILE_FAILURES(f32)
BURNISH_HOSTILE_FAILURES(f64)
#undef BURNISH_HOSTILE_FAILURES

}  // namespace

HostileCounts hostile_counts(int mdf, double p0, double p1, int method) {
    const std::size_t directions = hostile_directions<f64::vec3, double>().size();
    const std::size_t models = static_cast<std::size_t>(f64::kBrdfCookTorrance) + 1;
    HostileCounts counts;
    counts.broken_f32 = failures_f32(mdf, p0, p1, method);
    counts.broken_f64 = failures_f64(mdf, p0, p1, method);
    // D, the sample and its density, then the density and the value of every model, and both of four cosine lobes.
    counts.combinations = hostile_normals<f64::vec3, double>().size() * directions *
                          (3 + directions * (1 + models + 2 * 4));
    return counts;
}

}  // namespace burnish::verify
