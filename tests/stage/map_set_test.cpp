// Roles of maps by the names that libraries of materials give them.
#include "stage/map_set.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/layered_materials.hpp"
#include "burnish/load_model.hpp"
#include "image/texel_value.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

using namespace test;

TEST(MapSets, NamesOfLibrariesStateRoles) {
    struct Named {
        const char* file;
        std::optional<MapRole> role;
    };
    const Named all[] = {
        // ambientCG
        {"Metal032_2K-JPG_Color.jpg", MapRole::base_color},
        {"Metal032_2K_NormalGL.jpg", MapRole::normal},
        {"Metal032_2K_NormalDX.jpg", MapRole::normal_directx},
        {"Metal032_2K_Metalness.png", MapRole::metallic},
        {"Metal032_2K_Roughness.png", MapRole::roughness},
        {"Metal032_2K_Displacement.png", MapRole::height},
        {"Fabric004_4K_AmbientOcclusion.png", MapRole::occlusion},
        {"Metal032_2K.png", std::nullopt},
        // Poly Haven
        {"rusty_metal_02_diff_2k.jpg", MapRole::base_color},
        {"rusty_metal_02_nor_gl_2k.exr", MapRole::normal},
        {"rusty_metal_02_nor_dx_2k.exr", MapRole::normal_directx},
        {"rusty_metal_02_rough_2k.exr", MapRole::roughness},
        {"rusty_metal_02_arm_2k.jpg", MapRole::orm},
        {"rusty_metal_02_ao_2k.jpg", MapRole::occlusion},
        {"rusty_metal_02_metal_2k.exr", MapRole::metallic},
        {"rusty_metal_02_disp_2k.png", MapRole::height},
        // cgbookcase
        {"Fabric01_2K_BaseColor.png", MapRole::base_color},
        {"Fabric01_2K_Height.png", MapRole::height},
        {"Fabric01_2K_AO.png", MapRole::occlusion},
        // Substance
        {"Door_Base_Color.tga", MapRole::base_color},
        {"Door_OcclusionRoughnessMetallic.png", MapRole::orm},
        {"Door_Normal_OpenGL.png", MapRole::normal},
        {"Door_Normal_DirectX.png", MapRole::normal_directx},
        {"Door_Glossiness.png", MapRole::glossiness},
        {"Default_metalRoughness.jpg", MapRole::metallic_roughness},
        {"metallic_roughness.png", MapRole::metallic_roughness},
        {"DefaultMaterial_Emissive.1001.png", MapRole::emissive},
        {"Door_ambient_occlusion.png", MapRole::occlusion},
        // Unity
        {"Rock_AlbedoTransparency.png", MapRole::base_color},
        {"Rock_MetallicSmoothness.png", MapRole::metallic_smoothness},
        {"Rock_Metallic_Gloss.tga", MapRole::metallic_smoothness},
        {"Rock_MetallicGlossMap.png", MapRole::metallic_smoothness},
        {"Rock_MaskMap.png", MapRole::mask_map},
        {"Rock_SpecularSmoothness.png", std::nullopt},
        {"Rock_Smoothness.png", MapRole::glossiness},
        // Unreal
        {"T_Rock_BC.png", MapRole::base_color},
        {"T_Rock_N.png", MapRole::normal_directx},
        {"T_Rock_Normal.png", MapRole::normal_directx},
        {"T_Rock_NormalGL.png", MapRole::normal},
        {"T_Rock_ORM.png", MapRole::orm},
        {"T_Rock_ORDp.png", MapRole::occlusion_roughness},
        {"T_Rock_R.png", MapRole::roughness},
        {"T_Rock_M_2K.png", MapRole::metallic},
        {"T_Rock_AO.png", MapRole::occlusion},
        {"Rock_N.png", MapRole::normal},
        {"n.png", std::nullopt},
        {"Rock_B.png", std::nullopt},
        // burnish
        {"base_color.png", MapRole::base_color},
        {"orm.png", MapRole::orm},
        {"anisotropy.png", MapRole::anisotropy},
        {"preview.png", std::nullopt},
    };
    for (const Named& named : all) EXPECT_EQ(map_role_of(named.file), named.role) << named.file;
}

bool says(const std::vector<std::string>& lines, std::initializer_list<std::string_view> parts) {
    return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
        return std::all_of(parts.begin(), parts.end(),
                           [&](std::string_view part) { return line.find(part) != line.npos; });
    });
}

// A picture of one value.
void flat(const std::filesystem::path& path, float r, float g, float b) {
    Image image(4, 4, 3);
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
        image.pixels[i] = r;
        image.pixels[i + 1] = g;
        image.pixels[i + 2] = b;
    }
    write_image(path, image, {});
}

TEST(MapSets, TwoCandidatesAreNamedAndNoneIsGuessed) {
    const ScratchFolder folder;
    flat(folder / "a_Roughness.png", 0.5f, 0.5f, 0.5f);
    flat(folder / "b_Roughness.png", 0.5f, 0.5f, 0.5f);
    const std::string line = error_line([&] { find_map_set(folder / ""); });
    EXPECT_NE(line.find("roughness"), line.npos) << line;
    EXPECT_NE(line.find("a_Roughness.png"), line.npos) << line;
    EXPECT_NE(line.find("b_Roughness.png"), line.npos) << line;
}

// Formats that keep the same: neither is a better guess.
TEST(MapSets, OneMapInTwoFormatsIsTheOneThatKeepsMoreAndTheOtherIsNamed) {
    const ScratchFolder folder;
    flat(folder / "a_Color.png", 0.5f, 0.5f, 0.5f);
    flat(folder / "a_Color.jpg", 0.5f, 0.5f, 0.5f);
    const MapSet set = find_map_set(folder / "");
    EXPECT_EQ(set.files.at(MapRole::base_color).filename(), "a_Color.png");
    ASSERT_EQ(set.notes.size(), 1u);
    EXPECT_NE(set.notes[0].find("a_Color.jpg: passed over, a_Color.png is the same map"),
              std::string::npos);
    std::filesystem::rename(folder / "a_Color.png", folder / "a_Color.tga");
    const std::string line = error_line([&] { find_map_set(folder / ""); });
    EXPECT_NE(line.find("a_Color.jpg"), line.npos) << line;
    EXPECT_NE(line.find("a_Color.tga"), line.npos) << line;
}

TEST(MapSets, OpenGlComesBeforeDirectX) {
    const ScratchFolder folder;
    flat(folder / "x_NormalGL.png", 0.5f, 0.5f, 1.0f);
    flat(folder / "x_NormalDX.png", 0.5f, 0.5f, 1.0f);
    const MapSet set = find_map_set(folder / "");
    EXPECT_TRUE(set.files.contains(MapRole::normal));
    EXPECT_FALSE(set.files.contains(MapRole::normal_directx));
}

ParameterValues maps_of(const ScratchFolder& folder) {
    ParameterValues values;
    values.set("maps", (folder / "").string(), "--maps");
    return values;
}

Scene plane_with(const ParameterValues& values) {
    Scene scene = load_model("builtin:plane", 0);
    apply_material_parameters(scene, values);
    return scene;
}

TEST(MapSets, AFolderIsAWholeMaterial) {
    const ScratchFolder folder;
    flat(folder / "x_Color.png", 0.5f, 0.5f, 0.5f);
    flat(folder / "x_Gloss.png", 0.25f, 0.25f, 0.25f);
    flat(folder / "x_NormalDX.png", 0.5f, 0.5f, 1.0f);
    const Scene scene = plane_with(maps_of(folder));
    const Material& m = scene.materials.front();
    EXPECT_TRUE(m.base_color_texture);
    EXPECT_TRUE(m.flip_green);
    EXPECT_EQ(m.metallic, 0.0f) << "no map of metal: a dielectric";
    ASSERT_NE(gltf_lobe_of(m), nullptr);
    EXPECT_EQ(gltf_lobe_of(m)->roughness, 1.0f) << "the factor; the map has the value";
    const Texture& surface =
        scene.textures[static_cast<std::size_t>(m.metallic_roughness_texture.texture)];
    std::uint16_t green = 0;
    std::memcpy(&green, surface.texels.data() + 2, 2);
    // 8 bits of the picture.
    EXPECT_NEAR(green / 65535.0, 0.75, 0.003);
}

void flat_with_alpha(const std::filesystem::path& path, float r, float g, float b, float a) {
    Image image(4, 4, 4);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = std::array{r, g, b, a}[i % 4];
    write_image(path, image, {});
}

// Red, green and blue of the first texel.
glm::vec3 first_texel(const Scene& scene, const TextureUse& use) {
    const Texture& t = scene.textures[static_cast<std::size_t>(use.texture)];
    return {texel_value(t, 0), texel_value(t, 1), texel_value(t, 2)};
}

// Half a code of 8 bits, and a little for rounding.
constexpr float kHalfCode = 0.5f / 255.0f + 1e-5f;

TEST(MapSets, UnitysMapsHaveMetallicInRedAndSmoothnessInAlpha) {
    const ScratchFolder folder;
    flat_with_alpha(folder / "x_MetallicSmoothness.png", 0.75f, 0.1f, 0.2f, 0.25f);
    flat_with_alpha(folder / "x_AlbedoTransparency.png", 1.0f, 0.5f, 0.25f, 0.75f);
    const Scene scene = plane_with(maps_of(folder));
    const Material& m = scene.materials.front();
    EXPECT_EQ(m.alpha_mode, AlphaMode::mask);
    EXPECT_EQ(m.metallic, 1.0f) << "the factor; the map has the value";
    const glm::vec3 texel = first_texel(scene, m.metallic_roughness_texture);
    EXPECT_NEAR(texel.y, 0.75f, kHalfCode) << "roughness: 1 - smoothness";
    EXPECT_NEAR(texel.z, 0.75f, kHalfCode) << "metallic";
    EXPECT_TRUE(scene.warnings.empty());
    // Without an alpha there is no smoothness.
    flat(folder / "x_MetallicSmoothness.png", 0.75f, 0.1f, 0.2f);
    const Scene without = plane_with(maps_of(folder));
    EXPECT_TRUE(
        says(without.warnings, {"x_MetallicSmoothness.png: expected smoothness in the alpha "
                                "channel, found 3 channels without alpha"}));
    const Material& n = without.materials.front();
    EXPECT_NEAR(first_texel(without, n.metallic_roughness_texture).z, 0.75f, kHalfCode);
    EXPECT_EQ(gltf_lobe_of(n)->roughness, 1.0f);
}

TEST(MapSets, MaskMapsAndMegascansMapsAreReadByTheirChannels) {
    const ScratchFolder folder;
    flat_with_alpha(folder / "x_MaskMap.png", 0.75f, 0.5f, 0.1f, 0.25f);
    const Scene mask = plane_with(maps_of(folder));
    const Material& m = mask.materials.front();
    const glm::vec3 texel = first_texel(mask, m.metallic_roughness_texture);
    EXPECT_NEAR(texel.y, 0.75f, kHalfCode);
    EXPECT_NEAR(texel.z, 0.75f, kHalfCode);
    const Texture& occlusion = mask.textures[static_cast<std::size_t>(m.occlusion_texture.texture)];
    EXPECT_NEAR(texel_value(occlusion, 0), 0.5f, kHalfCode);
    const ScratchFolder second;
    flat(second / "T_x_ORDp.png", 0.75f, 0.5f, 0.25f);
    const Scene scan = plane_with(maps_of(second));
    const Material& n = scan.materials.front();
    EXPECT_NEAR(first_texel(scan, n.occlusion_texture).x, 0.75f, kHalfCode);
    EXPECT_NEAR(first_texel(scan, n.metallic_roughness_texture).y, 0.5f, kHalfCode);
    EXPECT_EQ(n.metallic, 0.0f) << "blue is a displacement";
}

// One rule for flags, folders and scene files, which all name maps by these parameters.
TEST(MapSets, GrayPicturesOfPackedMapsAreNamed) {
    const ScratchFolder folder;
    write_image(folder / "gray.png", Image(4, 4, 1), {});
    flat(folder / "rgb.png", 0.5f, 0.5f, 0.5f);
    for (const char* name : {"orm_map", "anisotropy_map"}) {
        ParameterValues values;
        values.set(name, (folder / "gray.png").string(), name);
        EXPECT_TRUE(says(plane_with(values).warnings,
                         {"gray.png: expected a ", "found a gray picture: every property"}))
            << name;
        values.set(name, (folder / "rgb.png").string(), name);
        EXPECT_TRUE(plane_with(values).warnings.empty()) << name;
    }
    ParameterValues one;
    one.set("roughness_map", (folder / "gray.png").string(), "roughness_map");
    EXPECT_TRUE(plane_with(one).warnings.empty()) << "a map of one property";
}

TEST(MapSets, AFlipOfADirectXMapIsSaidToChangeNothing) {
    const ScratchFolder folder;
    flat(folder / "x_Color.png", 0.5f, 0.5f, 0.5f);
    flat(folder / "x_NormalDX.png", 0.5f, 0.5f, 1.0f);
    ParameterValues values = maps_of(folder);
    values.set("flip_green", "true", "--flip-green");
    const Scene flipped = plane_with(values);
    EXPECT_TRUE(flipped.materials.front().flip_green);
    EXPECT_TRUE(says(flipped.warnings, {"flip_green: ", "--flip-green=false", "nothing changes"}));
    values.set("flip_green", "false", "--flip-green");
    const Scene plain = plane_with(values);
    EXPECT_FALSE(plain.materials.front().flip_green);
    EXPECT_TRUE(plain.warnings.empty());
    // Another map in its place has a green of its own.
    values.set("flip_green", "true", "--flip-green");
    values.set("normal_map", "builtin:bumps", "--normal-map");
    EXPECT_FALSE(says(plane_with(values).warnings, {"flip_green: "}));
}

TEST(MapSets, FoldersAroundAFolderOfMapsNameIt) {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder / "rust_2k/textures");
    folder.write("rust_2k/rust_metal.blend", "no picture");
    flat(folder / "rust_2k/textures/rust_diff_2k.png", 0.5f, 0.5f, 0.5f);
    const std::string wanted = "did you mean \"" + (folder / "rust_2k/textures").string() + "\"?";
    const std::string line = error_line<UsageError>([&] { find_map_set(folder / "rust_2k"); });
    EXPECT_NE(line.find(wanted), line.npos) << line;
    ParameterValues values;
    values.set("normal_map", (folder / "rust_2k").string(), "--normal-map");
    const std::string map = error_line<UsageError>([&] { plane_with(values); });
    EXPECT_NE(map.find("a folder with maps in \"" + (folder / "rust_2k/textures").string()),
              map.npos)
        << map;
}

TEST(MapSets, FlagsMultiplyAndReplace) {
    const ScratchFolder folder;
    flat(folder / "x_Color.png", 0.5f, 0.5f, 0.5f);
    flat(folder / "x_Roughness.png", 0.5f, 0.5f, 0.5f);
    flat(folder / "other.png", 1.0f, 1.0f, 1.0f);
    ParameterValues values = maps_of(folder);
    values.set("roughness", "0.5", "--roughness");
    values.set("metallic_map", (folder / "other.png").string(), "--metallic-map");
    values.set("uv_scale", "3", "--uv-scale");
    values.set("base_color_map", "none", "--base-color-map");
    const Material m = plane_with(values).materials.front();
    EXPECT_EQ(gltf_lobe_of(m)->roughness, 0.5f);
    EXPECT_EQ(m.metallic, 1.0f);
    EXPECT_FALSE(m.base_color_texture);
    EXPECT_EQ(m.metallic_roughness_texture.transform[0][0], 3.0f);
}

// A ramp that rises by 1 over the texture square, `height_scale` high, has slope height_scale along u.
TEST(MapSets, AHeightMapHasTheNormalsOfItsSlopes) {
    const ScratchFolder folder;
    constexpr int kSize = 64;
    Image ramp(kSize, kSize, 3);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            for (int c = 0; c < 3; ++c) ramp.at(x, y)[c] = (static_cast<float>(x) + 0.5f) / kSize;
    write_image(folder / "h.exr", ramp, {});
    ParameterValues values;
    values.set("height_map", (folder / "h.exr").string(), "--height-map");
    values.set("height_scale", "0.5", "--height-scale");
    const Scene scene = plane_with(values);
    const Texture& normals =
        scene.textures[static_cast<std::size_t>(scene.materials.front().normal_texture.texture)];
    std::uint16_t rgb[3];
    std::memcpy(rgb, normals.texels.data() + 6 * (32 * kSize + 32), sizeof rgb);
    const double z = 1 / std::hypot(0.5, 1.0);
    // n leans against the rise.
    EXPECT_NEAR(rgb[0] / 65535.0, 0.5 - 0.5 * 0.5 * z, 1e-4);
    EXPECT_NEAR(rgb[1] / 65535.0, 0.5, 1e-4);
}

TEST(MapSets, WhatIsMissingIsSaid) {
    ParameterValues values;
    values.set("maps", "/no/such/folder", "--maps");
    EXPECT_THROW(plane_with(values), UsageError);
    const ScratchFolder folder;
    EXPECT_THROW(plane_with(maps_of(folder)), UsageError);
}

TEST(MapSets, TheNameOfTheSetIsNoRole) {
    const ScratchFolder folder;
    for (const char* name : {"Rusty_Metal_2K.png", "Rusty_Metal_2K_Color.png", "preview.png"})
        flat(folder / name, 0.5f, 0.5f, 0.5f);
    const MapSet set = find_map_set(folder / "");
    EXPECT_EQ(set.files.size(), 1U);
    EXPECT_TRUE(set.files.contains(MapRole::base_color));
}

TEST(MapSets, OfTwoFilesOfOneNameTheFinerIsTaken) {
    const ScratchFolder folder;
    for (const char* name : {"x_height.png", "x_height.exr", "x_height.jpg"})
        flat(folder / name, 0.5f, 0.5f, 0.5f);
    EXPECT_EQ(find_map_set(folder / "").files.at(MapRole::height).extension(), ".exr");
}

TEST(MapSets, AMapOfItsOwnReplacesTheChannelOfAnOrmMap) {
    const ScratchFolder folder;
    flat(folder / "x_orm.png", 0.25f, 0.5f, 1.0f);
    flat(folder / "rough.png", 0.75f, 0.75f, 0.75f);
    ParameterValues values = maps_of(folder);
    std::filesystem::create_directory(folder / "sub");
    std::filesystem::rename(folder / "rough.png", folder / "sub/rough.png");
    values.set("roughness_map", (folder / "sub/rough.png").string(), "--roughness-map");
    const Scene scene = plane_with(values);
    const Material& m = scene.materials.front();
    const Texture& surface =
        scene.textures[static_cast<std::size_t>(m.metallic_roughness_texture.texture)];
    std::uint16_t rgb[3];
    std::memcpy(rgb, surface.texels.data(), sizeof rgb);
    EXPECT_NEAR(rgb[1] / 65535.0, 0.75, 0.003);
    EXPECT_NEAR(rgb[2] / 65535.0, 1.0, 0.003);
    EXPECT_TRUE(m.occlusion_texture);
}

// Whether a line of `lines` holds all of `parts`.
TEST(MapSets, NotesAreNoWarningsAndNameWhatIsDrawn) {
    const ScratchFolder folder, other;
    for (const char* name : {"x_color.png", "x_roughness.png", "x_orm.png", "x_normal.png"})
        flat(folder / name, 0.5f, 0.5f, 1.0f);
    flat(other / "y.png", 0.5f, 0.5f, 0.5f);
    const Scene plain = plane_with(maps_of(folder));
    EXPECT_TRUE(plain.warnings.empty()) << plain.warnings.front();
    EXPECT_TRUE(says(plain.notes, {"base color x_color.png", "roughness-metallic x_orm.png"}));
    EXPECT_TRUE(says(plain.notes, {"x_roughness.png: passed over", "x_orm.png holds"}));

    ParameterValues values = maps_of(folder);
    values.set("roughness_map", (other / "y.png").string(), "--roughness-map");
    values.set("normal_map", "builtin:bumps", "--normal-map");
    const Scene mixed = plane_with(values);
    EXPECT_TRUE(says(mixed.notes, {"x_roughness.png: passed over, roughness_map is set"}));
    EXPECT_FALSE(says(mixed.notes, {"x_orm.png holds the roughness"}));
    EXPECT_TRUE(says(mixed.notes, {"x_orm.png (roughness: roughness_map holds)"}));
    EXPECT_TRUE(says(mixed.notes, {"not drawn", "normal x_normal.png (normal_map holds)"}));

    values = maps_of(folder);
    values.set("weave", "plain", "--weave");
    const Scene woven = plane_with(values);
    EXPECT_TRUE(says(woven.notes, {"x_orm.png (roughness: weave holds; metallic: weave holds)"}));
    EXPECT_TRUE(says(woven.notes, {"not drawn: normal x_normal.png (weave holds)"}));
}

TEST(MapSets, AFlagSettlesTwoCandidates) {
    const ScratchFolder folder;
    flat(folder / "a_Roughness.png", 0.5f, 0.5f, 0.5f);
    flat(folder / "b_Roughness.png", 0.5f, 0.5f, 0.5f);
    ParameterValues values = maps_of(folder);
    values.set("roughness_map", (folder / "b_Roughness.png").string(), "--roughness-map");
    EXPECT_TRUE(plane_with(values).materials.front().metallic_roughness_texture);
}

TEST(MapSets, MissingMapsAndDanglingLinksAreNamed) {
    const ScratchFolder folder;
    flat(folder / "base_color.png", 0.5f, 0.5f, 0.5f);
    std::filesystem::create_symlink(folder / "gone.png", folder / "normal.png");
    folder.write("orm.ktx2", "\xabKTX 20\xbb");
    folder.write("material.json", R"({"format": "burnish-material", "version": 1, "maps": {
        "base_color": {"file": "base_color.png"}, "normal": {"file": "normal.png"},
        "anisotropy": {"file": "anisotropy.png"}}})");
    const MapSet set = find_map_set(folder / "");
    EXPECT_EQ(set.files.size(), 1u);
    EXPECT_TRUE(says(set.warnings, {"normal.png", "a link to a file that is not there"}));
    EXPECT_TRUE(says(set.warnings, {"anisotropy.png", "material.json names this map"}));
    EXPECT_TRUE(says(set.warnings, {"orm.ktx2", "ktx extract"}));
    EXPECT_EQ(set.warnings.size(), 3u) << "each once";
    folder.write("material.json", "{");
    EXPECT_TRUE(says(find_map_set(folder / "").warnings, {"material.json", "told by their names"}));
    std::filesystem::remove(folder / "base_color.png");
    const std::string line = error_line<UsageError>([&] { find_map_set(folder / ""); });
    EXPECT_NE(line.find("none: "), line.npos) << line;
}

TEST(MapSets, OfUdimTilesTheFirstIsDrawnAndSaid) {
    const ScratchFolder folder;
    for (const char* name : {"x_color.1001.png", "x_color.1002.png", "x_roughness.1001.png",
                             "x_roughness.1002.png", "x_metallic_1024.png"})
        flat(folder / name, 0.5f, 0.5f, 0.5f);
    const MapSet set = find_map_set(folder / "");
    EXPECT_EQ(set.files.at(MapRole::base_color).filename(), "x_color.1001.png");
    EXPECT_EQ(set.files.at(MapRole::roughness).filename(), "x_roughness.1001.png");
    EXPECT_TRUE(set.files.contains(MapRole::metallic)) << "1024 is a resolution";
    EXPECT_TRUE(says(set.warnings, {"UDIM", "1001 to 1002", "tile 1001"}));
    std::filesystem::remove(folder / "x_color.1002.png");
    std::filesystem::remove(folder / "x_roughness.1002.png");
    EXPECT_TRUE(find_map_set(folder / "").warnings.empty());
}

// glTF's texture: red is not read.
TEST(MapSets, AMetallicRoughnessMapHasNoOcclusion) {
    const ScratchFolder folder;
    flat(folder / "x_metalRoughness.png", 0.0f, 0.25f, 1.0f);
    const Material m = plane_with(maps_of(folder)).materials.front();
    EXPECT_TRUE(m.metallic_roughness_texture);
    EXPECT_FALSE(m.occlusion_texture);
    EXPECT_EQ(m.metallic, 1.0f);
}

// The 32-bit pictures beside glTF's have other units, and would win by their ending.
TEST(MapSets, OfACapturesExportGltfsMapsAreTaken) {
    const ScratchFolder folder;
    for (const char* name : {"base_color.png", "normal.png", "normal.exr", "diffuse.exr",
                             "alpha.exr", "grain_angle.exr", "metallic_roughness.png"})
        flat(folder / name, 0.5f, 0.5f, 1.0f);
    folder.write("material.gltf", "{}");
    const MapSet set = find_map_set(folder / "");
    EXPECT_EQ(set.files.at(MapRole::normal).filename(), "normal.png");
    EXPECT_EQ(set.files.at(MapRole::base_color).filename(), "base_color.png");
    EXPECT_FALSE(set.files.contains(MapRole::opacity));
}

TEST(MapSets, AFolderInAnotherPlaceIsSentToItsFlag) {
    const ScratchFolder maps, weave;
    flat(maps / "x_color.png", 0.5f, 0.5f, 0.5f);
    flat(weave / "normal.png", 0.5f, 0.5f, 1.0f);
    weave.write("weave.json", "{}");
    weave.write("draft.wif", "[WIF]\n");
    for (const char* name : {"scratch", "weave", "tabulated", "normal_map", "roughness_map"})
        for (const ScratchFolder* folder : {&maps, &weave}) {
            ParameterValues values;
            values.set(name, (*folder / "").string(), name);
            const std::string line = error_line<UsageError>([&] { plane_with(values); });
            EXPECT_NE(line.find("--maps takes it"), line.npos) << line;
            EXPECT_EQ(line.find("draft.wif") != line.npos, folder == &weave) << line;
        }
}

}  // namespace
}  // namespace burnish
