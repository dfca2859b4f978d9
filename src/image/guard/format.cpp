#include "image/guard/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "burnish/error.hpp"
#include "image/guard/container_checks.hpp"

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
    Signature{"BM"sv, ImageFormat::bmp},
    Signature{"FUJIFILMCCD-RAW"sv, ImageFormat::raw},
    Signature{"IIRO"sv, ImageFormat::raw},  // Olympus, as the next two
    Signature{"IIRS"sv, ImageFormat::raw},
    Signature{"MMOR"sv, ImageFormat::raw},
    Signature{"IIU\0"sv, ImageFormat::raw},                 // Panasonic, Leica
    Signature{"II\x1a\0\0\0HEAPCCDR"sv, ImageFormat::raw},  // Canon
    Signature{"FOVb"sv, ImageFormat::raw},                  // Sigma
    Signature{"\0MRM"sv, ImageFormat::raw},                 // Minolta
};

// Containers that name their kind at an offset.
constexpr std::array kBrands = {
    Signature{"WEBP"sv, ImageFormat::webp}, Signature{"heic"sv, ImageFormat::heif},
    Signature{"heix"sv, ImageFormat::heif}, Signature{"heim"sv, ImageFormat::heif},
    Signature{"heis"sv, ImageFormat::heif}, Signature{"hevc"sv, ImageFormat::heif},
    Signature{"hevx"sv, ImageFormat::heif}, Signature{"mif1"sv, ImageFormat::heif},
    Signature{"msf1"sv, ImageFormat::heif}, Signature{"avif"sv, ImageFormat::avif},
    Signature{"avis"sv, ImageFormat::avif}, Signature{"crx "sv, ImageFormat::raw},  // Canon
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
    Stranger{"RIFF"sv, "a RIFF file that is no WebP (sound or video?)"},
    Stranger{"DDS "sv, "a DDS file (`oiiotool IN.dds -o OUT.png` converts it)"},
    Stranger{"\xabKTX"sv, "a KTX file (`ktx extract IN.ktx2 OUT.png` converts it)"},
    Stranger{"8BPS"sv, "a Photoshop file"},
    Stranger{"%PDF"sv, "a PDF file"},
    Stranger{"\0\0\0\x0cjP  "sv, "a JPEG 2000 file"},
    Stranger{"{"sv, "a text file (JSON?)"},
    Stranger{"glTF"sv, "a glTF binary"},
};

constexpr std::string_view kRawEndings[] = {
    ".3fr", ".arw", ".cr2", ".cr3", ".crw", ".dcr", ".dng", ".erf", ".fff",
    ".iiq", ".kdc", ".mef", ".mos", ".mrw", ".nef", ".nrw", ".orf", ".pef",
    ".raf", ".rw2", ".rwl", ".sr2", ".srf", ".srw", ".x3f",
};

// Decoded bytes that a byte of a file can stand for, beyond a free allowance. Deflate reaches 1032;
// wavelet codings of one constant color reach tens of thousands; a bomb wants millions.
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
    if (text.size() >= 12 && (text.starts_with("RIFF") || text.substr(4, 4) == "ftyp")) {
        for (const Signature& brand : kBrands)
            if (text.substr(8).starts_with(brand.start)) return brand.format;
    }
    if (is_tga_head(head)) return ImageFormat::tga;  // last: it has no signature
    return std::nullopt;
}

bool is_foreign_image(std::span<const std::byte> head) {
    constexpr std::string_view kStarts[] = {"\xabKTX", "DDS ", "GIF8", "8BPS", "\0\0\0\x0cjP  "sv};
    return std::any_of(std::begin(kStarts), std::end(kStarts),
                       [&](std::string_view start) { return as_text(head).starts_with(start); });
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
        case ImageFormat::webp:
            return "WebP";
        case ImageFormat::tga:
            return "TGA";
        case ImageFormat::bmp:
            return "BMP";
        case ImageFormat::heif:
            return "HEIF";
        case ImageFormat::avif:
            return "AVIF";
        case ImageFormat::raw:
            return "raw camera";
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
        case ImageFormat::webp:
            return "webp";
        case ImageFormat::tga:
            return "targa";
        case ImageFormat::bmp:
            return "bmp";
        case ImageFormat::heif:
        case ImageFormat::avif:
            return "heif";
        case ImageFormat::raw:
            return "raw";
    }
    return "";
}

std::span<const std::string_view> raw_camera_endings() {
    return kRawEndings;
}

bool has_raw_ending(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos) return false;
    std::string ending(name.substr(dot));
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return std::find(std::begin(kRawEndings), std::end(kRawEndings), ending) !=
           std::end(kRawEndings);
}

ImageFormat require_image_format(std::span<const std::byte> head, const std::string& name) {
    if (const auto format = image_format_of(head)) return *format;
    const std::string_view text = as_text(head);
    std::string found = text.empty() ? "an empty file" : "a file of another kind";
    for (const Stranger& stranger : kStrangers) {
        if (text.starts_with(stranger.start)) found = stranger.found;
    }
    if (text.size() >= 8 && text.substr(4, 4) == "ftyp") found = "an MP4 (or similar) file";
    if (has_raw_ending(name))
        found += "; a raw camera file of another kind must be developed to a linear 16-bit TIFF";
    throw Error(name, "",
                "a PNG, JPEG, WebP, TIFF, OpenEXR, Radiance HDR, TGA, BMP, HEIF, AVIF or raw "
                "camera image",
                found);
}

ImageFormat require_format_of_file(std::span<const std::byte> bytes, const std::string& name) {
    const ImageFormat format = require_image_format(bytes, name);
    if (format == ImageFormat::tiff && is_raw_tiff(ByteCursor(bytes, name, format)))
        return ImageFormat::raw;
    return format;
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
