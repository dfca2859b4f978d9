// Contact sheets of labeled pictures, and difference images, for comparison by eye.
#pragma once

#include <string>
#include <vector>

#include "burnish/image.hpp"

namespace burnish {

// `image` holds display values (sRGB-encoded, 0..1): grey, RGB or RGBA, which is laid over the
// background. An empty image leaves its place empty.
struct SheetCell {
    Image image;
    std::string label;  // drawn above the image, wrapped to its width
};

struct SheetOptions {
    int padding_px = 12;  // around and between the cells
    int font_px = 16;
    float background = 0.16f;  // display values: neutral and dark, so that it does not bias the eye
    float text = 0.86f;
};

// RGB, display values. Rows may differ in length; columns are as wide as their widest image (or
// word of a label), rows as high as their highest image. Labels are UTF-8, marked up as
// Canvas::text says. Throws Error when the sheet would be larger than an image may be.
Image compose_sheet(const std::vector<std::vector<SheetCell>>& rows,
                    const SheetOptions& options = {});

// The difference of `b` from `a` (same size; display values): black where they agree,
// through orange to pale yellow where b is brighter, through blue to pale cyan where it is darker;
// the full colour is reached at a difference of 1/gain. Of the three channels the one that differs
// most counts, so that a shift of hue shows too. Alpha is ignored; NaN in either shows magenta.
Image difference_image(const Image& a, const Image& b, float gain = 4.0f);

// One gain for the differences of `others` from `reference`: the largest of 1, 1.5, 2, 3, 4, 6 ...
// 32 at which no more than 2 % of the pixels that differ visibly reach the full colour; 1 when none
// does. NaN does not count.
float difference_gain(const Image& reference, const std::vector<Image>& others);

// Root mean square difference over the colour channels (alpha ignored); NaN when either holds one.
double rmse(const Image& a, const Image& b);

}  // namespace burnish
