// Builds glTF files in memory, for tests and benchmarks. The caller may change the JSON freely,
// even to broken files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace burnish {

struct GlbPrimitive {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> tangents;
    std::vector<glm::vec2> texcoord0;
    std::vector<glm::vec2> texcoord1;
    std::vector<glm::vec4> colors;
    std::vector<std::uint32_t> indices;
    int material = -1;
    int mode = 4;
};

class GlbWriter {
  public:
    GlbWriter();

    nlohmann::json root;  // all except buffers[0]

    int add_view(std::span<const std::byte> bytes);
    // `component` is glTF's code (5126 float ...), `type` "SCALAR", "VEC3" ...
    int add_accessor(int view, int component, std::size_t count, const char* type);
    int add_mesh(const GlbPrimitive& primitive);
    int add_node(int mesh);  // makes the node a root of the scene
    int add_png(
        std::span<const std::byte> png);  // adds an image and its texture; returns the texture
    int add_material(const nlohmann::json& material);

    std::vector<std::byte> glb() const;
    std::string gltf(const std::string& buffer_uri) const;  // the same with an external buffer
    const std::vector<std::byte>& binary() const { return binary_; }

    template <class Item>
    int add_items(const std::vector<Item>& items, int component, const char* type) {
        return add_accessor(add_view(std::as_bytes(std::span(items))), component, items.size(),
                            type);
    }

  private:
    std::vector<std::byte> binary_;
};

// A folder for one test, removed by the destructor.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path write(const std::string& name, std::span<const std::byte> bytes) const;
    std::filesystem::path write(const std::string& name, std::string_view text) const;

  private:
    std::filesystem::path path_;
};

// An 8-bit RGB picture whose texel (x, y) is (x, y, x + y) modulo 256, or noise with a seed.
std::vector<std::byte> png_gradient(int width, int height);
std::vector<std::byte> png_noise(int width, int height, unsigned seed);

// `cells` x `cells` quadrilaterals of the unit square in z = 0, normals +z, u right, v down.
GlbPrimitive unit_square(int cells, bool with_tangents);

}  // namespace burnish
