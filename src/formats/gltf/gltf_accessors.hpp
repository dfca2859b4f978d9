// Typed, checked reading of glTF accessors: every component type, strides, normalized integers,
// sparse accessors and accessors without a buffer view.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <string_view>
#include <vector>

#include "formats/gltf/gltf_buffers.hpp"
#include "formats/gltf/gltf_report.hpp"

namespace tinygltf {
class Model;
struct Accessor;
}  // namespace tinygltf

namespace burnish {

// `user` is the key that refers to the accessor, for messages. Every function throws Error for
// indices out of range, the wrong number of components, unknown component types, and elements
// outside their buffer view.
class GltfAccessors {
  public:
    GltfAccessors(const tinygltf::Model& model, GltfBuffers& buffers, GltfReport& report)
        : model_(model), buffers_(buffers), report_(report) {}

    // Values that stand in place of an accessor's own, of decompressed primitives: `components` for
    // each element. The caller keeps them alive until it has taken them back with clear_values().
    void set_values(int accessor, int components, const std::vector<float>& values) {
        decoded_[accessor] = {components, &values};
    }
    void clear_values() { decoded_.clear(); }

    // Elements `first` .. `first + count` as floats; the caller has checked them against
    // element_count().
    std::vector<glm::vec2> vec2s(int accessor, std::size_t first, std::size_t count,
                                 std::string_view user);
    std::vector<glm::vec3> vec3s(int accessor, std::size_t first, std::size_t count,
                                 std::string_view user);
    std::vector<glm::vec4> vec4s(int accessor, std::size_t first, std::size_t count,
                                 std::string_view user);
    // RGB or RGBA; a missing alpha is 1.
    std::vector<glm::vec4> colors(int accessor, std::size_t first, std::size_t count,
                                  std::string_view user);

    std::size_t element_count(int accessor, std::string_view user) const;

    // All elements of an index accessor, each checked to be below `limit`.
    std::vector<std::uint32_t> indices(int accessor, std::size_t limit, std::string_view user);

  private:
    void read_floats(int accessor, int components, std::size_t first, std::size_t count, float* out,
                     std::string_view user);
    void apply_sparse(const tinygltf::Accessor& accessor, int components, std::size_t first,
                      std::size_t count, float* out, std::string_view key);
    void apply_sparse(const tinygltf::Accessor& accessor, std::vector<std::uint32_t>& out,
                      std::string_view key);
    std::vector<std::uint32_t> sparse_indices(const tinygltf::Accessor& accessor,
                                              std::string_view key);

    struct Decoded {
        int components = 0;
        const std::vector<float>* values = nullptr;
    };

    const tinygltf::Model& model_;
    GltfBuffers& buffers_;
    GltfReport& report_;
    std::map<int, Decoded> decoded_;  // by accessor
};

}  // namespace burnish
