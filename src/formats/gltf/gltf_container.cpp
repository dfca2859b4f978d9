#include "formats/gltf/gltf_container.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <string>

#include "burnish/error.hpp"
#include "core/files.hpp"

namespace burnish {
namespace {

constexpr std::uint32_t kGlbMagic = 0x46546C67;     // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;  // "BIN\0"
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

// Little-endian, as glTF stores everything. The caller has checked the range.
std::uint32_t word_at(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i)
        word |= std::to_integer<std::uint32_t>(bytes[offset + i]) << (8 * i);
    return word;
}

std::string_view text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Reads the chunk at `offset` and advances `offset` past it.
std::span<const std::byte> take_chunk(std::span<const std::byte> bytes, std::size_t& offset,
                                      std::uint32_t& type, const GltfReport& report) {
    if (bytes.size() - offset < kChunkHeaderBytes)
        report.fail("chunk", "a header of 8 bytes", fmt::format("{} bytes", bytes.size() - offset));
    const std::size_t length = word_at(bytes, offset);
    type = word_at(bytes, offset + 4);
    offset += kChunkHeaderBytes;
    if (length > bytes.size() - offset) {
        report.fail("chunk", fmt::format("{} bytes", length),
                    fmt::format("{} bytes: the file is truncated", bytes.size() - offset));
    }
    const auto chunk = bytes.subspan(offset, length);
    // Chunks are padded to four bytes; an unpadded last chunk is accepted.
    offset = std::min(bytes.size(), offset + (length + 3) / 4 * 4);
    return chunk;
}

void split_glb(GltfContainer& container, const GltfReport& report) {
    std::span<const std::byte> bytes = container.bytes;
    if (bytes.size() < kHeaderBytes)
        report.fail("header", "12 bytes", fmt::format("{} bytes", bytes.size()));
    const std::uint32_t version = word_at(bytes, 4);
    if (version != 2) report.fail("header", "version 2", fmt::format("version {}", version));
    const std::size_t length = word_at(bytes, 8);
    if (length > bytes.size()) {
        report.fail("header", fmt::format("{} bytes", length),
                    fmt::format("{} bytes: the file is truncated", bytes.size()));
    }
    if (length < kHeaderBytes)
        report.fail("header", "a length of at least 12", fmt::format("{}", length));
    bytes = bytes.first(length);

    std::size_t offset = kHeaderBytes;
    std::uint32_t type = 0;
    const auto first = take_chunk(bytes, offset, type, report);
    if (type != kJsonChunk)
        report.fail("first chunk", "type JSON", fmt::format("type {:#010x}", type));
    container.json = text_of(first);
    while (offset < bytes.size() && container.binary.empty()) {
        const auto chunk = take_chunk(bytes, offset, type, report);
        if (type == kBinaryChunk) container.binary = chunk;
    }
}

bool is_scheme_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '+' ||
           c == '-' || c == '.';
}

bool has_scheme(std::string_view uri) {
    const std::size_t colon = uri.find(':');
    if (colon == 0 || colon == std::string_view::npos) return false;
    for (const char c : uri.substr(0, colon))
        if (!is_scheme_character(c)) return false;
    return true;
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::string percent_decoded(std::string_view uri) {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool escape = uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 &&
                            hex_digit(uri[i + 2]) >= 0;
        if (escape) {
            text.push_back(static_cast<char>(16 * hex_digit(uri[i + 1]) + hex_digit(uri[i + 2])));
            i += 2;
        } else {
            text.push_back(uri[i]);
        }
    }
    return text;
}

}  // namespace

GltfContainer open_gltf_container(const std::filesystem::path& path, GltfReport& report) {
    GltfContainer container;
    container.folder = path.parent_path();
    container.bytes = read_file(path);
    report.earn(container.bytes.size());
    const std::string_view text = text_of(container.bytes);
    if (container.bytes.size() >= 4 && word_at(container.bytes, 0) == kGlbMagic) {
        split_glb(container, report);
        return container;
    }
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    container.json = text;
    if (container.json.starts_with(kByteOrderMark))
        container.json.remove_prefix(kByteOrderMark.size());
    const std::size_t first = container.json.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || container.json[first] != '{')
        report.fail("", "glTF (JSON, or a binary that starts with \"glTF\")",
                    text.empty() ? "an empty file" : shown(text.substr(0, 16)));
    return container;
}

std::filesystem::path resolve_gltf_uri(ModelFiles& files, const std::filesystem::path& folder,
                                       GltfFile kind, std::string_view uri, std::string_view key,
                                       GltfReport& report) {
    constexpr std::string_view kExpected = "a relative path inside the model's folder";
    constexpr std::string_view kFileScheme = "file://";
    if (uri.empty()) report.fail(key, kExpected, shown(uri));
    const bool file_scheme = uri.starts_with(kFileScheme);
    const std::string name = percent_decoded(file_scheme ? uri.substr(kFileScheme.size()) : uri);
    // "C:" is the drive of a path of Windows.
    const bool drive = name.size() > 2 && name[1] == ':';
    if ((has_scheme(uri) && !file_scheme && !drive) || name.find('\0') != std::string::npos)
        report.fail(key, kExpected, shown(uri));
    const FoundFile found = kind == GltfFile::picture ? files.find_picture(name) : files.find(name);
    if (found && !found.is_exact())
        report.warn(fmt::format("{}: {}", key, used_in_place(uri, found)));
    if (found) return found.path;
    const auto relative = std::filesystem::path(name).lexically_normal();
    const bool outside = relative.empty() || relative.is_absolute() || *relative.begin() == "..";
    if (outside || file_scheme || drive || name.find('\\') != std::string::npos)
        report.fail(key, kExpected, fmt::format("{}, and no file of its name there", shown(uri)));
    return folder / relative;
}

}  // namespace burnish
