#include "gpu/upload/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <string>
#include <string_view>

#include "burnish/error.hpp"
#include "scene/geometry/normal_transform.hpp"

namespace burnish::gpu {
namespace {

std::string name_of_mesh(const Mesh& mesh) {
    return mesh.name.empty() ? "mesh" : mesh.name;
}

// Attribute locations of shaders/surface.vert.
enum Location : GLuint { position, normal, tangent, texcoord0, texcoord1, color };

// Interleaves the attributes a mesh has.
class Interleaver {
  public:
    struct Part {
        GLuint location;
        int components;
        std::size_t offset;
        const float* values;
    };

    template <typename Vector>
    void add(Location location, const std::vector<Vector>& values) {
        if (values.empty()) return;
        parts_.push_back({location, Vector::length(), stride_, &values[0][0]});
        stride_ += static_cast<std::size_t>(Vector::length());
        count_ = values.size();
    }

    // Into the bound buffer.
    void upload() const {
        std::vector<float> data(stride_ * count_);
        for (const Part& part : parts_) {
            const auto n = static_cast<std::size_t>(part.components);
            for (std::size_t i = 0; i < count_; ++i) {
                std::copy_n(part.values + i * n, n, data.data() + i * stride_ + part.offset);
            }
        }
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(float)),
                     data.data(), GL_STATIC_DRAW);
    }

    const std::vector<Part>& parts() const { return parts_; }
    std::size_t stride() const { return stride_; }

  private:
    std::vector<Part> parts_;
    std::size_t stride_ = 0;
    std::size_t count_ = 0;
};

Bounds transformed(const Bounds& box, const glm::mat4& m) {
    Bounds out;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 local((corner & 1) != 0 ? box.high.x : box.low.x,
                              (corner & 2) != 0 ? box.high.y : box.low.y,
                              (corner & 4) != 0 ? box.high.z : box.low.z);
        const glm::vec3 p(m * glm::vec4(local, 1.0f));
        out.low = corner == 0 ? p : glm::min(out.low, p);
        out.high = corner == 0 ? p : glm::max(out.high, p);
    }
    return out;
}

bool finite(const glm::mat4& m) {
    for (int c = 0; c < 4; ++c) {
        for (int r = 0; r < 4; ++r) {
            if (!std::isfinite(m[c][r])) return false;
        }
    }
    return true;
}

// `n`: the number of vertices.
void require_triangles(const std::string& name, std::span<const std::uint32_t> indices,
                       std::size_t n) {
    if (indices.size() % 3 != 0 ||
        indices.size() > static_cast<std::size_t>(std::numeric_limits<GLsizei>::max())) {
        throw Error(name, "indices", "three a triangle, below 2^31",
                    std::to_string(indices.size()));
    }
    const auto highest = std::ranges::max_element(indices);
    if (highest != indices.end() && *highest >= n) {
        throw Error(name, "indices", "below " + std::to_string(n), std::to_string(*highest));
    }
}

void upload_indices(std::span<const std::uint32_t> indices) {
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(),
                 GL_STATIC_DRAW);
}

}  // namespace

void require_sound(const Mesh& mesh) {
    const std::size_t n = mesh.positions.size();
    const auto fits = [n](std::size_t size) { return size == 0 || size == n; };
    if (!fits(mesh.normals.size()) || !fits(mesh.tangents.size()) || !fits(mesh.texcoord0.size()) ||
        !fits(mesh.texcoord1.size()) || !fits(mesh.colors.size())) {
        throw Error(name_of_mesh(mesh), "attributes", "as many values as positions",
                    "another number");
    }
    if (mesh.normals.empty() && n > 0) {
        throw Error(name_of_mesh(mesh), "normals", "one a vertex", "none");
    }
    require_triangles(name_of_mesh(mesh), mesh.indices, n);
}

std::uint64_t content_of(const Mesh& mesh) {
    std::uint64_t sum = 0;
    const auto add = [&](const auto& values) {
        const auto bytes = std::as_bytes(std::span(values));
        const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        // Multiplying by an odd factor makes the sum depend on the order of the attributes.
        sum = (sum ^ std::hash<std::string_view>()(text)) * 0x9E3779B97F4A7C15U;
    };
    add(mesh.positions);
    add(mesh.normals);
    add(mesh.tangents);
    add(mesh.texcoord0);
    add(mesh.texcoord1);
    add(mesh.colors);
    add(mesh.indices);
    return sum;
}

MeshBuffers::MeshBuffers(const Mesh& mesh) : content_(content_of(mesh)) {
    require_sound(mesh);
    index_count_ = static_cast<GLsizei>(mesh.indices.size());
    has_color_ = !mesh.colors.empty();
    if (mesh.positions.empty()) index_count_ = 0;
    vertex_count_ = static_cast<GLsizei>(mesh.positions.size());
    glBindVertexArray(array_.get());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
    Interleaver interleaver;
    interleaver.add(Location::position, mesh.positions);
    interleaver.add(Location::normal, mesh.normals);
    interleaver.add(Location::tangent, mesh.tangents);
    interleaver.add(Location::texcoord0, mesh.texcoord0);
    interleaver.add(Location::texcoord1, mesh.texcoord1);
    interleaver.add(Location::color, mesh.colors);
    interleaver.upload();
    stride_ = interleaver.stride();
    for (const Interleaver::Part& part : interleaver.parts())
        attributes_.push_back({part.location, part.components, part.offset});
    describe_vertices();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
    upload_indices(mesh.indices);
    glBindVertexArray(0);
    check_gl(("uploading " + name_of_mesh(mesh)).c_str());
}

void MeshBuffers::set_coarse(std::span<const std::uint32_t> indices) {
    require_triangles("coarse mesh", indices, static_cast<std::size_t>(vertex_count_));
    coarse_count_ = static_cast<GLsizei>(indices.size());
    coarse_.reset();
    if (indices.empty()) return;
    coarse_.emplace();
    // The binding of indices is part of the vertex array.
    glBindVertexArray(array_.get());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, coarse_->get());
    upload_indices(indices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
    glBindVertexArray(0);
    check_gl("uploading a coarse mesh");
}

void MeshBuffers::describe_vertices() const {
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
    for (const Attribute& attribute : attributes_) {
        const std::size_t offset = attribute.offset * sizeof(float);
        glEnableVertexAttribArray(attribute.location);
        glVertexAttribPointer(attribute.location, attribute.components, GL_FLOAT, GL_FALSE,
                              static_cast<GLsizei>(stride_ * sizeof(float)),
                              reinterpret_cast<const void*>(offset));
    }
}

void MeshBuffers::bind_triangles(bool coarse) const {
    const bool by_coarse = coarse && coarse_count_ > 0;
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, by_coarse ? coarse_->get() : indices_.get());
}

void MeshBuffers::set_constants() {
    glVertexAttrib4f(Location::tangent, 0.0f, 0.0f, 0.0f, 1.0f);
    glVertexAttrib4f(Location::texcoord0, 0.0f, 0.0f, 0.0f, 1.0f);
    glVertexAttrib4f(Location::texcoord1, 0.0f, 0.0f, 0.0f, 1.0f);
    glVertexAttrib4f(Location::color, 1.0f, 1.0f, 1.0f, 1.0f);
    // Nothing blocks the view.
    for (GLuint i = 0; i < kVisibilityLocations; ++i)
        glVertexAttrib4f(kVisibilityLocation + i, 0.0f, 0.0f, 0.0f, 0.0f);
}

void MeshBuffers::draw(bool coarse) const {
    if (count(coarse) == 0) return;
    set_constants();
    glBindVertexArray(array_.get());
    // The binding of indices is part of the vertex array.
    bind_triangles(coarse);
    glDrawElements(GL_TRIANGLES, count(coarse), GL_UNSIGNED_INT, nullptr);
    if (coarse) bind_triangles(false);
    glBindVertexArray(0);
}

std::vector<DrawItem> draw_items(std::span<const std::optional<Instance>> instances,
                                 std::span<const Bounds> meshes, std::size_t materials,
                                 const std::string& name) {
    std::vector<DrawItem> items;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (!instances[i]) continue;
        const Instance& instance = *instances[i];
        if (instance.mesh < 0) continue;  // erased
        const bool mesh = static_cast<std::size_t>(instance.mesh) < meshes.size();
        const bool material =
            instance.material >= 0 && static_cast<std::size_t>(instance.material) < materials;
        if (!mesh || !material || !finite(instance.transform)) {
            throw Error(name, "instance " + std::to_string(i),
                        "a mesh and a material of the scene and a finite transform",
                        "something else");
        }
        DrawItem item;
        item.instance = static_cast<int>(i);
        item.mesh = instance.mesh;
        item.material = instance.material;
        item.world_from_local = instance.transform;
        const glm::mat3 linear(instance.transform);
        item.mirrored = is_mirrored(linear);
        item.normal_from_local = normal_transform(linear);
        item.bounds =
            transformed(meshes[static_cast<std::size_t>(instance.mesh)], instance.transform);
        items.push_back(item);
    }
    return items;
}

Bounds bounds_of(const std::vector<DrawItem>& items) {
    Bounds all{glm::vec3(-0.5f), glm::vec3(0.5f)};
    bool first = true;
    for (const DrawItem& item : items) {
        if (!std::isfinite(item.bounds.radius())) continue;
        all.low = first ? item.bounds.low : glm::min(all.low, item.bounds.low);
        all.high = first ? item.bounds.high : glm::max(all.high, item.bounds.high);
        first = false;
    }
    return all;
}

}  // namespace burnish::gpu
