// Strokes into texels. Private to the scratch generator.
#pragma once

#include <cstddef>
#include <vector>

#include "burnish/scratch_settings.hpp"
#include "maps/scratch/scratch_strokes.hpp"

namespace burnish {

// Texels a side of the squares that are engraved independently of one another: their buffers (five
// floats a texel) stay in the second-level cache.
inline constexpr int kBlock = 128;

// A stroke ready to be drawn: texels, y down, float where one texel is looked at.
struct TexelStroke {
    double mx, my;          // the middle
    double tx, ty, nx, ny;  // tangent and left normal there, y down
    double k;               // curvature, 0 when the arc leaves its tangent by less than it shows
    double half_length, half_width;
    double depth;                        // millimetres
    double cap_a, cap_b, cap_c;          // the round profile: b (1 - q^2) / (sqrt(a - b q^2) + c)
    double taper_begin;                  // |s| where the taper begins
    float low_x, high_x, low_y, high_y;  // bounds
};

TexelStroke texel_stroke(const Stroke& stroke, double taper, double texel_mm);

// Which strokes touch which block. `shift_x`, `shift_y`: whole tiles that the stroke has to be
// moved by to lie there.
struct StrokeUse {
    std::uint32_t stroke;
    std::int16_t shift_x, shift_y;
};

class StrokeBins {
  public:
    StrokeBins(const std::vector<TexelStroke>& strokes, int size);
    std::size_t bytes() const { return uses_.size() * sizeof(StrokeUse); }
    const StrokeUse* begin(std::size_t block) const { return uses_.data() + first_[block]; }
    const StrokeUse* end(std::size_t block) const { return uses_.data() + first_[block + 1]; }

  private:
    std::vector<std::size_t> first_;
    std::vector<StrokeUse> uses_;
};

// Texels of a row are drawn so many at a time; buffers are longer by as many.
inline constexpr int kSpanPadding = 4;

// What one layer leaves on a block. Values of a texel do not depend on the order of strokes but
// for the direction of exact ties, where the first stroke wins.
struct BlockBuffers {
    int x0 = 0, y0 = 0, width = 0, height = 0;
    std::vector<float> groove;          // <= 0, millimetres: the deepest
    std::vector<float> lip;             // >= 0: the highest
    std::vector<float> score;           // |height| of the stroke that gave the direction
    std::vector<float> line_x, line_y;  // its left normal, y down, of any length

    void move_to(int x0_, int y0_, int width_, int height_);  // empty
    void clear_layer();  // groove and lip; score and direction go on
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

void draw_stroke(const TexelStroke& stroke, ScratchProfile profile, double move_x, double move_y,
                 BlockBuffers& block);

}  // namespace burnish
