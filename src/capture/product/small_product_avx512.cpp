// Compiled for x86-64-v4 (CMakeLists.txt); called only where the processor has it: 32 registers of
// 16 numbers.
#define BURNISH_PRODUCT small_product_avx512
#define BURNISH_LANES 16
#define BURNISH_ROWS 13
#include "capture/product/small_product_kernel.inc"
