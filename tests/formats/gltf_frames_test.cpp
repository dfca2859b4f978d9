// Tangents of meshes that store none: their frame is that of the coordinates which the material reads
// its normals with. The second derivation is the same mesh with the transform baked into its
// coordinates.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "burnish/fit_tangents.hpp"
#include "burnish/image_io.hpp"
#include "burnish/stage.hpp"
#include "formats/obj/obj.hpp"
#include "gltf_support.hpp"

namespace burnish {
namespace {

using nlohmann::json;
using test::load_bytes;
using test::warns;

constexpr double kQuarter = std::numbers::pi / 2.0;

// A bent sheet whose coordinates are neither square nor axis-parallel.
GlbPrimitive bent_sheet() {
    GlbPrimitive sheet = unit_square(6, false);
    for (std::size_t i = 0; i < sheet.positions.size(); ++i) {
        glm::vec3& p = sheet.positions[i];
        p.z = 0.3f * std::sin(3.0f * p.x) + 0.2f * p.y * p.y;
        sheet.normals[i] = glm::normalize(glm::vec3(-0.9f * std::cos(3.0f * p.x), -0.4f * p.y, 1));
        glm::vec2& uv = sheet.texcoord0[i];
        uv = {1.3f * uv.x + 0.2f * uv.y * uv.y, 0.7f * uv.y - 0.1f * uv.x};
    }
    return sheet;
}

json transform_of(glm::dvec2 scale, double rotation) {
    return {{"KHR_texture_transform",
             {{"offset", {0.3, -0.2}}, {"scale", {scale.x, scale.y}}, {"rotation", rotation}}}};
}

json read_with(const json& extensions) {
    return {{"index", 0}, {"extensions", extensions}};
}

GlbWriter sheet_with(GlbPrimitive sheet, const json& material) {
    GlbWriter writer;
    writer.add_png(png_gradient(4, 2));
    sheet.material = writer.add_material(material);
    writer.add_node(writer.add_mesh(sheet));
    return writer;
}

json aniso(const json& texture) {
    return {{"KHR_materials_anisotropy",
             {{"anisotropyStrength", 0.8}, {"anisotropyTexture", texture}}}};
}

void expect_same_frames(const Mesh& a, const Mesh& b) {
    ASSERT_EQ(a.tangents.size(), b.tangents.size());
    for (std::size_t i = 0; i < a.tangents.size(); ++i) {
        // Directions of edges of 1/6 in coordinates up to 10, rounded at 2^-20.
        EXPECT_LT(glm::length(glm::vec3(a.tangents[i]) - glm::vec3(b.tangents[i])), 2e-5f) << i;
        EXPECT_EQ(a.tangents[i].w, b.tangents[i].w) << i;
    }
}

class GltfFramesOf : public testing::TestWithParam<std::pair<glm::dvec2, double>> {
  protected:
    // The mesh whose texture is read through the transform, and the mesh with baked coordinates.
    static void expect_baked(const json& material, TextureUse Material::*use) {
        const Scene moved = load_bytes(sheet_with(bent_sheet(), material));
        const glm::mat3 transform = (moved.materials[0].*use).transform;
        GlbPrimitive baked = bent_sheet();
        for (glm::vec2& uv : baked.texcoord0) uv = glm::vec2(transform * glm::vec3(uv, 1.0f));
        const Scene plain = load_bytes(sheet_with(baked, {{"normalTexture", {{"index", 0}}}}));
        expect_same_frames(moved.meshes.at(0), plain.meshes.at(0));
        EXPECT_EQ(moved.meshes[0].texcoord0, bent_sheet().texcoord0) << "coordinates stay";
    }
};

TEST_P(GltfFramesOf, OfANormalTextureAreThoseOfBakedCoordinates) {
    const auto [scale, rotation] = GetParam();
    expect_baked({{"normalTexture", read_with(transform_of(scale, rotation))}},
                 &Material::normal_texture);
}

TEST_P(GltfFramesOf, OfAnAnisotropyTextureAreThoseOfBakedCoordinates) {
    const auto [scale, rotation] = GetParam();
    expect_baked({{"extensions", aniso(read_with(transform_of(scale, rotation)))}},
                 &Material::anisotropy_texture);
}

INSTANTIATE_TEST_SUITE_P(
    Transforms, GltfFramesOf,
    testing::Values(std::pair(glm::dvec2(1, 1), kQuarter),
                    std::pair(glm::dvec2(1, 1), 2 * kQuarter), std::pair(glm::dvec2(1, 1), 0.65),
                    std::pair(glm::dvec2(6, 2), kQuarter), std::pair(glm::dvec2(6, 2), -0.4),
                    std::pair(glm::dvec2(-1, 1), 0.0), std::pair(glm::dvec2(1, -1), 0.3),
                    std::pair(glm::dvec2(-3, -2), 0.0)));

TEST(GltfFrames, ScalesWithoutTurnsChangeNothing) {
    const Scene plain = load_bytes(sheet_with(bent_sheet(), {{"normalTexture", {{"index", 0}}}}));
    const Scene scaled = load_bytes(
        sheet_with(bent_sheet(), {{"normalTexture", read_with(transform_of({6, 2}, 0.0))}}));
    EXPECT_EQ(plain.meshes.at(0).tangents, scaled.meshes.at(0).tangents);
}

TEST(GltfFrames, StoredTangentsStay) {
    GlbPrimitive sheet = bent_sheet();
    for (const glm::vec3 n : sheet.normals)
        sheet.tangents.emplace_back(glm::normalize(glm::cross({0.2f, 1.0f, 0.1f}, n)), 1.0f);
    const json turned = read_with(transform_of({1, 1}, kQuarter));
    json material = {{"normalTexture", turned}};
    material["extensions"] = aniso({{"index", 0}});
    const Scene scene = load_bytes(sheet_with(sheet, material));
    const Mesh& mesh = scene.meshes.at(0);
    EXPECT_FALSE(mesh.tangent_source);
    for (std::size_t i = 0; i < mesh.tangents.size(); ++i)
        EXPECT_LT(glm::length(mesh.tangents[i] - sheet.tangents[i]), 1e-6f);
    EXPECT_EQ(scene.materials[0].anisotropy_texture_turn, 0.0f) << "one frame for all textures";
}

TEST(GltfFrames, MaterialsOfOneMeshGetTheirOwn) {
    GlbWriter writer;
    writer.add_png(png_gradient(4, 2));
    GlbPrimitive sheet = unit_square(2, false);
    for (const double rotation : {0.0, kQuarter, 0.0})
        sheet.material =
            writer.add_material({{"normalTexture", read_with(transform_of({1, 1}, rotation))}});
    writer.add_node(writer.add_mesh(sheet));
    json& primitives = writer.root["meshes"][0]["primitives"];
    for (const int material : {0, 1}) {
        primitives.push_back(primitives[0]);
        primitives.back()["material"] = material;
    }
    const Scene scene = load_bytes(writer);
    ASSERT_EQ(scene.instances.size(), 3u);
    EXPECT_EQ(scene.meshes.size(), 2u) << "two frames: the materials without a turn share a mesh";
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        EXPECT_EQ(*mesh.tangent_source,
                  tangent_source_of(scene.materials[static_cast<std::size_t>(instance.material)]));
    }
}

// Directions of the anisotropy texture in world space, as the renderer turns them: the texture's, by
// the turn, in the frame of the mesh. They must be those of a material that has no normal map, whose
// frame is the anisotropy texture's own.
TEST(GltfFrames, AnAnisotropyTextureIsTurnedIntoTheNormalMapsFrame) {
    const auto world = [](const Scene& scene, float angle) {
        const Mesh& mesh = scene.meshes.at(0);
        const float turned = angle + scene.materials.at(0).anisotropy_texture_turn;
        const glm::vec3 t(mesh.tangents[0]);
        const glm::vec3 b = glm::cross(mesh.normals[0], t) * mesh.tangents[0].w;
        return std::cos(turned) * t + std::sin(turned) * b;
    };
    struct Case {
        glm::dvec2 normal_scale;
        double normal, anisotropy;
    };
    for (const Case& c : {Case{{1, 1}, 0.0, kQuarter}, Case{{1, 1}, 0.4, -1.1},
                          Case{{-1, 1}, 0.4, -1.1}, Case{{2, 2}, 1.0, 3.0}}) {
        const json own =
            read_with(transform_of({c.normal_scale.x < 0 ? -1.0 : 1.0, 1}, c.anisotropy));
        const Scene alone =
            load_bytes(sheet_with(unit_square(1, false), json{{"extensions", aniso(own)}}));
        const Scene both = load_bytes(
            sheet_with(unit_square(1, false),
                       json{{"normalTexture", read_with(transform_of(c.normal_scale, c.normal))},
                            {"extensions", aniso(own)}}));
        EXPECT_EQ(warns(both, "not by quarter turns"), c.anisotropy != kQuarter);
        for (const float angle : {0.0f, 0.9f})
            EXPECT_LT(glm::length(world(alone, angle) - world(both, angle)), 1e-5f)
                << c.normal << ' ' << c.anisotropy << ' ' << angle;
    }
}

TEST(GltfFrames, AnApproximateAnisotropyDirectionIsSaid) {
    const json mirrored = read_with(transform_of({-1, 1}, 0.0));
    const Scene one = load_bytes(sheet_with(
        bent_sheet(), json{{"normalTexture", {{"index", 0}}}, {"extensions", aniso(mirrored)}}));
    EXPECT_TRUE(warns(one, "the anisotropy texture is mirrored against the normal map"));
    GlbPrimitive sheet = bent_sheet();
    sheet.texcoord1 = sheet.texcoord0;
    const Scene sets =
        load_bytes(sheet_with(sheet, json{{"normalTexture", {{"index", 0}, {"texCoord", 1}}},
                                          {"extensions", aniso({{"index", 0}})}}));
    EXPECT_TRUE(warns(sets, "the anisotropy texture has other texture coordinates"));
}

// --- flags, and other formats -------------------------------------------------------------------

Stage staged(const std::filesystem::path& file, const char* normal_map) {
    StageRequest request;
    request.input = file.string();
    request.environment = "none";
    if (normal_map != nullptr) request.values.set("normal_map", normal_map, "test");
    return set_stage(request);
}

TEST(GltfFrames, ANormalMapOfAFlagIsReadInItsOwnFrame) {
    const TemporaryFolder folder;
    const auto path = folder.write(
        "model.glb",
        sheet_with(bent_sheet(), {{"normalTexture", read_with(transform_of({1, 1}, kQuarter))}})
            .glb());
    const Scene plain = load_bytes(sheet_with(bent_sheet(), {{"normalTexture", {{"index", 0}}}}));
    Stage stage = staged(path, "builtin:bumps");
    expect_same_frames(stage.scene.meshes.at(0), plain.meshes.at(0));
    // Without the flag the file's own map is back, and with it its frame.
    stage.materials.apply(stage.scene, {});
    expect_same_frames(stage.scene.meshes.at(0), load_gltf(path).meshes.at(0));
}

// A normal map of x and y alone is one of two channels wherever it comes from, and nobody then says
// that it is no normal map.
TEST(NormalMaps, OfXAndYAloneAreCompletedEverywhere) {
    const TemporaryFolder folder;
    Image xy(16, 16, 3);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            xy.at(x, y)[0] = static_cast<float>(x) / 15.0f;
            xy.at(x, y)[1] = static_cast<float>(y) / 15.0f;
        }
    write_image(folder.path() / "xy.png", xy, {});
    const auto map = (folder.path() / "xy.png").string();
    const auto glb = folder.write("plain.glb", sheet_with(bent_sheet(), json::object()).glb());
    GlbWriter own = sheet_with(
        bent_sheet(), {{"normalTexture", {{"index", 0}}}, {"occlusionTexture", {{"index", 0}}}});
    own.root["images"][0] = {{"uri", "xy.png"}};
    const auto gltf = folder.write("own.glb", own.glb());
    folder.write("m.mtl", std::string_view("newmtl a\nnorm xy.png\n"));
    const auto obj = folder.write(
        "m.obj", std::string_view("mtllib m.mtl\nv 0 0 0\nv 2 0 0\nv 0 2 0\nvt 0 0\nvt 1 0\n"
                                  "vt 0 1\nusemtl a\nf 1/1 2/2 3/3\n"));
    const auto scene = folder.write("s.json", json{{"format", "burnish-scene"},
                                                   {"version", 1},
                                                   {"objects", {{{"model", "plain.glb"}}}},
                                                   {"parameters", {{"normal_map", "xy.png"}}}}
                                                  .dump());
    for (const Stage& stage : {staged(gltf, nullptr), staged(obj, nullptr), staged(scene, nullptr),
                               staged(glb, map.c_str())}) {
        const TextureUse& use = stage.scene.materials.at(0).normal_texture;
        ASSERT_TRUE(use);
        EXPECT_EQ(stage.scene.textures.at(static_cast<std::size_t>(use.texture)).channels, 2);
        EXPECT_TRUE(warns(stage.scene, "z is taken from them"));
        EXPECT_FALSE(warns(stage.scene, "does not look like"));
    }
    const Scene shared = load_gltf(gltf);
    const int occlusion = shared.materials[0].occlusion_texture.texture;
    EXPECT_EQ(shared.textures.at(static_cast<std::size_t>(occlusion)).channels, 3)
        << "other uses read the whole picture";
}

TEST(GltfFrames, AWarningOfTheFileIsGivenOnce) {
    const TemporaryFolder folder;
    const json mirrored = read_with(transform_of({-1, 1}, 0.0));
    const auto path =
        folder.write("m.glb", sheet_with(bent_sheet(), json{{"normalTexture", {{"index", 0}}},
                                                            {"extensions", aniso(mirrored)}})
                                  .glb());
    const auto lines = staged(path, nullptr).scene.warnings;
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(),
                            [](const std::string& line) {
                                return line.find("is mirrored") != std::string::npos;
                            }),
              1);
}

TEST(GltfFrames, AnObjsMirroredMapIsThatOfBakedCoordinates) {
    const std::string head = "mtllib m.mtl\nv 0 0 0\nv 2 0 0\nv 0 2 0\nvn 0 0 1\n";
    const std::string tail = "usemtl a\nf 1/1/1 2/2/1 3/3/1\n";
    const auto load = [&](const std::string& options, const std::string& coordinates) {
        const TemporaryFolder folder;
        folder.write("n.png", png_gradient(4, 2));
        folder.write("m.mtl", "newmtl a\nnorm " + options + "n.png\n");
        return load_obj(folder.write("m.obj", head + coordinates + tail));
    };
    const Scene plain = load("", "vt 0 0\nvt -1 0\nvt 0 1\n");
    const Scene mirrored = load("-s -1 1 1 ", "vt 0 0\nvt 1 0\nvt 0 1\n");
    expect_same_frames(mirrored.meshes.at(0), plain.meshes.at(0));
    EXPECT_EQ(mirrored.meshes[0].tangents[0].w, -1.0f);
}

// Nodes in map coordinates: the mesh, a light and a camera keep their places to each other to a
// micrometer, which floats at 5e6 m cannot say: they are half a meter apart.
TEST(GltfFrames, AModelFarFromTheOriginIsMovedToItBeforeItsTransformsAreFloats) {
    const auto scene_at = [](double x, double z) {
        GlbWriter writer = test::writer_of(unit_square(1, true));
        nlohmann::json& nodes = writer.root["nodes"];
        nodes[0]["translation"] = {x + 0.123456, 0.25, z};
        writer.root["extensionsUsed"] = {"KHR_lights_punctual"};
        writer.root["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
        writer.root["cameras"] = {
            {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}}};
        nodes.push_back({{"translation", {x + 0.3, 2.0, z + 0.7}},
                         {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
        nodes.push_back({{"translation", {x, 0.1, z + 3.3}}, {"camera", 0}});
        writer.root["scenes"][0]["nodes"] = {0, 1, 2};
        return test::load_bytes(writer);
    };
    const Scene near = scene_at(0, 0), far = scene_at(447321, 5411823);
    EXPECT_FALSE(test::warns(near, "far from the origin"));
    EXPECT_TRUE(
        test::warns(far, "is subtracted from the positions of its nodes, lights and cameras"));
    ASSERT_EQ(far.instances.size(), 1u);
    const glm::vec3 moved =
        glm::vec3(far.instances[0].transform[3]) - glm::vec3(near.instances[0].transform[3]);
    const auto expect_moved = [&](glm::vec3 from, glm::vec3 to) {
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(to[i] - from[i], moved[i], 1e-6) << i;
    };
    expect_moved(near.lights.at(0).position, far.lights.at(0).position);
    expect_moved(near.cameras.at(0).position, far.cameras.at(0).position);
    EXPECT_LT(glm::length(glm::vec3(far.instances[0].transform[3])), 2.0f);
}

}  // namespace
}  // namespace burnish
