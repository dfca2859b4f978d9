// How far measured or rendered values are from those they should be: root mean square error (RMSE),
// peak signal-to-noise ratio (PSNR), and FLIP, the difference that a viewer sees between two
// pictures. Each caller of psnr() says which peak its ratio is relative to: figures of different
// peaks cannot be compared. All functions are pure and may be called from any thread.
#pragma once

#include <cstddef>

#include "burnish/api.hpp"
#include "burnish/image.hpp"

namespace BURNISH_API burnish {

// A sum of squared differences. Sums of parts of the values can be made apart and merged; the
// caller merges in a fixed order where the result must not depend on the number of threads.
struct SquaredError {
    double squares = 0.0;
    std::size_t count = 0;

    void add(double difference) {
        squares += difference * difference;
        ++count;
    }
    void merge(const SquaredError& other) {
        squares += other.squares;
        count += other.count;
    }
    // In the units of the differences; 0 when nothing was added.
    double rmse() const;
};

// 20 log10(peak / rmse) in decibels. `peak`: the value that the ratio takes as full signal, in the
// units of `rmse`. Infinity for an RMSE of 0, whatever the peak: both sides agree everywhere.
double psnr(double rmse, double peak);

// FLIP for pictures of low dynamic range: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom and
// Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM Comput. Graph.
// Interact. Tech. 3(2), HPG 2020. It estimates, pixel by pixel, the difference that a viewer sees
// when the two pictures alternate in the same place.
//
// `reference` and `test`: display-encoded (sRGB) RGB or RGBA of the same size, in [0, 1]; values
// outside are clamped, a value that is not a number counts as 0, and alpha is not read. The result
// has one channel in [0, 1]: 0 where the viewer sees no difference, 1 for the largest difference
// (pure green beside pure blue). The order of the two pictures does not matter.
//
// `pixels_per_degree`: pixels in one degree of the visual field. 67 is a display of 3840 pixels and
// 0.7 m width at a distance of 0.7 m, the paper's default. Range: 1 to 1000.
//
// Throws Error if a picture has no pixels or fewer than 3 channels, if the sizes differ, or if
// `pixels_per_degree` is out of range. Runs on all cores; the result does not depend on their
// number.
Image flip_error(const Image& reference, const Image& test, double pixels_per_degree = 67.0);

// The mean of all values of a picture of one channel; 0 for a picture without pixels. The paper
// gives FLIP as one number in this way. Throws Error for more than one channel.
double mean_of(const Image& one_channel);

// FLIP errors as colors: display-encoded RGB from black (0) through purple and orange to light
// yellow (1), with lightness that rises with the error. Values outside [0, 1] are clamped, and one
// that is not a number counts as 0. Throws Error for more than one channel.
Image flip_colors(const Image& error);

}  // namespace burnish
