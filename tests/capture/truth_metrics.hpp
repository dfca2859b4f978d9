// Errors of a fitted material relative to the simulated sample that it was fitted to. Uses the
// closed forms of the truth, and nothing of the fit except its material.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/tabulated_material.hpp"
#include "burnish/virtual_sample.hpp"

namespace burnish::test {

// Writes a stack of the sample under the rig to `folder` as OpenEXR; returns the rig with its
// pictures.
Rig write_stack(const VirtualSample& sample, const Rig& rig, const VirtualCamera& camera,
                const std::filesystem::path& folder);

struct ClassMetrics {
    std::string name;
    int texels = 0;
    double angle_median_deg = 0.0, angle_p90_deg = 0.0;  // modulo 180, less each exemplar's offset
    double l1_covered = 0.0, l1_all = 0.0;  // Int |D - truth| cos dw, median over texels' exemplars
    double specular_ratio = 0.0;            // median ratio of fitted to true k_s F(1)
    double diffuse_ratio = 0.0;
};

// Returns one entry for each distribution of the sample.
std::vector<ClassMetrics> compare_to_truth(const VirtualSample& sample,
                                           const TabulatedMaterial& material);

// rho of a texel of the material; `areas` are those of areas_of.
Vec3d material_brdf(const TabulatedMaterial& material, const std::vector<std::vector<float>>& areas,
                    int column, int row, const Vec3d& to_light, const Vec3d& to_eye);
std::vector<std::vector<float>> areas_of(const TabulatedMaterial& material);

}  // namespace burnish::test
