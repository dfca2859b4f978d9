// The directional albedo of a reflection model without Fresnel, as a table.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "burnish/f64.hpp"
#include "burnish/shading_names.hpp"

namespace burnish {

// Int f cos dwi of the unperturbed model, F = 1, for every roughness pair and direction of the view:
// three coefficients a node, [cosine][alpha across][alpha along]. shading/brdf/albedo.glsl says what
// the axes and the coefficients are; models/albedo_nodes.hpp how many nodes there are and what they
// hold. Threads: immutable.
class AlbedoTable {
  public:
    AlbedoTable(Brdf brdf, Mdf mdf);

    const std::vector<std::array<float, 3>>& nodes() const { return nodes_; }

    // The albedo at a place of the table.
    double at(const f64::AlbedoPlace& place) const;

  private:
    std::vector<std::array<float, 3>> nodes_;
};

// The table of a model, kept until the process ends. The build makes those of microfacet and
// microfacet-separable for every distribution: within 0.95 % of the integral for alphas from 0.05 to 1
// (tests/models/albedo_table_test.cpp). Those of other models are computed at the first call, from 9.8
// million samples, without the coefficients of the mixed term: 1.6 % in the mean over a sphere of
// alphas 0.15 and 0.5, up to 8 % in a direction where the alphas differ twentyfold. The same on any
// number of threads. Threads: any.
std::shared_ptr<const AlbedoTable> albedo_table(Brdf brdf, Mdf mdf);

// surface_compensated by the albedo that the table has for the lobe of `material` under `p`, seen from
// `wo` (unit, in the lobe's unperturbed space).
f64::SurfaceMaterial compensated(const f64::SurfaceMaterial& material, const AlbedoTable& table,
                                 const f64::Perturbation& p, f64::vec3 wo);

}  // namespace burnish
