// `burnish verify --csv`: somebody else's values of a BRDF held against ours.
#pragma once

#include <string>
#include <vector>

#include "burnish/mdf.hpp"
#include "burnish/parameters.hpp"
#include "burnish/progress.hpp"
#include "burnish/shading_names.hpp"

namespace burnish {

struct VerifyCsvRequest {
    ParameterValues values;  // the roughness pair, as VerifyRequest has it; f0, default 1
    std::string input;       // "-": standard input
    Brdf brdf = Brdf::microfacet;
    Mdf mdf = Mdf::ggx;
    Method method = Method::follow_grain;
    Direction<double> normal{0, 0, 1};  // any length, z > 0
    bool json = false;
    std::string command;  // for the JSON
};

struct VerifyCsvReport {
    std::string text;  // whole lines
    double error = 0;  // root mean square of the difference over that of our values
    std::vector<std::string> warnings;
};

// Throws Error naming file, line and column for what cannot be read: numbers that are not finite, directions whose
// length is further than 0.001 from 1, no rows, more than 4,000,000. UsageError for a normal of the lower
// hemisphere and for a model without a meaning under the method.
VerifyCsvReport verify_csv(const VerifyCsvRequest& request, const Progress& progress);

}  // namespace burnish
