// Spectral reflectances as a shader holds them: per channel, over the angle.
//
// Threads: functions of their arguments.
#pragma once

#include "burnish/conductor.hpp"
#include "models/spectra/metal_reflectance.hpp"

namespace burnish {

// The index eta + ik per channel whose exact Fresnel reflectance is that of the held colors: equal at
// normal incidence, and with the least squared error over the hemisphere (weight cos theta sin theta).
// A channel that is 1 at normal incidence is 1 at all angles (eta 0).
Conductor fitted_conductor(const MetalReflectance& metal);

// The curve (fresnel_curve of shading/) nearest to the colors: equal at normal incidence, 1 at grazing
// incidence, and with the least squared error between (weight (cos theta + 0.15) sin theta).
FresnelTerms fitted_curve(const MetalReflectance& metal);

}  // namespace burnish
