// Values of a scene file below those of flags: which values flags replace, and the source that an
// error names.
#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>

#include "burnish/conductors.hpp"
#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/layered_materials.hpp"
#include "burnish/scene_file.hpp"
#include "support/paths.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {
namespace {

using Words = std::vector<std::pair<const char*, std::string>>;

ParameterValues values_of(const Words& words) {
    ParameterValues values;
    for (const auto& [name, text] : words) values.set(name, text, "");
    return values;
}

// A material under the values of the file and the flags; by default the default material.
Material material_of(const Words& file, const Words& flags, Material base = {}) {
    Scene scene;
    LayeredMaterials materials({base}, {{values_of(file), "s.json: objects[0]"}});
    materials.apply(scene, values_of(flags));
    return scene.materials.at(0);
}

TEST(LayersOfValues, HalfOfAPairKeepsTheOtherHalf) {
    const auto alpha = [](const Words& file, const Words& flags) {
        return stated_alpha(material_of(file, flags)).value();
    };
    EXPECT_EQ(alpha({{"alpha_x", "0.1"}, {"alpha_y", "0.3"}}, {{"alpha_x", "0.2"}}),
              glm::vec2(0.2f, 0.3f));
    EXPECT_EQ(alpha({{"alpha_x", "0.1"}}, {{"alpha_y", "0.2"}}), glm::vec2(0.1f, 0.2f));
    // A single half sets both, in the file and after a flag has replaced it.
    EXPECT_EQ(alpha({{"alpha_x", "0.1"}}, {{"alpha_x", "0.2"}}), glm::vec2(0.2f));
    EXPECT_EQ(alpha({{"e_x", "198"}}, {{"alpha_x", "0.2"}}), glm::vec2(0.2f));
    // alpha = sqrt(2 / (e + 2)): 198 is 0.1.
    EXPECT_EQ(alpha({{"e_x", "198"}, {"e_y", "198"}}, {{"alpha_x", "0.2"}}), glm::vec2(0.2f, 0.1f));
    EXPECT_EQ(alpha({{"alpha_x", "0.25"}, {"alpha_y", "0.3"}}, {{"e_y", "198"}}),
              glm::vec2(0.25f, 0.1f));
    EXPECT_EQ(alpha({{"weave", "plain"}}, {{"alpha_x", "0.3"}}), glm::vec2(0.3f, 0.45f));
    EXPECT_EQ(alpha({{"roughness", "0.5"}}, {{"alpha_x", "0.3"}}), glm::vec2(0.3f));
    EXPECT_EQ(alpha({{"alpha_x", "0.1"}, {"alpha_y", "0.3"}}, {{"cosine_exponent", "49.5"}}),
              glm::vec2(0.1f));
}

TEST(LayersOfValues, AMetalOfTheFlagsIsMetallic) {
    const Material gold = material_of({{"metallic", "0"}}, {{"metal", "gold"}});
    EXPECT_TRUE(gold.conductor);
    EXPECT_EQ(gold.metallic, 1.0f);
    EXPECT_EQ(material_of({{"metal", "gold"}}, {{"metallic", "0.5"}}).metallic, 0.5f);
    // Values of one layer combine: both apply.
    EXPECT_EQ(material_of({{"metallic", "0"}, {"metal", "gold"}}, {}).metallic, 0.0f);
}

// As the yarns of a weave under another draft, a film stays on another metal, but not on one whose oxide
// is not known.
TEST(LayersOfValues, AFilmLiesOnTheMetalOfItsLayer) {
    const auto film = [](const Words& file, const Words& flags, Material base = {}) {
        const Material m = material_of(file, flags, std::move(base));
        return m.conductor && m.conductor->oxide ? m.conductor->oxide->thickness_nm : 0.0f;
    };
    EXPECT_EQ(film({{"metal", "titanium"}, {"oxide", "50"}}, {}), 50.0f);
    EXPECT_EQ(film({{"metal", "titanium"}}, {{"oxide", "50"}}), 50.0f);
    EXPECT_EQ(film({{"metal", "titanium"}, {"oxide", "50"}}, {{"oxide", "0"}}), 0.0f);
    EXPECT_EQ(film({{"metal", "titanium"}, {"oxide", "50"}}, {{"metal", "gold"}}), 0.0f);
    EXPECT_EQ(film({{"metal", "titanium"}, {"oxide", "50"}}, {{"metal", "iron"}}), 50.0f);
    EXPECT_EQ(film({{"metal", "titanium"}, {"oxide", "50"}}, {{"metal", "none"}}), 0.0f);
    EXPECT_EQ(film({{"metal", "titanium"}, {"oxide", "50"}}, {{"weave", "plain"}}), 0.0f);
    EXPECT_EQ(film({}, {{"oxide", "50"}}), 0.0f) << "no metal";
    // A model's own metal, told by its numbers.
    Material base;
    base.conductor = conductor_preset("iron");
    EXPECT_EQ(film({}, {{"oxide", "60"}}, base), 60.0f);
    base.conductor->oxide = oxide_film("iron", 40);
    EXPECT_EQ(film({}, {}, base), 40.0f);
    EXPECT_EQ(film({}, {{"oxide", "0"}}, base), 0.0f);
    EXPECT_EQ(film({}, {{"metal", "iron"}}, base), 0.0f);
}

TEST(LayersOfValues, AFilmNeedsAMetalWhoseOxideIsKnown) {
    EXPECT_THROW(material_of({}, {{"metal", "gold"}, {"oxide", "50"}}), UsageError);
    EXPECT_NO_THROW(material_of({}, {{"metal", "gold"}, {"oxide", "0"}}));
    Material unknown;
    unknown.conductor = Conductor{{0.5f, 1.0f, 1.5f}, {3.0f, 3.0f, 3.0f}};
    EXPECT_THROW(material_of({}, {{"oxide", "50"}}, unknown), UsageError);
}

TEST(LayersOfValues, NumbersOfTheFilesMapAreNotThoseOfTheFlags) {
    const Words file = {{"normal_map", "builtin:bumps"},
                        {"normal_scale", "2"},
                        {"uv_scale", "4"},
                        {"flip_green", "true"}};
    Material m = material_of(file, {{"normal_map", "builtin:bumps"}});
    EXPECT_EQ(m.normal_scale, 1.0f);
    EXPECT_EQ(m.normal_texture.transform[0][0], 1.0f);
    EXPECT_FALSE(m.flip_green);
    m = material_of(file, {{"normal_scale", "3"}});
    EXPECT_EQ(m.normal_scale, 3.0f);
    EXPECT_EQ(m.normal_texture.transform[0][0], 4.0f);
    EXPECT_TRUE(m.flip_green);
}

TEST(LayersOfValues, AWeaveOfTheFlagsIsNoneOfTheFilesMetal) {
    const Words file = {{"metal", "steel"}, {"roughness", "0.6"}};
    const Material m = material_of(file, {{"weave", "plain"}});
    EXPECT_FALSE(m.conductor);
    EXPECT_EQ(m.metallic, 0.0f);
    EXPECT_EQ(cloth_of(m)->alpha, Cloth{}.alpha);
    // The roughness of the file's cloth stays when a flag changes the draft.
    const Material other =
        material_of({{"weave", "plain"}, {"roughness", "0.5"}}, {{"weave", "satin-5"}});
    EXPECT_EQ(cloth_of(other)->alpha, glm::vec2(0.25f));
}

// A flag undoes every effect of the file's value.
TEST(LayersOfValues, WhatAFlagReplacesLeavesNothing) {
    Material base;
    base.metallic = 0.6f;
    base.lobe = GltfLobe{0.3f, 0.2f};
    base.anisotropy_rotation = 0.4f;
    const ScratchFolder folder;
    std::filesystem::create_directory(folder / "map");
    for (const char* name : {"map/normal.png", "map/anisotropy.png"})
        write_image(folder / name, Image(4, 4, 3, 0.5f), {});
    const std::string map = (folder / "map").string();
    EXPECT_EQ(material_of({{"weave", "plain"}}, {{"normal_map", "none"}, {"weave", "none"}}, base),
              base);
    EXPECT_EQ(material_of({{"weave", "plain"}, {"weave_gap", "0.2"}}, {{"weave", "none"}}, base),
              base);
    EXPECT_EQ(material_of({{"metal", "gold"}}, {{"metal", "none"}}, base), base);
    const Words follow = {{"scratch", map}, {"scratch_direction", "follow"}};
    EXPECT_TRUE(material_of(follow, {}, base).anisotropy_texture);
    EXPECT_EQ(material_of(follow, {{"normal_map", "none"}}, base), base);
    // The rotation follows the final roughness pair.
    Words pair = follow;
    pair.insert(pair.end(), {{"alpha_x", "0.1"}, {"alpha_y", "0.4"}});
    EXPECT_FLOAT_EQ(material_of(pair, {}).anisotropy_rotation, glm::radians(90.0f));
    EXPECT_EQ(material_of(pair, {{"alpha_x", "0.5"}}).anisotropy_rotation, 0.0f);
}

TEST(LayersOfValues, FaultsOfTheFileNameItsPlace) {
    const auto line = [](const Words& file, const Words& flags) {
        return error_line([&] { material_of(file, flags); });
    };
    EXPECT_EQ(line({{"normal_map", "no.png"}}, {}).find("s.json: objects[0]: no.png"), 0u);
    EXPECT_EQ(line({{"brdf", "phong"}, {"method", "deform-smooth"}}, {}).find("s.json: "), 0u);
    EXPECT_EQ(error_line<UsageError>([] {
                  material_of({{"brdf", "phong"}}, {{"method", "deform-smooth"}});
              }).find("method: "),
              0u);
    try {
        material_of({{"normal_map", "builtin:bump"}}, {});
        ADD_FAILURE() << "accepted";
    } catch (const UsageError& error) {
        ADD_FAILURE() << "not the command's: " << error.what();
    } catch (const Error&) {
    }
}

// An example file, through the reader and the parameters.
TEST(LayersOfValues, TheExampleIsWhatItSays) {
    SceneFile file = load_scene_file(source_folder() / "examples/scenes/brushed_cup.json");
    LayeredMaterials materials(file.scene.materials, file.layers);
    EXPECT_TRUE(materials.apply(file.scene, {}).warnings.empty());
    ASSERT_EQ(file.scene.materials.size(), 2u);
    const Material &copper = file.scene.materials[0], &steel = file.scene.materials[1];
    EXPECT_EQ(copper.name, "turned copper");
    EXPECT_EQ(copper.lobe, MaterialLobe(AlphaLobe{{0.08f, 0.35f}}));
    EXPECT_TRUE(copper.conductor);
    EXPECT_EQ(steel.mdf, Mdf::ashikhmin_shirley);
    EXPECT_EQ(steel.normal_scale, 0.4f);
    EXPECT_EQ(file.scene.textures.at(static_cast<std::size_t>(steel.normal_texture.texture)).name,
              "builtin:bumps");
}

// The examples of coats: brushed brass under lacquer with a linen shade, and dyed oxide on aluminum.
TEST(LayersOfValues, TheExamplesOfCoatsAreWhatTheySay) {
    SceneFile lamp = load_scene_file(source_folder() / "examples/scenes/lacquered_lamp.json");
    LayeredMaterials of_lamp(lamp.scene.materials, lamp.layers);
    EXPECT_TRUE(of_lamp.apply(lamp.scene, {}).warnings.empty());
    const Material &brass = lamp.scene.materials.front(), &linen = lamp.scene.materials.back();
    EXPECT_EQ(brass.coat.strength, 1.0f);
    EXPECT_EQ(brass.lobe, MaterialLobe(AlphaLobe{{0.08f, 0.34f}}));
    EXPECT_EQ(brass.method, Method::follow_grain);
    EXPECT_TRUE(brass.conductor && brass.normal_texture && !brass.coat.normal_texture);
    EXPECT_TRUE(cloth_of(linen) && has_sheen(linen) && !has_coat(linen));
    SceneFile discs = load_scene_file(source_folder() / "examples/scenes/anodized_discs.json");
    LayeredMaterials of_discs(discs.scene.materials, discs.layers);
    EXPECT_TRUE(of_discs.apply(discs.scene, {}).warnings.empty());
    ASSERT_EQ(discs.scene.materials.size(), 3u);
    for (const Material& m : discs.scene.materials) {
        EXPECT_TRUE(m.conductor && has_coat(m));
        EXPECT_LT(m.coat.tint.x * m.coat.tint.y * m.coat.tint.z, 0.1f) << "dyed";
    }
}

// One model with several sets of parameters: each has its own values, and a map is read once.
TEST(LayersOfValues, ManyObjectsOfAFile) {
    const ScratchFolder folder;
    const auto path = folder.write("s.json", R"({"format": "burnish-scene", "version": 1,
        "objects": [{"model": "builtin:plane"}, {"model": "builtin:plane", "material": "a"},
                    {"model": "builtin:plane", "material": "b"}],
        "materials": {"a": {"mdf": "ward"}, "b": {"alpha_x": 0.2, "normal_map": "builtin:bumps"}},
        "parameters": {"mdf": "beckmann", "roughness": 0.5, "triangles": 2,
                       "normal_map": "builtin:bumps"}})");
    SceneFile file = load_scene_file(path);
    LayeredMaterials materials(file.scene.materials, file.layers);
    materials.apply(file.scene, {});
    EXPECT_EQ(file.scene.textures.size(), 1u);
    ASSERT_EQ(file.scene.materials.size(), 3u);
    const auto& m = file.scene.materials;
    EXPECT_EQ(m[0].mdf, Mdf::beckmann);
    EXPECT_EQ(m[1].mdf, Mdf::ward);
    EXPECT_EQ(m[1].lobe, MaterialLobe(GltfLobe{0.5f}));
    EXPECT_EQ(m[2].lobe, MaterialLobe(AlphaLobe{glm::vec2(0.2f)}));
    materials.apply(file.scene, values_of({{"mdf", "ggx"}}));
    for (const Material& material : file.scene.materials) EXPECT_EQ(material.mdf, Mdf::ggx);
}

}  // namespace
}  // namespace burnish::test
