// Turntables as pictures: what stands still in them, and what does not.
#include <gtest/gtest.h>

#include "jobs/turntable_request.hpp"
#include "plot/sheet.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {
namespace {

// RMSE of two linear pictures of the same thing that were drawn under turned axes: directions are rounded
// to floats, and environments are read from half floats (steps of 5e-4 of a value). Pictures of another
// thing are farther apart.
constexpr double kSame = 5e-4, kOther = 5e-2;

// An L of unit height, which no turn but a full one maps onto itself; `turned` by a quarter,
// counter-clockwise as seen from above: (x, z) -> (z, -x).
std::string l_shape(bool turned) {
    const double corners[6][2] = {{-0.7, -0.5}, {0.7, -0.5}, {0.7, 0.0},
                                  {0.1, 0.0},   {0.1, 0.5},  {-0.7, 0.5}};
    std::string obj;
    for (const double y : {-0.4, 0.4})
        for (const auto& [x, z] : corners)
            obj += "v " + std::to_string(turned ? z : x) + " " + std::to_string(y) + " " +
                   std::to_string(turned ? -x : z) + "\n";
    // Outlines run clockwise as seen from above; faces are seen counter-clockwise from outside.
    obj += "f 12 11 10 9\nf 12 9 8 7\nf 3 4 5 6\nf 1 2 3 6\n";
    for (int i = 1; i <= 6; ++i) {
        const int next = i % 6 + 1;
        obj += "f " + std::to_string(i) + " " + std::to_string(i + 6) + " " +
               std::to_string(next + 6) + " " + std::to_string(next) + "\n";
    }
    return obj;
}

class TurntablePicture : public testing::Test {
  protected:
    // Draws it and returns the pictures of all frames.
    std::vector<Image> drawn(RenderRequest request, Turn turn) {
        request.turn = turn;
        request.stage.values.set("image_light", "prefiltered", "");  // without noise
        request.stage.lights = {"70,35", "point:-1.5,1.5,1,4"};
        render(request);
        std::vector<Image> pictures;
        for (int i = 0; i < request.turntable; ++i) pictures.push_back(frame_picture(request, i));
        return pictures;
    }
    Image still(RenderRequest request) {
        request.turntable = 0;
        request.stage.values.set("image_light", "prefiltered", "");
        render(request);
        return read_image(request.output);
    }
    ScratchFolder folder_;
};

TEST_F(TurntablePicture, FrameZeroIsTheStillInEveryTurn) {
    const RenderRequest request = turntable_request("builtin:drape", folder_ / "a.exr", 1);
    RenderRequest alone = request;
    alone.stage.lights = {"70,35", "point:-1.5,1.5,1,4"};
    const Image expected = still(alone);
    for (const Turn turn : {Turn::object, Turn::light, Turn::camera})
        EXPECT_EQ(drawn(request, turn)[0].pixels, expected.pixels);
}

// The studio, the lamp's shadow on the ground and the highlights stand still about a round object.
TEST_F(TurntablePicture, ARoundObjectThatTurnsIsOnePicture) {
    RenderRequest request =
        turntable_request("builtin:sphere", folder_ / "a.exr", 4,
                          {{"metal", "copper"}, {"alpha_x", "0.2"}, {"alpha_y", "0.2"}});
    const std::vector<Image> camera = drawn(request, Turn::camera);
    const std::vector<Image> light = drawn(request, Turn::light);
    request.stage.values.set("ground", "true", "");
    const std::vector<Image> object = drawn(request, Turn::object);
    for (std::size_t i = 1; i < object.size(); ++i) {
        EXPECT_LT(rmse(object[i], object[0]), kSame) << i;
        EXPECT_GT(rmse(camera[i], camera[0]), kOther) << i;
        EXPECT_GT(rmse(light[i], light[0]), kOther) << i;
    }
    // The camera goes around one way as the lights do the other way.
    EXPECT_LT(rmse(camera[1], light[3]), kSame);
    EXPECT_LT(rmse(camera[3], light[1]), kSame);
    EXPECT_GT(rmse(camera[1], light[1]), kOther);
}

TEST_F(TurntablePicture, HalfATurnOfTheLightIsLightsAndEnvironmentTurnedByHand) {
    const RenderRequest request =
        turntable_request("builtin:drape", folder_ / "a.exr", 2, {{"environment_rotation", "25"}});
    const std::vector<Image> light = drawn(request, Turn::light);
    RenderRequest by_hand = request;
    by_hand.stage.values.set("environment_rotation", "205", "");
    by_hand.stage.lights = {"250,35", "point:1.5,1.5,-1,4"};
    EXPECT_LT(rmse(light[1], still(by_hand)), kSame);
    EXPECT_GT(rmse(light[1], light[0]), kOther);
}

TEST_F(TurntablePicture, AQuarterTurnOfTheObjectIsTheModelTurnedByHand) {
    const std::string model = folder_.write("l.obj", l_shape(false)).string();
    RenderRequest request = turntable_request(model, folder_ / "a.exr", 4,
                                              {{"base_color", "0.7,0.4,0.2"}, {"metallic", "0"}});
    const std::vector<Image> object = drawn(request, Turn::object);
    RenderRequest by_hand = request;
    by_hand.stage.input = folder_.write("turned.obj", l_shape(true)).string();
    by_hand.stage.lights = {"70,35", "point:-1.5,1.5,1,4"};
    const Image expected = still(by_hand);
    EXPECT_LT(rmse(object[1], expected), kSame);
    EXPECT_GT(rmse(object[3], expected), kOther);  // the other way around
    EXPECT_GT(rmse(object[0], expected), kOther);
}

// What no object covers is the same in all frames, to the rounding of half floats.
TEST_F(TurntablePicture, TheBackgroundStandsBehindAnObjectThatTurns) {
    const RenderRequest request = turntable_request("builtin:drape", folder_ / "a.exr", 5);
    const std::vector<Image> object = drawn(request, Turn::object);
    for (std::size_t i = 1; i < object.size(); ++i)
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 3; ++c) {
                const float first = object[0].at(x, 0)[c];
                // 2^-10 is the step of a half float; the texel beside it may come to be read.
                EXPECT_NEAR(object[i].at(x, 0)[c], first, 4e-3f * first + 1e-4f) << i << " " << x;
            }
}

}  // namespace
}  // namespace burnish::test
