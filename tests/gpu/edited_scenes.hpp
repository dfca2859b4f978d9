// A small scene with every kind of data that an edit can change.
#pragma once

#include "burnish/scene.hpp"
#include "test_scene.hpp"

namespace burnish::test {

// Two spheres and a plane, three materials, two textures, two lights.
inline Scene busy_scene() {
    Scene scene;
    scene.name = "busy scene";
    scene.meshes = {uv_sphere(32, 16), unit_plane()};
    Material brushed;
    brushed.lobe = AlphaLobe{{0.4f, 0.15f}};
    brushed.normal_texture.texture = 0;
    Material painted;
    painted.metallic = 0.0f;
    painted.lobe = GltfLobe{0.5f, 0.0f};
    painted.base_color = {0.2f, 0.5f, 0.8f, 1.0f};
    Material patterned = painted;
    patterned.base_color_texture.texture = 1;
    scene.materials = {brushed, painted, patterned};
    scene.textures = {bump_texture(32, 4, 0.3f),
                      float_texture(2, 2, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}})};
    for (int i = 0; i < 3; ++i) {
        Instance instance;
        instance.mesh = i == 2 ? 1 : 0;
        instance.material = i;
        instance.transform[0][0] = instance.transform[1][1] = instance.transform[2][2] = 0.45f;
        instance.transform[3] =
            glm::vec4(static_cast<float>(i) - 1.0f, i == 2 ? 0.3f : 0.0f, 0.0f, 1.0f);
        scene.instances.push_back(instance);
    }
    scene.lights = {directional({0.4f, 0.6f, 1.0f}),
                    directional({-1, 0.4f, 0.4f}, {1, 0.5f, 0.2f})};
    return scene;
}

// Brighter above and to the right, so that rotations and shadows are visible.
inline Environment sky_environment() {
    Environment sky = constant_environment({0.1f, 0.12f, 0.15f}, 64);
    sky.name = "sky";
    for (int y = 2; y < 9; ++y)
        for (int x = 40; x < 48; ++x) {
            float* p = sky.radiance.at(x, y);
            p[0] = p[1] = p[2] = 6.0f;
        }
    return sky;
}

}  // namespace burnish::test
