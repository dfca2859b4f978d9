// Maps of a material against closed forms: what glTF's formulas make of them is the lobe that went in.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <utility>

#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "burnish/gltf_material.hpp"
#include "burnish/weave_maps.hpp"

namespace burnish {
namespace {

constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

// Not inlined: GCC 12 takes the variant of a Material that it sees through for uninitialized (its bug
// 105562).
[[gnu::noinline]] Material material_of(MaterialLobe lobe) {
    Material m;
    m.lobe = std::move(lobe);
    return m;
}

GltfMaterial bake(const Material& m, int size, const std::vector<Texture>& textures = {}) {
    return bake_gltf_material(m, textures, {size, size, 16}, kNoLimit);
}

// A 16-bit code as a fraction.
double code(const Texture& map, int x, int y, int channel) {
    const std::size_t at = (static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
                            static_cast<std::size_t>(x)) *
                               static_cast<std::size_t>(map.channels) +
                           static_cast<std::size_t>(channel);
    if (map.type == TexelType::u8) return std::to_integer<int>(map.texels[at]) / 255.0;
    std::uint16_t value = 0;
    std::memcpy(&value, map.texels.data() + 2 * at, 2);
    return value / 65535.0;
}

// What KHR_materials_anisotropy says that a texel's lobe is: alpha across and along the grooves, and
// the direction of the grooves in radians, from 0 to pi.
struct ReadLobe {
    double across, along, groove;
};
ReadLobe lobe_at(const GltfMaterial& baked, int x, int y) {
    const double roughness = code(baked.textures[1], x, y, 1);
    const double strength = code(baked.textures[3], x, y, 2);
    const double along = roughness * roughness;
    const double dx = 2 * code(baked.textures[3], x, y, 0) - 1;
    const double dy = 2 * code(baked.textures[3], x, y, 1) - 1;
    const double groove = std::atan2(dy, dx) + std::acos(0.0);
    const double pi = std::acos(-1.0);
    return {along + strength * strength * (1 - along), along,
            groove - pi * std::floor(groove / pi)};
}

// Codes of 16 bits: a step of the root of alpha is 1.5e-5.
constexpr double kCode = 1e-4;

TEST(GltfBake, ARoughnessPairComesBack) {
    Material m = material_of(AlphaLobe{{0.08f, 0.3f}});
    m.anisotropy_rotation = 0.4f;
    const GltfMaterial baked = bake(m, 16);
    const ReadLobe lobe = lobe_at(baked, 3, 7);
    EXPECT_NEAR(lobe.along, 0.08, kCode);
    EXPECT_NEAR(lobe.across, 0.3, kCode);
    // The smaller alpha is along the tangent: that is where the grooves run.
    EXPECT_NEAR(lobe.groove, 0.4, kCode);
}

TEST(GltfBake, AStretchAlongTheTangentHasGroovesAcrossIt) {
    Material m = material_of(GltfLobe{0.5f, 0.6f});
    const ReadLobe lobe = lobe_at(bake(m, 16), 0, 0);
    EXPECT_NEAR(lobe.along, 0.25, kCode);
    EXPECT_NEAR(lobe.across, 0.25 + 0.36 * 0.75, kCode);
    EXPECT_NEAR(lobe.groove, std::acos(0.0), kCode);
}

TEST(GltfBake, ColorsAreThoseOfTheInterface) {
    Material m;
    m.base_color = {0.5f, 0.25f, 0.125f, 1.0f};
    m.metallic = 0.75f;
    const GltfMaterial baked = bake(m, 16);
    EXPECT_NEAR(code(baked.textures[1], 0, 0, 2), 0.75, kCode);
    // sRGB of 1/2 and of 1/8 (IEC 61966-2-1); 8 bits.
    EXPECT_NEAR(code(baked.textures[0], 0, 0, 0), 0.735357, 0.002);
    EXPECT_NEAR(code(baked.textures[0], 0, 0, 2), 0.388573, 0.002);
    m.conductor = Conductor{{1.0f, 2.0f, 1.5f}, {0.0f, 1.0f, 3.0f}};
    const GltfMaterial metal = bake(m, 16);
    EXPECT_NEAR(code(metal.textures[1], 0, 0, 2), 1.0, 0.0);
    // ((n-1)^2 + k^2) / ((n+1)^2 + k^2): 0, 2/10, 9.25/15.25; sRGB of 0.2 is 0.484529.
    EXPECT_NEAR(code(metal.textures[0], 0, 0, 0), 0.0, 0.0);
    EXPECT_NEAR(code(metal.textures[0], 0, 0, 1), 0.484529, 0.002);
}

TEST(GltfBake, TheColorOfAFilmIsThatAtNormalIncidence) {
    Material m;
    m.conductor = Conductor{{1.0f, 2.0f, 1.5f}, {0.0f, 1.0f, 3.0f}};
    m.conductor->oxide = OxideFilm{30.0f, {{{0.2f, -0.5f, 1.5f}}}};  // held within [0, 1]
    const GltfMaterial metal = bake(m, 16);
    EXPECT_NEAR(code(metal.textures[0], 0, 0, 0), 0.484529, 0.002);
    EXPECT_NEAR(code(metal.textures[0], 0, 0, 1), 0.0, 0.0);
    EXPECT_NEAR(code(metal.textures[0], 0, 0, 2), 1.0, 0.0);
    EXPECT_TRUE(std::any_of(metal.losses.begin(), metal.losses.end(),
                            [](const std::string& line) { return line.starts_with("oxide: "); }));
}

// Slopes of +s and -s along x, alternating from texel to texel: their variance is s^2.
Texture ridges(int size, double slope) {
    Texture t{"ridges", size, size, 3, TexelType::f32, ColorSpace::linear, {}};
    std::vector<float> rgb;
    const double z = 1 / std::hypot(slope, 1.0);
    for (int i = 0; i < size * size; ++i) {
        const double x = (i % 2 == 0 ? slope : -slope) * z;
        for (const double n : {x, 0.0, z}) rgb.push_back(static_cast<float>(0.5 + 0.5 * n));
    }
    t.texels.resize(rgb.size() * sizeof(float));
    std::memcpy(t.texels.data(), rgb.data(), t.texels.size());
    return t;
}

// Variances of slopes add, and that of a Beckmann lobe is alpha^2/2.
TEST(GltfBake, DetailBelowATexelWidensTheLobe) {
    Material m = material_of(AlphaLobe{{0.2f, 0.2f}});
    m.mdf = Mdf::beckmann;
    m.normal_texture.texture = 0;
    const double slope = 0.15;
    const GltfMaterial baked = bake(m, 16, {ridges(64, slope)});
    const ReadLobe lobe = lobe_at(baked, 5, 5);
    EXPECT_NEAR(lobe.across, std::sqrt(0.04 + 2 * slope * slope), 1e-3);
    EXPECT_NEAR(lobe.along, 0.2, 1e-3);
    // The ridges run along y.
    EXPECT_NEAR(lobe.groove, std::acos(0.0), 1e-3);
    EXPECT_NEAR(code(baked.textures[2], 5, 5, 0), 0.5, kCode);
    EXPECT_NEAR(code(baked.textures[2], 5, 5, 2), 1.0, kCode);
}

TEST(GltfBake, AMapOfItsOwnSizeStaysWhatItIs) {
    Material m;
    m.normal_texture.texture = 0;
    m.normal_scale = 2.0f;
    const double slope = 0.15;
    const GltfMaterial baked = bake(m, 16, {ridges(16, slope)});
    const double z = 1 / std::hypot(2 * slope, 1.0);
    EXPECT_NEAR(code(baked.textures[2], 4, 9, 0), 0.5 + 0.5 * 2 * slope * z, kCode);
    EXPECT_NEAR(code(baked.textures[2], 5, 9, 0), 0.5 - 0.5 * 2 * slope * z, kCode);
    EXPECT_NEAR(lobe_at(baked, 4, 9).along, 1.0, kCode);
}

// The tile of a weave, at as many points as texels, against the maps that burnish weave makes.
TEST(GltfBake, AWeaveIsTheTileOfItsMaps) {
    WeaveMapSettings settings;
    settings.draft = builtin_draft("twill-2-1");
    settings.repeats_u = settings.repeats_v = 6;  // 18 yarns: at least 16
    settings.width = settings.height = 16 * 18;
    settings.shape = {0.2f, 0.8f, 0.0f, {1.0f, 0.0f}};
    const WeaveMaps maps = bake_weave(settings, kNoLimit);
    std::vector<float> normals(3 * maps.yarns.size());
    weave_normal_rows(maps, 0, maps.height, normals.data());

    Material m = material_of(Cloth{std::make_shared<Draft>(settings.draft),
                                   90.0f,
                                   0.2f,
                                   0.8f,
                                   0.0f,
                                   0.0f,
                                   0.0f,
                                   glm::vec3(1.0f, 0.0f, 0.0f),
                                   glm::vec3(0.0f, 0.0f, 1.0f),
                                   {0.2f, 0.45f}});
    m.metallic = 0.0f;
    const GltfMaterial baked = bake(m, settings.width);
    // 90 yarns across the texture square are five tiles; the last row of the square is that of a tile.
    EXPECT_FLOAT_EQ(baked.tile[0][0], 5.0f);
    EXPECT_FLOAT_EQ(baked.tile[1][1], 5.0f);
    EXPECT_FLOAT_EQ(baked.tile[2][1], 1.0f - 5.0f);
    double worst = 0;
    for (int y = 0; y < maps.height; ++y)
        for (int x = 0; x < maps.width; ++x) {
            const std::size_t t = static_cast<std::size_t>(y * maps.width + x);
            const bool warp = maps.yarns[t] <= maps.ends;
            ASSERT_EQ(code(baked.textures[0], x, y, 0), warp ? 1.0 : 0.0) << x << "," << y;
            for (int c = 0; c < 2; ++c)
                worst = std::max(
                    worst,
                    std::abs(code(baked.textures[2], x, y, c) -
                             static_cast<double>(normals[3 * t + static_cast<std::size_t>(c)])));
            // Fibers run along the yarn, and grooves along the fibers; across them alpha is 0.45.
            const ReadLobe lobe = lobe_at(baked, x, y);
            ASSERT_NEAR(lobe.across, 0.45, 1e-3);
            ASSERT_NEAR(std::abs(std::cos(lobe.groove)), warp ? 0.0 : 1.0, 1e-3);
        }
    EXPECT_LT(worst, kCode);
}

// The base color is that of yarns without one of their own.
TEST(GltfBake, YarnsHaveTheirOwnColor) {
    Cloth cloth;
    cloth.draft = std::make_shared<Draft>(builtin_draft("plain"));
    cloth.gap = 0.0f;
    cloth.warp_color = glm::vec3(1.0f, 0.0f, 0.0f);
    Material m = material_of(cloth);
    m.base_color = {0.0f, 0.0f, 1.0f, 1.0f};
    const GltfMaterial baked = bake(m, 256);
    int red = 0, blue = 0;
    for (int x = 0; x < 256; ++x) {
        red += code(baked.textures[0], x, 8, 0) == 1.0 ? 1 : 0;
        blue += code(baked.textures[0], x, 8, 2) == 1.0 ? 1 : 0;
    }
    EXPECT_EQ(red + blue, 256);
    EXPECT_GT(red, 100);
    EXPECT_GT(blue, 100);
}

TEST(GltfBake, TexturesThatShareATransformAreTheTile) {
    Material m;
    m.normal_texture.texture = 0;
    m.normal_texture.transform = glm::mat3(4, 0, 0, 0, 4, 0, 0, 0, 1);
    EXPECT_EQ(bake(m, 16, {ridges(16, 0.1)}).tile, m.normal_texture.transform);
    m.base_color_texture.texture = 0;
    EXPECT_EQ(bake(m, 16, {ridges(16, 0.1)}).tile, glm::mat3(1.0f));
}

TEST(GltfBake, RefusesWhatCannotBe) {
    EXPECT_THROW(bake(Material{}, 8), UsageError);
    EXPECT_THROW(bake_gltf_material(Material{}, {}, {16, 16, 12}, kNoLimit), UsageError);
    EXPECT_THROW(bake_gltf_material(Material{}, {}, {4096, 4096, 16}, 1 << 20), Error);
}

}  // namespace
}  // namespace burnish
