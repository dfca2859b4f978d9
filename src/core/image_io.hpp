// Reading and writing pictures through OpenImageIO. Formats are a list we allow: PNG, JPEG, TIFF,
// OpenEXR and Radiance HDR, told by content, with OpenImageIO's size limits set.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "burnish/image.hpp"

namespace burnish {

// Any allowed format to linear float, 1, 3 or 4 channels (others are reduced or refused in words).
// sRGB encodings (8-bit PNG/JPEG/TIFF) are linearised unless `as_data`. NaN and infinities throw
// when `finite_only`. Throws Error naming the file for missing, truncated, hostile or huge files.
struct ReadOptions {
    bool as_data = false;
    bool finite_only = true;
};
Image read_image(const std::filesystem::path& path, const ReadOptions& options = {});

// A texture at its own depth (u8, u16, f32), from a file or from the bytes of one (glTF buffers).
Texture read_texture(const std::filesystem::path& path, ColorSpace color_space);
Texture decode_texture(std::span<const std::byte> bytes, const std::string& name,
                       ColorSpace color_space);

// What a file holds, without reading its pixels: for `burnish info`.
struct ImageInfo {
    std::string format;
    int width = 0, height = 0, channels = 0;
    std::string pixel_type;
    std::map<std::string, std::string> metadata;
};
ImageInfo read_image_info(const std::filesystem::path& path);
bool is_image_file(const std::filesystem::path& path);  // by content

// Writes by extension: .png (8-bit), .jpg, .tif (8-bit) take DISPLAY values (already tone mapped,
// sRGB-encoded, 0..1); .exr takes linear values as they are. `metadata`: attributes such as
// "burnish:command". Written whole or not at all. Throws Error for other extensions, before
// anything is written.
void write_image(const std::filesystem::path& path, const Image& image,
                 const std::map<std::string, std::string>& metadata);
bool holds_linear(const std::filesystem::path& path);          // .exr
void require_image_extension(const std::filesystem::path& path);  // UsageError unless one of ours

float srgb_from_linear(float linear);
float linear_from_srgb(float srgb);

}  // namespace burnish
