// Materials as they reflect light to other surfaces.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "bounce_support.hpp"
#include "burnish/surface.hpp"

namespace burnish::test {
namespace {

// The radiance of a plate under a white sky, seen along its normal, is its albedo as the renderer's surface has it:
// but for what a dielectric of f0 = 0 loses at grazing angles, 0.024 of 0.5, and what a rough metal absorbs of light
// that facets reflect more than once, 0.062.
TEST(Bounces, ReflectAsTheSurfaceDoes) {
    std::vector<Material> materials(4, matt(glm::vec3(0.5f)));
    materials[1].dielectric_f0 = 0.04f;
    materials[1].lobe = AlphaLobe{{0.5f, 0.5f}};
    materials[2].metallic = 1.0f;
    materials[2].lobe = AlphaLobe{{0.3f, 0.3f}};
    materials[3].metallic = 1.0f;
    materials[3].lobe = AlphaLobe{{0.1f, 0.6f}};
    for (std::size_t k = 0; k < materials.size(); ++k) {
        Facing f = facing({0, 1, 0});
        f.scene.materials[0] = materials[k];
        const SurfacePoint point(materials[k]);
        double albedo = 0;
        constexpr int kSamples = 1 << 14;
        for (int i = 0; i < kSamples; ++i) {
            const auto s = point.sample(
                {0, 0, 1}, {(i + 0.5) / kSamples, std::fmod(0.5 + 0.7548776662466927 * i, 1.0),
                            std::fmod(0.5 + 0.5698402909980532 * i, 1.0)});
            if (s) albedo += s->weight.x / kSamples;
        }
        const double found = plate_radiance(f, white_sky());
        EXPECT_NEAR(found, albedo, k < 2 ? 0.03 : 0.07) << k;
    }
}

// Nothing sends more than it gets, white as it may be.
TEST(Bounces, GainNoEnergy) {
    for (const float f0 : {0.0f, 0.04f, 0.17f})
        for (const float metallic : {0.0f, 0.5f, 1.0f}) {
            Facing f = facing({0, 1, 0});
            f.scene.materials[0].dielectric_f0 = f0;
            f.scene.materials[0].metallic = metallic;
            const double found = plate_radiance(f, white_sky());
            // Half floats of 11 bits.
            EXPECT_LT(found, 1.002) << f0 << ", " << metallic;
        }
}

Texture texture_of(ColorSpace space, const std::vector<int>& values) {
    Texture texture;
    texture.width = 2;
    texture.height = static_cast<int>(values.size()) / 8;
    texture.channels = 4;
    texture.color_space = space;
    for (const int value : values) texture.texels.push_back(static_cast<std::byte>(value));
    return texture;
}

// The mean of light, not of the numbers that are stored: half of white is 0.5, its sRGB byte is 188.
TEST(Bounces, HaveTheMeanColorOfATexture) {
    Facing f = facing({0, 1, 0});
    f.scene.textures = {texture_of(ColorSpace::srgb, {255, 255, 255, 255, 0, 0, 0, 255, 0, 0, 0,
                                                      255, 255, 255, 255, 255}),
                        texture_of(ColorSpace::linear, {0, 255, 255, 255, 0, 255, 255, 255})};
    Material& material = f.scene.materials[0];
    material = matt({0.8f, 0.4f, 0.2f});
    material.base_color_texture.texture = 0;
    const double dielectric = plate_radiance(f, white_sky());
    EXPECT_NEAR(dielectric, 0.4 * 400.0 / 441.0, 0.01);  // what the interface lets through twice
    // Blue is metallic: a metal of this color.
    material.metallic = 1.0f;
    material.metallic_roughness_texture.texture = 1;
    EXPECT_NEAR(plate_radiance(f, white_sky()), 0.4, 0.03);
    // Textures that are not there, or of no texels, are left out.
    for (const int texture : {2, 1000}) {
        material.base_color_texture.texture = texture;
        EXPECT_TRUE(std::isfinite(plate_radiance(f, white_sky())));
    }
    f.scene.textures[0] = Texture{};
    material.base_color_texture.texture = 0;
    EXPECT_TRUE(std::isfinite(plate_radiance(f, white_sky())));
}

TEST(Bounces, EmitTheMeanColorOfATexture) {
    Facing f = facing({0, 1, 0});
    f.scene.textures = {texture_of(ColorSpace::srgb, {255, 255, 255, 255, 0, 0, 0, 255})};
    f.scene.materials[0] = matt(glm::vec3(0.0f));
    f.scene.materials[0].emissive = {3.0f, 1.0f, 1.0f};
    f.scene.materials[0].emissive_texture.texture = 0;
    EXPECT_NEAR(plate_radiance(f, {}), 1.5, 0.02);
}

// A mirror shows what is opposite of the eye: the western or the eastern half of the sky.
TEST(Bounces, AMirrorShowsTheOppositeSky) {
    const glm::dvec3 eye = glm::normalize(glm::dvec3(1, 1, 0));
    Scene scene = scene_of({disc(eye * 1.5, 0.02, -eye, 16), disc({0, 0, 0}, 0.3, {0, 1, 0}, 32)});
    scene.materials.push_back(matt({0.9f, 0.6f, 0.3f}));
    scene.materials[1].metallic = 1.0f;
    scene.materials[1].lobe = AlphaLobe{{0.02f, 0.02f}};
    scene.instances[1].material = 1;
    VisibilityFinder finder(scene, {1024, false});
    for (const double side : {-1.0, 1.0}) {
        const SceneLight sky = sky_of([&](glm::dvec3 w) { return w.x * side > 0 ? 1.0 : 0.0; });
        const f64::vec3 found = radiance(around(*finder.lit(sky, 1), 0, 0), -eye);
        const double wanted = side < 0 ? 1.0 : 0.0;
        EXPECT_NEAR(found.x, 0.9 * wanted, 0.02);
        EXPECT_NEAR(found.y, 0.6 * wanted, 0.02);
        EXPECT_NEAR(found.z, 0.3 * wanted, 0.02);
    }
}

}  // namespace
}  // namespace burnish::test
