// Scenes made in code for the tests of the GPU layer.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "burnish/scene.hpp"

namespace burnish::test {

inline constexpr float kPiF = 3.14159265358979f;

// A sphere of radius 1 with exact tangents along increasing u (eastwards about +y).
inline Mesh uv_sphere(int columns, int rows) {
    Mesh mesh;
    mesh.name = "test sphere";
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const float u = static_cast<float>(column) / static_cast<float>(columns);
            const float v = static_cast<float>(row) / static_cast<float>(rows);
            const float phi = 2 * kPiF * u;
            const float theta = kPiF * v;
            const glm::vec3 n(std::sin(theta) * std::sin(phi), std::cos(theta),
                              std::sin(theta) * std::cos(phi));
            mesh.positions.push_back(n);
            mesh.normals.push_back(n);
            mesh.tangents.emplace_back(std::cos(phi), 0.0f, -std::sin(phi), 1.0f);
            mesh.texcoord0.emplace_back(u, 1 - v);
        }
    }
    const auto at = [&](int row, int column) {
        return static_cast<std::uint32_t>(row * (columns + 1) + column);
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t a = at(row, column), b = at(row + 1, column);
            const std::uint32_t c = at(row + 1, column + 1), d = at(row, column + 1);
            if (row + 1 < rows) mesh.indices.insert(mesh.indices.end(), {a, b, c});
            if (row > 0) mesh.indices.insert(mesh.indices.end(), {a, c, d});
        }
    }
    return mesh;
}

// The square [-1, 1]^2 in the plane z = 0, facing +z, u along x and v along y.
inline Mesh unit_plane() {
    Mesh mesh;
    mesh.name = "test plane";
    for (int i = 0; i < 4; ++i) {
        const float u = static_cast<float>(i % 2);
        const float v = static_cast<float>(i / 2);
        mesh.positions.emplace_back(2 * u - 1, 2 * v - 1, 0.0f);
        mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
        mesh.tangents.emplace_back(1.0f, 0.0f, 0.0f, 1.0f);
        mesh.texcoord0.emplace_back(u, 1 - v);
    }
    mesh.indices = {0, 1, 3, 0, 3, 2};
    return mesh;
}

// RGB floats, linear.
inline Texture float_texture(int width, int height, const std::vector<glm::vec3>& texels) {
    Texture t;
    t.name = "test texture";
    t.width = width;
    t.height = height;
    t.channels = 3;
    t.type = TexelType::f32;
    const auto bytes = std::as_bytes(std::span(texels));
    t.texels.assign(bytes.begin(), bytes.end());
    return t;
}

// Smooth bumps: the normal map of sum of sines of height `slope`.
inline Texture bump_texture(int size, float waves, float slope) {
    std::vector<glm::vec3> texels;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const float a = 2 * kPiF * waves * static_cast<float>(x) / static_cast<float>(size);
            const float b = 2 * kPiF * waves * static_cast<float>(y) / static_cast<float>(size);
            const glm::vec3 n =
                glm::normalize(glm::vec3(-slope * std::cos(a), slope * std::cos(b), 1.0f));
            texels.push_back(0.5f * n + 0.5f);
        }
    }
    return float_texture(size, size, texels);
}

inline Texture constant_texture(glm::vec3 value) {
    return float_texture(1, 1, {value});
}

inline Environment constant_environment(glm::vec3 radiance, int width = 32) {
    Environment e;
    e.name = "constant";
    e.radiance = Image(width, width / 2, 3);
    for (std::size_t i = 0; i < e.radiance.pixels.size(); ++i) {
        e.radiance.pixels[i] = radiance[static_cast<int>(i % 3)];
    }
    return e;
}

inline Light directional(glm::vec3 towards_light, glm::vec3 color = glm::vec3(1.0f)) {
    Light light;
    light.direction = -glm::normalize(towards_light);
    light.color = color;
    return light;
}

inline Scene one_object(Mesh mesh, Material material) {
    Scene scene;
    scene.name = "test scene";
    scene.meshes.push_back(std::move(mesh));
    scene.materials.push_back(std::move(material));
    scene.instances.push_back({});
    return scene;
}

}  // namespace burnish::test
