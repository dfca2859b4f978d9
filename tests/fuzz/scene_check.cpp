#include "scene_check.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "harness.hpp"
#include "scene/material/texture_uses.hpp"

namespace burnish::fuzz {
namespace {

void expect(bool holds, const char* what) {
    if (!holds) broken(what);
}

bool finite(float v) {
    return std::isfinite(v);
}

template <typename Vector>
bool finite_parts(const Vector& v) {
    for (int i = 0; i < Vector::length(); ++i)
        if (!std::isfinite(v[i])) return false;
    return true;
}

template <typename Matrix>
bool finite_columns(const Matrix& m) {
    for (int c = 0; c < Matrix::length(); ++c)
        if (!finite_parts(m[c])) return false;
    return true;
}

template <typename Vector>
void expect_attribute(const std::vector<Vector>& values, std::size_t count, const char* what) {
    expect(values.empty() || values.size() == count, what);
    for (const Vector& value : values) expect(finite_parts(value), what);
}

// Float rounding of a normalised vector, with room for one that was stored in 8 bits.
bool is_unit(const glm::vec3& v) {
    return std::abs(glm::length(v) - 1.0f) < 1e-3f;
}

void expect_sound_mesh(const Mesh& mesh) {
    const std::size_t count = mesh.positions.size();
    expect_attribute(mesh.positions, count, "positions");
    expect_attribute(mesh.normals, count, "normals");
    expect_attribute(mesh.tangents, count, "tangents");
    expect_attribute(mesh.texcoord0, count, "texcoord0");
    expect_attribute(mesh.texcoord1, count, "texcoord1");
    expect_attribute(mesh.colors, count, "colors");
    expect(mesh.normals.size() == count, "a mesh without normals");
    expect(mesh.tangents.size() == count, "a mesh without tangents");
    for (const glm::vec3& normal : mesh.normals) expect(is_unit(normal), "a normal not unit");
    for (const glm::vec4& tangent : mesh.tangents) {
        expect(is_unit(glm::vec3(tangent)), "a tangent not unit");
        expect(std::abs(tangent.w) == 1.0f, "a handedness not 1");
    }
    expect(mesh.indices.size() % 3 == 0, "indices not in threes");
    for (const std::uint32_t index : mesh.indices) expect(index < count, "an index out of range");
}

void expect_sound_material(const Material& m, std::size_t textures) {
    for (const TextureUse* use : texture_uses(m)) {
        expect(use->texture < static_cast<int>(textures), "a texture out of range");
        expect(finite_columns(use->transform), "a texture transform");
    }
    expect(finite_parts(m.base_color) && finite_parts(m.emissive), "a color");
    expect(finite(m.metallic) && finite(m.normal_scale), "a factor");
    expect(finite(m.coat.strength) && finite(m.coat.roughness) && finite_parts(m.coat.tint),
           "a coat");
    expect(finite_parts(m.sheen.color) && finite(m.sheen.roughness), "a sheen");
    expect(finite(m.specular) && finite_parts(m.specular_color), "a specular factor");
    expect(finite(m.occlusion_strength) && finite(m.alpha_cutoff), "a factor");
    expect(finite(m.anisotropy_rotation), "a rotation");
    if (m.conductor) {
        expect(finite_parts(m.conductor->eta) && finite_parts(m.conductor->k), "an index");
        if (m.conductor->oxide)
            for (const glm::vec3& term : m.conductor->oxide->curve)
                expect(finite_parts(term), "a term of a film");
    }
    const auto alpha = stated_alpha(m);
    expect(!alpha || finite_parts(*alpha), "an alpha");
    if (const GltfLobe* lobe = gltf_lobe_of(m))
        expect(finite(lobe->roughness) && finite(lobe->anisotropy_strength), "a roughness");
    expect(!cloth_of(m) || cloth_of(m)->draft, "a draft");
    expect(!tabulated_of(m) || tabulated_of(m)->material, "a table");
}

void expect_sound_texture(const Texture& t) {
    constexpr std::size_t kBytes[] = {1, 2, 4};
    expect(t.width > 0 && t.height > 0 && t.channels > 0 && t.channels <= 4, "a texture's size");
    const std::size_t wanted =
        static_cast<std::size_t>(t.width) * static_cast<std::size_t>(t.height) *
        static_cast<std::size_t>(t.channels) * kBytes[static_cast<std::size_t>(t.type)];
    expect(t.texels.size() == wanted, "a texture's texels");
}

void expect_sound_light(const Light& light) {
    expect(finite_parts(light.color) && finite_parts(light.position), "a light");
    expect(finite(light.intensity) && finite(light.range), "a light's strength");
    expect(finite(light.inner_cone) && finite(light.outer_cone), "a light's cone");
    expect(is_unit(light.direction), "a light's direction");
}

}  // namespace

void expect_sound(const Scene& scene) {
    for (const Mesh& mesh : scene.meshes) expect_sound_mesh(mesh);
    for (const Texture& texture : scene.textures) expect_sound_texture(texture);
    for (const Material& material : scene.materials)
        expect_sound_material(material, scene.textures.size());
    for (const Instance& instance : scene.instances) {
        expect(instance.mesh >= 0 && instance.mesh < static_cast<int>(scene.meshes.size()),
               "an instance's mesh");
        expect(
            instance.material >= 0 && instance.material < static_cast<int>(scene.materials.size()),
            "an instance's material");
        expect(finite_columns(instance.transform), "a transform");
    }
    for (const Light& light : scene.lights) expect_sound_light(light);
    for (const Camera& camera : scene.cameras) {
        expect(finite_parts(camera.position) && finite_parts(camera.target), "a camera's place");
        expect(finite_parts(camera.up), "a camera's up");
        expect(finite(camera.yfov) && finite(camera.ymag), "a camera's view");
        expect(finite(camera.near_plane) && finite(camera.far_plane), "a camera's planes");
    }
    const Bounds bounds = bounds_of(scene);
    expect(finite_parts(bounds.low) && finite_parts(bounds.high), "the bounds");
    for (const std::string& warning : scene.warnings)
        expect(warning.find_first_of("\r\n") == std::string::npos, "a warning of two lines");
}

}  // namespace burnish::fuzz
