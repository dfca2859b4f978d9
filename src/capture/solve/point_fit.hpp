// The fit of one point to a given exemplar: the rotation of the exemplar, and the diffuse and
// specular strengths, by least squares on the pictures' own values.
//
//   I_q = received_q (d / pi + s b_q),  b_q = F(i.h)/F(1) D(h) / (4 g(i) g(o))
//
// d and s are linear and solved for within every trial of the angle (variable projection).
#pragma once

#include <array>

#include "burnish/f32.hpp"
#include "capture/stack/light_geometry.hpp"

namespace burnish {

// Error that stands for "no fit": above the errors of all fits, which are at most 1.
inline constexpr float kNoFit = 2.0f;

// An exemplar's tables, shared by all points: D normalised, areas on kAreaGrid.
struct ExemplarTables {
    NdfGrid grid;
    const float* D = nullptr;
    const float* areas = nullptr;
};

// Columns of the area grid for `shift` columns of the exemplar's grid.
inline float area_shift(const NdfGrid& grid, float shift) {
    return shift * static_cast<float>(kAreaGrid.azimuths) / static_cast<float>(grid.azimuths);
}

// b of one sample where the exemplar is rotated by `shift` columns. `fresnel` is F(c)/F(1).
inline float specular_shape(const ExemplarTables& tables, const PointSamples& samples,
                            std::size_t q, float shift, float fresnel, float area_out) {
    const float d = lookup(tables.grid, tables.D, samples.half[q], shift);
    const float area_in = area_at(tables.areas, samples.in[q], samples.to_light[q][2],
                                  area_shift(tables.grid, shift));
    return f32::area_brdf(fresnel * d, area_in, area_out);
}

struct PointFit {
    float shift = 0.0f;                     // columns of the exemplars' grid
    float diffuse = 0.0f, specular = 0.0f;  // luminance
    float error = 0.0f;  // weighted mean square of the residuals; 1: nothing is explained
};

// The weight of a sample is 1 / (I + mean I)^2: errors in a bright highlight are relative, so that
// its peak does not dominate, and errors in the dark are absolute. Keeps a pointer to the samples;
// const members may be called from several threads.
class PointFitter {
  public:
    // eta: index of refraction; 0 omits the Fresnel factor. `samples` must outlive the fitter.
    PointFitter(const PointSamples& samples, float eta);

    // Diffuse and specular strength at a given rotation, both nonnegative.
    PointFit at(const ExemplarTables& tables, float shift) const;
    // Searches for the best rotation within `width` columns of `shift` and of the rotation half a
    // circle from it, to about 0.02 columns. A camera often sees nearly the same of a distribution
    // after half a turn. Returns early, before the minimum, if the error is above `give_up` after
    // the first step.
    PointFit refined(const ExemplarTables& tables, float shift, float width,
                     float give_up = 1e30f) const;
    // Searches for the best rotation within about 2 `width` columns of `shift`.
    PointFit nearby(const ExemplarTables& tables, float shift, float width) const;
    // Diffuse and specular strength of each channel at a given rotation.
    void colors(const ExemplarTables& tables, float shift, std::array<float, 3>& diffuse,
                std::array<float, 3>& specular) const;

    const std::vector<float>& weights() const { return weights_; }
    const std::vector<float>& fresnel() const { return fresnel_; }

  private:
    PointFit descend(const ExemplarTables& tables, PointFit best, float width, float give_up) const;

    const PointSamples* samples_;
    std::vector<float> weights_, fresnel_;
    std::vector<float> uv_, vv_, vy_;  // terms of the normal equations without b
    double uu_ = 0.0, uy_ = 0.0, value_square_ = 0.0;
};

}  // namespace burnish
