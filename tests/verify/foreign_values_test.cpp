// `burnish verify --csv` on values of other programs: it says what is wrong with them.
#include <gtest/gtest.h>

#include <random>

#include "burnish/error.hpp"
#include "jobs/models/verify_csv.hpp"
#include "support/program.hpp"
#include "support/test_folder.hpp"
#include "verify/stock_formulas.hpp"

namespace burnish::test {
namespace {

constexpr double kAlphaT = 0.5, kAlphaB = 0.1;

VerifyCsvRequest request_of(const std::string& file, const Vector& n) {
    VerifyCsvRequest request;
    request.input = file;
    request.normal = {n[0], n[1], n[2]};
    request.values.set_value("alpha_x", kAlphaT);
    request.values.set_value("alpha_y", kAlphaB);
    return request;
}

template <typename F>
VerifyCsvReport report_of(const Vector& n, const F& f) {
    const Folder folder;
    return verify_csv(request_of(folder.write("values.csv", value_table(f)), n), {});
}

void expect_words(const VerifyCsvReport& report, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        EXPECT_NE(report.text.find(word), std::string::npos) << word << "\n" << report.text;
}

// GGX of the alphas above by the stock formula, in any frame.
double ggx_in(const ShaderFrame& frame, const Vector& l, const Vector& v, double at = kAlphaT,
              double ab = kAlphaB) {
    const Terms t = ggx_terms(frame, at, ab, l, v);
    return t.NoL > 0 && t.NoV > 0 ? t.D * t.V : 0;
}

const Vector kMapped = polar3(30, 35);
const ShaderFrame kStock{{1, 0, 0}, {0, 1, 0}, kMapped};

TEST(ForeignValues, ThreesStockFormulaIsInTheUnperturbedFrame) {
    // Roughness 0.316 and anisotropy 0.667: alphas 0.5 and 0.1.
    const double roughness = std::sqrt(0.1), anisotropy = std::sqrt(4.0 / 9);
    const VerifyCsvReport report = report_of(kMapped, [&](const Vector& l, const Vector& v) {
        return three_brdf(kStock, roughness, anisotropy, 1.0, l, v);
    });
    EXPECT_GT(report.error, 0.5);
    expect_words(report,
                 {"verdict             matches normal-map (microfacet, ggx)",
                  "the lobe is in the unperturbed frame", "degrees from the mapped normal"});
    // Nothing else is said to be wrong.
    EXPECT_EQ(report.text.find("; "), report.text.rfind("; ")) << report.text;
    EXPECT_EQ(report.text.find("times ours"), std::string::npos) << report.text;
}

TEST(ForeignValues, FilamentsStockFormulaIsInTheUnperturbedFrame) {
    // alpha 0.3, anisotropy 2/3: alphas 0.5 and 0.1. A metal of reflectance 0.9.
    const Folder folder;
    const std::string file =
        folder.write("values.csv", value_table([&](const auto& l, const auto& v) {
                         return filament_brdf(kStock, std::sqrt(0.3), 2.0 / 3, 0.9, l, v);
                     }));
    VerifyCsvRequest request = request_of(file, kMapped);
    request.values.set_value("f0", 0.9);
    const VerifyCsvReport report = verify_csv(request, {});
    EXPECT_GT(report.error, 0.5);
    expect_words(report, {"matches normal-map", "the lobe is in the unperturbed frame"});
}

TEST(ForeignValues, TheMendedFrameIsWhatWasAskedFor) {
    const ShaderFrame mended = mended_frame(kMapped);
    const VerifyCsvReport report =
        report_of(kMapped, [&](const Vector& l, const Vector& v) { return ggx_in(mended, l, v); });
    EXPECT_LT(report.error, 1e-5) << "six digits are written";
    expect_words(report, {"matches follow-grain", "which was asked for"});
}

TEST(ForeignValues, AMapThatIsNotReadIsFound) {
    const VerifyCsvReport report = report_of(
        kMapped, [&](const Vector& l, const Vector& v) { return ggx_in(ShaderFrame(), l, v); });
    expect_words(report, {"matches none", "the mapped normal is not used at all"});
}

TEST(ForeignValues, UsualMistakesAreNamed) {
    const ShaderFrame mended = mended_frame(kMapped);
    const auto said = [&](const auto& f) { return report_of(kMapped, f).text; };
    const auto expect_said = [&](const std::string& text, const std::string& words) {
        EXPECT_NE(text.find("matches follow-grain"), std::string::npos) << text;
        EXPECT_NE(text.find(words), std::string::npos) << text;
        EXPECT_EQ(text.find("which was asked for"), std::string::npos) << text;
    };
    expect_said(said([&](const auto& l, const auto& v) {
                    return ggx_in(mended, l, v) * std::max(dot3(kMapped, l), 0.0);
                }),
                "the cosine of the light is multiplied in");
    expect_said(said([&](const auto& l, const auto& v) {
                    const Terms t = ggx_terms(mended, kAlphaT, kAlphaB, l, v);
                    return t.D * t.V * 4 * t.NoL * t.NoV;
                }),
                "1/(4 cos cos) is missing");
    expect_said(said([&](const auto& l, const auto& v) {
                    return ggx_in(mended, l, v, kAlphaT * kAlphaT, kAlphaB * kAlphaB);
                }),
                "both alphas are squared");
    expect_said(said([&](const auto& l, const auto& v) {
                    return ggx_in(mended, l, v, std::sqrt(kAlphaT), std::sqrt(kAlphaB));
                }),
                "both alphas are square roots");
    expect_said(
        said([&](const auto& l, const auto& v) { return ggx_in(mended, l, v) / std::numbers::pi; }),
        "which is 1/pi");
    expect_said(said([&](const auto& l, const auto& v) {
                    const Terms t = ggx_terms(mended, kAlphaT, kAlphaB, l, v);
                    return t.NoL > 0 && t.NoV > 0 ? t.D * std::min(t.V, 1.0) : 0.0;
                }),
                "cut off at 1");
    expect_said(said([&](const auto& l, const auto& v) {
                    const Terms t = ggx_terms(mended, kAlphaT, kAlphaB, l, v);
                    return t.NoL > 0 && t.NoV > 0 ? t.D / (4 * t.NoL * t.NoV) : 0.0;
                }),
                "masking and shadowing are missing");
}

// Both mistakes at once.
TEST(ForeignValues, ExchangedAlphasInTheUnperturbedFrameAreFound) {
    const VerifyCsvReport report = report_of(kMapped, [&](const Vector& l, const Vector& v) {
        return ggx_in(kStock, l, v, kAlphaB, kAlphaT);
    });
    expect_words(report, {"matches normal-map", "alpha_x and alpha_y are exchanged"});
}

// A normal of the plate itself tells no method from another.
TEST(ForeignValues, MethodsThatTheRowsDoNotTellApartAreListed) {
    const VerifyCsvReport report = report_of(
        {0, 0, 1}, [&](const Vector& l, const Vector& v) { return ggx_in(ShaderFrame(), l, v); });
    expect_words(report, {"which was asked for. These rows do not tell it from none, normal-map",
                          "stretch"});
}

TEST(ForeignValues, NoiseOfTwoPercentIsNoOtherMethod) {
    const ShaderFrame mended = mended_frame(kMapped);
    std::mt19937 generator(5);
    std::normal_distribution<double> noise(1, 0.02);
    const VerifyCsvReport report = report_of(kMapped, [&](const Vector& l, const Vector& v) {
        return ggx_in(mended, l, v) * noise(generator);
    });
    EXPECT_NEAR(report.error, 0.02, 0.01);
    expect_words(report, {"follow-grain (microfacet, ggx)", "which was asked for"});
}

TEST(ForeignValues, WhatNothingExplainsIsSaidSo) {
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> any(0, 1);
    const VerifyCsvReport report =
        report_of(kMapped, [&](const Vector&, const Vector&) { return any(generator); });
    expect_words(report, {"nothing that is tried explains the values", "; the nearest is"});
}

TEST(ForeignValues, RowsThatSayNothingAreSaidSo) {
    const Folder folder;
    const auto verdict_of = [&](const std::string& row) {
        const std::string file = folder.write("in.csv", "ix,iy,iz,ox,oy,oz,f\n" + row);
        const std::string text = verify_csv(request_of(file, kMapped), {}).text;
        return text.substr(text.find("verdict"));
    };
    EXPECT_NE(verdict_of("0,0,1,0,0,1,0\n").find("their values are all 0"), std::string::npos);
    EXPECT_NE(verdict_of("0,0,-1,0,0,1,2\n").find("our values are all 0"), std::string::npos);
}

TEST(ForeignValues, BadTablesAreNamedByFileLineAndColumn) {
    const Folder folder;
    const std::string header = "ix,iy,iz,ox,oy,oz,f\n", good = "0,0,1,0,0,1,2\n";
    const auto complain = [&](const std::string& table, const std::vector<std::string>& parts) {
        const std::string file = folder.write("in.csv", table);
        expect_parts(refusal_of([&] { verify_csv(request_of(file, kMapped), {}); }), parts);
    };
    complain("", {"in.csv", "a header line that names the columns"});
    complain(header, {"in.csv", "a row of values below the header", "none"});
    complain("ix,iy,iz,ox,oy,f\n" + good, {"in.csv: line 1", "a column named oz"});
    complain(header + good + "0,0,1,0,0,1,nan\n",
             {"in.csv: line 3, column f", "a finite number", "nan"});
    complain(header + "0,0,1,0,0,1,inf\n", {"line 2, column f", "a finite number"});
    complain(header + "0,0,1,0,0,1,1e200\n", {"line 2, column f", "below 1e100"});
    complain(header + "0,0,1.01,0,0,1,1\n",
             {"line 2, column ix", "unit direction", "a length of 1.01"});
    complain(header + "0,0,1,0,0,0,1\n", {"line 2, column ox", "unit direction", "a length of 0"});
    complain(header + "0,0,1,0,0,1\n", {"line 2", "7 fields"});
    complain(header + "0,x,1,0,0,1,1\n", {"line 2, column iy", "a number", "\"x\""});
    expect_parts(refusal_of([&] { verify_csv(request_of(folder.path("no.csv"), kMapped), {}); }),
                 {"no.csv"});
}

TEST(ForeignValues, NearlyUnitDirectionsAreNormalizedWithAWarning) {
    const Folder folder;
    const std::string file =
        folder.write("in.csv", "ix,iy,iz,ox,oy,oz,f\n0,0,1.0005,0,0,1,6.3661977\n0,0,1,0,0,1,-1\n");
    const VerifyCsvReport report = verify_csv(request_of(file, {0, 0, 1}), {});
    ASSERT_EQ(report.warnings.size(), 2U);
    expect_parts(report.warnings[0], {"in.csv: 1 row ", "it is normalized"});
    expect_parts(report.warnings[1], {"1 row ", "negative f"});
    // 1/(4 pi alpha_x alpha_y) = 1.59: the peak of GGX, head-on.
    expect_words(report, {"ours 1.59155"});
}

TEST(ForeignValues, BytesOfAnyKindAreAnsweredWithOneLine) {
    const Folder folder;
    std::mt19937 generator(11);
    const std::string good = value_table([](const Vector&, const Vector&) { return 1.0; });
    for (int i = 0; i < 200; ++i) {
        std::string bytes = good.substr(0, 400);
        for (int k = 0; k < 6; ++k)
            bytes[generator() % bytes.size()] = static_cast<char>(generator() % 256);
        bytes.resize(generator() % bytes.size());
        const std::string file = folder.write("in.csv", bytes);
        try {
            verify_csv(request_of(file, kMapped), {});
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
    }
}

TEST(ForeignValues, NormalsOfTheOtherSideAndIdleModelsAreRefused) {
    const Folder folder;
    const std::string file = folder.write("in.csv", "ix,iy,iz,ox,oy,oz,f\n0,0,1,0,0,1,2\n");
    expect_parts(error_line<UsageError>([&] {
                     verify_csv(request_of(file, {0, 1, 0}), {});
                 }),
                 {"--normal", "Z > 0", "0,1,0"});
    VerifyCsvRequest request = request_of(file, kMapped);
    request.brdf = Brdf::phong;
    request.method = Method::stretch;
    expect_parts(error_line<UsageError>([&] { verify_csv(request, {}); }),
                 {"--method", "phong", "stretch"});
}

}  // namespace
}  // namespace burnish::test
