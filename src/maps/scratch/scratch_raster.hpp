// Strokes into texels. Private to the scratch generator.
#pragma once

#include <cstddef>
#include <vector>

#include "burnish/scratch_settings.hpp"
#include "maps/scratch/scratch_strokes.hpp"

namespace burnish {

// Side in texels of the blocks, which are engraved independently. The buffers of a block (five
// floats per texel) fit in the second-level cache.
inline constexpr int kBlock = 128;

// A stroke prepared for drawing: in texels, y down; float for values read per texel.
struct TexelStroke {
    double mx, my;          // the middle
    double tx, ty, nx, ny;  // tangent and left normal there, y down
    double k;               // curvature, 0 for an arc whose sagitta is invisible
    double half_length, half_width;
    double depth;                        // millimeters
    double cap_a, cap_b, cap_c;          // the round profile: b (1 - q^2) / (sqrt(a - b q^2) + c)
    double taper_begin;                  // |s| where the taper begins
    float low_x, high_x, low_y, high_y;  // bounds
};

TexelStroke texel_stroke(const Stroke& stroke, double taper, double texel_mm);

std::vector<TexelStroke> texel_strokes(const std::vector<Stroke>& strokes, double taper,
                                       double texel_mm);

// A stroke that touches a block. `shift_x`, `shift_y`: translation in whole tiles that moves the
// stroke to the block.
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

// Number of texels of a row that are drawn together; buffers have this many texels of padding.
inline constexpr int kSpanPadding = 4;

// The result of one layer on a block. Values of a texel do not depend on the order of strokes,
// except the direction at exact ties, where the first stroke wins.
struct BlockBuffers {
    int x0 = 0, y0 = 0, width = 0, height = 0;
    std::vector<float> groove;          // <= 0, millimeters: depth of the deepest groove
    std::vector<float> lip;             // >= 0, millimeters: height of the highest lip
    std::vector<float> score;           // |height| of the stroke that set the direction
    std::vector<float> line_x, line_y;  // its left normal, y down, of any length

    void move_to(int x0_, int y0_, int width_, int height_);  // clears all buffers
    void clear_layer();  // clears groove and lip; keeps score and direction
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

void draw_stroke(const TexelStroke& stroke, ScratchProfile profile, double move_x, double move_y,
                 BlockBuffers& block);

}  // namespace burnish
