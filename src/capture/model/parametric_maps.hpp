// The analytic models of a material's maps (`fit`'s fourth stage, parametric_fit.hpp) as models of
// its texels: what they hold, and what they look like under a light of a rig.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "burnish/image.hpp"
#include "burnish/rig.hpp"
#include "burnish/tabulated_material.hpp"
#include "capture/model/parametric_fit.hpp"

namespace burnish {

// A model of which the material has all maps; they are the material's.
struct ParametricMaps {
    ParametricModel model;
    std::string name;
    const std::vector<float>*along, *across, *groove_deg, *diffuse, *specular;

    // Alphas and groove of a texel. Strengths, of luminance, are left to the maps.
    ParametricFit lobe(std::size_t texel) const;
};

// In the order of parametric_model_names; models that lack a map are left out.
std::vector<ParametricMaps> parametric_maps(const TabulatedMaterial& material);

// As Relighter::picture. The maps hold luminances, which are tinted as the material's own diffuse
// and specular colours are, at the same luminance.
Image parametric_picture(const TabulatedMaterial& material, const ParametricMaps& maps,
                         const Rig& rig, std::size_t light);

}  // namespace burnish
