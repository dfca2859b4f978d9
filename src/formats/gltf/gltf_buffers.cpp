#include "formats/gltf/gltf_buffers.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <array>
#include <cstring>

#include "burnish/error.hpp"
#include "core/files.hpp"
#include "formats/gltf/gltf_meshopt.hpp"

namespace burnish {
namespace {

// Value of each base64 digit, -1 for everything else.
constexpr std::array<int, 256> base64_values() {
    std::array<int, 256> values{};
    values.fill(-1);
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < kDigits.size(); ++i)
        values[static_cast<unsigned char>(kDigits[i])] = static_cast<int>(i);
    return values;
}
constexpr auto kBase64 = base64_values();

int integer(const tinygltf::Value& object, const char* key, int otherwise) {
    return object.Has(key) ? object.Get(key).GetNumberAsInt() : otherwise;
}

std::size_t size(const tinygltf::Value& object, const char* key) {
    return static_cast<std::size_t>(integer(object, key, 0));
}

}  // namespace

std::optional<std::vector<std::byte>> decode_data_uri(std::string_view uri, std::string_view key,
                                                      const GltfReport& report) {
    if (!uri.starts_with("data:")) return std::nullopt;
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64"))
        report.fail(key, "a data URI in base64", shown(uri));
    std::string_view text = uri.substr(comma + 1);
    while (text.ends_with('=')) text.remove_suffix(1);

    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const int digit = kBase64[static_cast<unsigned char>(c)];
        if (digit < 0)
            report.fail(key, "a data URI in base64",
                        fmt::format("the character {}", shown(std::string_view(&c, 1))));
        bits = (bits << 6) | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<std::byte>((bits >> count) & 0xFF));
        }
    }
    return bytes;
}

GltfBuffers::GltfBuffers(const GltfContainer& container, const GltfDocument& document,
                         ModelFiles& files, GltfReport& report)
    : container_(container),
      document_(document),
      files_(files),
      report_(report),
      owned_(document.buffers.size()),
      buffers_(document.buffers.size()),
      decompressed_(document.model->bufferViews.size()) {
    for (std::size_t i = 0; i < buffers_.size(); ++i) {
        const GltfBuffer& buffer = document.buffers[i];
        // A buffer without URI is the binary chunk if it is the first of a .glb. Otherwise it is
        // empty, and only a fallback buffer of compressed views may be so.
        if (buffer.has_uri && !buffer.fallback) {
            owned_[i] = read_uri(i);
            buffers_[i] = owned_[i];
        } else if (!buffer.has_uri && i == 0) {
            buffers_[i] = container.binary;
        }
        if (buffers_[i].empty()) continue;
        if (buffers_[i].size() < buffer.byte_length) {
            report.fail(fmt::format("buffers[{}].byteLength", i),
                        fmt::format("at most the {} bytes there are", buffers_[i].size()),
                        fmt::format("{}", buffer.byte_length));
        }
        buffers_[i] = buffers_[i].first(static_cast<std::size_t>(buffer.byte_length));
    }
}

std::vector<std::byte> GltfBuffers::read_uri(std::size_t index) {
    const std::string key = fmt::format("buffers[{}].uri", index);
    const std::string& uri = document_.buffers[index].uri;
    if (auto bytes = decode_data_uri(uri, key, report_)) return std::move(*bytes);
    const auto path =
        resolve_gltf_uri(files_, container_.folder, GltfFile::buffer, uri, key, report_);
    std::vector<std::byte> bytes;
    try {
        bytes = read_file(path);
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}: {}", report_.file(), key, error.what()));
    }
    report_.earn(bytes.size());
    return bytes;
}

std::span<const std::byte> GltfBuffers::range(int buffer, std::size_t offset, std::size_t length,
                                              std::string_view key) const {
    const auto bytes = item_at(buffers_, buffer, report_, fmt::format("{}.buffer", key));
    if (offset > bytes.size() || length > bytes.size() - offset) {
        report_.fail(key, fmt::format("bytes inside the {} of buffer {}", bytes.size(), buffer),
                     fmt::format("byteOffset {}, byteLength {}", offset, length));
    }
    return bytes.subspan(offset, length);
}

std::span<const std::byte> GltfBuffers::view(int index, std::string_view user) {
    const auto& view = item_at(document_.model->bufferViews, index, report_, user);
    const std::string key = fmt::format("bufferViews[{}]", index);
    if (!view.extensions.contains(kMeshoptExtension))
        return range(view.buffer, view.byteOffset, view.byteLength, key);
    auto& bytes = decompressed_[static_cast<std::size_t>(index)];
    if (!bytes) bytes = decompress(view, key);
    return *bytes;
}

std::vector<std::byte> GltfBuffers::decompress(const tinygltf::BufferView& view,
                                               std::string_view key) {
    const tinygltf::Value& extension = view.extensions.at(kMeshoptExtension);
    MeshoptView meshopt;
    meshopt.count = size(extension, "count");
    meshopt.stride = size(extension, "byteStride");
    meshopt.mode = extension.Get("mode").Get<std::string>();
    if (extension.Has("filter")) meshopt.filter = extension.Get("filter").Get<std::string>();
    meshopt.bytes = range(integer(extension, "buffer", -1), size(extension, "byteOffset"),
                          size(extension, "byteLength"), key);
    auto bytes = decode_meshopt_view(meshopt, key, report_);
    if (bytes.size() < view.byteLength) {
        report_.fail(fmt::format("{}.byteLength", key),
                     fmt::format("at most the {} bytes it unpacks to", bytes.size()),
                     fmt::format("{}", view.byteLength));
    }
    bytes.resize(view.byteLength);
    return bytes;
}

}  // namespace burnish
