// Measured metals: what published spectra of their optical constants reflect, integrated to linear
// Rec. 709 under daylight D65 (docs/evidence/metals.md).
//
// Threads: any number may call these functions at a time. Lifetime: names are static.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string_view>

#include "burnish/api.hpp"
#include "burnish/conductor.hpp"

namespace BURNISH_API burnish {

// gold silver copper aluminium steel brass titanium iron chromium nickel tungsten bronze
std::span<const std::string_view> conductor_names();

// The bare metal: the index of refraction per channel whose exact Fresnel reflectance has the metal's
// color at normal incidence and is nearest to it at all other angles. Channels above 1 are held at 1.
// Throws UsageError, with the nearest name, for a metal that is not in the list.
Conductor conductor_preset(std::string_view name);

// The name of the preset with this index of refraction; empty when there is none.
std::string_view conductor_name(const Conductor& conductor);

// The formula of the oxide that grows on a metal, such as TiO2; empty where no measured one is known.
// Throws UsageError for a metal that is not in the list.
std::string_view oxide_of(std::string_view metal);

// A film of that oxide on the metal, 0 to 1000 nm thick: interference at every wavelength, as a curve
// over the angle. Takes a millisecond. Throws UsageError for a metal that is not in the list and for
// one of which no oxide is known.
OxideFilm oxide_film(std::string_view metal, float thickness_nm);

// Reflectance at normal incidence: of the film where there is one, else ((n-1)^2 + k^2) / ((n+1)^2 +
// k^2) per channel.
glm::vec3 normal_reflectance(const Conductor& conductor);

}  // namespace burnish
