// Light and view directions at the pixels of a stack, and the samples made from them in the layout
// of the fits: one array for each quantity, single precision, positions on polar grids computed
// once.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "burnish/ndf_grid.hpp"
#include "burnish/rig.hpp"

namespace burnish {

using Vec3f = std::array<float, 3>;

// Directions in sample space and the light received from them, for one point.
struct PointLights {
    Vec3f to_eye{0.0f, 0.0f, 1.0f};
    std::vector<float> x, y, z;                  // towards each light, unit
    std::array<std::vector<float>, 3> received;  // L cos^m / r^2, rgb

    std::size_t size() const { return x.size(); }
};

class LightGeometry {
  public:
    LightGeometry(const Rig& rig, int width, int height);
    void at(std::size_t pixel, PointLights& out) const;
    std::size_t lights() const { return rig_.lights.size(); }
    bool all_far() const { return all_far_; }

  private:
    Rig rig_;
    int width_, height_;
    bool all_far_ = false;
    PointLights far_;
};

// A position on a polar grid: between rings `ring` and `ring` + 1, at the fractional `column` in
// [0, azimuths).
struct GridPlace {
    int ring = 0;
    float fraction = 0.0f;
    float column = 0.0f;
};
// (x, y, z) may have any length.
GridPlace grid_place(const NdfGrid& grid, float x, float y, float z);

// The same on the nodes of the areas that ndf_areas computes.
GridPlace area_place(float x, float y, float z);

// ndf_lookup at a precomputed position, with the table rotated by `shift` columns.
inline float lookup(const NdfGrid& grid, const float* table, const GridPlace& place, float shift) {
    const auto columns = static_cast<float>(grid.azimuths);
    // Reduces `shift` to one circle. It is the same for all positions of a loop, so that compilers
    // move it out of the loop.
    float rotation = shift - columns * static_cast<float>(static_cast<int>(shift / columns));
    if (rotation < 0.0f) rotation += columns;
    float c = place.column - rotation;
    if (c < 0.0f) c += columns;
    int c0 = static_cast<int>(c);
    if (c0 >= grid.azimuths) c0 = 0;
    const int c1 = c0 + 1 == grid.azimuths ? 0 : c0 + 1;
    const float t = c - static_cast<float>(static_cast<int>(c));
    const float* low = table + place.ring * grid.azimuths;
    const float* high = place.ring + 1 < grid.rings ? low + grid.azimuths : low;
    const float a = low[c0] + t * (low[c1] - low[c0]);
    const float b = high[c0] + t * (high[c1] - high[c0]);
    return a + place.fraction * (b - a);
}

// g of a direction with this z, from the areas of ndf_areas.
inline float area_at(const float* areas, const GridPlace& place, float z, float shift) {
    const float g = z + lookup(kAreaGrid, areas, place, shift);
    return g > 1e-6f ? g : 1e-6f;  // the lower bound of ndf_area_lookup
}

// Transforms directions of sample space to the frame of a normal, made by the shortest rotation
// from +z.
class NormalFrame {
  public:
    explicit NormalFrame(const Vec3f& normal);
    Vec3f operator()(float x, float y, float z) const {
        return {t_[0] * x + t_[1] * y + t_[2] * z, b_[0] * x + b_[1] * y + b_[2] * z,
                n_[0] * x + n_[1] * y + n_[2] * z};
    }
    Vec3f operator()(const Vec3d& v) const {
        return (*this)(static_cast<float>(v[0]), static_cast<float>(v[1]),
                       static_cast<float>(v[2]));
    }

  private:
    Vec3f t_, b_, n_;
};

// The samples of one point in the frame of its normal: those of lights above its horizon that are
// not clipped.
struct PointSamples {
    std::vector<int> light;       // index of each sample's light
    std::vector<GridPlace> half;  // of h, on the exemplars' grid
    std::vector<GridPlace> in;    // of i, on the nodes of areas
    GridPlace out;                // of o, on the nodes of areas
    std::vector<float> cosine_ih;
    std::vector<float> weight_rgb[3];    // I = rho * this: n.i L cos^m / r^2
    std::vector<float> value_rgb[3];     // I
    std::vector<float> received, value;  // luminance of both
    Vec3f to_eye{};                      // in the normal's frame
    std::vector<Vec3f> to_light;         // likewise

    std::size_t size() const { return light.size(); }
    void resize(std::size_t count);
};

// Least cosine between light and normal of a sample, 6 degrees above the surface: below it, an
// error of the normal by a few degrees changes the predicted sample by as much as its value.
inline constexpr float kLeastLightCosine = 0.1f;

// `values`: lights x 3, infinite where clipped. `keep`: lights to take part (empty: all).
void gather_samples(const PointLights& lights, const Vec3f& normal, std::span<const float> values,
                    std::span<const std::uint8_t> keep, const NdfGrid& grid, PointSamples& out);

// Keeps at most `most` samples: half of them the brightest, the others evenly spread over the
// remaining ones in the order of lights.
void thin_samples(const PointSamples& samples, std::size_t most, PointSamples& out);

// F(c) / F(1) of a dielectric of index eta; 1 for eta = 0 (docs/theory/capture-model.md).
class RelativeFresnel {
  public:
    explicit RelativeFresnel(float eta);
    float operator()(float cosine) const;
    void of(const std::vector<float>& cosines, std::vector<float>& out) const;

  private:
    float eta_, by_;  // by_: 1 / F(1)
};

}  // namespace burnish
