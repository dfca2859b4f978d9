// The instances of a scene as one soup of triangles in world space, for the visibility pass: a
// buffer of positions to draw, and textures from which the shading pass reads the corners of the
// triangle it sees. Desktop OpenGL only.
#pragma once

#include <vector>

#include "gpu/geometry.hpp"

namespace burnish::gpu {

class BakedGeometry {
  public:
    // `chosen`: indices into `items`, in drawing order.
    BakedGeometry(const Scene& scene, const std::vector<DrawItem>& items,
                  const std::vector<std::size_t>& chosen);

    // Whether that many vertices and triangles fit the textures and are worth the memory.
    static bool fits(std::size_t vertices, std::size_t triangles);

    // One part an instance, in the order of `chosen`. Counter-clockwise is the front everywhere.
    std::size_t parts() const { return parts_.size(); }
    int material_of(std::size_t part) const { return parts_[part].material; }
    void draw(std::size_t part, Program& program) const;
    void bind_for_shading(Program& program) const;

  private:
    struct Part {
        int material;
        std::size_t first_triangle, triangles;
    };
    std::vector<Part> parts_;
    VertexArray array_;
    Buffer positions_;
    Buffer indices_;
    GlTexture triangle_texture_;
    GlTexture vertex_texture_;
};

}  // namespace burnish::gpu
