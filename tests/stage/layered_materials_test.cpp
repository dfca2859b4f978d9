// Materials are a pure function of the models' materials and the values: properties over the whole
// table.
#include "burnish/layered_materials.hpp"

#include <gtest/gtest.h>

#include <random>

#include "scene/material/texture_uses.hpp"
#include "stage/material_parameters.hpp"
#include "value_samples.hpp"

namespace burnish::test {
namespace {

class LayeredMaterialsTest : public testing::Test {
  protected:
    Scene scene_ = scene_of_all_lobes();
    const std::vector<Material> base_ = scene_.materials;
    const ValueSamples samples_;

    std::vector<Material> applied(LayeredMaterials& materials, const ParameterValues& values) {
        materials.apply(scene_, values);
        return scene_.materials;
    }

    // Applying values twice equals once, values in between leave no trace, and no values restore
    // the base.
    void expect_pure(const ParameterValues& values, const ParameterValues& between) {
        LayeredMaterials materials(base_);
        const std::vector<Material> once = applied(materials, values);
        const std::size_t textures = scene_.textures.size();
        EXPECT_EQ(applied(materials, values), once);
        EXPECT_EQ(scene_.textures.size(), textures) << "a map was read again";
        EXPECT_EQ(applied(materials, {}), base_);
        applied(materials, between);
        EXPECT_EQ(applied(materials, values), once);
        EXPECT_EQ(materials.base(), base_);
    }
};

TEST_F(LayeredMaterialsTest, EveryParameterIsAppliedOnceAndCanBeTakenBack) {
    int counted = 0;
    for (const Parameter& p : parameter_table()) {
        if (p.group != ParameterGroup::material) continue;
        SCOPED_TRACE(std::string(p.name));
        const ParameterValues values = samples_.values(p, 0);
        LayeredMaterials materials(base_);
        EXPECT_NE(applied(materials, values), base_) << "it changes nothing";
        expect_pure(values, samples_.values(p, 1));
        ++counted;
    }
    EXPECT_EQ(counted, 62);
}

// Whether the combination of two values in a layer is an error.
bool is_refused(const ParameterValues& values) {
    try {
        apply_parameters(Material{}, values, MaterialAssets{});
    } catch (const UsageError&) {
        return true;
    }
    return false;
}

TEST_F(LayeredMaterialsTest, SoAreManyTogether) {
    std::mt19937 random(16);
    const auto some_values = [&] {
        for (;;) {
            ParameterValues values;
            for (const Parameter& p : parameter_table()) {
                if (p.group != ParameterGroup::material || random() % 5 != 0) continue;
                const ParameterValues more = samples_.values(p, static_cast<int>(random() % 2));
                for (const auto& [name, value] : more.set_values()) values.set_value(name, value);
            }
            if (!is_refused(values)) return values;
        }
    };
    for (int i = 0; i < 100; ++i) {
        SCOPED_TRACE(i);
        expect_pure(some_values(), some_values());
        if (HasFailure()) return;
    }
}

// A file's value of a parameter leaves no trace when a flag overrides it.
TEST_F(LayeredMaterialsTest, AFlagWinsOverTheFileForEveryParameter) {
    scene_.instances.resize(1);
    for (const Parameter& p : parameter_table()) {
        if (p.group != ParameterGroup::material) continue;
        SCOPED_TRACE(std::string(p.name));
        const ParameterValues file = samples_.values(p, 0), both = samples_.values(p, 1);
        ParameterValues flag;
        flag.set_value(p.name, samples_.value(p, 1));
        Material plain;
        plain.normal_texture.texture = 0;
        LayeredMaterials layered({plain}, {{file, "s.json: objects[0]"}});
        const std::vector<Material> found = applied(layered, flag);
        LayeredMaterials alone({plain});
        std::vector<Material> expected = applied(alone, both);
        // Each has appended its own textures.
        const auto name_of = [&](const TextureUse& use) {
            return use ? scene_.textures[static_cast<std::size_t>(use.texture)].name : "";
        };
        const auto found_uses = texture_uses(found[0]);
        const auto expected_uses = texture_uses(expected[0]);
        for (std::size_t i = 0; i < found_uses.size(); ++i) {
            EXPECT_EQ(name_of(*found_uses[i]), name_of(*expected_uses[i]));
            expected_uses[i]->texture = found_uses[i]->texture;
        }
        if (p.name == "tabulated")
            std::get<Tabulated>(expected[0].lobe).material = tabulated_of(found[0])->material;
        if (const Cloth* cloth = cloth_of(found[0])) {
            EXPECT_EQ(cloth->draft->name, cloth_of(expected[0])->draft->name);
            std::get<Cloth>(expected[0].lobe).draft = cloth->draft;
        }
        EXPECT_EQ(found, expected);
    }
}

TEST_F(LayeredMaterialsTest, AFailureChangesNoMaterial) {
    LayeredMaterials materials(base_);
    ParameterValues good;
    good.set("base_color", "1,0,0", "");
    const std::vector<Material> before = applied(materials, good);
    for (const char* name : {"normal_map", "tabulated", "weave", "scratch"}) {
        ParameterValues bad;
        bad.set(name, "no/such", "");
        EXPECT_THROW(materials.apply(scene_, bad), Error) << name;
        EXPECT_EQ(scene_.materials, before);
    }
}

}  // namespace
}  // namespace burnish::test
