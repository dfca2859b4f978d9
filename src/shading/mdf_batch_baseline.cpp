// For every processor that the compiler's baseline covers.
#define BURNISH_SIMD simd_baseline
#define BURNISH_KERNELS kMdfKernelsBaseline
#include "shading/mdf_batch_kernels.inc"
