// The C++ face of the shading text: the right function behind every name, in both precisions.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "burnish/brdf_models.hpp"
#include "burnish/mdf.hpp"
#include "core/constants.hpp"
#include "shading/brdf_cases.hpp"

namespace burnish {
namespace {

// Numbers that mean about the same roughness (0.2, 0.5) whatever the distribution.
std::array<double, 2> numbers_of(Mdf mdf) {
    if (mdf == Mdf::ashikhmin_shirley) return {48.0, 6.0};
    return {0.2, 0.5};
}

template <typename Float>
Direction<Float> tilted(double degrees, double azimuth) {
    const double t = degrees * kPi / 180, f = azimuth * kPi / 180;
    return {static_cast<Float>(std::sin(t) * std::cos(f)),
            static_cast<Float>(std::sin(t) * std::sin(f)), static_cast<Float>(std::cos(t))};
}

TEST(MdfValues, FloatFollowsDouble) {
    for (int m = 0; m < static_cast<int>(mdf_names().size()); ++m) {
        for (int k = 0; k < static_cast<int>(method_names().size()); ++k) {
            const auto mdf = static_cast<Mdf>(m);
            const auto method = static_cast<Method>(k);
            const auto [p0, p1] = numbers_of(mdf);
            const auto full =
                mdf_values(mdf, p0, p1, method, tilted<double>(25, 40), tilted<double>(20, 60));
            const auto single = mdf_values(mdf, static_cast<float>(p0), static_cast<float>(p1),
                                           method, tilted<float>(25, 40), tilted<float>(20, 60));
            EXPECT_GT(full.D, 0.0);
            EXPECT_NEAR(single.D, full.D, 1e-5 * full.D) << name_of(mdf) << name_of(method);
            EXPECT_NEAR(single.D_proj, full.D_proj, 1e-5 * full.D_proj);
            EXPECT_NEAR(single.D_conserving, full.D_conserving, 1e-5 * full.D_conserving);
        }
    }
}

// A rotation moves the peak to n~ and keeps its height; `none` leaves it at n.
TEST(MdfValues, EveryMethodPutsThePeakWhereItBelongs) {
    const Direction<double> n = tilted<double>(30, 35), up{0, 0, 1};
    for (int m = 0; m < static_cast<int>(mdf_names().size()); ++m) {
        const auto mdf = static_cast<Mdf>(m);
        const auto [p0, p1] = numbers_of(mdf);
        const double peak = mdf_values(mdf, p0, p1, Method::none, n, up).D;
        for (const Method method :
             {Method::gram_schmidt, Method::rotate_exact, Method::rotate_approx, Method::rotate_arc,
              Method::follow_grain, Method::deform_linear, Method::deform_smooth}) {
            EXPECT_NEAR(mdf_values(mdf, p0, p1, method, n, n).D, peak, 1e-12 * peak)
                << name_of(mdf) << ' ' << name_of(method);
        }
    }
}

TEST(MdfParameters, TellExponentsFromAlphas) {
    EXPECT_EQ(mdf_parameters(Mdf::ashikhmin_shirley)[0].name, "e_x");
    EXPECT_EQ(mdf_parameters(Mdf::ggx)[1].name, "alpha_y");
    EXPECT_GT(mdf_parameters(Mdf::ward)[0].low, 0.0);
}

TEST(BrdfModels, NamesAreUniqueAndParametersFit) {
    for (const BrdfModel& model : brdf_models()) {
        EXPECT_LE(model.parameters.size(), kMostBrdfParameters);
        int same = 0;
        for (const BrdfModel& other : brdf_models()) same += other.name == model.name ? 1 : 0;
        EXPECT_EQ(same, 1) << model.name;
    }
}

TEST(BrdfModels, FloatFollowsDouble) {
    for (const test::BrdfCase& c : test::brdf_cases()) {
        std::array<float, kMostBrdfParameters> q{};
        for (std::size_t i = 0; i < q.size(); ++i) q[i] = static_cast<float>(c.p[i]);
        const double full = c.f(tilted<double>(50, 10), tilted<double>(40, 170));
        const float single = c.model->value_f32(q, tilted<float>(50, 10), tilted<float>(40, 170));
        EXPECT_GT(full, 0.0);
        EXPECT_NEAR(single, full, 1e-5 * full) << test::label(c);
    }
}

TEST(MicrofacetModel, CorrelatedShadowsLess) {
    for (int m = 0; m < static_cast<int>(mdf_names().size()); ++m) {
        const auto mdf = static_cast<Mdf>(m);
        const auto [p0, p1] = numbers_of(mdf);
        const std::array<double, kMostBrdfParameters> p{p0, p1, 1.0};
        const auto wi = tilted<double>(70, 10), wo = tilted<double>(60, 170);
        EXPECT_GT(microfacet_model(mdf, Smith::correlated).value_f64(p, wi, wo),
                  microfacet_model(mdf, Smith::separable).value_f64(p, wi, wo))
            << name_of(mdf);
    }
}

template <typename Float>
class MakeUnit : public testing::Test {};
using Floats = testing::Types<float, double>;
TYPED_TEST_SUITE(MakeUnit, Floats);

TYPED_TEST(MakeUnit, WorksAtAnyLength) {
    using Limits = std::numeric_limits<TypeParam>;
    for (const TypeParam scale :
         {TypeParam(1), Limits::max() / 8, Limits::min(), 16 * Limits::denorm_min()}) {
        Direction<TypeParam> v{2 * scale, -3 * scale, 6 * scale};
        ASSERT_TRUE(make_unit(v));
        const TypeParam tolerance = 4 * Limits::epsilon();
        EXPECT_NEAR(v.x, TypeParam(2) / 7, tolerance);
        EXPECT_NEAR(v.y, TypeParam(-3) / 7, tolerance);
        EXPECT_NEAR(v.z, TypeParam(6) / 7, tolerance);
    }
}

TYPED_TEST(MakeUnit, RefusesZero) {
    Direction<TypeParam> v{0, 0, -TypeParam(0)};
    EXPECT_FALSE(make_unit(v));
}

}  // namespace
}  // namespace burnish
