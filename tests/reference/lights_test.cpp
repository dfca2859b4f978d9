#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/lamps.hpp"
#include "reference/owen_points.hpp"
#include "reference/sky.hpp"
#include "reference/surfaces.hpp"

namespace burnish {
namespace {

constexpr double kPi4 = 4.0 * std::numbers::pi;

// Dim, with a bright patch and a turn.
Environment patchy() {
    Environment sky = test::constant_environment({0.2f, 0.3f, 0.4f}, 64);
    for (int y = 6; y < 9; ++y)
        for (int x = 40; x < 44; ++x)
            for (int c = 0; c < 3; ++c) sky.radiance.at(x, y)[c] = 40.0f;
    return sky;
}

RenderSettings turned() {
    RenderSettings settings;
    settings.environment_rotation = 0.7f;
    settings.environment_intensity = 1.5f;
    return settings;
}

glm::vec3 on_sphere(float a, float b) {
    const float z = 1.0f - 2.0f * a, r = std::sqrt(std::max(1.0f - z * z, 0.0f));
    return {r * std::cos(6.2831853f * b), r * std::sin(6.2831853f * b), z};
}

TEST(Sky, DrawsWithTheDensityThatItStates) {
    const Sky sky(patchy(), turned());
    int others = 0;
    for (std::uint32_t i = 0; i < 4096; ++i) {
        const auto xi = owen_point(i, 1);
        const Sky::Sample s = sky.sample({xi[0], xi[1]});
        if (std::abs(sky.pdf(s.direction) / s.pdf - 1.0f) > 1e-3f) ++others;
        EXPECT_NEAR(glm::length(s.direction), 1.0f, 1e-5f);
    }
    EXPECT_LE(others, 4);  // draws at the edge of a texel, which by rounding lie in the next one
}

TEST(Sky, HasADensityThatIntegratesToOneAndDrawsTheLightThatThereIs) {
    const Sky sky(patchy(), turned());
    double density = 0.0, even = 0.0, drawn = 0.0;
    constexpr std::uint32_t kCount = 1 << 18;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const auto xi = owen_point(i, 2);
        const glm::vec3 w = on_sphere(xi[0], xi[1]);
        density += static_cast<double>(sky.pdf(w)) * kPi4 / kCount;
        even += static_cast<double>(sky.radiance(w).y) * kPi4 / kCount;
        const Sky::Sample s = sky.sample({xi[2], xi[3]});
        drawn += static_cast<double>(s.radiance.y / s.pdf) / kCount;
    }
    // Of a patch of 12 in 2048 texels, 2^18 stratified points hold 1,500: 1 %.
    EXPECT_NEAR(density, 1.0, 0.01);
    EXPECT_NEAR(drawn / even, 1.0, 0.01);
}

// The luminance over the density varies between texels and their neighbors alone.
TEST(Sky, DrawsBrightPartsAsOftenAsTheyAreBright) {
    const Sky sky(patchy(), turned());
    double sum = 0.0, squares = 0.0;
    constexpr std::uint32_t kCount = 4096;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const auto xi = owen_point(i, 5);
        const Sky::Sample s = sky.sample({xi[0], xi[1]});
        const double value = static_cast<double>(s.radiance.x + s.radiance.y + s.radiance.z) /
                             static_cast<double>(s.pdf);
        sum += value / kCount;
        squares += value * value / kCount;
    }
    // Without the distribution the ratio of deviation to mean would be 3.
    EXPECT_LT(std::sqrt(squares - sum * sum) / sum, 0.5);
}

TEST(Sky, IsDarkWithoutAnEnvironmentOrWithTheImageLightOff) {
    EXPECT_FALSE(Sky(Environment{}, turned()).lights());
    RenderSettings off = turned();
    off.image_light = ImageLight::off;
    EXPECT_FALSE(Sky(patchy(), off).lights());
    EXPECT_GT(Sky(patchy(), off).background({0, 1, 0}, {0.5f, 0.5f}).y, 0.0f);
}

Light lamp(LightType type) {
    Light light;
    light.type = type;
    light.position = {0.4f, 0.3f, 2.0f};
    light.direction = glm::normalize(type == LightType::tube ? glm::vec3(1.0f, 0.2f, 0.1f)
                                                             : glm::vec3(-0.3f, 0.1f, -1.0f));
    light.size = type == LightType::tube ? glm::vec2(1.5f, 0.4f) : glm::vec2(1.2f, 0.7f);
    light.intensity = 3.0f;
    return light;
}

TEST(AreaLamp, GivesTheIrradianceOfItsOutline) {
    for (const LightType type : {LightType::rectangle, LightType::disc, LightType::tube}) {
        const AreaLamp light(lamp(type));
        const glm::vec3 at(0.1f, -0.2f, 0.0f), up(0.0f, 0.0f, 1.0f);
        double irradiance = 0.0;
        constexpr std::uint32_t kCount = 1 << 14;
        for (std::uint32_t i = 0; i < kCount; ++i) {
            const auto xi = owen_point(i, 9);
            const auto seen = light.sample(at, {xi[0], xi[1]});
            ASSERT_TRUE(seen);
            irradiance +=
                static_cast<double>(seen->radiance.x * seen->direction.z / seen->pdf) / kCount;
        }
        const double exact =
            3.0 * std::numbers::pi * static_cast<double>(light.cosine_share(at, up));
        // The outline of area_cosine is an octagon for a disc (1 %), and of a tube without its round ends (2 %).
        EXPECT_NEAR(irradiance / exact, 1.0, type == LightType::rectangle ? 1e-3 : 0.02)
            << static_cast<int>(type);
    }
}

TEST(AreaLamp, IsMetWhereItIsSampledWithTheSameDensity) {
    for (const LightType type : {LightType::rectangle, LightType::disc, LightType::tube})
        for (const bool two_sided : {false, true}) {
            Light described = lamp(type);
            described.two_sided = two_sided;
            const AreaLamp light(described);
            const glm::vec3 at(0.1f, -0.2f, two_sided && type != LightType::tube ? 4.0f : 0.0f);
            for (std::uint32_t i = 0; i < 256; ++i) {
                const auto xi = owen_point(i, 4);
                const auto seen = light.sample(at, {xi[0], xi[1]});
                ASSERT_TRUE(seen);
                const auto met = light.met_by(at, seen->direction);
                // Rounding at the rim, and where the side of a tube is seen at a slant.
                if (!met || (type == LightType::tube && std::abs(xi[0] - 0.5f) > 0.45f)) continue;
                EXPECT_NEAR(met->distance / seen->distance, 1.0f, 1e-3f);
                EXPECT_NEAR(met->pdf / seen->pdf, 1.0f, 0.02f) << static_cast<int>(type);
            }
        }
}

TEST(AreaLamp, DoesNotEmitBehind) {
    const AreaLamp light(lamp(LightType::rectangle));
    EXPECT_FALSE(light.sample({0.0f, 0.0f, 4.0f}, {0.5f, 0.5f}));
    EXPECT_FALSE(light.met_by({0.4f, 0.3f, 4.0f}, {0.0f, 0.0f, -1.0f}));
    const AreaLamp tube(lamp(LightType::tube));
    EXPECT_FALSE(tube.sample(lamp(LightType::tube).position, {0.5f, 0.5f}));  // within it
}

// Light that is looked for, light that the lobe meets, and both weighted by the power heuristic: one integral.
TEST(Lights, AreTheSameByTheirOwnSamplingByTheLobesAndByBoth) {
    const Sky sky(patchy(), turned());
    for (const Method method :
         {Method::normal_map, Method::rotate_approx, Method::follow_grain, Method::deform_smooth}) {
        Material m = test::rough_metal({0.15f, 0.4f});
        m.method = method;
        const PointSurface surface = test::surface_of(m, {0.3f, -0.5f, 1.0f});
        double by_sky = 0.0, by_lobe = 0.0, by_both = 0.0, squares_sky = 0.0, squares_lobe = 0.0,
               squares_both = 0.0;
        constexpr std::uint32_t kCount = 1 << 16;
        for (std::uint32_t i = 0; i < kCount; ++i) {
            const auto xi = owen_point(0, i), more = owen_point(1, i);
            const Sky::Sample s = sky.sample({xi[0], xi[1]});
            const double a =
                static_cast<double>((surface.eval_cos(s.direction) * s.radiance).y / s.pdf);
            const double pa = static_cast<double>(s.pdf),
                         pb = static_cast<double>(surface.pdf(s.direction));
            double both = a * pa * pa / (pa * pa + pb * pb), b = 0.0;
            if (const auto drawn = surface.sample({more[0], more[1], more[2]})) {
                b = static_cast<double>((drawn->weight * sky.radiance(drawn->wi)).y);
                const double qb = static_cast<double>(drawn->pdf),
                             qa = static_cast<double>(sky.pdf(drawn->wi));
                both += b * qb * qb / (qa * qa + qb * qb);
            }
            by_sky += a / kCount;
            by_lobe += b / kCount;
            by_both += both / kCount;
            squares_sky += a * a / kCount;
            squares_lobe += b * b / kCount;
            squares_both += both * both / kCount;
        }
        const auto deviation = [&](double mean, double squares) {
            return std::sqrt((squares - mean * mean) / kCount);
        };
        const double sky_noise = deviation(by_sky, squares_sky),
                     lobe_noise = deviation(by_lobe, squares_lobe);
        EXPECT_NEAR(by_sky, by_lobe, 4.0 * std::hypot(sky_noise, lobe_noise)) << name_of(method);
        EXPECT_NEAR(by_both, by_lobe, 4.0 * lobe_noise) << name_of(method);
        // Both together are not much noisier than the better one, though the other one is far noisier.
        EXPECT_LT(deviation(by_both, squares_both), 1.5 * std::min(sky_noise, lobe_noise))
            << name_of(method);
    }
}

}  // namespace
}  // namespace burnish
