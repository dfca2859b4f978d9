// Converts the values of a pixel to samples of its distribution, for all stages of a fit.
#pragma once

#include <cstdint>
#include <vector>

#include "capture/stack/light_geometry.hpp"

namespace burnish {

// Memory that a worker reuses from pixel to pixel.
struct PixelWork {
    PointLights lights;
    PointSamples samples;
};

// Shared by all workers, which only read it. `geometry` must outlive the context.
struct SampleContext {
    const LightGeometry* geometry = nullptr;
    std::vector<std::uint8_t> keep;  // one value for each light: 1 takes part, 0 is held out
    NdfGrid grid;                    // of the exemplars
    float spacing_rad = 0.05f;       // median distance of neighboring half vectors

    // Fills work.samples with the samples of a pixel in the frame of `normal`. `values`: lights x
    // 3, as decoded by the stack.
    void gather(std::size_t pixel, const Vec3f& normal, const float* values,
                PixelWork& work) const {
        geometry->at(pixel, work.lights);
        gather_samples(work.lights, normal, {values, 3 * geometry->lights()}, keep, grid,
                       work.samples);
    }
};

}  // namespace burnish
