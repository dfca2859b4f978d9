// Push-pull interpolation of scattered samples (Gortler et al., "The Lumigraph", 1996,
// section 3.4): samples are splatted with tent weights; coarser levels gather them where the finer
// one has too few (pull), then fill the finer one's gaps (push).
#pragma once

#include <vector>

namespace burnish {

struct PushPullImage {
    int side = 0;               // square, a power of two
    std::vector<float> value;   // weighted mean of samples at this level or of finer ones
    std::vector<float> weight;  // 0: no sample near; 1: samples at this level

    explicit PushPullImage(int side_ = 0);
    void clear(int side_);  // as if newly constructed
    // Coordinates are in pixels, with pixel centers at integers plus 1/2.
    void splat(float x, float y, float sample);
};

// Fills `image` in place. `reach`: number of levels that may fill a gap; each doubles the distance.
// Pixels farther from all samples keep weight 0. All other weights end in (0, 1].
void push_pull(PushPullImage& image, int reach);

}  // namespace burnish
