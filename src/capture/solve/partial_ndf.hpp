// The part of a distribution that one point shows by itself: W08's solve, corrected
// (docs/theory/capture-model.md).
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
    float specular = 0.0f;  // Int D (n.h) over the known part, before it was normalised
    int rounds = 0;
};

// Memory that a worker keeps from one point to the next.
class PartialNdfWork {
    friend class PartialNdfSolver;
    struct Cell {
        std::size_t index;
        float base;    // 4 (rho - diffuse) / (F(c)/F(1))
        GridPlace in;  // of the light that shows it, on the coarse grid
    };
    PushPullImage image;
    std::vector<Cell> known;
    std::vector<float> fresnel, coarse, areas, next;
};

class PartialNdfSolver {
  public:
    // `spacing_rad`: how far apart half vectors lie; gaps are filled over about that far.
    PartialNdfSolver(const NdfGrid& grid, float spacing_rad, float eta);

    // Writes a table and its weights (0: unknown), cells each. `samples` lies in the frame of the
    // point's normal. D is normalised over the known part.
    PartialNdf solve(const PointSamples& samples, PartialNdfWork& work, float* table,
                     float* weights) const;

  private:
    void splat(const PointSamples& samples, float low, PartialNdfWork& work) const;
    void read_cells(const PointSamples& samples, PartialNdfWork& work, float* weights) const;
    float next_areas(const float* table, PartialNdfWork& work) const;  // the largest change

    NdfGrid grid_;
    RelativeFresnel fresnel_;
    int side_;  // of the picture that samples are splatted into
    std::vector<Vec3f> cell_direction_;
    std::vector<float> cell_x_, cell_y_;  // place of each cell in that picture
    std::vector<float> cell_mass_;        // cos(theta) dw
    // Of each cell: its block of the coarse grid, and dw by that of all the block's cells.
    std::vector<std::size_t> cell_block_;
    std::vector<float> cell_share_;
    std::vector<float> area_kernel_;  // coarse cells x coarse directions: max(h.k, 0) dw
    std::vector<float> least_area_;   // k_z of each coarse direction
};

// The share-th smallest of rho = I / received (luminance); 0 without samples.
float low_percentile(const PointSamples& samples, float share);

inline constexpr float kDiffuseShare = 0.02f;

}  // namespace burnish
