// Solves for the part of a distribution that the samples of one point determine: W08's method with
// corrections (docs/theory/capture-model.md).
//
//   rho_q = I_q / received_q; diffuse = the 2nd percentile of rho (the minimum reads low under
//   noise); D(h_q) = 4 (rho_q - diffuse) g(i_q) g(o) / (F(c_q)/F(1)), g = Int max(h.k, 0) D over
//   the known part, D normalised before each g; at most 10 rounds.
#pragma once

#include <span>
#include <vector>

#include "capture/solve/push_pull.hpp"
#include "capture/stack/light_geometry.hpp"

namespace burnish {

struct PartialNdf {
    float diffuse = 0.0f;   // luminance albedo, first estimate
    float specular = 0.0f;  // Int D (n.h) over the known part, before normalization
    int rounds = 0;
};

// Memory that a worker reuses from point to point.
class PartialNdfWork {
    friend class PartialNdfSolver;
    struct Cell {
        std::size_t index;
        float base;    // 4 (rho - diffuse) / (F(c)/F(1))
        GridPlace in;  // position of i of the cell's light on the coarse grid
    };
    PushPullImage image_;
    std::vector<Cell> known_;
    std::vector<float> fresnel_, coarse_, areas_, next_;
};

class PartialNdfSolver {
  public:
    // `spacing_rad`: spacing of half vectors; the solver fills gaps of about this width.
    PartialNdfSolver(const NdfGrid& grid, float spacing_rad, float eta);

    // Writes a table and its weights (0: unknown), one value for each cell. `samples` is in the
    // frame of the point's normal. D is normalized over the known part.
    PartialNdf solve(const PointSamples& samples, PartialNdfWork& work, float* table,
                     float* weights) const;

  private:
    void splat(const PointSamples& samples, float low, PartialNdfWork& work) const;
    void read_cells(const PointSamples& samples, PartialNdfWork& work, float* weights) const;
    float next_areas(const float* table, PartialNdfWork& work) const;  // the largest change

    NdfGrid grid_;
    RelativeFresnel fresnel_;
    int side_;  // pixels of a side of the picture that samples are splatted into
    std::vector<Vec3f> cell_direction_;
    std::vector<float> cell_x_, cell_y_;  // position of each cell in that picture
    std::vector<float> cell_mass_;        // cos(theta) dw
    // Of each cell: the index of its block of the coarse grid, and its share of the block's solid
    // angle.
    std::vector<std::size_t> cell_block_;
    std::vector<float> cell_share_;
    std::vector<float> area_kernel_;  // coarse cells x coarse directions: max(h.k, 0) dw
    std::vector<float> least_area_;   // k_z of each coarse direction
};

// The quantile `share` of rho = I / received (luminance); 0 without samples.
float low_percentile(const PointSamples& samples, float share);

inline constexpr float kDiffuseShare = 0.02f;

}  // namespace burnish
