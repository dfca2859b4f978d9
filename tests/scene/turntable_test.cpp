// What turns on a turntable, as the camera sees it.
#include "burnish/turntable.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "scene/camera/angles.hpp"
#include "scene/camera/view.hpp"

namespace burnish {
namespace {

constexpr Turn kTurns[] = {Turn::object, Turn::light, Turn::camera};
// Places and directions are floats of size about 5.
constexpr double kTurnRounding = 2e-6;
constexpr float kTurnRotation = 0.7f;

Camera tilted_camera() {
    Camera camera;
    camera.position = {1.3f, 2.1f, 4.7f};
    camera.target = {0.3f, -0.2f, 0.9f};
    camera.up = glm::normalize(glm::vec3(0.2f, 1.0f, 0.1f));
    camera.near_plane = 0.1f;
    camera.far_plane = 50.0f;
    return camera;
}

std::vector<Light> lights_of_all_types() {
    Light sun;
    sun.direction = -glm::vec3(direction_at({20, 50}));
    Light lamp;
    lamp.type = LightType::point;
    lamp.position = {-2.0f, 3.0f, 1.0f};
    Light spot = lamp;
    spot.type = LightType::spot;
    spot.position = {2.5f, 1.0f, -1.5f};
    spot.direction = glm::normalize(glm::vec3(-0.5f, -0.3f, 0.4f));
    return {sun, lamp, spot};
}

TurntableFrame frame_of(Turn turn, int index, int count) {
    return turntable_frame(tilted_camera(), lights_of_all_types(), kTurnRotation, turn, index,
                           count);
}

// In the axes of the camera: right, up, back.
glm::dvec3 seen(const Camera& camera, glm::dvec3 direction) {
    const CameraBasis basis = camera_basis(camera);
    return {glm::dot(basis.right, direction), glm::dot(basis.up, direction),
            glm::dot(basis.back, direction)};
}

glm::dvec3 seen_place(const Camera& camera, glm::dvec3 place) {
    return seen(camera, place - camera_basis(camera).position);
}

// Counter-clockwise as seen from above.
glm::dvec3 turned(glm::dvec3 v, double angle_rad) {
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

TEST(Turntable, FrameZeroIsTheStillInEveryTurn) {
    for (const Turn turn : kTurns) {
        const TurntableFrame frame = frame_of(turn, 0, 24);
        EXPECT_EQ(frame.camera, tilted_camera());
        EXPECT_EQ(frame.lights, lights_of_all_types());
        EXPECT_EQ(frame.environment_rotation, kTurnRotation);
    }
}

TEST(Turntable, TheFrameAfterTheLastIsFrameZero) {
    for (const Turn turn : kTurns) {
        const TurntableFrame first = frame_of(turn, 0, 24), next = frame_of(turn, 24, 24);
        EXPECT_LT(glm::distance(next.camera.position, first.camera.position), kTurnRounding);
        EXPECT_LT(glm::distance(next.camera.up, first.camera.up), kTurnRounding);
        for (std::size_t i = 0; i < first.lights.size(); ++i) {
            EXPECT_LT(glm::distance(next.lights[i].position, first.lights[i].position),
                      kTurnRounding);
            EXPECT_LT(glm::distance(next.lights[i].direction, first.lights[i].direction),
                      kTurnRounding);
        }
        EXPECT_NEAR(std::cos(next.environment_rotation), std::cos(kTurnRotation), kTurnRounding);
        EXPECT_NEAR(std::sin(next.environment_rotation), std::sin(kTurnRotation), kTurnRounding);
    }
}

TEST(Turntable, TheCameraSeesTheSameLightsWhileTheObjectTurns) {
    const Camera camera = tilted_camera();
    const std::vector<Light> lights = lights_of_all_types();
    const glm::dvec3 target(camera.target), corner(0.9, 0.4, -0.6), sky(0.3, 0.5, -0.8);
    for (int i = 0; i < 7; ++i) {
        const TurntableFrame frame = frame_of(Turn::object, i, 7);
        const double angle = glm::two_pi<double>() * i / 7;
        for (std::size_t l = 0; l < lights.size(); ++l) {
            EXPECT_LT(glm::distance(seen(frame.camera, glm::dvec3(frame.lights[l].direction)),
                                    seen(camera, glm::dvec3(lights[l].direction))),
                      kTurnRounding);
            EXPECT_LT(glm::distance(seen_place(frame.camera, glm::dvec3(frame.lights[l].position)),
                                    seen_place(camera, glm::dvec3(lights[l].position))),
                      5 * kTurnRounding);
        }
        // A direction of the environment's picture, where it is seen.
        EXPECT_LT(glm::distance(seen(frame.camera,
                                     turned(sky, static_cast<double>(frame.environment_rotation))),
                                seen(camera, turned(sky, static_cast<double>(kTurnRotation)))),
                  kTurnRounding);
        // A corner of the object, counter-clockwise about the axis through the target.
        EXPECT_LT(glm::distance(seen_place(frame.camera, corner),
                                seen_place(camera, target + turned(corner - target, angle))),
                  5 * kTurnRounding);
    }
}

TEST(Turntable, LightsTurnAboutTheTargetWhileTheCameraStands) {
    const std::vector<Light> lights = lights_of_all_types();
    const TurntableFrame frame = frame_of(Turn::light, 1, 4);
    EXPECT_EQ(frame.camera, tilted_camera());
    const DirectionAngles sun = angles_of(-glm::dvec3(frame.lights[0].direction));
    EXPECT_NEAR(sun.azimuth_deg, 20 + 90, 1e-4);
    EXPECT_NEAR(sun.elevation_deg, 50, 1e-4);
    const glm::dvec3 axis(tilted_camera().target);
    for (std::size_t l = 1; l < lights.size(); ++l) {
        const glm::dvec3 before = glm::dvec3(lights[l].position) - axis;
        const glm::dvec3 after = glm::dvec3(frame.lights[l].position) - axis;
        EXPECT_LT(glm::distance(after, glm::dvec3(before.z, before.y, -before.x)), kTurnRounding);
    }
    EXPECT_NEAR(frame.environment_rotation, kTurnRotation + glm::half_pi<float>(), kTurnRounding);
    EXPECT_EQ(frame.lights[2].outer_cone, lights[2].outer_cone);
}

TEST(Turntable, TheCameraGoesAroundWhileLightsStand) {
    const TurntableFrame frame = frame_of(Turn::camera, 1, 4);
    EXPECT_EQ(frame.lights, lights_of_all_types());
    EXPECT_EQ(frame.environment_rotation, kTurnRotation);
    const auto azimuth = [](const Camera& camera) {
        return angles_of(glm::dvec3(camera.position) - glm::dvec3(camera.target)).azimuth_deg;
    };
    EXPECT_NEAR(azimuth(frame.camera), azimuth(tilted_camera()) + 90, 1e-4);
    EXPECT_EQ(frame.camera.target, tilted_camera().target);
    EXPECT_EQ(frame.camera.near_plane, tilted_camera().near_plane);
}

}  // namespace
}  // namespace burnish
