// The compiled kernels of mdf_batch.hpp, one set for each instruction set. Plain pointers only: a
// file compiled for AVX2 must not share inline functions of the standard library with the rest.
#pragma once

#include <cstddef>

namespace burnish {

template <typename Float>
struct MdfKernelColumns {
    const Float *p0, *p1;  // by row, or one number each where `one_lobe`
    const Float *nx, *ny, *nz, *hx, *hy, *hz;
    Float *D, *D_proj, *D_conserving;  // D and D_proj may be nullptr together
};

template <typename Float>
struct MdfKernelCall {
    int mdf, method;
    bool one_lobe;
    bool conserving;  // what goes into D_conserving: the conserving form or as published
    std::size_t count;
    MdfKernelColumns<Float> columns;
};

struct MdfKernels {
    const char* instructions;
    void (*f32)(const MdfKernelCall<float>&);
    void (*f64)(const MdfKernelCall<double>&);
};

extern const MdfKernels kMdfKernelsBaseline;
#ifdef BURNISH_HAS_AVX2
extern const MdfKernels kMdfKernelsAvx2;
#endif

}  // namespace burnish
