// OpenEXR pictures of luminance and subsampled chroma (channels Y, RY, BY), which OpenImageIO 2.4
// refuses. Private to the image reader.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "burnish/image.hpp"

namespace burnish {

// The first part as linear RGB, or RGBA with alpha not premultiplied, f32. `bytes` have passed
// check_image_structure. Throws Error for subsampled channels of other names and for broken data.
Texture decode_subsampled_exr(std::span<const std::byte> bytes, const std::string& name);

}  // namespace burnish
