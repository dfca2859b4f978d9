// The picture formats that we read, told by their content, and the checks of a file that come
// before a decoder sees it. The decoders of OpenImageIO 2.4 trust their input: some fill a
// truncated picture with grey, some allocate what a header of 40 bytes asks for. This folder walks
// each container first: complete to its end marker, sizes within bounds, no more pixels than the
// bytes can stand for. Each file of the folder says what OpenImageIO must do before the file can
// go: the tests of tests/image/image_hostile_test.cpp and `scripts/fuzz.sh image` then pass without
// it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace burnish {

// `raw` is what a camera's sensor counted: DNG and the formats of the makers.
enum class ImageFormat { png, jpeg, tiff, exr, hdr, webp, tga, bmp, heif, avif, raw };

// Bytes of the start of a file that are enough to tell its format, but for the TIFF files that are
// raw camera files (require_format_of_file).
inline constexpr std::size_t kImageHeadBytes = 18;

inline constexpr std::int64_t kMaxImageSide = 32768;
inline constexpr std::uint64_t kMaxImageBytes = std::uint64_t{4} << 30;  // decoded

std::optional<ImageFormat> image_format_of(std::span<const std::byte> head);
// Whether the file is a picture of a format that is not read: KTX, DDS, GIF, Photoshop, JPEG 2000.
bool is_foreign_image(std::span<const std::byte> head);
std::string_view format_name(ImageFormat format);  // "PNG", "OpenEXR" ...
const char* oiio_format_name(ImageFormat format);  // what OpenImageIO calls its plug-in

// Endings of the raw files of cameras, in small letters with their dot.
std::span<const std::string_view> raw_camera_endings();
// Whether a name ends as the raw files of a camera do (.dng, .nef, .cr3 ...), in any case.
bool has_raw_ending(std::string_view name);

// Throws Error "<name>: expected a PNG, JPEG, ... or raw camera image, found <what>".
ImageFormat require_image_format(std::span<const std::byte> head, const std::string& name);

// The same of a whole file. A TIFF that is a raw camera file by what it holds or by its name is
// `raw`.
ImageFormat require_format_of_file(std::span<const std::byte> bytes, const std::string& name);

// What the walk of a container found.
struct ImageStructure {
    bool subsampled = false;  // OpenEXR: a channel with fewer samples than the picture has pixels
    bool premultiplied = false;  // TGA: says that color was multiplied by alpha
};

// Throws Error when the file is truncated, its declared size is out of bounds, or it is of a kind
// that is not supported (BigTIFF, deep OpenEXR). What it accepts may still be refused on decoding.
ImageStructure check_image_structure(ImageFormat format, std::span<const std::byte> bytes,
                                     const std::string& name);

// Throws Error for more than kMaxImageBytes of pixels, and for more than `file_bytes` can stand
// for.
void check_decoded_bytes(std::uint64_t decoded, std::uint64_t file_bytes, const std::string& name);

// Throws Error unless 1 <= side <= kMaxImageSide.
void check_image_size(std::int64_t width, std::int64_t height, const std::string& name);

}  // namespace burnish
