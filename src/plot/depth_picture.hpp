// A small picture with a depth buffer: near triangles and lines hide those behind them.
#pragma once

#include <vector>

#include "burnish/image.hpp"
#include "burnish/plot/color_map.hpp"

namespace burnish::plot {

// x, y in pixels, y down; the larger depth is nearer.
struct DepthPoint {
    double x = 0, y = 0, depth = 0;
};

class DepthPicture {
  public:
    DepthPicture(int width, int height, const Rgb& background);

    // Light between 0 and 1 at each corner, interpolated, scales the colour in linear light.
    struct Corner {
        DepthPoint at;
        double light = 1;
    };
    void triangle(const Corner& a, const Corner& b, const Corner& c, const Rgb& color);

    // A line `thickness` pixels wide. It is drawn where its depth is at most `bias` behind the
    // depth buffer, is blended by `opacity`, and writes its depth. `on`, `off`: dashes in pixels
    // (0: solid).
    struct Line {
        Rgb color;
        double thickness = 2;
        double bias = 0;
        double opacity = 1;
        double on = 0, off = 0;
    };
    void line(const DepthPoint& from, const DepthPoint& to, const Line& style);

    // Averages of `factor` x `factor` pixels, in linear light: RGB display values.
    Image reduced(int factor) const;

  private:
    int width_, height_;
    std::vector<float> linear_;  // RGB
    std::vector<double> depth_;
};

}  // namespace burnish::plot
