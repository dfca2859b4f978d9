#include "burnish/conductors.hpp"

#include <array>
#include <cstddef>
#include <glm/common.hpp>

#include "core/text.hpp"
#include "models/spectra/fresnel_fit.hpp"
#include "models/spectra/optical_constants.hpp"

namespace burnish {

namespace {

constexpr std::array<std::string_view, 12> kNames = {"gold",     "silver", "copper",   "aluminium",
                                                     "steel",    "brass",  "titanium", "iron",
                                                     "chromium", "nickel", "tungsten", "bronze"};

// fitted_conductor of every metal (src/models/spectra/), so that nothing is integrated at the start.
// conductors_test.cpp fits them again.
const std::array<Conductor, kNames.size()>& conductors() {
    static const std::array<Conductor, kNames.size()> table = {{
        {{0.000000f, 0.400415f, 1.593037f}, {1.000000f, 2.255112f, 1.711678f}},  // gold
        {{0.049100f, 0.051892f, 0.052340f}, {4.508336f, 3.563607f, 2.620896f}},  // silver
        {{0.000000f, 0.802518f, 1.240141f}, {1.000000f, 2.498718f, 2.303920f}},  // copper
        {{1.502762f, 0.985322f, 0.606036f}, {7.655418f, 6.549816f, 5.351039f}},  // aluminium
        {{2.190981f, 1.889037f, 1.469398f}, {3.460972f, 3.152047f, 2.739496f}},  // steel
        {{0.481592f, 0.523966f, 1.128045f}, {4.373749f, 2.670335f, 1.813403f}},  // brass
        {{2.753381f, 2.507848f, 2.241322f}, {3.845795f, 3.397432f, 3.015265f}},  // titanium
        {{2.922703f, 2.919775f, 2.546311f}, {3.077274f, 2.937337f, 2.749978f}},  // iron
        {{3.245552f, 3.116123f, 2.286404f}, {3.286428f, 3.336470f, 3.117089f}},  // chromium
        {{2.039576f, 1.904487f, 1.730443f}, {4.206572f, 3.571139f, 2.897095f}},  // nickel
        {{3.636969f, 3.494395f, 3.314184f}, {2.923856f, 2.747554f, 2.505619f}},  // tungsten
        {{0.337945f, 0.579585f, 1.035998f}, {5.862968f, 2.364735f, 1.893852f}},  // bronze
    }};
    return table;
}

std::size_t index_of_metal(std::string_view name) {
    return static_cast<std::size_t>(index_of_name(kNames, name, "metal", ""));
}

}  // namespace

std::span<const std::string_view> conductor_names() {
    return kNames;
}

Conductor conductor_preset(std::string_view name) {
    return conductors()[index_of_metal(name)];
}

std::string_view conductor_name(const Conductor& conductor) {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        const Conductor& preset = conductors()[i];
        if (preset.eta == conductor.eta && preset.k == conductor.k) return kNames[i];
    }
    return {};
}

std::string_view oxide_of(std::string_view metal) {
    return measured_metals()[index_of_metal(metal)].oxide;
}

OxideFilm oxide_film(std::string_view metal, float thickness_nm) {
    return {thickness_nm, fitted_curve(MetalReflectance(metal, static_cast<double>(thickness_nm)))};
}

glm::vec3 normal_reflectance(const Conductor& conductor) {
    if (conductor.oxide) return glm::clamp(conductor.oxide->curve[0], 0.0f, 1.0f);
    const glm::vec3 below = conductor.eta - 1.0f;
    const glm::vec3 above = conductor.eta + 1.0f;
    const glm::vec3 k2 = conductor.k * conductor.k;
    return (below * below + k2) / (above * above + k2);
}

}  // namespace burnish
