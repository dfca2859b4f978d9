#include "image/guard/png_chunks.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace burnish {
namespace {

constexpr std::uint64_t kSignatureBytes = 8;
constexpr std::uint64_t kChunkOverhead = 12;  // length, type, checksum
constexpr std::uint64_t kHeaderBytes = 13;

// Deflate cannot do better than 1032 to 1; the rest is room for its own headers.
constexpr std::uint64_t kMaxDeflateRatio = 1040;

constexpr std::array<std::string_view, 5> kCriticalChunks = {"IHDR", "PLTE", "IDAT", "IEND",
                                                             "tRNS"};
constexpr std::array<std::string_view, 4> kMinorChunks = {"gAMA", "sRGB", "tEXt", "iTXt"};

struct Chunk {
    std::string_view type;
    std::uint64_t data = 0;  // offset
    std::uint64_t length = 0;
};

Chunk chunk_at(const ByteCursor& file, std::uint64_t at) {
    const std::uint64_t length = file.u32(at, true);
    file.require(at, length + kChunkOverhead);
    return {file.text(at + 4, 4), at + 8, length};
}

bool checksum_holds(const ByteCursor& file, const Chunk& chunk) {
    // The type is covered too.
    const std::string_view covered = file.text(chunk.data - 4, chunk.length + 4);
    const auto* bytes = reinterpret_cast<const Bytef*>(covered.data());
    return crc32_z(0, bytes, covered.size()) == file.u32(chunk.data + chunk.length, true);
}

// Chunks without which there is no picture. Others may be damaged: files with a broken color
// profile are not rare.
bool is_critical(const Chunk& chunk) {
    return std::find(kCriticalChunks.begin(), kCriticalChunks.end(), chunk.type) !=
           kCriticalChunks.end();
}

bool is_used(const ByteCursor& file, const Chunk& chunk) {
    if (is_critical(chunk)) return true;  // and checked
    return std::find(kMinorChunks.begin(), kMinorChunks.end(), chunk.type) != kMinorChunks.end() &&
           checksum_holds(file, chunk);
}

void check_header(const ByteCursor& file, std::uint64_t data_bytes) {
    const std::uint64_t header = kSignatureBytes + 8;
    const std::uint64_t width = file.u32(header, true), height = file.u32(header + 4, true);
    check_image_size(static_cast<std::int64_t>(width), static_cast<std::int64_t>(height),
                     file.name());
    // Samples a pixel by color type; 0: there is no such type.
    constexpr std::array<std::uint64_t, 7> kSamples = {1, 0, 3, 1, 2, 0, 4};
    const std::uint64_t depth = file.u8(header + 8);
    const unsigned type = file.u8(header + 9);
    if (type >= kSamples.size() || kSamples[type] == 0) file.fail("a broken header");
    const std::uint64_t raw_bytes = height * (width * kSamples[type] * depth / 8);
    if (raw_bytes / kMaxDeflateRatio > data_bytes) {
        file.fail(fmt::format("{} bytes of data for {} x {} pixels", data_bytes, width, height));
    }
}

}  // namespace

void check_png(const ByteCursor& file) {
    std::uint64_t data_bytes = 0;
    for (std::uint64_t at = kSignatureBytes;;) {
        const Chunk chunk = chunk_at(file, at);
        const bool first = at == kSignatureBytes;
        if (first != (chunk.type == "IHDR") || (first && chunk.length != kHeaderBytes)) {
            file.fail("a broken header");
        }
        // A capital says that the picture cannot be understood without it.
        const bool required = chunk.type.front() >= 'A' && chunk.type.front() <= 'Z';
        if (required && !is_critical(chunk)) {
            file.fail(fmt::format("an unknown chunk {}", shown(chunk.type)));
        }
        if (is_critical(chunk) && !checksum_holds(file, chunk)) {
            file.fail(fmt::format("damaged data (checksum of {})", chunk.type));
        }
        if (chunk.type == "IDAT") data_bytes += chunk.length;
        if (chunk.type == "IEND") break;
        at += chunk.length + kChunkOverhead;
    }
    if (data_bytes == 0) file.fail("no picture in it");
    check_header(file, data_bytes);
}

std::vector<std::byte> without_unused_chunks(std::span<const std::byte> bytes) {
    const std::string name;  // nothing is thrown here
    const ByteCursor file(bytes, name, ImageFormat::png);
    std::vector<std::span<const std::byte>> kept = {bytes.first(kSignatureBytes)};
    std::size_t kept_bytes = kSignatureBytes;
    bool dropped = false;
    for (std::uint64_t at = kSignatureBytes;;) {
        const Chunk chunk = chunk_at(file, at);
        const std::uint64_t length = chunk.length + kChunkOverhead;
        if (is_used(file, chunk)) {
            kept.push_back(
                bytes.subspan(static_cast<std::size_t>(at), static_cast<std::size_t>(length)));
            kept_bytes += kept.back().size();
        } else {
            dropped = true;
        }
        if (chunk.type == "IEND") break;
        at += length;
    }
    std::vector<std::byte> copy;
    if (!dropped) return copy;
    copy.reserve(kept_bytes);
    for (const auto& part : kept) copy.insert(copy.end(), part.begin(), part.end());
    return copy;
}

}  // namespace burnish
