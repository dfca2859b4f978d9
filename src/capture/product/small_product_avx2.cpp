// Compiled with -mavx2 -mfma (CMakeLists.txt); called only where the processor has both: 16
// registers of 8 numbers.
#define BURNISH_PRODUCT small_product_avx2
#define BURNISH_LANES 8
#define BURNISH_ROWS 6
#include "capture/product/small_product_kernel.inc"
