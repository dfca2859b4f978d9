// The models by name, as `brdf eval` has them, against the independent oracle (tests/oracle).
#include <gtest/gtest.h>

#include "brdf_cases.hpp"
#include "oracle/further_brdfs.hpp"
#include "oracle/make_cases.hpp"
#include "oracle/oracle.hpp"

namespace burnish::test {
namespace {

double value_of(const oracle::BrdfCase& c) {
    std::array<double, kMostBrdfParameters> p{};
    for (std::size_t k = 0; k < p.size(); ++k) {
        p[k] = static_cast<double>(c.p[k]);
    }
    const auto unit = [](oracle::Vec3 v) {
        Direction<double> w{static_cast<double>(v.x), static_cast<double>(v.y),
                            static_cast<double>(v.z)};
        make_unit(w);
        return w;
    };
    return model_named(c.brdf).value_f64(p, unit(c.i), unit(c.o));
}

TEST(FurtherOracle, EveryModelAgrees) {
    for (const std::string& name : oracle::further_brdf_names()) {
        const bool table = name == "ashikhmin-premoze-shirley";
        const double tolerance = table ? 1e-5 : 1e-9;
        for (const oracle::BrdfCase& c : oracle::further_cases(name, 51, table ? 40 : 600)) {
            const double want = static_cast<double>(oracle::brdf_eval(c.brdf, c.p, c.i, c.o));
            // What rounding of the directions themselves does, and the smallest double.
            const double wobble =
                4 * static_cast<double>(oracle::brdf_wobble(c.brdf, c.p, c.i, c.o, 1.2e-16L));
            EXPECT_NEAR(value_of(c), want, tolerance * std::abs(want) + wobble + 1e-60)
                << c.brdf << " " << c.kind << " p " << static_cast<double>(c.p[0]) << " "
                << static_cast<double>(c.p[1]) << " " << static_cast<double>(c.p[2]) << " i.z "
                << static_cast<double>(c.i.z) << " o.z " << static_cast<double>(c.o.z);
            if (HasFailure()) {
                break;
            }
        }
    }
}

}  // namespace
}  // namespace burnish::test
