// The direction of scratches and the wear of the surface. Private to the scratch generator.
//
// Points are in units of the tile, (0, 0) the upper left corner, y down the picture; the tile
// repeats.
#pragma once

#include "burnish/image.hpp"
#include "burnish/scratch_maps.hpp"
#include "burnish/scratch_settings.hpp"

namespace burnish {

struct TilePoint {
    double x = 0.0;
    double y = 0.0;
};

// A line at the angle a as (cos 2a, sin 2a), counter-clockwise with y up; (0, 0) for no direction.
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
    // Curvature of the field along itself, radians per tile: that of a scratch that follows the
    // field.
    double curvature_at(TilePoint p) const;
    // Whether scratches end at the edge of the tile because the field does not repeat.
    bool full_face() const;

  private:
    DoubleAngle unturned(TilePoint p) const;

    ScratchField kind_;
    double turn_;  // radians
    Image image_;  // double angle, two channels
};

// Bilinear look-up of `channel` of an image stretched over the repeating tile.
double sample_tile(const Image& image, int channel, TilePoint p);

}  // namespace burnish
