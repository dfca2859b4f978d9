// Moves of the camera: what must stay where it is, by the projection of rays.
#include "viewer/motion/orbit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <string>
#include <vector>

#include "burnish/parameters.hpp"
#include "burnish/stage.hpp"
#include "core/constants.hpp"
#include "scene/camera/angles.hpp"
#include "viewer/inspect/ray.hpp"

namespace burnish::viewer {
namespace {

constexpr WindowSize kFullWindow = {1280, 720};

Camera plain_camera(bool orthographic = false) {
    Camera camera;
    camera.position = {1.5f, 1.0f, 2.5f};
    camera.target = {0.1f, 0.2f, -0.3f};
    camera.yfov = 0.7f;
    camera.ymag = 1.3f;
    camera.orthographic = orthographic;
    return camera;
}

double distance_to(const Camera& camera, glm::dvec3 point) {
    return glm::distance(glm::dvec3(camera.position), point);
}

glm::dvec3 away_of(const Camera& camera) {
    return glm::normalize(glm::dvec3(camera.position) - glm::dvec3(camera.target));
}

// Positions are in single precision: 2^-24 of some meters, seen from meters away, is 1e-4 pixels of 720;
// the bound leaves room for several roundings.
constexpr double kPixelBound = 2e-3;

void expect_near(glm::dvec2 a, glm::dvec2 b, double bound) {
    EXPECT_NEAR(a.x, b.x, bound);
    EXPECT_NEAR(a.y, b.y, bound);
}

TEST(Orbit, KeepsTheDistanceAndTheUpDirection) {
    Camera camera = plain_camera();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> drag(-300, 300);
    const double distance = distance_to(camera, glm::dvec3(camera.target));
    for (int i = 0; i < 200; ++i) {
        camera = orbited(camera, {drag(random), drag(random)}, kFullWindow.height);
        // 200 roundings of 1e-7.
        ASSERT_NEAR(distance_to(camera, glm::dvec3(camera.target)), distance, 2e-5 * distance);
        ASSERT_EQ(camera.up, glm::vec3(0, 1, 0));
        ASSERT_LE(std::abs(angles_of(away_of(camera)).elevation_deg), kHighestElevationDeg + 1e-4);
        // Never upside down: the point above the target is seen above it.
        const glm::dvec3 target(camera.target);
        const auto above = pixel_of(camera, target + glm::dvec3(0, 0.1, 0), kFullWindow);
        ASSERT_TRUE(above.has_value());
        ASSERT_LT(above->y, 0.5 * kFullWindow.height);
    }
}

TEST(Orbit, ADragOverTheWindowsHeightIsAFullTurn) {
    const Camera camera = plain_camera();
    const Camera turned = orbited(camera, {720, 0}, 720);
    EXPECT_LT(glm::distance(turned.position, camera.position), 1e-6f);
    // A quarter to the right: the camera goes to the left, clockwise from above.
    const Camera quarter = orbited(camera, {180, 0}, 720);
    const double before = angles_of(away_of(camera)).azimuth_deg;
    EXPECT_NEAR(angles_of(away_of(quarter)).azimuth_deg, before - 90, 1e-4);
    // Down: it rises, a degree for two pixels.
    const Camera risen = orbited(camera, {0, 20}, 720);
    EXPECT_NEAR(angles_of(away_of(risen)).elevation_deg,
                angles_of(away_of(camera)).elevation_deg + 10, 1e-4);
}

TEST(Orbit, APointOnTheFrontFollowsTheCursorsSide) {
    const Camera camera = plain_camera();
    const glm::dvec3 front = glm::dvec3(camera.target) + 0.2 * away_of(camera);
    const glm::dvec2 before = *pixel_of(camera, front, kFullWindow);
    const glm::dvec2 after = *pixel_of(orbited(camera, {10, 6}, 720), front, kFullWindow);
    EXPECT_GT(after.x, before.x);
    EXPECT_GT(after.y, before.y);
}

TEST(Orbit, AboutAPivotKeepsItsPlaceInTheView) {
    const Camera camera = plain_camera();
    const glm::dvec3 pivot(0.4, -0.1, 0.2);
    const Camera moved = orbited(camera, pivot, {55, -31}, 720);
    EXPECT_NEAR(distance_to(moved, pivot), distance_to(camera, pivot), 1e-6);
    expect_near(*pixel_of(moved, pivot, kFullWindow), *pixel_of(camera, pivot, kFullWindow),
                kPixelBound);
    EXPECT_NEAR(distance_to(moved, glm::dvec3(moved.target)),
                distance_to(camera, glm::dvec3(camera.target)), 1e-6);
}

// A view straight down has the up direction of place_camera; its first drag must not turn it.
TEST(Orbit, LeavesAVerticalViewWithoutATurn) {
    for (const bool from_above : {true, false}) {
        for (const char* azimuth : {"0", "0.001"}) {
            ParameterValues values;
            values.set("camera_elevation", from_above ? "90" : "-90", "camera_elevation");
            values.set("camera_azimuth", azimuth, "camera_azimuth");
            Scene scene;
            const Camera camera = place_camera(scene, values, 1.5);
            const Camera moved = orbited_by(camera, glm::dvec3(camera.target), 0.0, 0.0);
            const double size = distance_to(camera, glm::dvec3(camera.target));
            const glm::dvec3 right = glm::dvec3(camera.target) + glm::dvec3(0.2 * size, 0, 0);
            // 0.1 degrees of tilt changes the place by its square; the azimuth of 0.001 degrees by 1e-5.
            expect_near(*pixel_of(moved, right, kFullWindow), *pixel_of(camera, right, kFullWindow),
                        0.05);
        }
    }
}

TEST(Pan, APointUnderTheCursorFollowsIt) {
    for (const bool orthographic : {false, true}) {
        const Camera camera = plain_camera(orthographic);
        const glm::dvec3 point(-0.3, 0.5, 0.4);
        const glm::dvec2 drag(37, -121);
        const Camera moved = panned(camera, drag, kFullWindow.height, depth_of(camera, point));
        expect_near(*pixel_of(moved, point, kFullWindow),
                    *pixel_of(camera, point, kFullWindow) + drag, kPixelBound);
        const Camera by_target = panned(camera, drag, kFullWindow.height);
        const glm::dvec3 target(camera.target);
        expect_near(*pixel_of(by_target, target, kFullWindow),
                    *pixel_of(camera, target, kFullWindow) + drag, kPixelBound);
        EXPECT_NEAR(glm::distance(away_of(moved), away_of(camera)), 0, 1e-6);
    }
}

TEST(Pan, APointBehindTheEyeCannotBeDragged) {
    const Camera camera = plain_camera();
    EXPECT_EQ(panned(camera, {10, 10}, 720, -1.0), camera);
}

TEST(Zoom, KeepsThePointUnderTheCursor) {
    for (const bool orthographic : {false, true}) {
        const Camera camera = plain_camera(orthographic);
        const glm::dvec2 cursor(900, 123);
        const glm::dvec3 under = under_cursor(camera, cursor, kFullWindow);
        expect_near(*pixel_of(camera, under, kFullWindow), cursor, kPixelBound);
        for (const double factor : {0.5, 0.9, 1.7}) {
            const Camera zoomed_camera = zoomed(camera, factor, cursor, kFullWindow);
            expect_near(*pixel_of(zoomed_camera, under, kFullWindow), cursor, kPixelBound);
            const double size =
                orthographic ? static_cast<double>(zoomed_camera.ymag / camera.ymag)
                             : distance_to(zoomed_camera, under) / distance_to(camera, under);
            EXPECT_NEAR(size, factor, 1e-6);
        }
        const glm::dvec3 seen(0.3, 0.1, 0.5);
        expect_near(*pixel_of(zoomed(camera, 0.3, seen), seen, kFullWindow),
                    *pixel_of(camera, seen, kFullWindow), kPixelBound);
    }
}

TEST(Zoom, InAndOutIsTheIdentity) {
    for (const bool orthographic : {false, true}) {
        const Camera camera = plain_camera(orthographic);
        Camera moved = camera;
        const glm::dvec2 cursor(200, 640);
        for (int i = 0; i < 12; ++i) moved = zoomed(moved, wheel_factor(1), cursor, kFullWindow);
        EXPECT_NE(moved, camera);
        for (int i = 0; i < 12; ++i) moved = zoomed(moved, wheel_factor(-1), cursor, kFullWindow);
        // 24 roundings of coordinates near 3.
        EXPECT_LT(glm::distance(moved.position, camera.position), 1e-5f);
        EXPECT_LT(glm::distance(moved.target, camera.target), 1e-5f);
        EXPECT_NEAR(moved.ymag, camera.ymag, 1e-5f);
    }
}

TEST(Zoom, StopsWhereSinglePrecisionEnds) {
    Camera near = plain_camera(), far = near;
    for (int i = 0; i < 2000; ++i) {
        near = zoomed(near, 0.5, glm::dvec3(near.target));
        far = zoomed(far, 2.0, glm::dvec3(far.target));
    }
    EXPECT_NE(near.position, near.target);
    EXPECT_TRUE(std::isfinite(far.position.x));
    EXPECT_NE(zoomed(near, 2.0, glm::dvec3(near.target)), near);
    EXPECT_NE(zoomed(far, 0.5, glm::dvec3(far.target)), far);
    EXPECT_EQ(zoomed(near, 0.0, glm::dvec3(0.0)), near);
    EXPECT_EQ(zoomed(near, std::nan(""), glm::dvec3(0.0)), near);
}

// A box whose corners are all that place_camera sees.
Scene box_scene() {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.positions.emplace_back((i & 1) != 0 ? 1.0f : -0.5f, (i & 2) != 0 ? 0.7f : -0.2f,
                                    (i & 4) != 0 ? 2.0f : 1.0f);
        mesh.normals.emplace_back(0, 0, 1);
        mesh.tangents.emplace_back(1, 0, 0, 1);
    }
    mesh.indices = {0, 1, 2};
    Scene scene;
    scene.meshes.push_back(mesh);
    scene.materials.emplace_back();
    scene.instances.push_back({});
    return scene;
}

TEST(Frame, StandsWherePlaceCameraStands) {
    const Scene scene = box_scene();
    for (const double aspect : {0.5, 1.0, 16.0 / 9}) {
        for (const char* elevation : {"-40", "20", "80"}) {
            ParameterValues values;
            values.set("camera_elevation", elevation, "camera_elevation");
            const Camera placed = place_camera(scene, values, aspect);
            const Camera there = zoomed(panned(placed, {100, 30}, 720), 0.2, {0, 0, 0});
            const Camera again = framed(there, bounds_of(scene), aspect);
            EXPECT_LT(glm::distance(again.position, placed.position), 1e-4f) << elevation;
            EXPECT_LT(glm::distance(again.target, placed.target), 1e-5f);
        }
    }
}

TEST(Frame, AnOrthographicViewShowsTheBoxWithTheMargin) {
    const Bounds bounds = bounds_of(box_scene());
    const Camera camera = framed(plain_camera(true), bounds, 16.0 / 9);
    double most = 0;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner((i & 1) != 0 ? bounds.high.x : bounds.low.x,
                                (i & 2) != 0 ? bounds.high.y : bounds.low.y,
                                (i & 4) != 0 ? bounds.high.z : bounds.low.z);
        const glm::dvec2 at = *pixel_of(camera, corner, kFullWindow);
        most = std::max({most, std::abs(at.x / 640 - 1), std::abs(at.y / 360 - 1)});
    }
    EXPECT_NEAR(most, 1 / 1.06, 1e-5);
}

TEST(Angles, AreTheInverseOfDirections) {
    for (const double azimuth : {-170.0, -90.0, 0.0, 33.0, 180.0}) {
        for (const double elevation : {-89.0, -10.0, 0.0, 45.0}) {
            const DirectionAngles angles = angles_of(direction_at({azimuth, elevation}));
            EXPECT_NEAR(angles.azimuth_deg, azimuth, 1e-9);
            EXPECT_NEAR(angles.elevation_deg, elevation, 1e-9);
        }
    }
    const DirectionAngles zenith = angles_of({0, 2, 0});
    EXPECT_EQ(zenith.azimuth_deg, 0);
    EXPECT_EQ(zenith.elevation_deg, 90);
}

}  // namespace
}  // namespace burnish::viewer
