// Completion of unknown cells from similar tables and from the decay of tails; clustering of
// rotated points.
#include <gtest/gtest.h>

#include <algorithm>

#include "capture/solve/exemplar_solve.hpp"
#include "solve_support.hpp"

namespace burnish {
namespace {

using test::Random;

const NdfGrid kGrid{32, 96};

Exemplars exemplars_of(const std::vector<std::vector<float>>& tables) {
    Exemplars out;
    out.grid = kGrid;
    out.count = static_cast<int>(tables.size());
    for (const auto& table : tables) out.D.insert(out.D.end(), table.begin(), table.end());
    out.weights.assign(out.D.size(), 1.0f);
    out.areas.assign(tables.size() * static_cast<std::size_t>(kAreaGrid.cells()), 0.0f);
    out.origin.assign(out.D.size(), NdfOrigin::measured);
    return out;
}

int first_ring_beyond(double degrees) {
    int r = 0;
    while (test::theta_at(kGrid, r) * 180 / kPi < degrees) ++r;
    return r;
}

void forget(Exemplars& exemplars, int e, int ring, int column) {
    const std::size_t i = test::cell(kGrid, ring, column);
    exemplars.table(e)[i] = 0;
    exemplars.weight(e)[i] = 0;
}

double difference(const float* a, const std::vector<float>& b) {
    double sum = 0;
    for (int r = 0; r < kGrid.rings; ++r)
        for (int k = 0; k < kGrid.azimuths; ++k) {
            const std::size_t i = test::cell(kGrid, r, k);
            sum += test::cosine_weight(kGrid, r) * std::abs(static_cast<double>(a[i] - b[i]));
        }
    return sum;
}

void expect_whole(const Exemplars& exemplars) {
    for (int e = 0; e < exemplars.count; ++e) {
        EXPECT_NEAR(ndf_mass(kGrid, exemplars.table(e)), 1, 1e-4);
        const std::vector<float> areas = ndf_areas(kGrid, exemplars.table(e));
        for (std::size_t i = 0; i < areas.size(); ++i)
            EXPECT_NEAR(exemplars.area(e)[i], areas[i], 1e-5f);
        for (int i = 0; i < kGrid.cells(); ++i) {
            EXPECT_TRUE(std::isfinite(exemplars.table(e)[i]));
            EXPECT_GE(exemplars.table(e)[i], 0.0f);
        }
    }
}

// Nothing is known beyond 60 degrees, the limit of captures. The extrapolated tail of a GGX with 1
// to 5 % of its mass there is accurate to 0.4 % of the total mass, that of a Beckmann with no mass
// there to 0.01 %. A Beckmann with mass there falls faster than any power: 0.8 %.
TEST(Completion, TailsAreContinued) {
    struct Case {
        const char* name;
        test::DirectionalLobe lobe;
        double allowed;
    };
    const Case cases[] = {{"ggx", test::ggx(0.25, 0.5), 0.004},
                          {"narrow ggx", test::ggx(0.1, 0.3), 0.004},
                          {"wide ggx", test::ggx(0.45, 0.45), 0.004},
                          {"beckmann", test::beckmann(0.15, 0.4), 1e-4},
                          {"wide beckmann", test::beckmann(0.5, 0.5), 1e-4},
                          {"very wide beckmann", test::beckmann(0.8, 0.8), 0.008}};
    const int beyond = first_ring_beyond(60);
    for (const Case& c : cases) {
        const std::vector<float> truth = test::normalized(kGrid, test::sampled(kGrid, c.lobe));
        Exemplars exemplars = exemplars_of({truth});
        for (int r = beyond; r < kGrid.rings; ++r)
            for (int a = 0; a < kGrid.azimuths; ++a) forget(exemplars, 0, r, a);
        const CompletionReport report = complete_exemplars(exemplars);
        EXPECT_EQ(report.completed, 0) << c.name;
        const double tail = test::mass_of(kGrid, exemplars.table(0), beyond);
        EXPECT_NEAR(tail, test::mass_of(kGrid, truth.data(), beyond), c.allowed) << c.name;
        EXPECT_LT(difference(exemplars.table(0), truth), 2 * c.allowed) << c.name;
        for (int r = 0; r < kGrid.rings; ++r)
            for (int a = 0; a < kGrid.azimuths; ++a)
                EXPECT_EQ(exemplars.origin[test::cell(kGrid, r, a)],
                          r < beyond ? NdfOrigin::measured : NdfOrigin::extrapolated)
                    << c.name << " " << r << " " << a;
        const double share = std::cos(test::theta_at(kGrid, beyond));
        EXPECT_NEAR(report.extrapolated, share, 1e-3) << c.name;
        EXPECT_NEAR(report.measured, 1 - share, 1e-3) << c.name;
        EXPECT_NEAR(report.completed_share, 0, 1e-9) << c.name;
        expect_whole(exemplars);
    }
}

// Two views of one distribution, rotated and with different strengths, each with a hole where the
// other one is known: both are completed.
TEST(Completion, HolesAreFilledFromAlikeExemplars) {
    const auto lobe = test::ggx(0.2, 0.5, 0.15, 0.1);
    const std::vector<float> a = test::normalized(kGrid, test::sampled(kGrid, lobe));
    const std::vector<float> b = test::normalized(kGrid, test::sampled(kGrid, lobe, 31));
    std::vector<float> stronger = b;
    for (float& v : stronger) v *= 1.4f;
    Exemplars exemplars = exemplars_of({a, stronger});
    // A hole of a fifth of the circle that extends inwards to the slopes of the lobe.
    for (int r = 12; r < kGrid.rings; ++r)
        for (int k = 0; k < 20; ++k) {
            forget(exemplars, 0, r, 15 + k);
            forget(exemplars, 1, r, 31 + 60 + k);
        }
    const CompletionReport report = complete_exemplars(exemplars);
    EXPECT_EQ(report.completed, 2);
    EXPECT_LT(difference(exemplars.table(0), a), 0.005);
    EXPECT_LT(difference(exemplars.table(1), b), 0.005);
    for (int r = 0; r < kGrid.rings; ++r) {
        EXPECT_EQ(exemplars.origin[test::cell(kGrid, r, 60)], NdfOrigin::measured) << r;
        EXPECT_EQ(exemplars.origin[test::cell(kGrid, r, 25)],
                  r < 12 ? NdfOrigin::measured : NdfOrigin::completed)
            << r;
    }
    EXPECT_GT(report.completed_share, 0.1);
    EXPECT_NEAR(report.extrapolated, 0, 1e-9);
    EXPECT_NEAR(report.measured + report.completed_share + report.extrapolated, 1, 1e-6);
    expect_whole(exemplars);
}

// An unrelated exemplar gives no cells.
TEST(Completion, UnlikeExemplarsDoNotSpeakForOneAnother) {
    const std::vector<float> narrow =
        test::normalized(kGrid, test::sampled(kGrid, test::beckmann(0.1, 0.1)));
    const std::vector<float> wide =
        test::normalized(kGrid, test::sampled(kGrid, test::beckmann(0.3, 0.9, 0.4, 0)));
    Exemplars exemplars = exemplars_of({narrow, wide});
    for (int r = 16; r < kGrid.rings; ++r)
        for (int k = 0; k < 30; ++k) forget(exemplars, 0, r, k);
    const CompletionReport report = complete_exemplars(exemplars);
    EXPECT_EQ(report.completed, 0);
    EXPECT_EQ(exemplars.origin[test::cell(kGrid, 20, 15)], NdfOrigin::extrapolated);
    EXPECT_LT(difference(exemplars.table(0), narrow), 0.03);
    expect_whole(exemplars);
}

// Rotates counter-clockwise, linear between columns; rotations by whole columns are exact.
TEST(TurnTable, ShiftsColumns) {
    Random random(5);
    std::vector<float> table, out(static_cast<std::size_t>(kGrid.cells()));
    for (int i = 0; i < kGrid.cells(); ++i) table.push_back(static_cast<float>(random.uniform()));
    for (const float shift : {0.0f, 7.0f, 95.0f, 13.25f, -2.5f, 200.0f}) {
        rotate_table(kGrid, table.data(), shift, out.data());
        for (int r = 0; r < kGrid.rings; ++r) {
            for (int a = 0; a < kGrid.azimuths; ++a) {
                const double from = a - static_cast<double>(shift);
                const int low = static_cast<int>(std::floor(from));
                const double t = from - low;
                EXPECT_NEAR(static_cast<double>(out[test::cell(kGrid, r, a)]),
                            (1 - t) * static_cast<double>(table[test::cell(kGrid, r, low)]) +
                                t * static_cast<double>(table[test::cell(kGrid, r, low + 1)]),
                            1e-5)
                    << shift;
            }
        }
    }
}

// Points of three distributions at all rotations, each partly known: clustering finds three
// exemplars or few more, and no exemplar mixes two distributions.
TEST(Clustering, FindsTheClassesWhateverTheTurn) {
    const test::DirectionalLobe lobes[] = {test::beckmann(0.15, 0.45), test::ggx(0.3, 0.3, 0.25, 0),
                                           test::ggx(0.12, 0.25)};
    Random random(6);
    std::vector<float> values, weights;
    std::vector<int> classes;
    const std::size_t count = 150;
    for (std::size_t p = 0; p < count; ++p) {
        classes.push_back(random.below(3));
        const std::vector<float> table = test::sampled(
            kGrid, lobes[static_cast<std::size_t>(classes.back())], random.uniform(0, 96));
        for (int r = 0; r < kGrid.rings; ++r) {
            for (int a = 0; a < kGrid.azimuths; ++a) {
                const bool seen = r < 12 || (r < 24 && a < 60);
                values.push_back(seen ? table[test::cell(kGrid, r, a)] : -1.0f);
                weights.push_back(seen ? 1.0f : 0.0f);
            }
        }
    }
    std::vector<Candidate> turns;
    ClusterSettings settings;
    settings.exemplars = 12;
    const Exemplars found = cluster_points(kGrid, {values, weights, count}, settings, turns, {});
    EXPECT_GE(found.count, 3);
    EXPECT_LE(found.count, 12);
    ASSERT_EQ(turns.size(), count);
    std::vector<int> owner(static_cast<std::size_t>(found.count), -1);
    for (std::size_t p = 0; p < count; ++p) {
        ASSERT_GE(turns[p].exemplar, 0) << p;
        ASSERT_LT(turns[p].exemplar, found.count) << p;
        EXPECT_LT(turns[p].residual, 0.05f) << p;
        int& own = owner[static_cast<std::size_t>(turns[p].exemplar)];
        if (own < 0) own = classes[p];
        EXPECT_EQ(own, classes[p]) << p;
    }
    std::vector<Candidate> again;
    const Exemplars twice = cluster_points(kGrid, {values, weights, count}, settings, again, {});
    EXPECT_EQ(twice.D, found.D);  // the same seed, the same answer
}

}  // namespace
}  // namespace burnish
