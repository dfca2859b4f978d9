// Reads the analytic models of a material's maps (from parametric_fit.hpp) texel by texel and
// renders them under a light of a rig.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "burnish/image.hpp"
#include "burnish/rig.hpp"
#include "burnish/tabulated_material.hpp"
#include "capture/model/parametric_fit.hpp"

namespace burnish {

// An analytic model all of whose maps the material has. The pointers refer to the material's maps.
struct ParametricMaps {
    ParametricModel model;
    std::string name;
    const std::vector<float>*along, *across, *groove_deg, *diffuse, *specular;

    // Alphas and groove of a texel. Leaves the strengths at 0; the maps hold their luminance.
    ParametricFit lobe(std::size_t texel) const;
};

// In the order of parametric_model_names; models that lack a map are left out.
std::vector<ParametricMaps> parametric_maps(const TabulatedMaterial& material);

// As Relighter::picture. The maps hold luminances; each is tinted with the hue of the material's
// own diffuse or specular color.
Image parametric_picture(const TabulatedMaterial& material, const ParametricMaps& maps,
                         const Rig& rig, std::size_t light);

}  // namespace burnish
