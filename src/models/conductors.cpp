#include "burnish/conductors.hpp"

#include <array>
#include <cstddef>

#include "burnish/shading_names.hpp"
#include "core/text.hpp"

namespace burnish {

namespace {

constexpr std::array<std::string_view, 7> kNames = {"gold",  "silver", "copper",  "aluminium",
                                                    "steel", "brass",  "titanium"};

// n and k at 650, 550 and 450 nm, linear between the neighboring samples of the measurement. The
// tables were read in the refractiveindex.info database (public domain, CC0).
const std::array<Conductor, kNames.size()>& conductors() {
    static const std::array<Conductor, kNames.size()> table = {{
        // Johnson and Christy 1972, "Optical constants of the noble metals", Phys. Rev. B 6, 4370
        {{0.1556f, 0.4241f, 1.3831f}, {3.6024f, 2.4721f, 1.9155f}},
        {{0.0522f, 0.0596f, 0.0400f}, {4.4094f, 3.5974f, 2.6484f}},
        {{0.2378f, 1.0066f, 1.2404f}, {3.6264f, 2.5823f, 2.3929f}},
        // Rakic 1995, "Algorithm for the determination of intrinsic optical constants of metal
        // films: application to aluminum", Appl. Opt. 34, 4755
        {{1.5580f, 1.0152f, 0.6332f}, {7.7124f, 6.6273f, 5.4544f}},
        // Karlsson and Ribbing 1982, "Optical constants and spectral selectivity of stainless steel
        // and its oxides", J. Appl. Phys. 53, 6340: ferritic, 13.5 % chromium
        {{2.1942f, 1.9042f, 1.4945f}, {3.4813f, 3.1704f, 2.7709f}},
        // Querry 1985, "Optical constants", report CRDC-CR-85034: 70 % copper, 30 % zinc
        {{0.4440f, 0.5270f, 1.0940f}, {3.6950f, 2.7650f, 1.8290f}},
        // Johnson and Christy 1974, "Optical constants of transition metals", Phys. Rev. B 9, 5056
        {{2.7407f, 2.5418f, 2.2670f}, {3.8143f, 3.4345f, 3.0385f}},
    }};
    return table;
}

}  // namespace

std::span<const std::string_view> conductor_names() {
    return kNames;
}

Conductor conductor_preset(std::string_view name) {
    return conductors()[static_cast<std::size_t>(index_of_name(kNames, name, "metal", ""))];
}

std::string_view conductor_name(const Conductor& conductor) {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        const Conductor& preset = conductors()[i];
        if (preset.eta == conductor.eta && preset.k == conductor.k) return kNames[i];
    }
    return {};
}

glm::vec3 normal_reflectance(const Conductor& conductor) {
    const glm::vec3 below = conductor.eta - 1.0f;
    const glm::vec3 above = conductor.eta + 1.0f;
    const glm::vec3 k2 = conductor.k * conductor.k;
    return (below * below + k2) / (above * above + k2);
}

}  // namespace burnish
