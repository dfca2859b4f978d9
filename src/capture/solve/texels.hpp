// The results of a fit for each pixel: of a whole sample, or of the bands of one of several jobs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "burnish/tabulated_material.hpp"
#include "capture/model/parametric_fit.hpp"

namespace burnish {

// The map names of each analytic model's numbers; each texel has one value of each.
inline constexpr std::array<const char*, 5> kModelNumbers = {"alpha_along", "alpha_across",
                                                             "groove_deg", "diffuse", "specular"};

// Pixels [first, first + count) of the row-major picture, in that order in all arrays.
struct Texels {
    std::size_t first = 0, count = 0;
    std::vector<std::uint16_t>
        exemplar;              // TabulatedMaterial::kNoExemplar: outside the mask, or not fitted
    std::vector<float> angle;  // rotation of the exemplar, radians, counter-clockwise
    std::vector<float> error;  // PointFit::error
    std::vector<float> diffuse, specular, normal;  // x 3
    std::vector<float> models;                     // x models x kModelNumbers; empty without models

    Texels() = default;
    // Pixels without an exemplar; their normals are +z.
    Texels(std::size_t first_pixel, std::size_t pixels, bool with_models);

    // Calls use(member, values per pixel) for each array.
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
    // Do all arrays have the length that `count` requires?
    bool whole(bool with_models) const;
    // Overwrites the pixels of `part`, which must lie within these; if these have models, so must
    // `part`.
    void merge(const Texels& part);
};

}  // namespace burnish
