#include "burnish/parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "burnish/shading_names.hpp"
#include "core/text.hpp"
#include "image/image_io.hpp"
#include "models/conductors.hpp"
#include "stage/material_parameters.hpp"
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

TEST(ParameterTable, RowsAreSound) {
    std::set<std::string_view> names;
    for (const Parameter& p : parameter_table()) {
        SCOPED_TRACE(std::string(p.name));
        EXPECT_TRUE(names.insert(p.name).second) << "twice";
        EXPECT_EQ(p.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
                  std::string_view::npos);
        EXPECT_FALSE(p.help.empty());
        EXPECT_EQ(p.help.find('\n'), std::string_view::npos);
        EXPECT_EQ(p.kind == ParameterKind::choice, !p.choices.empty());
        EXPECT_LE(p.low, p.high);
        EXPECT_EQ(find_parameter(p.name), &p);
        ParameterValues values;
        EXPECT_FALSE(values.is_set(p.name));
        EXPECT_EQ(values.has_value(p.name), !p.default_text.empty());
        if (p.default_text.empty()) continue;
        EXPECT_NO_THROW(values.set(p.name, p.default_text, ""));
    }
}

TEST(ParameterTable, MetalsAreTheConductors) {
    const auto choices = find_parameter("metal")->choices;
    ASSERT_EQ(choices.size(), conductor_names().size() + 1);
    EXPECT_EQ(choices[0], "none");
    for (std::size_t i = 0; i < conductor_names().size(); ++i)
        EXPECT_EQ(choices[i + 1], conductor_names()[i]);
}

TEST(ParameterTable, DefaultsAreThoseOfMaterials) {
    const ParameterValues values;
    const Material material;
    EXPECT_EQ(static_cast<Mdf>(values.choice("mdf")), material.mdf);
    EXPECT_EQ(static_cast<Brdf>(values.choice("brdf")), material.brdf);
    EXPECT_EQ(static_cast<Method>(values.choice("method")), material.method);
    EXPECT_EQ(values.boolean("conserve"), material.conserve);
}

TEST(ParameterValues, KeepsWhatWasSet) {
    ParameterValues values;
    values.set("alpha_x", "0.25", "--alpha-x");
    values.set("exposure", "+1.5", "");
    values.set("width", "640", "");
    values.set("conserve", "on", "");
    values.set("method", "rotate-arc", "");
    values.set("camera_position", "1,-2.5,3e1", "");
    values.set("normal_map", "scratches.png", "");
    EXPECT_DOUBLE_EQ(values.real("alpha_x"), 0.25);
    EXPECT_DOUBLE_EQ(values.real("exposure"), 1.5);
    EXPECT_EQ(values.integer("width"), 640);
    EXPECT_TRUE(values.boolean("conserve"));
    EXPECT_EQ(static_cast<Method>(values.choice("method")), Method::rotate_arc);
    EXPECT_EQ(values.vec3("camera_position"), glm::vec3(1.0f, -2.5f, 30.0f));
    EXPECT_EQ(values.text("normal_map"), "scratches.png");
    EXPECT_EQ(values.set_values().size(), 7u);
}

TEST(ParameterValues, ColoursAreLinearOrSrgb) {
    ParameterValues values;
    values.set("base_color", "0.1,0.2,1", "");
    EXPECT_EQ(values.vec3("base_color"), glm::vec3(0.1f, 0.2f, 1.0f));
    values.set("base_color", "#80ff00", "");
    // IEC 61966-2-1 above its linear foot.
    EXPECT_NEAR(values.vec3("base_color").r, std::pow((128.0 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
    EXPECT_FLOAT_EQ(values.vec3("base_color").g, 1.0f);
    EXPECT_FLOAT_EQ(values.vec3("base_color").b, 0.0f);
}

TEST(ParameterValues, ErrorsNameAllFourThings) {
    ParameterValues values;
    const auto line = [&](const char* name, const char* text, const char* where) {
        return error_line<UsageError>([&] { values.set(name, text, where); });
    };
    EXPECT_EQ(line("alpha_x", "7", "--alpha-x"),
              "--alpha-x: expected a number from 0.001 to 1.5, found " + shown("7"));
    EXPECT_EQ(line("alpha_x", "7", ""),
              "--alpha-x: expected a number from 0.001 to 1.5, found " + shown("7"));
    EXPECT_EQ(
        line("alpha_x", "7", "a.json: materials.m.alpha_x"),
        "a.json: materials.m.alpha_x: expected a number from 0.001 to 1.5, found " + shown("7"));
    EXPECT_EQ(line("alpha_x", "7", "preset gold"),
              "preset gold: alpha_x: expected a number from 0.001 to 1.5, found " + shown("7"));
    EXPECT_NE(line("method", "folow-grain", "").find("did you mean 'follow-grain'?"),
              std::string::npos);
    EXPECT_EQ(line("alfa_x", "1", "a.json"),
              "a.json: unknown parameter " + shown("alfa_x") + "; did you mean 'alpha_x'?");
    EXPECT_EQ(line("colour of the sky", "1", ""),
              "unknown parameter " + shown("colour of the sky"));
    EXPECT_TRUE(values.set_values().empty()) << "a refused value was kept";
}

TEST(ParameterValues, RefusesEverythingThatIsNotTheValue) {
    const std::pair<const char*, std::vector<std::string>> bad[] = {
        {"alpha_x",
         {"", " 0.1", "0.1 ", "0,1", "nan", "inf", "-inf", "1e999", "0x1", "+-1", "--1", "+", "1f",
          "0.0009", "1.6", std::string("0.1\0", 4), std::string(100000, '1')}},
        {"width", {"", "0", "1.0", "1e2", "16385", "99999999999", "-5", "+5", "12px"}},
        {"conserve", {"", "maybe", "TRUE ", "2"}},
        {"mdf", {"", "GGX ", "Ggx2", "0"}},
        {"base_color",
         {"", "1", "1,1", "1,1,1,1", "1,,1", "2,0,0", "#12345", "#1234567", "#12345g", "#-12345",
          "#+12345", "nan,0,0", "0.1, 0.2,0.3"}},
        {"camera_target", {"#ffffff", "1,2", "1e7,0,0", "inf,0,0"}},
        {"normal_map", {"", std::string("a\0b", 3)}},
    };
    for (const auto& [name, texts] : bad) {
        for (const std::string& text : texts) {
            ParameterValues values;
            EXPECT_THROW(values.set(name, text, "here"), UsageError) << name << " " << text;
        }
    }
}

TEST(ParameterValues, AskingForWhatNobodySetIsAnError) {
    const ParameterValues values;
    EXPECT_THROW((void)values.real("alpha_x"), UsageError);
    EXPECT_THROW((void)values.real("no_such"), UsageError);
}

TEST(ParameterValues, TheLaterWinsAndReplacesOtherWaysOfSayingIt) {
    ParameterValues file, flags;
    file.set("alpha_x", "0.1", "");
    file.set("alpha_y", "0.3", "");
    file.set("width", "640", "");
    file.set("height", "480", "");
    flags.set("e_x", "100", "");
    flags.set("width", "320", "");
    file.merge(flags);
    EXPECT_FALSE(file.is_set("alpha_x"));
    EXPECT_FALSE(file.is_set("alpha_y"));
    EXPECT_DOUBLE_EQ(file.real("e_x"), 100.0);
    EXPECT_EQ(file.integer("width"), 320);
    EXPECT_EQ(file.integer("height"), 480);
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
        EXPECT_EQ(m.alpha.value(), glm::vec2(0.2f, 0.6f));
        EXPECT_NEAR(m.anisotropy_rotation, 1.5707963f, 1e-6f);
        EXPECT_EQ(m.base_color, glm::vec4(0.5f, 0.25f, 0.125f, 1.0f));
        EXPECT_FLOAT_EQ(m.dielectric_f0, 0.08f);
        EXPECT_TRUE(m.double_sided);
    }
}

TEST(MaterialParameters, RoughnessInThreeWays) {
    Scene scene = one_triangle(true);
    ParameterValues exponents;
    exponents.set("e_x", "0", "");
    exponents.set("e_y", "198", "");
    apply_material_parameters(scene, exponents);
    // e = 2 / alpha^2 - 2, so 0 is alpha 1 and 198 is alpha 0.1.
    EXPECT_NEAR(scene.materials[0].alpha->x, 1.0f, 1e-6f);
    EXPECT_NEAR(scene.materials[0].alpha->y, 0.1f, 1e-6f);

    ParameterValues one;
    one.set("alpha_x", "0.5", "");
    apply_material_parameters(scene, one);
    EXPECT_NEAR(scene.materials[0].alpha->y, 0.1f, 1e-6f) << "the other of a pair stays";

    ParameterValues gltf;
    gltf.set("roughness", "0.3", "");
    gltf.set("anisotropy", "0.7", "");
    apply_material_parameters(scene, gltf);
    EXPECT_FALSE(scene.materials[0].alpha.has_value()) << "a pair would hide the roughness";
    EXPECT_FLOAT_EQ(scene.materials[0].roughness, 0.3f);
    EXPECT_FLOAT_EQ(scene.materials[0].anisotropy_strength, 0.7f);

    apply_material_parameters(scene, one);
    EXPECT_EQ(scene.materials[0].alpha.value(), glm::vec2(0.5f)) << "one alone sets both";

    ParameterValues cosine;
    cosine.set("cosine_exponent", "49.5", "");
    apply_material_parameters(scene, cosine);
    EXPECT_NEAR(scene.materials[0].alpha->x, 0.1f, 1e-6f);
    EXPECT_NEAR(scene.materials[0].alpha->y, 0.1f, 1e-6f);
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

// What has no half vectors cannot be deformed, whether one call asks for it or two.
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

TEST(ParameterValues, ModelsThatAreNotDrawnSayWhatIs) {
    ParameterValues values;
    const auto line = [&](const char* text) {
        return error_line<UsageError>([&] { values.set("brdf", text, "--brdf"); });
    };
    EXPECT_NE(line("he").find("found " + shown("he") +
                              " (brdf eval computes it, no picture: cook-torrance is nearest)"),
              std::string::npos)
        << line("he");
    EXPECT_NE(line("ashikhmin-premoze-shirley").find("microfacet with mdf ashikhmin-shirley"),
              std::string::npos);
    EXPECT_NE(line("ggx").find("microfacet with mdf ggx"), std::string::npos);
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
    apply_material_parameters(scene, values);
    apply_material_parameters(scene, values);
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.textures[0].width, 4);
    EXPECT_EQ(scene.textures[0].color_space, ColorSpace::linear);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find(shown("bare")), std::string::npos);
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

// Linear RGB reflectances at normal incidence as tabulated for artists (Akenine-Moller et al. 2018,
// Real-Time Rendering, table 9.2), from whole spectra and other measurements, hence the tolerance;
// stainless steel is a nearly neutral 0.6.
TEST(Conductors, HaveTheColoursOfTheMetals) {
    const std::pair<const char*, glm::vec3> known[] = {
        {"gold", {1.000f, 0.782f, 0.344f}},     {"silver", {0.972f, 0.960f, 0.915f}},
        {"copper", {0.955f, 0.638f, 0.538f}},   {"aluminium", {0.913f, 0.922f, 0.924f}},
        {"titanium", {0.542f, 0.497f, 0.449f}}, {"brass", {0.910f, 0.778f, 0.423f}},
        {"steel", {0.60f, 0.59f, 0.57f}}};
    EXPECT_EQ(std::size(known), conductor_names().size());
    for (const auto& [name, color] : known) {
        const glm::vec3 found = normal_reflectance(conductor_preset(name));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], color[c], 0.1f) << name << " " << c;
    }
    EXPECT_THROW(conductor_preset("gould"), UsageError);
}

TEST(Names, NearestIsWhatWasMeant) {
    EXPECT_EQ(nearest_name(mdf_names(), "beckman"), "beckmann");
    EXPECT_EQ(nearest_name(mdf_names(), "GGX"), "ggx");
    EXPECT_EQ(nearest_name(brdf_names(), "ward_gdm"), "ward-gmd");
    EXPECT_EQ(nearest_name(method_names(), "smooth"), "deform-smooth");
    EXPECT_EQ(nearest_name(method_names(), "rotate-arch"), "rotate-arc");
    EXPECT_EQ(nearest_name(method_names(), "banana"), "");
    EXPECT_EQ(nearest_name(method_names(), ""), "");
    EXPECT_EQ(nearest_name(method_names(), std::string(1000000, 'r')), "");
    EXPECT_EQ(nearest_name({}, "ggx"), "");
}

TEST(Names, RoundTripAndError) {
    for (std::size_t i = 0; i < method_names().size(); ++i) {
        const auto method = static_cast<Method>(i);
        EXPECT_EQ(index_of_name(method_names(), name_of(method), "method", ""),
                  static_cast<int>(i));
    }
    EXPECT_EQ(name_of(Mdf::beckmann), "beckmann");
    EXPECT_EQ(name_of(Brdf::ward_gmd), "ward-gmd");
    EXPECT_EQ(error_line<UsageError>([] { index_of_name(mdf_names(), "gxx", "mdf", "--mdf"); }),
              "--mdf: unknown mdf " + shown("gxx") +
                  "; did you mean 'ggx'? known: ashikhmin-shirley ward "
                  "beckmann ggx");
}

}  // namespace
}  // namespace burnish
