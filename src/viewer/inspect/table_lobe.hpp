// One exemplar of a measured material in double precision: values, areas and draws, as
// shaders/lib/tabulated.glsl looks them up.
//
// Angles in turns run from the lobe's x axis to the table's.
//
// Threads: any number may use a TableLobe; what is made when it is first needed is made once.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "burnish/f64.hpp"
#include "burnish/tabulated_material.hpp"
#include "scene/material/tabulated_draws.hpp"

namespace burnish::viewer {

// What a table is integrated to, when it is first needed.
struct TableIntegrals {
    std::once_flag areas_made, draws_made;
    std::vector<float> areas;
    TabulatedDraws draws;
};

class TableLobe {
  public:
    TableLobe(std::shared_ptr<const TabulatedMaterial> material, int exemplar,
              std::shared_ptr<TableIntegrals> integrals);

    double D(const f64::LobePoint& q, double turns) const;
    NdfOrigin origin(const f64::LobePoint& q, double turns) const;
    // Center of the highest cell, unit, against the lobe's axes.
    f64::vec3 highest(double turns) const;
    // |w| g(w/|w|): the area of facets that w sees. The first call takes some 40 ms.
    double area(f64::vec3 w, double turns) const;

    // A half vector by two numbers of [0, 1), and its density per steradian.
    f64::vec3 sample(f64::vec2 xi, double turns) const;
    double density(const f64::LobePoint& q, double turns) const;

  private:
    const TabulatedDraws& draws() const;

    std::shared_ptr<const TabulatedMaterial> material_;
    std::shared_ptr<TableIntegrals> integrals_;
    int exemplar_ = 0, highest_cell_ = 0;
};

// The exemplar's TableLobe. The integrals of the last 256 exemplars are kept as long as their material is
// alive. A table must not be changed in place. Thread-safe.
std::shared_ptr<const TableLobe> table_lobe(
    const std::shared_ptr<const TabulatedMaterial>& material, int exemplar);

}  // namespace burnish::viewer
