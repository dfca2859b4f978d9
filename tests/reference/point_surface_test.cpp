#include "reference/point_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "burnish/surface.hpp"
#include "reference/chi_square.hpp"
#include "reference/owen_points.hpp"
#include "reference/surfaces.hpp"

namespace burnish {
namespace {

std::string label(const Material& m) {
    return std::string(name_of(m.brdf)) + " " + std::string(name_of(m.mdf)) + " " +
           std::string(name_of(m.method));
}

// 5 sigmas: the bins of the midpoint rule are wrong by less than a tenth of their noise.
TEST(PointSurface, DrawsByItsDensityForEveryDistributionAndMethod) {
    for (std::size_t mdf = 0; mdf < mdf_names().size(); ++mdf)
        for (std::size_t method = 0; method < method_names().size(); ++method)
            for (const glm::vec3 eye :
                 {glm::vec3(0.3f, 0.1f, 1.0f), glm::vec3(-1.0f, 0.6f, 0.5f)}) {
                Material m = test::rough_metal();
                m.mdf = static_cast<Mdf>(mdf);
                m.method = static_cast<Method>(method);
                EXPECT_LT(std::abs(test::chi_square_sigmas(test::surface_of(m, eye))), 5.0)
                    << label(m);
            }
}

TEST(PointSurface, DrawsByItsDensityForEveryModel) {
    for (std::size_t brdf = 0; brdf < brdf_names().size(); ++brdf)
        for (const Method method : {Method::normal_map, Method::follow_grain}) {
            Material m = test::rough_metal();
            m.metallic = 0.4f;
            m.brdf = static_cast<Brdf>(brdf);
            m.method = method;
            EXPECT_LT(std::abs(test::chi_square_sigmas(test::surface_of(m, {0.5f, -0.3f, 1.0f}))),
                      5.0)
                << label(m);
        }
}

TEST(PointSurface, DrawsByItsDensityUnderCoatAndSheen) {
    Material m = test::rough_metal();
    m.metallic = 0.4f;
    m.coat.strength = 0.9f;
    m.coat.roughness = 0.6f;
    m.sheen.color = {0.3f, 0.2f, 0.5f};
    m.sheen.roughness = 0.4f;
    EXPECT_LT(std::abs(test::chi_square_sigmas(test::surface_of(m, {0.5f, -0.3f, 1.0f}))), 5.0);
}

// The weight of a draw is f cos over its density, and f is that of SurfacePoint, which is in double precision.
TEST(PointSurface, ReflectsAsSurfacePointDoes) {
    const glm::vec3 eye = glm::normalize(glm::vec3(0.4f, -0.3f, 1.0f));
    const glm::dvec3 tilt = glm::normalize(glm::dvec3(0.3, 0.2, 1.0));
    for (std::size_t method = 0; method < method_names().size(); ++method) {
        Material m = test::rough_metal();
        m.method = static_cast<Method>(method);
        const PointSurface surface = test::surface_of(m, eye);
        const SurfacePoint exact(m, tilt);
        for (std::uint32_t i = 0; i < 64; ++i) {
            const auto xi = owen_point(i, 3);
            const auto drawn = surface.sample({xi[0], xi[1], xi[2]});
            if (!drawn) continue;
            const glm::dvec3 f = exact.eval_cos(glm::dvec3(drawn->wi), glm::dvec3(eye));
            // 2e-4: single precision through the frames and the lobe.
            EXPECT_NEAR(static_cast<double>(drawn->weight.x * drawn->pdf), f.x, 2e-4 * (f.x + 0.1))
                << label(m);
            EXPECT_NEAR(static_cast<double>(drawn->pdf / surface.pdf(drawn->wi)), 1.0, 1e-3)
                << label(m);
        }
    }
}

TEST(PointSurface, HasTheGrainOfItsGrooves) {
    Material m = test::rough_metal({0.1f, 0.5f});
    m.anisotropy_rotation = 0.0f;
    const PointSurface along_x = test::surface_of(m, {0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 1.0f});
    EXPECT_NEAR(std::abs(along_x.grain().x), 1.0f, 1e-4f);  // rough across the grooves
    m.lobe = AlphaLobe{{0.3f, 0.3f}};
    EXPECT_EQ(test::surface_of(m, {0.0f, 0.0f, 1.0f}).grain(), glm::vec3(0.0f));
}

}  // namespace
}  // namespace burnish
