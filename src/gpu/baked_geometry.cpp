#include "gpu/baked_geometry.hpp"

#include <glm/geometric.hpp>

#include "gpu/texture_units.hpp"

namespace burnish::gpu {
namespace {

// As shaders/resolve.frag addresses them.
constexpr std::size_t kTrianglesPerRow = 4096;
constexpr std::size_t kVerticesPerRow = 1024;
constexpr std::size_t kTexelsPerVertex = 3;

std::size_t rows(std::size_t count, std::size_t per_row) {
    return (count + per_row - 1) / per_row;
}

glm::vec3 unit_or_zero(const glm::vec3& v) {
    const float l = glm::length(v);
    return l > 0.0f ? v / l : glm::vec3(0.0f);
}

struct Soup {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec4> vertices;  // position, u; normal, v; tangent
    std::vector<glm::uvec4> triangles;
};

void append(Soup& soup, const Mesh& mesh, const DrawItem& item, bool second_uv) {
    const auto base = static_cast<std::uint32_t>(soup.positions.size());
    const glm::mat3 linear(item.world_from_local);
    const std::vector<glm::vec2>& uvs = second_uv ? mesh.texcoord1 : mesh.texcoord0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 p(item.world_from_local * glm::vec4(mesh.positions[i], 1.0f));
        const glm::vec3 n = unit_or_zero(item.normal_from_local * mesh.normals[i]);
        const glm::vec4 t = mesh.tangents.empty() ? glm::vec4(0, 0, 0, 1) : mesh.tangents[i];
        const glm::vec2 uv = uvs.empty() ? glm::vec2(0.0f) : uvs[i];
        soup.positions.push_back(p);
        soup.vertices.emplace_back(p, uv.x);
        soup.vertices.emplace_back(n, uv.y);
        soup.vertices.emplace_back(unit_or_zero(linear * glm::vec3(t)), item.mirrored ? -t.w : t.w);
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t a = base + mesh.indices[i];
        const std::uint32_t b = base + mesh.indices[i + 1];
        const std::uint32_t c = base + mesh.indices[i + 2];
        soup.triangles.emplace_back(a, item.mirrored ? c : b, item.mirrored ? b : c, 0u);
    }
}

void upload_texture(GLuint unit_texture, GLenum internal, GLenum layout, GLenum type,
                    std::size_t width, std::size_t height, const void* data) {
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glBindTexture(GL_TEXTURE_2D, unit_texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal), static_cast<GLsizei>(width),
                 static_cast<GLsizei>(height), 0, layout, type, data);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace

bool BakedGeometry::fits(std::size_t vertices, std::size_t triangles) {
    // 4 million vertices: 250 MB here; more is drawn by instances, without a second copy.
    return vertices > 0 && triangles > 0 && vertices <= (1u << 22) && triangles <= (1u << 24);
}

BakedGeometry::BakedGeometry(const Scene& scene, const std::vector<DrawItem>& items,
                             const std::vector<std::size_t>& chosen) {
    Soup soup;
    for (const std::size_t index : chosen) {
        const DrawItem& item = items[index];
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(item.mesh)];
        const Material& material = scene.materials[static_cast<std::size_t>(item.material)];
        const std::size_t first = soup.triangles.size();
        append(soup, mesh, item, material.normal_texture.texcoord == 1);
        parts_.push_back({item.material, first, soup.triangles.size() - first});
    }
    std::vector<std::uint32_t> indices;
    indices.reserve(soup.triangles.size() * 3);
    for (const glm::uvec4& t : soup.triangles) indices.insert(indices.end(), {t.x, t.y, t.z});

    glBindVertexArray(array_.get());
    glBindBuffer(GL_ARRAY_BUFFER, positions_.get());
    glBufferData(GL_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(soup.positions.size() * sizeof(glm::vec3)),
                 soup.positions.data(), GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(),
                 GL_STATIC_DRAW);
    glBindVertexArray(0);

    const std::size_t triangle_rows = rows(soup.triangles.size(), kTrianglesPerRow);
    const std::size_t vertex_rows = rows(soup.positions.size(), kVerticesPerRow);
    soup.triangles.resize(triangle_rows * kTrianglesPerRow);
    soup.vertices.resize(vertex_rows * kVerticesPerRow * kTexelsPerVertex);
    upload_texture(triangle_texture_.get(), GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                   kTrianglesPerRow, triangle_rows, soup.triangles.data());
    upload_texture(vertex_texture_.get(), GL_RGBA32F, GL_RGBA, GL_FLOAT,
                   kVerticesPerRow * kTexelsPerVertex, vertex_rows, soup.vertices.data());
    check_gl("uploading the triangles of the scene");
}

void BakedGeometry::draw(std::size_t part, Program& program) const {
    const Part& p = parts_[part];
    program.set("u_first_triangle", static_cast<unsigned>(p.first_triangle));
    glBindVertexArray(array_.get());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * p.triangles), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(3 * p.first_triangle * sizeof(std::uint32_t)));
    glBindVertexArray(0);
}

void BakedGeometry::bind_for_shading(Program& program) const {
    glActiveTexture(GL_TEXTURE0 + kTrianglesUnit);
    glBindTexture(GL_TEXTURE_2D, triangle_texture_.get());
    glActiveTexture(GL_TEXTURE0 + kVerticesUnit);
    glBindTexture(GL_TEXTURE_2D, vertex_texture_.get());
    program.set("u_triangles", static_cast<int>(kTrianglesUnit));
    program.set("u_vertices", static_cast<int>(kVerticesUnit));
}

}  // namespace burnish::gpu
