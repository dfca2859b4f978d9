#include "reference/texture_pyramid.hpp"

#include <gtest/gtest.h>

#include <array>

#include "gpu/test_scene.hpp"
#include "scene/material/texture_sampler.hpp"

namespace burnish {
namespace {

Texture ramp() {
    std::vector<glm::vec3> texels;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            texels.emplace_back(static_cast<float>(x) / 8.0f, static_cast<float>(y) / 8.0f, 0.25f);
    return test::float_texture(8, 8, texels);
}

TextureUse used(Wrap wrap = Wrap::repeat) {
    TextureUse use;
    use.texture = 0;
    use.wrap_s = use.wrap_t = wrap;
    return use;
}

TEST(TexturePyramid, IsTheTextureWhereTheFootprintIsSmall) {
    const std::array<Texture, 1> textures = {ramp()};
    const TexturePyramid pyramid(textures[0], PyramidForm::plain);
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp})
        for (const glm::vec2 uv :
             {glm::vec2(0.3f, 0.7f), glm::vec2(1.2f, -0.4f), glm::vec2(-7.3f, 2.9f)}) {
            const glm::vec4 expected = TextureSampler(used(wrap), textures).at(uv);
            const glm::vec4 read = pyramid.at(used(wrap), uv, {});
            for (int c = 0; c < 4; ++c) EXPECT_NEAR(read[c], expected[c], 1e-5f);
        }
}

TEST(TexturePyramid, IsTheMeanOfTheTextureWhereTheFootprintIsLarge) {
    const Texture texture = ramp();
    const TexturePyramid pyramid(texture, PyramidForm::plain);
    const glm::vec4 mean = pyramid.at(used(), {0.3f, 0.7f}, {{100.0f, 0.0f}, {0.0f, 100.0f}});
    EXPECT_NEAR(mean.x, 3.5f / 8.0f, 1e-6f);
    EXPECT_NEAR(mean.y, 3.5f / 8.0f, 1e-6f);
}

// A footprint of 2^(kFinerLevels + 1) texels is read from level 1, by the longer side and through the transform.
TEST(TexturePyramid, ReadsTheLevelOfTheLongerSide) {
    const Texture texture = ramp();
    const TexturePyramid pyramid(texture, PyramidForm::plain);
    const float side = std::exp2(kFinerLevels + 1.0f) / 8.0f;
    const glm::vec2 middle_of_four(1.0f / 8.0f, 1.0f / 8.0f);
    const glm::vec4 four = pyramid.at(used(), middle_of_four, {{side, 0.0f}, {0.0f, 1e-3f}});
    EXPECT_NEAR(four.x, 0.5f / 8.0f, 1e-5f);
    TextureUse twice = used();
    twice.transform = glm::mat3(2.0f);
    twice.transform[2][2] = 1.0f;
    const glm::vec4 same =
        pyramid.at(twice, 0.5f * middle_of_four, {{0.5f * side, 0.0f}, {0.0f, 1e-3f}});
    EXPECT_NEAR(same.x, four.x, 1e-5f);
}

TEST(TexturePyramid, KeepsTheVarianceOfSlopes) {
    const Texture bumps = test::bump_texture(32, 4.0f, 0.5f);
    const TexturePyramid pyramid(bumps, PyramidForm::slopes);
    const glm::vec4 near = pyramid.at(used(), {0.3f, 0.6f}, {});
    const glm::vec4 far = pyramid.at(used(), {0.3f, 0.6f}, {{10.0f, 0.0f}, {0.0f, 10.0f}});
    EXPECT_EQ(near.z, 0.0f);
    EXPECT_NEAR(far.x, 0.0f, 1e-4f);
    EXPECT_NEAR(far.z, 0.5f * 0.5f / 2.0f, 0.01f);  // of a sine
}

TEST(TexturePyramid, HasNoTexelThatIsNoNumber) {
    const Texture broken = test::float_texture(2, 1, {{NAN, 1.0f, INFINITY}, {0.5f, 0.5f, 0.5f}});
    const glm::vec4 plain =
        TexturePyramid(broken, PyramidForm::plain).at(used(), {0.25f, 0.5f}, {});
    EXPECT_EQ(plain, glm::vec4(0.0f));
    const glm::vec4 flat =
        TexturePyramid(broken, PyramidForm::normal).at(used(), {0.25f, 0.5f}, {});
    EXPECT_EQ(flat.z, 1.0f);
}

}  // namespace
}  // namespace burnish
