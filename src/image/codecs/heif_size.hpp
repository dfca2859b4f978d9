// The size of the picture that a HEIF or AVIF file decodes to.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace burnish {

// Throws Error unless the picture has the size that its header states: OpenImageIO 2.4 makes rows of the
// stated size and copies them from a picture of the decoded one, beyond its end where that is smaller.
// Decodes the picture.
void require_heif_size(std::span<const std::byte> bytes, int width, int height,
                       const std::string& name);

}  // namespace burnish
