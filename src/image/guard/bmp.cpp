#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "image/guard/container_checks.hpp"

namespace burnish {
namespace {

constexpr std::uint64_t kFileHeaderBytes = 14;
constexpr std::uint32_t kOldHeader = 12, kUsualHeader = 40, kMasksInHeader = 108;
constexpr std::uint32_t kBmpPlain = 0, kBmpRuns8 = 1, kBmpRuns4 = 2, kBmpMasks = 3;

struct BmpHeader {
    std::uint32_t bytes = 0;             // of the second header
    std::int64_t width = 0, height = 0;  // height is negative when the first row is the top one
    unsigned bits = 0;                   // a pixel
    std::uint32_t compression = kBmpPlain;
    std::uint64_t colors = 0;  // of the palette
    std::uint64_t pixels = 0;  // offset

    std::uint64_t rows() const { return static_cast<std::uint64_t>(height < 0 ? -height : height); }
    std::uint64_t columns() const { return static_cast<std::uint64_t>(width); }
    std::uint64_t row_bytes() const { return (columns() * bits + 31) / 32 * 4; }
    bool has_runs() const { return compression == kBmpRuns8 || compression == kBmpRuns4; }
};

BmpHeader read_bmp_header(const ByteCursor& file) {
    constexpr std::array<std::uint32_t, 4> kKnown = {kOldHeader, kUsualHeader, kMasksInHeader, 124};
    BmpHeader header;
    const auto i32 = [&](std::uint64_t at) {
        return std::int64_t{static_cast<std::int32_t>(file.u32(at, kLittleEndian))};
    };
    header.pixels = file.u32(10, kLittleEndian);
    header.bytes = file.u32(14, kLittleEndian);
    if (std::find(kKnown.begin(), kKnown.end(), header.bytes) == kKnown.end())
        file.fail(fmt::format("a header of {} bytes", header.bytes));
    if (header.bytes == kOldHeader) {
        header.width = file.u16(18, kLittleEndian);
        header.height = file.u16(20, kLittleEndian);
        header.bits = file.u16(24, kLittleEndian);
    } else {
        header.width = i32(18);
        header.height = i32(22);
        header.bits = file.u16(28, kLittleEndian);
        header.compression = file.u32(30, kLittleEndian);
        header.colors = file.u32(46, kLittleEndian);
    }
    if (header.bits <= 8 && header.colors == 0) header.colors = std::uint64_t{1} << header.bits;
    return header;
}

// OpenImageIO 2.4 reads masks only from the longer headers, and those of 32 bits not at all.
void check_bmp_masks(const ByteCursor& file, const BmpHeader& header) {
    const auto mask = [&](std::uint64_t i) { return file.u32(54 + 4 * i, kLittleEndian); };
    const bool usual = header.bits == 32
                           ? mask(0) == 0xFF0000 && mask(1) == 0xFF00 && mask(2) == 0xFF
                           : mask(0) == 0x7C00 && mask(1) == 0x3E0 && mask(2) == 0x1F;
    if (!usual && (header.bits == 32 || header.bytes < kMasksInHeader))
        file.fail(
            fmt::format("{} bits a pixel in another order (save it with 24 bits)", header.bits));
}

void check_bmp_kind(const ByteCursor& file, const BmpHeader& header) {
    constexpr std::array<unsigned, 6> kBits = {1, 4, 8, 16, 24, 32};
    const bool known = std::find(kBits.begin(), kBits.end(), header.bits) != kBits.end();
    const bool fits = header.compression == kBmpPlain ||
                      (header.compression == kBmpRuns8 && header.bits == 8 && header.height > 0) ||
                      (header.compression == kBmpRuns4 && header.bits == 4 && header.height > 0) ||
                      (header.compression == kBmpMasks && (header.bits == 16 || header.bits == 32));
    if (!known || !fits)
        file.fail(
            fmt::format("{} bits a pixel of compression {}", header.bits, header.compression));
    if (header.compression == kBmpMasks) check_bmp_masks(file, header);
    const std::uint64_t palette = header.bits <= 8 ? header.colors : 0;
    if (palette > std::uint64_t{1} << std::min(header.bits, 8U))
        file.fail(fmt::format("a palette of {} colors", palette));
    const std::uint64_t entry = header.bytes == kOldHeader ? 3 : 4;
    const std::uint64_t behind = kFileHeaderBytes + header.bytes + palette * entry;
    file.require(0, behind);
    if (header.pixels < behind) file.fail("pixels inside the header");
}

[[noreturn]] void fail_outside_palette(const ByteCursor& file) {
    file.fail("a color outside the palette");
}

// Indices of uncompressed rows.
void check_bmp_indices(const ByteCursor& file, const BmpHeader& header) {
    if (header.colors >= std::uint64_t{1} << header.bits) return;
    const unsigned mask = (1U << header.bits) - 1;
    for (std::uint64_t y = 0; y < header.rows(); ++y) {
        const std::uint64_t row = header.pixels + y * header.row_bytes();
        for (std::uint64_t x = 0; x < header.columns(); ++x) {
            const std::uint64_t bit = x * header.bits;
            const unsigned shift = 8 - header.bits - static_cast<unsigned>(bit % 8);
            if ((file.u8(row + bit / 8) >> shift & mask) >= header.colors)
                fail_outside_palette(file);
        }
    }
}

// OpenImageIO 2.4 writes three channels for every pixel of a run, into rows of one where it finds the
// palette gray.
void check_bmp_run_colors(const ByteCursor& file, const BmpHeader& header) {
    for (std::uint64_t i = 0; i < header.colors; ++i) {
        const std::uint64_t at = kFileHeaderBytes + header.bytes + 4 * i;
        const unsigned blue = file.u8(at);
        if (file.u8(at + 1) != blue || file.u8(at + 2) != blue) return;
    }
    file.fail("runs over a gray palette (save it without compression)");
}

// Pairs of a count and a value; a count of 0 begins a line (0), the end (1), a step (2), or as many
// plain pixels as the value says, padded to an even number of bytes.
void check_bmp_runs(const ByteCursor& file, const BmpHeader& header) {
    const std::uint64_t per_byte = header.compression == kBmpRuns4 ? 2 : 1;
    const auto check_value = [&](unsigned value) {
        const bool high = per_byte == 2 && value >> 4 >= header.colors;
        const unsigned low = per_byte == 2 ? value & 0xFU : value;
        if (high || low >= header.colors) fail_outside_palette(file);
    };
    std::uint64_t x = 0, y = 0;
    for (std::uint64_t at = header.pixels;;) {
        const unsigned count = file.u8(at), value = file.u8(at + 1);
        at += 2;
        std::uint64_t pixels = count;
        if (count == 0 && value == 1) return;
        if (count == 0 && value == 0) {
            x = 0;
            ++y;
            continue;
        }
        if (count == 0 && value == 2) {
            x += file.u8(at);
            y += file.u8(at + 1);
            at += 2;
        } else if (count == 0) {
            pixels = value;
            const std::uint64_t bytes = (pixels + per_byte - 1) / per_byte;
            for (std::uint64_t i = 0; i < bytes; ++i) check_value(file.u8(at + i));
            at += (bytes + 1) / 2 * 2;
        } else {
            check_value(value);
        }
        x += pixels;
        if (x > header.columns() || y >= header.rows()) file.fail("a run beyond the picture");
    }
}

}  // namespace

void check_bmp(const ByteCursor& file) {
    const BmpHeader header = read_bmp_header(file);
    check_image_size(header.width, static_cast<std::int64_t>(header.rows()), file.name());
    check_bmp_kind(file, header);
    check_decoded_bytes(header.columns() * header.rows() * 4, file.size(), file.name());
    if (header.has_runs()) {
        check_bmp_run_colors(file, header);
        return check_bmp_runs(file, header);
    }
    file.require(header.pixels, header.row_bytes() * header.rows());
    if (header.bits <= 8) check_bmp_indices(file, header);
}

}  // namespace burnish
