// What the texts take from the precision that they are compiled in, once for every build of them
// (include/burnish/f32.hpp, f64.hpp, src/models/batch/mdf_batch_text.hpp). prelude.glsl has GLSL's own.
#pragma once

namespace burnish::dialect {

template <typename Scalar>
struct Precision;

// Enough nodes for the Ward normaliser (mdf/ward.glsl) and steps for the root of K11 Eq 5 to reach
// rounding error. Cosines that BRDFs divide by are held above the one, and values and densities
// below the other: nothing becomes infinite at the horizon.
template <>
struct Precision<float> {
    static constexpr int ward_nodes = 8;
    static constexpr int deform_root_steps = 14;
    static constexpr float least_cosine = 1e-12f;
    static constexpr float most_value = 1e30f;
};

template <>
struct Precision<double> {
    static constexpr int ward_nodes = 48;
    static constexpr int deform_root_steps = 18;
    static constexpr double least_cosine = 1e-100;
    static constexpr double most_value = 1e300;
};

}  // namespace burnish::dialect
