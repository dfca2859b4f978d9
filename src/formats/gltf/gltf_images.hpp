// The pictures of a glTF file, decoded once for each use.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "burnish/image.hpp"
#include "formats/gltf/gltf_buffers.hpp"

namespace burnish {

// How the texels of a picture are read.
enum class GltfReading {
    color,      // sRGB
    data,       // linear
    direction,  // linear; blue is filled with 1, because it is no strength
};

struct GltfPictures {
    std::vector<Texture> textures;
    std::vector<std::string> failures;  // one a texture: why it could not be read; empty: it was
};

class GltfImages {
  public:
    GltfImages(const GltfContainer& container, const GltfDocument& document, GltfBuffers& buffers,
               ModelFiles& files, GltfReport& report)
        : container_(container),
          document_(document),
          buffers_(buffers),
          files_(files),
          report_(report) {}

    // The index that the picture of texture `index` of the file will have among the textures; -1,
    // with a warning that names `user`, when the texture has no version that is read. Throws Error
    // for an image that the file does not have.
    int use(int index, GltfReading reading, std::string_view user);

    // Reads and decodes all pictures in use, in parallel, each from its first readable version.
    // Throws Error for more texels than the limit.
    GltfPictures decode();

  private:
    struct Wanted {
        std::vector<GltfTexture::Version> versions;
        GltfReading reading;
    };
    struct Tried {
        Texture texture;
        std::vector<std::string> failures;  // of the versions before the one that was read
        bool read = false;
    };

    // Finds the bytes of an image, or why they are not there; on one thread.
    void locate(int image);
    Texture decode_one(int image, GltfReading reading, std::span<const std::byte> view) const;
    Tried try_versions(const Wanted& wanted) const;

    const GltfContainer& container_;
    const GltfDocument& document_;
    GltfBuffers& buffers_;
    ModelFiles& files_;
    GltfReport& report_;
    std::vector<Wanted> used_;
    std::map<std::pair<std::vector<int>, GltfReading>, int> slots_;
    // By image: its view or its file, or why there is none.
    std::map<int, std::span<const std::byte>> views_;
    std::map<int, std::filesystem::path> paths_;
    std::map<int, std::string> broken_;
};

}  // namespace burnish
