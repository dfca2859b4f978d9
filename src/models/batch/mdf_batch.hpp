// The distributions over whole columns of directions, several at a time (xsimd): the same text as
// mdf.hpp, compiled with a register of numbers for Float. AVX2 with FMA where the processor has
// them, asked at run time; what the compiler's baseline offers (SSE2, NEON) elsewhere. Values agree
// with the scalar ones to the few last bits in which the elementary functions differ.
#pragma once

#include <span>
#include <string_view>

#include "burnish/shading_names.hpp"

namespace burnish {

template <typename Float>
struct DirectionColumns {
    std::span<const Float> x, y, z;
};

// Where each row has its own parameters. All columns are of one length (else
// std::invalid_argument), with the domains of mdf_values(): unit n with n.z > 0, unit h, p0 and p1
// in range.
template <typename Float>
struct MdfRows {
    std::span<const Float> p0, p1;
    DirectionColumns<Float> n, h;
};

// What MdfValues holds, by column; as long as the rows.
template <typename Float>
struct MdfResults {
    std::span<Float> D, D_proj, D_conserving;
};

void mdf_values(Mdf mdf, Method method, const MdfRows<float>& rows,
                const MdfResults<float>& results);
void mdf_values(Mdf mdf, Method method, const MdfRows<double>& rows,
                const MdfResults<double>& results);

// One lobe for all rows, for tables: D with the unperturbed lobe normalized to Int D (n.h) dw = 1,
// in the energy-conserving form where `conserving`. One thread; a caller may divide the columns.
void mdf_table(Mdf mdf, float p0, float p1, Method method, bool conserving,
               const DirectionColumns<float>& n, const DirectionColumns<float>& h,
               std::span<float> D);
void mdf_table(Mdf mdf, double p0, double p1, Method method, bool conserving,
               const DirectionColumns<double>& n, const DirectionColumns<double>& h,
               std::span<double> D);

// Which instructions the calls above use on this machine: "avx2+fma", "sse2", "neon64", ...
std::string_view mdf_batch_instructions();

}  // namespace burnish
