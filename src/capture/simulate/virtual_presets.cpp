// The simulated materials. Fresnel reflectance at the usual eta, 1.5, rises to 15 times that at
// normal incidence: a narrow lobe that reflects more than some 7 % from above would reflect more
// than it receives at grazing angles.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>

#include "burnish/error.hpp"
#include "burnish/virtual_sample.hpp"
#include "core/constants.hpp"
#include "core/text.hpp"

namespace burnish {

namespace {

VirtualNdf beckmann() {
    return {"beckmann", {{.mdf = Mdf::beckmann, .alpha_x = 0.12, .alpha_y = 0.40}}};
}
VirtualNdf ggx() {
    return {"ggx", {{.alpha_x = 0.10, .alpha_y = 0.35}}};
}
// Warp and weft of one cloth, their fibres at right angles.
VirtualNdf two_lobes() {
    return {"two-lobe",
            {{.weight = 0.6, .alpha_x = 0.12, .alpha_y = 0.45},
             {.weight = 0.4, .alpha_x = 0.12, .alpha_y = 0.30, .rotation = kPi / 2}}};
}
// Scratches with one worn side: some facets lean across the groove.
VirtualNdf asymmetric() {
    return {"asymmetric",
            {{.weight = 0.6, .alpha_x = 0.10, .alpha_y = 0.25},
             {.weight = 0.4, .alpha_x = 0.15, .alpha_y = 0.20, .lean_y = 0.45}}};
}
VirtualNdf satin(double along, double across) {
    return {"satin",
            {{.weight = 0.8, .mdf = Mdf::beckmann, .alpha_x = along, .alpha_y = across},
             {.weight = 0.2,
              .mdf = Mdf::beckmann,
              .alpha_x = 0.25,
              .alpha_y = 0.35,
              .rotation = kPi / 2}}};
}
// A leaning pile: bright at grazing angles, dark from above.
VirtualNdf velvet() {
    return {"velvet",
            {{.weight = 0.45, .alpha_x = 0.35, .alpha_y = 0.45, .lean_x = 0.2, .lean_y = 0.7},
             {.weight = 0.35, .alpha_x = 0.35, .alpha_y = 0.45, .lean_x = -0.2, .lean_y = -0.5},
             {.weight = 0.20, .mdf = Mdf::beckmann, .alpha_x = 0.6, .alpha_y = 0.7}}};
}
VirtualNdf plain(const char* name, double alpha) {
    return {name, {{.alpha_x = alpha, .alpha_y = alpha}}};
}

// A texel as a function of its position (u, v) in [0, 1]^2, v up.
using Paint = std::function<VirtualTexel(double u, double v)>;

struct Recipe {
    std::vector<VirtualNdf> ndfs;
    Paint paint;
};

VirtualTexel texel(int ndf, double grain, Vec3d diffuse, double specular) {
    VirtualTexel t;
    t.ndf = ndf;
    t.grain = grain;
    t.diffuse = diffuse;
    t.specular = {specular, specular, specular};
    return t;
}

// Grain angles in all directions: brushed rings about a point away from the middle.
double rings(double u, double v) {
    return std::atan2(v - 0.42, u - 0.55) + kPi / 2;
}
// Slow waves of albedo, so that no two texels are equal.
double shade(double u, double v) {
    return 0.8 + 0.2 * std::sin(7.0 * u + 2.0) * std::cos(5.0 * v);
}

Recipe one(const VirtualNdf& ndf, Vec3d diffuse, double specular) {
    return {{ndf}, [=](double u, double v) {
                const double s = shade(u, v);
                return texel(0, rings(u, v), {diffuse[0] * s, diffuse[1] * s, diffuse[2] * s},
                             specular * (0.7 + 0.3 * std::cos(9.0 * u - 4.0 * v)));
            }};
}

// Four patches, one distribution each, the grain rotating across all.
Recipe classes() {
    return {{beckmann(), ggx(), two_lobes(), asymmetric()}, [](double u, double v) {
                const int patch = (u >= 0.5 ? 1 : 0) + (v >= 0.5 ? 2 : 0);
                const double pu = 2.0 * u - std::floor(2.0 * u), pv = 2.0 * v - std::floor(2.0 * v);
                VirtualTexel t = texel(patch, rings(pu, pv), {0.058, 0.044, 0.034},
                                       0.066 + 0.027 * std::sin(6.0 * pu + 5.0 * pv));
                const double s = shade(u, v);
                for (double& c : t.diffuse) c *= s;
                return t;
            }};
}

// Motifs of one distribution on a ground of another, grain across and along.
Recipe wallpaper() {
    return {{ggx(), plain("ground", 0.35)}, [](double u, double v) {
                const double petals = std::sin(4.0 * kPi * u) * std::sin(4.0 * kPi * v);
                const bool motif = std::abs(petals) > 0.35;
                return motif ? texel(0, kPi / 4 * (petals > 0 ? 1 : -1) + kPi * u,
                                     {0.082, 0.066, 0.033}, 0.115)
                             : texel(1, 0.0, {0.20, 0.05, 0.06}, 0.08);
            }};
}

Recipe single_grain() {
    return {{ggx()}, [](double u, double v) {
                const double s = shade(u, v);
                return texel(0, kPi / 6, {0.058 * s, 0.048 * s, 0.038 * s}, 0.12);
            }};
}

struct Entry {
    VirtualPreset preset;
    Recipe (*make)();
};

constexpr std::array<Entry, 9> kEntries = {{
    {{"classes", "four patches: beckmann, ggx, two lobes, asymmetric"}, classes},
    {{"satin", "satin with a narrow highlight across its floats"},
     [] {
         return one(satin(0.12, 0.45), {0.096, 0.019, 0.024}, 0.105);
     }},
    {{"satin-soft", "a duller satin"},
     [] {
         return one(satin(0.22, 0.50), {0.05, 0.10, 0.20}, 0.115);
     }},
    {{"wallpaper", "gilt motifs on a matt ground"}, wallpaper},
    {{"velvet", "a pile that leans to two sides"},
     [] {
         return one(velvet(), {0.10, 0.01, 0.03}, 0.08);
     }},
    {{"single-grain", "one grain direction: its distribution cannot be completed"}, single_grain},
    {{"isotropic", "no grain at all"},
     [] {
         return one(plain("isotropic", 0.25), {0.15, 0.15, 0.12}, 0.15);
     }},
    {{"mirror", "a lobe narrower than any stack resolves"},
     [] {
         return one(plain("mirror", 0.01), {0.02, 0.02, 0.02}, 0.065);
     }},
    {{"diffuse", "no highlight at all"},
     [] {
         return one(plain("none", 0.5), {0.4, 0.35, 0.3}, 0.0);
     }},
}};

Vec3d waving_normal(double u, double v, double tilt_deg) {
    const double most = std::tan(tilt_deg * kDegree);
    const double x = most * std::sin(11.0 * u + 3.0 * v) * std::sqrt(0.5);
    const double y = most * std::cos(5.0 * u - 9.0 * v) * std::sqrt(0.5);
    const double length = std::sqrt(x * x + y * y + 1.0);
    return {x / length, y / length, 1.0 / length};
}

}  // namespace

std::span<const VirtualPreset> virtual_presets() {
    static const std::vector<VirtualPreset> all = [] {
        std::vector<VirtualPreset> list;
        list.reserve(kEntries.size());
        for (const Entry& entry : kEntries) list.push_back(entry.preset);
        return list;
    }();
    return all;
}

VirtualSample make_virtual_sample(std::string_view preset, const VirtualSettings& settings) {
    std::vector<std::string_view> names;
    names.reserve(kEntries.size());
    for (const Entry& entry : kEntries) names.push_back(entry.preset.name);
    const int index = index_of_name(names, preset, "material", "capture simulate");
    const Recipe recipe = kEntries[static_cast<std::size_t>(index)].make();

    VirtualSample sample;
    sample.name = preset;
    sample.width = settings.width;
    sample.height = settings.height;
    sample.width_mm = settings.width_mm;
    sample.height_mm = settings.width_mm * settings.height / settings.width;
    sample.eta = settings.eta;
    sample.ndfs = recipe.ndfs;
    for (int row = 0; row < settings.height; ++row)
        for (int column = 0; column < settings.width; ++column) {
            const double u = (column + 0.5) / settings.width;
            const double v = 1.0 - (row + 0.5) / settings.height;
            VirtualTexel t = recipe.paint(u, v);
            t.normal = waving_normal(u, v, settings.tilt_deg);
            sample.texels.push_back(t);
        }
    return sample;
}

}  // namespace burnish
