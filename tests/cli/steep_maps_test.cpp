// Maps so steep that many normals face away from the eye: in a white room a metal of albedo 1 shows
// no black pixel and none brighter than the room, whatever the method.
#include <algorithm>
#include <string>

#include "maps/normal/bumps.hpp"
#include "pictures.hpp"

namespace burnish::test {
namespace {

constexpr int kSide = 160;

Stage steep_stage(const std::string& method) {
    Stage stage = stage_of("builtin:sphere", "none", {},
                           {{"normal_map", "builtin:bumps"},
                            {"method", method},
                            {"base_color", "1,1,1"},
                            {"metallic", "1"},
                            {"alpha_x", "0.1"},
                            {"alpha_y", "0.4"},
                            {"samples", "16"},
                            {"image_light_samples", "64"},
                            {"width", std::to_string(kSide)},
                            {"height", std::to_string(kSide)}});
    Image room;
    room.width = 8;
    room.height = 4;
    room.channels = 3;
    room.pixels.assign(8 * 4 * 3, 1.0f);
    stage.environment.radiance = room;
    return stage;
}

struct Extremes {
    double least = 1e9, most = 0;
};

// Inside the silhouette, where no background is mixed in.
Extremes extremes(const Image& picture) {
    Extremes e;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const float* p = picture.at(x, y);
            if (p[3] < 0.999f) continue;
            e.least = std::min(e.least, static_cast<double>(*std::min_element(p, p + 3)));
            e.most = std::max(e.most, static_cast<double>(*std::max_element(p, p + 3)));
        }
    }
    return e;
}

class SteepMaps : public testing::TestWithParam<const char*> {};

TEST_P(SteepMaps, NoPixelIsBlackOrBrighterThanTheRoom) {
    BURNISH_REQUIRE_GL();
    Stage stage = steep_stage(GetParam());
    const int map = stage.scene.materials.at(0).normal_texture.texture;
    Texture& texture = stage.scene.textures.at(static_cast<std::size_t>(map));
    BumpOptions options;
    options.max_tilt_deg = 80.0;
    const Image steep = bump_normal_map(512, options);
    texture.width = texture.height = 512;
    texture.channels = steep.channels;
    texture.type = TexelType::f32;
    const auto bytes = std::as_bytes(std::span(steep.pixels));
    texture.texels.assign(bytes.begin(), bytes.end());
    const Extremes e = extremes(picture_of(stage));
    RecordProperty("least", std::to_string(e.least));
    RecordProperty("most", std::to_string(e.most));
    EXPECT_GT(e.least, 0.2);
    EXPECT_LT(e.most, 1.015);  // the room, within the table of albedos: measured 1.0115
}

INSTANTIATE_TEST_SUITE_P(Methods, SteepMaps,
                         testing::Values("follow-grain", "gram-schmidt", "rotate-exact",
                                         "rotate-arc"));

}  // namespace
}  // namespace burnish::test
