// Scene files as data: their meaning, and the errors for invalid files.
#include "burnish/scene_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <glm/vec4.hpp>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>

#include "burnish/image_io.hpp"
#include "support/paths.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

using test::error_line;
using test::ScratchFolder;

std::string example_of_the_manual() {
    std::ifstream file(test::source_folder() / "docs/reference/scene-file.md");
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const std::size_t start = text.find("```json\n") + 8;
    return text.substr(start, text.find("```", start) - start);
}

// A scene file with `members`.
// "lights" with one rectangle of these further members.
std::string area(const std::string& members) {
    return R"("lights": [{"type": "rectangle", "position": [0, 0, 1], "direction": [0, 0, -1], )" +
           members + "}]";
}

std::string scene_of(const std::string& members) {
    return R"({"format": "burnish-scene", "version": 1, )" + members + "}";
}

SceneFile load(const std::string& text) {
    const ScratchFolder folder;
    return load_scene_file(folder.write("s.json", text));
}

glm::vec3 placed(const Instance& instance, const glm::vec3& p) {
    return glm::vec3(instance.transform * glm::vec4(p, 1.0f));
}

TEST(SceneFile, ManualsExampleLoads) {
    const SceneFile file = load(example_of_the_manual());
    const Scene& scene = file.scene;
    ASSERT_EQ(scene.instances.size(), 2u);
    ASSERT_EQ(scene.meshes.size(), 2u);
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(file.environment, "builtin:studio");
    EXPECT_EQ(file.values.integer("width"), 960);
    EXPECT_DOUBLE_EQ(file.values.real("exposure"), 0.5);
    ASSERT_EQ(file.layers.size(), scene.materials.size());
    const auto layer = [&](std::size_t instance) {
        return file.layers.at(static_cast<std::size_t>(scene.instances[instance].material));
    };
    EXPECT_EQ(layer(0).values.text("metal"), "steel");
    EXPECT_DOUBLE_EQ(layer(0).values.real("alpha_x"), 0.45);
    EXPECT_EQ(layer(0).values.text("normal_map"), "builtin:bumps");
    EXPECT_NE(layer(0).place.find("s.json: objects[0]"), std::string::npos);
    EXPECT_DOUBLE_EQ(layer(1).values.real("roughness"), 0.6);
    EXPECT_FALSE(layer(1).values.is_set("metal"));
    EXPECT_TRUE(scene.textures.empty()) << "nothing that values name is read here";
    // The plane faces +z; rotated by -90 degrees about x it faces +y.
    const glm::vec3 up(scene.instances[1].transform * glm::vec4(0, 0, 1, 0));
    EXPECT_NEAR(up.y, 1.5f, 1e-5f);
}

TEST(SceneFile, ScalesThenTurnsXYZThenMoves) {
    const SceneFile file = load(scene_of(
        R"("objects": [{"model": "builtin:plane", "translate": [10, 0, 0],
                        "rotate_deg": [90, 90, 0], "scale": [2, 3, 4]}])"));
    // (0, 1, 0) -> (0, 3, 0) -> about x to (0, 0, 3) -> about y to (3, 0, 0) -> (13, 0, 0)
    const glm::vec3 p = placed(file.scene.instances.at(0), {0, 1, 0});
    EXPECT_NEAR(p.x, 13.0f, 1e-5f);
    EXPECT_NEAR(p.y, 0.0f, 1e-5f);
    EXPECT_NEAR(p.z, 0.0f, 1e-5f);
}

TEST(SceneFile, OneModelIsReadOnceAndWornInManyMaterials) {
    const SceneFile file = load(scene_of(
        R"("objects": [{"model": "builtin:plane"}, {"model": "builtin:plane", "material": "a"},
                       {"model": "builtin:plane", "material": "b"},
                       {"model": "builtin:plane", "material": "a"}],
           "materials": {"a": {"mdf": "ward"},
                         "b": {"alpha_x": 0.2, "normal_map": "builtin:bumps"}},
           "parameters": {"mdf": "beckmann", "roughness": 0.5, "triangles": 200,
                          "normal_map": "builtin:bumps"})"));
    const Scene& scene = file.scene;
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].indices.size(), 600u);
    EXPECT_EQ(scene.materials.size(), 3u);
    ASSERT_EQ(scene.instances.size(), 4u);
    const auto values = [&](std::size_t i) {
        return file.layers.at(static_cast<std::size_t>(scene.instances[i].material)).values;
    };
    EXPECT_EQ(values(0).text("mdf"), "beckmann");
    EXPECT_EQ(values(1).text("mdf"), "ward") << "the named set is more particular";
    EXPECT_EQ(values(2).text("mdf"), "beckmann");
    EXPECT_DOUBLE_EQ(values(1).real("roughness"), 0.5);
    EXPECT_FALSE(values(2).is_set("roughness")) << "alpha_x says it in another way";
    EXPECT_EQ(scene.instances[1].material, scene.instances[3].material);
    EXPECT_FALSE(file.values.is_set("mdf")) << "it must not override the sets";
}

TEST(SceneFile, LightsOfAllKinds) {
    const SceneFile file = load(scene_of(
        R"("lights": [{"type": "directional", "direction": [0, -2, 0], "color": "#ffffff"},
                      {"type": "point", "position": [1, 2, 3], "intensity": 50, "range": 9},
                      {"type": "spot", "position": [0, 1, 0], "direction": [1, 0, 0],
                       "inner_cone_deg": 30, "outer_cone_deg": 60}])"));
    const std::vector<Light>& lights = file.scene.lights;
    ASSERT_EQ(lights.size(), 3u);
    EXPECT_EQ(lights[0].direction, glm::vec3(0, -1, 0));
    EXPECT_EQ(lights[0].color, glm::vec3(1.0f));
    EXPECT_EQ(lights[1].type, LightType::point);
    EXPECT_FLOAT_EQ(lights[1].range, 9.0f);
    EXPECT_NEAR(lights[2].outer_cone, 1.0471976f, 1e-6f);
    EXPECT_NEAR(lights[2].inner_cone, 0.5235988f, 1e-6f);
}

TEST(SceneFile, FilesLieBesideIt) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder / "sub");
    write_image(folder / "sub/flat.png", Image(2, 2, 3, 0.5f), {});
    const auto path = folder.write(
        "sub/s.json", scene_of(
                          R"("objects": [{"model": "builtin:plane"}], "environment": "sky.hdr",
           "parameters": {"normal_map": "flat.png"})"));
    const SceneFile file = load_scene_file(path);
    EXPECT_EQ(file.environment, (folder / "sub/sky.hdr").string());
    EXPECT_EQ(file.layers.at(0).values.text("normal_map"), (folder / "sub/flat.png").string());
}

TEST(SceneFile, MaterialsAreNamedAsTheSceneNamesThem) {
    const SceneFile file = load(scene_of(
        R"("objects": [{"model": "builtin:plane", "material": "brushed"},
                       {"model": "builtin:plane"}],
           "materials": {"brushed": {"alpha_x": 0.1}}, "environment": "none")"));
    EXPECT_EQ(file.scene.materials.at(0).name, "brushed");
    EXPECT_EQ(file.scene.materials.at(1).name, "default");
    EXPECT_EQ(file.environment, "none") << "no file of that name";
}

TEST(SceneFile, SetsGoToSingleMaterialsOfAModel) {
    const ScratchFolder folder;
    folder.write("m.obj",
                 "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl oak\nf 1 2 3\n"
                 "usemtl brass\nf 1 2 3\n");
    folder.write("m.mtl", "newmtl oak\nnewmtl brass\n");
    const auto load_objects = [&](const std::string& objects) {
        return load_scene_file(
            folder.write("s.json", scene_of(R"("objects": [)" + objects + R"(], "materials": {
                "a": {"alpha_x": 0.1}, "b": {"alpha_x": 0.2, "name": "bright"}, "c": {"alpha_x": 0.3}})")));
    };
    const auto alphas = [](const SceneFile& file) {
        std::vector<double> all;
        for (const SceneFile::Layer& layer : file.layers)
            all.push_back(layer.values.is_set("alpha_x") ? layer.values.real("alpha_x") : 0.0);
        return all;
    };
    const SceneFile file = load_objects(
        R"({"model": "m.obj", "material": {"brass": "b", "#0": "a"}, "hidden": [1]},
           {"model": "m.obj", "material": {"*": "c", "oak": "a", "#0": "b"}},
           {"model": "m.obj", "material": {"brass": "c"}},
           {"model": "./m.obj", "material": {"brass": "b", "#0": "a"}, "hidden": [0, 0, 1]})");
    EXPECT_EQ(alphas(file), (std::vector<double>{0.1, 0.2, 0.2, 0.3, 0.0, 0.3}));
    EXPECT_EQ(file.scene.materials[0].name, "oak");
    EXPECT_EQ(file.scene.materials[1].name, "bright");
    EXPECT_TRUE(file.layers[1].renamed);
    EXPECT_FALSE(file.layers[0].renamed);
    EXPECT_EQ(file.scene.meshes.size(), 2u) << "the same file, spelled in two ways";
    ASSERT_EQ(file.objects.size(), 4u);
    EXPECT_EQ(file.objects[3].first_material, file.objects[0].first_material) << "shared";
    EXPECT_EQ(file.objects[2].first_material, 4);
    EXPECT_EQ(file.hidden, (std::vector<int>{1, 6, 7}));
    for (const Instance& instance : file.scene.instances)
        EXPECT_GE(instance.mesh, 0) << "who draws the scene hides them";

    const auto refused = [&](const std::string& member, const std::string& part) {
        const std::string line =
            error_line([&] { load_objects(R"({"model": "m.obj", )" + member + "}"); });
        EXPECT_NE(line.find("objects[0]"), std::string::npos) << line;
        EXPECT_NE(line.find(part), std::string::npos) << line;
    };
    refused(R"("material": {"bras": "a"})", "did you mean 'brass'?");
    refused(R"("material": {"brass": "d"})", "a name under \"materials\"");
    refused(R"("material": {"#2": "a"})", "an index below 2");
    refused(R"("material": 3)", "or an object");
    refused(R"("material": {"brass": 3})", "a text");
    refused(R"("hidden": [2])", "below 2");
    refused(R"("hidden": [-1])", "below 2");
    refused(R"("hidden": [0.5])", "below 2");
    refused(R"("hidden": 1)", "a list");
}

TEST(SceneFile, LightsOfModelsCanBeLeftOutAndTheViewersPartIsKeptAsItIs) {
    const std::string objects = R"("objects": [{"model": "builtin:plane"}], )";
    const SceneFile file =
        load(scene_of(objects + R"("model_lights": false, "viewer": {"anything": [1, {}]})"));
    EXPECT_TRUE(file.drops_lights);
    EXPECT_EQ(file.viewer, R"({"anything":[1,{}]})");
    EXPECT_FALSE(load(scene_of(objects + R"("lights": [])")).drops_lights);
    error_line([&] { load(scene_of(objects + R"("model_lights": 0)")); });
    error_line([&] { load(scene_of(objects + R"("viewer": 0)")); });
}

TEST(SceneFile, TrianglesOfALayerAboveCount) {
    const ScratchFolder folder;
    const auto path = folder.write(
        "s.json",
        scene_of(R"("objects": [{"model": "builtin:sphere"}], "parameters": {"triangles": 100})"));
    const auto triangles = [](const SceneFile& file) {
        return file.scene.meshes.at(0).indices.size() / 3;
    };
    ParameterValues over;
    over.set_value("triangles", 5000);
    EXPECT_LT(triangles(load_scene_file(path)), 300u);
    EXPECT_GT(triangles(load_scene_file(path, over)), 3000u);
}

// A direction of floats is not unit to the last bit: normalizing it again would change it.
TEST(SceneFile, DirectionsThatAreUnitStayAsTheyAreWritten) {
    std::mt19937 random(5);
    std::normal_distribution<float> normal;
    std::string lights;
    std::vector<glm::vec3> directions;
    for (int i = 0; i < 500; ++i) {
        glm::vec3 d(normal(random), normal(random), normal(random));
        directions.push_back(d / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z));
        const glm::dvec3 w = directions.back();
        lights += (i > 0 ? "," : "") + std::string(R"({"type": "directional", "direction": )") +
                  nlohmann::json({w.x, w.y, w.z}).dump() + "}";
    }
    const SceneFile file = load(scene_of(R"("lights": [)" + lights + "]"));
    for (std::size_t i = 0; i < directions.size(); ++i)
        EXPECT_EQ(file.scene.lights.at(i).direction, directions[i]);
}

TEST(SceneFile, IsToldByContent) {
    const ScratchFolder folder;
    EXPECT_TRUE(
        is_scene_file(folder.write("a.txt", "\xef\xbb\xbf \n" + scene_of("\"lights\": []"))));
    EXPECT_TRUE(is_scene_file(folder.write("broken.json", "{\"format\": ")));
    EXPECT_FALSE(is_scene_file(folder.write("m.gltf", R"({"asset": {"version": "2.0"}})")));
    EXPECT_FALSE(is_scene_file(folder.write("empty", "")));
    EXPECT_FALSE(is_scene_file(folder / "absent.json"));
    EXPECT_FALSE(is_scene_file(std::filesystem::temp_directory_path()));
}

TEST(SceneFile, ErrorsSayWhereAndWhat) {
    const std::pair<std::string, std::string> cases[] = {
        {"", "line 1, column 1: expected JSON, found the end of the file"},
        {"{\n  \"format\": \"burnish-scene\",\n  oops\n}",
         "line 3, column 3: expected JSON, found"},
        {"{\"format\": \"burnish-scene\"", "found the end of the file"},
        {"{\n\"version\": 1,\n\"version\": 1}", "line 3, column 9: expected each key once"},
        {"[1]", "expected an object"},
        {"{}", "format: expected \"burnish-scene\", found none"},
        {R"({"asset": {"version": "2.0"}})", "format: expected \"burnish-scene\", found none"},
        {R"({"format": "gltf", "version": 1})", "format: expected burnish-scene"},
        {R"({"format": "burnish-scene", "version": 2})", "version: expected 1, found 2"},
        {R"({"format": "burnish-scene", "version": 1, "x": 1e999})", "number in range"},
        {scene_of(R"("object": [])"), "did you mean 'objects'?"},
        {scene_of(R"("objects": {})"), "objects: expected a list"},
        {scene_of(R"("objects": [7])"), "objects[0]: expected an object {...}, found 7"},
        {scene_of(R"("objects": [{}])"), "objects[0].model: expected a value"},
        {scene_of(R"("objects": [{"model": "builtin:sphre"}])"), "did you mean 'sphere'?"},
        {scene_of(R"("objects": [{"model": "no.glb"}])"),
         "no.glb: expected a readable file, found no such file or folder"},
        {scene_of(R"("objects": [{"model": "no.glb"}])"), "s.json: objects[0].model: "},
        {scene_of(R"("objects": [{"model": "builtin:plane", "rotate": 1}])"),
         "objects[0]: unknown key"},
        {scene_of(R"("objects": [{"model": "builtin:plane", "scale": 0}])"),
         "objects[0].scale: expected a number from 1e-06"},
        {scene_of(R"("objects": [{"model": "builtin:plane", "scale": [1, -1, 1]}])"),
         "objects[0].scale[1]: expected"},
        {scene_of(R"("objects": [{"model": "builtin:plane", "translate": [1, 2]}])"),
         "objects[0].translate: expected three numbers [x, y, z], found [1, 2]"},
        {scene_of(R"("objects": [{"model": "builtin:plane", "translate": [1, 2, "3"]}])"),
         "objects[0].translate[2]: expected"},
        {scene_of(R"("materials": {"steel": {}}, "objects": [{"model": "builtin:plane",
                     "material": "stel"}])"),
         "(steel), found \"stel\"; did you mean 'steel'?"},
        {scene_of(R"("materials": {"m": {"alpha_x": "0.1"}})"),
         "materials.m.alpha_x: expected a number, found"},
        {scene_of(R"("materials": {"m": {"alpha_x": 9}})"),
         "materials.m.alpha_x: expected a number from 0.001 to 1.5"},
        {scene_of(R"("materials": {"m": {"aplha_x": 1}})"), "did you mean 'alpha_x'?"},
        {scene_of(R"("materials": {"m": {"width": 10}})"), "a parameter of materials"},
        {scene_of(R"("materials": {"m": {"alpha_x": 0.1, "e_x": 10}},
                     "objects": [{"model": "builtin:plane", "material": "m"}])"),
         "one pair"},
        {scene_of(R"("parameters": {"width": 10.5})"), "parameters.width: expected a whole number"},
        {scene_of(R"("parameters": {"flip_green": 1})"), "expected true or false, found 1"},
        {scene_of(R"("parameters": {"base_color": [1, 2]})"), "[r, g, b]"},
        {scene_of(R"("parameters": {"base_color": "red"})"), "parameters.base_color"},
        {scene_of(R"("lights": [{"type": "sun"}])"),
         "(directional point spot rectangle disc tube), found \"sun\""},
        {scene_of(R"("lights": [{"type": "spott"}])"), "did you mean 'spot'?"},
        {scene_of(R"("lights": [{"type": "point", "position": [0, 0, 0], "color": "red"}])"),
         "lights[0].color: expected [r, g, b]"},
        {scene_of(R"("lights": [{"type": "point", "direction": [0, 1, 0]}])"), "unknown key"},
        {scene_of(R"("lights": [{"type": "directional", "direction": [0, 0, 0]}])"),
         "not zero, found [0, 0, 0]"},
        {scene_of(R"("parameters": {"base_color": []})"), "found []"},
        {scene_of(R"("parameters": {"base_color": [[1], {"a": 1}, "x", 0.5, 6]})"),
         R"(found [[...], {...}, "...", 0.5, ...] (5 entries))"},
        {scene_of(R"("lights": [{"type": "spot", "position": [0, 0, 0], "direction": [0, 0, 1],
                      "inner_cone_deg": 50}])"),
         "lights[0].inner_cone_deg"},
        {scene_of(R"("environment": "")"), "environment: expected a text"},
        {scene_of(area(R"("size": [1, 0], "radiance": 1)")),
         "lights[0].size[1]: expected a number from 1e-06"},
        {scene_of(area(R"("size": [1, -1], "radiance": 1)")),
         "lights[0].size[1]: expected a number from 1e-06"},
        {scene_of(area(R"("size": [1, 1, 1], "radiance": 1)")), "[width, height] in meters"},
        {scene_of(area(R"("radiance": 1)")), "lights[0].size"},
        {scene_of(area(R"("size": 1)")), "expected radiance, lumens or watts, found none of them"},
        {scene_of(area(R"("size": 1, "watts": 1, "radiance": 1)")),
         "expected one of radiance, lumens and watts, found radiance and watts"},
        {scene_of(area(R"("size": 1e-6, "watts": 1000)")), "at most 1e+09 cd/m2 from 1e-12 m2"},
        {scene_of(area(R"("size": 1, "radiance": 1, "up": [0, 0, 1])")), "not along `direction`"},
        {scene_of(area(R"("size": 1, "radiance": 1, "two_sided": 1)")), "expected true or false"},
        {scene_of(area(R"("size": 1, "radiance": 1, "texture": "none.png")")), "lights[0].texture"},
        {scene_of(area(R"("size": 1, "radiance": 1, "intensity": 1)")),
         "unknown key \"intensity\""},
        {scene_of(area(R"("size": 1, "radiance": 1, "range": 1)")), "unknown key \"range\""},
    };
    for (const auto& [text, expected] : cases) {
        const std::string line = error_line([&broken = text] { (void)load(broken); });
        EXPECT_NE(line.find(expected), std::string::npos) << text << "\n" << line;
        EXPECT_TRUE(line.find("s.json") != std::string::npos) << line;
    }
}

// pi A L lumens leave one side of a surface that emits the same in all directions; a watt is 683 of them.
TEST(SceneFile, LightsWithAnAreaStateTheirPowerInOneOfThreeWays) {
    const SceneFile file = load(scene_of(
        R"("lights": [
        {"type": "rectangle", "position": [1, 2, 3], "direction": [0, 0, -2], "size": [2, 0.5], "radiance": 7},
        {"type": "rectangle", "position": [0, 0, 0], "direction": [0, 0, 1], "size": [2, 0.5],
         "lumens": 100, "two_sided": true, "up": [1, 0, 0]},
        {"type": "disc", "position": [0, 0, 0], "direction": [0, 0, 1], "size": 2, "watts": 1, "visible": false},
        {"type": "tube", "position": [0, 0, 0], "direction": [1, 0, 0], "length": 1.5, "radius": 0.02,
         "lumens": 100, "color": [1, 0.5, 0]}])"));
    const std::vector<Light>& lights = file.scene.lights;
    ASSERT_EQ(lights.size(), 4u);
    constexpr float kPi = 3.14159265f;
    EXPECT_EQ(lights[0].type, LightType::rectangle);
    EXPECT_EQ(lights[0].direction, glm::vec3(0, 0, -1));
    EXPECT_EQ(lights[0].size, glm::vec2(2, 0.5f));
    EXPECT_EQ(lights[0].intensity, 7.0f);
    EXPECT_TRUE(lights[0].visible);
    EXPECT_FLOAT_EQ(lights[1].intensity, 100.0f / (kPi * 2.0f));  // 1 m2, two sides
    EXPECT_EQ(lights[1].up, glm::vec3(1, 0, 0));
    EXPECT_FLOAT_EQ(lights[2].intensity, 683.0f / (kPi * kPi));  // pi m2
    EXPECT_FALSE(lights[2].visible);
    EXPECT_EQ(lights[3].size, glm::vec2(1.5f, 0.04f));
    EXPECT_FLOAT_EQ(lights[3].intensity, 100.0f / (kPi * 2 * kPi * 0.02f * 1.5f));
    EXPECT_EQ(lights[3].color, glm::vec3(1, 0.5f, 0));
}

TEST(SceneFile, FaultsOfTheFileAreNotFaultsOfTheCommand) {
    const ScratchFolder folder;
    for (const char* text :
         {R"("parameters": {"mdf": "gxx"})", R"("objects": [{"model": "builtin:nothing"}])",
          R"("lights": [{"type": "point", "position": [0,0,0], "color": "x"}])"}) {
        try {
            load_scene_file(folder.write("s.json", scene_of(text)));
            ADD_FAILURE() << text;
        } catch (const UsageError& error) {
            ADD_FAILURE() << error.what();
        } catch (const Error&) {
        }
    }
}

TEST(SceneFile, DeepNestingAndHugeNumbersOfBracketsAreRefused) {
    for (const std::string& open : {std::string("["), std::string("{\"a\":")}) {
        std::string text;
        for (int i = 0; i < 100000; ++i) text += open;
        EXPECT_NE(error_line([&] { (void)load(text); }).find("nested"), std::string::npos);
    }
}

// Every prefix of a valid file, and the file with random bytes changed, gives an error or a scene.
// Deterministic.
TEST(SceneFile, SurvivesDamage) {
    const ScratchFolder folder;
    const std::string good = scene_of(
        R"("objects": [{"model": "builtin:plane", "material": "m", "rotate_deg": [1, 2, 3]}],
           "materials": {"m": {"base_color": "#a0b0c0", "alpha_x": 0.2, "conserve": true}},
           "lights": [{"type": "point", "position": [1, 2, 3]}], "environment": "builtin:white",
           "parameters": {"width": 10, "camera_target": [0, 1, 0]})");
    const auto survives = [&](const std::string& text) {
        try {
            (void)load_scene_file(folder.write("s.json", text));
            return true;
        } catch (const Error&) {
            return false;
        }
    };
    EXPECT_TRUE(survives(good));
    for (std::size_t n = 0; n < good.size(); ++n) EXPECT_FALSE(survives(good.substr(0, n)));
    std::mt19937 random(7);
    for (int i = 0; i < 1000; ++i) {
        std::string text = good;
        for (auto k = random() % 3 + 1; k > 0; --k)
            text[random() % text.size()] = static_cast<char>(random() & 0xffu);
        (void)survives(text);
    }
}

}  // namespace
}  // namespace burnish
