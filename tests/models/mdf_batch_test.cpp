// The batched distributions against the scalar ones: the same text, other elementary functions.
#include "models/batch/mdf_batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "burnish/mdf.hpp"
#include "models/batch/mdf_batch_kernels.hpp"

namespace burnish {
namespace {

template <typename Float>
struct Columns {
    std::vector<Float> p0, p1, nx, ny, nz, hx, hy, hz, D, D_proj, D_conserving;

    MdfRows<Float> rows() const { return {p0, p1, n(), h()}; }
    DirectionColumns<Float> n() const { return {nx, ny, nz}; }
    DirectionColumns<Float> h() const { return {hx, hy, hz}; }
    MdfResults<Float> results() {
        for (auto* column : {&D, &D_proj, &D_conserving}) column->assign(p0.size(), Float(-1));
        return {D, D_proj, D_conserving};
    }
    void add(Float a, Float b, Direction<Float> normal, Direction<Float> half) {
        p0.push_back(a);
        p1.push_back(b);
        nx.push_back(normal.x);
        ny.push_back(normal.y);
        nz.push_back(normal.z);
        hx.push_back(half.x);
        hy.push_back(half.y);
        hz.push_back(half.z);
    }
};

template <typename Float>
Direction<Float> direction(double theta, double phi) {
    Direction<Float> v{static_cast<Float>(std::sin(theta) * std::cos(phi)),
                       static_cast<Float>(std::sin(theta) * std::sin(phi)),
                       static_cast<Float>(std::cos(theta))};
    make_unit(v);
    return v;
}

// Lobes from mirrors to the widest, tilts to 85 degrees, half vectors everywhere, at n and at n~.
template <typename Float>
Columns<Float> cases(Mdf mdf, std::size_t count) {
    std::mt19937 random(7);
    const auto uniform = [&] { return std::uniform_real_distribution<>()(random); };
    Columns<Float> columns;
    for (std::size_t i = 0; i < count; ++i) {
        const bool exponents = mdf == Mdf::ashikhmin_shirley;
        const auto shape = [&] {
            return static_cast<Float>(exponents ? std::pow(10.0, 4 * uniform()) - 1
                                                : std::pow(10.0, -2 + 2 * uniform()));
        };
        const Direction<Float> n = direction<Float>(1.4835 * uniform(), 6.2832 * uniform());
        const Direction<Float> h = i % 7 == 0 ? n
                                   : i % 7 == 1
                                       ? Direction<Float>{0, 0, 1}
                                       : direction<Float>(3.1415 * uniform(), 6.2832 * uniform());
        columns.add(shape(), shape(), n, h);
    }
    return columns;
}

// ln of the ratio that another rounding of exp, log and the sums before them can make: a few units
// in the last place, times what the exponent multiplies.
template <typename Float>
double allowed(double value, double peak) {
    const double unit = static_cast<double>(std::numeric_limits<Float>::epsilon());
    const double exponent = std::abs(std::log(std::max(value, 1e-300) / peak));
    return 16 * unit * (1 + exponent);
}

template <typename Float>
void expect_as_scalar(std::size_t count) {
    for (int mdf = 0; mdf < static_cast<int>(mdf_names().size()); ++mdf) {
        Columns<Float> columns = cases<Float>(static_cast<Mdf>(mdf), count);
        for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
            mdf_values(static_cast<Mdf>(mdf), static_cast<Method>(method), columns.rows(),
                       columns.results());
            for (std::size_t i = 0; i < count; ++i) {
                const auto one = mdf_values(static_cast<Mdf>(mdf), columns.p0[i], columns.p1[i],
                                            static_cast<Method>(method),
                                            {columns.nx[i], columns.ny[i], columns.nz[i]},
                                            {columns.hx[i], columns.hy[i], columns.hz[i]});
                const std::string where = "mdf " + std::to_string(mdf) + ", method " +
                                          std::to_string(method) + ", row " + std::to_string(i);
                // Values that a float holds with fewer digits are compared with what it can hold.
                const double least = 1e4 * static_cast<double>(std::numeric_limits<Float>::min());
                const auto expect_near = [&](Float batch, Float scalar) {
                    const auto b = static_cast<double>(batch), s = static_cast<double>(scalar);
                    ASSERT_TRUE(std::isfinite(b)) << where;
                    const double peak = std::max(1.0, s);
                    ASSERT_NEAR(b, s, least + s * allowed<Float>(s, peak)) << where;
                };
                expect_near(columns.D[i], one.D);
                expect_near(columns.D_proj[i], one.D_proj);
                expect_near(columns.D_conserving[i], one.D_conserving);
            }
        }
    }
}

TEST(MdfBatch, AgreesWithTheScalarTextInFloat) {
    expect_as_scalar<float>(1000);
}

TEST(MdfBatch, AgreesWithTheScalarTextInDouble) {
    expect_as_scalar<double>(1000);
}

// Neither the place in a register nor how many rows there are changes a value.
TEST(MdfBatch, RowsDoNotDependOnTheirNeighbors) {
    Columns<float> all = cases<float>(Mdf::ashikhmin_shirley, 40);
    mdf_values(Mdf::ashikhmin_shirley, Method::deform_smooth, all.rows(), all.results());
    for (std::size_t count = 1; count < 20; ++count) {
        Columns<float> some;
        for (std::size_t i = 0; i < count; ++i) {
            some.add(all.p0[i + 3], all.p1[i + 3], {all.nx[i + 3], all.ny[i + 3], all.nz[i + 3]},
                     {all.hx[i + 3], all.hy[i + 3], all.hz[i + 3]});
        }
        mdf_values(Mdf::ashikhmin_shirley, Method::deform_smooth, some.rows(), some.results());
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_EQ(some.D[i], all.D[i + 3]) << count << ", " << i;
            EXPECT_EQ(some.D_conserving[i], all.D_conserving[i + 3]) << count << ", " << i;
        }
    }
}

TEST(MdfBatch, OneLobeForAllIsTheSameAsInEveryRow) {
    for (const Method method : {Method::deform_smooth, Method::follow_grain, Method::rotate_arc}) {
        for (const bool flag : {false, true}) {  // conserving, and which way the grooves run
            Columns<double> columns = cases<double>(Mdf::ward, 101);
            columns.p0.assign(101, flag ? 0.1 : 0.5);
            columns.p1.assign(101, flag ? 0.5 : 0.1);
            mdf_values(Mdf::ward, method, columns.rows(), columns.results());
            std::vector<double> D(101, -1.0);
            mdf_table(Mdf::ward, columns.p0[0], columns.p1[0], method, flag, columns.n(),
                      columns.h(), D);
            EXPECT_EQ(D, flag ? columns.D_conserving : columns.D_proj);
        }
    }
}

// The kernels that other processors get.
TEST(MdfBatch, BaselineAgreesWithTheBestInstructions) {
    constexpr std::size_t count = 203;
    for (int mdf = 0; mdf < static_cast<int>(mdf_names().size()); ++mdf) {
        Columns<double> columns = cases<double>(static_cast<Mdf>(mdf), count);
        for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
            mdf_values(static_cast<Mdf>(mdf), static_cast<Method>(method), columns.rows(),
                       columns.results());
            std::vector<double> D(count), D_proj(count), D_conserving(count);
            kMdfKernelsBaseline.f64(
                {mdf,
                 method,
                 false,
                 true,
                 count,
                 {columns.p0.data(), columns.p1.data(), columns.nx.data(), columns.ny.data(),
                  columns.nz.data(), columns.hx.data(), columns.hy.data(), columns.hz.data(),
                  D.data(), D_proj.data(), D_conserving.data()}});
            for (std::size_t i = 0; i < count; ++i) {
                EXPECT_NEAR(D_conserving[i], columns.D_conserving[i],
                            1e-11 * std::abs(D_conserving[i]) + 1e-290)
                    << mdf << ", " << method << ", " << i;
            }
        }
    }
}

TEST(MdfBatch, ColumnsOfDifferentLengthAreRefused) {
    Columns<float> columns = cases<float>(Mdf::ggx, 5);
    const auto results = columns.results();
    columns.hz.pop_back();
    EXPECT_THROW(mdf_values(Mdf::ggx, Method::none, columns.rows(), results),
                 std::invalid_argument);
}

TEST(MdfBatch, SaysWhatItRunsOn) {
    EXPECT_FALSE(mdf_batch_instructions().empty());
#if defined(__x86_64__) && defined(__GNUC__)
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    EXPECT_EQ(mdf_batch_instructions().find("avx2") != std::string_view::npos, avx2);
#endif
}

}  // namespace
}  // namespace burnish
