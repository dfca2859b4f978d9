// Samplers: densities integrate to one, samples follow them (chi-square, corrected for the number of
// tests), and the forward maps invert the methods.
#include <gtest/gtest.h>

#include <random>

#include "lobes_under_test.hpp"

namespace burnish::test {
namespace {

const vec3 kTilted = direction(40 * kPi / 180, 0.9);

// Upper tail of chi-square by Wilson and Hilferty's cube-root normal approximation.
double chi_square_p_value(double statistic, int degrees) {
    const double k = degrees;
    const double z = (std::cbrt(statistic / k) - (1 - 2 / (9 * k))) / std::sqrt(2 / (9 * k));
    return 0.5 * std::erfc(z / std::sqrt(2.0));
}

constexpr int kRings = 24;
constexpr int kSectors = 32;

double ring_edge(int i) { return kPi * std::pow(static_cast<double>(i) / kRings, 1.5); }

std::vector<double> expected_counts(const f64::Lobe& lobe, const f64::Perturbation& p,
                                    const Axes& axes, double total) {
    constexpr int kSub = 12;
    std::vector<double> cells(kRings * kSectors);
    for (int i = 0; i < kRings * kSub; ++i) {
        const int ring = i / kSub;
        const double width = (ring_edge(ring + 1) - ring_edge(ring)) / kSub;
        const double theta = ring_edge(ring) + (i % kSub + 0.5) * width;
        for (int j = 0; j < kSectors * kSub; ++j) {
            const double phi = 2 * kPi * (j + 0.5) / (kSectors * kSub);
            const double area = std::sin(theta) * width * 2 * kPi / (kSectors * kSub);
            cells[static_cast<std::size_t>(ring * kSectors + j / kSub)] +=
                total * area * f64::lobe_pdf(lobe, p, axes.at(theta, phi));
        }
    }
    return cells;
}

double sampler_p_value(const LobeCase& c, int method, double& density_integral) {
    const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
    const f64::Perturbation p = perturbation(c, method, kTilted);
    const Axes axes(p.n);
    constexpr int kSamples = 100000;
    const std::vector<double> expected = expected_counts(lobe, p, axes, kSamples);
    std::vector<double> found(expected.size());
    std::mt19937 generator(static_cast<unsigned>(7 + method * 31 + c.mdf));
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int k = 0; k < kSamples; ++k) {
        const double xi0 = uniform(generator), xi1 = uniform(generator), select = uniform(generator);
        const vec3 h = f64::lobe_sample(lobe, p, {xi0, xi1}, select);
        const double theta = std::acos(std::clamp(f64::dot(h, axes.n), -1.0, 1.0));
        const int ring = std::min(static_cast<int>(std::pow(theta / kPi, 1 / 1.5) * kRings),
                                  kRings - 1);
        const double phi = std::atan2(f64::dot(h, axes.b), f64::dot(h, axes.t));
        const int sector = static_cast<int>((phi < 0 ? phi + 2 * kPi : phi) / (2 * kPi) * kSectors);
        found[static_cast<std::size_t>(ring * kSectors + std::min(sector, kSectors - 1))] += 1;
    }
    double statistic = 0, pooled_expected = 0, pooled_found = 0;
    int degrees = -1;
    density_integral = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        density_integral += expected[i] / kSamples;
        pooled_expected += expected[i];
        pooled_found += found[i];
        if (pooled_expected < 10) { continue; }  // a cell needs a handful for the statistic to hold
        statistic += std::pow(pooled_found - pooled_expected, 2) / pooled_expected;
        pooled_expected = pooled_found = 0;
        ++degrees;
    }
    return chi_square_p_value(statistic, degrees);
}

class Sampler : public testing::TestWithParam<int> {};

TEST_P(Sampler, FollowsItsDensity) {
    const double tests = static_cast<double>(lobe_cases().size()) * kMethods;
    for (const LobeCase& c : lobe_cases()) {
        double integral = 0;
        const double p_value = sampler_p_value(c, GetParam(), integral);
        EXPECT_GT(p_value, 0.01 / tests) << label(c, GetParam());
        EXPECT_NEAR(integral, 1.0, 5e-3) << label(c, GetParam());
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, Sampler, testing::Range(0, kMethods));

// perturb_forward is the inverse of the map that perturb_point evaluates.
TEST(ForwardMap, InvertsThePoint) {
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> uniform(0, 1);
    const LobeCase c{f64::kMdfGgx, 0.3, 0.6};
    for (int method = 0; method < kMethods; ++method) {
        if (method == f64::kMethodNormalMap || method == f64::kMethodRotateApprox) { continue; }
        for (int i = 0; i < 2000; ++i) {
            const vec3 n = direction(1.2 * uniform(generator), 2 * kPi * uniform(generator));
            const f64::Perturbation p = perturbation(c, method, n);
            const vec3 m = direction(1.5 * uniform(generator), 2 * kPi * uniform(generator));
            const f64::LobePoint q = f64::perturb_point(p, f64::perturb_forward(p, m));
            EXPECT_NEAR(q.x, m.x, 1e-9) << label(c, method);
            EXPECT_NEAR(q.y, m.y, 1e-9) << label(c, method);
        }
    }
}

// The deformations' determinants against finite differences of the map on the disk.
TEST(ForwardMap, JacobianMatchesFiniteDifferences) {
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    const LobeCase c{f64::kMdfGgx, 0.3, 0.6};
    for (int method : {f64::kMethodDeformLinear, f64::kMethodDeformSmooth}) {
        for (int i = 0; i < 500; ++i) {
            const vec3 n = direction(1.1 * uniform(generator), 2 * kPi * uniform(generator));
            const vec3 h = direction(1.3 * uniform(generator), 2 * kPi * uniform(generator));
            const f64::Perturbation p = perturbation(c, method, n);
            if (std::hypot(h.x - n.x, h.y - n.y) < 0.02) { continue; }  // kink at C'
            const auto q = [&](double dx, double dy) {
                const double x = h.x + dx, y = h.y + dy;
                return f64::perturb_point(p, {x, y, std::sqrt(1 - x * x - y * y)});
            };
            if (q(0, 0).weight == 0) { continue; }
            const double e = 1e-6;
            const f64::LobePoint px = q(e, 0), mx = q(-e, 0), py = q(0, e), my = q(0, -e);
            const double det = ((px.x - mx.x) * (py.y - my.y) - (px.y - mx.y) * (py.x - my.x)) /
                               (4 * e * e);
            EXPECT_NEAR(f64::deform_jacobian(method, n, h), det, 1e-5 * (1 + std::abs(det)))
                << label(c, method);
        }
    }
}

}  // namespace
}  // namespace burnish::test
