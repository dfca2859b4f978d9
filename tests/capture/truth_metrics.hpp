// How far a fitted material is from the simulated sample it was fitted to. Works from the truth's
// own closed forms; takes nothing from the fit but its material.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/tabulated_material.hpp"
#include "burnish/virtual_sample.hpp"

namespace burnish::test {

// Writes a stack of the sample under the rig into `folder` as OpenEXR; returns the rig with
// pictures.
Rig write_stack(const VirtualSample& sample, const Rig& rig, const VirtualCamera& camera,
                const std::filesystem::path& folder);

struct ClassMetrics {
    std::string name;
    int texels = 0;
    double angle_median_deg = 0.0, angle_p90_deg = 0.0;  // mod 180, less one offset an exemplar
    double l1_covered = 0.0, l1_all = 0.0;  // Int |D - truth| cos dw, median over texels' exemplars
    double specular_ratio = 0.0;            // median of fitted k_s F(1) over true
    double diffuse_ratio = 0.0;
};

// One entry a distribution of the sample. `skip`: texels this near the seams of patches (share of
// the width) are left out.
std::vector<ClassMetrics> compare_to_truth(const VirtualSample& sample,
                                           const TabulatedMaterial& material);

// rho of a texel of the material.
Vec3d material_brdf(const TabulatedMaterial& material, const std::vector<std::vector<float>>& areas,
                    int column, int row, const Vec3d& to_light, const Vec3d& to_eye);
std::vector<std::vector<float>> areas_of(const TabulatedMaterial& material);

}  // namespace burnish::test
