// Wavefront OBJ and MTL.
#include "formats/obj/obj.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "burnish/load_model.hpp"
#include "gltf_support.hpp"
#include "scene/geometry/polygon.hpp"

namespace burnish {
namespace {

using test::error_line;
using test::warns;

Scene load_text(std::string_view text) {
    const TemporaryFolder folder;
    return load_obj(folder.write("model.obj", text));
}

std::string error_of(std::string_view text) {
    return error_line([&] { load_text(text); });
}

double area_of(const Mesh& mesh) {
    double area = 0.0;
    for (std::size_t c = 0; c < mesh.indices.size(); c += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[c]];
        area += 0.5 * glm::length(glm::cross(mesh.positions[mesh.indices[c + 1]] - a,
                                             mesh.positions[mesh.indices[c + 2]] - a));
    }
    return area;
}

constexpr std::string_view kCube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
constexpr std::string_view kFaces =
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

TEST(Obj, ReadsPositionsNormalsAndCoordinates) {
    const Scene scene = load_text(
        "v 0 0 0\nv 2 0 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\n"
        "f 1/1/1 2/2/1 3/3/1\n");
    ASSERT_EQ(scene.meshes.size(), 1u);
    const Mesh& mesh = scene.meshes[0];
    ASSERT_EQ(mesh.positions.size(), 3u);
    EXPECT_EQ(mesh.positions[1], glm::vec3(2.0f, 0.0f, 0.0f));
    EXPECT_EQ(mesh.normals[0], glm::vec3(0.0f, 0.0f, 1.0f));
    EXPECT_EQ(mesh.texcoord0[0], glm::vec2(0.0f, 1.0f));  // v runs down in Mesh
    EXPECT_EQ(mesh.tangents[0], glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(Obj, NegativeNumbersCountFromTheEnd) {
    const Scene scene = load_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -4 -3 -1\n");
    ASSERT_EQ(scene.meshes.at(0).indices.size(), 6u);
    EXPECT_EQ(scene.meshes[0].positions[scene.meshes[0].indices[5]], glm::vec3(0, 0, 1));
}

TEST(Obj, WithoutSmoothingLinesNormalsAreSmooth) {
    const Scene scene = load_text(std::string(kCube) + std::string(kFaces));
    const Mesh& mesh = scene.meshes.at(0);
    EXPECT_EQ(mesh.positions.size(), 8u);
    EXPECT_NEAR(area_of(mesh), 6.0, 1e-5);
    for (std::size_t i = 0; i < 8; ++i) {
        const glm::vec3 outward = glm::normalize(mesh.positions[i] - glm::vec3(0.5f));
        EXPECT_GT(glm::dot(mesh.normals[i], outward), 0.9999f);
    }
}

TEST(Obj, SmoothingGroups) {
    const Scene flat = load_text(std::string(kCube) + "s off\n" + std::string(kFaces));
    ASSERT_EQ(flat.meshes.at(0).positions.size(), 24u);
    for (const glm::vec3 n : flat.meshes[0].normals)
        EXPECT_NEAR(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), 1.0f, 1e-6f);
    // Bottom and top are a group each, the walls a third: 8 + 8 vertices.
    const Scene groups = load_text(std::string(kCube) +
                                   "s 1\nf 1 4 3 2\ns 2\nf 5 6 7 8\ns 3\nf 1 2 6 5\nf 2 3 7 6\n"
                                   "f 3 4 8 7\nf 4 1 5 8\n");
    EXPECT_EQ(groups.meshes.at(0).positions.size(), 16u);
}

TEST(Obj, ContinuedLinesCommentsAndOddEndings) {
    const Scene scene =
        load_text("# comment\r\nv 0 0 0\r\nv 1 0 0\r\nv 0 \\\r\n1 0\r\n  f 1 2 \\\n3\r\n");
    EXPECT_EQ(scene.meshes.at(0).indices.size(), 3u);
    EXPECT_EQ(scene.meshes[0].positions[2], glm::vec3(0.0f, 1.0f, 0.0f));
}

// A carriage return in a name must not break the line of the warning.
TEST(Obj, WarningsAreOneLineWhateverTheNames) {
    const Scene scene =
        load_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nusemtl cloth\rof gold\nf 1//1 2//1 3//1\n");
    ASSERT_EQ(scene.warnings.size(), 2u);
    EXPECT_TRUE(warns(scene, "broken normals"));
    for (const std::string& line : scene.warnings)
        EXPECT_EQ(line.find_first_of("\r\n"), std::string::npos) << line;
}

TEST(Obj, HostileInputIsALineOfError) {
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    EXPECT_NE(error_of(vertices + "f 1 2 4\n").find("from 1 to 3"), std::string::npos);
    EXPECT_NE(error_of(vertices + "f 1 2 2000000000\n").find("from 1 to 3"), std::string::npos);
    EXPECT_NE(error_of(vertices + "f 1 2 -9\n").find("model.obj"), std::string::npos);
    EXPECT_NE(error_of(vertices + "f 1 2 0\n").find("model.obj"), std::string::npos);
    EXPECT_NE(error_of(vertices + "f 1 2 x\n").find("model.obj"), std::string::npos);
    std::string polygon = "f";
    for (int i = 0; i < 300; ++i) polygon += " 1";
    EXPECT_NE(error_of(vertices + polygon + "\n").find("at most 255 corners"), std::string::npos);
    for (const char* text : {"", "\n", "# nothing", "v 0 0 0\n", "f", "f 1\n", "s", "usemtl\n"}) {
        const Scene scene = load_text(text);
        EXPECT_TRUE(scene.instances.empty());
        EXPECT_TRUE(warns(scene, "nothing to draw"));
    }
    EXPECT_TRUE(warns(load_text(vertices + "l 1 2\nf 1 2 3\n"), "lines and points"));
}

TEST(Obj, PositionsThatAreNoNumbersAreRefusedWithTheirLine) {
    const struct {
        const char *line, *found;
    } cases[] = {{"v 1,75 0,5 0,0", "found \"1,75\" (OBJ has decimal points, no commas)"},
                 {"v 0 0 zero", "found \"zero\""},
                 {"v nan 0 0", "found \"nan\""},
                 {"v 1 inf 0", "found \"inf\""},
                 {"v 1e400 0 0", "found \"1e400\""},
                 {"v 0 1e30 0", "found \"1e30\""},
                 {"v 1 0x2 3", "found \"0x2\""},
                 {"v 1 2", "found \"1 2\""}};
    for (const auto& c : cases) {
        const std::string line =
            error_of("v 0 0 0\n# a comment\n" + std::string(c.line) + "\nv 0 1 0\nf 1 2 3\n");
        EXPECT_NE(line.find("model.obj: line 3: v: expected three finite numbers"), line.npos)
            << line;
        EXPECT_NE(line.find(c.found), line.npos) << line;
    }
    // What other programs write and the parser takes; a number too small for a double is 0.
    const Scene scene =
        load_text("v +0 .0 0.\nv 1.0E+0 0 1e-400 0.5 0.5 0.5\nv 0 1 0 1 # w\nf 1 2 3\n");
    EXPECT_EQ(scene.meshes.at(0).positions[1], glm::vec3(1.0f, 0.0f, 0.0f));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(Obj, CoordinatesAndNormalsThatAreNoNumbersAreReadAsZeroWithAWarning) {
    const Scene scene = load_text(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0,5 0,5\nvt nan 1\nvt 0.25\nvn 0 zero 1\n"
        "f 1/1/1 2/2/1 3/3/1\n");
    const Mesh& mesh = scene.meshes.at(0);
    EXPECT_EQ(mesh.texcoord0[0], glm::vec2(0.0f, 1.0f));  // v runs down in Mesh
    EXPECT_EQ(mesh.texcoord0[1], glm::vec2(0.0f, 1.0f));
    EXPECT_EQ(mesh.texcoord0[2], glm::vec2(0.25f, 1.0f)) << "one coordinate is enough";
    EXPECT_EQ(mesh.normals[0], glm::vec3(0.0f, 0.0f, 1.0f));
    EXPECT_TRUE(warns(scene,
                      "model.obj: line 4: vt: expected 2 finite numbers up to 2^24, found "
                      "\"0,5\" (OBJ has decimal points, no commas): 0 is read (and 1 more "
                      "such line)"));
    EXPECT_TRUE(warns(scene, "line 7: vn: expected 3 finite numbers up to 2^24, found \"zero\""));
}

TEST(Obj, CornersThatAreNoNumbersOrNameNothingAreNamed) {
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 0.5\n";
    for (const char* corner : {"x", "1,5", "1.5", "1/2/3/4", "/1", "1/x", "1-2"}) {
        const std::string line = error_of(vertices + "f 1 2 " + corner + "\n");
        EXPECT_NE(line.find("line 5: f: expected corners such as 7, 7/1, 7//3 or 7/1/3, found"),
                  line.npos)
            << line;
    }
    EXPECT_NE(error_of(vertices + "f 1 2 3\nf 1 2 9\n")
                  .find("line 6: f: expected vertex numbers from 1 to 3, found 9"),
              std::string::npos);
    EXPECT_NE(error_of(vertices + "f 1 2 -9\n").find("or back from -1 to -3, found -9"),
              std::string::npos);
    // A missing normal is computed; a missing texture coordinate is 0.
    const Scene scene = load_text(vertices + "f 1/9/9 2/1/7 3/1/-8\n");
    EXPECT_EQ(scene.meshes.at(0).normals[0], glm::vec3(0.0f, 0.0f, 1.0f));
    EXPECT_EQ(scene.meshes[0].texcoord0[1], glm::vec2(0.5f, 0.5f));
    EXPECT_TRUE(warns(scene, "line 5: f: no texture coordinate 9, the file has 1"));
    EXPECT_TRUE(warns(scene, "line 5: f: no normal -8"));
    // Zeros for what a corner lacks, slashes at the end and comments are what programs write.
    const Scene zeros = load_text(vertices + "f 1/0/0 2// 3/1/ # a face\n");
    EXPECT_EQ(zeros.meshes.at(0).indices.size(), 3u);
    EXPECT_EQ(zeros.meshes[0].texcoord0[2], glm::vec2(0.5f, 0.5f));
    EXPECT_TRUE(warns(load_text(vertices + "f 1 2 3\nf 1 2\n"),
                      "line 6: f: expected three corners or more, found 2: the face is not drawn"));
}

// Names of old programs: "Köper" in Windows-1252, here in the model, there in UTF-8.
TEST(Obj, NamesThatAreNotUtf8AreReadAsWindows1252) {
    const TemporaryFolder folder;
    folder.write("K\xC3\xB6per.mtl", std::string_view("newmtl K\xC3\xB6per\nKd 1 0 0\n"));
    const Scene scene = load_obj(folder.write(
        "model.obj", std::string_view("mtllib K\xF6per.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
                                      "usemtl K\xF6per\nf 1 2 3\n")));
    EXPECT_EQ(scene.materials.at(0).name, "K\xC3\xB6per");
    EXPECT_EQ(scene.materials[0].base_color, glm::vec4(1, 0, 0, 1));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(Obj, TruncationsAndFlippedBytesNeverCrash) {
    const std::string whole = "mtllib m.mtl\n" + std::string(kCube) +
                              "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nusemtl a\ns 1\n" +
                              "f 1/1/1 2/2/1 3/3/1 4//1\n" + std::string(kFaces);
    const std::string library = "newmtl a\nKd 1 0.5 0.2\nNs 20\nmap_Kd -s 2 2 x.png\nnorm y.png\n";
    const TemporaryFolder folder;
    folder.write("m.mtl", library);
    const auto attempt = [&](const std::string& text) {
        const auto path = folder.write("model.obj", text);
        try {
            load_obj(path);
        } catch (const Error&) {
        }
    };
    for (std::size_t length = 0; length < whole.size(); length += 3)
        attempt(whole.substr(0, length));
    std::mt19937 random(1);
    for (int i = 0; i < 300; ++i) {
        std::string text = whole;
        for (int k = 0; k < 1 + i % 4; ++k)
            text[random() % text.size()] = static_cast<char>(random());
        attempt(text);
    }
    for (std::size_t i = 0; i < 100; ++i) {
        std::string text = library;
        text[random() % text.size()] = static_cast<char>(random());
        folder.write("m.mtl", text);
        attempt(whole);
    }
}

TEST(Mtl, MaterialsAndTextures) {
    const TemporaryFolder folder;
    folder.write("maps/a b.png", png_gradient(2, 2));
    folder.write("n.png", png_gradient(2, 2));
    folder.write("h.png", png_gradient(2, 2));
    folder.write("lib.mtl",
                 std::string_view("newmtl phong one\nKd 0.5 0.25 0.125\nKs 1 1 1\nNs 30\n"
                                  "d 0.5\nmap_Kd maps\\a b.png\nmap_Bump h.png\n"
                                  "newmtl pbr\nKd 1 1 1\nPr 0.3\nPm 1\naniso 0.5\n"
                                  "Ke 2 0 0\nnorm n.png\nmap_Kd missing.png\n"));
    const auto path =
        folder.write("model.obj", std::string_view("mtllib lib.mtl\n"
                                                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\n"
                                                   "vt 0 1\nusemtl phong one\nf 1/1 2/2 3/3\n"
                                                   "usemtl pbr\nf 1/1 2/2 3/3\nusemtl gone\n"
                                                   "f 1/1 2/2 3/3\n"));
    const Scene scene = load_obj(path);
    ASSERT_EQ(scene.materials.size(), 3u);
    const Material& phong = scene.materials[0];
    EXPECT_EQ(phong.name, "phong one");
    EXPECT_EQ(phong.base_color, glm::vec4(0.5f, 0.25f, 0.125f, 0.5f));
    EXPECT_EQ(phong.alpha_mode, AlphaMode::blend);
    EXPECT_EQ(phong.metallic, 0.0f);
    EXPECT_NEAR(gltf_lobe_of(phong)->roughness, std::sqrt(std::sqrt(2.0f / 32.0f)), 1e-6f);
    ASSERT_TRUE(phong.base_color_texture);
    EXPECT_FALSE(phong.normal_texture);  // a height map is not a normal map
    EXPECT_TRUE(warns(scene, "map_Bump"));
    const Material& pbr = scene.materials[1];
    EXPECT_EQ(gltf_lobe_of(pbr)->roughness, 0.3f);
    EXPECT_EQ(pbr.metallic, 1.0f);
    EXPECT_EQ(gltf_lobe_of(pbr)->anisotropy_strength, 0.5f);
    EXPECT_EQ(pbr.emissive.x, 2.0f);
    EXPECT_TRUE(pbr.normal_texture);
    EXPECT_FALSE(pbr.base_color_texture);
    EXPECT_TRUE(warns(scene, "missing.png"));
    EXPECT_TRUE(warns(scene, "gone"));
    ASSERT_EQ(scene.textures.size(), 2u);
    EXPECT_EQ(
        scene.textures[static_cast<std::size_t>(phong.base_color_texture.texture)].color_space,
        ColorSpace::srgb);
    EXPECT_EQ(scene.textures[static_cast<std::size_t>(pbr.normal_texture.texture)].color_space,
              ColorSpace::linear);
}

TEST(Mtl, MissingOrOutsideLibrariesAreWarnings) {
    const std::string faces = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    for (const char* name : {"gone.mtl", "../x.mtl", "/etc/passwd"}) {
        const Scene scene = load_text("mtllib " + std::string(name) + "\n" + faces);
        EXPECT_TRUE(warns(scene, "mtllib"));
        EXPECT_EQ(scene.instances.size(), 1u);
    }
}

TEST(Polygon, ConcaveOutlinesKeepTheirAreaAndDirection) {
    // A comb in the plane x + y + z = 0, which favors no coordinate plane.
    const glm::vec3 u = glm::normalize(glm::vec3(1, -1, 0));
    const glm::vec3 v = glm::normalize(glm::vec3(1, 1, -2));
    const glm::vec2 outline[] = {{0, 0}, {7, 0}, {7, 3}, {6, 3}, {6, 1}, {5, 1}, {5, 3}, {4, 3},
                                 {4, 1}, {3, 1}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
    std::vector<glm::vec3> corners;
    for (const glm::vec2 p : outline) corners.push_back(p.x * u + p.y * v);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangulate(corners, triangles);
    ASSERT_EQ(triangles.size(), corners.size() - 2);
    const glm::vec3 normal = glm::cross(u, v);
    double area = 0.0;
    for (const auto& t : triangles) {
        const double part = 0.5 * glm::dot(normal, glm::cross(corners[t[1]] - corners[t[0]],
                                                              corners[t[2]] - corners[t[0]]));
        EXPECT_GT(part, 0.0);
        area += part;
    }
    EXPECT_NEAR(area, 7.0 + 4.0 * 2.0, 1e-4);  // the back of the comb and four teeth
}

TEST(Polygon, QuadrilateralsAreCutInside) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    // An arrow head: only the diagonal from the notch (corner 3) is inside.
    triangulate({{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}}, triangles);
    ASSERT_EQ(triangles.size(), 2u);
    for (const auto& t : triangles) EXPECT_TRUE(t[0] == 3 || t[1] == 3 || t[2] == 3);
    for (const auto& t : triangles) EXPECT_TRUE(t[0] == 1 || t[1] == 1 || t[2] == 1);
}

TEST(Polygon, AnythingComesOutAsTriangles) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f);
    for (std::size_t count = 3; count < 256; count += 7) {
        std::vector<glm::vec3> corners;
        for (std::size_t i = 0; i < count; ++i)
            corners.emplace_back(coordinate(random), coordinate(random), coordinate(random));
        std::vector<std::array<std::uint32_t, 3>> triangles;
        triangulate(corners, triangles);
        EXPECT_EQ(triangles.size(), count - 2);
        triangles.clear();
        triangulate(std::vector<glm::vec3>(count, glm::vec3(1.0f)), triangles);
        EXPECT_EQ(triangles.size(), count - 2);
    }
}

TEST(Obj, TeapotLoads) {
    const auto data = test::sample_data();
    if (data.empty()) GTEST_SKIP() << "no sample data (set BURNISH_DATA)";
    const Scene scene = load_model((data / "meshes" / "teapot_wdas.obj").string());
    ASSERT_EQ(scene.meshes.size(), 1u);
    // 6400 triangles in the file; 80 of them use a vertex twice (at the lid and the bottom).
    EXPECT_EQ(scene.meshes[0].indices.size(), 3u * 6320u);
    for (const glm::vec3 n : scene.meshes[0].normals) EXPECT_NEAR(glm::length(n), 1.0f, 1e-5f);
}

}  // namespace
}  // namespace burnish
