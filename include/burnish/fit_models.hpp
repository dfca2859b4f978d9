// The reflection models as they are fitted to measurements: which numbers of a lobe are free,
// within which bounds, and from where the search starts. The lobe is that of
// shading/brdf_models.hpp, its own strength (ks) at 1; the fit adds a scale for each color and a
// Lambertian term.
//
// Threads: any number may call these functions at a time. Lifetime: what they return is static.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/brdf_models.hpp"

namespace BURNISH_API burnish {

using LobeParameters = std::array<double, kMostBrdfParameters>;

// One number of the search. Exponents and roughness are searched in logarithms.
struct FreeParameter {
    double low, high;
};

// One way in which a model can be fitted. Most have one; a Lafortune lobe may also face the light.
struct FitVariant {
    std::vector<FreeParameter> free;
    std::function<LobeParameters(std::span<const double> q)> lobe;
    std::vector<std::vector<double>> starts;
};

struct FitModel {
    std::string_view name;  // of brdf_models()
    const BrdfModel* brdf = nullptr;
    double most_scale = 1;  // of each color
    std::vector<FitVariant> isotropic;
    // Adds parameters to the isotropic variant of the same index, whose numbers `widen` takes over
    // without a change of the lobe. Empty: the model has no anisotropic form.
    std::vector<FitVariant> anisotropic;
    std::function<std::vector<double>(std::span<const double> q)> widen;
    double stretch = 0;  // starts differ by it in the first two numbers, either way
};

// phong, ward, lafortune, ward-duer, ward-gmd, cook-torrance, ashikhmin-shirley, ggx, beckmann, he.
std::span<const FitModel> fit_models();
std::span<const std::string_view> fit_model_names();

}  // namespace burnish
