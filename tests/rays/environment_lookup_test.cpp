// Radiance and irradiance of environments on the CPU, against closed forms.
#include "rays/environment_lookup.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <random>

#include "core/constants.hpp"

namespace burnish {
namespace {

std::shared_ptr<const PreparedEnvironment> prepared(
    const std::function<glm::dvec3(glm::dvec3)>& radiance) {
    Environment environment;
    constexpr int kWidth = 128, kHeight = 64;
    environment.radiance = Image(kWidth, kHeight, 3);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const double theta = kPi * (y + 0.5) / kHeight,
                         phi = 2 * kPi * ((x + 0.5) / kWidth - 0.5);
            const glm::dvec3 value = radiance({std::sin(theta) * std::sin(phi), std::cos(theta),
                                               -std::sin(theta) * std::cos(phi)});
            for (int c = 0; c < 3; ++c)
                environment.radiance.at(x, y)[c] = static_cast<float>(value[c]);
        }
    return prepare_environment(std::move(environment));
}

std::vector<glm::vec3> directions() {
    std::mt19937 engine(5);
    std::normal_distribution<float> normal;
    std::vector<glm::vec3> all = {{1, 0, 0},
                                  {-1, 0, 0},
                                  {0, 1, 0},
                                  {0, -1, 0},
                                  {0, 0, 1},
                                  {0, 0, -1},
                                  glm::normalize(glm::vec3(1, 1, 1))};
    for (int i = 0; i < 100; ++i)
        all.push_back(glm::normalize(glm::vec3(normal(engine), normal(engine), normal(engine))));
    return all;
}

TEST(EnvironmentLookup, OfNoneIsBlack) {
    const EnvironmentLookup none(nullptr, 1.0f, 0.0f);
    EXPECT_TRUE(none.is_dark());
    EXPECT_EQ(none.radiance({0, 1, 0}, 0.5f), glm::vec3(0.0f));
    EXPECT_EQ(none.irradiance({0, 1, 0}), glm::vec3(0.0f));
}

TEST(EnvironmentLookup, OfAConstantIsTheConstantTimesTheIntensity) {
    const auto environment = prepared([](glm::dvec3) { return glm::dvec3(1.0, 0.5, 2.0); });
    const EnvironmentLookup lookup(environment.get(), 3.0f, 0.7f);
    EXPECT_FALSE(lookup.is_dark());
    for (const glm::vec3& w : directions()) {
        // Half floats of 11 bits, summed over texels: 2^-10.
        EXPECT_LT(glm::length(lookup.irradiance(w) - glm::vec3(3, 1.5f, 6)), 0.006f);
        for (const float alpha : {0.0f, 0.01f, 0.1f, 0.5f, 1.0f})
            EXPECT_LT(glm::length(lookup.radiance(w, alpha) - glm::vec3(3, 1.5f, 6)), 0.006f);
    }
}

// Of 1 + a.w: irradiance over pi is 1 + 2/3 a.n, a lobe's mean 1 + m a.w with m from 1, of a mirror, down.
TEST(EnvironmentLookup, OfALinearFunctionIsTheClosedForm) {
    const glm::dvec3 slope(0.3, -0.4, 0.6);
    const auto environment =
        prepared([&](glm::dvec3 w) { return glm::dvec3(1 + glm::dot(slope, w)); });
    const EnvironmentLookup lookup(environment.get(), 1.0f, 0.0f);
    for (const glm::vec3& w : directions()) {
        const double along = glm::dot(slope, glm::dvec3(w));
        // Texels of 1/16 of a face: a function that bends by 0.8 a radian squared.
        EXPECT_NEAR(static_cast<double>(lookup.irradiance(w).x), 1 + along * 2 / 3, 0.01);
        EXPECT_NEAR(static_cast<double>(lookup.radiance(w, 0.0f).x), 1 + along, 0.02);
        // A rough lobe lies between the mirror and the hemisphere. Its map has few texels: measured 0.065 beyond
        // them, of a function that changes by 0.78 a radian.
        const double rough = std::abs(static_cast<double>(lookup.radiance(w, 0.5f).x) - 1);
        EXPECT_LE(rough, std::abs(along) + 0.08);
        EXPECT_GE(rough, std::abs(along) / 2 - 0.08);
    }
}

// A rotation by an angle about +y leads +z to +x.
TEST(EnvironmentLookup, RotatesAboutTheYAxis) {
    const glm::dvec3 slope(0.3, -0.4, 0.6);
    const auto environment =
        prepared([&](glm::dvec3 w) { return glm::dvec3(1 + glm::dot(slope, w)); });
    for (const float angle : {0.5f, 1.5707964f, -2.0f}) {
        const EnvironmentLookup lookup(environment.get(), 1.0f, angle);
        const double a = static_cast<double>(angle);
        const glm::dvec3 turned(std::cos(a) * slope.x + std::sin(a) * slope.z, slope.y,
                                -std::sin(a) * slope.x + std::cos(a) * slope.z);
        for (const glm::vec3& w : directions()) {
            const double along = glm::dot(turned, glm::dvec3(w));
            EXPECT_NEAR(static_cast<double>(lookup.irradiance(w).x), 1 + along * 2 / 3, 0.01);
            EXPECT_NEAR(static_cast<double>(lookup.radiance(w, 0.0f).x), 1 + along, 0.02);
        }
    }
}

// Brighter than half floats hold.
TEST(EnvironmentLookup, KeepsTheLightOfASun) {
    const auto environment = prepared([](glm::dvec3) { return glm::dvec3(1e6); });
    const EnvironmentLookup lookup(environment.get(), 1.0f, 0.0f);
    EXPECT_NEAR(lookup.irradiance({0, 1, 0}).x, 1e6f, 2e3f);
    EXPECT_NEAR(lookup.radiance({0, 1, 0}, 0.3f).x, 1e6f, 2e3f);
}

}  // namespace
}  // namespace burnish
