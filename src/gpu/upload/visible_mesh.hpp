// The mesh of an instance whose vertices know what they see.
#pragma once

#include <memory>

#include "burnish/visibility.hpp"
#include "gpu/upload/geometry.hpp"

namespace burnish::gpu {

class VisibleMesh {
  public:
    // `mesh`: the instance's. `before`: what the instance had, whose vertices are taken over where they are the
    // same. Throws Error where `visibility` is of another mesh.
    VisibleMesh(std::shared_ptr<MeshBuffers> mesh, const InstanceVisibility& visibility,
                const VisibleMesh* before);

    void draw(bool coarse) const;

  private:
    std::shared_ptr<MeshBuffers> mesh_;   // of the scene: its coarse triangles serve
    std::shared_ptr<const Mesh> source_;  // with split edges; may be null
    std::shared_ptr<MeshBuffers> split_;  // of source_
    VertexArray array_;
    Buffer values_;
};

}  // namespace burnish::gpu
