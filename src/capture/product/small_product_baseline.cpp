// For every processor that the compiler's baseline covers: 16 registers of 4 numbers on x86-64.
#define BURNISH_PRODUCT small_product_baseline
#define BURNISH_LANES 4
#define BURNISH_ROWS 6
#include "capture/product/small_product_kernel.inc"
