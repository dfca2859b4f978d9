#include <fmt/format.h>

#include "image/guard/container_checks.hpp"

namespace burnish {
namespace {

using namespace std::string_view_literals;

constexpr std::uint64_t kTgaHeaderBytes = 18;
constexpr std::uint64_t kTgaEndBytes = 26;  // two offsets and the signature
constexpr std::string_view kTgaSignature = "TRUEVISION-XFILE.\0"sv;
constexpr unsigned kTgaRuns = 8;  // added to the type of a picture of runs
constexpr unsigned kTgaPalette = 1, kTgaColor = 2, kTgaGray = 3;

struct TgaHeader {
    unsigned name_bytes, has_palette, type, palette_length, palette_bits;
    unsigned width, height, bits, flags;

    unsigned kind() const { return type & ~kTgaRuns; }
    unsigned bytes_of(unsigned n) const { return (n + 7) / 8; }
    std::uint64_t pixels() const {
        return kTgaHeaderBytes + name_bytes +
               (has_palette != 0 ? std::uint64_t{palette_length} * bytes_of(palette_bits) : 0);
    }
};

TgaHeader read_tga_header(const ByteCursor& file) {
    const auto u16 = [&](std::uint64_t at) { return file.u16(at, kLittleEndian); };
    return {file.u8(0), file.u8(1), file.u8(2),  u16(5),     file.u8(7),
            u16(12),    u16(14),    file.u8(16), file.u8(17)};
}

bool has_bits(unsigned bits, std::initializer_list<unsigned> allowed) {
    for (const unsigned b : allowed)
        if (bits == b) return true;
    return false;
}

// Whether the numbers agree with one another, as those of another file hardly would.
bool is_consistent(const TgaHeader& header) {
    constexpr unsigned kMostAlphaBits = 8, kAlphaMask = 0x0F, kInterleaved = 0xC0;
    if ((header.type & ~(kTgaRuns | 3U)) != 0 || header.kind() == 0 || header.has_palette > 1)
        return false;
    if (header.width == 0 || header.height == 0) return false;
    if ((header.flags & kAlphaMask) > kMostAlphaBits || (header.flags & kInterleaved) != 0)
        return false;
    if (header.has_palette == 0 && (header.palette_length != 0 || header.palette_bits != 0))
        return false;
    if (header.has_palette == 1 &&
        (header.palette_length == 0 || !has_bits(header.palette_bits, {15, 16, 24, 32})))
        return false;
    switch (header.kind()) {
        case kTgaPalette:
            return header.has_palette == 1 && header.bits == 8;
        case kTgaColor:
            return has_bits(header.bits, {15, 16, 24, 32});
        case kTgaGray:
            return header.has_palette == 0 && has_bits(header.bits, {8, 16});
        default:
            return false;
    }
}

bool has_tga_end(std::string_view file) {
    return file.size() >= kTgaHeaderBytes + kTgaEndBytes && file.ends_with(kTgaSignature);
}

// Of each packet the first byte says how many pixels follow: one that is repeated, or all of them.
// Indices of a palette are held against its length.
void check_tga_pixels(const ByteCursor& file, const TgaHeader& header) {
    const std::uint64_t all = std::uint64_t{header.width} * header.height;
    const std::uint64_t bytes = header.bytes_of(header.bits);
    const unsigned first = file.u16(3, kLittleEndian);
    const auto check_indices = [&](std::uint64_t at, std::uint64_t count) {
        if (header.kind() != kTgaPalette) return file.require(at, count * bytes);
        for (std::uint64_t i = 0; i < count; ++i) {
            const unsigned index = file.u8(at + i);
            if (index < first || index - first >= header.palette_length)
                file.fail("a color outside the palette");
        }
    };
    std::uint64_t at = header.pixels();
    if ((header.type & kTgaRuns) == 0) return check_indices(at, all);
    for (std::uint64_t done = 0; done < all;) {
        const unsigned packet = file.u8(at);
        const std::uint64_t count = (packet & 0x7FU) + 1;
        const std::uint64_t stored = (packet & 0x80U) != 0 ? 1 : count;
        if (count > all - done) file.fail("a run beyond the picture");
        check_indices(at + 1, stored);
        at += 1 + stored * bytes;
        done += count;
    }
}

}  // namespace

bool is_tga_head(std::span<const std::byte> head) {
    if (head.size() < kTgaHeaderBytes) return false;
    const std::string name;  // nothing is thrown: the header is whole
    return is_consistent(read_tga_header(ByteCursor(head, name, ImageFormat::tga)));
}

ImageStructure check_tga(const ByteCursor& file) {
    // The area of attributes has 495 bytes; its last one says what alpha means.
    constexpr std::uint64_t kAreaBytes = 495;
    constexpr unsigned kPremultiplied = 4;
    const TgaHeader header = read_tga_header(file);
    check_image_size(header.width, header.height, file.name());
    check_decoded_bytes(std::uint64_t{header.width} * header.height * 4, file.size(), file.name());
    check_tga_pixels(file, header);
    ImageStructure structure;
    if (has_tga_end(file.text(0, file.size()))) {
        const std::uint64_t area = file.u32(file.size() - kTgaEndBytes, kLittleEndian);
        if (area != 0 && area + kAreaBytes <= file.size())
            structure.premultiplied = file.u8(area + kAreaBytes - 1) == kPremultiplied;
    }
    return structure;
}

std::span<const std::byte> without_tga_end(std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return has_tga_end(text) ? bytes.first(bytes.size() - kTgaEndBytes) : bytes;
}

}  // namespace burnish
