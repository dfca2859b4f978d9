// Measured materials: what is read must evaluate, sample and describe itself in finite numbers.
#include <cmath>

#include "formats/bsdf/rgl_brdf.hpp"
#include "harness.hpp"

namespace {

using burnish::Direction;
using burnish::fuzz::broken;

void expect_finite(double value, const char* what) {
    if (!std::isfinite(value) || value < 0) broken(what);
}

void try_direction(const burnish::RglBrdf& brdf, Direction<double> wo) {
    for (const double u : {0.0, 0.3, 0.999999}) {
        double density = 0;
        const Direction<double> wi = brdf.sample(wo, {u, 1 - u}, density);
        expect_finite(density, "a density of a draw");
        if (density > 0 && std::fabs(length(wi) - 1) > 1e-6) broken("a draw that is not unit");
        for (const double f : brdf.eval(wi, wo)) expect_finite(f, "a value");
        for (const double f : brdf.eval(wo, wo)) expect_finite(f, "a value the way back");
        expect_finite(brdf.pdf(wi, wo), "a density");
    }
    expect_finite(brdf.ndf(0.5, 0.5), "a distribution");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto path = burnish::fuzz::put("material.bsdf", burnish::fuzz::Bytes(data, size));
    burnish::fuzz::expect_answer([&] {
        const burnish::RglBrdf brdf = burnish::RglBrdf::load(path);
        try_direction(brdf, {0, 0, 1});
        try_direction(brdf, {0.6, 0, 0.8});
        try_direction(brdf, {-0.48, 0.64, 0.6});
        try_direction(brdf, {0, -1, 1e-9});
    });
    return 0;
}
