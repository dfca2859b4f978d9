// Reading and writing pictures through OpenImageIO. The formats read are PNG, JPEG, WebP, TIFF,
// OpenEXR, Radiance HDR, TGA, BMP, HEIF, AVIF and raw camera files, told by content (raw camera
// files in a TIFF by their name too). Nothing process-wide is changed: OpenImageIO's own limits stay
// as the program has set them.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/image.hpp"

namespace BURNISH_API burnish {

// All readers are thread-safe. They read the first picture of a file that holds several; of HEIF
// and AVIF the primary one, at 8 bits. Pixels come in stored order (an Exif orientation is not
// applied, the turns of HEIF and AVIF are), row 0 at the top. Alpha is not premultiplied: files
// that store color premultiplied are divided. Each reader throws Error naming the file for missing,
// truncated, hostile or huge files (a side over 32768, over 4 GiB decoded).
//
// OpenEXR: the picture is the display window. What the file holds outside it is left out; pixels
// for which it holds nothing are 0. Of several parts the first with R, G and B is read. The
// channels are R, G, B and A without a layer, else those of the first layer that has R, G and B,
// else all of up to four; a warning says when several parts or layers have them. Subsampled chroma
// becomes RGB. Of more than four channels of another format the leading RGBA or RGB are read.
//
// Raw camera files: linear camera RGB, white level at 1, black level subtracted, interpolated
// linearly between the sensor's samples, as the sensor is oriented; no white balance, no color
// matrix, no automatic brightness, no reconstructed highlights. A preview is never read in place of
// the sensor's data. A warning says so.

// Reads any of the formats as linear float, 1, 3 or 4 channels (grey with alpha becomes RGBA).
// Integer formats hold sRGB-encoded color, which is decoded unless `as_data` is set, the file says
// that it is linear, or it is a raw camera file. Alpha is never decoded. NaN and infinities throw
// when `finite_only`. `warnings`, if any, receives what will look different from what the file
// means, one line each.
struct ReadOptions {
    bool as_data = false;
    bool finite_only = true;
    std::vector<std::string>* warnings = nullptr;
};
Image read_image(const std::filesystem::path& path, const ReadOptions& options = {});

// Reads a texture at its own depth (u8, u16, f32), from a file or from the bytes of one (glTF
// buffers). Palettes are expanded; half and double become f32, which is always linear and finite.
Texture read_texture(const std::filesystem::path& path, ColorSpace color_space,
                     std::vector<std::string>* warnings = nullptr);
Texture decode_texture(std::span<const std::byte> bytes, const std::string& name,
                       ColorSpace color_space, std::vector<std::string>* warnings = nullptr);

// The contents of a file, without decoding its pixels, for `burnish info`. `metadata` holds the
// metadata that write_image was given, in every format, and the file's other attributes.
struct ImageInfo {
    std::string format;
    int width = 0, height = 0, channels = 0;
    std::string pixel_type;  // as stored: "uint8", "uint16", "half", "float" ...
    std::map<std::string, std::string> metadata;
    std::vector<std::string> warnings;  // what a reader would warn of
};
ImageInfo read_image_info(const std::filesystem::path& path);
bool is_image_file(const std::filesystem::path& path);  // by content

// Whether a name ends as raw camera files do (.dng, .nef, .cr3 ...), in any case.
bool is_raw_camera_name(const std::filesystem::path& path);

// How display values become whole numbers.
struct WriteOptions {
    int bits = 8;  // of a channel in .png and .tif, 8 or 16; .jpg has 8, and .exr holds floats
    // Before colors are rounded to 8 bits, adds a fixed pattern of noise of up to half a step, so that
    // slow gradients have no bands. The mean is kept, and so are values that 8 bits hold exactly.
    bool dither = false;
};

// Writes by extension: .png, .tif, .tiff (8-bit, or 16-bit by `options`) and .jpg, .jpeg (quality 95,
// alpha left out) take DISPLAY values (already tone mapped, sRGB-encoded; clamped to 0..1 and rounded,
// NaN becomes 0);
// .exr (float, zip) takes linear values as they are and stores alpha premultiplied, as the format
// wants it. `metadata`: attributes such as "burnish:command", kept under their names in PNG and
// OpenEXR and as "name=value" lines of the image description in JPEG and TIFF (Software and its
// like stay what they are); values are text of one line. Written whole or not at all. Throws
// UsageError for other extensions and Error for what cannot be written, before anything is touched.
void write_image(const std::filesystem::path& path, const Image& image,
                 const std::map<std::string, std::string>& metadata,
                 const WriteOptions& options = {});
bool holds_linear(const std::filesystem::path& path);             // .exr
bool holds_alpha(const std::filesystem::path& path);              // all but .jpg
void require_image_extension(const std::filesystem::path& path);  // UsageError unless one of ours

// The sRGB curve (IEC 61966-2-1), continued linearly below 0 and by its power above 1.
float srgb_from_linear(float linear);
float linear_from_srgb(float srgb);

}  // namespace burnish
