// Build step: writes the source of made_albedos (albedo_nodes.hpp) to the standard output.
#include <array>
#include <cmath>
#include <cstdio>
#include <thread>
#include <vector>

#include "models/albedo_nodes.hpp"

namespace burnish {
namespace {

// Where the mixed term is sampled to fit the polynomial. 1 would be a lobe without width.
constexpr std::array<double, 4> kMixed = {0.0, 0.4, 0.75, 0.96};

constexpr std::uint32_t kSamples = 640;
constexpr std::array<int, 4> kMdfs = {f32::kMdfAshikhminShirley, f32::kMdfWard, f32::kMdfBeckmann,
                                      f32::kMdfGgx};

struct Albedos {
    double correlated = 0, separable = 0;
};

// The lobe whose covariance in the axes of the view is given, and the azimuth of the view in it.
struct TurnedLobe {
    f32::Lobe lobe;
    float azimuth;
};

// Exponents of Ashikhmin and Shirley down to -1, where the formulas still hold: a node at the end of the
// table may have a larger alpha than any lobe that is drawn, and the values between nodes go on smoothly.
f32::Lobe lobe_with(int mdf, float alpha_x, float alpha_y) {
    const auto exponent = [](float alpha) { return 2.0f / (alpha * alpha) - 2.0f; };
    return mdf == f32::kMdfAshikhminShirley
               ? f32::lobe_make(mdf, exponent(alpha_x), exponent(alpha_y))
               : f32::lobe_from_alpha(mdf, alpha_x, alpha_y);
}

TurnedLobe turned_lobe(int mdf, const AlbedoNode& node, double mixed) {
    const double a = std::pow(static_cast<double>(node.along), 2);
    const double b = std::pow(static_cast<double>(node.across), 2);
    const double off = std::sqrt(mixed * a * b);
    const double middle = 0.5 * (a + b), difference = 0.5 * (a - b);
    const double reach = std::hypot(difference, off);
    const auto low = static_cast<float>(std::sqrt(std::max(middle - reach, 0.0)));
    return {lobe_with(mdf, static_cast<float>(std::sqrt(middle + reach)),
                      std::max(low, f32::kLowestAlpha)),
            static_cast<float>(0.5 * std::atan2(off, difference))};
}

// Int D G2/(4 cos_o) dwi over half vectors h that GGX of the same alphas shows to wo: the mean of
// D G2 (wo.h)/cos_o over their density.
Albedos albedos_of(const TurnedLobe& t, float cosine) {
    const float sine = std::sqrt(1.0f - cosine * cosine);
    const f32::vec3 wo{sine * std::cos(t.azimuth), sine * std::sin(t.azimuth), cosine};
    const f32::Perturbation flat =
        f32::perturb_make(f32::kMethodNone, f32::vec3(0.0f, 0.0f, 1.0f), true, false);
    const f32::Lobe drawn =
        f32::lobe_make(f32::kMdfGgx, f32::lobe_alpha_x(t.lobe), f32::lobe_alpha_y(t.lobe));
    const float lambda_o = f32::smith_lambda(t.lobe, wo);
    Albedos sum;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
        const f32::vec3 h = f32::visible_normal_sample(
            drawn.p0, drawn.p1, f32::visible_cap_bound(drawn, flat, wo), wo, albedo_point(i));
        const f32::vec3 wi = f32::reflect_about(wo, h);
        const float wo_h = f32::dot(wo, h);
        if (!(wo_h > 0.0f) || !(wi.z > 0.0f)) continue;
        const float over = f32::lobe_D(t.lobe, flat, h) * wo_h /
                           (cosine * f32::visible_normal_pdf(drawn, flat, wo, h));
        const float lambda_i = f32::smith_lambda(t.lobe, wi);
        sum.correlated += static_cast<double>(over / (1.0f + lambda_o + lambda_i));
        sum.separable += static_cast<double>(over / ((1.0f + lambda_o) * (1.0f + lambda_i)));
    }
    return {sum.correlated / kSamples, sum.separable / kSamples};
}

// The parabola through the first value that is nearest to the others.
std::array<double, 3> parabola(const std::array<double, kMixed.size()>& values) {
    double xx = 0, xxx = 0, xxxx = 0, xy = 0, xxy = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double x = kMixed[i], y = values[i] - values[0];
        xx += x * x;
        xxx += x * x * x;
        xxxx += x * x * x * x;
        xy += x * y;
        xxy += x * x * y;
    }
    const double determinant = xx * xxxx - xxx * xxx;
    return {values[0], (xy * xxxx - xxy * xxx) / determinant, (xx * xxy - xxx * xy) / determinant};
}

using Table = std::vector<std::array<double, 3>>;

struct Tables {
    Table correlated = Table(kAlbedoNodes), separable = Table(kAlbedoNodes);
};

void fill(Tables& tables, int mdf, int first, int step) {
    for (int i = first; i < kAlbedoNodes; i += step) {
        const AlbedoNode node = albedo_node(mdf, i);
        std::array<double, kMixed.size()> correlated{}, separable{};
        for (std::size_t k = 0; k < kMixed.size(); ++k) {
            const Albedos a = albedos_of(turned_lobe(mdf, node, kMixed[k]), node.cosine);
            correlated[k] = a.correlated;
            separable[k] = a.separable;
        }
        tables.correlated[static_cast<std::size_t>(i)] = parabola(correlated);
        tables.separable[static_cast<std::size_t>(i)] = parabola(separable);
    }
}

// A node is computed by one thread alone: the numbers are the same on any number of them.
Tables tables_of(int mdf) {
    Tables tables;
    const int count = std::max(static_cast<int>(std::thread::hardware_concurrency()), 1);
    std::vector<std::jthread> threads;
    for (int i = 0; i < count; ++i)
        threads.emplace_back([&tables, mdf, i, count] { fill(tables, mdf, i, count); });
    threads.clear();
    return tables;
}

void print(const char* name, int mdf, const Table& table) {
    std::printf("constexpr std::int16_t %s%d[] = {\n", name, mdf);
    for (const auto& node : table) {
        for (const double c : node)
            std::printf("%ld,", std::lround(std::clamp(c, -1.99, 1.99) *
                                            static_cast<double>(kAlbedoScale)));
        std::printf("\n");
    }
    std::printf("};\n");
}

void write() {
    std::printf("#include \"models/albedo_nodes.hpp\"\n\nnamespace burnish {\nnamespace {\n");
    for (const int mdf : kMdfs) {
        const Tables tables = tables_of(mdf);
        print("kCorrelated", mdf, tables.correlated);
        print("kSeparable", mdf, tables.separable);
    }
    std::printf("}\n\nstd::span<const std::int16_t> made_albedos(bool separable, int mdf) {\n");
    for (const int mdf : kMdfs)
        std::printf("    if (mdf == %d) return separable ? kSeparable%d : kCorrelated%d;\n", mdf,
                    mdf, mdf);
    std::printf("    return {};\n}\n\n}\n");
}

}  // namespace
}  // namespace burnish

int main() {
    burnish::write();
    return std::ferror(stdout) == 0 && std::fflush(stdout) == 0 ? 0 : 1;
}
