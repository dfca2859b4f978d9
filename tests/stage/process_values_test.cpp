// The process of a material: which method it picks, and what holds where both are stated.
#include <gtest/gtest.h>

#include "burnish/error.hpp"
#include "burnish/layered_materials.hpp"
#include "burnish/shading_names.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {
namespace {

using ProcessWords = std::vector<std::pair<const char*, std::string>>;

struct Applied {
    Material material;
    std::vector<std::string> warnings;  // that name the process
};

// A material with a normal map under the values of a file and of flags.
Applied applied(const ProcessWords& file, const ProcessWords& flags) {
    const auto values_of = [](const ProcessWords& words) {
        ParameterValues values;
        for (const auto& [name, text] : words) values.set(name, text, "");
        return values;
    };
    Scene scene;
    Material base;
    base.normal_texture.texture = 0;
    scene.textures.push_back({"flat",
                              1,
                              1,
                              3,
                              TexelType::u8,
                              ColorSpace::linear,
                              {std::byte{128}, std::byte{128}, std::byte{255}}});
    LayeredMaterials materials({base}, {{values_of(file), "s.json: objects[0]"}});
    Applied result;
    for (std::string& line : materials.apply(scene, values_of(flags)).warnings)
        if (line.starts_with("process: ")) result.warnings.push_back(std::move(line));
    result.material = scene.materials.at(0);
    return result;
}

TEST(ProcessValues, PickTheirMethods) {
    const std::pair<std::string, Method> pairs[] = {{"embossed", Method::follow_grain},
                                                    {"bent", Method::rotate_arc},
                                                    {"stamped", Method::stretch},
                                                    {"brushed-after", Method::slope_shift}};
    ASSERT_EQ(process_names().size(), std::size(pairs));
    for (std::size_t i = 0; i < std::size(pairs); ++i) {
        const auto& [name, method] = pairs[i];
        EXPECT_EQ(process_names()[i], name);
        EXPECT_EQ(name_of(static_cast<Process>(i)), name);
        for (const Applied& a :
             {applied({}, {{"process", name}}), applied({{"process", name}}, {})}) {
            EXPECT_EQ(a.material.method, method) << name;
            EXPECT_EQ(a.material.process, static_cast<Process>(i));
            EXPECT_TRUE(a.warnings.empty()) << a.warnings.front();
        }
    }
    EXPECT_EQ(applied({}, {}).material.method, Method::follow_grain);
    EXPECT_FALSE(applied({}, {}).material.process);
}

TEST(ProcessValues, AStatedMethodHoldsAndIsSaidToDisagree) {
    for (const Applied& a : {applied({}, {{"process", "stamped"}, {"method", "rotate-arc"}}),
                             applied({{"process", "stamped"}}, {{"method", "rotate-arc"}})}) {
        EXPECT_EQ(a.material.method, Method::rotate_arc);
        EXPECT_EQ(a.material.process, Process::stamped);
        ASSERT_EQ(a.warnings.size(), 1u);
        EXPECT_EQ(a.warnings.front(),
                  "process: stamped asks for method stretch, but method rotate-arc is stated: "
                  "rotate-arc is drawn (leave the method out for stretch)");
    }
    EXPECT_TRUE(applied({}, {{"process", "stamped"}, {"method", "stretch"}}).warnings.empty());
}

// The flag is the later word: it does not merely name what the file draws.
TEST(ProcessValues, AProcessOfTheFlagsReplacesAMethodOfTheFile) {
    const Applied a = applied({{"method", "gram-schmidt"}}, {{"process", "brushed-after"}});
    EXPECT_EQ(a.material.method, Method::slope_shift);
    EXPECT_TRUE(a.warnings.empty());
}

TEST(ProcessValues, AnUnknownOneIsRefusedWithTheNearest) {
    ParameterValues values;
    EXPECT_EQ(
        error_line<UsageError>([&] { values.set("process", "stampd", "--process"); }),
        "--process: expected one of embossed bent stamped brushed-after, found \"stampd\" (did you "
        "mean 'stamped'?)");
}

// Phong has no facets: the line names the method and the process that asked for it.
TEST(ProcessValues, ModelsWithoutFacetsRefuseThoseThatMoveThem) {
    for (const char* brdf : {"phong", "lafortune"}) {
        const std::string line = error_line<UsageError>([&] {
            applied({}, {{"brdf", brdf}, {"process", "stamped"}});
        });
        EXPECT_NE(line.find("method: expected a rotation such as follow-grain for brdf " +
                            std::string(brdf) +
                            ", which has no half vectors to move, found stretch "
                            "(of process stamped)"),
                  line.npos)
            << line;
        EXPECT_EQ(applied({}, {{"brdf", brdf}, {"process", "bent"}}).material.method,
                  Method::rotate_arc);
    }
}

}  // namespace
}  // namespace burnish::test
