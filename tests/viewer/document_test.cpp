// Documents: parameters set as people set them, cameras, and what is refused.
#include "viewer/document/document.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "burnish/error.hpp"
#include "support/test_folder.hpp"

namespace burnish::viewer {
namespace {

using test::error_line;

TEST(ViewerDocument, SettingAParameterTakesThePlaceOfOtherWaysOfSayingIt) {
    Document document;
    set_parameter(document, "e_x", 100.0);
    set_parameter(document, "alpha_x", 0.2);
    EXPECT_FALSE(document.values.is_set("e_x"));
    set_parameter_text(document, "normal_map", "builtin:bumps");
    set_parameter_text(document, "weave", "plain");
    EXPECT_FALSE(document.values.is_set("normal_map"));
    set_parameter(document, "weave_gap", 0.3);
    set_parameter_text(document, "weave", "none");
    EXPECT_FALSE(document.values.is_set("weave_gap")) << "it belongs to a weave";
    set_parameter_text(document, "scratch", "brushed");
    set_parameter_text(document, "weave", "none");
    EXPECT_EQ(document.values.text("scratch"), "brushed") << "no weave takes its place";
}

TEST(ViewerDocument, AFilmOfOxideStaysOnMetalsThatTakeOne) {
    Document document;
    set_parameter_text(document, "metal", "titanium");
    set_parameter(document, "oxide", 50.0);
    set_parameter_text(document, "metal", "iron");
    EXPECT_EQ(document.values.real("oxide"), 50.0);
    set_parameter_text(document, "metal", "gold");
    EXPECT_FALSE(document.values.is_set("oxide"));
    set_parameter_text(document, "metal", "iron");
    set_parameter(document, "oxide", 50.0);
    set_parameter_text(document, "metal", "none");
    EXPECT_FALSE(document.values.is_set("oxide"));
}

TEST(ViewerDocument, AMaterialKeepsItsOwnValueUntilAllAreSet) {
    Document document;
    set_parameter(document, "alpha_x", 0.2);
    set_parameter(document, "alpha_x", 0.3, 1);
    EXPECT_EQ(document.material_values.at(1).real("alpha_x"), 0.3);
    EXPECT_EQ(document.values.real("alpha_x"), 0.2);
    set_parameter(document, "alpha_x", 0.4);
    EXPECT_TRUE(document.material_values.empty());
    set_parameter(document, "alpha_x", 0.3, 1);
    unset_parameter(document, "alpha_x", 1);
    EXPECT_TRUE(document.material_values.empty());
    unset_parameter(document, "alpha_x");
    EXPECT_EQ(document, Document{});
}

TEST(ViewerDocument, AnEditThatIsRefusedChangesNothing) {
    Document document;
    set_parameter(document, "alpha_x", 0.2);
    const Document before = document;
    EXPECT_NE(error_line<UsageError>([&] {
                  set_parameter(document, "alpha_x", 7.0);
              }).find("a number from 0.001 to 1.5, found \"7\""),
              std::string::npos);
    EXPECT_NE(error_line<UsageError>([&] {
                  set_parameter(document, "alphax", 0.2);
              }).find("did you mean 'alpha_x'?"),
              std::string::npos);
    EXPECT_NE(error_line<UsageError>([&] {
                  set_parameter(document, "exposure", 1.0, 0);
              }).find("a parameter of materials"),
              std::string::npos);
    error_line<UsageError>([&] { unset_parameter(document, "alphax"); });
    error_line<UsageError>([&] { set_camera(document, {1, 2, 3}, {1, 2, 3}, 30.0); });
    error_line<UsageError>([&] { set_camera(document, {1, 2, 3}, {1, 2, 4}, 0.5); });
    EXPECT_EQ(document.values, before.values);
}

TEST(ViewerDocument, TheCameraIsPlacedByThreeValuesAlone) {
    Document document;
    set_parameter(document, "camera_zoom", 2.0);
    set_parameter(document, "camera_index", 3);
    set_camera(document, {0.1f, 0.2f, 3.3f}, {0, 0.5f, 0}, 42.5);
    EXPECT_EQ(document.values.set_values().size(), 3u);
    EXPECT_EQ(document.values.vec3("camera_position"), glm::vec3(0.1f, 0.2f, 3.3f));
    EXPECT_EQ(document.values.real("camera_fov"), 42.5);
    unset_camera(document);
    EXPECT_EQ(document, Document{});
}

TEST(ViewerDocument, LightsThatNoSceneFileCouldHoldAreRefused) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Light sound;
    sound.type = LightType::spot;
    sound.inner_cone = 0.1f;
    sound.outer_cone = 0.5f;
    require_valid(sound);
    const auto refused = [&](auto change) {
        Light light = sound;
        change(light);
        error_line<UsageError>([&] { require_valid(light); });
    };
    refused([&](Light& l) { l.color.g = 1.5f; });
    refused([&](Light& l) { l.color.g = nan; });
    refused([&](Light& l) { l.intensity = -1.0f; });
    refused([&](Light& l) { l.intensity = nan; });
    refused([&](Light& l) { l.direction = {0, 0, 2}; });
    refused([&](Light& l) { l.direction = {0, 0, 0}; });
    refused([&](Light& l) { l.position.x = 2e6f; });
    refused([&](Light& l) { l.range = -1.0f; });
    refused([&](Light& l) { l.inner_cone = 0.6f; });
    refused([&](Light& l) { l.outer_cone = 1.6f; });
}

TEST(ViewerDocument, CompareSettingsAndBookmarksHaveRanges) {
    require_valid(Compare{});
    const auto refused = [](Compare compare) {
        error_line<UsageError>([&] { require_valid(compare); });
    };
    refused({.methods = {Method::none}});
    refused({.methods = {Method::none, Method::none}});
    refused({.dividers = {0.2, 0.4}});
    refused({.methods = {Method::none, Method::normal_map, Method::follow_grain},
             .dividers = {0.5, 0.4}});
    refused({.dividers = {std::nan("")}});
    refused({.gain = 0.0});
    require_valid(Bookmark{"front"});
    error_line<UsageError>([] { require_valid(Bookmark{}); });
    error_line<UsageError>([] { require_valid(Bookmark{"in itself", {1, 1, 1}, {1, 1, 1}}); });
}

}  // namespace
}  // namespace burnish::viewer
