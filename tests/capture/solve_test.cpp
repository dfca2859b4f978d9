// Recovers points and tables from pictures rendered by an independent forward model.
#include <gtest/gtest.h>

#include <limits>

#include "burnish/virtual_ndf.hpp"
#include "capture/solve/exemplar_solve.hpp"
#include "capture/solve/partial_ndf.hpp"
#include "capture/solve/point_fit.hpp"
#include "solve_support.hpp"

namespace burnish {
namespace {

using test::Double3;
using test::Random;

const NdfGrid kGrid{32, 96};
const Double3 kEye = {0, -std::sqrt(0.5), std::sqrt(0.5)};  // 45 degrees

// A table and the data to render its pictures. The area is read with the library's lookup (its
// error has its own tests), with directions rotated back.
struct Truth {
    std::vector<float> table, areas;
    explicit Truth(const test::DirectionalLobe& lobe)
        : table(test::normalized(kGrid, test::sampled(kGrid, lobe))),
          areas(ndf_areas(kGrid, table.data())) {}

    ExemplarTables tables() const { return {kGrid, table.data(), areas.data()}; }
    test::Surface surface(double columns, const Double3& diffuse, const Double3& specular,
                          double eta) const {
        test::Surface out{diffuse, specular, eta, {}, {}};
        out.D = [this, columns](const Double3& h) {
            return test::read_table(kGrid, table, h, columns);
        };
        const double angle = 2 * kPi * columns / kGrid.azimuths;
        out.area = [this, angle](const Double3& k) {
            const double c = std::cos(angle), s = std::sin(angle);
            return static_cast<double>(ndf_area_lookup(
                areas.data(), static_cast<float>(c * k[0] + s * k[1]),
                static_cast<float>(-s * k[0] + c * k[1]), static_cast<float>(k[2])));
        };
        return out;
    }
};

Truth leaning() {
    return Truth(test::beckmann(0.2, 0.45, 0.1, 0.15));
}

double turn_between(double a, double b) {
    const double d = std::fmod(std::fmod(a - b, 96) + 96, 96);
    return std::min(d, 96 - d);
}

// ---- places and samples ----

TEST(LightPlaces, AreReadAsTheTablesThemselves) {
    Random random(1);
    std::vector<float> table;
    for (int i = 0; i < kGrid.cells(); ++i) table.push_back(static_cast<float>(random.uniform()));
    for (int i = 0; i < 2000; ++i) {
        const double z = random.uniform(0.001, 0.999), phi = random.uniform(-7, 7);
        const double s = std::sqrt(1 - z * z), columns = random.uniform(-200, 200);
        const Double3 h = {s * std::cos(phi), s * std::sin(phi), z};
        const GridPlace place = grid_place(kGrid, static_cast<float>(h[0]),
                                           static_cast<float>(h[1]), static_cast<float>(h[2]));
        // 1e-3: columns of up to 300 in single precision; steps of the table are up to 1.
        EXPECT_NEAR(
            static_cast<double>(lookup(kGrid, table.data(), place, static_cast<float>(columns))),
            test::read_table(kGrid, table, h, columns), 1e-3)
            << z << " " << phi << " " << columns;
    }
}

TEST(LightPlaces, AreasAreReadAsTheTablesThemselves) {
    const Truth truth = leaning();
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const double z = random.uniform(0, 1), phi = random.uniform(0, 7), s = std::sqrt(1 - z * z);
        const auto x = static_cast<float>(s * std::cos(phi));
        const auto y = static_cast<float>(s * std::sin(phi)), zf = static_cast<float>(z);
        EXPECT_NEAR(area_at(truth.areas.data(), area_place(x, y, zf), zf, 0),
                    ndf_area_lookup(truth.areas.data(), x, y, zf), 1e-5f);
    }
}

TEST(LightPlaces, FresnelIsExact) {
    for (const double eta : {0.0, 1.3, 1.5, 2.4})
        for (double c = 0.02; c <= 1; c += 0.02)
            EXPECT_NEAR(static_cast<double>(
                            RelativeFresnel(static_cast<float>(eta))(static_cast<float>(c))),
                        test::fresnel_ratio(eta, c), 2e-4 * test::fresnel_ratio(eta, c))
                << eta << " " << c;
}

TEST(PointSamples, LeaveOutWhatIsLowClippedOrNotKept) {
    test::Surface surface{{0.3, 0.2, 0.1}, {0, 0, 0}, 0, {}, {}};
    surface.D = [](const Double3&) { return 0.0; };
    surface.area = [](const Double3&) { return 1.0; };
    const std::vector<Double3> lights = {
        {0.6, 0, 0.8}, {0.8, 0, 0.6}, {std::sqrt(1 - 0.0081), 0, 0.09},
        {0, 0.6, 0.8}, {0, 0.8, 0.6}, {0, 0, 1}};
    test::Shot shot = test::shot_of(surface, lights, kEye, 2);
    shot.values[3 * 3 + 1] = std::numeric_limits<float>::infinity();
    const std::vector<std::uint8_t> keep = {1, 1, 1, 1, 0, 1};
    PointSamples samples;
    gather_samples(shot.lights, {0, 0, 1}, shot.values, keep, kGrid, samples);
    EXPECT_EQ(samples.light, (std::vector<int>{0, 1, 5}));
    for (std::size_t q = 0; q < samples.size(); ++q) {
        const Double3& i = lights[static_cast<std::size_t>(samples.light[q])];
        EXPECT_NEAR(samples.received[q], 2 * i[2], 1e-5);
        EXPECT_NEAR(samples.value[q], 2 * i[2] * test::luminance(surface.diffuse) / kPi, 1e-5);
        EXPECT_NEAR(samples.value_rgb[0][q], 2 * i[2] * 0.3 / kPi, 1e-5);
        EXPECT_NEAR(samples.weight_rgb[2][q], 2 * i[2], 1e-5);
    }
    gather_samples(shot.lights, {0, 0, 1}, shot.values, {}, kGrid, samples);
    EXPECT_EQ(samples.light, (std::vector<int>{0, 1, 4, 5}));
}

// Near lights: 1/r^2 and the LED's cos^m, at pixel centers.
TEST(LightGeometryOf, NearLightsFallOffInClosedForm) {
    Rig rig;
    rig.width_mm = 80;
    rig.height_mm = 40;
    rig.camera = {true, {0, -200, 300}};
    RigLight light;
    light.place = {true, {30, -20, 50}};
    light.intensity = {100, 200, 400};
    light.emission_exponent = 1.7;
    rig.lights = {light};
    LightGeometry geometry(rig, 8, 4);
    EXPECT_EQ(geometry.lights(), 1u);
    EXPECT_FALSE(geometry.all_far());
    PointLights found;
    for (int pixel = 0; pixel < 32; ++pixel) {
        geometry.at(static_cast<std::size_t>(pixel), found);
        const double x = (pixel % 8 + 0.5) * 10 - 40, y = 20 - (pixel / 8 + 0.5) * 10;
        const double dx = 30 - x, dy = -20 - y, r = std::sqrt(dx * dx + dy * dy + 2500);
        ASSERT_EQ(found.size(), 1u);
        EXPECT_NEAR(found.x[0], dx / r, 1e-6);
        EXPECT_NEAR(found.y[0], dy / r, 1e-6);
        EXPECT_NEAR(found.z[0], 50 / r, 1e-6);
        for (std::size_t c = 0; c < 3; ++c) {
            const double expected = light.intensity[c] * std::pow(50 / r, 1.7) / (r * r);
            EXPECT_NEAR(found.received[c][0], expected, 1e-5 * expected);
        }
        const double e = std::sqrt(x * x + (y + 200) * (y + 200) + 90000);
        EXPECT_NEAR(found.to_eye[0], -x / e, 1e-6);
        EXPECT_NEAR(found.to_eye[1], (-200 - y) / e, 1e-6);
    }
    rig.lights[0].place = {false, {0.6, 0, 0.8}};
    rig.camera = {false, {0, 0, 1}};
    EXPECT_TRUE(LightGeometry(rig, 8, 4).all_far());
}

// ---- points ----

// The rotation is accurate to 0.05 columns (the search stops at 0.02), strengths correspondingly.
TEST(PointFitterOf, NoiseFreeSamplesGiveTheTruth) {
    const Truth truth = leaning();
    Random random(3);
    for (const double eta : {0.0, 1.5}) {
        for (int i = 0; i < 12; ++i) {
            const double columns = random.uniform(0, 96);
            const Double3 d = {random.uniform(0, 0.4), random.uniform(0, 0.4), 0.1};
            const Double3 s = {random.uniform(0.02, 0.2), random.uniform(0.02, 0.2), 0.05};
            const PointSamples samples = test::samples_of(
                test::shot_of(truth.surface(columns, d, s, eta), test::cap_of(160, 75), kEye, 3),
                kGrid);
            const PointFitter fitter(samples, static_cast<float>(eta));
            const double start = columns + random.uniform(-1.5, 1.5) + (i % 2) * 48;
            const PointFit fit = fitter.refined(truth.tables(), static_cast<float>(start), 2.5f);
            EXPECT_LT(turn_between(static_cast<double>(fit.shift), columns), 0.05) << i;
            EXPECT_NEAR(static_cast<double>(fit.diffuse), test::luminance(d), 2e-3) << i;
            EXPECT_NEAR(static_cast<double>(fit.specular), test::luminance(s),
                        0.01 * test::luminance(s))
                << i;
            EXPECT_LT(fit.error, 1e-3f) << i;

            const PointFit exact = fitter.at(truth.tables(), static_cast<float>(columns));
            EXPECT_NEAR(static_cast<double>(exact.diffuse), test::luminance(d), 2e-4) << i;
            EXPECT_NEAR(static_cast<double>(exact.specular), test::luminance(s),
                        1e-3 * test::luminance(s))
                << i;
            EXPECT_LT(exact.error, 1e-6f) << i;
            EXPECT_GT(fitter.at(truth.tables(), static_cast<float>(columns + 12)).error, 1e-3f);

            std::array<float, 3> diffuse{}, specular{};
            fitter.colors(truth.tables(), static_cast<float>(columns), diffuse, specular);
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(static_cast<double>(diffuse[c]), d[c], 3e-4) << i;
                EXPECT_NEAR(static_cast<double>(specular[c]), s[c], 2e-3 * s[c]) << i;
            }
        }
    }
}

TEST(PointFitterOf, StrengthsAreNeverNegative) {
    const Truth truth = leaning();
    const auto lights = test::cap_of(120, 70);
    const Double3 none = {0, 0, 0}, some = {0.3, 0.3, 0.3};
    const PointSamples matt =
        test::samples_of(test::shot_of(truth.surface(0, some, none, 0), lights, kEye), kGrid);
    const PointFit diffuse = PointFitter(matt, 0).at(truth.tables(), 5);
    EXPECT_NEAR(diffuse.diffuse, 0.3f, 1e-3f);
    EXPECT_NEAR(diffuse.specular, 0.0f, 1e-3f);
    const PointSamples gloss =
        test::samples_of(test::shot_of(truth.surface(0, none, some, 0), lights, kEye), kGrid);
    const PointFit specular = PointFitter(gloss, 0).at(truth.tables(), 0);
    EXPECT_NEAR(specular.diffuse, 0.0f, 1e-3f);
    EXPECT_NEAR(specular.specular, 0.3f, 1e-3f);
    // Dark where the lobe is bright: the best unconstrained specular strength is negative.
    test::Shot inverse = test::shot_of(truth.surface(0, none, some, 0), lights, kEye);
    for (std::size_t i = 0; i < inverse.values.size(); ++i)
        inverse.values[i] = inverse.lights.z[i / 3] * 0.3f / (1.0f + 5.0f * inverse.values[i]);
    const PointSamples dark = test::samples_of(inverse, kGrid);
    for (float shift = 0; shift < 96; shift += 7) {
        const PointFit fit = PointFitter(dark, 0).at(truth.tables(), shift);
        EXPECT_GE(fit.specular, 0.0f);
        EXPECT_GE(fit.diffuse, 0.0f);
    }
}

// ---- tables ----

// Partial sums over points by several jobs, merged: the same equations within rounding.
TEST(TableEquationsOf, PartsMergeIntoTheWhole) {
    const Truth truth = leaning();
    TableEquations whole(kGrid), parts[] = {TableEquations(kGrid), TableEquations(kGrid)};
    Random random(8);
    for (int p = 0; p < 60; ++p) {
        const double columns = random.uniform(0, 96);
        const PointSamples samples = test::samples_of(
            test::shot_of(truth.surface(columns, {0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, 1.5),
                          test::cap_of(100, 75, random.uniform(0, 7)), kEye),
            kGrid);
        const PointFit fit{static_cast<float>(columns), 0.1f, 0.2f, 0.0f};
        for (TableEquations* equations : {&whole, &parts[p % 3 == 0]})
            equations->add(samples, PointFitter(samples, 1.5f), truth.tables(), fit);
    }
    parts[0].merge(parts[1]);
    std::vector<float> a(truth.table.size(), 0.3f), b = a, a_weights(a.size()), b_weights(a.size());
    whole.solve(a.data(), a_weights.data());
    parts[0].solve(b.data(), b_weights.data());
    EXPECT_EQ(a_weights, b_weights);
    // The conjugate gradients end at 1e-4 of the right side; the rounding of the sums is far
    // smaller.
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-3f * (a[i] + 0.01f)) << i;
    const std::vector<float> a_mimic = whole.diffuse_mimic(), b_mimic = parts[0].diffuse_mimic();
    for (std::size_t i = 0; i < a_mimic.size(); ++i)
        EXPECT_NEAR(a_mimic[i], b_mimic[i], 1e-3f) << i;
}

// 500 points at known random rotations: least squares recovers the table that made their pictures,
// in every cell near some h; no other cell is marked as determined.
TEST(TableEquationsOf, GiveBackTheTableThatMadeTheSamples) {
    for (const bool peaked : {false, true}) {
        const Truth truth(peaked ? test::ggx(0.12, 0.35, 0.05, 0)
                                 : test::beckmann(0.2, 0.45, 0.1, 0.15));
        TableEquations equations(kGrid);
        Random random(4);
        for (int p = 0; p < 500; ++p) {
            const double columns = random.uniform(0, 96);
            const Double3 d = {0.1, 0.1, 0.1}, s = {0.2, 0.2, 0.2};
            const PointSamples samples =
                test::samples_of(test::shot_of(truth.surface(columns, d, s, 1.5),
                                               test::cap_of(100, 75, random.uniform(0, 7)), kEye),
                                 kGrid);
            equations.add(samples, PointFitter(samples, 1.5f), truth.tables(),
                          {static_cast<float>(columns), 0.1f, 0.2f, 0.0f});
        }
        std::vector<float> table(truth.table.size(), 0.3f), weights(table.size(), -1.0f);
        equations.solve(table.data(), weights.data());
        double difference = 0, mass = 0;
        for (int r = 0; r < kGrid.rings; ++r) {
            const double degrees = test::theta_at(kGrid, r + 0.5) * 180 / kPi;
            for (int a = 0; a < kGrid.azimuths; ++a) {
                const std::size_t i = test::cell(kGrid, r, a);
                EXPECT_GE(table[i], 0.0f);
                EXPECT_TRUE(weights[i] == 0.0f || weights[i] == 1.0f) << weights[i];
                // The largest lean of an h is (75 + 45) / 2 degrees, plus a cell.
                if (degrees > 64) {
                    EXPECT_EQ(weights[i], 0.0f) << degrees;
                }
                if (degrees < 55) {
                    EXPECT_EQ(weights[i], 1.0f) << degrees;
                }
                if (weights[i] == 0) continue;
                const double w = test::cosine_weight(kGrid, r);
                mass += w * static_cast<double>(truth.table[i]);
                difference += w * std::abs(static_cast<double>(table[i] - truth.table[i]));
            }
        }
        // Only the weak smoothness causes a difference.
        EXPECT_LT(difference, 0.003 * mass) << (peaked ? "ggx" : "beckmann");
    }
}

// ---- the part that one point shows ----

struct PartialCase {
    double alpha_x, alpha_y, eta, allowed;
};

struct PartialFound {
    PartialNdf point;
    double difference = 0;  // cosine-weighted L1 over the known part, both normalized over it
    double reached = 0;     // share of the truth's mass in the known part
    double table_mass = 0, share = 0;  // share: of the hemisphere's solid angle
};

PartialFound solve_partially(const PartialCase& c) {
    const VirtualNdf ndf{"one", {{1.0, Mdf::beckmann, c.alpha_x, c.alpha_y, 0.5, 0.0, 0.0}}};
    test::Surface surface{{0.2, 0.2, 0.2}, {0.1, 0.1, 0.1}, c.eta, {}, {}};
    surface.D = [&](const Double3& h) { return ndf.D(h); };
    surface.area = [&](const Double3& k) { return ndf.area(k); };
    const int lights = 500;
    const PointSamples samples =
        test::samples_of(test::shot_of(surface, test::cap_of(lights, 75), kEye), kGrid);
    // Lights are sqrt(solid angle / count) apart, half vectors half as far.
    const double apart = 0.5 * std::sqrt(2 * kPi * (1 - std::cos(75 * kPi / 180)) / lights);
    const PartialNdfSolver solver(kGrid, static_cast<float>(apart), static_cast<float>(c.eta));
    std::vector<float> table(static_cast<std::size_t>(kGrid.cells())), weights(table.size());
    PartialFound out;
    PartialNdfWork work;
    out.point = solver.solve(samples, work, table.data(), weights.data());
    const std::vector<float> truth = test::sampled(kGrid, [&](double x, double y, double z) {
        return ndf.D({x, y, z});
    });
    for (const bool comparing : {false, true}) {
        for (int i = 0; i < kGrid.cells(); ++i) {
            const auto k = static_cast<std::size_t>(i);
            EXPECT_GE(weights[k], 0.0f);
            EXPECT_LE(weights[k], 1.0f);
            if (weights[k] == 0) continue;
            const int r = i / kGrid.azimuths;
            const double w = test::cosine_weight(kGrid, r);
            const auto D = static_cast<double>(truth[k]), found = static_cast<double>(table[k]);
            if (comparing) {
                out.difference += w * std::abs(found - D / out.reached);
            } else {
                out.reached += w * D;
                out.table_mass += w * found;
                out.share += w / std::cos(test::theta_at(kGrid, r + 0.5)) / (2 * kPi);
            }
        }
    }
    return out;
}

// Half vectors are 3 degrees apart and blurred by as much: a lobe of alpha 0.25 keeps its shape,
// one of 0.12 less so.
TEST(PartialNdfOf, OnePointShowsItsPart) {
    for (const PartialCase& c :
         {PartialCase{0.25, 0.4, 1.5, 0.1}, PartialCase{0.12, 0.4, 1.5, 0.35},
          PartialCase{0.25, 0.4, 0.0, 0.1}}) {
        const PartialFound found = solve_partially(c);
        EXPECT_LT(found.difference, c.allowed) << c.alpha_x;
        EXPECT_NEAR(found.table_mass, 1, 0.03);  // normalized; 3 %: partly known cells
        // One view covers a quarter to a half of the hemisphere, and most of the lobe's mass.
        EXPECT_GT(found.share, 0.15);
        EXPECT_LT(found.share, 0.5);
        EXPECT_GT(found.reached, 0.6);
        const double specular = static_cast<double>(found.point.specular) / (0.1 * found.reached);
        EXPECT_GT(specular, 0.7) << c.alpha_x;
        EXPECT_LT(specular, 1.05) << c.alpha_x;
        EXPECT_NEAR(found.point.diffuse, 0.2f, 0.01f) << c.alpha_x;
        EXPECT_GE(found.point.rounds, 1);
        EXPECT_LE(found.point.rounds, 10);
    }
}

TEST(PartialNdfOf, LowPercentilesAreThoseOfSortedRatios) {
    PointSamples samples;
    EXPECT_EQ(low_percentile(samples, 0.02f), 0.0f);
    for (int i = 0; i < 200; ++i) {
        const int k = (i * 77) % 200;  // 0 ... 199, shuffled
        samples.light.push_back(i);
        samples.received.push_back(0.5f + static_cast<float>(i % 3));
        samples.value.push_back(static_cast<float>(k) * samples.received.back());
    }
    EXPECT_NEAR(low_percentile(samples, 0.0f), 0, 1e-5f);
    EXPECT_NEAR(low_percentile(samples, 0.02f), 4, 1.01f);
    EXPECT_NEAR(low_percentile(samples, 0.5f), 100, 1.01f);
}

}  // namespace
}  // namespace burnish
