// What a fit finds for each pixel: of a whole sample, or of the bands that one job of several fits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "burnish/tabulated_material.hpp"
#include "capture/model/parametric_fit.hpp"

namespace burnish {

// The numbers of each analytic model and texel, by the names that they have in the material's maps.
inline constexpr std::array<const char*, 5> kModelNumbers = {"alpha_along", "alpha_across",
                                                             "groove_deg", "diffuse", "specular"};

// Pixels [first, first + count) of the row-major picture; arrays hold them in that order.
struct Texels {
    std::size_t first = 0, count = 0;
    std::vector<std::uint16_t>
        exemplar;              // TabulatedMaterial::kNoExemplar: outside the mask, or not fitted
    std::vector<float> angle;  // rotation of the exemplar, radians, counter-clockwise
    std::vector<float> error;  // PointFit::error
    std::vector<float> diffuse, specular, normal;  // x 3
    std::vector<float> models;  // x models x kModelNumbers; empty when models are not wanted

    Texels() = default;
    // Pixels without an exemplar, their normals +z.
    Texels(std::size_t first_pixel, std::size_t pixels, bool with_models);

    // Calls use(member, values a pixel) for each array: the one list of them.
    template <typename Use>
    static void for_each_field(bool with_models, Use use) {
        use(&Texels::exemplar, std::size_t{1});
        use(&Texels::angle, std::size_t{1});
        use(&Texels::error, std::size_t{1});
        use(&Texels::diffuse, std::size_t{3});
        use(&Texels::specular, std::size_t{3});
        use(&Texels::normal, std::size_t{3});
        use(&Texels::models,
            with_models ? parametric_model_names().size() * kModelNumbers.size() : std::size_t{0});
    }

    bool has_models() const { return !models.empty(); }
    // Are all arrays as long as `count` asks?
    bool whole(bool with_models) const;
    // Overwrites the pixels of `part`, which must lie within these and have models where these do.
    void merge(const Texels& part);
};

}  // namespace burnish
