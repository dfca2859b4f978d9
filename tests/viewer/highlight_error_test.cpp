// The highlight error: where it is known in closed form.
#include "viewer/inspect/highlight_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "viewer/viewer_scenes.hpp"

namespace burnish::viewer {
namespace {

constexpr double kTilt = 30.0;  // degrees
const glm::dvec3 kTiltedAlongX(0.5, 0.0, std::sqrt(0.75));
const glm::dvec3 kFromAbove(0.0, 0.0, 1.0);

Material brushed(Mdf mdf, Method method) {
    Material m;
    m.lobe = AlphaLobe{{0.1f, 0.5f}};
    m.mdf = mdf;
    m.method = method;
    return m;
}

double error_of(Mdf mdf, Method method) {
    const Scene scene = test::tilted_plane(brushed(mdf, method), kTiltedAlongX);
    return highlight_error_deg(scene, test::hit_at(scene, 0.1, 0.1), kFromAbove).value();
}

TEST(HighlightError, RotationsAndDeformationsHaveNone) {
    for (const Method method :
         {Method::gram_schmidt, Method::rotate_exact, Method::rotate_approx, Method::rotate_arc,
          Method::follow_grain, Method::deform_linear, Method::deform_smooth})
        for (const Mdf mdf : {Mdf::ashikhmin_shirley, Mdf::ward, Mdf::beckmann, Mdf::ggx})
            EXPECT_LT(error_of(mdf, method), 1e-5) << name_of(method);
}

TEST(HighlightError, OfNoMethodIsTheTilt) {
    // The normal is in single precision.
    EXPECT_NEAR(error_of(Mdf::ggx, Method::none), kTilt, 1e-5);
}

// Under normal-map GGX is highest where h^T (diag(1/ax^2, 1/ay^2, 0) + n n^T) h is least. In the plane
// of the tilt that is the eigenvector at angle psi with tan(2 psi) = 2 nx nz/(1/ax^2 + nx^2 - nz^2), away
// from n~.
TEST(HighlightError, OfNormalMapIsThatOfItsEigenvector) {
    const double psi = 0.5 * std::atan2(2 * kTiltedAlongX.x * kTiltedAlongX.z,
                                        100 + kTiltedAlongX.x * kTiltedAlongX.x -
                                            kTiltedAlongX.z * kTiltedAlongX.z);
    const double wanted = kTilt + psi * 180 / 3.14159265358979;
    // alpha is 0.1f.
    EXPECT_NEAR(error_of(Mdf::ggx, Method::normal_map), wanted, 1e-4);
    // Ward's exponent is 0 at the geometric normal, and Ashikhmin-Shirley's base 1 at n~.
    EXPECT_NEAR(error_of(Mdf::ward, Method::normal_map), kTilt, 1e-4);
    EXPECT_LT(error_of(Mdf::ashikhmin_shirley, Method::normal_map), 1e-4);
}

// Where nothing is anisotropic, engines evaluate the isotropic lobe about n~.
TEST(HighlightError, OfIsotropicNormalMapIsNone) {
    Material m = brushed(Mdf::ggx, Method::normal_map);
    m.lobe = AlphaLobe{{0.2f, 0.2f}};
    const Scene scene = test::tilted_plane(m, kTiltedAlongX);
    EXPECT_LT(highlight_error_deg(scene, test::hit_at(scene, 0, 0), kFromAbove).value(), 1e-5);
}

TEST(HighlightError, OfAPictureIsThatOfItsPlaces) {
    Scene scene = test::tilted_plane(brushed(Mdf::ggx, Method::none), kTiltedAlongX);
    Camera camera;
    camera.position = {0.0f, 0.0f, 4.0f};
    camera.yfov = 1.2f;  // shows 2.7 to either side
    const WindowSize window = {320, 160};
    const Picker picker(scene);
    const HighlightErrors errors = highlight_errors(scene, picker, camera, window, 32);
    EXPECT_EQ(errors.degrees.width, 32);
    EXPECT_EQ(errors.degrees.height, 16);
    int known = 0;
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 32; ++x) {
            const glm::dvec2 pixel(10 * x + 5, 10 * y + 5);
            const auto hit = pick(scene, picker, camera, pixel, window);
            const float error = *errors.degrees.at(x, y);
            ASSERT_EQ(hit.has_value(), !std::isnan(error));
            if (!hit) continue;
            ++known;
            // n~ faces every eye of this view.
            EXPECT_NEAR(static_cast<double>(error), kTilt, 1e-4);
        }
    }
    EXPECT_GT(known, 20);
    EXPECT_NEAR(errors.mean, kTilt, 1e-4);
    EXPECT_NEAR(errors.most, kTilt, 1e-4);
    EXPECT_LT(highlight_errors(scene, picker, camera, window, 32, Method::rotate_arc).most, 1e-5);
    EXPECT_EQ(highlight_errors(Scene{}, Picker{}, camera, window, 8).most, 0);
}

}  // namespace
}  // namespace burnish::viewer
