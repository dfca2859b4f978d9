#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "brdf_cases.hpp"
#include "chi_square.hpp"
#include "tabulate.hpp"

namespace burnish::test {
namespace {

std::vector<std::string> names_of(const std::vector<BrdfCase>& cases) {
    std::vector<std::string> names;
    for (const BrdfCase& c : cases) {
        names.push_back(label(c));
    }
    return names;
}

// Largest |f(i,o) - f(o,i)| over the larger of the two, and its mean, over random pairs.
std::string reciprocity(const BrdfCase& c) {
    constexpr int kPairs = 4000;
    std::mt19937 generator(23);
    double worst = 0, mean = 0;
    const auto uniform = [&] { return (static_cast<double>(generator()) + 0.5) / 4294967296.0; };
    const auto any = [&] {
        const double z = uniform();
        return direction(std::acos(z), 2 * kPi * uniform());
    };
    for (int i = 0; i < kPairs; ++i) {
        const vec3 wi = any(), wo = any();
        const double there = c.f(wi, wo), back = c.f(wo, wi), most = std::max(there, back);
        if (most < 1e-200) {
            continue;
        }
        worst = std::max(worst, std::abs(there - back) / most);
        mean += std::abs(there - back) / most / kPairs;
    }
    if (worst < 1e-9) {
        return "reciprocal (below 1e-9)";
    }
    return fmt::format("**not reciprocal**: {:.2f} mean, {:.2f} most", mean, worst);
}

// How the albedo behaves in the last tenth of a degree: as 1/cos^power. Powers below 0.1 are what
// approaching a limit looks like.
std::string boundedness(const BrdfCase& c) {
    double power = 0;
    for (const double azimuth : {0.0, 90.0}) {
        const double near = albedo(c, at_deg(89.9, azimuth)),
                     at = albedo(c, at_deg(89.99, azimuth));
        power = std::max(power, std::log10(at / near));
    }
    if (power < 0.1) {
        return "bounded";
    }
    return fmt::format("**not bounded**: as 1/cos^{:.1f}", power);
}

std::string sampler(const BrdfCase& c) {
    const vec3 wo = at_deg(40, 50);
    double integral = 0;
    const double p = sampler_p_value([&](vec3 wi) { return c.density(wi, wo); },
                                     [&](double a, double b, double s) {
                                         double density = 0;
                                         const vec3 wi = c.sample(wo, {a, b, s}, density);
                                         return density > 0 ? wi : vec3{0, 0, 0};
                                     },
                                     Axes(vec3{-wo.x, -wo.y, wo.z}), 71, integral);
    return fmt::format("{:.2f}", p);
}

constexpr std::array<double, 8> kAngles = {0, 15, 30, 45, 60, 75, 80, 85};

double largest_albedo(const BrdfCase& c) {
    double most = 0;
    for (const double theta : kAngles) {
        for (const double azimuth : {0.0, 90.0}) {
            most = std::max(most, albedo(c, at_deg(theta, azimuth)));
        }
    }
    return most;
}

std::string property_table(const std::vector<BrdfCase>& cases) {
    return markdown_table(
        "model", {"reciprocity", "albedo at grazing", "sampler, p", "largest albedo below"},
        names_of(cases), [&](std::size_t row, std::size_t column) {
            const BrdfCase& c = cases[row];
            if (column == 0) {
                return reciprocity(c);
            }
            if (column == 1) {
                return boundedness(c);
            }
            if (column == 2) {
                return sampler(c);
            }
            const double most = largest_albedo(c);
            return most > 1.005 ? fmt::format("**{:.3f}**", most) : fmt::format("{:.3f}", most);
        });
}

std::string albedo_table(const std::vector<BrdfCase>& cases) {
    std::vector<std::string> columns;
    for (const double angle : kAngles) {
        columns.push_back(fmt::format("{:.0f}", angle));
    }
    return markdown_table(
        "model", columns, names_of(cases), [&](std::size_t row, std::size_t column) {
            return fmt::format("{:.3f}, {:.3f}", albedo(cases[row], at_deg(kAngles[column], 0)),
                               albedo(cases[row], at_deg(kAngles[column], 90)));
        });
}

}  // namespace

std::string brdf_tables() {
    const std::vector<BrdfCase> cases = brdf_cases();
    return "\n## Reflection models\n\nParameters as in `burnish brdf eval --help`, in their order; "
           "Fresnel and ks are 1, the ks of `phong`\nand `lafortune` that of a lobe with albedo 1 "
           "head-on. Reciprocity over 4,000 random pairs: the\ndifference of f(i,o) and f(o,i) "
           "over "
           "the larger one. Albedo at grazing: between 89.9 and 89.99\ndegrees. Sampler: p-value "
           "of "
           "chi-square, 100,000 samples against their density, light from 40 degrees;\none in "
           "twenty is below 0.05 by chance.\n" +
           property_table(cases) +
           "\n### Albedo over the angle of the light\n\nLight in the x and in the y direction, "
           "degrees from the normal. More than 1 is energy from nowhere.\n" +
           albedo_table(cases);
}

}  // namespace burnish::test
