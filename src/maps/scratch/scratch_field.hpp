// Which way scratches run, and where the surface is worn. Private to the scratch generator.
//
// Points are tile units, (0, 0) the upper left corner, y down the picture; the tile repeats.
#pragma once

#include "burnish/image.hpp"
#include "burnish/scratch_maps.hpp"
#include "burnish/scratch_settings.hpp"

namespace burnish {

struct TilePoint {
    double x = 0.0;
    double y = 0.0;
};

// A line field as (cos 2a, sin 2a), a counter-clockwise with y up; (0, 0) where it has none.
struct DoubleAngle {
    double c = 0.0;
    double s = 0.0;
    double angle() const;  // -pi/2..pi/2
    explicit operator bool() const { return c != 0.0 || s != 0.0; }
};

class GrainField {
  public:
    GrainField(const ScratchLayer& layer, const ScratchInputs& inputs);

    // Of unit length or zero.
    DoubleAngle at(TilePoint p) const;
    // How fast the field turns along itself, radians a tile; what a scratch that follows it needs.
    double curvature_at(TilePoint p) const;
    // Scratches end at the edge of the tile: the field does not go on beyond it.
    bool full_face() const;

  private:
    DoubleAngle unturned(TilePoint p) const;

    ScratchField kind_;
    double turn_;  // radians
    Image image_;  // double angle, two channels
};

// Bilinear, repeating; `channel` of an image stretched over the tile.
double sample_tile(const Image& image, int channel, TilePoint p);

}  // namespace burnish
