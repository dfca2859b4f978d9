// Meshes on the device: one interleaved vertex buffer and one index buffer each.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "burnish/scene.hpp"
#include "gpu/device/handles.hpp"
#include "gpu/device/program.hpp"

namespace burnish::gpu {

// Throws Error naming the mesh when attributes differ in length or an index is out of range.
void require_sound(const Mesh& mesh);

// Attribute locations of shaders/surface.vert from which on visibility is passed.
inline constexpr GLuint kVisibilityLocation = 6;
inline constexpr GLuint kVisibilityLocations = 6;

std::uint64_t content_of(const Mesh& mesh);  // a hash without the name

class MeshBuffers {
  public:
    explicit MeshBuffers(const Mesh& mesh);

    // Triangles that draw(true) draws in place of the mesh's: three indices of its vertices each.
    // Empty: the mesh's. Throws Error for an index out of range.
    void set_coarse(std::span<const std::uint32_t> indices);
    void draw(bool coarse) const;
    // Binds the triangles to the vertex array in use.
    void bind_triangles(bool coarse) const;
    // Describes the attributes of the vertices to the vertex array in use.
    void describe_vertices() const;
    // The constants of the attributes that a mesh lacks.
    static void set_constants();
    GLsizei index_count(bool coarse) const { return count(coarse); }
    std::size_t vertices() const { return static_cast<std::size_t>(vertex_count_); }
    // A hash: equal for equal meshes, and different for others except in one case in 2^64.
    std::uint64_t content() const { return content_; }
    bool has_coarse() const { return coarse_count_ > 0; }
    bool has_color() const { return has_color_; }
    std::size_t triangles(bool coarse) const { return static_cast<std::size_t>(count(coarse)) / 3; }

  private:
    GLsizei count(bool coarse) const {
        return coarse && coarse_count_ > 0 ? coarse_count_ : index_count_;
    }

    struct Attribute {
        GLuint location;
        int components;
        std::size_t offset;  // in numbers
    };
    std::vector<Attribute> attributes_;
    std::size_t stride_ = 0;  // of a vertex, in numbers
    VertexArray array_;
    Buffer vertices_;
    Buffer indices_;
    std::optional<Buffer> coarse_;
    GLsizei vertex_count_ = 0, index_count_ = 0, coarse_count_ = 0;
    bool has_color_ = false;
    std::uint64_t content_ = 0;
};

// An instance with the values derived from its transform.
struct DrawItem {
    int instance = 0;
    int mesh = 0;
    int material = 0;
    glm::mat4 world_from_local{1.0f};
    glm::mat3 normal_from_local{1.0f};  // inverse transpose, up to a positive factor
    bool mirrored = false;              // the transform reverses handedness
    Bounds bounds;                      // world space
};

// Throws Error for an instance of a mesh or material that does not exist or a transform that is not
// finite. `meshes`: their boxes. `instances`: by number, empty where erased. `name`: of the scene,
// for messages.
std::vector<DrawItem> draw_items(std::span<const std::optional<Instance>> instances,
                                 std::span<const Bounds> meshes, std::size_t materials,
                                 const std::string& name);

// Box around all items; a unit box at the origin when there is none.
Bounds bounds_of(const std::vector<DrawItem>& items);

}  // namespace burnish::gpu
