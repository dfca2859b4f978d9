// `burnish verify`: what each method keeps of each reflection model, as a table or as JSON.
#pragma once

#include <string>
#include <vector>

#include "burnish/parameters.hpp"
#include "burnish/progress.hpp"
#include "burnish/shading_names.hpp"

namespace burnish {

struct VerifyRequest {
    // alpha_x and alpha_y, or e_x and e_y: one pair sets every distribution (e = 2/alpha^2 - 2); without a pair, e =
    // 200, 10.
    ParameterValues values;
    std::vector<Brdf> brdfs{Brdf::microfacet};
    std::vector<Mdf> mdfs;  // none: all. A model with a distribution of its own takes that one
    std::vector<Method> methods;  // none: all
    bool json = false;
    std::string command;  // for the JSON
};

struct VerifyReport {
    std::string text;  // the table or the JSON document, whole lines
    std::size_t rows = 0;
    std::size_t broken = 0;  // rows that break a bound of verify/properties.hpp
};

// Throws UsageError where nothing that is asked for has a meaning, and for lobes too narrow for the quadratures.
VerifyReport verify_methods(const VerifyRequest& request, const Progress& progress);

}  // namespace burnish
