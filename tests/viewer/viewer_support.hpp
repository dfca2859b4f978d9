// Documents, models and comparisons that the tests of the viewer share.
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "burnish/stage.hpp"
#include "scene/material/texture_uses.hpp"
#include "support/glb_writer.hpp"
#include "support/test_folder.hpp"
#include "viewer/document/document.hpp"

namespace burnish::test {

// Two squares with materials of their own, "brass" and "oak", one of them twice; a light and a camera
// where they are asked for.
inline std::filesystem::path two_materials(const ScratchFolder& folder, const std::string& name,
                                           bool with_light = false, bool with_camera = false) {
    GlbWriter writer;
    for (const char* material : {"brass", "oak"})
        writer.add_material({{"name", material},
                             {"pbrMetallicRoughness",
                              {{"roughnessFactor", material[0] == 'b' ? 0.3 : 0.8},
                               {"metallicFactor", material[0] == 'b' ? 1.0 : 0.0}}}});
    for (int i = 0; i < 2; ++i) {
        GlbPrimitive square = unit_square(2, false);
        for (glm::vec3& p : square.positions) p.z += static_cast<float>(i) * 0.5f;
        square.material = i;
        const int mesh = writer.add_mesh(square);
        writer.add_node(mesh);
        if (i == 0) {
            const int node = writer.add_node(mesh);
            writer.root["nodes"][static_cast<std::size_t>(node)]["translation"] = {1.5, 0, 0};
        }
    }
    if (with_light) {
        writer.root["extensionsUsed"].push_back("KHR_lights_punctual");
        writer.root["extensions"]["KHR_lights_punctual"]["lights"] = {
            {{"type", "directional"}, {"intensity", 2.0}, {"color", {1.0, 0.9, 0.7}}}};
        const std::size_t node = writer.root["nodes"].size();
        writer.root["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}},
                                        {"rotation", {-0.3826834, 0.0, 0.0, 0.9238795}}});
        writer.root["scenes"][0]["nodes"].push_back(node);
    }
    if (with_camera) {
        writer.root["cameras"] = {
            {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.01}}}}};
        const std::size_t node = writer.root["nodes"].size();
        writer.root["nodes"].push_back({{"camera", 0}, {"translation", {0.2, 0.4, 4.0}}});
        writer.root["scenes"][0]["nodes"].push_back(node);
    }
    const std::vector<std::byte> bytes = writer.glb();
    return folder.write(
        name, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

// A texture is the same where its name and its texels are: its place in the scene depends on what was
// looked at before.
inline bool same_texture(const Scene& a, const TextureUse& in_a, const Scene& b,
                         const TextureUse& in_b) {
    TextureUse placed = in_b;
    placed.texture = in_a.texture;
    if (!(placed == in_a) || in_a.texture < 0 || in_b.texture < 0)
        return placed == in_a && in_a.texture == in_b.texture;
    const Texture& x = a.textures.at(static_cast<std::size_t>(in_a.texture));
    const Texture& y = b.textures.at(static_cast<std::size_t>(in_b.texture));
    return x.width == y.width && x.height == y.height && x.channels == y.channels &&
           x.texels == y.texels;
}

inline void expect_same_materials(const Scene& a, const Scene& b) {
    ASSERT_EQ(a.materials.size(), b.materials.size());
    for (std::size_t i = 0; i < a.materials.size(); ++i) {
        SCOPED_TRACE("material " + std::to_string(i) + ", " + a.materials[i].name);
        Material x = a.materials[i], y = b.materials[i];
        const auto in_x = texture_uses(x), in_y = texture_uses(y);
        for (std::size_t use = 0; use < in_x.size(); ++use) {
            EXPECT_TRUE(same_texture(a, *in_x[use], b, *in_y[use]));
            *in_x[use] = *in_y[use] = TextureUse{};
        }
        // Drafts and tables are read by each scene for itself.
        if (auto* p = std::get_if<Cloth>(&x.lobe)) p->draft = nullptr;
        if (auto* p = std::get_if<Cloth>(&y.lobe)) p->draft = nullptr;
        if (auto* p = std::get_if<Tabulated>(&x.lobe)) *p = {};
        if (auto* p = std::get_if<Tabulated>(&y.lobe)) *p = {};
        EXPECT_EQ(x.name, y.name);
        EXPECT_TRUE(x == y);
    }
}

inline void expect_same_stage(const Stage& a, const Stage& b) {
    expect_same_materials(a.scene, b.scene);
    EXPECT_TRUE(a.scene.lights == b.scene.lights);
    ASSERT_EQ(a.scene.instances.size(), b.scene.instances.size());
    for (std::size_t i = 0; i < a.scene.instances.size(); ++i) {
        const Instance &x = a.scene.instances[i], &y = b.scene.instances[i];
        EXPECT_EQ(x.mesh < 0, y.mesh < 0) << i;
        EXPECT_EQ(x.material, y.material);
        EXPECT_EQ(x.transform, y.transform);
        if (x.mesh < 0 || y.mesh < 0) continue;
        const Mesh& p = a.scene.meshes.at(static_cast<std::size_t>(x.mesh));
        const Mesh& q = b.scene.meshes.at(static_cast<std::size_t>(y.mesh));
        EXPECT_TRUE(p.positions == q.positions);
        EXPECT_TRUE(p.tangents == q.tangents);
    }
    EXPECT_TRUE(a.camera == b.camera);
    EXPECT_TRUE(a.settings == b.settings);
    EXPECT_EQ(a.exposure_ev, b.exposure_ev);
    EXPECT_EQ(a.tone_map, b.tone_map);
    EXPECT_EQ(a.environment.name, b.environment.name);
    EXPECT_EQ(a.environment.radiance.pixels, b.environment.radiance.pixels);
}

// A random unit vector of floats.
inline glm::vec3 any_direction(std::mt19937& random) {
    std::normal_distribution<float> normal;
    return glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
}

}  // namespace burnish::test
