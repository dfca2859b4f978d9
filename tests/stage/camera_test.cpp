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

// The warnings of builtin:`model` with these parameters.
std::vector<std::string> warnings_of(
    const char* model, std::initializer_list<std::pair<const char*, const char*>> texts) {
    StageRequest request;
    request.input = model;
    for (const auto& [name, text] : texts) request.values.set(name, text, name);
    return set_stage(request).scene.warnings;
}

// The sphere's radius is half a meter; at a field of view of 30 degrees it fills the view from about
// 4 radii.
TEST(EyeInside, ZoomAndDistanceIntoTheModelAreWarnedOf) {
    EXPECT_TRUE(warnings_of("builtin:sphere", {{"camera_zoom", "3.9"}}).empty());
    const auto zoomed = warnings_of("builtin:sphere", {{"camera_zoom", "20"}});
    ASSERT_EQ(zoomed.size(), 1u);
    EXPECT_NE(zoomed.front().find("--camera-zoom below 4.0"), std::string::npos) << zoomed.front();
    EXPECT_TRUE(warnings_of("builtin:sphere", {{"camera_zoom", "20"}, {"camera_fov", "2"}}).empty())
        << "the remedy that the warning names";
    EXPECT_TRUE(warnings_of("builtin:sphere", {{"camera_distance", "0.51"}}).empty());
    EXPECT_EQ(warnings_of("builtin:sphere", {{"camera_distance", "0.4"}}).size(), 1u);
}

TEST(EyeInside, APositionIsWarnedOfWhereItSeesThrough) {
    EXPECT_EQ(warnings_of("builtin:sphere", {{"camera_position", "0.1,0.2,0.1"}}).size(), 1u);
    EXPECT_TRUE(warnings_of("builtin:sphere",
                            {{"camera_position", "0.1,0.2,0.1"}, {"double_sided", "true"}})
                    .empty())
        << "an interior";
    EXPECT_TRUE(warnings_of("builtin:torus", {{"camera_position", "0.01,0.02,0.01"}}).empty())
        << "the hole of a torus is in its bounds, but outside";
}

}  // namespace
}  // namespace burnish
