// A whole surface on the device, in float and in double: one text (shading/), three compilers. The
// compared values are those of surface_words.glsl, which all three compile.
#include <fstream>
#include <iterator>

#include "burnish/f64.hpp"
#include "device_values.hpp"
#include "support/paths.hpp"

// The order is significant.
// clang-format off
namespace burnish::f32 {
#include "shading/prelude_begin.hpp"
#include "surface_words.glsl"
#include "shading/prelude_end.hpp"
}  // namespace burnish::f32

namespace burnish::f64 {
#include "shading/prelude_begin.hpp"
#include "surface_words.glsl"
#include "shading/prelude_end.hpp"
}  // namespace burnish::f64
// clang-format on

namespace burnish::test {
namespace {

constexpr char kMain[] = R"(
uniform sampler2D u_wi;
uniform sampler2D u_wo;
uniform sampler2D u_n;
uniform vec2 u_alpha;
layout(location = 0) out vec4 o_values;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 a = texelFetch(u_wi, at, 0);
    vec4 b = texelFetch(u_wo, at, 0);
    vec4 c = texelFetch(u_n, at, 0);
    vec2 xi = vec2(a.w, b.w);
#ifdef WORD
    o_values = vec4(parity_word(WORD, a.xyz, b.xyz, c.xyz, xi, c.w), 0.0);
#else
    SurfaceMaterial m = parity_material(BRDF, MDF, FRESNEL, true);
#ifdef DIRECTION
    o_values = vec4(parity_direction(m, METHOD, a.xyz, b.xyz, c.xyz, xi, c.w), 0.0);
#else
    o_values = vec4(parity_eval(m, METHOD, a.xyz, b.xyz, c.xyz, xi, c.w),
                    parity_pdf(m, METHOD, a.xyz, b.xyz, c.xyz, xi, c.w));
#endif
#endif
}
)";

std::string stage_text() {
    std::ifstream in(test::source_folder() / "tests/gpu/surface_words.glsl");
    const std::string words{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    return "#include \"shading\"\n" + words + kMain;
}

std::string define(const char* name, int value) {
    return "#define " + std::string(name) + " " + std::to_string(value) + "\n";
}

// One kind of lobe.
struct Kind {
    int brdf, mdf, fresnel;
};

std::vector<Kind> kinds() {
    std::vector<Kind> list;
    for (int mdf = 0; mdf < static_cast<int>(mdf_names().size()); ++mdf)
        list.push_back({f32::kBrdfMicrofacet, mdf, f32::kFresnelSchlick});
    for (int brdf = f32::kBrdfMicrofacetSeparable; brdf <= f32::kBrdfHe; ++brdf) {
        const int fresnel = brdf == f32::kBrdfTabulated ? f32::kFresnelDielectric
                            : brdf == f32::kBrdfWardGmd ? f32::kFresnelConductor
                            : brdf == f32::kBrdfWard    ? f32::kFresnelCurve
                                                        : f32::kFresnelSchlick;
        list.push_back({brdf, f32::kMdfGgx, fresnel});
    }
    return list;
}

bool prints() {
    return std::getenv("BURNISH_PRINT_PARITY") != nullptr;
}

std::string label_of(const Kind& kind, int method) {
    return "brdf " + std::to_string(kind.brdf) + " mdf " + std::to_string(kind.mdf) + " " +
           std::string(name_of(static_cast<Method>(method)));
}

struct Four {
    double v[4];
};

#define BURNISH_SURFACE_AT(ns)                                                                    \
    struct Input_##ns {                                                                           \
        ns::vec3 a, b, n;                                                                         \
        ns::vec2 xi;                                                                              \
        ns::Float select;                                                                         \
        Input_##ns(const Row& wi, const Row& wo, const Row& normal)                               \
            : a(wi[0], wi[1], wi[2]),                                                             \
              b(wo[0], wo[1], wo[2]),                                                             \
              n(normal[0], normal[1], normal[2]),                                                 \
              xi(wi[3], wo[3]),                                                                   \
              select(normal[3]) {}                                                                \
    };                                                                                            \
    Four surface_at(const Kind& k, int method, const Input_##ns& in) {                            \
        const ns::SurfaceMaterial m = ns::parity_material(k.brdf, k.mdf, k.fresnel, true);        \
        const ns::vec3 f = ns::parity_eval(m, method, in.a, in.b, in.n, in.xi, in.select);        \
        const ns::Float pdf = ns::parity_pdf(m, method, in.a, in.b, in.n, in.xi, in.select);      \
        return {{static_cast<double>(f.x), static_cast<double>(f.y), static_cast<double>(f.z),    \
                 static_cast<double>(pdf)}};                                                      \
    }                                                                                             \
    Four direction_at(const Kind& k, int method, const Input_##ns& in) {                          \
        const ns::SurfaceMaterial m = ns::parity_material(k.brdf, k.mdf, k.fresnel, true);        \
        const ns::vec3 w = ns::parity_direction(m, method, in.a, in.b, in.n, in.xi, in.select);   \
        return {                                                                                  \
            {static_cast<double>(w.x), static_cast<double>(w.y), static_cast<double>(w.z), 0.0}}; \
    }                                                                                             \
    Four word_at(int word, const Input_##ns& in) {                                                \
        const ns::vec3 w = ns::parity_word(word, in.a, in.b, in.n, in.xi, in.select);             \
        return {                                                                                  \
            {static_cast<double>(w.x), static_cast<double>(w.y), static_cast<double>(w.z), 0.0}}; \
    }
BURNISH_SURFACE_AT(f32)
BURNISH_SURFACE_AT(f64)
#undef BURNISH_SURFACE_AT

// The largest difference |x - y| / (|y| + 0.01) over four numbers.
double difference(const double* x, const double* y) {
    double worst = 0;
    for (int k = 0; k < 4; ++k)
        worst = std::max(worst, std::abs(x[k] - y[k]) / (std::abs(y[k]) + 0.01));
    return worst;
}

Four four_of(const Row& row) {
    return {{double{row[0]}, double{row[1]}, double{row[2]}, double{row[3]}}};
}

// The error at the quantile `share`. The remaining inputs may differ by more than the bound,
// because rounding decides the side of an edge (the horizon of n~, the rim of a deformation, the
// part of a mixture).
double at_share(std::vector<double> errors, double share) {
    std::sort(errors.begin(), errors.end());
    return errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
}

class SurfaceParity : public DeviceValues {
  protected:
    std::string stage = stage_text();

    Input_f32 single(std::size_t i) const { return {inputs.wi[i], inputs.wo[i], inputs.n[i]}; }
    Input_f64 twice(std::size_t i) const { return {inputs.wi[i], inputs.wo[i], inputs.n[i]}; }
};

TEST_F(SurfaceParity, EveryMethodAndKindOfLobe) {
    for (const Kind& kind : kinds()) {
        for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
            if (!f32::brdf_takes_method(kind.brdf, method)) continue;
            const auto device =
                values_of(stage, define("BRDF", kind.brdf) + define("MDF", kind.mdf) +
                                     define("FRESNEL", kind.fresnel) + define("METHOD", method));
            std::vector<double> to_single, to_double;
            for (std::size_t i = 0; i < inputs.wi.size(); ++i) {
                const Four s = surface_at(kind, method, single(i));
                to_single.push_back(difference(four_of(device[i]).v, s.v));
                to_double.push_back(difference(s.v, surface_at(kind, method, twice(i)).v));
            }
            if (prints()) {
                std::printf("%-32s GLSL-f32 %.1e %.1e f32-f64 %.1e %.1e\n",
                            label_of(kind, method).c_str(), at_share(to_single, 0.995),
                            at_share(to_single, 1), at_share(to_double, 0.995),
                            at_share(to_double, 1));
            }
            // Measured on llvmpipe: 3.6e-6, and 2.6e-5 between float and double, in the worst input.
            EXPECT_LT(at_share(to_single, 1), 1e-5) << label_of(kind, method);
            EXPECT_LT(at_share(to_double, 1), 8e-5) << label_of(kind, method);
        }
    }
}

TEST_F(SurfaceParity, DirectionsAgree) {
    for (const Kind& kind : kinds()) {
        for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
            if (!f32::brdf_takes_method(kind.brdf, method)) continue;
            const auto device =
                values_of(stage, define("BRDF", kind.brdf) + define("MDF", kind.mdf) +
                                     define("FRESNEL", kind.fresnel) + define("METHOD", method) +
                                     "#define DIRECTION\n");
            std::vector<double> to_single, to_double;
            for (std::size_t i = 0; i < inputs.wi.size(); ++i) {
                const Four s = direction_at(kind, method, single(i));
                to_single.push_back(difference(four_of(device[i]).v, s.v));
                to_double.push_back(difference(s.v, direction_at(kind, method, twice(i)).v));
            }
            if (prints()) {
                std::printf("direction %-32s GLSL-f32 %.1e %.1e f32-f64 %.1e %.1e\n",
                            label_of(kind, method).c_str(), at_share(to_single, 0.98),
                            at_share(to_single, 1), at_share(to_double, 0.98),
                            at_share(to_double, 1));
            }
            // Measured: 1.3e-5 and 6.2e-6.
            EXPECT_LT(at_share(to_single, 0.98), 4e-5) << label_of(kind, method);
            EXPECT_LT(at_share(to_double, 0.98), 2e-5) << label_of(kind, method);
        }
    }
}

TEST_F(SurfaceParity, EveryWordAgrees) {
    for (int word = 0; word < f32::kParityWords; ++word) {
        const auto device = values_of(stage, define("WORD", word));
        std::vector<double> to_single, to_double;
        for (std::size_t i = 0; i < inputs.wi.size(); ++i) {
            const Four s = word_at(word, single(i));
            to_single.push_back(difference(four_of(device[i]).v, s.v));
            to_double.push_back(difference(s.v, word_at(word, twice(i)).v));
        }
        if (prints()) {
            std::printf("word %2d GLSL-f32 %.1e %.1e f32-f64 %.1e %.1e\n", word,
                        at_share(to_single, 0.995), at_share(to_single, 1),
                        at_share(to_double, 0.995), at_share(to_double, 1));
        }
        // Measured: 1.7e-5 and 1.9e-5 (a normal of two channels, whose z is the root of a
        // difference); 9e-5 in the worst input.
        EXPECT_LT(at_share(to_single, 0.995), 5e-5) << word;
        EXPECT_LT(at_share(to_double, 0.995), 6e-5) << word;
        EXPECT_LT(at_share(to_single, 1), 3e-4) << word;
    }
}

}  // namespace
}  // namespace burnish::test
