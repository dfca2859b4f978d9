// Material libraries as programs write them: bump maps, pictures of other names, keys and positions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "burnish/image_io.hpp"
#include "formats/obj/mtl_text.hpp"
#include "formats/obj/obj.hpp"
#include "gltf_support.hpp"
#include "image/texel_value.hpp"
#include "maps/normal/normal_map_look.hpp"

namespace burnish {
namespace {

using test::warns;

constexpr std::string_view kTriangle =
    "mtllib lib.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3\n";

using Paint = std::function<glm::vec4(float u, float v)>;

// A model folder with one triangle of the material "m".
class ModelFolder {
  public:
    void picture(const std::string& name, int size, int channels, const Paint& paint) const {
        Image image(size, size, channels);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const auto at = [&](int i) {
                    return (static_cast<float>(i) + 0.5f) / static_cast<float>(size);
                };
                const glm::vec4 color = paint(at(x), at(y));
                for (int c = 0; c < channels; ++c) image.at(x, y)[c] = color[c];
            }
        std::filesystem::create_directories((folder_.path() / name).parent_path());
        write_image(folder_.path() / name, image, {});
    }
    Scene load(const std::string& keys, const std::string& library = "lib.mtl") const {
        folder_.write(library, std::string_view("newmtl m\n" + keys));
        return load_obj(folder_.write("model.obj", kTriangle));
    }
    const TemporaryFolder& folder() const { return folder_; }

  private:
    TemporaryFolder folder_;
};

// The normals of a round bump, encoded as normal maps encode them.
glm::vec4 dome(float u, float v) {
    const glm::vec2 p(2.0f * u - 1.0f, 2.0f * v - 1.0f);
    const float r2 = glm::dot(p, p);
    const glm::vec3 n = r2 < 0.5f ? glm::vec3(p.x, -p.y, std::sqrt(1.0f - r2)) : glm::vec3(0, 0, 1);
    return glm::vec4(0.5f * n + 0.5f, 1.0f);
}
glm::vec4 height(float u, float v) {
    return glm::vec4(glm::vec3(std::sin(9.0f * u) * std::sin(7.0f * v) * 0.5f + 0.5f), 1.0f);
}
glm::vec4 red(float, float) {
    return {1.0f, 0.0f, 0.0f, 1.0f};
}

Texture texture_of(const Scene& scene, const TextureUse& use) {
    return scene.textures.at(static_cast<std::size_t>(use.texture));
}

TEST(NormalMapLook, TellsNormalsFromHeightsAndPhotographs) {
    const ModelFolder model;
    const auto looks = [&](const Paint& paint, int channels = 3) {
        model.picture("look.png", 32, channels, paint);
        return looks_like_normal_map(
            read_texture(model.folder().path() / "look.png", ColorSpace::linear));
    };
    EXPECT_TRUE(looks(dome));
    EXPECT_TRUE(looks(dome, 4));
    EXPECT_TRUE(looks([](float, float) { return glm::vec4(0.5f, 0.5f, 1.0f, 1.0f); }));
    // A chart in a black picture: padding does not count.
    EXPECT_TRUE(looks([](float u, float v) { return u < 0.3f ? dome(u, v) : glm::vec4(0.0f); }));
    EXPECT_FALSE(looks(height));
    EXPECT_FALSE(looks(height, 1));
    EXPECT_FALSE(looks([](float, float) { return glm::vec4(0.0f, 0.0f, 0.0f, 1.0f); }));
    // A sky: its mean is near +z, its lengths are not 1.
    EXPECT_FALSE(looks([](float, float v) {
        return glm::vec4(0.3f + 0.3f * v, 0.45f + 0.2f * v, 0.8f + 0.1f * v, 1.0f);
    }));
    // An object-space map: unit vectors in all directions.
    EXPECT_FALSE(looks([](float u, float v) {
        const float a = 6.2832f * u, z = 2.0f * v - 1.0f, r = std::sqrt(1.0f - z * z);
        return glm::vec4(0.5f + 0.5f * glm::vec3(r * std::cos(a), r * std::sin(a), z), 1.0f);
    }));
}

TEST(Mtl, BumpMapsThatAreNormalMapsAreDrawnAsNormHasThem) {
    const ModelFolder model;
    model.picture("n.png", 32, 3, dome);
    const Material with_norm = model.load("norm -bm 0.5 -s 2 2 n.png\n").materials.at(0);
    ASSERT_TRUE(with_norm.normal_texture);
    for (const char* key : {"map_Bump", "map_bump", "bump", "MAP_BUMP"}) {
        const Scene scene = model.load(std::string(key) + " -bm 0.5 -s 2 2 n.png\n");
        EXPECT_EQ(scene.materials.at(0).normal_texture, with_norm.normal_texture) << key;
        EXPECT_EQ(scene.materials[0].normal_scale, 0.5f) << key;
        ASSERT_EQ(scene.warnings.size(), 1u);
        EXPECT_TRUE(warns(scene, "n.png looks like a tangent-space normal map")) << key;
    }
    EXPECT_TRUE(model.load("map_Bump n.png -bm 2\n").materials.at(0).normal_texture)
        << "options after the name";
}

TEST(Mtl, HeightMapsAreNotDrawnAndSaidToBe) {
    const ModelFolder model;
    model.picture("h.png", 32, 3, height);
    model.picture("n.png", 32, 3, dome);
    const Scene scene = model.load("map_Bump -bm 0.5 h.png\n");
    EXPECT_FALSE(scene.materials.at(0).normal_texture);
    EXPECT_EQ(scene.materials[0].normal_scale, 1.0f);
    EXPECT_TRUE(scene.textures.empty()) << "a picture that nothing draws is dropped";
    EXPECT_TRUE(
        warns(scene, "\"m\": map_Bump h.png does not look like a tangent-space normal map"));
    EXPECT_TRUE(warns(scene, "--normal-map"));
    const Scene both = model.load("norm n.png\nmap_Bump h.png\n");
    EXPECT_TRUE(both.materials.at(0).normal_texture);
    EXPECT_TRUE(warns(both, "map_Bump is not read beside norm"));
}

TEST(Mtl, BlackKdBesideAPictureIsDrawnWhite) {
    const ModelFolder model;
    model.picture("c.png", 4, 3, red);
    const Scene scene = model.load("Kd 0 0 0\nd 0.5\nmap_Kd c.png\n");
    EXPECT_EQ(scene.materials.at(0).base_color, glm::vec4(1.0f, 1.0f, 1.0f, 0.5f));
    EXPECT_TRUE(warns(scene, "\"m\": Kd 0 0 0 would make map_Kd black"));
    // Without the picture black is meant; another factor is, too.
    EXPECT_EQ(model.load("Kd 0 0 0\n").materials.at(0).base_color, glm::vec4(0, 0, 0, 1));
    EXPECT_EQ(model.load("Kd 0 0 0\nmap_Kd none.png\n").materials.at(0).base_color,
              glm::vec4(0, 0, 0, 1));
    EXPECT_EQ(model.load("Kd 0 0.1 0\nmap_Kd c.png\n").materials.at(0).base_color,
              glm::vec4(0, 0.1f, 0, 1));
}

TEST(Mtl, PicturesOfOtherNamesAreFoundAndNamed) {
    const ModelFolder model;
    model.picture("tex/col.png", 4, 3, red);
    const struct {
        const char *name, *says;
    } cases[] = {{"tex/col.png", ""},
                 {"tex\\col.png", ""},
                 {"\"tex/col.png\"", ""},
                 {"Tex/COL.PNG", "of other letter case"},
                 {"C:\\Users\\artist\\project\\tex\\col.png", "of another folder"},
                 {"../somewhere/tex/col.png", "of another folder"},
                 {"/home/artist/col.png", "of another folder"},
                 {"col.tga", "of another folder and another ending"},
                 {"tex/col.jpg", "of another ending"}};
    for (const auto& c : cases) {
        const Scene scene = model.load(std::string("map_Kd ") + c.name + "\n");
        EXPECT_TRUE(scene.materials.at(0).base_color_texture) << c.name;
        ASSERT_EQ(scene.warnings.size(), *c.says ? 1u : 0u) << c.name;
        EXPECT_TRUE(!*c.says || warns(scene, c.says)) << c.name;
    }
    EXPECT_TRUE(warns(model.load("map_Kd gone.png\n"),
                      "lib.mtl: \"m\": map_Kd \"gone.png\": no such picture"));
}

TEST(Mtl, APictureThatCannotBeReadIsAWarning) {
    const ModelFolder model;
    model.folder().write("c.png", std::string_view("no picture"));
    model.picture("n.png", 8, 3, dome);
    const Scene scene = model.load("Kd 0 0 0\nmap_Kd c.png\nmap_Ke c.png\nnorm n.png\n");
    const Material& m = scene.materials.at(0);
    EXPECT_FALSE(m.base_color_texture);
    EXPECT_FALSE(m.emissive_texture);
    EXPECT_TRUE(m.normal_texture);
    EXPECT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(m.base_color, glm::vec4(0, 0, 0, 1));
    EXPECT_TRUE(warns(scene, "the texture is not used"));
}

TEST(Mtl, RoughnessAndMetalPicturesBecomeOneTexture) {
    const ModelFolder model;
    const auto ramp = [](float u, float) { return glm::vec4(u, 0.0f, 1.0f - u, 1.0f); };
    model.picture("r.png", 8, 3, ramp);
    model.picture("p.png", 4, 3, [](float, float v) { return glm::vec4(0.0f, v, 0.0f, 1.0f); });
    const Scene scene = model.load("Pr 0.25\nPm 0\nmap_Pr r.png\nmap_Pm -imfchan g p.png\n");
    const Material& m = scene.materials.at(0);
    EXPECT_EQ(gltf_lobe_of(m)->roughness, 1.0f);
    EXPECT_EQ(m.metallic, 1.0f);
    ASSERT_TRUE(m.metallic_roughness_texture);
    const Texture both = texture_of(scene, m.metallic_roughness_texture);
    EXPECT_EQ(both.width, 8);
    EXPECT_EQ(both.color_space, ColorSpace::linear);
    const auto at = [&](std::size_t x, std::size_t y, std::size_t c) {
        return texel_value(both, 3 * (y * 8 + x) + c);
    };
    for (std::size_t i = 0; i < 8; ++i) {
        // Half a code of 8 bits.
        EXPECT_NEAR(at(i, 3, 1), (static_cast<float>(i) + 0.5f) / 8.0f, 0.5f / 255.0f + 1e-6f);
        // The picture of 4 rows shows each of them twice.
        EXPECT_NEAR(at(2, i, 2), (static_cast<float>(i / 2) + 0.5f) / 4.0f, 0.5f / 255.0f + 1e-6f);
    }
    // One of them alone leaves the other number as it is.
    const Scene alone = model.load("Pr 0.25\nPm 1\nmap_Pm r.png\n");
    EXPECT_EQ(gltf_lobe_of(alone.materials.at(0))->roughness, 0.25f);
    EXPECT_EQ(texel_value(texture_of(alone, alone.materials[0].metallic_roughness_texture), 1),
              1.0f);
}

TEST(Mtl, AlphaPicturesJoinTheColor) {
    const ModelFolder model;
    model.picture("c.png", 4, 3, red);
    model.picture("cut.png", 8, 3, [](float u, float) {
        return glm::vec4(glm::vec3(u < 0.5f ? 0.0f : 1.0f), 1.0f);
    });
    model.picture("soft.png", 8, 3, [](float u, float) { return glm::vec4(glm::vec3(u), 1.0f); });
    model.picture("own.png", 8, 4, [](float u, float) {
        return glm::vec4(0.0f, 1.0f, 0.0f, u < 0.5f ? 0.0f : 1.0f);
    });
    const Scene cut = model.load("map_Kd c.png\nmap_d cut.png\n");
    EXPECT_EQ(cut.materials.at(0).alpha_mode, AlphaMode::mask);
    const Texture joined = texture_of(cut, cut.materials[0].base_color_texture);
    ASSERT_EQ(joined.channels, 4);
    EXPECT_EQ(joined.color_space, ColorSpace::srgb);
    EXPECT_EQ(texel_value(joined, 0), 1.0f);
    EXPECT_EQ(texel_value(joined, 1), 0.0f);
    EXPECT_EQ(texel_value(joined, 3), 0.0f);
    EXPECT_EQ(texel_value(joined, 4 * 7 + 3), 1.0f);
    EXPECT_EQ(model.load("d 0.5\nmap_Kd c.png\nmap_d cut.png\n").materials.at(0).alpha_mode,
              AlphaMode::blend);
    EXPECT_EQ(model.load("map_Kd c.png\nmap_d soft.png\n").materials.at(0).alpha_mode,
              AlphaMode::blend);
    const Scene own = model.load("map_Kd own.png\nmap_d own.png\n");
    EXPECT_EQ(own.materials.at(0).alpha_mode, AlphaMode::mask);
    EXPECT_EQ(own.textures.size(), 1u);
    const Scene without = model.load("Kd 1 0 0\nmap_d cut.png\n");
    EXPECT_EQ(without.materials.at(0).base_color, glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(texel_value(texture_of(without, without.materials[0].base_color_texture), 1), 1.0f);
    const Scene opaque = model.load("map_Kd c.png\nmap_d c.png\n");
    EXPECT_EQ(opaque.materials.at(0).alpha_mode, AlphaMode::opaque);
    EXPECT_TRUE(warns(opaque, "map_d has no alpha"));
}

TEST(Mtl, KeysThatAreNotReadAreNamedOnce) {
    const ModelFolder model;
    const std::string plain = "Ka 1 1 1\nNi 1.5\nillum 2\nTf 1 1.0 1.000\nPc 0\nPs 0.00\n";
    EXPECT_TRUE(model.load(plain).warnings.empty());
    const Scene scene = model.load(plain + "map_aniso a.png\nfoo 1\nPs 0.5\nmap_Ns n.png\n");
    EXPECT_EQ(scene.warnings.size(), 4u);
    for (const char* key : {"map_aniso", "foo", "Ps", "map_Ns"})
        EXPECT_TRUE(warns(scene, std::string("\"m\": ") + key + " is not read"));
    const Scene many = model.load(
        "disp d.png\nnewmtl b\ndisp d.png\nnewmtl c\ndisp d.png\n"
        "newmtl d\ndisp d.png\nnewmtl e\ndisp d.png\n");
    ASSERT_EQ(many.warnings.size(), 1u);
    EXPECT_TRUE(warns(many, "lib.mtl: \"m\", \"b\", \"c\" and 2 more: disp is not read"));
}

TEST(Mtl, AClearCoatIsRead) {
    const ModelFolder model;
    const Scene scene = model.load("Kd 1 0 0\nPc 0.75\nPcr 0.25\n");
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_EQ(scene.materials.at(0).coat.strength, 0.75f);
    EXPECT_EQ(scene.materials.at(0).coat.roughness, 0.25f);
    const Scene thick = model.load("Pc 30\nPcr -2\n");
    EXPECT_EQ(thick.materials.at(0).coat.strength, 1.0f);
    EXPECT_EQ(thick.materials.at(0).coat.roughness, 0.0f);
    EXPECT_TRUE(warns(thick, "lib.mtl: \"m\": Pc: 30 is not from 0 to 1: 1 is used"));
    EXPECT_FALSE(has_coat(model.load("Kd 1 0 0\n").materials.at(0)));
}

// The rule of glTF's factors.
TEST(Mtl, NumbersOutOfRangeAreClampedAndWordsAreNotRead) {
    const ModelFolder model;
    const Scene scene = model.load("Kd 0.5 2 -1\nPr 3\nPm -0.5\nd 7\nKe 1 nan 0\naniso much\n");
    const Material& m = scene.materials.at(0);
    EXPECT_EQ(m.base_color, glm::vec4(0.5f, 1.0f, 0.0f, 1.0f));
    EXPECT_EQ(gltf_lobe_of(m)->roughness, 1.0f);
    EXPECT_EQ(m.metallic, 0.0f);
    EXPECT_EQ(m.emissive, glm::vec3(0.0f));
    EXPECT_EQ(gltf_lobe_of(m)->anisotropy_strength, 0.0f);
    EXPECT_EQ(scene.warnings.size(), 6u);
    for (const char* line : {"Kd: 2 is not from 0 to 1: 1 is used", "Pr: 3 is not from 0 to 1: 1",
                             "Pm: -0.5 is not from 0 to 1: 0", "d: 7 is not from 0 to 1: 1",
                             "Ke: expected three numbers, found \"nan\": the key is not read",
                             "aniso: expected a number, found \"much\": the key is not read"})
        EXPECT_TRUE(warns(scene, std::string("lib.mtl: \"m\": ") + line)) << line;
    EXPECT_EQ(gltf_lobe_of(model.load("Ns -5\n").materials.at(0))->roughness, 1.0f)
        << "the exponent 0";
    // Without its key a color is the default one.
    EXPECT_EQ(model.load("Kd 0,5 0,5 0,5\n").materials.at(0).base_color,
              glm::vec4(0.8f, 0.8f, 0.8f, 1.0f));
    // One number stands for three.
    const Scene one = model.load("Kd 0.25\nNs 10 # soft\n");
    EXPECT_EQ(one.materials.at(0).base_color, glm::vec4(0.25f, 0.25f, 0.25f, 1.0f));
    EXPECT_TRUE(one.warnings.empty());
}

TEST(Mtl, KeysMayBeInAnyLetterCase) {
    const MtlText text = read_mtl_text("NEWMTL m\r\nKD 1 0 0\rMAP_KD\ta b.png\nmap_Kn n.png\n");
    EXPECT_EQ(text.text, "newmtl m\nKd 1 0 0\nmap_Kd a b.png\nnorm n.png\n");
    ASSERT_TRUE(text.materials.contains("m"));
    EXPECT_EQ(text.materials.at("m").at("map_Kd"), "a b.png");
}

// The parser takes three numbers after -s and -o, whatever follows.
TEST(Mtl, OptionsOfMapsAreMadeWhole) {
    const auto value = [](const std::string& map) {
        return read_mtl_text("newmtl m\nmap_Kd " + map + "\n").materials.at("m").at("map_Kd");
    };
    EXPECT_EQ(value("a.png"), "a.png");
    EXPECT_EQ(value("-s 2 a.png"), "-s 2 1 1 a.png");
    EXPECT_EQ(value("-s 2 3 -o 0.5 a b.png"), "-s 2 3 1 -o 0.5 0 0 a b.png");
    EXPECT_EQ(value("-s 1 2 3 4.png"), "-s 1 2 3 4.png");
    EXPECT_EQ(value("a b.png -bm 0.5 -clamp on"), "-bm 0.5 -clamp on a b.png");
    EXPECT_EQ(value("a -b.png"), "a -b.png");
    EXPECT_EQ(value("-cc on -imfchan g a.png"), "-imfchan g a.png");
    EXPECT_EQ(value("-s"), "-s 1 1 1 ");
    const ModelFolder model;
    model.picture("c.png", 4, 3, red);
    const TextureUse use = model.load("map_Kd -s 2 3 c.png\n").materials.at(0).base_color_texture;
    ASSERT_TRUE(use);
    EXPECT_EQ(use.transform[0][0], 2.0f);
    EXPECT_EQ(use.transform[1][1], 3.0f);
}

TEST(Mtl, LibrariesOfOtherNamesAreFound) {
    const ModelFolder model;
    const Scene other_case = model.load("Kd 1 0 0\n", "LIB.MTL");
    EXPECT_EQ(other_case.materials.at(0).base_color, glm::vec4(1, 0, 0, 1));
    EXPECT_TRUE(warns(other_case, "LIB.MTL is read in its place"));
    std::filesystem::remove(model.folder().path() / "LIB.MTL");
    const Scene renamed = model.load("Kd 0 1 0\n", "model.mtl");
    EXPECT_EQ(renamed.materials.at(0).base_color, glm::vec4(0, 1, 0, 1));
    EXPECT_TRUE(warns(renamed, "mtllib \"lib.mtl\": "));
}

TEST(Mtl, ALineOfLibrariesIsReadAsOneNameOrAsSeveral) {
    const TemporaryFolder folder;
    const auto color = [&](const std::string& line, const std::string& material) {
        const std::string text =
            "mtllib " + line + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl " + material + "\nf 1 2 3\n";
        return load_obj(folder.write("model.obj", std::string_view(text)))
            .materials.at(0)
            .base_color;
    };
    folder.write("a.mtl", std::string_view("\xEF\xBB\xBFnewmtl m\nKd 1 0 0\n"));
    folder.write("b.mtl", std::string_view("newmtl n\nKd 0 1 0\n"));
    EXPECT_EQ(color("a.mtl b.mtl", "m"), glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(color("a.mtl b.mtl", "n"), glm::vec4(0, 1, 0, 1));
    folder.write("a.mtl b.mtl", std::string_view("newmtl m\nKd 0 0 1\n"));
    EXPECT_EQ(color("a.mtl b.mtl", "m"), glm::vec4(0, 0, 1, 1));
}

// A sphere of rings, as a scanner writes it, somewhere on a map.
std::string sphere_at(glm::dvec3 center, double radius) {
    std::string text;
    constexpr int kRings = 16, kSides = 24;
    for (int r = 0; r <= kRings; ++r)
        for (int s = 0; s < kSides; ++s) {
            const double a = 3.14159265358979 * r / kRings, b = 6.28318530717959 * s / kSides;
            const glm::dvec3 p =
                center + radius * glm::dvec3(std::sin(a) * std::cos(b), std::cos(a),
                                             std::sin(a) * std::sin(b));
            char line[128];
            std::snprintf(line, sizeof line, "v %.6f %.6f %.6f\n", p.x, p.y, p.z);
            text += line;
        }
    for (int r = 0; r < kRings; ++r)
        for (int s = 0; s < kSides; ++s) {
            const int t = (s + 1) % kSides, low = r * kSides + 1, high = low + kSides;
            const auto face = [&](int i, int j, int k) {
                text += "f " + std::to_string(i) + " " + std::to_string(j) + " " +
                        std::to_string(k) + "\n";
            };
            face(low + s, high + s, high + t);
            face(low + s, high + t, low + t);
        }
    return text;
}

Scene load_shape(const std::string& text) {
    const TemporaryFolder folder;
    return load_obj(folder.write("model.obj", std::string_view(text)));
}

TEST(Obj, ModelsFarFromTheOriginKeepTheirShape) {
    const Scene here = load_shape(sphere_at(glm::dvec3(0.0), 3.0));
    const Scene there = load_shape(sphere_at({447321.0, 5411823.0, 412.0}, 3.0));
    ASSERT_EQ(there.meshes.size(), 1u);
    ASSERT_EQ(there.meshes[0].positions.size(), here.meshes[0].positions.size());
    // The center is a multiple of 10 (one digit of a diagonal of 10.4), so the spheres differ by a
    // whole vector; six decimals of the file and half a step of a float at 8 m are the rest.
    const glm::vec3 shift = there.meshes[0].positions[0] - here.meshes[0].positions[0];
    for (std::size_t i = 0; i < here.meshes[0].positions.size(); ++i) {
        const glm::vec3 moved = there.meshes[0].positions[i] - shift;
        EXPECT_LT(glm::length(moved - here.meshes[0].positions[i]), 4e-6f) << i;
        EXPECT_LT(glm::length(there.meshes[0].normals[i] - here.meshes[0].normals[i]), 1e-4f) << i;
    }
    EXPECT_LT(glm::length(shift), 10.0f);
    EXPECT_TRUE(warns(there, "(447320, 5411820, 410) is subtracted"));
    EXPECT_FALSE(warns(here, "subtracted"));
}

TEST(Obj, AMarkOfUtf8AndLinesOfCarriageReturnsAreRead) {
    EXPECT_EQ(load_shape("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").meshes.size(), 1u);
    EXPECT_EQ(load_shape("# old\rv 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r").meshes.size(), 1u);
}

TEST(Obj, ModelsNearTheOriginStayWhereTheyAre) {
    // 99 and 101 diagonals away: a diagonal of the box of a sphere is 2 sqrt(3) radii.
    const double diagonal = 2.0 * std::sqrt(3.0);
    EXPECT_FALSE(warns(load_shape(sphere_at({98.0 * diagonal, 0, 0}, 1.0)), "subtracted"));
    EXPECT_TRUE(warns(load_shape(sphere_at({101.0 * diagonal, 0, 0}, 1.0)), "subtracted"));
    // Vertices that no face uses decide nothing; one point is no size.
    EXPECT_FALSE(
        warns(load_shape("v 1e8 1e8 1e8\n" + sphere_at(glm::dvec3(0.0), 1.0) + "f 2 3 4\n"),
              "subtracted"));
    EXPECT_FALSE(warns(load_shape("v 1e8 0 0\nv 1e8 0 0\nv 1e8 0 0\nf 1 2 3\n"), "subtracted"));
}

}  // namespace
}  // namespace burnish
