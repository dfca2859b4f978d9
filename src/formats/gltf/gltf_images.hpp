// The pictures of a glTF file, decoded once for each use.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "burnish/image.hpp"
#include "formats/gltf/gltf_buffers.hpp"

namespace burnish {

class GltfImages {
  public:
    GltfImages(const GltfContainer& container, const GltfDocument& document, GltfBuffers& buffers,
               GltfReport& report)
        : container_(container), document_(document), buffers_(buffers), report_(report) {}

    // The index that image `image`, read as `color_space`, will have among the textures.
    int use(int image, ColorSpace color_space, std::string_view user);

    // Reads and decodes all pictures in use, in parallel. Throws Error naming the model and the
    // picture for missing files, broken pictures and more texels than the limit.
    std::vector<Texture> decode();

  private:
    Texture decode_one(int image, ColorSpace color_space, std::span<const std::byte> view) const;

    const GltfContainer& container_;
    const GltfDocument& document_;
    GltfBuffers& buffers_;
    GltfReport& report_;
    std::vector<std::pair<int, ColorSpace>> used_;
    std::map<std::pair<int, ColorSpace>, int> slots_;
};

}  // namespace burnish
