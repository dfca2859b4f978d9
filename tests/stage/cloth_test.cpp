// Woven cloth as a material: the effect of --weave and its parameters, and their errors.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <string>
#include <utility>
#include <vector>

#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "burnish/layered_materials.hpp"
#include "burnish/load_model.hpp"
#include "burnish/wif.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

Scene scene_with(const std::vector<std::pair<std::string, std::string>>& parameters) {
    Scene scene = load_model("builtin:plane", 2);
    ParameterValues values;
    for (const auto& [name, text] : parameters) values.set(name, text, "");
    apply_material_parameters(scene, values);
    return scene;
}

std::string refusal_of(const std::vector<std::pair<std::string, std::string>>& parameters) {
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
    const std::string unknown = refusal_of({{"weave", "twil-2-2"}});
    EXPECT_NE(unknown.find("twil-2-2"), std::string::npos);
    EXPECT_NE(unknown.find("twill-2-2"), std::string::npos);
    EXPECT_EQ(unknown.find('\n'), std::string::npos);
    EXPECT_NE(refusal_of({{"weave", "missing.wif"}}).find("no such file"), std::string::npos);
}

// The rule of normal_scale without a normal map.
TEST(ClothMaterial, ParametersOfAWeaveWithoutOneAreSaidToChangeNothing) {
    const auto says = [](const Scene& scene, std::string_view line) {
        return std::find(scene.warnings.begin(), scene.warnings.end(), line) !=
               scene.warnings.end();
    };
    for (const char* name : {"weave_fuzz", "weave_crimp", "weave_gap", "weave_yarns_per_cm"}) {
        const std::string line = std::string(name) + ": there is no weave: nothing changes";
        EXPECT_TRUE(says(scene_with({{name, "0.2"}}), line));
        EXPECT_FALSE(says(scene_with({{name, "0.2"}, {"weave", "plain"}}), line));
    }
    EXPECT_TRUE(says(scene_with({{"warp_color", "1,0,0"}}),
                     "warp_color: there is no weave: nothing changes"));
}

TEST(ClothMaterial, ColorsOfADraftThatAMetalHidesAreSaid) {
    const test::ScratchFolder folder;
    Draft draft = builtin_draft("plain");
    draft.warp_colors.assign(static_cast<std::size_t>(draft.ends), glm::vec3(1, 0, 0));
    draft.weft_colors.assign(static_cast<std::size_t>(draft.picks), glm::vec3(0, 0, 1));
    folder.write("colors.wif", wif_text(draft));
    const std::string file = (folder / "colors.wif").string();
    const auto says = [&](std::vector<std::pair<std::string, std::string>> words,
                          std::string_view text) {
        words.emplace_back("weave", file);
        for (const std::string& warning : scene_with(words).warnings)
            if (warning.find(text) != std::string::npos) return true;
        return false;
    };
    EXPECT_TRUE(says({{"metal", "gold"}},
                     "metal: every yarn is of this metal: the colors of the "
                     "draft are not drawn (--metal none draws them)"));
    EXPECT_FALSE(says({{"metal", "none"}}, "metal:"));
    EXPECT_TRUE(says({{"base_color", "1,0,0"}}, "base_color: the yarns have colors of their own"));
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
