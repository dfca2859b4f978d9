// Reading and writing pictures through OpenImageIO. The formats are PNG, JPEG, TIFF, OpenEXR and
// Radiance HDR, told by content. Nothing process-wide is changed: OpenImageIO's own limits stay as
// the program has set them.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "burnish/api.hpp"
#include "burnish/image.hpp"

namespace BURNISH_API burnish {

// All readers are thread-safe. They read the first picture of a file that holds several. Pixels
// come in stored order (an Exif orientation is not applied), row 0 at the top. Alpha is not
// premultiplied: files that store color premultiplied are divided. Of more than four channels the
// leading RGBA or RGB are read, found by name. OpenEXR's subsampled chroma becomes RGB. Each reader
// throws Error naming the file for missing, truncated, hostile or huge files (a side over 32768,
// over 4 GiB decoded).

// Reads any of the formats as linear float, 1, 3 or 4 channels (grey with alpha becomes RGBA).
// Integer formats (8- and 16-bit PNG, JPEG, TIFF) hold sRGB-encoded color, which is decoded unless
// `as_data` is set or the file says that it is linear. Alpha is never decoded. NaN and infinities
// throw when `finite_only`.
struct ReadOptions {
    bool as_data = false;
    bool finite_only = true;
};
Image read_image(const std::filesystem::path& path, const ReadOptions& options = {});

// Reads a texture at its own depth (u8, u16, f32), from a file or from the bytes of one (glTF
// buffers). Palettes are expanded; half and double become f32, which is always linear and finite.
Texture read_texture(const std::filesystem::path& path, ColorSpace color_space);
Texture decode_texture(std::span<const std::byte> bytes, const std::string& name,
                       ColorSpace color_space);

// The contents of a file, without decoding its pixels, for `burnish info`. `metadata` holds the
// metadata that write_image was given, in every format, and the file's other attributes.
struct ImageInfo {
    std::string format;
    int width = 0, height = 0, channels = 0;
    std::string pixel_type;  // as stored: "uint8", "uint16", "half", "float" ...
    std::map<std::string, std::string> metadata;
};
ImageInfo read_image_info(const std::filesystem::path& path);
bool is_image_file(const std::filesystem::path& path);  // by content

// Writes by extension: .png, .tif, .tiff (8-bit) and .jpg, .jpeg (quality 95, alpha left out) take
// DISPLAY values (already tone mapped, sRGB-encoded; clamped to 0..1 and rounded, NaN becomes 0);
// .exr (float, zip) takes linear values as they are and stores alpha premultiplied, as the format
// wants it. `metadata`: attributes such as "burnish:command", kept under their names in PNG and
// OpenEXR and as "name=value" lines of the image description in JPEG and TIFF (Software and its
// like stay what they are); values are text of one line. Written whole or not at all. Throws
// UsageError for other extensions and Error for what cannot be written, before anything is touched.
void write_image(const std::filesystem::path& path, const Image& image,
                 const std::map<std::string, std::string>& metadata);
bool holds_linear(const std::filesystem::path& path);             // .exr
bool holds_alpha(const std::filesystem::path& path);              // all but .jpg
void require_image_extension(const std::filesystem::path& path);  // UsageError unless one of ours

// The sRGB curve (IEC 61966-2-1), continued linearly below 0 and by its power above 1.
float srgb_from_linear(float linear);
float linear_from_srgb(float srgb);

}  // namespace burnish
