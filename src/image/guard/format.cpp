#include "image/guard/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "burnish/error.hpp"

namespace burnish {
namespace {

using namespace std::string_view_literals;

struct Signature {
    std::string_view start;
    ImageFormat format;
};

constexpr std::array kSignatures = {
    Signature{"\x89PNG\r\n\x1a\n"sv, ImageFormat::png},
    Signature{"\xff\xd8\xff"sv, ImageFormat::jpeg},
    Signature{"II*\0"sv, ImageFormat::tiff},
    Signature{"MM\0*"sv, ImageFormat::tiff},
    Signature{"\x76\x2f\x31\x01"sv, ImageFormat::exr},
    Signature{"#?RADIANCE"sv, ImageFormat::hdr},
    Signature{"#?RGBE"sv, ImageFormat::hdr},
};

// Formats people are likely to try, so that the error can say what they have.
struct Stranger {
    std::string_view start;
    std::string_view found;
};

constexpr std::array kStrangers = {
    Stranger{"II+\0"sv, "a BigTIFF file"},
    Stranger{"MM\0+"sv, "a BigTIFF file"},
    Stranger{"GIF8"sv, "a GIF file"},
    Stranger{"BM"sv, "a BMP file"},
    Stranger{"RIFF"sv, "a WebP (or other RIFF) file"},
    Stranger{"DDS "sv, "a DDS file"},
    Stranger{"\xabKTX"sv, "a KTX file"},
    Stranger{"8BPS"sv, "a Photoshop file"},
    Stranger{"%PDF"sv, "a PDF file"},
    Stranger{"\0\0\0\x0cjP  "sv, "a JPEG 2000 file"},
    Stranger{"{"sv, "a text file (JSON?)"},
    Stranger{"glTF"sv, "a glTF binary"},
};

// Decoded bytes that a byte of a file can stand for, beyond a free allowance. Deflate reaches 1032;
// wavelet codings of one constant colour reach tens of thousands; a bomb wants millions.
constexpr std::uint64_t kMaxExpansion = std::uint64_t{1} << 17;
constexpr std::uint64_t kFreeBytes = std::uint64_t{64} << 20;

std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

std::optional<ImageFormat> image_format_of(std::span<const std::byte> head) {
    const std::string_view text = as_text(head);
    for (const Signature& signature : kSignatures) {
        if (text.starts_with(signature.start)) return signature.format;
    }
    return std::nullopt;
}

std::string_view format_name(ImageFormat format) {
    switch (format) {
        case ImageFormat::png:
            return "PNG";
        case ImageFormat::jpeg:
            return "JPEG";
        case ImageFormat::tiff:
            return "TIFF";
        case ImageFormat::exr:
            return "OpenEXR";
        case ImageFormat::hdr:
            return "Radiance HDR";
    }
    return "";
}

const char* oiio_format_name(ImageFormat format) {
    switch (format) {
        case ImageFormat::png:
            return "png";
        case ImageFormat::jpeg:
            return "jpeg";
        case ImageFormat::tiff:
            return "tiff";
        case ImageFormat::exr:
            return "openexr";
        case ImageFormat::hdr:
            return "hdr";
    }
    return "";
}

ImageFormat require_image_format(std::span<const std::byte> head, const std::string& name) {
    if (const auto format = image_format_of(head)) return *format;
    const std::string_view text = as_text(head);
    std::string found = text.empty() ? "an empty file" : "a file of another kind";
    for (const Stranger& stranger : kStrangers) {
        if (text.starts_with(stranger.start)) found = stranger.found;
    }
    throw Error(name, "", "a PNG, JPEG, TIFF, OpenEXR or Radiance HDR image", found);
}

void check_image_size(std::int64_t width, std::int64_t height, const std::string& name) {
    const auto fits = [](std::int64_t side) { return side >= 1 && side <= kMaxImageSide; };
    if (fits(width) && fits(height)) return;
    throw Error(name, "", fmt::format("an image of 1 to {} pixels a side", kMaxImageSide),
                fmt::format("{} x {}", width, height));
}

void check_decoded_bytes(std::uint64_t decoded, std::uint64_t file_bytes, const std::string& name) {
    if (decoded > kMaxImageBytes) {
        throw Error(name, "", fmt::format("at most {} bytes of pixels", kMaxImageBytes),
                    fmt::format("{}", decoded));
    }
    if (decoded > kFreeBytes && (decoded - kFreeBytes) / kMaxExpansion > file_bytes) {
        throw Error(name, "", "a file as large as its pixels need",
                    fmt::format("{} bytes for {} bytes of pixels", file_bytes, decoded));
    }
}

}  // namespace burnish
