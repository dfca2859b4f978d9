// Woven cloth as a material: the effect of --weave and its parameters, and their errors.
#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>
#include <string>

#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "burnish/layered_materials.hpp"
#include "burnish/load_model.hpp"

namespace burnish {
namespace {

Scene scene_with(std::initializer_list<std::pair<const char*, const char*>> parameters) {
    Scene scene = load_model("builtin:plane", 2);
    ParameterValues values;
    for (const auto& [name, text] : parameters) values.set(name, text, "");
    apply_material_parameters(scene, values);
    return scene;
}

std::string refusal_of(std::initializer_list<std::pair<const char*, const char*>> parameters) {
    try {
        scene_with(parameters);
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

TEST(ClothMaterial, AWeaveMakesTheSurfaceFibers) {
    const Scene scene =
        scene_with({{"weave", "satin-5"}, {"weave_twist", "-30"}, {"warp_color", "1,0,0"}});
    const Material& m = scene.materials.front();
    const Cloth* cloth = cloth_of(m);
    ASSERT_TRUE(cloth);
    EXPECT_EQ(cloth->draft->ends, 5);
    EXPECT_FLOAT_EQ(cloth->twist, glm::radians(-30.0f));
    EXPECT_EQ(cloth->warp_color, glm::vec3(1, 0, 0));
    EXPECT_FALSE(cloth->weft_color);
    EXPECT_EQ(cloth->alpha, Cloth{}.alpha);
    EXPECT_EQ(m.metallic, 0.0f);
}

TEST(ClothMaterial, RoughnessIsAPairOfTheFibers) {
    // Also for an existing cloth: alpha = roughness^2, stretched across the fibers.
    Scene scene = scene_with({{"weave", "plain"}});
    ParameterValues later;
    later.set("roughness", "0.5", "");
    later.set("anisotropy", "0.6", "");
    apply_material_parameters(scene, later);
    ASSERT_TRUE(cloth_of(scene.materials.front()));
    EXPECT_FLOAT_EQ(cloth_of(scene.materials.front())->alpha.x, 0.25f);
    EXPECT_FLOAT_EQ(cloth_of(scene.materials.front())->alpha.y, 0.25f + 0.75f * 0.36f);
}

TEST(ClothMaterial, NoneIsNoOtherDetail) {
    EXPECT_TRUE(
        cloth_of(scene_with({{"weave", "plain"}, {"normal_map", "none"}}).materials.front()));
    Scene scene = scene_with({{"weave", "plain"}});
    ParameterValues later;
    later.set("normal_map", "none", "");
    apply_material_parameters(scene, later);
    EXPECT_TRUE(cloth_of(scene.materials.front()));
    later.set("weave", "none", "");
    apply_material_parameters(scene, later);
    EXPECT_FALSE(cloth_of(scene.materials.front()));
}

TEST(ClothMaterial, WhatContradictsItselfIsRefused) {
    EXPECT_NE(refusal_of({{"weave", "plain"}, {"normal_map", "builtin:bumps"}}).find("two of them"),
              std::string::npos);
    EXPECT_NE(refusal_of({{"weave", "plain"}, {"scratch", "brushed"}}).find("two of them"),
              std::string::npos);
    EXPECT_NE(refusal_of({{"weave_gap", "0.2"}}).find("a weave beside it"), std::string::npos);
    const std::string unknown = refusal_of({{"weave", "twil-2-2"}});
    EXPECT_NE(unknown.find("twil-2-2"), std::string::npos);
    EXPECT_NE(unknown.find("twill-2-2"), std::string::npos);
    EXPECT_EQ(unknown.find('\n'), std::string::npos);
    EXPECT_NE(refusal_of({{"weave", "missing.wif"}}).find("no such file"), std::string::npos);
}

TEST(ClothMaterial, ColorsThatAMetalHidesAreSaid) {
    const auto says_so = [](const Scene& scene) {
        for (const std::string& warning : scene.warnings)
            if (warning.find("warp_color") != std::string::npos) return true;
        return false;
    };
    EXPECT_TRUE(
        says_so(scene_with({{"weave", "plain"}, {"metal", "steel"}, {"warp_color", "1,0,0"}})));
    EXPECT_FALSE(says_so(scene_with({{"weave", "plain"}, {"metal", "steel"}})));
    EXPECT_FALSE(says_so(scene_with({{"weave", "plain"}, {"warp_color", "1,0,0"}})));
}

}  // namespace
}  // namespace burnish
