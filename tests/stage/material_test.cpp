// What is drawn of a material, and what is said of its normal map.
#include <glm/geometric.hpp>
#include <span>

#include "formats/load_model.hpp"
#include "stage/material_parameters.hpp"
#include "stage/normal_map_check.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

using namespace test;

TEST(DrawnMethod, NormalMapIsARotationWhereNothingIsAnisotropic) {
    Material m;
    m.method = Method::normal_map;
    EXPECT_EQ(drawn_method(m), Method::gram_schmidt);
    m.anisotropy_strength = 0.3f;
    EXPECT_EQ(drawn_method(m), Method::normal_map);
    m.alpha = glm::vec2(0.2f, 0.2f);  // hides the strength
    EXPECT_EQ(drawn_method(m), Method::gram_schmidt);
    m.alpha = glm::vec2(0.2f, 0.21f);
    EXPECT_EQ(drawn_method(m), Method::normal_map);
    m.alpha = glm::vec2(0.2f, 0.2f);
    m.anisotropy_texture.texture = 0;
    EXPECT_EQ(drawn_method(m), Method::normal_map);
}

TEST(DrawnMethod, OtherMethodsStay) {
    Material m;
    for (int method = 0; method <= static_cast<int>(Method::deform_smooth); ++method) {
        m.method = static_cast<Method>(method);
        if (m.method == Method::normal_map) continue;
        EXPECT_EQ(drawn_method(m), m.method);
    }
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
    // 45 degrees to both sides, and black padding beside.
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

}  // namespace
}  // namespace burnish
