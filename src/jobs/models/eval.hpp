// `burnish mdf eval` and `burnish brdf eval`: a table of questions in, the same table with the
// answers as further columns out.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "burnish/progress.hpp"

namespace burnish {

enum class Precision { f32 = 0, f64 = 1 };
std::span<const std::string_view> precision_names();

struct EvalRequest {
    std::string input;   // "-": standard input
    std::string output;  // "-": standard output
    Precision precision = Precision::f64;
};

// Reads mdf,p0,p1,method,nx,ny,nz,hx,hy,hz; adds D, D_proj, D_conserving. Numbers are read and
// written in the chosen precision, shortest digits that read back as the same number.
void eval_mdf_table(const EvalRequest& request, const Progress& progress);

// Reads brdf,p0..p4,ix,iy,iz,ox,oy,oz (and mdf, smith for the model `microfacet`); adds f.
void eval_brdf_table(const EvalRequest& request, const Progress& progress);

// The models that the column `brdf` may name.
std::span<const std::string_view> brdf_table_names();

}  // namespace burnish
