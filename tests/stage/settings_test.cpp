// Render settings agree with the parameter table.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "burnish/stage.hpp"

namespace burnish {
namespace {

TEST(RenderSettings, DefaultsAreThoseOfTheTable) {
    const ParameterValues none;
    EXPECT_EQ(render_settings(none), RenderSettings{});
    const Stage stage;
    EXPECT_EQ(static_cast<ToneMap>(none.choice("tone_map")), stage.tone_map);
    EXPECT_EQ(none.real("exposure"), stage.exposure_ev);
}

// A value at the other end of a parameter's range, different from the default.
ParameterValue another_value(const Parameter& p) {
    switch (p.kind) {
        case ParameterKind::integer:
            return static_cast<int>(p.high);
        case ParameterKind::boolean:
            return p.default_value != ParameterValue(true);
        case ParameterKind::choice:
            return ParameterChoice{static_cast<int>(p.choices.size()) - 1};
        case ParameterKind::color:
            return glm::vec3(0.5f);
        default:
            return p.high;
    }
}

TEST(RenderSettings, EveryParameterOfThePictureGoesIn) {
    int counted = 0;
    for (const Parameter& p : parameter_table()) {
        if (p.group != ParameterGroup::render && p.group != ParameterGroup::environment) continue;
        // Members of Stage, and what a file is written with.
        constexpr std::string_view kElsewhere[] = {"exposure", "tone_map", "robust_mean",
                                                   "bit_depth", "dither"};
        if (std::ranges::find(kElsewhere, p.name) != std::end(kElsewhere)) continue;
        ParameterValues values;
        values.set_value(p.name, another_value(p));
        EXPECT_NE(render_settings(values), RenderSettings{}) << p.name;
        ++counted;
    }
    EXPECT_EQ(counted, 16);
}

}  // namespace
}  // namespace burnish
