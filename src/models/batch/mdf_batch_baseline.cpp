// For every processor that the compiler's baseline covers.
#define BURNISH_SIMD simd_baseline
#define BURNISH_KERNELS kMdfKernelsBaseline
#include "models/batch/mdf_batch_kernels.inc"
