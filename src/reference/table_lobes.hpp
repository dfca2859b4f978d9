// The distributions of a tabulated material on the CPU, read as shaders/lib/tabulated.glsl reads them.
#pragma once

#include <memory>
#include <vector>

#include "burnish/f32.hpp"
#include "burnish/tabulated_material.hpp"
#include "scene/material/tabulated_draws.hpp"

namespace burnish {

// One exemplar. `groove`: from the lobe's x axis to the table's, in turns. Threads: immutable.
class TableLobe {
  public:
    TableLobe(const TabulatedMaterial& material, int exemplar);

    float D(const f32::LobePoint& q, float groove) const;
    // tabulated_area seen from w.
    float area(const f32::vec3& w, float groove) const;
    // The density of `sample`, per steradian.
    float density(const f32::LobePoint& q, float groove) const;
    // A half vector of the unperturbed distribution.
    f32::vec3 sample(const f32::vec2& xi, float groove) const;

  private:
    const NdfGrid& grid_;
    const float* table_;
    std::vector<float> areas_;
    TabulatedDraws draws_;
};

}  // namespace burnish
