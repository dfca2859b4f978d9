// What `burnish verify` measures, against closed forms and against reflections that are wrong on purpose.
#include "verify/properties.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "shading/highlight.hpp"

namespace burnish::test {
namespace {

using verify::broken_bounds;
using verify::Figures;
using verify::measure;
using verify::Reflection;
using verify::reflection_of;
using verify::Subject;

const Subject kGrain{f64::kBrdfMicrofacet, f64::kMdfGgx, 0.15, 0.5, f64::kMethodFollowGrain};

// The bounds that a wrong `make` breaks, in one text.
std::string broken_by(const verify::MakeReflection& make, Subject subject = kGrain) {
    std::string text;
    for (const std::string& line : broken_bounds(subject, measure(subject, make)))
        text += line + "\n";
    return text;
}

// Facets of even density 1/pi, and Lambert's law: Int (n.h)/pi over the hemisphere is 1, and so is the albedo, from
// everywhere.
Reflection lambert(const Subject&, vec3 n) {
    Reflection r;
    r.n = r.peak = n;
    r.D = [n](vec3 h) { return f64::dot(n, h) > 0 ? 1 / kPi : 0; };
    r.f = [n](vec3 wi, vec3 wo) {
        return f64::dot(n, wi) > 0 && f64::dot(n, wo) > 0 ? 1 / kPi : 0;
    };
    r.pdf = [n](vec3 wi, vec3) { return std::max(f64::dot(n, wi), 0.0) / kPi; };
    r.sample = [n](vec3, double xi0, double xi1, double, double& pdf) {
        const vec3 wi = Axes(n).at(std::acos(std::sqrt(xi0)), 2 * kPi * xi1);
        pdf = f64::dot(n, wi) / kPi;
        return wi;
    };
    return r;
}

TEST(VerifyProperties, LambertsLawHasTheFiguresOfItsClosedForm) {
    const Figures f = measure(kGrain, lambert);
    // 1e-3: the horizon cuts through cells of the quadrature over half vectors.
    EXPECT_NEAR(f.energy_least, 1, 1e-4);
    EXPECT_NEAR(f.energy_most, 1, 1e-4);
    EXPECT_NEAR(f.albedo_least, 1, 2e-3);
    EXPECT_NEAR(f.albedo_most, 1, 1e-3);
    EXPECT_EQ(f.reciprocity, 0);
    EXPECT_GT(f.sampler_p, 1e-3);
}

// Phong without masking, seen head-on: ks = (n+1)/(2 pi) makes its albedo 1.
TEST(VerifyProperties, PhongKeepsAllLightHeadOn) {
    const Subject phong{f64::kBrdfPhong, f64::kMdfGgx, 0.2, 0.2, f64::kMethodNone};
    const Figures f = measure(phong);
    EXPECT_GE(f.albedo_most, 1 - 1e-3);
    EXPECT_TRUE(std::isnan(f.energy_least)) << "it has no facets";
    EXPECT_GT(f.reciprocity, 0.1) << "its cosine is that of the light alone";
    EXPECT_FALSE(verify::is_judged(phong));
    EXPECT_TRUE(broken_bounds(phong, f).empty());
}

TEST(VerifyProperties, WhatIsPromisedHolds) {
    for (const int method :
         {f64::kMethodNone, f64::kMethodGramSchmidt, f64::kMethodRotateArc, f64::kMethodFollowGrain,
          f64::kMethodSlopeShift, f64::kMethodStretch}) {
        Subject s = kGrain;
        s.method = method;
        EXPECT_TRUE(verify::is_judged(s));
        EXPECT_EQ(broken_by(reflection_of, s), "")
            << method_names()[static_cast<std::size_t>(method)];
    }
}

// docs/evidence/correctness.md: normal-map has its highlight 50 degrees and more off, and makes energy. It is not
// judged.
TEST(VerifyProperties, PublishedMethodsAreReportedAsTheyAre) {
    Subject s = kGrain;
    s.method = f64::kMethodNormalMap;
    const Figures f = measure(s);
    EXPECT_GT(f.highlight_deg, 50);
    EXPECT_GT(f.albedo_most, 1.2);
    EXPECT_FALSE(verify::is_judged(s));
    EXPECT_TRUE(broken_bounds(s, f).empty());
}

// The plates of highlight.hpp are built without the maps of verify/.
TEST(VerifyProperties, PlatesOfProcessesAreThoseOfTheTests) {
    const vec3 n = direction(0.6, 2.2), wo = direction(0.4, 1.0);
    for (const LobeCase& c : lobe_cases()) {
        for (const int method :
             {f64::kMethodFollowGrain, f64::kMethodSlopeShift, f64::kMethodStretch}) {
            const Subject s{f64::kBrdfMicrofacet, c.mdf, c.p0, c.p1, method};
            const Radiance found = verify::process_plate(s, n, wo);
            const Radiance wanted = method == f64::kMethodFollowGrain
                                        ? tilted_plate(c, n, wo)
                                        : moved_plate(c, method, n, wo);
            for (const double theta : {0.2, 0.5, 0.8}) {
                for (const double phi : {0.3, 1.9, 2.4, 4.0}) {
                    const vec3 wi = direction(theta, phi);
                    EXPECT_NEAR(found(wi), wanted(wi), 1e-9 * (1 + wanted(wi))) << label(c, method);
                }
            }
        }
    }
}

TEST(VerifyProperties, AWrongFrameIsFound) {
    const auto in_the_frame_of = [](int method) {
        return [method](Subject s, vec3 n) {
            s.method = method;
            return reflection_of(s, n);
        };
    };
    EXPECT_NE(broken_by(in_the_frame_of(f64::kMethodNormalMap)).find("highlight"),
              std::string::npos);
    // A green channel of the other sign.
    const auto turned_over = [](const Subject& s, vec3 n) {
        Reflection r = reflection_of(s, {n.x, -n.y, n.z});
        r.n = n;
        return r;
    };
    EXPECT_NE(broken_by(turned_over).find("highlight"), std::string::npos);
}

TEST(VerifyProperties, AWrongSamplerIsFound) {
    const auto widened = [](const Subject& s, vec3 n) {
        Reflection r = reflection_of(s, n);
        Subject other = s;
        other.p0 *= 1.05;
        r.sample = reflection_of(other, n).sample;
        return r;
    };
    const std::string found = broken_by(widened);
    EXPECT_EQ(found.find("the sampler does not follow its density"), 0U) << found;
}

TEST(VerifyProperties, WrongEnergyAndOneSidedModelsAreFound) {
    const auto brighter = [](const Subject& s, vec3 n) {
        Reflection r = reflection_of(s, n);
        r.D = [D = r.D](vec3 h) { return 1.01 * D(h); };
        r.f = [f = r.f](vec3 wi, vec3 wo) { return 1.3 * f(wi, wo) * (1 + 1e-5 * wi.x); };
        return r;
    };
    const std::string found = broken_by(brighter);
    for (const char* word : {"Int D (n~.h) dw 1.01", "furnace reflects 1.", "not reciprocal"})
        EXPECT_NE(found.find(word), std::string::npos) << found;
    EXPECT_EQ(found.find("highlight"), std::string::npos) << found;
}

TEST(VerifyProperties, FiguresThatAreNoNumbersBreakTheirBounds) {
    Figures f = measure(kGrain);
    f.highlight_deg = std::nan("");
    f.albedo_most = std::nan("");
    f.sampler_p = std::nan("");
    f.hostile.broken_f32 = 2;
    EXPECT_EQ(broken_bounds(kGrain, f).size(), 4U);
}

}  // namespace
}  // namespace burnish::test
