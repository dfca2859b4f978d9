// Light that surfaces reflect to one another, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/packing.hpp>

#include "bounce_support.hpp"
#include "core/constants.hpp"

namespace burnish::test {
namespace {

// The interface of a dielectric reflects at grazing angles, whatever its f0: 20/21 passes on the way in, and as much
// on the way out.
constexpr double kThrough = 400.0 / 441.0;

// All points of a sphere have the same form factor to one another. Under a white sky the irradiance over pi
// of an open half is 1/2 from the sky and half of what the bowl itself sends: E <- 1/2 + rho E/2. What blocks
// the view after n reflections has the radiance rho E of n - 1 reflections.
TEST(Bounces, InABowlAreTheGeometricSeries) {
    const SceneLight sky = white_sky();
    for (const double albedo : {0.3, 0.9}) {
        const double rho = kThrough * albedo;
        Scene scene = scene_of({bowl(12)});
        scene.materials[0] = matt(glm::vec3(static_cast<float>(albedo)));
        VisibilityFinder finder(scene, kWhole);
        double irradiance = 0.5;
        for (int bounces = 1; bounces <= 4; ++bounces) {
            const auto seen = finder.lit(sky, bounces);
            double sum = 0, most = 0, slope = 0;
            int inner = 0;
            for (std::size_t i = 0; i < scene.meshes[0].positions.size(); ++i) {
                // The rim's rays start beside it, where half of their directions are open.
                if (scene.meshes[0].positions[i].y > -0.3f) continue;
                const f64::Surroundings s = around(*seen, 0, i);
                sum += s.color.x;
                most = std::max(most, std::abs(s.color.x - rho * irradiance));
                slope = std::max(slope, f64::length(s.slope));
                ++inner;
            }
            // Measured: below 2 percent in the mean.
            EXPECT_NEAR(sum / inner, rho * irradiance, 0.02 * rho * irradiance);
            EXPECT_LT(most, 0.16 * rho * irradiance);  // 64 lamps of the sky: 13 percent
            EXPECT_LT(slope, 0.3);
            irradiance = 0.5 + rho * irradiance / 2;
        }
    }
}

TEST(Bounces, OfNoneTheSurroundingsAreBlack) {
    VisibilityFinder finder(scene_of({bowl(6)}), kWhole);
    EXPECT_TRUE(is_dark(*finder.lit(white_sky(), 0), 0));
    EXPECT_TRUE(is_dark(*finder.visibility(), 0));
    // Nor without any light.
    EXPECT_TRUE(is_dark(*finder.lit({}, 3), 0));
}

TEST(Bounces, FollowTheIntensityOfTheEnvironment) {
    const Scene scene = scene_of({bowl(6)});
    VisibilityFinder finder(scene, kWhole);
    SceneLight sky = white_sky();
    const auto once = finder.lit(sky, 2);
    sky.intensity = 8.0f;
    const auto eightfold = finder.lit(sky, 2);
    for (std::size_t i = 0; i < scene.meshes[0].positions.size(); ++i)
        // 2^-10: half floats have 11 bits.
        EXPECT_NEAR(around(*eightfold, 0, i).color.x, 8 * around(*once, 0, i).color.x,
                    8 * std::ldexp(1.0, -10));
    sky.intensity = 0.0f;
    EXPECT_TRUE(is_dark(*finder.lit(sky, 2), 0));
}

TEST(Bounces, HaveTheColorOfTheMaterial) {
    Scene scene = scene_of({bowl(6)});
    scene.materials[0] = matt({0.8f, 0.4f, 0.1f});
    VisibilityFinder finder(scene, kWhole);
    const auto seen = finder.lit(white_sky(), 1);
    const std::size_t lowest = vertex_at(scene.meshes[0], {0, -1, 0});
    const f64::vec3 color = around(*seen, 0, lowest).color;
    EXPECT_NEAR(color.y / color.x, 0.5, 0.01);
    EXPECT_NEAR(color.z / color.x, 0.125, 0.01);
}

// A plate over a floor, in the dark: what blocks the floor's view has the plate's radiance everywhere.
TEST(Bounces, APlateThatEmitsLightsTheFloor) {
    const glm::dvec3 middle(0.1, 0.6, 0);
    Scene scene = scene_of({ground(0.8, 8), disc(middle, 0.4, {0, -1, 0})});
    scene.materials.push_back(matt(glm::vec3(0.0f)));
    scene.materials[1].emissive = {2.0f, 1.0f, 0.25f};
    scene.instances[1].material = 1;
    VisibilityFinder finder(scene, kWhole);
    const auto seen = finder.lit({}, 1);
    double most = 0;
    for (std::size_t i = 0; i < scene.meshes[0].positions.size(); ++i) {
        const glm::dvec3 to = middle - place_of(scene, 0, i).position;
        const f64::vec3 light = radiance(around(*seen, 0, i), to);
        most = std::max(most, f64::length(light - f64::vec3(2.0, 1.0, 0.25)));
    }
    EXPECT_LT(most, 0.01);
}

// The plate sees the floor that it lights. A disc of radius R at height h and distance d aside gives an
// irradiance over pi of (1 - (d^2 + h^2 - R^2) / sqrt((d^2 + h^2 + R^2)^2 - 4 R^2 d^2)) / 2 times its radiance.
TEST(Bounces, APlateThatEmitsSeesTheFloorThatItLights) {
    constexpr double kRadius = 0.4, kHeight = 0.6, kFloor = 2.0;
    Scene scene = scene_of({disc({0, kHeight, 0}, kRadius, {0, -1, 0}), ground(kFloor, 40)});
    scene.materials.push_back(matt(glm::vec3(0.0f)));
    scene.materials[1].emissive = glm::vec3(1.0f);
    scene.instances[0].material = 1;
    const auto irradiance = [&](double d) {
        const double sum = d * d + kHeight * kHeight;
        return (1 - (sum - kRadius * kRadius) / std::sqrt(std::pow(sum + kRadius * kRadius, 2) -
                                                          4 * kRadius * kRadius * d * d)) /
               2;
    };
    // Weighted by the cosine, over what of the floor the plate's middle sees: all but the horizon.
    double wanted = 0, share = 0;
    constexpr int kSteps = 1000;
    for (int i = 0; i < kSteps; ++i) {
        const double sine2 = (i + 0.5) / kSteps, d = kHeight * std::sqrt(sine2 / (1 - sine2));
        if (d > kFloor) continue;
        wanted += kThrough * irradiance(d) / kSteps;
        share += 1.0 / kSteps;
    }
    VisibilityFinder finder(scene, kWhole);
    const auto seen = finder.lit({}, 2);
    const std::size_t middle = vertex_at(scene.meshes[0], {0, kHeight, 0});
    const f64::vec3 found = f64::surroundings_about(around(*seen, 0, middle), share, {0, -1, 0});
    // Measured: 17 percent too bright. The light falls from below the plate to the horizon by more than the plane of
    // least squares may, whose base is held to a quarter of its mean.
    EXPECT_GT(found.x, 0.98 * wanted);
    EXPECT_LT(found.x, 1.18 * wanted);
    // Straight below it is brighter than the mean.
    EXPECT_GT(radiance(around(*seen, 0, middle), {0, -1, 0}).x, 1.2 * wanted / share);
}

// A floor between a red wall at +x and a black one at -x.
Scene corridor() {
    Scene scene = scene_of({ground(1.0, 8), rectangle({1, 0, -1}, {0, 0, 2}, {0, 2, 0}, 8, 8),
                            rectangle({-1, 0, 1}, {0, 0, -2}, {0, 2, 0}, 8, 8)});
    scene.materials.push_back(matt({0.8f, 0.05f, 0.05f}));
    scene.materials.push_back(matt(glm::vec3(0.0f)));
    scene.instances[1].material = 1;
    scene.instances[2].material = 2;
    return scene;
}

TEST(Bounces, ARedWallColorsTheFloorAndItsSideOfIt) {
    Scene scene = corridor();
    for (const std::size_t wall : {std::size_t{1}, std::size_t{2}})
        ASSERT_LT(
            glm::dot(glm::vec3(scene.meshes[wall].normals[0]), scene.meshes[wall].positions[0]),
            0.0f)
            << "the walls face the floor";
    VisibilityFinder finder(scene, kWhole);
    const auto seen = finder.lit(white_sky(), 1);
    const std::size_t middle = vertex_at(scene.meshes[0], glm::dvec3(0.0));
    const f64::Surroundings s = around(*seen, 0, middle);
    EXPECT_GT(s.color.x, 4 * s.color.y);
    EXPECT_NEAR(s.color.y, s.color.z, 1e-3);
    EXPECT_GT(s.slope.x, 3 * std::abs(s.slope.z));
    EXPECT_GT(radiance(s, {1, 0.3, 0}).x, 3 * radiance(s, {-1, 0.3, 0}).x);
    // Without the black wall the red one is all that blocks the view.
    scene.instances[2].mesh = -1;
    VisibilityFinder alone(scene, kWhole);
    const f64::Surroundings one = around(*alone.lit(white_sky(), 1), 0, middle);
    EXPECT_GT(one.color.x, 4 * one.color.y);
}

// The wall at x = 1 under a directional light that travels along (1, -0.5, 0), seen from a black floor.
Scene wall_and_floor() {
    Scene scene = scene_of({ground(0.8, 8), rectangle({1, 0, -2}, {0, 0, 4}, {0, 2, 0}, 16, 8)});
    scene.materials.push_back(matt(glm::vec3(0.0f)));
    scene.instances[0].material = 1;
    return scene;
}

Light sun() {
    Light light;
    light.direction = glm::normalize(glm::vec3(1.0f, -0.5f, 0.0f));
    light.intensity = 3.0f;
    light.color = {1.0f, 0.5f, 0.25f};
    return light;
}

TEST(Bounces, ALitWallHasTheRadianceOfLambertsLaw) {
    const Scene scene = wall_and_floor();
    ASSERT_LT(scene.meshes[1].normals[0].x, 0.0f) << "the wall faces the floor";
    VisibilityFinder finder(scene, kWhole);
    const std::vector<Light> lights{sun()};
    SceneLight light;
    light.lights = lights;
    const std::size_t middle = vertex_at(scene.meshes[0], glm::dvec3(0.0));
    const f64::vec3 found =
        radiance(around(*finder.lit(light, 1), 0, middle), glm::dvec3(1, 0.5, 0));
    const double wanted = kThrough * 3.0 / kPi * static_cast<double>(sun().direction.x);
    // Half floats, and a slope that is found by least squares: measured 0.0001.
    EXPECT_NEAR(found.x, wanted, 0.005 * wanted);
    EXPECT_NEAR(found.y, wanted / 2, 0.005 * wanted);
    EXPECT_NEAR(found.z, wanted / 4, 0.005 * wanted);
}

TEST(Bounces, WhatStandsBetweenTakesTheLight) {
    Scene scene = wall_and_floor();
    // A shade far from the floor, before the sun, that faces it or turns its back to it.
    for (const bool faces_sun : {true, false}) {
        Scene shaded = scene;
        glm::dvec3 u(0, 0, 12), v(0, 12, 0);
        if (!faces_sun) std::swap(u, v);
        shaded.meshes.push_back(rectangle({-4, -1, -6}, u, v, 2, 2));
        shaded.instances.push_back({2, 1, glm::mat4(1.0f)});
        VisibilityFinder finder(shaded, kWhole);
        const std::vector<Light> lights{sun()};
        SceneLight light;
        light.lights = lights;
        EXPECT_TRUE(is_dark(*finder.lit(light, 1), 0)) << faces_sun;
        // A blended one lets it pass.
        shaded.materials[1].alpha_mode = AlphaMode::blend;
        VisibilityFinder through(shaded, kWhole);
        EXPECT_FALSE(is_dark(*through.lit(light, 1), 0)) << faces_sun;
    }
}

// A light behind the wall does not shine through it.
TEST(Bounces, TheBackOfAWallGetsNoLightForItsFront) {
    const Scene scene = wall_and_floor();
    VisibilityFinder finder(scene, kWhole);
    std::vector<Light> lights{sun()};
    lights[0].direction = {-1.0f, 0.0f, 0.0f};
    SceneLight light;
    light.lights = lights;
    EXPECT_TRUE(is_dark(*finder.lit(light, 1), 0));
}

// Point lights fall off with the square of the distance, spots end at their cone.
TEST(Bounces, PointsAndSpotsShineAsTheExtensionHasIt) {
    // A large wall that a lamp lights head-on at 2 m, and a piece of floor near the lit place.
    Scene scene = scene_of({rectangle({0.9, 0, 0.05}, {0.1, 0, 0}, {0, 0, -0.1}, 2, 2),
                            rectangle({1, -0.1, -0.1}, {0, 0, 0.2}, {0, 0.2, 0}, 4, 4)});
    scene.materials.push_back(matt(glm::vec3(0.0f)));
    scene.instances[0].material = 1;
    VisibilityFinder finder(scene, kWhole);
    std::vector<Light> lights(1);
    lights[0].type = LightType::point;
    lights[0].intensity = 5.0f;
    lights[0].position = {-1.0f, 0.05f, 0.0f};
    SceneLight light;
    light.lights = lights;
    // 5 cd at 2 m, over pi; the wall's corners, 0.1 m aside, get 0.4 percent less.
    const double wanted = kThrough * 5.0 / 4 / kPi;
    const auto seen = [&] { return radiance(around(*finder.lit(light, 1), 0, 0), {1, 0.5, 0}).x; };
    EXPECT_NEAR(seen(), wanted, 0.015 * wanted);
    lights[0].type = LightType::spot;
    lights[0].direction = {1.0f, 0.0f, 0.0f};
    lights[0].inner_cone = 0.3f;
    lights[0].outer_cone = 0.4f;
    EXPECT_NEAR(seen(), wanted, 0.015 * wanted);
    lights[0].direction = {0.0f, 0.0f, 1.0f};
    EXPECT_NEAR(seen(), 0.0, 1e-6);
    lights[0].type = LightType::point;
    lights[0].range = 1.5f;
    EXPECT_NEAR(seen(), 0.0, 1e-6);
}

// The upper half of the sky is white: a plate that faces up has an irradiance over pi of 1, one that faces
// sideways of 1/2, one that faces down of 0. Texels of the half's edge: measured 0.0011.
TEST(Bounces, FollowTheEnvironmentsUpAndDown) {
    const SceneLight sky = sky_of([](glm::dvec3 w) { return w.y > 0 ? 1.0 : 0.0; });
    const double up = plate_radiance(facing({0, 1, 0}), sky),
                 side = plate_radiance(facing({0, 0, 1}), sky),
                 down = plate_radiance(facing({0, -1, 0}), sky);
    EXPECT_NEAR(up, kThrough, 0.01);
    EXPECT_NEAR(side, 0.5 * kThrough, 0.01);
    EXPECT_NEAR(down, 0.0, 0.01);
}

// The half of the sky about +z is white. Rotated by 90 degrees about +y it is that about +x.
TEST(Bounces, FollowTheEnvironmentsRotation) {
    SceneLight sky = sky_of([](glm::dvec3 w) { return w.z > 0 ? 1.0 : 0.0; });
    EXPECT_NEAR(plate_radiance(facing({0, 0, 1}), sky), kThrough, 0.01);
    EXPECT_NEAR(plate_radiance(facing({1, 0, 0}), sky), 0.5 * kThrough, 0.01);
    sky.rotation = static_cast<float>(kPi / 2);
    EXPECT_NEAR(plate_radiance(facing({1, 0, 0}), sky), kThrough, 0.01);
    EXPECT_NEAR(plate_radiance(facing({-1, 0, 0}), sky), 0.0, 0.01);
    EXPECT_NEAR(plate_radiance(facing({0, 0, 1}), sky), 0.5 * kThrough, 0.01);
    sky.rotation = static_cast<float>(kPi);
    EXPECT_NEAR(plate_radiance(facing({0, 0, -1}), sky), kThrough, 0.01);
}

// A large plate close over a larger floor, under a white sky and a sun at the zenith. Its lower side is dark, and
// no light comes through it, whichever of its sides is the front.
TEST(Bounces, TheUpperSideOfAPlateDoesNotShineDown) {
    for (const double facing_up : {1.0, -1.0, 0.0}) {
        Scene scene =
            scene_of({ground(8.0, 20), rectangle({-2, 0.2, 2}, {4, 0, 0}, {0, 0, -4}, 8, 8)});
        if (facing_up < 0) scene.meshes[1] = rectangle({-2, 0.2, -2}, {4, 0, 0}, {0, 0, 4}, 8, 8);
        scene.materials.push_back(matt(glm::vec3(0.0f)));
        scene.instances[0].material = 1;
        scene.materials[0].double_sided = facing_up == 0;
        VisibilityFinder finder(scene, kWhole);
        std::vector<Light> lights(1);
        lights[0].direction = {0, -1, 0};
        lights[0].intensity = 3.0f;
        SceneLight light = white_sky();
        light.lights = lights;
        const std::size_t below = vertex_at(scene.meshes[0], glm::dvec3(0.0));
        const auto seen = finder.lit(light, 1);
        EXPECT_LT(radiance(around(*seen, 0, below), {0, 1, 0}).x, 0.05) << facing_up;
    }
}

// A box over a floor under a bright patch of the sky. The shadow is the same whether the floor has one side or two, and
// whichever of them is the front.
TEST(Bounces, BothSidesOfASurfaceHaveShadowsOfTheSky) {
    const SceneLight sky = sky_of([](glm::dvec3 w) {
        return glm::dot(w, glm::normalize(glm::dvec3(1, 2, 0))) > 0.97 ? 40.0 : 0.3;
    });
    const auto ratios = [&](bool two_sided, bool turned, std::size_t half) {
        Scene scene = scene_of({turned ? rectangle({-2, 0, -2}, {4, 0, 0}, {0, 0, 4}, 32, 32)
                                       : rectangle({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 32, 32),
                                box({-0.3, 0.02, -0.3}, {0.3, 0.8, 0.3}, 4)});
        scene.materials.push_back(matt());
        scene.materials[1].double_sided = two_sided;
        scene.instances[0].material = 1;
        VisibilityFinder finder(scene, kWhole);
        const auto seen = finder.lit(sky, 1);
        std::vector<double> found;
        for (double x = -1.6; x < -0.3; x += 0.25) {
            const std::size_t vertex = vertex_at(scene.meshes[0], {x, 0, 0});
            found.push_back(1.0 + static_cast<double>(glm::unpackHalf1x16(
                                      seen->instances[0].vertices[vertex].around[half])));
        }
        return found;
    };
    const std::vector<double> one = ratios(false, false, 6);
    EXPECT_LT(*std::ranges::min_element(one), 0.5);  // in the shadow
    EXPECT_GT(*std::ranges::max_element(one), 0.8);  // beyond it
    const std::vector<double> front = ratios(true, false, 6), back = ratios(true, true, 7);
    for (std::size_t i = 0; i < one.size(); ++i) {
        // The upper side's own rays differ by their turn about the normal.
        EXPECT_NEAR(front[i], one[i], 0.1) << i;
        EXPECT_NEAR(back[i], one[i], 0.1) << i;
    }
}

// What blocks the view does not depend on the light, nor do the warnings.
TEST(Bounces, LeaveTheBlockedShareAlone) {
    Scene scene = scene_of(
        {ground(0.5, 8), disc({0, 0.3, 0}, 0.4, {0, -1, 0}, 32), sphere({5, 5, 5}, 0.5, 8, true)});
    VisibilityFinder finder(scene, {64, true});
    const auto seen = finder.visibility(), lit = finder.lit(white_sky(), 2);
    EXPECT_EQ(seen->warnings.size(), 1u);
    EXPECT_EQ(lit->warnings, seen->warnings);
    ASSERT_EQ(lit->instances.size(), seen->instances.size());
    for (std::size_t i = 0; i < lit->instances.size(); ++i) {
        ASSERT_EQ(lit->instances[i].vertices.size(), seen->instances[i].vertices.size());
        EXPECT_EQ(lit->instances[i].mesh, seen->instances[i].mesh);
        for (std::size_t k = 0; k < lit->instances[i].vertices.size(); ++k)
            ASSERT_EQ(lit->instances[i].vertices[k].blocked,
                      seen->instances[i].vertices[k].blocked);
    }
    // A result stays as it was when the finder is lit anew.
    const auto again = finder.lit({}, 1);
    EXPECT_TRUE(is_dark(*again, 0));
    EXPECT_FALSE(is_dark(*lit, 0));
}

// Split meshes are lit as whole ones are.
TEST(Bounces, LightSplitMeshes) {
    const Scene scene =
        scene_of({ground(1.0, 2), rectangle({0.5, 0, -0.5}, {0, 0, 1}, {0, 1, 0}, 4, 4)});
    VisibilityFinder finder(scene, {});
    const auto seen = finder.lit(white_sky(), 1);
    const InstanceVisibility& floor = seen->instances.at(0);
    ASSERT_TRUE(floor.mesh);
    ASSERT_EQ(floor.vertices.size(), floor.mesh->positions.size());
    const std::size_t near = vertex_at(*floor.mesh, {0.3, 0, 0.1});
    EXPECT_GT(around_of(floor.vertices[near]).color.x, 0.2);
}

}  // namespace
}  // namespace burnish::test
