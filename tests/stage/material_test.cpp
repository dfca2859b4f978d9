// The drawn form of a material, and the warnings about its normal map.
#include <glm/geometric.hpp>
#include <span>

#include "burnish/layered_materials.hpp"
#include "burnish/load_model.hpp"
#include "scene/material/texture_uses.hpp"
#include "stage/normal_map_check.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

using namespace test;

TEST(DrawnMethod, NormalMapIsARotationWhereNothingIsAnisotropic) {
    Material m;
    m.method = Method::normal_map;
    EXPECT_EQ(drawn_method(m), Method::gram_schmidt);
    m.lobe = GltfLobe{0.5f, 0.3f};
    EXPECT_EQ(drawn_method(m), Method::normal_map);
    m.lobe = AlphaLobe{{0.2f, 0.2f}};
    EXPECT_EQ(drawn_method(m), Method::gram_schmidt);
    m.lobe = AlphaLobe{{0.2f, 0.21f}};
    EXPECT_EQ(drawn_method(m), Method::normal_map);
    m.lobe = AlphaLobe{{0.2f, 0.2f}};
    m.anisotropy_texture.texture = 0;
    EXPECT_EQ(drawn_method(m), Method::normal_map);
    Cloth cloth;
    cloth.alpha = {0.2f, 0.2f};
    m.lobe = cloth;
    EXPECT_EQ(drawn_method(m), Method::gram_schmidt) << "cloth reads no anisotropy texture";
    m.lobe = Tabulated{};
    EXPECT_EQ(drawn_method(m), Method::normal_map);
}

TEST(DrawnMethod, OtherMethodsStay) {
    Material m;
    for (int method = 0; method <= static_cast<int>(Method::stretch); ++method) {
        m.method = static_cast<Method>(method);
        if (m.method == Method::normal_map) continue;
        EXPECT_EQ(drawn_method(m), m.method);
    }
}

// Every member that a kind of lobe does not read is neutral in the drawn material.
TEST(DrawnMaterial, IsWhatTheLobeReads) {
    Material all;
    all.base_color = {0.1f, 0.2f, 0.3f, 0.4f};
    all.metallic = 0.7f;
    all.conductor = Conductor{{0.2f, 0.5f, 1.4f}, {3.9f, 2.4f, 1.6f}};
    all.mdf = Mdf::ward;
    all.brdf = Brdf::phong;
    all.specular = 0.5f;
    all.coat.strength = 0.5f;
    all.sheen.color = glm::vec3(0.5f);
    int texture = 0;
    for (TextureUse* use : texture_uses(all)) use->texture = texture++;
    for (const MaterialLobe& lobe : {MaterialLobe(GltfLobe{}), MaterialLobe(AlphaLobe{})}) {
        all.lobe = lobe;
        EXPECT_EQ(drawn_material(all), all);
    }
    all.lobe = Cloth{};
    Material cloth = drawn_material(all);
    EXPECT_EQ(drawn_material(cloth), cloth);
    EXPECT_FALSE(cloth.normal_texture || cloth.anisotropy_texture ||
                 cloth.metallic_roughness_texture);
    cloth.normal_texture = all.normal_texture;
    cloth.anisotropy_texture = all.anisotropy_texture;
    cloth.metallic_roughness_texture = all.metallic_roughness_texture;
    EXPECT_EQ(cloth, all) << "nothing else changes";
    all.lobe = Tabulated{};
    const Material tabulated = drawn_material(all);
    EXPECT_EQ(drawn_material(tabulated), tabulated);
    EXPECT_EQ(tabulated.base_color, glm::vec4(1.0f, 1.0f, 1.0f, 0.4f));
    EXPECT_EQ(tabulated.metallic, 0.0f);
    EXPECT_FALSE(tabulated.conductor || tabulated.base_color_texture ||
                 tabulated.anisotropy_texture || tabulated.metallic_roughness_texture);
    EXPECT_EQ(tabulated.mdf, Mdf::ggx);
    EXPECT_EQ(tabulated.brdf, Brdf::microfacet_separable);
    EXPECT_EQ(tabulated.normal_texture, all.normal_texture);
    EXPECT_EQ(tabulated.coat, all.coat);
    EXPECT_EQ(tabulated.sheen, all.sheen);
    EXPECT_FALSE(has_specular_factors(tabulated));
    all.coat.strength = 0.0f;
    all.sheen.color = glm::vec3(0.0f);
    EXPECT_EQ(drawn_material(all).coat, Coat{}) << "its textures are not read";
    EXPECT_EQ(drawn_material(all).sheen, Sheen{});
    EXPECT_EQ(tabulated.emissive_texture, all.emissive_texture);
}

Scene scene_with(std::vector<std::uint8_t> texels, int width, int channels) {
    Scene scene;
    Texture texture;
    texture.name = "map.png";
    texture.width = width;
    texture.height = 1;
    texture.channels = channels;
    const auto bytes = std::as_bytes(std::span(texels));
    texture.texels.assign(bytes.begin(), bytes.end());
    scene.textures.push_back(texture);
    scene.materials.emplace_back().normal_texture.texture = 0;
    scene.materials.push_back(scene.materials[0]);
    return scene;
}

std::vector<std::string> warnings_of(std::vector<std::uint8_t> texels, int width, int channels) {
    Scene scene = scene_with(std::move(texels), width, channels);
    warn_of_odd_normal_maps(scene);
    return scene.warnings;
}

TEST(NormalMapCheck, TakesMapsThatLeanLittle) {
    EXPECT_TRUE(warnings_of({128, 128, 255, 128, 128, 255}, 2, 3).empty());
    // 45 degrees to both sides, next to black padding.
    EXPECT_TRUE(
        warnings_of({218, 128, 218, 37, 128, 218, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 5, 3).empty());
    EXPECT_TRUE(warnings_of({0, 0, 0}, 1, 3).empty());
    EXPECT_TRUE(warnings_of({128, 128, 255, 0}, 1, 4).empty());
    EXPECT_TRUE(warnings_of({128, 128}, 1, 2).empty()) << "two channels: z is what is left";
}

TEST(NormalMapCheck, WarnsOnceOfWhatIsNone) {
    const auto sideways = warnings_of({255, 128, 128}, 1, 3);
    ASSERT_EQ(sideways.size(), 1u) << "two materials, one map";
    EXPECT_NE(sideways[0].find("map.png does not look like a tangent-space normal map"),
              std::string::npos);
    EXPECT_NE(sideways[0].find("(1.00, 0.00, 0.00)"), std::string::npos) << sideways[0];
    EXPECT_EQ(warnings_of({128, 128, 128}, 1, 3).size(), 1u) << "a height map";
    EXPECT_EQ(warnings_of({240, 240, 240}, 1, 3).size(), 1u) << "a bright photograph";
    EXPECT_EQ(warnings_of({128, 255, 128, 128, 0, 128}, 2, 3).size(), 1u) << "object space";
    EXPECT_EQ(warnings_of({200, 180}, 2, 1).size(), 1u) << "gray, drawn as (g, g, g)";
}

TEST(NormalMapCheck, TakesTheBuiltInAndRealMaps) {
    Scene scene = load_model("builtin:plane");
    ParameterValues values;
    values.set("normal_map", "builtin:bumps", "");
    apply_material_parameters(scene, values);
    warn_of_odd_normal_maps(scene);
    EXPECT_TRUE(scene.warnings.empty());
    if (sample_data().empty()) GTEST_SKIP() << "SKIPPED: no sample data";
    const auto real = sample_data() / "textures/scratched_gold/Scratched_gold_01_1K_Normal.png";
    const auto height =
        sample_data() / "textures/scratched_gold/Scratched_gold_01_1K_Base_Color.png";
    values.set("normal_map", real.string(), "");
    apply_material_parameters(scene, values);
    warn_of_odd_normal_maps(scene);
    EXPECT_TRUE(scene.warnings.empty());
    values.set("normal_map", height.string(), "");
    apply_material_parameters(scene, values);
    warn_of_odd_normal_maps(scene);
    EXPECT_EQ(scene.warnings.size(), 1u);
}

TEST(NormalMaps, ADirectXMapIsToldByItsSlopes) {
    ParameterValues values;
    values.set("normal_map", "builtin:bumps", "--normal-map");
    const auto warnings = [&](bool flip) {
        Scene scene = load_model("builtin:plane", 0);
        if (flip) values.set("flip_green", "true", "--flip-green");
        apply_material_parameters(scene, values);
        warn_of_odd_normal_maps(scene);
        return scene.warnings;
    };
    EXPECT_TRUE(warnings(false).empty());
    const std::vector<std::string> lines = warnings(true);
    ASSERT_EQ(lines.size(), 1U);
    // It holds for a map that a folder calls DirectX too, where no flag was given.
    EXPECT_NE(lines.front().find("--flip-green=false draws it as OpenGL"), std::string::npos)
        << lines.front();
}

}  // namespace
}  // namespace burnish
