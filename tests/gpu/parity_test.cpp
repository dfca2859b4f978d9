// The shading functions on the device against the same text compiled as C++ in float.
#include <algorithm>
#include <array>
#include <cmath>

#include "device_values.hpp"

namespace burnish::test {
namespace {

using f32::vec2;
using f32::vec3;

// Bound of the relative error of a device, times 1 + |ln(D/D0)|. Measured on llvmpipe (LLVM 15):
// 1.3e-6, or 11 units of 2^-23, in the worst distribution, method and model. The bound is twice
// that.
constexpr double kBound = 2.6e-6;

constexpr char kStage[] = R"(
#include "shading"
uniform sampler2D u_wi;  // xyz, xi.x
uniform sampler2D u_wo;  // xyz, xi.y
uniform sampler2D u_n;   // xyz, select
uniform vec2 u_alpha;
layout(location = 0) out vec4 o_values;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 a = texelFetch(u_wi, at, 0);
    vec4 b = texelFetch(u_wo, at, 0);
    vec4 c = texelFetch(u_n, at, 0);
    Lobe lobe = lobe_from_alpha(brdf_mdf(BRDF, MDF), u_alpha.x, u_alpha.y);
    bool along_x = lobe_grooves_along_x(lobe.mdf, lobe.p0, lobe.p1);
    Perturbation p = perturb_make(METHOD, c.xyz, along_x, true);
#ifdef COSINE_POWERS
    float pdf;
    vec3 wi = phong_sample(40.0, b.xyz, vec2(a.w, b.w), pdf);
    o_values = vec4(phong_eval(1.5, 1000.0, a.xyz, b.xyz),
                    lafortune_eval(1.5, vec3(-1.1, -0.9, 0.8), 20.0, a.xyz, b.xyz),
                    ashikhmin_shirley_diffuse(0.6, 0.3, a.z, b.z),
                    pdf / lafortune_pdf(vec3(-1.0, -1.0, 1.0), 40.0, wi, b.xyz));
#elif defined(COSINE_LOBES)
    CosineLobe phong = cosine_lobe_make(kBrdfPhong, -1.0, vec3(0.0), 60.0);
    CosineLobe own = cosine_lobe_make(kBrdfLafortune, 1.5, vec3(-1.1, -0.9, 0.8), 20.0);
    float pdf;
    vec3 wi = cosine_lobe_sample(own, p, b.xyz, vec2(a.w, b.w), pdf);
    o_values = vec4(cosine_lobe_eval(phong, p, a.xyz, b.xyz), cosine_lobe_eval(own, p, a.xyz, b.xyz),
                    cosine_lobe_albedo(own, p, b.xyz), pdf / cosine_lobe_pdf(own, p, wi, b.xyz));
#elif defined(WEAVE_POINT)
    int bits = int(c.w * 32.0);
    WeaveCell cell;
    cell.warp_up = (bits & 1) != 0;
    cell.warp_start = (bits & 2) != 0;
    cell.warp_end = (bits & 4) != 0;
    cell.weft_start = (bits & 8) != 0;
    cell.weft_end = (bits & 16) != 0;
    WeaveShape shape;
    shape.crimp = 0.2;
    shape.bulge = 0.8;
    shape.gap = 0.125;
    shape.twist = vec2(0.8, 0.6);
    WeavePoint w = weave_point(cell, shape, a.w - 0.5, b.w - 0.5);
    o_values = vec4(w.n.xy, w.height, w.warp + 2.0 * w.cover + 4.0 * w.fiber.x);
#elif defined(WIDENED)
    Lobe wide = widen_lobe(lobe, a.w * b.w * 0.2, c.w * c.w * 0.2);
    o_values = vec4(wide.p0, wide.p1, wide.paper_norm, wide.projected_norm);
#elif defined(SAMPLE)
    float pdf;
    vec3 wi = brdf_sample(BRDF, lobe, p, b.xyz, vec2(a.w, b.w), c.w, pdf);
    o_values = vec4(wi, pdf);
#else
    vec3 h = normalize(a.xyz + b.xyz);
    o_values = vec4(lobe_D(lobe, p, h), brdf_eval(BRDF, lobe, p, a.xyz, b.xyz),
                    brdf_pdf(BRDF, lobe, p, a.xyz, b.xyz), fresnel_conductor(0.2, 3.9, dot(a.xyz, h)));
#endif
}
)";

class Parity : public DeviceValues {
  protected:
    std::vector<Row> on_device(int mdf, int brdf, int method, const std::string& stage,
                               glm::vec2 alpha) {
        return values_of(kStage,
                         "#define MDF " + std::to_string(mdf) + "\n#define BRDF " +
                             std::to_string(brdf) + "\n#define METHOD " + std::to_string(method) +
                             "\n#define " + stage + "\n",
                         alpha);
    }

    struct Worst {
        double d = 0, f = 0, pdf = 0, fresnel = 0;
    };

    Worst compare(int mdf, int brdf, int method, glm::vec2 alpha) {
        const auto device = on_device(mdf, brdf, method, "VALUES", alpha);
        const f32::Lobe lobe = f32::lobe_from_alpha(f32::brdf_mdf(brdf, mdf), alpha.x, alpha.y);
        const bool along_x = f32::lobe_grooves_along_x(lobe.mdf, lobe.p0, lobe.p1);
        Worst worst;
        for (std::size_t i = 0; i < kInputCount; ++i) {
            const vec3 wi = xyz(inputs.wi[i]), wo = xyz(inputs.wo[i]);
            const f32::Perturbation p = f32::perturb_make(method, xyz(inputs.n[i]), along_x, true);
            const vec3 h = f32::normalize(wi + wo);
            const double d = f32::lobe_D(lobe, p, h);
            // An error of eps in the argument of exp or pow is an error of |ln(D/D0)| eps of the
            // value.
            const double lost = 1 + std::abs(std::log(std::max(d, 1e-30) / lobe.projected_norm));
            const auto error = [&](float on_device_value, double wanted, double floor) {
                return std::abs(on_device_value - wanted) / (std::abs(wanted) + floor) / lost;
            };
            // Floors: a value below 1e-6 of the peak is invisible in any picture.
            worst.d = std::max(worst.d, error(device[i][0], d, 1e-6 * lobe.projected_norm));
            worst.f = std::max(worst.f, error(device[i][1], f32::brdf_eval(brdf, lobe, p, wi, wo),
                                              1e-5 * lobe.projected_norm));
            worst.pdf =
                std::max(worst.pdf, error(device[i][2], f32::brdf_pdf(brdf, lobe, p, wi, wo),
                                          1e-6 * lobe.projected_norm));
            const double fresnel = f32::fresnel_conductor(0.2f, 3.9f, f32::dot(wi, h));
            worst.fresnel = std::max(worst.fresnel, std::abs(device[i][3] - fresnel));
        }
        return worst;
    }
};

TEST_F(Parity, EveryDistributionAndMethodAgrees) {
    for (int mdf = 0; mdf < static_cast<int>(mdf_names().size()); ++mdf) {
        for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
            const Worst worst = compare(mdf, f32::kBrdfMicrofacet, method, {0.15f, 0.5f});
            const std::string what = std::string(name_of(static_cast<Mdf>(mdf))) + " " +
                                     std::string(name_of(static_cast<Method>(method)));
            RecordProperty(what + " D", std::to_string(worst.d));
            if (std::getenv("BURNISH_PRINT_PARITY") != nullptr) {
                std::printf("%-36s D %.2e f %.2e pdf %.2e F %.2e\n", what.c_str(), worst.d, worst.f,
                            worst.pdf, worst.fresnel);
            }
            EXPECT_LT(worst.d, kBound) << what;
            EXPECT_LT(worst.f, kBound) << what;
            EXPECT_LT(worst.pdf, kBound) << what;
            EXPECT_LT(worst.fresnel, 1e-6) << what;
        }
    }
}

TEST_F(Parity, EveryModelAgrees) {
    for (int brdf = 0; brdf <= f32::kBrdfCookTorrance; ++brdf) {
        for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
            const Worst worst = compare(f32::kMdfGgx, brdf, method, {0.5f, 0.2f});
            const std::string what = std::string(name_of(static_cast<Brdf>(brdf))) + " " +
                                     std::string(name_of(static_cast<Method>(method)));
            EXPECT_LT(worst.f, kBound) << what;
            EXPECT_LT(worst.pdf, kBound) << what;
        }
    }
}

// Models without a distribution. Phong with an exponent of 1,000: rounding of the chord between
// unit vectors, 2^-24, relative to a lobe 0.03 wide, twice (the square), times |ln f|.
TEST_F(Parity, ModelsWithoutADistributionAgree) {
    const auto device = on_device(f32::kMdfGgx, f32::kBrdfMicrofacet, f32::kMethodNone,
                                  "COSINE_POWERS", {0.3f, 0.3f});
    for (std::size_t i = 0; i < kInputCount; ++i) {
        const vec3 wi = xyz(inputs.wi[i]), wo = xyz(inputs.wo[i]);
        const auto expect = [&](float found, double wanted, double scale) {
            const double lost = 1 + std::abs(std::log(std::max(wanted, 1e-30) / scale));
            EXPECT_NEAR(found, wanted, 1e-5 * lost * wanted + 1e-6 * scale) << i;
        };
        expect(device[i][0], f32::phong_eval(1.5f, 1000.0f, wi, wo), 1.5);
        expect(device[i][1], f32::lafortune_eval(1.5f, {-1.1f, -0.9f, 0.8f}, 20.0f, wi, wo), 1.5);
        expect(device[i][2], f32::ashikhmin_shirley_diffuse(0.6f, 0.3f, wi.z, wo.z), 0.1);
        // With C = (-1, -1, 1) the lobe of lafortune is that of phong; the device makes both
        // samplers.
        EXPECT_NEAR(device[i][3], 1.0f, 1e-4f) << i;
    }
}

// phong and lafortune under every method. As above, with 1e-5 for the error of the power: n = 60
// times the rounding of a dot product.
TEST_F(Parity, CosineLobesAgreeUnderEveryMethodButThoseOfFacets) {
    const f32::CosineLobe phong = f32::cosine_lobe_make(f32::kBrdfPhong, -1.0f, {0, 0, 0}, 60.0f);
    const f32::CosineLobe own =
        f32::cosine_lobe_make(f32::kBrdfLafortune, 1.5f, {-1.1f, -0.9f, 0.8f}, 20.0f);
    for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
        if (f32::method_moves_facets(method)) continue;  // brdf_takes_method: there are no facets
        const auto device =
            on_device(f32::kMdfGgx, f32::kBrdfPhong, method, "COSINE_LOBES", {0.3f, 0.3f});
        for (std::size_t i = 0; i < kInputCount; ++i) {
            const vec3 wi = xyz(inputs.wi[i]), wo = xyz(inputs.wo[i]);
            const f32::Perturbation p = f32::perturb_make(method, xyz(inputs.n[i]), true, true);
            const auto expect = [&](float found, double wanted, double scale) {
                const double lost = 1 + std::abs(std::log(std::max(wanted, 1e-30) / scale));
                EXPECT_NEAR(found, wanted, 1e-5 * lost * wanted + 1e-6 * scale)
                    << i << " " << name_of(static_cast<Method>(method));
            };
            // Horizons are sharp: rounding decides the side of a cosine near 0.
            if (std::abs(f32::dot(p.n, wi)) < 1e-5f || std::abs(f32::dot(p.n, wo)) < 1e-5f)
                continue;
            expect(device[i][0], f32::cosine_lobe_eval(phong, p, wi, wo), phong.ks);
            expect(device[i][1], f32::cosine_lobe_eval(own, p, wi, wo), own.ks);
            EXPECT_NEAR(device[i][2], f32::cosine_lobe_albedo(own, p, wo), 1e-4f * own.ks) << i;
            EXPECT_NEAR(device[i][3], 1.0f, 1e-4f) << i;
        }
    }
}

// Slopes within 4 units of single precision. Edges agree exactly, because they are comparisons of
// floats.
TEST_F(Parity, WovenPointsAgree) {
    const auto device = on_device(f32::kMdfGgx, f32::kBrdfMicrofacet, f32::kMethodNone,
                                  "WEAVE_POINT", {0.3f, 0.3f});
    const f32::WeaveShape shape{0.2f, 0.8f, 0.125f, {0.8f, 0.6f}};
    for (std::size_t i = 0; i < kInputCount; ++i) {
        const int bits = static_cast<int>(inputs.n[i][3] * 32.0f);
        const f32::WeaveCell cell{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0,
                                  (bits & 8) != 0, (bits & 16) != 0};
        const f32::WeavePoint w =
            f32::weave_point(cell, shape, inputs.wi[i][3] - 0.5f, inputs.wo[i][3] - 0.5f);
        EXPECT_NEAR(device[i][0], w.n.x, 2e-6f) << i;
        EXPECT_NEAR(device[i][1], w.n.y, 2e-6f) << i;
        EXPECT_NEAR(device[i][2], w.height, 2e-6f) << i;
        EXPECT_EQ(device[i][3], w.warp + 2 * w.cover + 4 * w.fiber.x) << i;
    }
}

TEST_F(Parity, WidenedLobesAgree) {
    for (int mdf = 0; mdf < static_cast<int>(mdf_names().size()); ++mdf) {
        const auto device =
            on_device(mdf, f32::kBrdfMicrofacet, f32::kMethodNone, "WIDENED", {0.15f, 0.5f});
        const f32::Lobe lobe = f32::lobe_from_alpha(mdf, 0.15f, 0.5f);
        for (std::size_t i = 0; i < kInputCount; ++i) {
            const float select = inputs.n[i][3];
            const f32::Lobe wide = f32::widen_lobe(lobe, inputs.wi[i][3] * inputs.wo[i][3] * 0.2f,
                                                   select * select * 0.2f);
            const float wanted[] = {wide.p0, wide.p1, wide.paper_norm, wide.projected_norm};
            // Exponents down to 3 are computed by subtracting 2.
            const float floor[] = {mdf == f32::kMdfAshikhminShirley ? 2.0f : 0.0f, 2.0f, 0.0f,
                                   0.0f};
            for (std::size_t k = 0; k < 4; ++k) {
                EXPECT_NEAR(device[i][k], wanted[k], kBound * (wanted[k] + floor[k]))
                    << name_of(static_cast<Mdf>(mdf)) << " " << i << " " << k;
            }
        }
    }
}

// Each sample has the direction and the density of the C++ text.
TEST_F(Parity, SamplesAgree) {
    const glm::vec2 alpha(0.15f, 0.5f);
    for (int mdf = 0; mdf < static_cast<int>(mdf_names().size()); ++mdf) {
        for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
            const auto device = on_device(mdf, f32::kBrdfMicrofacet, method, "SAMPLE", alpha);
            const f32::Lobe lobe = f32::lobe_from_alpha(mdf, alpha.x, alpha.y);
            const bool along_x = f32::lobe_grooves_along_x(mdf, lobe.p0, lobe.p1);
            std::vector<double> errors, densities;
            for (std::size_t i = 0; i < kInputCount; ++i) {
                const f32::Perturbation p =
                    f32::perturb_make(method, xyz(inputs.n[i]), along_x, true);
                float pdf = 0;
                const vec3 wi =
                    f32::brdf_sample(f32::kBrdfMicrofacet, lobe, p, xyz(inputs.wo[i]),
                                     vec2(inputs.wi[i][3], inputs.wo[i][3]), inputs.n[i][3], pdf);
                errors.push_back(f32::length(wi - xyz(device[i])));
                densities.push_back(std::abs(device[i][3] - pdf) / (pdf + 1e-2));
            }
            std::sort(errors.begin(), errors.end());
            std::sort(densities.begin(), densities.end());
            // 99 %: the other samples lie at a branch (select at a part of the mixture) or at the
            // rim.
            const std::size_t most = kInputCount * 99 / 100;
            if (std::getenv("BURNISH_PRINT_PARITY") != nullptr) {
                std::printf("sample %d %d: 99%% %.2e worst %.2e density 99%% %.2e worst %.2e\n",
                            mdf, method, errors[most], errors.back(), densities[most],
                            densities.back());
            }
            const std::string what = std::string(name_of(static_cast<Mdf>(mdf))) + " " +
                                     std::string(name_of(static_cast<Method>(method)));
            // Measured: 3.3e-6 and 1.1e-5, for ashikhmin-shirley, whose exponent is 87.
            EXPECT_LT(errors[most], 1e-5) << what;
            EXPECT_LT(densities[most], 4e-5) << what;
        }
    }
}

}  // namespace
}  // namespace burnish::test
