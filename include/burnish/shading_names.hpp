// The names of distributions, models and methods: one list for flags, scene files and tables.
//
// Threads: any number may call these functions at a time. Lifetime: what they return is static.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "burnish/api.hpp"

namespace BURNISH_API burnish {

// The numbers are those of shading/names.glsl (a test holds them together).
enum class Mdf { ashikhmin_shirley = 0, ward = 1, beckmann = 2, ggx = 3 };
enum class Brdf {
    microfacet = 0,
    microfacet_separable = 1,
    ashikhmin_shirley = 2,
    ward_gmd = 3,
    ward = 4,
    ward_duer = 5,
    cook_torrance = 6,
    phong = 7,
    lafortune = 8
};
enum class Method {
    none = 0,
    normal_map = 1,
    gram_schmidt = 2,
    rotate_exact = 3,
    rotate_approx = 4,
    rotate_arc = 5,
    follow_grain = 6,
    deform_linear = 7,
    deform_smooth = 8,
    slope_shift = 9,
    stretch = 10
};

// How the micro-structure of a surface got onto its bumps, which decides what they do to the lobe
// (docs/theory/processes.md).
enum class Process {
    embossed = 0,  // pressed: grooves keep their shadow on the plate, and their widths
    bent = 1,      // bent without stretch
    stamped = 2,   // deep-drawn: stretched with the surface
    brushed_after =
        3  // height added to height: brushed on the bumps, or bumps cut into a brushed plate
};

std::span<const std::string_view> mdf_names();  // in the order of the enumeration
std::span<const std::string_view> brdf_names();
std::span<const std::string_view> method_names();
std::span<const std::string_view> process_names();

// The method that shades a surface made by the process.
Method method_of(Process process);

// Phong and lafortune are lobes about a direction: there is no distribution of half vectors, so
// `mdf` is not looked at, and neither a deformation nor slope-shift or stretch has anything to act on.
constexpr bool has_half_vectors(Brdf brdf) {
    return brdf != Brdf::phong && brdf != Brdf::lafortune;
}
constexpr bool is_deformation(Method method) {
    return method == Method::deform_linear || method == Method::deform_smooth;
}

// What to take instead of a model that `brdf eval` has and no renderer draws, as half a sentence;
// empty when `brdf` is no such model.
std::string_view instead_of_undrawn(std::string_view brdf);

std::string_view name_of(Mdf mdf);
std::string_view name_of(Brdf brdf);
std::string_view name_of(Method method);
std::string_view name_of(Process process);

}  // namespace burnish
