// The parameter table and typed values: names, ranges, defaults, text.
#include "burnish/parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/trigonometric.hpp>
#include <limits>
#include <set>

#include "burnish/conductors.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/scene.hpp"
#include "burnish/shading_names.hpp"
#include "core/text.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

using test::error_line;

TEST(ParameterTable, RowsAreSound) {
    std::set<std::string_view> names;
    for (const Parameter& p : parameter_table()) {
        SCOPED_TRACE(std::string(p.name));
        EXPECT_TRUE(names.insert(p.name).second) << "twice";
        EXPECT_EQ(p.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
                  std::string_view::npos);
        EXPECT_FALSE(p.help.empty());
        EXPECT_EQ(p.help.find('\n'), std::string_view::npos);
        EXPECT_EQ(p.kind == ParameterKind::choice, !p.choices.empty());
        EXPECT_LE(p.low, p.high);
        EXPECT_EQ(find_parameter(p.name), &p);
        ParameterValues values;
        EXPECT_FALSE(values.is_set(p.name));
        EXPECT_EQ(values.has_value(p.name), p.default_value.has_value());
        EXPECT_EQ(p.default_text.empty(), !p.default_value);
        EXPECT_EQ(p.names.empty(), p.kind != ParameterKind::text) << p.name;
        EXPECT_TRUE(p.belongs_to.empty() || find_parameter(p.belongs_to)) << p.belongs_to;
        if (!p.default_value) continue;
        values.set(p.name, p.default_text, "");
        EXPECT_EQ(values.set_values().begin()->second, *p.default_value);
    }
}

// A number of the parameter's kind, within the range and different from the default.
ParameterValue another_value(const Parameter& p) {
    switch (p.kind) {
        case ParameterKind::real:
            return 0.25 * p.low + 0.75 * p.high;
        case ParameterKind::integer:
            return static_cast<int>(p.high);
        case ParameterKind::boolean:
            return p.default_value != ParameterValue(true);
        case ParameterKind::choice:
            return ParameterChoice{static_cast<int>(p.choices.size()) - 1};
        case ParameterKind::color:
        case ParameterKind::vector:
            return glm::vec3(0.1f, 0.2f, 0.3f) * static_cast<float>(p.high);
        case ParameterKind::text:
            return std::string("some text");
    }
    return 0;
}

TEST(ParameterTable, TextGivesEveryValueBack) {
    for (const Parameter& p : parameter_table()) {
        SCOPED_TRACE(std::string(p.name));
        const ParameterValue value = another_value(p);
        ParameterValues typed, read;
        typed.set_value(p.name, value);
        read.set(p.name, text_of(p, value), "");
        EXPECT_EQ(read.set_values().at(std::string(p.name)), value);
        EXPECT_EQ(typed, read);
        EXPECT_EQ(typed.text(p.name), text_of(p, value));
        typed.erase(p.name);
        EXPECT_FALSE(typed.is_set(p.name));
    }
}

// Enumerations against the names of their choices, by name, so that a change of either order fails.
TEST(ParameterTable, ChoicesAreTheEnumerations) {
    const auto number = [](std::string_view parameter, std::string_view name) {
        ParameterValues values;
        values.set(parameter, name, "");
        return values.choice(parameter);
    };
    EXPECT_EQ(number("image_light", "off"), static_cast<int>(ImageLight::off));
    EXPECT_EQ(number("image_light", "importance"), static_cast<int>(ImageLight::importance));
    EXPECT_EQ(number("image_light", "bent-normal"), static_cast<int>(ImageLight::bent_normal));
    EXPECT_EQ(number("image_light", "prefiltered"), static_cast<int>(ImageLight::prefiltered));
    EXPECT_EQ(find_parameter("image_light")->choices.size(), 4u);
    EXPECT_EQ(number("background", "environment"), static_cast<int>(BackgroundKind::environment));
    EXPECT_EQ(number("background", "color"), static_cast<int>(BackgroundKind::color));
    EXPECT_EQ(number("background", "transparent"), static_cast<int>(BackgroundKind::transparent));
    EXPECT_EQ(find_parameter("background")->choices.size(), 3u);
    EXPECT_EQ(number("normal_filter", "mips"), static_cast<int>(NormalFilter::mips));
    EXPECT_EQ(number("normal_filter", "moments"), static_cast<int>(NormalFilter::moments));
    EXPECT_EQ(number("scratch_direction", "keep"), static_cast<int>(ScratchDirection::keep));
    EXPECT_EQ(number("scratch_direction", "follow"), static_cast<int>(ScratchDirection::follow));
    const auto metals = find_parameter("metal")->choices;
    ASSERT_EQ(metals.size(), conductor_names().size() + 1);
    EXPECT_EQ(metals[0], "none");
    for (std::size_t i = 0; i < conductor_names().size(); ++i)
        EXPECT_EQ(metals[i + 1], conductor_names()[i]);
}

TEST(ParameterTable, DefaultsAreThoseOfMaterialsAndCloth) {
    const ParameterValues values;
    const Material material;
    EXPECT_EQ(static_cast<Mdf>(values.choice("mdf")), material.mdf);
    EXPECT_EQ(static_cast<Brdf>(values.choice("brdf")), material.brdf);
    EXPECT_EQ(static_cast<Method>(values.choice("method")), material.method);
    EXPECT_EQ(static_cast<NormalFilter>(values.choice("normal_filter")), material.normal_filter);
    EXPECT_EQ(values.boolean("conserve"), material.conserve);
    EXPECT_EQ(values.vec3("lafortune_c"), material.lafortune_c);
    const Cloth cloth;
    EXPECT_EQ(static_cast<float>(values.real("weave_yarns")), cloth.yarns);
    EXPECT_EQ(static_cast<float>(values.real("weave_crimp")), cloth.crimp);
    EXPECT_EQ(static_cast<float>(values.real("weave_bulge")), cloth.bulge);
    EXPECT_EQ(static_cast<float>(values.real("weave_gap")), cloth.gap);
    EXPECT_EQ(static_cast<float>(values.real("weave_fuzz")), cloth.fuzz);
    EXPECT_FLOAT_EQ(glm::radians(static_cast<float>(values.real("weave_twist"))), cloth.twist);
    // Help texts show the decimal numbers, not the nearest floats.
    EXPECT_EQ(find_parameter("weave_bulge")->default_text, "0.7");
    EXPECT_EQ(find_parameter("weave_twist")->default_text, "20");
    EXPECT_EQ(find_parameter("background_color")->default_text, "0.05,0.05,0.05");
}

TEST(ParameterValues, KeepsWhatWasSet) {
    ParameterValues values;
    values.set("alpha_x", "0.25", "--alpha-x");
    values.set("exposure", "+1.5", "");
    values.set("width", "640", "");
    values.set("conserve", "on", "");
    values.set("method", "rotate-arc", "");
    values.set("camera_position", "1,-2.5,3e1", "");
    values.set("normal_map", "scratches.png", "");
    EXPECT_DOUBLE_EQ(values.real("alpha_x"), 0.25);
    EXPECT_DOUBLE_EQ(values.real("exposure"), 1.5);
    EXPECT_EQ(values.integer("width"), 640);
    EXPECT_TRUE(values.boolean("conserve"));
    EXPECT_EQ(static_cast<Method>(values.choice("method")), Method::rotate_arc);
    EXPECT_EQ(values.vec3("camera_position"), glm::vec3(1.0f, -2.5f, 30.0f));
    EXPECT_EQ(values.text("normal_map"), "scratches.png");
    EXPECT_EQ(values.set_values().size(), 7u);
}

TEST(ParameterValues, ColorsAreLinearOrSrgb) {
    ParameterValues values;
    values.set("base_color", "0.1,0.2,1", "");
    EXPECT_EQ(values.vec3("base_color"), glm::vec3(0.1f, 0.2f, 1.0f));
    values.set("base_color", "#80ff00", "");
    // IEC 61966-2-1 above the linear segment.
    EXPECT_NEAR(values.vec3("base_color").r, std::pow((128.0 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
    EXPECT_FLOAT_EQ(values.vec3("base_color").g, 1.0f);
    EXPECT_FLOAT_EQ(values.vec3("base_color").b, 0.0f);
}

TEST(ParameterValues, ErrorsNameAllFourThings) {
    ParameterValues values;
    const auto line = [&](const char* name, const char* text, const char* where) {
        return error_line<UsageError>([&] { values.set(name, text, where); });
    };
    EXPECT_EQ(line("alpha_x", "7", "--alpha-x"),
              "--alpha-x: expected a number from 0.001 to 1.5, found " + shown("7"));
    EXPECT_EQ(line("alpha_x", "7", ""),
              "--alpha-x: expected a number from 0.001 to 1.5, found " + shown("7"));
    EXPECT_EQ(
        line("alpha_x", "7", "a.json: materials.m.alpha_x"),
        "a.json: materials.m.alpha_x: expected a number from 0.001 to 1.5, found " + shown("7"));
    EXPECT_EQ(line("alpha_x", "7", "preset gold"),
              "preset gold: alpha_x: expected a number from 0.001 to 1.5, found " + shown("7"));
    EXPECT_NE(line("method", "folow-grain", "").find("did you mean 'follow-grain'?"),
              std::string::npos);
    EXPECT_EQ(line("alfa_x", "1", "a.json"),
              "a.json: unknown parameter " + shown("alfa_x") + "; did you mean 'alpha_x'?");
    EXPECT_EQ(line("colour of the sky", "1", ""),
              "unknown parameter " + shown("colour of the sky"));
    EXPECT_TRUE(values.set_values().empty()) << "a refused value was kept";
}

TEST(ParameterValues, RefusesEverythingThatIsNotTheValue) {
    const std::pair<const char*, std::vector<std::string>> bad[] = {
        {"alpha_x",
         {"", " 0.1", "0.1 ", "0,1", "nan", "inf", "-inf", "1e999", "0x1", "+-1", "--1", "+", "1f",
          "0.0009", "1.6", std::string("0.1\0", 4), std::string(100000, '1')}},
        {"width", {"", "0", "1.0", "1e2", "16385", "99999999999", "-5", "+5", "12px"}},
        {"conserve", {"", "maybe", "TRUE ", "2"}},
        {"mdf", {"", "GGX ", "Ggx2", "0"}},
        {"base_color",
         {"", "1", "1,1", "1,1,1,1", "1,,1", "2,0,0", "#12345", "#1234567", "#12345g", "#-12345",
          "#+12345", "nan,0,0", "0.1, 0.2,0.3"}},
        {"camera_target", {"#ffffff", "1,2", "1e7,0,0", "inf,0,0"}},
        {"normal_map", {"", std::string("a\0b", 3)}},
    };
    for (const auto& [name, texts] : bad) {
        for (const std::string& text : texts) {
            ParameterValues values;
            EXPECT_THROW(values.set(name, text, "here"), UsageError) << name << " " << text;
        }
    }
}

TEST(ParameterValues, AskingForWhatNobodySetIsAnError) {
    const ParameterValues values;
    EXPECT_THROW((void)values.real("alpha_x"), UsageError);
    EXPECT_THROW((void)values.real("no_such"), UsageError);
}

TEST(ParameterValues, TheLaterWinsAndReplacesOtherWaysOfSayingIt) {
    ParameterValues file, flags;
    file.set("alpha_x", "0.1", "");
    file.set("alpha_y", "0.3", "");
    file.set("width", "640", "");
    file.set("height", "480", "");
    flags.set("e_x", "100", "");
    flags.set("width", "320", "");
    file.merge(flags);
    EXPECT_FALSE(file.is_set("alpha_x"));
    EXPECT_FALSE(file.is_set("alpha_y"));
    EXPECT_DOUBLE_EQ(file.real("e_x"), 100.0);
    EXPECT_EQ(file.integer("width"), 320);
    EXPECT_EQ(file.integer("height"), 480);
}

TEST(ParameterValues, TakesTypedValues) {
    ParameterValues values;
    values.set_value("alpha_x", 0.25);
    values.set_value("roughness", 1);  // a real parameter accepts a whole number
    values.set_value("width", 640);
    values.set_value("conserve", true);
    values.set_value("mdf", ParameterChoice{static_cast<int>(Mdf::ward)});
    values.set_value("base_color", glm::vec3(0.1f, 0.2f, 1.0f));
    values.set_value("normal_map", std::string("flat.png"));
    EXPECT_EQ(values.real("alpha_x"), 0.25);
    EXPECT_EQ(values.real("roughness"), 1.0);
    EXPECT_EQ(values.real("width"), 640.0);
    EXPECT_EQ(values.text("mdf"), "ward");
    EXPECT_EQ(values.text("base_color"), "0.1,0.2,1");
    const std::pair<const char*, ParameterValue> bad[] = {
        {"alpha_x", 7.0},
        {"alpha_x", std::numeric_limits<double>::quiet_NaN()},
        {"alpha_x", true},
        {"alpha_x", std::string("0.2")},
        {"width", 640.0},
        {"width", 0},
        {"conserve", 1},
        {"mdf", ParameterChoice{4}},
        {"mdf", ParameterChoice{-1}},
        {"base_color", glm::vec3(2.0f)},
        {"base_color", glm::vec3(std::numeric_limits<float>::infinity(), 0.0f, 0.0f)},
        {"normal_map", std::string()},
        {"no_such", 1}};
    for (const auto& [name, value] : bad) {
        ParameterValues refused;
        EXPECT_THROW(refused.set_value(name, value), UsageError) << name << value.index();
        EXPECT_TRUE(refused.set_values().empty());
    }
    EXPECT_EQ(error_line<UsageError>([&] { values.set_value("width", 0, "a.json: width"); }),
              "a.json: width: expected a whole number from 1 to 16384, found " + shown("0"));
}

TEST(ParameterValues, AskingForAnotherKindIsAClearError) {
    const ParameterValues values;
    EXPECT_EQ(error_line([&] { (void)values.real("mdf"); }),
              "parameter: mdf: expected a number, found a choice of names");
    EXPECT_EQ(error_line([&] { (void)values.integer("alpha_x"); }),
              "parameter: alpha_x: expected a whole number, found a number");
    EXPECT_EQ(error_line([&] { (void)values.vec3("width"); }),
              "parameter: width: expected a vector, found a whole number");
    EXPECT_THROW((void)values.boolean("mdf"), Error);
    EXPECT_THROW((void)values.choice("width"), Error);
}

TEST(ParameterValues, ModelsThatAreNotDrawnSayWhatIs) {
    ParameterValues values;
    const auto line = [&](const char* text) {
        return error_line<UsageError>([&] { values.set("brdf", text, "--brdf"); });
    };
    EXPECT_NE(line("he").find("found " + shown("he") +
                              " (brdf eval computes it, no picture: cook-torrance is nearest)"),
              std::string::npos)
        << line("he");
    EXPECT_NE(line("ashikhmin-premoze-shirley").find("microfacet with mdf ashikhmin-shirley"),
              std::string::npos);
    EXPECT_NE(line("ggx").find("microfacet with mdf ggx"), std::string::npos);
}

TEST(Names, NearestIsWhatWasMeant) {
    EXPECT_EQ(nearest_name(mdf_names(), "beckman"), "beckmann");
    EXPECT_EQ(nearest_name(mdf_names(), "GGX"), "ggx");
    EXPECT_EQ(nearest_name(brdf_names(), "ward_gdm"), "ward-gmd");
    EXPECT_EQ(nearest_name(method_names(), "smooth"), "deform-smooth");
    EXPECT_EQ(nearest_name(method_names(), "rotate-arch"), "rotate-arc");
    EXPECT_EQ(nearest_name(method_names(), "banana"), "");
    EXPECT_EQ(nearest_name(method_names(), ""), "");
    EXPECT_EQ(nearest_name(method_names(), std::string(1000000, 'r')), "");
    EXPECT_EQ(nearest_name({}, "ggx"), "");
}

TEST(Names, RoundTripAndError) {
    for (std::size_t i = 0; i < method_names().size(); ++i) {
        const auto method = static_cast<Method>(i);
        EXPECT_EQ(index_of_name(method_names(), name_of(method), "method", ""),
                  static_cast<int>(i));
    }
    EXPECT_EQ(name_of(Mdf::beckmann), "beckmann");
    EXPECT_EQ(name_of(Brdf::ward_gmd), "ward-gmd");
    EXPECT_EQ(error_line<UsageError>([] { index_of_name(mdf_names(), "gxx", "mdf", "--mdf"); }),
              "--mdf: unknown mdf " + shown("gxx") +
                  "; did you mean 'ggx'? known: ashikhmin-shirley ward "
                  "beckmann ggx");
}

}  // namespace
}  // namespace burnish
