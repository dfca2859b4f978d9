// Push-pull interpolation of scattered samples (Gortler et al., "The Lumigraph", 1996,
// section 3.4): samples are splatted with tent weights; coarser levels gather them where the finer
// one has too few (pull), then fill the finer one's gaps (push).
#pragma once

#include <vector>

namespace burnish {

struct PushPullImage {
    int side = 0;               // square, a power of two
    std::vector<float> value;   // weighted mean at this level or below
    std::vector<float> weight;  // 0: no sample near; 1: samples at this level

    explicit PushPullImage(int side_ = 0);
    void clear(int side_);  // as if made anew
    // (x, y) in pixels, pixel centres at whole + 1/2.
    void splat(float x, float y, float sample);
};

// Fills `image` in place. `reach`: levels that may fill a gap (each doubles the distance); pixels
// farther from all samples keep weight 0. Others end with weight in (0, 1].
void push_pull(PushPullImage& image, int reach);

}  // namespace burnish
