// The size of the picture that a HEIF or AVIF file decodes to.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace burnish {

// Decodes the picture and compares its size with the one that its header states. Returns "" where they agree,
// else the fault in words. OpenImageIO 2.4 makes rows of the stated size and copies them from the decoded
// picture, beyond its end where that is smaller.
std::string heif_size_fault(std::span<const std::byte> bytes, int width, int height);

}  // namespace burnish
