// Lights on the sphere of directions, and the light that puts a highlight at a point: against D over a
// grid of half vectors, by f64 alone.
#include "viewer/motion/light_sphere.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <string>

#include "burnish/f64.hpp"
#include "core/constants.hpp"
#include "gpu/tabulated_scenes.hpp"
#include "viewer/inspect/point_lobe.hpp"
#include "viewer/inspect/ray.hpp"
#include "viewer/viewer_scenes.hpp"

namespace burnish::viewer {
namespace {

constexpr WindowSize kBallWindow = {800, 600};

Camera front_camera() {
    Camera camera;
    camera.position = {0.5f, 1.0f, 4.0f};
    return camera;
}

TEST(DraggedLight, TheFrontOfTheBallFollowsTheCursor) {
    const Camera camera = front_camera();
    const glm::dvec3 front = towards_eye(camera, {0, 0, 0});
    const auto shown = [&](glm::dvec3 d) { return *pixel_of(camera, 0.1 * d, kBallWindow); };
    const glm::dvec2 before = shown(front);
    const glm::dvec2 right = shown(dragged_direction(camera, front, {30, 0}, 600)) - before;
    EXPECT_GT(right.x, 1);
    EXPECT_NEAR(right.y, 0, 1e-3 * right.x);
    const glm::dvec2 down = shown(dragged_direction(camera, front, {0, 30}, 600)) - before;
    EXPECT_GT(down.y, 1);
    EXPECT_NEAR(down.x, 0, 1e-3 * down.y);
    // The height of the window is half a turn.
    const glm::dvec3 back = dragged_direction(camera, front, {0, 600}, 600);
    EXPECT_LT(glm::distance(back, -front), 1e-12);
}

TEST(DraggedLight, ADragAndItsReverseCancel) {
    const Camera camera = front_camera();
    const glm::dvec3 before = glm::normalize(glm::dvec3(0.3, 0.5, -0.7));
    const glm::dvec3 there = dragged_direction(camera, before, {41, -73}, 600);
    EXPECT_NEAR(glm::length(there), 1, 1e-14);
    EXPECT_LT(glm::distance(dragged_direction(camera, there, {-41, 73}, 600), before), 1e-12);
    EXPECT_EQ(dragged_direction(camera, before, {0, 0}, 600), glm::normalize(before));
}

TEST(DraggedLight, ARectangleTurnsAsAWhole) {
    Light light;
    light.type = LightType::rectangle;
    light.position = {1.0f, 2.0f, 1.5f};
    light.direction = glm::normalize(-light.position);
    light.up = glm::normalize(glm::cross(light.direction, glm::vec3(1, 0, 0)));
    const Light moved = dragged_light(front_camera(), light, {0, 0, 0}, {50, 20}, 600);
    EXPECT_LT(glm::distance(moved.direction, glm::normalize(-moved.position)), 1e-6f);
    EXPECT_NEAR(glm::dot(moved.up, moved.direction), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::length(moved.up), 1.0f, 1e-6f);
}

TEST(DraggedLight, PointAndSpotLightsKeepTheirDistance) {
    const Camera camera = front_camera();
    const glm::dvec3 pivot(0.2, 0.1, 0.0);
    Light light;
    light.type = LightType::spot;
    light.position = {1.0f, 2.0f, 1.5f};
    light.direction = glm::normalize(glm::vec3(pivot) - light.position);
    const Light moved = dragged_light(camera, light, pivot, {60, 25}, 600);
    EXPECT_NEAR(glm::distance(glm::dvec3(moved.position), pivot),
                glm::distance(glm::dvec3(light.position), pivot), 1e-6);
    EXPECT_GT(glm::distance(moved.position, light.position), 0.1f);
    // It still points at the pivot.
    EXPECT_LT(glm::distance(glm::dvec3(moved.direction), -towards_light(moved, pivot)), 1e-6);
    light.type = LightType::directional;
    const Light turned = dragged_light(camera, light, pivot, {60, 25}, 600);
    EXPECT_EQ(turned.position, light.position);
    const glm::dvec3 wanted = dragged_direction(camera, towards_light(light, pivot), {60, 25}, 600);
    EXPECT_LT(glm::distance(towards_light(turned, pivot), wanted), 1e-6);
}

TEST(Ball, PlacesAreTheInverseOfDirections) {
    const Camera camera = front_camera();
    for (const glm::dvec3 v :
         {glm::dvec3(1, 2, 3), glm::dvec3(-1, 0.5, -2), glm::dvec3(0, -1, 0)}) {
        const glm::dvec3 d = glm::normalize(v);
        const BallPlace place = place_on_ball(camera, d);
        EXPECT_LE(glm::length(place.at), 1 + 1e-12);
        EXPECT_LT(glm::distance(direction_on_ball(camera, place), d), 1e-7);
    }
    const glm::dvec3 edge = direction_on_ball(camera, {{30, 40}, true});
    EXPECT_LT(glm::distance(place_on_ball(camera, edge).at, glm::dvec2(0.6, 0.8)), 1e-9);
}

// ---- the highlight ------------------------------------------------------------------------------

const glm::dvec3 kNormal = glm::normalize(glm::dvec3(0.35, -0.25, 1.0));
const glm::dvec3 kEye = glm::normalize(glm::dvec3(0.3, 0.1, 1.0));
constexpr double kRotation = 0.4;

f64::vec3 of(glm::dvec3 v) {
    return {v.x, v.y, v.z};
}

glm::dvec3 half_of(glm::dvec3 to_light) {
    return glm::normalize(to_light + kEye);
}

// The largest of `value` over a grid of the disk of half vectors, and finer about `h`.
template <typename Value>
double largest(glm::dvec3 h, const Value& value) {
    double most = 0;
    const auto look = [&](double x, double y) {
        const double r2 = x * x + y * y;
        if (r2 < 1) most = std::max(most, value(glm::dvec3(x, y, std::sqrt(1 - r2))));
    };
    constexpr int kSide = 300;
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) look((2 * i + 1.0) / kSide - 1, (2 * j + 1.0) / kSide - 1);
    for (const double reach : {1e-1, 1e-2, 1e-3})
        for (int i = -20; i <= 20; ++i)
            for (int j = -20; j <= 20; ++j) look(h.x + reach * i / 20, h.y + reach * j / 20);
    return most;
}

Material rotated_material(Mdf mdf, Method method) {
    Material m;
    m.lobe = AlphaLobe{{0.15f, 0.4f}};
    m.mdf = mdf;
    m.method = method;
    m.anisotropy_rotation = static_cast<float>(kRotation);
    return m;
}

TEST(Highlight, IsAtThePeakOfEveryDistributionUnderEveryMethod) {
    for (int mdf = 0; mdf < 4; ++mdf) {
        for (int method = 0; method < 9; ++method) {
            for (const bool crossed : {false, true}) {
                Material m = rotated_material(static_cast<Mdf>(mdf), static_cast<Method>(method));
                if (crossed) m.lobe = AlphaLobe{{0.45f, 0.1f}};
                const auto alpha = *stated_alpha(m);
                const Scene scene = test::tilted_plane(m, kNormal);
                const Hit hit = test::hit_at(scene, 0.2, 0.3);
                const auto light = direction_for_highlight(scene, hit, kEye);
                ASSERT_TRUE(light.has_value()) << mdf << " " << method;
                const f64::Lobe lobe = f64::lobe_from_alpha(mdf, static_cast<double>(alpha.x),
                                                            static_cast<double>(alpha.y));
                const f64::vec2 turn(std::cos(kRotation), std::sin(kRotation));
                const f64::Perturbation p =
                    f64::perturb_make(method, f64::seen_from_rotated(of(kNormal), turn),
                                      f64::lobe_grooves_along_x(mdf, lobe.p0, lobe.p1), false);
                const auto D = [&](glm::dvec3 h) {
                    return f64::lobe_D(lobe, p, f64::seen_from_rotated(of(h), turn));
                };
                // The normal is in single precision, so that D is 1e-13 below its peak; in the azimuth
                // about the geometric normal that Ashikhmin-Shirley reads under normal-map it changes
                // no faster.
                const double found = D(half_of(*light));
                EXPECT_GE(found * (1 + 1e-9), largest(half_of(*light), D))
                    << name_of(static_cast<Mdf>(mdf)) << " "
                    << name_of(static_cast<Method>(method));
            }
        }
    }
}

TEST(Highlight, OfALobeAboutADirectionIsAlongIt) {
    for (const Brdf brdf : {Brdf::phong, Brdf::lafortune}) {
        for (const Method method : {Method::none, Method::normal_map, Method::follow_grain}) {
            Material m = rotated_material(Mdf::ggx, method);
            m.brdf = brdf;
            m.lafortune_c = {-0.9f, -0.7f, 0.95f};
            m.metallic = 1.0f;
            const Scene scene = test::tilted_plane(m, kNormal);
            const Hit hit = test::hit_at(scene, 0.2, 0.3);
            const auto light = direction_for_highlight(scene, hit, kEye);
            ASSERT_TRUE(light.has_value());
            const PointLobe lobe(surface_at(scene, hit, kEye), method);
            // Phong's own denominator is the cosine of the light.
            const auto value = [&](glm::dvec3 w) {
                return (brdf == Brdf::phong ? lobe.eval_cos(w, kEye) : lobe.eval(w, kEye)).x /
                       lobe.F(w, kEye).x;
            };
            EXPECT_GE(value(*light) * (1 + 1e-9), largest(*light, value)) << name_of(method);
        }
    }
}

TEST(Highlight, OfATableIsAtItsHighestCell) {
    TabulatedMaterial t = test::blank_material({24, 80}, 1, 1);
    std::vector<float> table = test::ggx_table(t.grid, 0.3, 0.5, 0.7);
    table[static_cast<std::size_t>(7 * 80 + 13)] = 9.0f;  // theta 8.8 degrees, azimuth 58.5 degrees
    test::add_exemplar(t, table, 0.7f);
    t.angle[0] = 0.3f;
    const test::ReferenceTable reference(t.grid, table.data());
    for (const Method method :
         {Method::none, Method::normal_map, Method::follow_grain, Method::deform_smooth}) {
        Material m = rotated_material(Mdf::ggx, method);
        m.lobe = Tabulated{std::make_shared<const TabulatedMaterial>(t), {}};
        const Scene scene = test::tilted_plane(m, kNormal);
        const Hit hit = test::hit_at(scene, 0.2, 0.3);
        const auto light = direction_for_highlight(scene, hit, kEye);
        ASSERT_TRUE(light.has_value());
        const double groove = method == Method::follow_grain ? 0.7 : 0.0;
        const double angle = kRotation + 0.3 + groove;
        const f64::vec2 turn(std::cos(angle), std::sin(angle));
        const f64::Perturbation p = f64::perturb_make(
            static_cast<int>(method), f64::seen_from_rotated(of(kNormal), turn), true, false);
        const auto D = [&](glm::dvec3 h) {
            const f64::LobePoint q = f64::perturb_point(p, f64::seen_from_rotated(of(h), turn));
            const double u = std::sqrt(std::atan2(std::sqrt(q.s2), q.z) / kHalfPi);
            return q.weight * reference.at(u, std::atan2(q.y, q.x) + groove);
        };
        // The polynomial of the look-up is off by 7e-7 of an angle, and the cell is a tenth wide.
        const double found = D(half_of(*light));
        EXPECT_GE(found * (1 + 1e-4), largest(half_of(*light), D)) << name_of(method);
    }
}

TEST(Highlight, IsRefusedBelowTheHorizon) {
    const glm::dvec3 steep = glm::normalize(glm::dvec3(1.0, 0.0, 0.7));
    const glm::dvec3 from_left = glm::normalize(glm::dvec3(-0.7, 0.0, 1.0));
    const Scene scene = test::tilted_plane(rotated_material(Mdf::ggx, Method::follow_grain), steep);
    const Hit hit = test::hit_at(scene, 0, 0);
    // 55 + 2 (55 + 35) degrees from the eye: behind the plane.
    EXPECT_FALSE(direction_for_highlight(scene, hit, from_left).has_value());
    EXPECT_TRUE(direction_for_highlight(scene, hit, from_left, Method::none).has_value());
    EXPECT_FALSE(light_for_highlight(scene, hit, from_left, Light{}).has_value());
}

TEST(Highlight, IsRefusedWhereTheModelHasNoMeaning) {
    Material m = rotated_material(Mdf::ggx, Method::follow_grain);
    m.brdf = Brdf::phong;
    const Scene scene = test::tilted_plane(m, kNormal);
    const Hit hit = test::hit_at(scene, 0, 0);
    EXPECT_FALSE(direction_for_highlight(scene, hit, kEye, Method::deform_smooth).has_value());
}

TEST(Highlight, MovesALightAtItsDistance) {
    const Scene scene =
        test::tilted_plane(rotated_material(Mdf::ggx, Method::follow_grain), kNormal);
    const Hit hit = test::hit_at(scene, 0.4, -0.2);
    const glm::dvec3 wanted = *direction_for_highlight(scene, hit, kEye);
    for (const LightType type : {LightType::directional, LightType::point, LightType::spot}) {
        Light light;
        light.type = type;
        light.position = {1.0f, 1.0f, 2.0f};
        light.direction = {0.0f, -1.0f, 0.0f};
        const auto placed = light_for_highlight(scene, hit, kEye, light);
        ASSERT_TRUE(placed.has_value());
        EXPECT_LT(glm::distance(towards_light(*placed, hit.position), wanted), 1e-6);
        if (type == LightType::directional) continue;
        EXPECT_NEAR(glm::distance(glm::dvec3(placed->position), hit.position),
                    glm::distance(glm::dvec3(light.position), hit.position), 1e-6);
        if (type == LightType::spot) {
            EXPECT_LT(glm::distance(-glm::dvec3(placed->direction), wanted), 1e-6);
        }
    }
}

}  // namespace
}  // namespace burnish::viewer
