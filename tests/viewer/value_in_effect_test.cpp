// What panels and scripts say of a parameter is what is drawn, whoever states it.
#include "viewer/document/value_in_effect.hpp"

#include <gtest/gtest.h>

#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "scene/material/material_values.hpp"
#include "viewer/document/load_stage.hpp"
#include "viewer/viewer_support.hpp"

namespace burnish::viewer {
namespace {

using test::ScratchFolder;
using test::two_materials;

class ValueInEffectTest : public testing::Test {
  protected:
    // A scene file with one object, and these parameters.
    std::string scene(const std::string& name, const std::string& model,
                      const std::string& parameters) {
        return folder_
            .write(name, R"({"format": "burnish-scene", "version": 1, "objects": [{"model": ")" +
                             model + R"("}], "environment": "none", "parameters": )" + parameters +
                             "}")
            .string();
    }
    void show(Document document) {
        document_ = std::move(document);
        if (document_.environment.empty()) document_.environment = "none";
        stage_ = load_stage(document_);
    }
    ValueInEffect now(std::string_view name, std::optional<int> material = std::nullopt) const {
        return value_in_effect(document_, stage_, name, material);
    }
    std::string text(std::string_view name, std::optional<int> material = std::nullopt) const {
        const auto value = now(name, material).value;
        return value ? text_of(*find_parameter(name), *value) : "no value";
    }

    ScratchFolder folder_;
    Document document_;
    Stage stage_;
};

TEST_F(ValueInEffectTest, OfASceneFileIsWhatTheFileSays) {
    show({.input = scene("brushed.json", "builtin:sphere",
                         R"({"metal": "copper", "scratch": "fine-random", "samples": 8,
                             "alpha_x": 0.3, "alpha_y": 0.1, "exposure": 0.5})")});
    EXPECT_EQ(text("metal"), "copper");
    EXPECT_EQ(text("scratch"), "fine-random");
    EXPECT_EQ(text("samples"), "8");
    EXPECT_EQ(text("alpha_x"), "0.3");
    EXPECT_EQ(text("exposure"), "0.5");
    EXPECT_EQ(text("weave"), "none");
    EXPECT_EQ(text("normal_map"), "none") << "its normals are those of the scratches";
    for (const char* name : {"metal", "scratch", "samples", "alpha_x", "exposure"})
        EXPECT_FALSE(now(name).set_here) << name << " is the file's";
    Document changed = document_;
    set_parameter(changed, "alpha_x", 0.2);
    set_parameter(changed, "samples", 4);
    show(changed);
    EXPECT_TRUE(now("alpha_x").set_here);
    EXPECT_EQ(text("alpha_x"), "0.2");
    EXPECT_EQ(text("alpha_y"), "0.1") << "the file's half of the pair";
    EXPECT_EQ(text("samples"), "4");
}

TEST_F(ValueInEffectTest, OfAModelIsWhatItsMaterialHas) {
    show({.input = two_materials(folder_, "two.glb", false, true).string()});
    // Alphas are the square of glTF's roughness: 0.3 of brass, 0.8 of oak.
    EXPECT_EQ(text("roughness", 0), "0.3");
    EXPECT_EQ(text("alpha_x", 0), "0.09");
    EXPECT_EQ(text("alpha_y", 1), "0.64");
    EXPECT_EQ(text("metallic", 0), "1");
    EXPECT_EQ(text("metallic", 1), "0");
    EXPECT_EQ(text("metal", 0), "none");
    EXPECT_TRUE(materials_differ(stage_, *find_parameter("roughness")));
    EXPECT_FALSE(materials_differ(stage_, *find_parameter("f0")));
    // The camera of the file, and not the table's.
    EXPECT_NEAR(std::get<double>(*now("camera_fov").value), glm::degrees(0.7), 1e-4);
    EXPECT_EQ(std::get<glm::vec3>(*now("camera_position").value), glm::vec3(0.2f, 0.4f, 4.0f));
    Document changed = document_;
    set_parameter(changed, "roughness", 0.5, 1);
    show(changed);
    EXPECT_TRUE(now("roughness", 1).set_here);
    EXPECT_EQ(text("roughness", 1), "0.5");
    EXPECT_FALSE(now("roughness").set_here);
}

TEST_F(ValueInEffectTest, OfClothIsThatOfItsYarns) {
    show({.input = "builtin:drape"});
    const Cloth* cloth = cloth_of(stage_.scene.materials.at(0));
    if (cloth == nullptr) {
        Document woven = document_;
        set_parameter_text(woven, "weave", "satin-5");
        show(woven);
        cloth = cloth_of(stage_.scene.materials.at(0));
    }
    ASSERT_NE(cloth, nullptr);
    EXPECT_EQ(text("weave"), cloth->draft->name);
    EXPECT_EQ(static_cast<float>(std::get<double>(*now("weave_yarns").value)), cloth->yarns);
    EXPECT_EQ(static_cast<float>(std::get<double>(*now("alpha_x").value)), cloth->alpha.x);
}

// Names of files and switches that exclude others say more than their value: "scratch none" takes a normal
// map away, physical_size a uv_scale, and "metal none" the reflectance of a weave. What belongs to another
// parameter takes the place of a normal map. One number of a pair that has two widths, or two of glTF's,
// gives the lobe one width.
bool says_more(const Parameter& p, const Material& m) {
    const glm::vec2 pair = alpha_of(m);
    const bool gltf = gltf_lobe_of(m) != nullptr;
    const bool of_gltf = p.name == "roughness" || p.name == "anisotropy";
    const bool of_pair = p.name.starts_with("alpha_") || p.name.starts_with("e_");
    return p.kind == ParameterKind::text || p.name == "physical_size" ||
           (p.belongs_to != "" && cloth_of(m) == nullptr) || p.belongs_to == "height_map" ||
           p.belongs_to == "scratch" || (p.name == "metal" && cloth_of(m) != nullptr) ||
           (p.name == "anisotropy" && !gltf) ||
           (pair.x != pair.y &&
            ((of_gltf && !gltf) || (of_pair && gltf) || p.name == "cosine_exponent"));
}

void expect_same_look(const Material& a, const Material& b) {
    // Alphas go through exponents and roots of six digits.
    EXPECT_NEAR(alpha_of(a).x, alpha_of(b).x, 1e-5f);
    EXPECT_NEAR(alpha_of(a).y, alpha_of(b).y, 1e-5f);
    // Degrees with six digits.
    EXPECT_NEAR(a.anisotropy_rotation, b.anisotropy_rotation, 1e-6f);
    Material x = a, y = b;
    for (Material* m : {&x, &y}) {
        if (auto* cloth = std::get_if<Cloth>(&m->lobe)) {
            EXPECT_NEAR(cloth->twist, cloth_of(a)->twist, 1e-6f);
            cloth->twist = 0;
            cloth->alpha = {};
            cloth->draft = nullptr;  // each stage reads its own
        } else {
            m->lobe = GltfLobe{};
        }
        m->anisotropy_rotation = 0;
    }
    EXPECT_TRUE(x == y);
}

TEST_F(ValueInEffectTest, SettingAParameterToItChangesNothingThatIsDrawn) {
    const std::string inputs[] = {
        "builtin:sphere",
        "builtin:drape",
        two_materials(folder_, "two.glb").string(),
        scene("pair.json", "builtin:plane",
              R"({"alpha_x": 0.35, "alpha_y": 0.12, "metal": "gold", "normal_map": "builtin:bumps",
                  "normal_scale": 0.7, "uv_scale": 3, "anisotropy_rotation": 30, "samples": 7,
                  "brdf": "phong", "method": "gram-schmidt", "environment_intensity": 1.7})"),
        scene("gltf.json", "builtin:plane",
              R"({"roughness": 0.4, "anisotropy": 0.6, "base_color": [0.2, 0.3, 0.4],
                  "metallic": 0.25, "background": "color", "seed": 5})"),
        scene("cloth.json", "builtin:plane",
              R"({"weave": "twill-2-2", "weave_twist": 12, "warp_color": [0.4, 0.1, 0.1]})")};
    int compared = 0;
    for (const std::string& input : inputs) {
        show({.input = input});
        const Document before = document_;
        const Stage drawn = stage_;
        for (const Parameter& p : parameter_table()) {
            if (p.group == ParameterGroup::camera || p.group == ParameterGroup::mesh) continue;
            const bool material = p.group == ParameterGroup::material;
            const Material& first = drawn.scene.materials.at(0);
            const auto index = material ? std::optional<int>(0) : std::nullopt;
            const auto value = value_in_effect(before, drawn, p.name, index).value;
            if (!value || says_more(p, first)) continue;
            SCOPED_TRACE(input + " " + std::string(p.name) + " " + text_of(p, *value));
            Document set = before;
            set_parameter(set, p.name, *value, index);
            show(set);
            EXPECT_EQ(now(p.name, index).value, value);
            EXPECT_TRUE(stage_.settings == drawn.settings);
            expect_same_look(stage_.scene.materials.at(0), first);
            ++compared;
        }
    }
    EXPECT_GT(compared, 150);
}

TEST_F(ValueInEffectTest, WhereANumberIsNotStatedAPersonBeginsWithTheLookThatThereIs) {
    show({.input = scene("a.json", "builtin:plane", R"({"roughness": 0.5, "anisotropy": 0.3})")});
    const auto start = [&](std::string_view name) {
        return std::get<double>(start_value(document_, stage_, *find_parameter(name)));
    };
    // KHR_materials_anisotropy: alpha = roughness^2 across, mix(alpha, 1, strength^2) along.
    EXPECT_NEAR(start("alpha_y"), 0.25, 1e-6);
    EXPECT_NEAR(start("alpha_x"), 0.25 + 0.75 * 0.09, 1e-6);
    EXPECT_NEAR(start("e_y"), 2 / 0.0625 - 2, 1e-4);
    // Grooves along the tangent are no pair of glTF's: a round lobe of the same area stands for them.
    show({.input = scene("b.json", "builtin:plane", R"({"alpha_x": 0.1, "alpha_y": 0.4})")});
    EXPECT_EQ(now("roughness").value, std::nullopt);
    EXPECT_NEAR(start("roughness"), std::sqrt(0.2), 1e-6);
    // Where ks is left out, phong's is (n + 1) / (2 pi).
    show(
        {.input = scene("c.json", "builtin:plane", R"({"cosine_exponent": 50, "brdf": "phong"})")});
    EXPECT_NEAR(start("ks"), 51 / 6.283185307, 1e-3);
    EXPECT_THROW(now("alhpa_x"), UsageError);
}

}  // namespace
}  // namespace burnish::viewer
