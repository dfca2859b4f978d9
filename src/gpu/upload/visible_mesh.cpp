#include "gpu/upload/visible_mesh.hpp"

#include <cstddef>
#include <string>
#include <utility>

#include "burnish/error.hpp"

namespace burnish::gpu {
namespace {

void describe(GLuint location, GLenum type, bool normalized, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, 4, type, normalized ? GL_TRUE : GL_FALSE,
                          static_cast<GLsizei>(sizeof(VertexVisibility)),
                          reinterpret_cast<const void*>(offset));
}

}  // namespace

VisibleMesh::VisibleMesh(std::shared_ptr<MeshBuffers> mesh, const InstanceVisibility& visibility,
                         const VisibleMesh* before)
    : mesh_(std::move(mesh)), source_(visibility.mesh) {
    if (source_ && before != nullptr && before->source_ == source_)
        split_ = before->split_;
    else if (source_)
        split_ = std::make_shared<MeshBuffers>(*source_);
    const MeshBuffers& vertices = split_ ? *split_ : *mesh_;
    if (vertices.vertices() != visibility.vertices.size() ||
        vertices.vertices() < mesh_->vertices())
        throw Error("visibility", "vertices",
                    "as many as the mesh has: " + std::to_string(vertices.vertices()),
                    std::to_string(visibility.vertices.size()));
    glBindVertexArray(array_.get());
    vertices.describe_vertices();
    glBindBuffer(GL_ARRAY_BUFFER, values_.get());
    glBufferData(GL_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(visibility.vertices.size() * sizeof(VertexVisibility)),
                 visibility.vertices.data(), GL_STATIC_DRAW);
    constexpr std::size_t kFour = 4 * sizeof(std::int16_t);
    for (GLuint i = 0; i < 4; ++i)
        describe(kVisibilityLocation + i, GL_SHORT, true,
                 offsetof(VertexVisibility, blocked) + i * kFour);
    for (GLuint i = 0; i < 2; ++i)
        describe(kVisibilityLocation + 4 + i, GL_HALF_FLOAT, false,
                 offsetof(VertexVisibility, around) + i * kFour);
    glBindVertexArray(0);
    check_gl("uploading visibility");
}

void VisibleMesh::draw(bool coarse) const {
    // The coarse triangles are of the mesh's own vertices, which are the first ones.
    const MeshBuffers& triangles = split_ && !(coarse && mesh_->has_coarse()) ? *split_ : *mesh_;
    if (triangles.index_count(coarse) == 0) return;
    MeshBuffers::set_constants();
    glBindVertexArray(array_.get());
    triangles.bind_triangles(coarse);
    glDrawElements(GL_TRIANGLES, triangles.index_count(coarse), GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

}  // namespace burnish::gpu
