#include <fmt/format.h>

#include <algorithm>

#include "highlight.hpp"
#include "lobes_under_test.hpp"
#include "tabulate.hpp"
#include "verify/hostile.hpp"

namespace burnish::test {
namespace {

std::vector<std::string> names_of_methods() {
    return {method_names().begin(), method_names().end()};
}

std::vector<std::string> names_of_lobes() {
    std::vector<std::string> names;
    for (const LobeCase& c : lobe_cases()) {
        names.push_back(fmt::format("{} ({:g}, {:g})", mdf_names()[static_cast<std::size_t>(c.mdf)],
                                    c.p0, c.p1));
    }
    return names;
}

using Cell = std::function<std::string(const LobeCase& c, int method)>;

std::string lobes_by_methods(const Cell& cell) {
    const std::vector<LobeCase> cases = lobe_cases();
    return markdown_table("distribution", names_of_methods(), names_of_lobes(),
                          [&](std::size_t row, std::size_t column) {
                              return cell(cases[row], static_cast<int>(column));
                          });
}

double energy(const LobeCase& c, int method, vec3 n, bool about_perturbed) {
    const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
    const f64::Perturbation p = perturbation(c, method, n);
    const vec3 axis = about_perturbed ? n : vec3{0, 0, 1};
    return integrate_cap(
        [&](vec3 h) { return f64::lobe_D(lobe, p, h) * std::max(f64::dot(axis, h), 0.0); }, axis,
        kPi / 2, 200, 240);
}

std::string energy_over_azimuths(const LobeCase& c, int method, double tilt_deg,
                                 bool about_perturbed) {
    double mean = 0, low = 1e300, high = -1e300;
    for (const double azimuth : {0.0, 30.0, 60.0, 90.0}) {
        const vec3 n = direction(tilt_deg * kPi / 180, azimuth * kPi / 180);
        const double e = energy(c, method, n, about_perturbed);
        mean += e / 4;
        low = std::min(low, e);
        high = std::max(high, e);
    }
    return fmt::format("{:.3f} [{:.2f}, {:.2f}]", mean, low, high);
}

std::string energy_tables(const std::string& title, bool about_perturbed) {
    std::string text = "\n## " + title +
                       "\n\nMean [least, most] over azimuths 0, 30, 60, 90 degrees of the tilt.\n";
    for (const double tilt : {30.0, 60.0}) {
        text += fmt::format("\n### Tilt {:.0f} degrees\n", tilt);
        text += lobes_by_methods([&](const LobeCase& c, int method) {
            return energy_over_azimuths(c, method, tilt, about_perturbed);
        });
    }
    return text;
}

// White-furnace albedo of the microfacet model (Fresnel 1) for wo, by quadrature over half vectors,
// where the lobe is: dwi = 4 (wo.h) dh.
double albedo_of(const LobeCase& c, int method, vec3 n, vec3 wo) {
    const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
    const f64::Perturbation p = perturbation(c, method, n);
    return integrate_cap(
        [&](vec3 h) {
            const double wo_h = f64::dot(wo, h);
            if (wo_h <= 0) {
                return 0.0;
            }
            const vec3 wi = f64::reflect_about(wo, h);
            return f64::brdf_eval(f64::kBrdfMicrofacet, lobe, p, wi, wo) *
                   std::max(f64::dot(p.n, wi), 0.0) * 4 * wo_h;
        },
        n, kPi, 240, 240);
}

std::string furnace_table() {
    return "\n## White furnace\n\nAlbedo of `microfacet` with Fresnel 1, seen along the geometric "
           "normal, n~ tilted by 30 degrees\nalong x and along y. More than 1 is energy from "
           "nowhere; less is light that single scattering loses,\nor that leaves below the horizon "
           "of n~.\n" +
           lobes_by_methods([](const LobeCase& c, int method) {
               return fmt::format("{:.3f}, {:.3f}",
                                  albedo_of(c, method, direction(kPi / 6, 0), {0, 0, 1}),
                                  albedo_of(c, method, direction(kPi / 6, kPi / 2), {0, 0, 1}));
           });
}

std::string highlight_errors(const LobeCase& c, int method) {
    std::string text;
    for (const double tilt : {15.0, 30.0, 45.0}) {
        const vec3 n = direction(tilt * kPi / 180, 35 * kPi / 180);
        const vec3 wo{0, 0, 1};
        const vec3 found = brightest(mapped_plate(c, method, n, wo), 60);
        const bool moved = method == f64::kMethodSlopeShift || method == f64::kMethodStretch;
        const vec3 wanted =
            brightest(moved ? moved_plate(c, method, n, wo) : tilted_plate(c, n, wo), 60);
        text += fmt::format("{}{:.1f}", text.empty() ? "" : ", ", angle_deg(found, wanted));
    }
    return text;
}

std::string highlight_table() {
    return "\n## Highlight error\n\nDegrees between the brightest direction of a flat plate whose "
           "normal map says n~ and that of a plate\nwhich really is tilted, its grooves lying in "
           "it, seen along the geometric normal: n~ tilted by 15, 30\nand 45 degrees at azimuth "
           "35. "
           "`microfacet`, Fresnel 1. Of slope-shift and stretch the plate is\none of their own "
           "process: bumps brushed afterwards, or stamped with the grain.\n" +
           lobes_by_methods(highlight_errors);
}

std::string hostile_table() {
    return fmt::format(
               "\n## Hostile frames\n\nValues that are NaN, infinite or negative among D, every "
               "model's f, the density and the sample, of\n{} combinations each: n~ at 89.9 "
               "degrees, "
               "along the tangent, the bitangent and 1e-4 or a subnormal\nnumber above the "
               "horizon; "
               "h, wi and wo equal to n and n~, at the horizon, 1e-8 or a subnormal number\nabove "
               "it, opposite one another. In single, in double precision.\n",
               verify::hostile_counts(f64::kMdfGgx, 0.2, 0.5, f64::kMethodNone).combinations) +
           lobes_by_methods([](const LobeCase& c, int method) {
               const auto counts = verify::hostile_counts(c.mdf, c.p0, c.p1, method);
               return fmt::format("{}, {}", counts.broken_f32, counts.broken_f64);
           });
}

}  // namespace

std::string method_tables() {
    return "\nD is `D_proj`: normalised so that the unperturbed lobe has Int D (n.h) dw = 1.\n" +
           energy_tables("Int D (n.h) dw, about the geometric normal", false) +
           energy_tables("Int D (n~.h) dw, about the perturbed normal", true) + furnace_table() +
           highlight_table() + hostile_table();
}

}  // namespace burnish::test
