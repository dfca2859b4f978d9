// `burnish mdf eval` and `burnish brdf eval`: read a table of parameters and directions and write
// it with the values as additional columns.
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
    bool rgb = false;  // eval_brdf_table alone: adds f_r, f_g, f_b
};

// Reads mdf,p0,p1,method,nx,ny,nz,hx,hy,hz; adds D, D_proj, D_conserving. Numbers are read and
// written in the chosen precision, shortest digits that read back as the same number.
void eval_mdf_table(const EvalRequest& request, const Progress& progress);

// Reads brdf,p0..p4,ix,iy,iz,ox,oy,oz (and mdf, smith for the model `microfacet`); adds f. Where
// `brdf` is a measured material (.bsdf, relative to the working folder), f is its luminance, and
// p0..p4 are not read.
void eval_brdf_table(const EvalRequest& request, const Progress& progress);

// The model names that the column `brdf` accepts.
std::span<const std::string_view> brdf_table_names();

}  // namespace burnish
