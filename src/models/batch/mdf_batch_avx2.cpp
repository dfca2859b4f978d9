// Compiled with -mavx2 -mfma (CMakeLists.txt); called only where the processor has both.
#define BURNISH_SIMD simd_avx2
#define BURNISH_KERNELS kMdfKernelsAvx2
#include "models/batch/mdf_batch_kernels.inc"
