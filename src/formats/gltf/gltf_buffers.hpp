// The bytes of the buffer views of a glTF file, decompressed where necessary.
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
    // Reads every buffer that has data. Throws Error for missing files, URIs outside the folder,
    // and buffers shorter than declared. Keeps references to all arguments.
    GltfBuffers(const GltfContainer& container, const GltfDocument& document, ModelFiles& files,
                GltfReport& report);

    // The bytes of one view, valid for the lifetime of this object. `user` is the key that refers
    // to the view, for messages. EXT_meshopt_compression is decoded at the first use. Throws Error
    // when the view exceeds its buffer.
    std::span<const std::byte> view(int index, std::string_view user);

  private:
    std::vector<std::byte> read_uri(std::size_t index);
    std::span<const std::byte> range(int buffer, std::size_t offset, std::size_t length,
                                     std::string_view key) const;
    std::vector<std::byte> decompress(const tinygltf::BufferView& view, std::string_view key);

    const GltfContainer& container_;
    const GltfDocument& document_;
    ModelFiles& files_;
    GltfReport& report_;
    std::vector<std::vector<std::byte>> owned_;  // one per buffer; empty for the GLB's
    std::vector<std::span<const std::byte>> buffers_;
    std::vector<std::optional<std::vector<std::byte>>> decompressed_;  // one per view
};

// The bytes of a "data:" URI; nothing for another URI. Throws Error for a malformed one.
std::optional<std::vector<std::byte>> decode_data_uri(std::string_view uri, std::string_view key,
                                                      const GltfReport& report);

}  // namespace burnish
