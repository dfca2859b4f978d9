// The format that write_image writes for the ending of a name.
#pragma once

#include <filesystem>

#include "image/guard/format.hpp"

namespace burnish {

// Throws UsageError for another ending than .png, .jpg, .jpeg, .tif, .tiff and .exr.
ImageFormat require_written_format(const std::filesystem::path& path);

}  // namespace burnish
