// Mean reflection of the yarns of one family, seen from so far that yarns are not resolved: the
// mean of the lobe over the visible normals of the surface (docs/theory/cloth.md).
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "burnish/f32.hpp"
#include "maps/weave/weave_cells.hpp"

namespace burnish {

// Of the table, and of the samples of the surface that it is a mean over. Coarse: for pictures in motion, in
// a thirtieth of the time or less where the full one takes long.
enum class WeaveDetail { full, coarse };
constexpr int weave_table_side(WeaveDetail detail) {
    return detail == WeaveDetail::full ? 96 : 32;
}

// The lobe on every point of the surface, its x axis along the fibers.
struct WeaveLobe {
    int brdf = 0;
    f32::Lobe lobe{};
    int method = 0;
    bool conserve = false;
    f32::vec2 twist{1.0f, 0.0f};  // (cos, sin) of the angle from the yarn to the fibers
};

// The mean of a family in the yarn's axes: x along the yarn, y across.
struct WeaveMean {
    // By half vector h: side x side texels over h.x/h.z and h.y/h.z by weave_table_coordinate with
    // `width`, texel i at coordinate (2 i + 1)/side - 1. A texel holds the mean over the surface of
    // brdf_lobe_factor, divided by `peak`, and x, y of the mean normal weighted by it.
    std::vector<std::array<float, 4>> table;
    int side = 0;
    glm::vec2 width{1.0f};
    float peak = 1.0f;
    // Normals for the cosines: root mean squares along and across, and the mean of z.
    glm::vec3 node{0.0f, 0.0f, 1.0f};
    glm::vec2 variance{0.0f};  // of the slopes
};

// An empty `slopes` gives a table of zeros. The same on any number of threads.
WeaveMean weave_mean(std::span<const WeaveSlope> slopes, const WeaveLobe& lobe,
                     WeaveDetail detail = WeaveDetail::full);

// As above, with a number of slopes that suits the width of the lobe.
WeaveMean weave_mean(const WeaveFamily& family, const f32::WeaveShape& shape, const WeaveLobe& lobe,
                     WeaveDetail detail = WeaveDetail::full);

// All that the means of a cloth depend on.
struct ClothLobe {
    WeaveFamilies families;
    f32::WeaveShape shape{};
    WeaveLobe lobe;
    bool operator==(const ClothLobe& other) const;
};
struct ClothMeans {
    WeaveMean weft, warp;
    WeaveDetail detail = WeaveDetail::full;
};
ClothMeans cloth_means(const ClothLobe& lobe, WeaveDetail detail);

}  // namespace burnish
