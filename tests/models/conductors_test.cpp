// Measured metals and the films on them, against derivations that share no code with them: complex
// amplitudes in long double, the series of internal reflections, published charts.
#include "burnish/conductors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <glm/common.hpp>
#include <numbers>
#include <random>
#include <string>

#include "burnish/error.hpp"
#include "burnish/f32.hpp"
#include "models/fresnel_words.hpp"
#include "models/metal_charts.hpp"
#include "models/spectra/cie_1931.hpp"
#include "models/spectra/fresnel_fit.hpp"
#include "models/spectra/metal_reflectance.hpp"
#include "models/spectra/optical_constants.hpp"
#include "oracle/surface.hpp"

namespace burnish {
namespace {

using LongComplex = std::complex<long double>;

Spectrum spectrum_of(double (*f)(double nm)) {
    Spectrum s;
    for (int i = 0; i < kWavelengths; ++i) s[static_cast<std::size_t>(i)] = f(wavelength_nm(i));
    return s;
}

// --- colors ---------------------------------------------------------------------------------------

// ISO/CIE 11664-2: the white of D65 is 0.95047, 1, 1.08883 from tables of 1 nm; in steps of 5 nm it
// differs by less than 1e-4.
TEST(Cie1931, SeesTheWhiteOfD65) {
    const glm::dvec3 white = xyz_of_reflectance(spectrum_of([](double) { return 1.0; }));
    EXPECT_NEAR(white.x, 0.95047, 1e-4);
    EXPECT_NEAR(white.y, 1.0, 1e-12);
    EXPECT_NEAR(white.z, 1.08883, 1e-4);
}

TEST(Cie1931, MakesAPerfectReflectorWhiteAndAGreyOneGrey) {
    const glm::dvec3 grey = rec709_of_reflectance(spectrum_of([](double) { return 0.25; }));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(grey[c], 0.25, 1e-12);
}

// A reflectance of long, middle or short wavelengths alone is mainly red, green or blue.
TEST(Cie1931, TellsLongFromMiddleFromShortWavelengths) {
    const glm::dvec3 red =
        rec709_of_reflectance(spectrum_of([](double nm) { return nm > 600 ? 1.0 : 0.0; }));
    const glm::dvec3 green = rec709_of_reflectance(
        spectrum_of([](double nm) { return nm > 500 && nm < 570 ? 1.0 : 0.0; }));
    const glm::dvec3 blue =
        rec709_of_reflectance(spectrum_of([](double nm) { return nm < 490 ? 1.0 : 0.0; }));
    EXPECT_GT(red.r, 10 * std::max(red.g, red.b));
    EXPECT_GT(green.g, 10 * std::max(green.r, green.b));
    EXPECT_GT(blue.b, 10 * std::max(blue.r, blue.g));
}

// --- tables ---------------------------------------------------------------------------------------

TEST(MeasuredMetals, CoverTheVisibleRangeInAscendingOrderUnderTheNamesOfTheConductors) {
    ASSERT_EQ(measured_metals().size(), conductor_names().size());
    const auto check = [](std::string_view name, std::span<const OpticalSample> samples) {
        EXPECT_LE(samples.front().nm, 380.0) << name;
        EXPECT_GE(samples.back().nm, 780.0) << name;
        for (std::size_t i = 1; i < samples.size(); ++i)
            EXPECT_LT(samples[i - 1].nm, samples[i].nm) << name;
        for (const OpticalSample& s : samples) {
            EXPECT_GT(s.n, 0.0) << name;
            EXPECT_GE(s.k, 0.0) << name;
        }
    };
    for (std::size_t i = 0; i < conductor_names().size(); ++i) {
        EXPECT_EQ(measured_metals()[i].name, conductor_names()[i]);
        check(measured_metals()[i].name, measured_metals()[i].samples);
    }
    for (const MeasuredOxide& oxide : measured_oxides()) check(oxide.formula, oxide.samples);
}

TEST(MeasuredMetals, AreReadLinearlyBetweenSamplesAndHeldBeyondThem) {
    const OpticalSample samples[] = {{400, 1, 2}, {500, 3, 6}};
    EXPECT_EQ(optical_index(samples, 425), std::complex<double>(1.5, 3));
    EXPECT_EQ(optical_index(samples, 380), std::complex<double>(1, 2));
    EXPECT_EQ(optical_index(samples, 780), std::complex<double>(3, 6));
}

// Reflectances of freshly evaporated films at 400, 450, ..., 700 nm, measured directly (Hass and Hadley,
// "Optical properties of metals", AIP Handbook of Physics, 3rd ed., 1972), not by way of n and k. The
// two kinds of measurement, of different films, differ by up to 0.025; model fits that smear the
// absorption edge of copper miss it by 0.1.
TEST(MeasuredMetals, ReflectWhatMirrorsWereMeasuredToReflect) {
    const std::pair<std::string_view, std::array<double, 7>> mirrors[] = {
        {"aluminium", {0.924, 0.922, 0.918, 0.915, 0.911, 0.905, 0.897}},
        {"silver", {0.956, 0.971, 0.979, 0.983, 0.986, 0.988, 0.989}},
        {"gold", {0.387, 0.387, 0.477, 0.817, 0.919, 0.955, 0.970}},
        {"copper", {0.475, 0.552, 0.600, 0.669, 0.933, 0.966, 0.975}}};
    for (const auto& [metal, reflectances] : mirrors) {
        const MetalReflectance spectrum(metal);
        for (std::size_t i = 0; i < reflectances.size(); ++i) {
            const int sample = 4 + 10 * static_cast<int>(i);
            EXPECT_NEAR(spectrum.at(sample, 1.0), reflectances[i], 0.026)
                << metal << " " << wavelength_nm(sample);
        }
    }
}

// --- Fresnel and Airy -------------------------------------------------------------------------------

TEST(MetalReflectance, IsFresnelsByComplexAmplitudes) {
    for (const std::string_view metal : conductor_names()) {
        const MetalReflectance spectrum(metal);
        const auto samples =
            measured_metals()[static_cast<std::size_t>(std::ranges::find(conductor_names(), metal) -
                                                       conductor_names().begin())]
                .samples;
        for (int i = 0; i < kWavelengths; i += 8) {
            const std::complex<double> m = optical_index(samples, wavelength_nm(i));
            for (const double c : {1.0, 0.7, 0.3, 0.05})
                EXPECT_NEAR(spectrum.at(i, c),
                            static_cast<double>(oracle::conductor(m.real(), m.imag(), c)), 1e-12)
                    << metal;
        }
    }
}

// The sum, term by term, of the waves that leave the film after 0, 1, 2, ... reflections inside, with
// the transmissions of both interfaces, polarization by polarization.
long double reflections_summed(LongComplex film, long double thickness, LongComplex metal,
                               long double nm, long double cosine) {
    const long double sine2 = 1 - cosine * cosine;
    const LongComplex cos_film = std::sqrt(LongComplex(1) - sine2 / (film * film));
    const LongComplex cos_metal = std::sqrt(LongComplex(1) - sine2 / (metal * metal));
    const LongComplex phase = std::exp(
        LongComplex(0, 2 * std::numbers::pi_v<long double> * thickness / nm) * film * cos_film);
    long double sum = 0;
    for (const bool p : {false, true}) {
        // Admittances: of the fields along the interface.
        const LongComplex y0 = p ? LongComplex(1) / cosine : LongComplex(cosine);
        const LongComplex y1 = p ? film / cos_film : film * cos_film;
        const LongComplex y2 = p ? metal / cos_metal : metal * cos_metal;
        const LongComplex r01 = (y0 - y1) / (y0 + y1), t01 = LongComplex(2) * y0 / (y0 + y1);
        const LongComplex r10 = -r01, t10 = LongComplex(2) * y1 / (y0 + y1);
        const LongComplex r12 = (y1 - y2) / (y1 + y2);
        LongComplex field = r01, inside = t01 * phase * r12 * phase;
        for (int order = 0; order < 200; ++order) {
            field += inside * t10;
            inside *= r10 * phase * r12 * phase;
        }
        sum += std::norm(field);
    }
    return sum / 2;
}

TEST(FilmReflectance, IsTheSumOfAllInternalReflections) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 400; ++i) {
        const std::complex<double> film(1.3 + 2 * unit(random), i % 2 ? 0.6 * unit(random) : 0.0);
        const std::complex<double> metal(0.1 + 3 * unit(random), 1.5 + 5 * unit(random));
        const double thickness = 1000 * unit(random), nm = 380 + 400 * unit(random);
        const double cosine = 0.02 + 0.98 * unit(random);
        const long double series =
            reflections_summed(LongComplex(film.real(), film.imag()), thickness,
                               LongComplex(metal.real(), metal.imag()), nm, cosine);
        // 200 orders: each is at most r10 r12 < 0.93 of the one before.
        EXPECT_NEAR(film_reflectance(film, thickness, metal, nm, cosine),
                    static_cast<double>(series), 1e-6)
            << film << metal << thickness << " " << cosine;
    }
}

TEST(FilmReflectance, IsTheMetalsWithoutAFilmAndUnderAFilmOfTheMetal) {
    const std::complex<double> metal(2.5, 3.4);
    for (const double cosine : {1.0, 0.6, 0.1}) {
        const double bare = interface_reflectance(metal, cosine);
        EXPECT_NEAR(film_reflectance({2.4, 0.1}, 0, metal, 500, cosine), bare, 1e-12);
        EXPECT_NEAR(film_reflectance(metal, 40, metal, 500, cosine), bare, 1e-12);
    }
}

// A quarter wave of index sqrt(R-matched) on glass: the textbook value ((n1^2 - n0 n2)/(n1^2 + n0 n2))^2.
TEST(FilmReflectance, IsTheTextbooksForAQuarterWaveOnGlass) {
    const double n1 = 1.38, n2 = 1.52, nm = 550;
    const double expected = std::pow((n1 * n1 - n2) / (n1 * n1 + n2), 2);
    EXPECT_NEAR(film_reflectance(n1, nm / (4 * n1), n2, nm, 1.0), expected, 1e-12);
}

TEST(MetalReflectance, LosesNoEnergyAndReachesOneAtGrazingIncidence) {
    for (const std::string_view metal : conductor_names())
        for (const double nm : {0.0, 25.0, 140.0, 600.0}) {
            if (nm > 0 && oxide_of(metal).empty()) continue;
            const MetalReflectance spectrum(metal, nm);
            for (int i = 0; i < kWavelengths; i += 5) {
                for (double c = 0; c <= 1; c += 0.125) {
                    EXPECT_GE(spectrum.at(i, c), 0.0) << metal;
                    EXPECT_LE(spectrum.at(i, c), 1.0 + 1e-12) << metal;
                }
                EXPECT_NEAR(spectrum.at(i, 0.0), 1.0, 1e-12) << metal;
            }
        }
}

// --- what a shader holds --------------------------------------------------------------------------

// 2e-6: the digits that the table has.
TEST(Conductors, AreTheFitsOfTheSpectra) {
    for (const std::string_view metal : conductor_names()) {
        const Conductor fitted = fitted_conductor(MetalReflectance(metal));
        const Conductor preset = conductor_preset(metal);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(preset.eta[c], fitted.eta[c], 2e-6f * (1 + fitted.eta[c]))
                << metal << " " << c;
            EXPECT_NEAR(preset.k[c], fitted.k[c], 2e-6f * (1 + fitted.k[c])) << metal << " " << c;
        }
        EXPECT_EQ(conductor_name(preset), metal);
        EXPECT_FALSE(preset.oxide);
    }
    EXPECT_THROW(conductor_preset("gould"), UsageError);
}

TEST(Conductors, HaveTheColorOfTheSpectraAtNormalIncidence) {
    for (const std::string_view metal : conductor_names()) {
        const glm::dvec3 color = MetalReflectance(metal).held_color(1.0);
        const glm::vec3 held = normal_reflectance(conductor_preset(metal));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(held[c], color[c], 1e-5) << metal;
    }
}

// The bound of docs/evidence/metals.md: two of 255 at the worst angle.
TEST(Conductors, AreWithinTwoOf255OfTheSpectraAtAllAngles) {
    for (const std::string_view metal : conductor_names()) {
        const test::FitError e =
            test::error_of(MetalReflectance(metal), test::values_of(conductor_preset(metal)));
        EXPECT_LT(e.largest_srgb, 2.0) << metal;
        EXPECT_LT(e.rms_srgb, 0.5) << metal;
    }
}

// Every chart is right for some metals: docs/evidence/metals.md says which and why. No chart has steel,
// tungsten and bronze.
TEST(Conductors, AreWithinThreeOf255OfAPublishedChart) {
    for (const std::string_view metal : conductor_names()) {
        const glm::ivec3 ours =
            test::srgb8_of_linear(glm::dvec3(normal_reflectance(conductor_preset(metal))));
        int charts = 0, nearest = 255;
        for (const test::MetalChart& chart : test::kMetalCharts)
            if (const test::ChartColor* theirs = test::find_color(chart, metal)) {
                ++charts;
                nearest = std::min(nearest, test::difference(ours, theirs->srgb));
            }
        const bool uncharted = metal == "steel" || metal == "tungsten" || metal == "bronze";
        EXPECT_EQ(charts == 0, uncharted) << metal;
        EXPECT_TRUE(uncharted || nearest <= 3) << metal << " " << nearest;
    }
}

// --- oxides ---------------------------------------------------------------------------------------

TEST(OxideFilms, AreKnownOfTheMetalsThatTheErrorNames) {
    EXPECT_EQ(oxide_of("titanium"), "TiO2");
    EXPECT_EQ(oxide_of("gold"), "");
    EXPECT_THROW(oxide_of("gould"), UsageError);
    try {
        oxide_film("gold", 50);
        FAIL();
    } catch (const UsageError& error) {
        const std::string line = error.what();
        EXPECT_NE(line.find("titanium (TiO2)"), line.npos) << line;
        EXPECT_NE(line.find("gold"), line.npos) << line;
    }
    EXPECT_THROW(oxide_film("gould", 50), UsageError);
}

// The bounds of docs/evidence/metals.md.
TEST(OxideFilms, AreCurvesWithinSixOf255OfTheSpectraAtAllAngles) {
    for (const std::string_view metal : conductor_names()) {
        if (oxide_of(metal).empty()) continue;
        for (const float nm :
             {1.0f, 20.0f, 45.0f, 80.0f, 130.0f, 210.0f, 333.0f, 550.0f, 1000.0f}) {
            const OxideFilm film = oxide_film(metal, nm);
            EXPECT_EQ(film.thickness_nm, nm);
            const test::FitError e = test::error_of(
                MetalReflectance(metal, static_cast<double>(nm)), test::values_of(film.curve));
            EXPECT_LT(e.largest_srgb, 6.0) << metal << " " << nm;
            EXPECT_LT(e.rms_srgb, 1.2) << metal << " " << nm;
        }
    }
}

// Terms of opposite signs cancel in part; a float keeps twenty of its roundings.
TEST(OxideFilms, AreEvaluatedInSinglePrecision) {
    for (const float nm : {20.0f, 175.0f, 1000.0f}) {
        const FresnelTerms terms = oxide_film("titanium", nm).curve;
        const test::ShaderFresnel wanted = test::values_of(terms);
        for (float c = 0; c <= 1; c += 1.0f / 64)
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(f32::fresnel_curve(terms[0][i], terms[1][i], terms[2][i], terms[3][i],
                                               terms[4][i], terms[5][i], c),
                            wanted(c)[i], 20 * 6e-8)
                    << nm << " " << c;
    }
}

TEST(OxideFilms, HaveTheColorOfTheSpectraAtNormalIncidence) {
    Conductor c = conductor_preset("titanium");
    c.oxide = oxide_film("titanium", 175);  // its red is below 0
    const glm::dvec3 color = MetalReflectance("titanium", 175).held_color(1.0);
    EXPECT_EQ(normal_reflectance(c).r, 0.0f);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(normal_reflectance(c)[i], color[i], 1e-6);
    EXPECT_EQ(conductor_name(c), "titanium");
}

TEST(OxideFilms, ThatAreThinAreTheMetal) {
    for (const std::string_view metal : conductor_names()) {
        if (oxide_of(metal).empty()) continue;
        Conductor c = conductor_preset(metal);
        const glm::vec3 bare = normal_reflectance(c);
        c.oxide = oxide_film(metal, 0.01f);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(normal_reflectance(c)[i], bare[i], 1e-3f) << metal;
    }
}

// Hue in degrees, 0 red, 120 green, 240 blue; and how colorful, 0 grey, of display values.
struct HueOf {
    double hue, saturation;
};
HueOf hue_of(std::string_view metal, double nm) {
    const glm::ivec3 c = test::srgb8_of_linear(MetalReflectance(metal, nm).color(1.0));
    const int high = std::max({c.x, c.y, c.z}), low = std::min({c.x, c.y, c.z});
    const double chroma = std::max(high - low, 1);
    double hue = c.x == high   ? (c.y - c.z) / chroma
                 : c.y == high ? 2 + (c.z - c.x) / chroma
                               : 4 + (c.x - c.y) / chroma;
    hue = std::fmod(60 * hue + 360, 360);
    return {hue, (high - low) / std::max(1.0, static_cast<double>(high))};
}

struct HueStep {
    double nm;         // somewhere in
    double low, high;  // degrees
};

void expect_hues(std::string_view metal, std::span<const HueStep> steps) {
    for (const HueStep& step : steps) {
        const HueOf found = hue_of(metal, step.nm);
        EXPECT_GE(found.hue, step.low) << metal << " " << step.nm;
        EXPECT_LE(found.hue, step.high) << metal << " " << step.nm;
        EXPECT_GT(found.saturation, 0.15) << metal << " " << step.nm;
    }
}

// As the voltage rises, and with it the film at 1.5 to 2.5 nm a volt, anodized titanium becomes yellow,
// purple, blue, light blue, (silver,) yellow, pink, violet, blue-green, green, yellow-green, pink
// (Diamanti, Del Curto and Pedeferri 2008, "Interference colors of thin oxide layers on titanium",
// Color Res. Appl. 33, 221; the trade's charts have the same order).
TEST(OxideFilms, ColorTitaniumInTheOrderOfAnodizing) {
    const HueStep steps[] = {{20, 30, 55},    {40, 255, 300},  {50, 200, 225},  {65, 190, 215},
                             {112, 45, 65},   {145, 285, 330}, {160, 210, 250}, {178, 170, 195},
                             {190, 130, 165}, {205, 60, 100},  {240, 310, 345}};
    expect_hues("titanium", steps);
}

// Between the blue and the yellow of the second order it is nearly silver.
TEST(OxideFilms, MakeTitaniumSilverBetweenTheFirstOrders) {
    EXPECT_LT(hue_of("titanium", 85).saturation, 0.1);
}

// Tempering colors: straw, brown, purple, dark blue, light blue, grey. The films are 30 to 70 nm thick.
TEST(OxideFilms, ColorIronInTheOrderOfTempering) {
    const HueStep steps[] = {
        {20, 35, 55}, {33, 25, 50}, {38, 270, 345}, {46, 220, 250}, {60, 200, 215}};
    expect_hues("iron", steps);
    EXPECT_LT(hue_of("iron", 96).saturation, 0.15);
}

// The film on a plate that is left in air stays without color.
TEST(OxideFilms, LeaveAluminiumWithoutColor) {
    for (const double nm : {3.0, 40.0, 100.0})
        EXPECT_LT(hue_of("aluminium", nm).saturation, 0.08) << nm;
}

}  // namespace
}  // namespace burnish
