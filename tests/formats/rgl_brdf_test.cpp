// The reader of measured materials on files with values in closed form, and on broken files.
#include "formats/bsdf/rgl_brdf.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "core/constants.hpp"
#include "formats/bsdf/spectral_rgb.hpp"
#include "support/bsdf_writer.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {
namespace {

using Dir = Direction<double>;

RglBrdf parse(const std::vector<TensorPart>& parts) {
    const std::string text = tensor_text(parts);
    const auto* bytes = reinterpret_cast<const std::byte*>(text.data());
    return RglBrdf(TensorFile("made.bsdf", {bytes, bytes + text.size()}));
}

RglBrdf parse(const KnownMaterial& material) {
    return parse(material.parts());
}

Dir towards(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

Vector plain(Dir w) {
    return {w.x, w.y, w.z};
}

Dir random_direction(std::mt19937& generator) {
    std::uniform_real_distribution<double> uniform(0, 1);
    const double z = 0.1 + 0.9 * uniform(generator);
    return towards(std::acos(z), 2 * kPi * uniform(generator));
}

// ---- files whose values are known ---------------------------------------------------------------

// f cos(theta_i) = color D(h) / (4 sigma(wo)) at incident directions of the file. The tables of D
// and sigma, with 128 nodes a side, are within 1 % of D for lobes half as wide as that alpha.
void expect_known_values(const KnownMaterial& material) {
    const RglBrdf brdf = parse(material);
    std::mt19937 generator(1);
    for (std::size_t t = 0; t + 1 < material.thetas; ++t) {
        for (int k = 0; k < 50; ++k) {
            const double phi = material.phis == 1
                                   ? 6.0 * k / 50
                                   : material.phi(static_cast<std::size_t>(k) % material.phis);
            const Dir wo = towards(material.theta(t), phi), wi = random_direction(generator);
            const Dir h = normalize(wi + wo);
            const double D = material.surface.D(plain(h));
            const double expected = D / (4 * material.surface.sigma(plain(wo)) * wi.z);
            const auto f = brdf.eval(wi, wo);
            EXPECT_NEAR(f[0], 0.8 * expected, 0.01 * expected);
            EXPECT_NEAR(f[1], 0.5 * expected, 0.01 * expected);
            EXPECT_NEAR(f[2], 0.2 * expected, 0.01 * expected);
        }
    }
}

TEST(RglBrdf, IsotropicValuesAreThoseWritten) {
    KnownMaterial material;
    material.normals = 128;
    expect_known_values(material);
}

TEST(RglBrdf, AnisotropicValuesAreThoseWritten) {
    KnownMaterial material;
    material.surface = {0.5, 0.25};
    material.phis = 9;
    material.thetas = 3;
    material.normals = 128;
    expect_known_values(material);
}

// Files with a half or a quarter of the azimuths against the whole circle.
TEST(RglBrdf, SymmetryFillsTheCircle) {
    KnownMaterial whole;
    whole.surface = {0.5, 0.25};
    whole.phis = 9;
    whole.thetas = 3;
    // Odd in x and y, so that a mirror image differs from a half turn.
    whole.color = [](double x, double y) { return std::array{0.2 + x, 0.2 + y, 0.5}; };
    KnownMaterial half = whole;
    half.phis = 5;
    half.symmetry = 2;
    const RglBrdf all = parse(whole), some = parse(half);
    EXPECT_EQ(all.symmetry(), 1);
    EXPECT_EQ(some.symmetry(), 2);
    std::mt19937 generator(2);
    for (int k = 0; k < 200; ++k) {
        const Dir wi = random_direction(generator);
        Dir wo = random_direction(generator);
        if (wo.y > 0) wo = {-wo.x, -wo.y, wo.z};
        const auto direct = all.eval(wi, wo), there = some.eval(wi, wo);
        const auto turned = some.eval({-wi.x, -wi.y, wi.z}, {-wo.x, -wo.y, wo.z});
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(there[c], direct[c], 1e-9 + 1e-6 * direct[c]);
            EXPECT_NEAR(turned[c], there[c], 1e-9 + 1e-9 * there[c]);
        }
    }
    KnownMaterial quarter = whole;
    quarter.phis = 3;
    quarter.symmetry = 4;
    const RglBrdf mirrored = parse(quarter);
    EXPECT_EQ(mirrored.symmetry(), 4);
    for (int k = 0; k < 100; ++k) {
        const Dir wi = random_direction(generator), wo = random_direction(generator);
        const auto f = mirrored.eval(wi, wo);
        for (const double sx : {-1.0, 1.0})
            for (const double sy : {-1.0, 1.0}) {
                const auto g =
                    mirrored.eval({sx * wi.x, sy * wi.y, wi.z}, {sx * wo.x, sy * wo.y, wo.z});
                EXPECT_NEAR(g[0], f[0], 1e-9 + 1e-9 * f[0]);
            }
    }
}

// The density of draws is that of visible normals, D(h) / (4 sigma(wo)), at directions of the file.
TEST(RglBrdf, ThePdfIsThatOfVisibleNormals) {
    KnownMaterial material;
    material.normals = 128;
    const RglBrdf brdf = parse(material);
    std::mt19937 generator(3);
    for (std::size_t t = 0; t + 1 < material.thetas; ++t)
        for (int k = 0; k < 50; ++k) {
            const Dir wo = towards(material.theta(t), 0.3), wi = random_direction(generator);
            const Dir h = normalize(wi + wo);
            // Near the normal the table, proportional to D u^3, is interpolated poorly.
            if (std::acos(h.z) < 0.1) continue;
            const double expected =
                material.surface.D(plain(h)) / (4 * material.surface.sigma(plain(wo)));
            EXPECT_NEAR(brdf.pdf(wi, wo), expected, 0.02 * expected) << t;
        }
}

TEST(RglBrdf, TheParameterisationInvertsItself) {
    KnownMaterial material;
    material.surface = {0.5, 0.2};
    material.phis = 9;
    material.thetas = 4;
    const RglBrdf brdf = parse(material);
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> uniform(0.001, 0.999);
    for (int k = 0; k < 1000; ++k) {
        const Dir wo = random_direction(generator);
        const std::array<double, 2> square{uniform(generator), uniform(generator)};
        double density = 0;
        const Dir h = brdf.normal_at(wo, square, density);
        EXPECT_NEAR(length(h), 1, 1e-12);
        const auto back = brdf.square_of(h, wo);
        // Rounding of sines and arcs in both directions, times the density: about 1e6 in u.
        EXPECT_NEAR(back[0], square[0], 1e-8);
        EXPECT_NEAR(back[1], square[1], 1e-8);
        EXPECT_GT(density, 0);
    }
}

// The color is looked up at the position in the square. For a table of x and y themselves, eval
// returns the position of the half vector.
TEST(RglBrdf, ColorIsLookedUpInTheSquare) {
    KnownMaterial material;
    material.color = [](double x, double y) { return std::array{x, y, 1.0}; };
    const RglBrdf brdf = parse(material);
    std::mt19937 generator(6);
    for (int k = 0; k < 200; ++k) {
        const Dir wi = random_direction(generator), wo = random_direction(generator);
        const auto f = brdf.eval(wi, wo);
        const auto square = brdf.square_of(normalize(wi + wo), wo);
        EXPECT_NEAR(f[0] / f[2], square[0], 1e-6);
        EXPECT_NEAR(f[1] / f[2], square[1], 1e-6);
    }
}

TEST(RglBrdf, SpectralFilesBecomeColors) {
    KnownMaterial material;
    for (int w = 360; w <= 1000; w += 5) material.wavelengths.push_back(static_cast<float>(w));
    const RglBrdf brdf = parse(material);  // 0.8 at every wavelength: gray
    EXPECT_EQ(brdf.wavelengths(), material.wavelengths.size());
    const Dir wi = towards(0.4, 1), wo = towards(kPi / 14, 0);
    KnownMaterial gray;
    gray.color = [](double, double) { return std::array{0.8, 0.8, 0.8}; };
    const auto found = brdf.eval(wi, wo), expected = parse(gray).eval(wi, wo);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-6 * expected[c]);
}

TEST(RglBrdf, BelowTheHorizonThereIsNothing) {
    const RglBrdf brdf = parse(KnownMaterial{});
    const Dir up = towards(0.3, 0), down{up.x, up.y, -up.z};
    EXPECT_EQ(brdf.eval(down, up)[0], 0);
    EXPECT_EQ(brdf.eval(up, down)[0], 0);
    EXPECT_EQ(brdf.pdf(up, down), 0);
    double density = 1;
    brdf.sample(down, {0.5, 0.5}, density);
    EXPECT_EQ(density, 0);
    for (const double z : {1.0, 1e-3, 1e-9, 1e-300}) {  // up to the horizon, and at the normal
        const Dir w{std::sqrt(1 - z * z), 0, z};
        EXPECT_TRUE(std::isfinite(brdf.eval(w, up)[0]) && std::isfinite(brdf.eval(up, w)[0]));
        EXPECT_TRUE(std::isfinite(brdf.pdf(w, up)) && std::isfinite(brdf.pdf(up, w)));
        EXPECT_TRUE(std::isfinite(brdf.eval(w, w)[0]) && std::isfinite(brdf.pdf(w, w)));
    }
}

// ---- broken files -------------------------------------------------------------------------------

TensorPart& part(std::vector<TensorPart>& parts, std::string_view name) {
    for (TensorPart& candidate : parts)
        if (candidate.name == name) return candidate;
    throw std::runtime_error("no such part");
}

std::string refusal(const std::vector<TensorPart>& parts) {
    return error_line([&] { parse(parts); });
}

void expect_words(const std::string& line, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        EXPECT_NE(line.find(word), std::string::npos) << word << " in: " << line;
}

KnownMaterial tiny() {
    KnownMaterial material;
    material.normals = 6;
    material.samples = 3;
    material.thetas = 2;
    return material;
}

void set_float(TensorPart& field, std::size_t index, float value) {
    std::memcpy(field.data.data() + 4 * index, &value, 4);
}

TEST(RglBrdfHostile, EveryFieldIsNeeded) {
    for (const char* name :
         {"phi_i", "theta_i", "sigma", "ndf", "vndf", "luminance", "rgb", "jacobian"}) {
        auto parts = tiny().parts();
        std::erase_if(parts, [&](const TensorPart& p) { return p.name == name; });
        expect_words(refusal(parts), {"made.bsdf", name, "expected", "found"});
    }
}

TEST(RglBrdfHostile, ShapesMustFitOneAnother) {
    for (const char* name : {"vndf", "luminance", "rgb"}) {
        auto parts = tiny().parts();
        std::swap(part(parts, name).shape[0], part(parts, name).shape[1]);
        expect_words(refusal(parts), {name, "expected 1 x 2", "found 2 x 1"});
    }
    auto parts = tiny().parts();
    part(parts, "sigma").shape = {1, 36};
    expect_words(refusal(parts), {"sigma", "2 x 2", "1 x 36"});
    parts = tiny().parts();
    part(parts, "ndf").shape = {36};
    expect_words(refusal(parts), {"ndf", "rank 2", "rank 1"});
    parts = tiny().parts();
    part(parts, "rgb").type = 5;  // uint32 has the same size
    expect_words(refusal(parts), {"rgb", "float32", "uint32"});
}

TEST(RglBrdfHostile, NumbersMustMakeSense) {
    const auto with = [](std::string_view name, std::size_t index, float value) {
        auto parts = tiny().parts();
        set_float(part(parts, name), index, value);
        return refusal(parts);
    };
    expect_words(with("theta_i", 1, 0.0F), {"theta_i", "rise", "number 1"});
    expect_words(with("theta_i", 1, 1.7F), {"theta_i", "1.57"});
    expect_words(with("phi_i", 0, 4.0F), {"phi_i"});
    expect_words(with("sigma", 3, 0.0F), {"sigma", "above 0", "number 3"});
    expect_words(with("ndf", 3, -1.0F), {"ndf", "at least 0", "number 3"});
    expect_words(with("vndf", 3, -1.0F), {"vndf", "at least 0"});
    expect_words(with("rgb", 0, NAN), {"rgb", "finite"});
    auto parts = tiny().parts();
    TensorPart& light = part(parts, "luminance");
    for (std::size_t i = 9; i < 18; ++i) set_float(light, i, 0.0F);
    expect_words(refusal(parts), {"luminance", "only zeros", "1"});
}

TEST(RglBrdfHostile, AzimuthsCoverTheCircleOrAPartThatSymmetryCompletes) {
    KnownMaterial material = tiny();
    material.phis = 3;
    auto parts = material.parts();
    set_float(part(parts, "phi_i"), 2, 2.0F);
    expect_words(refusal(parts), {"phi_i", "circle"});
}

TEST(RglBrdfHostile, WavelengthsCoverWhatTheEyeSees) {
    KnownMaterial material = tiny();
    material.wavelengths = {450, 500, 700};
    expect_words(refusal(material.parts()), {"wavelengths", "400", "450"});
    material.wavelengths = {400, 700, 600};
    expect_words(refusal(material.parts()), {"wavelengths", "rise"});
}

TEST(RglBrdfHostile, DescriptionsStayOnOneLine) {
    KnownMaterial material = tiny();
    material.description = "two\nlines\x1b[31m";
    EXPECT_EQ(parse(material).description().find_first_of("\n\x1b"), std::string::npos);
}

// ---- color -------------------------------------------------------------------------------------

// CIE 015: the white point of D65 for the 2 degree observer; the fits are within 0.003.
TEST(SpectralRgb, DaylightHasItsColor) {
    double sum[3] = {};
    for (int w = 380; w <= 780; ++w) {
        const auto bar = cie_xyz_bar(w);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += bar[c] * illuminant_d65(w);
    }
    const double all = sum[0] + sum[1] + sum[2];
    EXPECT_NEAR(sum[0] / all, 0.3127, 0.003);
    EXPECT_NEAR(sum[1] / all, 0.3290, 0.003);
}

TEST(SpectralRgb, WhiteIsWhiteWhateverTheWavelengths) {
    for (const std::vector<float>& waves :
         {std::vector<float>{400, 700}, {360, 450, 455, 600, 1000}, {390, 500, 610, 730}}) {
        double sum[3] = {};
        for (const auto& weight : reflectance_to_rgb(waves))
            for (std::size_t c = 0; c < 3; ++c) sum[c] += weight[c];
        for (const double value : sum) EXPECT_NEAR(value, 1, 1e-12);
    }
}

// Spectral bands have the color of their name.
TEST(SpectralRgb, BandsHaveTheirColors) {
    std::vector<float> waves;
    for (int w = 380; w <= 780; w += 5) waves.push_back(static_cast<float>(w));
    const auto weights = reflectance_to_rgb(waves);
    const auto band = [&](float from, float to) {
        std::array<double, 3> rgb{};
        for (std::size_t k = 0; k < waves.size(); ++k)
            for (std::size_t c = 0; c < 3; ++c)
                if (waves[k] >= from && waves[k] <= to) rgb[c] += weights[k][c];
        return rgb;
    };
    const auto red = band(610, 780), green = band(520, 560), blue = band(380, 480);
    EXPECT_GT(red[0], 10 * std::max(red[1], red[2]));
    EXPECT_GT(green[1], 2 * std::max(green[0], green[2]));
    EXPECT_GT(blue[2], 5 * std::max(blue[0], blue[1]));
}

}  // namespace
}  // namespace burnish::test
