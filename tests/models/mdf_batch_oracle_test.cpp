// The batched distributions against the independent oracle (tests/oracle), through both calls of
// the batch: parameters by row, and one lobe for all rows.
#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "burnish/f32.hpp"
#include "burnish/f64.hpp"
#include "mdf_oracle_support.hpp"
#include "models/batch/mdf_batch.hpp"

namespace burnish::test {
namespace {

using oracle::MdfCase;

// Cases of one distribution and method as columns.
template <typename Float>
struct Group {
    std::vector<MdfCase> cases;
    std::vector<Float> p0, p1, nx, ny, nz, hx, hy, hz;

    void add(const MdfCase& c) {
        cases.push_back(c);
        p0.push_back(static_cast<Float>(c.p0));
        p1.push_back(static_cast<Float>(c.p1));
        add_unit(c.n, nx, ny, nz);
        add_unit(c.h, hx, hy, hz);
    }
    Mdf mdf() const { return static_cast<Mdf>(index_of(mdf_names(), cases[0].mdf)); }
    Method method() const { return static_cast<Method>(index_of(method_names(), cases[0].method)); }

    // D, D_proj and D_conserving of every case, by row.
    std::vector<std::array<double, 3>> by_row() const {
        const std::size_t count = cases.size();
        std::vector<Float> D(count), D_proj(count), D_conserving(count);
        mdf_values(mdf(), method(), MdfRows<Float>{p0, p1, {nx, ny, nz}, {hx, hy, hz}},
                   MdfResults<Float>{D, D_proj, D_conserving});
        std::vector<std::array<double, 3>> values;
        for (std::size_t i = 0; i < count; ++i)
            values.push_back({static_cast<double>(D[i]), static_cast<double>(D_proj[i]),
                              static_cast<double>(D_conserving[i])});
        return values;
    }

    // D_proj or D_conserving of all rows under the lobe of row `which`; that row's value.
    double of_table(std::size_t which, bool conserving) const {
        std::vector<Float> D(cases.size());
        mdf_table(mdf(), p0[which], p1[which], method(), conserving, {nx, ny, nz}, {hx, hy, hz},
                  std::span<Float>(D));
        return static_cast<double>(D[which]);
    }

  private:
    static void add_unit(oracle::Vec3 v, std::vector<Float>& x, std::vector<Float>& y,
                         std::vector<Float>& z) {
        const dialect::Vec3<Float> unit = dialect::normalize(dialect::Vec3<Float>(
            static_cast<Float>(v.x), static_cast<Float>(v.y), static_cast<Float>(v.z)));
        x.push_back(unit.x);
        y.push_back(unit.y);
        z.push_back(unit.z);
    }
};

template <typename Float>
std::vector<Group<Float>> groups(unsigned seed, std::size_t cases_of_a_pair) {
    std::map<std::pair<std::string, std::string>, Group<Float>> by_name;
    for (const MdfCase& c : oracle::mdf_cases(seed, 44 * cases_of_a_pair)) {
        const bool single = sizeof(Float) == sizeof(float);
        by_name[{c.mdf, c.method}].add(single ? rounded_to_float(c) : c);
    }
    std::vector<Group<Float>> all;
    for (auto& [name, group] : by_name) all.push_back(std::move(group));
    return all;
}

// Nine digits, as the scalar text; a lobe for all rows gives what it gives by row.
TEST(MdfBatchOracle, DistributionsInDoubleAgreeToNineDigits) {
    for (const Group<double>& group : groups<double>(21, 301)) {
        const auto got = group.by_row();
        for (std::size_t i = 0; i < group.cases.size(); ++i) {
            const MdfCase& c = group.cases[i];
            const std::array<double, 3> want = oracle_values(c);
            const double slack = rounding_slack(c, want, 1.2e-16L) + 1e-300;
            for (std::size_t k = 0; k < 3; ++k)
                ASSERT_NEAR(got[i][k], want[k], 1e-9 * want[k] + slack) << describe(c);
            if (i % 16 != 0) continue;
            ASSERT_NEAR(group.of_table(i, false), want[1], 1e-9 * want[1] + slack) << describe(c);
            ASSERT_NEAR(group.of_table(i, true), want[2], 1e-9 * want[2] + slack) << describe(c);
        }
    }
}

TEST(MdfBatchOracle, SinglePrecisionStaysWithinItsBound) {
    double worst = 0;
    for (const Group<float>& group : groups<float>(22, 301)) {
        const auto got = group.by_row();
        for (std::size_t i = 0; i < group.cases.size(); ++i) {
            const MdfCase& c = group.cases[i];
            const std::array<double, 3> want = oracle_values(c);
            const double slack = rounding_slack(c, want, static_cast<long double>(kFloatUnit));
            if (want[1] < 1e-30) {  // float's own floor
                ASSERT_NEAR(got[i][1], want[1], 1e-29 + slack) << describe(c);
                continue;
            }
            const double bound = float_bound(c, want[1]);
            const auto expect_within = [&](double value, double exact) {
                const double error = std::max(std::abs(value - exact) - slack, 0.0) / exact;
                worst = std::max(worst, error / bound);
                ASSERT_LE(error, bound) << describe(c) << " want " << exact << " got " << value;
            };
            for (std::size_t k = 0; k < 3; ++k) expect_within(got[i][k], want[k]);
            if (i % 16 == 0) {
                expect_within(group.of_table(i, false), want[1]);
                expect_within(group.of_table(i, true), want[2]);
            }
            if (HasFatalFailure()) return;
        }
    }
    RecordProperty("worst_share_of_bound", std::to_string(worst));
}

}  // namespace
}  // namespace burnish::test
