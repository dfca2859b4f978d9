#include "rays/closed_in_lights.hpp"

#include <gtest/gtest.h>

#include "shapes.hpp"

namespace burnish::test {
namespace {

Light point_at(glm::vec3 position) {
    Light light;
    light.type = LightType::point;
    light.position = position;
    return light;
}

Scene with_light(Mesh mesh, const Light& light) {
    Scene scene = scene_of({std::move(mesh)});
    scene.lights = {light};
    return scene;
}

TEST(ClosedInLights, AreThoseWithinABody) {
    const Mesh ball = sphere({0, 0, 0}, 1.0, 24);
    EXPECT_EQ(warnings_of_closed_in_lights(with_light(ball, point_at({0.2f, 0.5f, 0.1f}))).size(),
              1U);
    EXPECT_TRUE(warnings_of_closed_in_lights(with_light(ball, point_at({0, 1.1f, 0}))).empty());
    EXPECT_TRUE(warnings_of_closed_in_lights(with_light(ball, Light{})).empty());  // directional
    const Mesh crate = box({-1, -1, -1}, {1, 1, 1}, 2);
    Light rectangle = point_at({0, 0.9f, 0});
    rectangle.type = LightType::rectangle;
    const auto lines = warnings_of_closed_in_lights(with_light(crate, rectangle));
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_NE(lines[0].find("light 1: lies within the object 0"), std::string::npos) << lines[0];
}

TEST(ClosedInLights, AreNotThoseOfRoomsAndOpenShades) {
    const Light middle = point_at({0, -0.1f, 0});
    EXPECT_TRUE(
        warnings_of_closed_in_lights(with_light(box({-1, -1, -1}, {1, 1, 1}, 2, true), middle))
            .empty());
    EXPECT_TRUE(warnings_of_closed_in_lights(with_light(bowl(24), middle)).empty());
    Scene shade = with_light(sphere({0, 0, 0}, 1.0, 24), middle);
    shade.materials[0].double_sided = true;
    EXPECT_TRUE(warnings_of_closed_in_lights(shade).empty());
}

// A mirrored instance has its corners in the other order.
TEST(ClosedInLights, AreFoundInMirroredBodies) {
    Scene scene = with_light(sphere({0, 0, 0}, 1.0, 24), point_at({0.2f, 0.5f, 0.1f}));
    scene.instances[0].transform[0][0] = -1.0f;
    EXPECT_EQ(warnings_of_closed_in_lights(scene).size(), 1U);
}

}  // namespace
}  // namespace burnish::test
