// Lobes widened by a variance of slopes, against the convolution of their slopes by quadrature.
#include <gtest/gtest.h>

#include "core/parallel.hpp"
#include "lobes_under_test.hpp"

namespace burnish::test {
namespace {

const f64::Perturbation kFlat = f64::perturb_make(f64::kMethodNone, {0, 0, 1}, true, false);

// Density of the slopes (x, y) of a lobe: D (n.h)^4, since dw = (n.h)^3 dx dy and D (n.h) dw = 1.
double slope_density(const f64::Lobe& lobe, double x, double y) {
    const double z = 1 / std::sqrt(1 + x * x + y * y);
    return f64::lobe_D(lobe, kFlat, {-x * z, -y * z, z}) * z * z * z * z;
}

struct Case {
    int mdf;
    double alpha_x, alpha_y;
    double sigma_x, sigma_y;  // of the detail's slopes
};

// Midpoints for 10 sigma: at least 60, and 2.5 for every alpha, where those of a Gaussian are good
// to 1e-10.
int steps_for(double sigma, double alpha) {
    return std::max(60, static_cast<int>(std::ceil(25 * sigma / alpha)));
}

// Gaussian detail to 5 sigma: Int Int density(s - t) gauss(t) dt.
double convolved(const f64::Lobe& lobe, const Case& c, double x, double y) {
    const int nx = steps_for(c.sigma_x, c.alpha_x), ny = steps_for(c.sigma_y, c.alpha_y);
    double sum = 0, weights = 0;
    for (int i = 0; i < nx; ++i) {
        for (int j = 0; j < ny; ++j) {
            const double u = 10 * (i + 0.5) / nx - 5, v = 10 * (j + 0.5) / ny - 5;
            const double w = std::exp(-0.5 * (u * u + v * v));
            sum += w * slope_density(lobe, x - u * c.sigma_x, y - v * c.sigma_y);
            weights += w;
        }
    }
    return sum / weights;
}

struct Error {
    double peak;   // widened over convolved, at no slope
    double l1;     // half of Int |widened - convolved|: the share of energy in the wrong place
    double worst;  // largest difference over the convolved peak
};

// Over slopes to 8 widths, where a GGX has 1.5 % of its energy left.
Error error_of(const Case& c) {
    const f64::Lobe lobe = f64::lobe_from_alpha(c.mdf, c.alpha_x, c.alpha_y);
    const f64::Lobe wide = f64::widen_lobe(lobe, c.sigma_x * c.sigma_x, c.sigma_y * c.sigma_y);
    const double width_x = f64::lobe_alpha_x(wide), width_y = f64::lobe_alpha_y(wide);
    const double peak = convolved(lobe, c, 0, 0);
    Error e{slope_density(wide, 0, 0) / peak, 0, 0};
    // Symmetric in both axes: a quadrant. Points crowd at the middle: s = 8 u^2 widths.
    constexpr int kPoints = 30;
    std::vector<Error> rows(kPoints, Error{});
    parallel_for(kPoints, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            for (int j = 0; j < kPoints; ++j) {
                const double u = (static_cast<double>(i) + 0.5) / kPoints, v = (j + 0.5) / kPoints;
                const double x = 8 * u * u * width_x, y = 8 * v * v * width_y;
                const double area = 256 * u * v * width_x * width_y / (kPoints * kPoints);
                const double d = std::abs(slope_density(wide, x, y) - convolved(lobe, c, x, y));
                rows[i].l1 += 4 * 0.5 * d * area;
                rows[i].worst = std::max(rows[i].worst, d / peak);
            }
        }
    });
    for (const Error& row : rows) {
        e.l1 += row.l1;
        e.worst = std::max(e.worst, row.worst);
    }
    return e;
}

const std::vector<Case>& cases(int mdf) {
    static std::vector<Case> all[4];
    std::vector<Case>& list = all[mdf];
    if (!list.empty()) return list;
    for (double ratio : {0.25, 1.0, 4.0}) {
        list.push_back({mdf, 0.1, 0.1, 0.1 * ratio, 0.1 * ratio});
        list.push_back({mdf, 0.05, 0.2, 0.1 * ratio, 0.1 * ratio});
        list.push_back({mdf, 0.1, 0.4, 0.1 * ratio, 0.02 * ratio});
    }
    return list;
}

std::string label(const Case& c) {
    return std::string(mdf_names()[static_cast<std::size_t>(c.mdf)]) + " alpha " +
           std::to_string(c.alpha_x) + "," + std::to_string(c.alpha_y) + " sigma " +
           std::to_string(c.sigma_x) + "," + std::to_string(c.sigma_y);
}

// Bounds: what docs/theory/normal-filtering.md says, which `BURNISH_PRINT_WIDEN=1` prints.
void expect_within(int mdf, double peak_low, double peak_high, double l1) {
    for (const Case& c : cases(mdf)) {
        const Error e = error_of(c);
        if (std::getenv("BURNISH_PRINT_WIDEN") != nullptr) {
            std::printf("%-70s peak %.3f l1 %.4f worst %.4f\n", label(c).c_str(), e.peak, e.l1,
                        e.worst);
        }
        EXPECT_GT(e.peak, peak_low) << label(c);
        EXPECT_LT(e.peak, peak_high) << label(c);
        EXPECT_LT(e.l1, l1) << label(c);
    }
}

// 1e-6: the quadrature of a Gaussian cut at 5 sigma.
TEST(Widen, BeckmannIsTheConvolution) {
    expect_within(f64::kMdfBeckmann, 1 - 3e-6, 1 + 3e-6, 3e-6);
}

// Slopes of 0.4 reach where Ward's 1 - z and half the squared slope part: to 0.1 the peak is within
// 3 % and 1.5 % of the energy are in the wrong place.
TEST(Widen, WardIsNearTheConvolution) {
    expect_within(f64::kMdfWard, 0.99, 1.22, 0.1);
}

// The tail of GGX widens with the lobe; that of the convolution stays as it was.
TEST(Widen, GgxIsNearTheConvolution) {
    expect_within(f64::kMdfGgx, 0.98, 1.12, 0.19);
}

TEST(Widen, AshikhminShirleyIsNearTheConvolution) {
    expect_within(f64::kMdfAshikhminShirley, 0.99, 1.01, 0.09);
}

// The closed form beside widen_ggx, E2 by its own quadrature.
TEST(Widen, PeakOfGgxIsWithinFivePercentOfTheClosedForm) {
    for (double t = 1e-4; t < 1e4; t *= 2) {
        // e^t E2(t) = Int_0^1 exp(-t (1/u - 1)) du.
        double inverse_g = 0;
        constexpr int kSteps = 200000;
        for (int i = 0; i < kSteps; ++i) {
            inverse_g += std::exp(-t * (kSteps / (i + 0.5) - 1)) / kSteps;
        }
        const double variance = 0.01;
        const double alpha = std::sqrt(2 * variance * t);
        const double wide = f64::widen_ggx(alpha, variance);
        EXPECT_NEAR(wide * wide * inverse_g / (2 * variance), 1, 0.05) << t;
    }
}

TEST(Widen, NothingIsWidenedByNothing) {
    for (const LobeCase& c : lobe_cases()) {
        const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
        const f64::Lobe same = f64::widen_lobe(lobe, 0, 0);
        EXPECT_NEAR(same.p0, c.p0, 1e-14 * c.p0);
        EXPECT_NEAR(same.p1, c.p1, 1e-14 * c.p1);
        EXPECT_NEAR(same.projected_norm, lobe.projected_norm, 1e-12 * lobe.projected_norm);
    }
}

// Each axis by itself, in the sense of the axes, and never narrower.
TEST(Widen, AxesAreApart) {
    for (const LobeCase& c : lobe_cases()) {
        const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
        const f64::Lobe x = f64::widen_lobe(lobe, 0.04, 0), y = f64::widen_lobe(lobe, 0, 0.04);
        EXPECT_GT(f64::lobe_alpha_x(x), f64::lobe_alpha_x(lobe) + 0.01);
        EXPECT_NEAR(f64::lobe_alpha_y(x), f64::lobe_alpha_y(lobe), 1e-14);
        EXPECT_GT(f64::lobe_alpha_y(y), f64::lobe_alpha_y(lobe) + 0.01);
        EXPECT_NEAR(f64::lobe_alpha_x(y), f64::lobe_alpha_x(lobe), 1e-14);
    }
}

TEST(Widen, WidenedLobesStayNormalized) {
    for (const LobeCase& c : lobe_cases()) {
        const f64::Lobe wide = f64::widen_lobe(f64::lobe_make(c.mdf, c.p0, c.p1), 0.03, 0.1);
        const double energy =
            integrate_cap([&](vec3 h) { return f64::lobe_D(wide, kFlat, h) * h.z; }, {0, 0, 1},
                          kPi / 2, 500, 720);
        EXPECT_NEAR(energy, 1.0, 5e-5) << label(c, f64::kMethodNone);
    }
}

}  // namespace
}  // namespace burnish::test
