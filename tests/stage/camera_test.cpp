// Where the framed camera stands.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "burnish/load_model.hpp"
#include "burnish/stage.hpp"

namespace burnish {
namespace {

Camera camera_of(std::initializer_list<std::pair<const char*, const char*>> texts) {
    ParameterValues values;
    for (const auto& [name, text] : texts) values.set(name, text, name);
    return place_camera(load_model("builtin:sphere", 0), values, 1.5);
}

double distance_of(const Camera& camera) {
    return static_cast<double>(glm::distance(camera.position, camera.target));
}

TEST(FramedCamera, ZoomDividesItsDistance) {
    const double usual = distance_of(camera_of({}));
    EXPECT_NEAR(distance_of(camera_of({{"camera_zoom", "2"}})), usual / 2, 1e-5 * usual);
    EXPECT_NEAR(distance_of(camera_of({{"camera_zoom", "0.5"}})), usual * 2, 1e-5 * usual);
}

TEST(FramedCamera, AzimuthsWrap) {
    const Camera once = camera_of({{"camera_azimuth", "45"}});
    const Camera again = camera_of({{"camera_azimuth", "765"}});
    EXPECT_LT(glm::distance(once.position, again.position), 1e-5f);
}

// Of a sphere of radius r a light 60 degrees high casts the shadow of the top to 2 r/tan 60 = 1.15 r from
// the middle; the view shows the ground to 2 r.
TEST(FramedCamera, ShowsTheGroundAroundTheModel) {
    const Camera camera = camera_of({{"ground", "true"}, {"camera_elevation", "20"}});
    const glm::vec3 forward = glm::normalize(camera.target - camera.position);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::vec3 up = glm::cross(right, forward);
    const float half = std::tan(0.5f * camera.yfov);
    const auto inside = [&](glm::vec3 p) {
        const glm::vec3 v = p - camera.position;
        const float depth = glm::dot(v, forward);
        return std::abs(glm::dot(v, up)) <= half * depth &&
               std::abs(glm::dot(v, right)) <= 1.5f * half * depth;
    };
    const float r = bounds_of(load_model("builtin:sphere", 0)).high.y;
    for (const float x : {-2.0f, 2.0f})
        for (const float z : {-2.0f, 2.0f})
            EXPECT_TRUE(inside({x * r, -r, z * r})) << x << "," << z;
    EXPECT_GT(distance_of(camera), distance_of(camera_of({{"camera_elevation", "20"}})));
}

}  // namespace
}  // namespace burnish
