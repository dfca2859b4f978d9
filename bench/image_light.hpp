// The test cases of image light: a white metal sphere whose normal map is one tilt.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "burnish/context.hpp"
#include "burnish/scene.hpp"

namespace burnish::bench {

struct SphereCase {
    Mdf mdf;
    Method method;
    glm::vec2 alpha;
    float tilt_deg;
};

// RMSE of linear radiance against 4,096 samples, 40 x 40 pixels.
struct SphereErrors {
    double bent_normal;
    double samples_32;
    double prefiltered;
};

// The available environments of the sample data (BURNISH_DATA, else ../shared/data).
std::vector<Environment> sample_environments();

SphereErrors sphere_errors(gpu::Context& context, const Environment& environment,
                           const SphereCase& c);

}  // namespace burnish::bench
