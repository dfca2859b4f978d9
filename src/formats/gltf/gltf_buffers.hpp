// The bytes behind the buffer views of a glTF file, decompressed where they need to be.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "formats/gltf/gltf_container.hpp"
#include "formats/gltf/gltf_document.hpp"
#include "formats/gltf/gltf_report.hpp"

namespace tinygltf {
struct BufferView;
}

namespace burnish {

class GltfBuffers {
  public:
    // Reads every buffer that has data. Throws Error for missing files, URIs that lead out of the
    // folder, and buffers shorter than they say. Keeps references to all three.
    GltfBuffers(const GltfContainer& container, const GltfDocument& document, GltfReport& report);

    // The bytes of one view, valid as long as this object. `user` names who asks, for messages.
    // EXT_meshopt_compression is undone on first use. Throws Error when they lie outside the
    // buffer.
    std::span<const std::byte> view(int index, std::string_view user);

  private:
    std::vector<std::byte> read_uri(std::size_t index);
    std::span<const std::byte> range(int buffer, std::size_t offset, std::size_t length,
                                     std::string_view key) const;
    std::vector<std::byte> decompress(const tinygltf::BufferView& view, std::string_view key);

    const GltfContainer& container_;
    const GltfDocument& document_;
    GltfReport& report_;
    std::vector<std::vector<std::byte>> owned_;  // a buffer each; empty for the GLB's
    std::vector<std::span<const std::byte>> buffers_;
    std::vector<std::optional<std::vector<std::byte>>> decompressed_;  // a view each
};

// The bytes of a "data:" URI, or nothing when `uri` is none. Throws Error when it is broken.
std::optional<std::vector<std::byte>> decode_data_uri(std::string_view uri, std::string_view key,
                                                      const GltfReport& report);

}  // namespace burnish
