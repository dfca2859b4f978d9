// Material parameters applied to the materials of a scene.
#include <gtest/gtest.h>

#include "burnish/image_io.hpp"
#include "burnish/layered_materials.hpp"
#include "burnish/shading_names.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

using test::error_line;

Scene one_triangle(bool with_coordinates) {
    Scene scene;
    Mesh mesh;
    mesh.name = "bare";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.tangents.assign(3, {1, 0, 0, 1});
    if (with_coordinates) mesh.texcoord0 = {{0, 0}, {1, 0}, {0, 1}};
    mesh.indices = {0, 1, 2};
    scene.meshes.push_back(mesh);
    scene.materials.resize(2);
    scene.instances = {{0, 0, glm::mat4(1.0f)}, {0, 1, glm::mat4(1.0f)}};
    return scene;
}

TEST(MaterialParameters, GoOntoEveryMaterial) {
    Scene scene = one_triangle(true);
    ParameterValues values;
    values.set("mdf", "ward", "");
    values.set("brdf", "ward-gmd", "");
    values.set("method", "deform-smooth", "");
    values.set("conserve", "true", "");
    values.set("alpha_x", "0.2", "");
    values.set("alpha_y", "0.6", "");
    values.set("anisotropy_rotation", "90", "");
    values.set("base_color", "0.5,0.25,0.125", "");
    values.set("f0", "0.08", "");
    values.set("double_sided", "true", "");
    apply_material_parameters(scene, values);
    for (const Material& m : scene.materials) {
        EXPECT_EQ(m.mdf, Mdf::ward);
        EXPECT_EQ(m.brdf, Brdf::ward_gmd);
        EXPECT_EQ(m.method, Method::deform_smooth);
        EXPECT_TRUE(m.conserve);
        EXPECT_EQ(m.lobe, MaterialLobe(AlphaLobe{{0.2f, 0.6f}}));
        EXPECT_NEAR(m.anisotropy_rotation, 1.5707963f, 1e-6f);
        EXPECT_EQ(m.base_color, glm::vec4(0.5f, 0.25f, 0.125f, 1.0f));
        EXPECT_FLOAT_EQ(m.dielectric_f0, 0.08f);
        EXPECT_TRUE(m.double_sided);
    }
}

TEST(MaterialParameters, LayersGoOntoEveryMaterial) {
    Scene scene = one_triangle(true);
    ParameterValues values;
    values.set("coat", "0.75", "");
    values.set("coat_roughness", "0.25", "");
    values.set("coat_tint", "0.5,0.25,0.125", "");
    values.set("coat_normal_map", "builtin:bumps", "");
    values.set("sheen_color", "0.25,0.5,0.125", "");
    values.set("sheen_roughness", "0.5", "");
    values.set("ior", "2", "");
    values.set("specular", "0.5", "");
    values.set("specular_color", "2,1,0.5", "");
    values.set("metallic", "0", "");
    values.set("uv_scale", "4", "");
    apply_material_parameters(scene, values);
    for (const Material& m : scene.materials) {
        EXPECT_EQ(m.coat.strength, 0.75f);
        EXPECT_EQ(m.coat.roughness, 0.25f);
        EXPECT_EQ(m.coat.tint, glm::vec3(0.5f, 0.25f, 0.125f));
        EXPECT_EQ(scene.textures.at(static_cast<std::size_t>(m.coat.normal_texture.texture)).name,
                  "builtin:bumps");
        EXPECT_EQ(m.coat.normal_texture.transform[0][0], 4.0f);
        EXPECT_FALSE(m.normal_texture) << "the surface below has bumps of its own";
        EXPECT_EQ(m.sheen.color, glm::vec3(0.25f, 0.5f, 0.125f));
        EXPECT_EQ(m.sheen.roughness, 0.5f);
        EXPECT_FLOAT_EQ(m.dielectric_f0, 1.0f / 9.0f);  // (2-1)^2/(2+1)^2
        EXPECT_EQ(m.specular, 0.5f);
        EXPECT_EQ(m.specular_color, glm::vec3(2.0f, 1.0f, 0.5f));
    }
}

TEST(MaterialParameters, CoatsThatNobodyHasAreRefused) {
    const std::pair<const char*, const char*> refused[] = {
        {"coat", "1.5"},          {"coat_roughness", "-0.1"}, {"coat_tint", "2,1,1"},
        {"sheen_color", "1,1,7"}, {"sheen_roughness", "nan"}, {"ior", "0.5"},
        {"specular", "2"}};
    for (const auto& row : refused)
        EXPECT_NE(
            error_line([&] { ParameterValues().set(row.first, row.second, ""); }).find("expected"),
            std::string::npos)
            << row.first;
    Scene scene = one_triangle(true);
    ParameterValues both;
    both.set("ior", "1.5", "");
    both.set("f0", "0.04", "");
    EXPECT_NE(error_line([&] { apply_material_parameters(scene, both); }).find("not both"),
              std::string::npos);
}

TEST(MaterialParameters, ALayerThatIsNotThereIsNamed) {
    Scene scene = one_triangle(true);
    ParameterValues values;
    values.set("coat_tint", "0.5,0.5,0.5", "");
    values.set("sheen_roughness", "0.5", "");
    apply_material_parameters(scene, values);
    const auto said = [&](const std::string& line) {
        return std::find(scene.warnings.begin(), scene.warnings.end(), line) !=
               scene.warnings.end();
    };
    EXPECT_TRUE(said("coat_tint: there is no coat (--coat 1): nothing changes"));
    EXPECT_TRUE(said("sheen_roughness: there is no sheen (--sheen-color): nothing changes"));
}

TEST(MaterialParameters, RoughnessInThreeWays) {
    Scene scene = one_triangle(true);
    ParameterValues exponents;
    exponents.set("e_x", "0", "");
    exponents.set("e_y", "198", "");
    apply_material_parameters(scene, exponents);
    // e = 2 / alpha^2 - 2: 0 is alpha 1 and 198 is alpha 0.1.
    EXPECT_NEAR(stated_alpha(scene.materials[0])->x, 1.0f, 1e-6f);
    EXPECT_NEAR(stated_alpha(scene.materials[0])->y, 0.1f, 1e-6f);

    ParameterValues one;
    one.set("alpha_x", "0.5", "");
    apply_material_parameters(scene, one);
    EXPECT_NEAR(stated_alpha(scene.materials[0])->y, 0.1f, 1e-6f) << "the other of a pair stays";

    ParameterValues gltf;
    gltf.set("roughness", "0.3", "");
    gltf.set("anisotropy", "0.7", "");
    apply_material_parameters(scene, gltf);
    EXPECT_EQ(scene.materials[0].lobe, MaterialLobe(GltfLobe{0.3f, 0.7f}));

    apply_material_parameters(scene, one);
    EXPECT_EQ(stated_alpha(scene.materials[0]), glm::vec2(0.5f)) << "one alone sets both";

    ParameterValues cosine;
    cosine.set("cosine_exponent", "49.5", "");
    apply_material_parameters(scene, cosine);
    EXPECT_NEAR(stated_alpha(scene.materials[0])->x, 0.1f, 1e-6f);
    EXPECT_NEAR(stated_alpha(scene.materials[0])->y, 0.1f, 1e-6f);
    cosine.merge(one);
    EXPECT_FALSE(cosine.is_set("cosine_exponent")) << "another way of saying it";

    ParameterValues both = one;
    both.set("e_y", "10", "");
    EXPECT_NE(
        error_line<UsageError>([&] { apply_material_parameters(scene, both); }).find("one pair"),
        std::string::npos);
}

TEST(MaterialParameters, CosineLobesHaveTheirOwn) {
    Scene scene = one_triangle(true);
    EXPECT_FALSE(scene.materials[0].ks.has_value()) << "as much as keeps the energy";
    ParameterValues values;
    const auto default_c = values.vec3("lafortune_c");
    EXPECT_EQ(default_c, scene.materials[0].lafortune_c);
    values.set("brdf", "lafortune", "");
    values.set("ks", "0.25", "");
    values.set("lafortune_c", "-1,-0.5,0.75", "");
    apply_material_parameters(scene, values);
    EXPECT_EQ(scene.materials[1].brdf, Brdf::lafortune);
    EXPECT_EQ(scene.materials[1].ks, 0.25f);
    EXPECT_EQ(scene.materials[1].lafortune_c, glm::vec3(-1.0f, -0.5f, 0.75f));
}

// Models without half vectors reject deformations, whether one call sets both or two calls.
TEST(MaterialParameters, DeformationsNeedHalfVectors) {
    for (const char* method : {"deform-linear", "deform-smooth"}) {
        Scene scene = one_triangle(true);
        ParameterValues values;
        values.set("method", method, "");
        apply_material_parameters(scene, values);
        ParameterValues later;
        later.set("brdf", "phong", "");
        EXPECT_EQ(error_line<UsageError>([&] { apply_material_parameters(scene, later); }),
                  "method: expected a rotation such as follow-grain for brdf phong, which has no "
                  "half vectors to deform, found " +
                      std::string(method));
        later.set("method", "rotate-approx", "");
        apply_material_parameters(scene, later);
        EXPECT_EQ(scene.materials[0].brdf, Brdf::phong);
    }
}

TEST(MaterialParameters, NormalMapIsReadOnce) {
    const test::ScratchFolder folder;
    const std::string path = (folder / "flat.png").string();
    Image flat(4, 4, 3, 0.5f);
    write_image(path, flat, {});
    Scene scene = one_triangle(false);
    ParameterValues values;
    values.set("normal_map", path, "");
    values.set("normal_scale", "2", "");
    values.set("flip_green", "true", "");
    values.set("uv_scale", "4", "");
    LayeredMaterials materials(scene.materials);
    materials.apply(scene, values);
    const std::vector<std::string> warnings = materials.apply(scene, values).warnings;
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.textures[0].width, 4);
    EXPECT_EQ(scene.textures[0].color_space, ColorSpace::linear);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find(shown("bare")), std::string::npos);
    for (const Material& m : scene.materials) {
        EXPECT_EQ(m.normal_texture.texture, 0);
        EXPECT_EQ(m.normal_texture.transform * glm::vec3(0.5f, 0.25f, 1.0f),
                  glm::vec3(2.0f, 1.0f, 1.0f));
        EXPECT_FLOAT_EQ(m.normal_scale, 2.0f);
        EXPECT_TRUE(m.flip_green);
    }
    ParameterValues none;
    none.set("normal_map", "none", "");
    apply_material_parameters(scene, none);
    EXPECT_FALSE(scene.materials[0].normal_texture);

    ParameterValues missing;
    missing.set("normal_map", (folder / "absent.png").string(), "");
    EXPECT_NE(error_line([&] { apply_material_parameters(scene, missing); }).find("absent.png"),
              std::string::npos);
    write_image(folder / "grey.png", Image(4, 4, 1, 0.5f), {});
    missing.set("normal_map", (folder / "grey.png").string(), "");
    EXPECT_NE(error_line([&] { apply_material_parameters(scene, missing); }).find("channels"),
              std::string::npos);
    missing.set("normal_map", "builtin:bump", "");
    EXPECT_THROW(apply_material_parameters(scene, missing), UsageError);
}

TEST(MaterialParameters, BuiltInBumps) {
    Scene scene = one_triangle(true);
    ParameterValues values;
    values.set("normal_map", "builtin:bumps", "");
    apply_material_parameters(scene, values);
    ASSERT_EQ(scene.textures.size(), 1u);
    const Texture& map = scene.textures[0];
    EXPECT_EQ(map.texels.size(),
              static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height) * 3 * 2);
    EXPECT_TRUE(scene.warnings.empty());
}

}  // namespace
}  // namespace burnish
