// The reflectance of a metal as a material holds it.
//
// Threads and lifetime: plain values; copies are independent, and any number of threads may read
// one.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>

namespace burnish {

// The terms of fresnel_curve (shading/brdf/fresnel.glsl) at R, G, B: the reflectance at normal
// incidence, then what is added toward grazing incidence, where it is 1.
inline constexpr std::size_t kFresnelTerms = 6;
using FresnelTerms = std::array<glm::vec3, kFresnelTerms>;

// A transparent film of oxide, whose interference colors a metal. Its reflectance takes the place of
// the metal's own.
struct OxideFilm {
    float thickness_nm = 0.0f;
    FresnelTerms curve{};
    bool operator==(const OxideFilm&) const = default;
};

// Complex index of refraction eta + i k at R, G, B, and what lies on the metal.
struct Conductor {
    glm::vec3 eta{1.0f};
    glm::vec3 k{0.0f};
    std::optional<OxideFilm> oxide = std::nullopt;
    bool operator==(const Conductor&) const = default;
};

}  // namespace burnish
