// check_image_structure, and the walks over JPEG, OpenEXR and Radiance HDR. Needed until OpenImageIO
// refuses truncated JPEG and TIFF files, and reports what libjpeg, libtiff and OpenEXR throw or
// abort at, instead of passing it on: 2.4 does neither.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "burnish/error.hpp"
#include "image/guard/byte_cursor.hpp"
#include "image/guard/container_checks.hpp"
#include "image/guard/format.hpp"
#include "image/guard/png_chunks.hpp"

namespace burnish {
namespace {

// A Huffman-coded JPEG spends at least one bit on the DC term of 64 pixels: 512 a byte.
constexpr std::uint64_t kMaxJpegPixelsPerByte = 1024;

// Encoders write up to about ten progressive scans; each costs a pass over the whole picture.
constexpr int kMaxJpegScans = 64;

constexpr std::uint64_t kMaxHdrHeaderBytes = std::uint64_t{1} << 20;
constexpr int kMaxExrParts = 64;
constexpr std::uint64_t kLongestExrName = 255;

// ---- JPEG: markers from SOI to EOI --------------------------------------------------------------

bool is_frame_header(unsigned marker) {
    return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

// The offset behind the next marker at or after `at`, and its code. Stuffed zeros, restart markers
// and stray bytes are passed over, which makes this the end of a scan's data too.
std::pair<std::uint64_t, unsigned> next_jpeg_marker(const ByteCursor& file, std::uint64_t at) {
    for (;;) {
        file.require(at, 2);
        const void* found =
            std::memchr(file.data() + at, 0xFF, static_cast<std::size_t>(file.size() - at));
        if (found == nullptr) file.truncated();
        at = static_cast<std::uint64_t>(static_cast<const std::byte*>(found) - file.data()) + 1;
        const unsigned code = file.u8(at);
        const bool restart = code >= 0xD0 && code <= 0xD7;
        if (code != 0x00 && code != 0xFF && code != 0x01 && !restart) return {at + 1, code};
    }
}

void check_jpeg(const ByteCursor& file) {
    constexpr unsigned kEnd = 0xD9, kStart = 0xD8, kScan = 0xDA;
    int scans = 0;
    bool sized = false;
    for (std::uint64_t at = 2;;) {
        const auto [segment, marker] = next_jpeg_marker(file, at);
        if (marker == kEnd) break;
        if (marker == kStart) file.fail("a second picture inside the first");
        const unsigned length = file.u16(segment, true);
        if (length < 2) file.fail("a broken segment");
        file.require(segment, length);
        if (is_frame_header(marker)) {
            const unsigned height = file.u16(segment + 3, true);
            const unsigned width = file.u16(segment + 5, true);
            check_image_size(width, height, file.name());
            if (std::uint64_t{width} * height / kMaxJpegPixelsPerByte > file.size()) {
                file.fail(fmt::format("{} bytes for {} x {} pixels", file.size(), width, height));
            }
            sized = true;
        }
        if (marker == kScan && ++scans > kMaxJpegScans) file.fail("too many scans");
        at = segment + length;
    }
    if (!sized || scans == 0) file.fail("no picture in it");
}

// ---- OpenEXR: the headers of all parts ----------------------------------------------------------

// What one header must say; unset when the attribute is missing.
struct ExrHeader {
    bool has_window = false;
    bool empty = true;
    bool subsampled = false;
};

void check_exr_attribute(const ByteCursor& file, std::string_view name, std::uint64_t value,
                         std::uint64_t length, ExrHeader& header) {
    const auto i32 = [&](std::uint64_t offset) {
        return std::int64_t{static_cast<std::int32_t>(file.u32(value + offset, false))};
    };
    if (name == "dataWindow" || name == "displayWindow") {
        if (length != 16) file.fail("a broken header");
        check_image_size(i32(8) - i32(0) + 1, i32(12) - i32(4) + 1, file.name());
        // Positions far out overflow the offsets that decoders compute from them.
        constexpr std::int64_t kFarthest = 1 << 24;
        for (const std::uint64_t corner : {0U, 4U, 8U, 12U}) {
            if (std::abs(i32(corner)) > kFarthest) file.fail("a window out of bounds");
        }
        header.has_window = header.has_window || name == "dataWindow";
    } else if (name == "type") {
        // Of other parts OpenEXR keeps what it does not know, and checks nothing.
        const std::string_view part(reinterpret_cast<const char*>(file.data() + value), length);
        if (part != "scanlineimage" && part != "tiledimage")
            file.fail(fmt::format("a part of type {}", shown(part)));
    } else if (name == "tiles" && length >= 8) {
        check_image_size(file.u32(value, false), file.u32(value + 4, false), file.name());
    } else if (name == "chunkCount" && length == 4) {
        // Each chunk has an 8-byte entry in the offset table.
        const std::uint64_t chunks = file.u32(value, false);
        if (chunks > file.size() / 8) file.truncated();
    }
}

// A list of names with 16 bytes each, ended by an empty name: pixel type (0 to 2: whole numbers,
// half, float), a flag and padding, pixels a sample in x and in y. OpenImageIO 2.4 aborts at
// another pixel type.
std::uint64_t length_of_exr_channels(const ByteCursor& file, std::uint64_t value,
                                     ExrHeader& header) {
    constexpr std::uint32_t kMaxSampling = 64;
    constexpr std::uint64_t kChannelBytes = 16;
    for (std::uint64_t at = value;;) {
        const std::string_view name = file.text_until(at, '\0', kLongestExrName);
        at += name.size() + 1;
        if (name.empty()) return at - value;
        file.require(at, kChannelBytes);
        if (const std::uint32_t pixel_type = file.u32(at, false); pixel_type > 2)
            file.fail(fmt::format("a channel of pixel type {}", pixel_type));
        for (const std::uint64_t axis : {8U, 12U}) {
            const std::uint32_t sampling = file.u32(at + axis, false);
            if (sampling < 1 || sampling > kMaxSampling)
                file.fail(fmt::format("a channel with a sample every {} pixels", sampling));
            header.subsampled = header.subsampled || sampling > 1;
        }
        at += kChannelBytes;
    }
}

// Texts, each behind its length, that must fill `length` bytes.
std::uint64_t length_of_exr_texts(const ByteCursor& file, std::uint64_t value,
                                  std::uint64_t length) {
    std::uint64_t at = 0;
    while (at < length) at += 4 + std::uint64_t{file.u32(value + at, false)};
    return at;
}

// Decoders read as many bytes as the type says, whatever length stands before them: were it another
// one, they would see another file than this walk does, and take any four bytes for a length.
void check_exr_type(const ByteCursor& file, std::string_view type, std::uint64_t value,
                    std::uint64_t length, ExrHeader& header) {
    struct Fixed {
        std::string_view type;
        std::uint64_t length;
    };
    constexpr Fixed kFixed[] = {
        {"box2f", 16},      {"box2i", 16},   {"chromaticities", 32},
        {"compression", 1}, {"double", 8},   {"envmap", 1},
        {"float", 4},       {"int", 4},      {"keycode", 28},
        {"lineOrder", 1},   {"m33d", 72},    {"m33f", 36},
        {"m44d", 128},      {"m44f", 64},    {"rational", 8},
        {"tiledesc", 9},    {"timecode", 8}, {"v2d", 16},
        {"v2f", 8},         {"v2i", 8},      {"v3d", 24},
        {"v3f", 12},        {"v3i", 12},     {"deepImageState", 1},
    };
    std::uint64_t wanted = length;
    for (const Fixed& fixed : kFixed)
        if (type == fixed.type) wanted = fixed.length;
    if (type == "chlist") wanted = length_of_exr_channels(file, value, header);
    if (type == "stringvector") wanted = length_of_exr_texts(file, value, length);
    if (type == "preview") {  // pixels of four bytes behind their width and height
        const std::uint64_t pixels =
            std::uint64_t{file.u32(value, false)} * file.u32(value + 4, false);
        wanted = pixels <= length ? 8 + 4 * pixels : 0;
    }
    if (wanted != length) {
        file.fail(fmt::format("{} bytes for an attribute of type {}", length, shown(type)));
    }
}

// Walks one header and returns the offset behind its end.
std::uint64_t check_exr_header(const ByteCursor& file, std::uint64_t at, ExrHeader& header) {
    for (;;) {
        const std::string_view name = file.text_until(at, '\0', kLongestExrName);
        at += name.size() + 1;
        if (name.empty()) return at;
        header.empty = false;
        const std::string_view type = file.text_until(at, '\0', kLongestExrName);
        at += type.size() + 1;
        const std::uint64_t length = file.u32(at, false);
        at += 4;
        file.require(at, length);
        check_exr_type(file, type, at, length, header);
        check_exr_attribute(file, name, at, length, header);
        at += length;
    }
}

ImageStructure check_exr(const ByteCursor& file) {
    constexpr std::uint32_t kVersionMask = 0xFF, kDeep = 0x800, kMultiPart = 0x1000;
    const std::uint32_t version = file.u32(4, false);
    if ((version & kVersionMask) != 2) file.fail("another version of the format");
    if ((version & kDeep) != 0) file.fail("a deep image");
    ImageStructure structure;
    std::uint64_t at = 8;
    for (int part = 0;; ++part) {
        if (part == kMaxExrParts) file.fail("too many parts");
        ExrHeader header;
        at = check_exr_header(file, at, header);
        if (header.empty && part > 0) break;
        if (!header.has_window) file.fail("a header without a data window");
        structure.subsampled = structure.subsampled || header.subsampled;
        if ((version & kMultiPart) == 0) break;
    }
    return structure;
}

// ---- Radiance HDR: the resolution line ----------------------------------------------------------

// A decimal number after `word`; what is behind it is left in `line`.
std::int64_t take_side(const ByteCursor& file, std::string_view& line, std::string_view word) {
    const auto wrong = [&file, whole = line] {
        throw Error(file.name(), "resolution line", "\"-Y height +X width\"", shown(whole));
    };
    if (!line.starts_with(word)) wrong();
    line.remove_prefix(word.size());
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    std::int64_t value = 0;
    std::size_t digits = 0;
    for (; digits < line.size() && line[digits] >= '0' && line[digits] <= '9'; ++digits) {
        value = std::min<std::int64_t>(value * 10 + (line[digits] - '0'), 1LL << 40);
    }
    if (digits == 0) wrong();
    line.remove_prefix(digits);
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    return value;
}

void check_hdr(const ByteCursor& file) {
    std::uint64_t at = 0;
    std::string_view line;
    do {
        if (at > kMaxHdrHeaderBytes) file.fail("a header without an end");
        line = file.text_until(at, '\n', kMaxHdrHeaderBytes);
        at += line.size() + 1;
    } while (!line.empty());
    std::string_view resolution = file.text_until(at, '\n', kMaxHdrHeaderBytes);
    const std::int64_t height = take_side(file, resolution, "-Y");
    const std::int64_t width = take_side(file, resolution, "+X");
    check_image_size(width, height, file.name());
}

}  // namespace

ImageStructure check_image_structure(ImageFormat format, std::span<const std::byte> bytes,
                                     const std::string& name) {
    const ByteCursor file(bytes, name, format);
    switch (format) {
        case ImageFormat::png:
            check_png(file);
            break;
        case ImageFormat::jpeg:
            check_jpeg(file);
            break;
        case ImageFormat::tiff:
            check_tiff(file);
            break;
        case ImageFormat::exr:
            return check_exr(file);
        case ImageFormat::hdr:
            check_hdr(file);
            break;
        case ImageFormat::webp:
            check_webp(file);
            break;
        case ImageFormat::tga:
            return check_tga(file);
        case ImageFormat::bmp:
            check_bmp(file);
            break;
        case ImageFormat::heif:
        case ImageFormat::avif:
            check_heif(file);
            break;
        case ImageFormat::raw:
            check_raw(file);
            break;
    }
    return {};
}

}  // namespace burnish
