#include "burnish/f32.hpp"
#include "burnish/image_io.hpp"

namespace burnish {

float srgb_from_linear(float linear) {
    return f32::srgb_from_linear(linear);
}

float linear_from_srgb(float srgb) {
    return f32::linear_from_srgb(srgb);
}

}  // namespace burnish
