#include <fmt/format.h>

#include <algorithm>

#include "image/guard/container_checks.hpp"

namespace burnish {
namespace {

constexpr std::uint64_t kWebpHeaderBytes = 12;  // "RIFF", length, "WEBP"
constexpr std::uint64_t kWebpChunkBytes = 8;    // name, length

std::uint32_t u24(const ByteCursor& file, std::uint64_t at) {
    return file.u16(at, kLittleEndian) | file.u8(at + 2) << 16;
}

void check_canvas(const ByteCursor& file, std::uint32_t width, std::uint32_t height) {
    check_image_size(width, height, file.name());
    // Decoders give four bytes a pixel.
    check_decoded_bytes(std::uint64_t{width} * height * 4, file.size(), file.name());
}

void check_lossy(const ByteCursor& file, std::uint64_t data) {
    // A tag of three bytes, a start code, then 14 bits a side.
    if (file.text(data + 3, 3) != "\x9d\x01\x2a") file.fail("a broken header");
    check_canvas(file, file.u16(data + 6, kLittleEndian) & 0x3FFFU,
                 file.u16(data + 8, kLittleEndian) & 0x3FFFU);
}

void check_lossless(const ByteCursor& file, std::uint64_t data) {
    if (file.u8(data) != 0x2F) file.fail("a broken header");
    const std::uint32_t bits = file.u32(data + 1, kLittleEndian);
    check_canvas(file, (bits & 0x3FFFU) + 1, (bits >> 14 & 0x3FFFU) + 1);
}

}  // namespace

void check_webp(const ByteCursor& file) {
    constexpr unsigned kAnimation = 0x02;
    const std::uint64_t end = std::uint64_t{file.u32(4, kLittleEndian)} + kWebpChunkBytes;
    file.require(0, end);
    std::uint64_t at = kWebpHeaderBytes;
    while (at + kWebpChunkBytes <= end) {
        const std::string_view name = file.text(at, 4);
        const std::uint64_t length = file.u32(at + 4, kLittleEndian), data = at + kWebpChunkBytes;
        file.require(data, length);
        if (name == "VP8X") {
            if ((file.u8(data) & kAnimation) != 0) file.fail("an animation (save one frame of it)");
            check_canvas(file, u24(file, data + 4) + 1, u24(file, data + 7) + 1);
        } else if (name == "VP8 ") {
            return check_lossy(file, data);
        } else if (name == "VP8L") {
            return check_lossless(file, data);
        } else if (at == kWebpHeaderBytes) {
            file.fail(fmt::format("a first chunk {}", shown(name)));
        }
        at = data + length + length % 2;  // chunks begin at even offsets
    }
    file.fail("no picture in it");
}

std::vector<std::byte> webp_without_alpha(std::span<const std::byte> bytes) {
    const std::string name;  // nothing is thrown: the chunks have been walked
    const ByteCursor file(bytes, name, ImageFormat::webp);
    std::uint64_t at = kWebpHeaderBytes;
    const auto length = [&] { return std::uint64_t{file.u32(at + 4, kLittleEndian)}; };
    while (file.text(at, 4) != "VP8 " && file.text(at, 4) != "VP8L")
        at += kWebpChunkBytes + length() + length() % 2;
    const std::uint64_t end = std::min(at + kWebpChunkBytes + length() + length() % 2, file.size());
    const auto frame =
        bytes.subspan(static_cast<std::size_t>(at), static_cast<std::size_t>(end - at));
    std::vector<std::byte> copy(kWebpHeaderBytes + frame.size());
    std::copy_n(bytes.begin(), kWebpHeaderBytes, copy.begin());
    std::copy(frame.begin(), frame.end(), copy.begin() + kWebpHeaderBytes);
    const std::uint64_t riff = 4 + frame.size();
    for (std::size_t i = 0; i < 4; ++i) copy[4 + i] = static_cast<std::byte>(riff >> 8 * i);
    // The lossless header: a mark, 14 bits a side, then whether alpha is used.
    constexpr std::size_t kAlphaByte = kWebpHeaderBytes + kWebpChunkBytes + 4;
    constexpr std::byte kAlphaBit{0x10};
    if (file.text(at, 4) == "VP8L") copy.at(kAlphaByte) &= ~kAlphaBit;
    return copy;
}

}  // namespace burnish
