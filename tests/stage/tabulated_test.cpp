// `tabulated` as a parameter of materials: flags, scene files, the parameters that it replaces and
// those that replace it.
#include <gtest/gtest.h>

#include <string>

#include "burnish/layered_materials.hpp"
#include "burnish/load_model.hpp"
#include "burnish/tabulated_file.hpp"
#include "burnish/tabulated_material.hpp"
#include "support/bsdf_writer.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {
namespace {

// Writes a material of two texels with D = 1/pi.
void write_even(const std::filesystem::path& path) {
    TabulatedMaterial m;
    m.grid = {4, 8};
    m.exemplars = 1;
    m.D.assign(32, 0.31831F);
    m.origin.assign(32, NdfOrigin::measured);
    m.groove = {0.0F};
    m.width = 2;
    m.height = 1;
    m.exemplar = {0, 0};
    m.angle = {0.0F, 1.0F};
    m.diffuse = m.specular = m.normal = Image(2, 1, 3);
    m.normal.pixels[2] = m.normal.pixels[5] = 1;
    write_tabulated_material(path, m);
}

ParameterValues values_of(std::initializer_list<std::pair<const char*, std::string>> pairs) {
    ParameterValues values;
    for (const auto& [name, text] : pairs) values.set(name, text, "");
    return values;
}

class TabulatedParameter : public testing::Test {
  protected:
    TabulatedParameter() { write_even(folder / "even.exr"); }
    std::string file() const { return (folder / "even.exr").string(); }
    ScratchFolder folder;
};

TEST_F(TabulatedParameter, ReplacesLobeAndColors) {
    Scene scene = load_model("builtin:plane");
    apply_material_parameters(scene, values_of({{"tabulated", file()},
                                                {"method", "rotate-exact"},
                                                {"metal", "gold"},
                                                {"alpha_x", "0.1"},
                                                {"normal_map", "builtin:bumps"},
                                                {"uv_scale", "3"}}));
    const Material m = drawn_material(scene.materials[0]);
    ASSERT_TRUE(tabulated_of(m));
    EXPECT_EQ(tabulated_of(m)->material->texels(), 2U);
    EXPECT_EQ(tabulated_of(m)->file, file());
    EXPECT_FALSE(m.conductor);
    EXPECT_EQ(m.metallic, 0.0F);
    EXPECT_EQ(m.brdf, Brdf::microfacet_separable);
    EXPECT_EQ(m.method, Method::rotate_exact);
    EXPECT_TRUE(m.normal_texture);
    EXPECT_EQ(m.normal_texture.transform[0][0], 3.0F);
    std::string warnings;
    for (const std::string& line : scene.warnings) warnings += line + "\n";
    EXPECT_NE(warnings.find("alpha_x, metal"), std::string::npos) << warnings;
    // Later values keep the parameters that they do not set.
    apply_material_parameters(scene, values_of({{"method", "follow-grain"}}));
    EXPECT_TRUE(tabulated_of(scene.materials[0]));
    apply_material_parameters(scene, values_of({{"tabulated", "none"}}));
    EXPECT_FALSE(tabulated_of(scene.materials[0]));
}

TEST_F(TabulatedParameter, AWeaveTakesItsPlaceAndTheOtherWayRound) {
    Scene scene = load_model("builtin:plane");
    apply_material_parameters(scene, values_of({{"tabulated", file()}}));
    apply_material_parameters(scene, values_of({{"weave", "plain"}}));
    EXPECT_TRUE(cloth_of(scene.materials[0]));
    apply_material_parameters(scene, values_of({{"tabulated", file()}}));
    EXPECT_TRUE(tabulated_of(scene.materials[0]));
    const std::string line = error_line<UsageError>([&] {
        apply_material_parameters(scene, values_of({{"tabulated", file()}, {"weave", "plain"}}));
    });
    EXPECT_NE(line.find("tabulated"), std::string::npos) << line;
    ParameterValues values = values_of({{"weave", "plain"}});
    values.merge(values_of({{"tabulated", file()}}));
    EXPECT_FALSE(values.is_set("weave"));
}

TEST_F(TabulatedParameter, LiesBesideItsSceneFileAndIsReadOnce) {
    folder.write("s.json", R"({"format": "burnish-scene", "version": 1,
        "objects": [{"model": "builtin:plane", "material": "a"},
                    {"model": "builtin:sphere", "material": "a"}],
        "materials": {"a": {"tabulated": "even.exr"}}})");
    SceneFile read = load_scene_file(folder / "s.json");
    LayeredMaterials materials(read.scene.materials, read.layers);
    materials.apply(read.scene, {});
    ASSERT_EQ(read.scene.materials.size(), 2U);
    ASSERT_TRUE(tabulated_of(read.scene.materials[0]));
    EXPECT_EQ(tabulated_of(read.scene.materials[0])->material,
              tabulated_of(read.scene.materials[1])->material);
}

TEST_F(TabulatedParameter, OtherFilesAreRefused) {
    Scene scene = load_model("builtin:plane");
    folder.write("text.exr", "nothing");
    for (const char* name : {"text.exr", "missing.exr"}) {
        const std::string line = error_line([&] {
            apply_material_parameters(scene, values_of({{"tabulated", (folder / name).string()}}));
        });
        EXPECT_NE(line.find(name), std::string::npos) << line;
    }
    KnownMaterial known;
    folder.write("known.bsdf", known.text());
    apply_material_parameters(scene, values_of({{"tabulated", (folder / "known.bsdf").string()}}));
    EXPECT_EQ(tabulated_of(scene.materials[0])->material->exemplars, 1);
}

}  // namespace
}  // namespace burnish::test
