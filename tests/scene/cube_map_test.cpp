#include "scene/light/cube_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/constants.hpp"
#include "gpu/test_scene.hpp"

namespace burnish::test {
namespace {

// Int L dw over the cells of a lat-long map, each of constant radiance.
double latlong_integral(const Image& map) {
    double sum = 0;
    for (int y = 0; y < map.height; ++y) {
        const double band = std::cos(kPi * y / map.height) - std::cos(kPi * (y + 1) / map.height);
        for (int x = 0; x < map.width; ++x) {
            sum += static_cast<double>(map.at(x, y)[0]) * band * 2 * kPi / map.width;
        }
    }
    return sum;
}

double cube_integral(const CubeMap& cube) {
    double sum = 0;
    for (int face = 0; face < 6; ++face) {
        for (int row = 0; row < cube.size; ++row) {
            for (int column = 0; column < cube.size; ++column) {
                sum += static_cast<double>(cube.at(face, row, column).x) *
                       cube_texel_solid_angle(cube.size, row, column);
            }
        }
    }
    return sum;
}

TEST(CubeMap, TexelsCoverTheSphere) {
    EXPECT_NEAR(cube_integral(cube_from_latlong(constant_environment(glm::vec3(1)).radiance, 8)),
                4 * kPi, 1e-5);
}

TEST(CubeMap, DirectionsFollowOpenGl) {
    // Table 8.19 of the OpenGL specification: the middle of each face and the direction of
    // increasing s.
    const glm::vec3 middle[6] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                 {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    const glm::vec3 s_axis[6] = {{0, 0, -1}, {0, 0, 1}, {1, 0, 0},
                                 {1, 0, 0},  {1, 0, 0}, {-1, 0, 0}};
    const glm::vec3 t_axis[6] = {{0, -1, 0}, {0, -1, 0}, {0, 0, 1},
                                 {0, 0, -1}, {0, -1, 0}, {0, -1, 0}};
    for (int face = 0; face < 6; ++face) {
        EXPECT_NEAR(glm::distance(cube_direction(face, 0.5, 0.5), middle[face]), 0, 1e-6);
        EXPECT_GT(glm::dot(cube_direction(face, 0.9, 0.5), s_axis[face]), 0.5f);
        EXPECT_GT(glm::dot(cube_direction(face, 0.5, 0.9), t_axis[face]), 0.5f);
    }
}

// A sun of one pixel at the equator, at medium elevation and near the zenith: samples must not miss
// it.
TEST(CubeMap, KeepsTheEnergyOfASmallSun) {
    for (const int width : {256, 1000}) {
        for (const double height : {0.03, 0.2, 0.37, 0.5, 0.81}) {
            Image map(width, width / 2, 3, 0.0f);
            const int y = static_cast<int>(height * map.height);
            const int x = static_cast<int>(0.643 * map.width);
            for (int c = 0; c < 3; ++c) map.at(x, y)[c] = 1e5f;
            const CubeMap cube = cube_from_latlong(map, cube_size_for(width));
            const double wanted = latlong_integral(map);
            EXPECT_NEAR(cube_integral(cube) / wanted, 1.0, 0.005) << width << " at " << height;
            for (const CubeMap& level : cube_mips(cube)) {
                EXPECT_NEAR(cube_integral(level) / wanted, 1.0, 0.005) << level.size;
            }
        }
    }
}

TEST(CubeMap, LooksWhereTheLatLongLooks) {
    // A gradient of two coordinates: u in red, v in green.
    Image map(256, 128, 3);
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            map.at(x, y)[0] = (static_cast<float>(x) + 0.5f) / 256;
            map.at(x, y)[1] = (static_cast<float>(y) + 0.5f) / 128;
        }
    }
    const CubeMap cube = cube_from_latlong(map, 64);
    const auto at = [&](int face) { return cube.at(face, 32, 32); };
    EXPECT_NEAR(at(5).x, 0.5f, 0.02f);   // -z: the middle
    EXPECT_NEAR(at(0).x, 0.75f, 0.02f);  // columns run towards +x
    EXPECT_NEAR(at(1).x, 0.25f, 0.02f);
    EXPECT_NEAR(at(2).y, 0.0f, 0.02f);  // row 0 is the zenith
    EXPECT_NEAR(at(3).y, 1.0f, 0.02f);
    EXPECT_NEAR(at(4).y, 0.5f, 0.02f);
}

TEST(CubeMap, WhatIsNoRadianceIsBlack) {
    Image map = constant_environment(glm::vec3(1)).radiance;
    map.pixels[0] = std::nanf("");
    map.pixels[1] = -5.0f;
    map.pixels[2] = HUGE_VALF;
    for (const glm::vec3& v : cube_from_latlong(map, 16).texels) {
        for (int c = 0; c < 3; ++c) EXPECT_TRUE(v[c] >= 0.0f && v[c] <= 1.0f);
    }
}

TEST(Irradiance, IsExactForConstantLight) {
    const CubeMap cube =
        cube_irradiance(cube_from_latlong(constant_environment({2, 1, 0.5f}).radiance, 16), 8);
    for (const glm::vec3& v : cube.texels) {
        EXPECT_NEAR(glm::distance(v, glm::vec3(2, 1, 0.5f)), 0, 1e-5);
    }
}

// L = max(dot(d, up), 0)^2: its cosine convolution about up is Int cos^3 dw / pi = 1/2.
TEST(Irradiance, AgreesWithAClosedForm) {
    Image map(256, 128, 3);
    for (int y = 0; y < map.height; ++y) {
        const float cosine = std::max(std::cos(kPiF * (static_cast<float>(y) + 0.5f) / 128), 0.0f);
        for (int x = 0; x < map.width; ++x) {
            for (int c = 0; c < 3; ++c) map.at(x, y)[c] = cosine * cosine;
        }
    }
    const CubeMap cube = cube_irradiance(cube_from_latlong(map, 32), 16);
    // The four texels around the zenith are 0.09 rad away: the cosine costs 0.4 %.
    EXPECT_NEAR(cube.at(2, 8, 8).x, 0.5f, 0.005f);
    EXPECT_NEAR(cube.at(3, 8, 8).x, 0.0f, 0.005f);
}

}  // namespace
}  // namespace burnish::test
