// RMSE and PSNR between rendered pictures and those of a stack, one light at a time, so that
// neither stack is completely in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "burnish/compare.hpp"
#include "burnish/image.hpp"
#include "burnish/rig.hpp"
#include "burnish/tabulated_material.hpp"

namespace burnish {

struct LightError {
    std::size_t samples = 0;  // valid samples: within the mask and not clipped
    double rmse = 0.0;        // 0 without samples
    double psnr = 0.0;        // dB, infinite for an RMSE of 0; not a number without samples
};

struct StackError {
    std::vector<LightError> lights;
    std::size_t samples = 0;
    double peak = 0.0;  // the brightest valid sample, the reference of PSNR
    double rmse = 0.0;  // over all samples
    double psnr_median = 0.0, psnr_mean = 0.0, psnr_worst = 0.0;  // of lights with samples
    std::size_t worst = 0;                                        // index of that light
};

class StackComparison {
  public:
    // `stack`: lights with pictures. Throws Error when one of them is of another size than the
    // material or cannot be read.
    StackComparison(const Rig& stack, const TabulatedMaterial& material);

    // Reads the picture of the light and adds the errors of `rendered`.
    void add(std::size_t light, const Image& rendered);

    // After all lights. Throws Error if no sample is valid or all are black.
    StackError result() const;

  private:
    // Samples at the light's largest value are summed separately: only after all pictures it is
    // known whether they are clipped (kRepeatsOfClipping in image_stack.hpp).
    struct Sums {
        SquaredError all, at_top;
        double top = 0.0, next = 0.0;  // the largest value, and the largest below it
    };
    Rig stack_;
    Image white_;
    std::vector<std::uint8_t> counts_;  // for each pixel: 1 if it is valid
    std::vector<Sums> sums_;
    int width_ = 0, height_ = 0;
};

}  // namespace burnish
