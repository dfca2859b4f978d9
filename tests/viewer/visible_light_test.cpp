// What vertices see, found off the frame for the window.
#include "viewer/prepare/visible_light.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "burnish/environments.hpp"
#include "gpu/gpu_fixture.hpp"
#include "viewer/document/load_stage.hpp"

namespace burnish::viewer {
namespace {

class OffTheFrame : public test::GpuTest {
  protected:
    void SetUp() override {
        test::GpuTest::SetUp();
        if (IsSkipped()) return;
        Document document{.input = "builtin:pot", .environment = "builtin:white"};
        document.values.set("triangles", "2000", "");
        document.values.set("visibility_rays", "64", "");
        stage = load_stage(document);
        environment = prepare_environment(stage.environment);
        renderer = std::make_unique<gpu::Renderer>(*context);
        renderer->set_scene(stage.scene);
        renderer->set_environment(environment);
    }

    // Until the renderer has been given something; false after 30 s, a hundred times what the work takes.
    bool is_given() {
        for (int i = 0; i < 3000; ++i) {
            if (light.give(*renderer)) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return false;
    }

    // From above, into the pot.
    glm::vec3 inside() {
        Camera camera;
        camera.position = {0.0f, 2.0f, 0.01f};
        RenderSettings settings = test::small_picture(32, 32, 4);
        settings.visibility = true;
        return test::rgb(renderer->render(camera, settings), 16, 16);
    }

    Stage stage;
    std::shared_ptr<const PreparedEnvironment> environment;
    std::unique_ptr<gpu::Renderer> renderer;
    VisibleLight light;
};

constexpr VisibleLight::Change kNew{.geometry = true, .forgotten = true};

TEST_F(OffTheFrame, DarkensWhatIsClosedInOnceItIsFound) {
    stage.settings.bounces = 0;
    const float open = inside().x;
    light.follow(stage, environment, kNew, *renderer);
    EXPECT_TRUE(light.working());
    EXPECT_NEAR(inside().x, open, 2e-3f);  // not known yet
    light.step();
    ASSERT_TRUE(is_given());
    EXPECT_FALSE(light.working());
    EXPECT_LT(inside().x, 0.95f * open);
}

TEST_F(OffTheFrame, IsAllThereBeforeAPictureIsKept) {
    light.hold(true);
    light.follow(stage, environment, kNew, *renderer);
    light.finish(*renderer);
    EXPECT_FALSE(light.working());
    const float found = inside().x;
    light.finish(*renderer);  // nothing is due
    EXPECT_EQ(inside().x, found);
    Stage again = stage;
    again.settings.visibility = false;
    light.follow(again, environment, {}, *renderer);
    EXPECT_GT(inside().x, 1.05f * found);
}

TEST_F(OffTheFrame, WaitsWhileItIsHeldAndEndsWhenItIsNoMore) {
    light.hold(true);
    light.follow(stage, environment, kNew, *renderer);
    light.step();
    // Ten times what the work takes.
    std::this_thread::sleep_for(std::chrono::milliseconds(1000));
    EXPECT_FALSE(light.give(*renderer));
    EXPECT_TRUE(light.working());
    light.hold(false);
    EXPECT_TRUE(is_given());
    // Work that is held is given up with its owner: the end of the test does not wait forever.
    light.hold(true);
    stage.settings.bounces = 0;
    light.follow(stage, environment, {}, *renderer);
    light.step();
}

TEST_F(OffTheFrame, LightThatChangesIsFoundWithoutNewRaysForWhatIsSeen) {
    light.follow(stage, environment, kNew, *renderer);
    light.step();
    ASSERT_TRUE(is_given());
    const float before = inside().x;
    // Nothing that it depends on.
    stage.settings.samples = 99;
    light.follow(stage, environment, {}, *renderer);
    EXPECT_FALSE(light.working());
    stage.settings.bounces = 0;
    light.follow(stage, environment, {}, *renderer);
    EXPECT_TRUE(light.working());
    light.step();
    ASSERT_TRUE(is_given());
    EXPECT_LT(inside().x, before);
}

TEST_F(OffTheFrame, WhatIsOfAnotherSceneIsDropped) {
    light.follow(stage, environment, kNew, *renderer);
    light.step();
    stage.scene.instances.push_back(stage.scene.instances.front());
    renderer->set_scene(stage.scene);
    light.follow(stage, environment, kNew, *renderer);  // cancels
    while (light.working()) {
        light.step();
        if (light.give(*renderer)) break;  // of two instances, or it would be refused
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_FALSE(light.working());
}

TEST_F(OffTheFrame, SwitchedOffItForgets) {
    light.follow(stage, environment, kNew, *renderer);
    light.step();
    ASSERT_TRUE(is_given());
    stage.settings.visibility = false;
    light.follow(stage, environment, {}, *renderer);
    EXPECT_FALSE(light.working());
    stage.settings.visibility = true;
    light.follow(stage, nullptr, {}, *renderer);  // no environment
    EXPECT_FALSE(light.working());
}

}  // namespace
}  // namespace burnish::viewer
