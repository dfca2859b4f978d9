#include "jobs/info/info_rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>

#include "burnish/coverage.hpp"
#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/rig.hpp"
#include "core/text.hpp"
#include "jobs/info/info_scene.hpp"

namespace burnish {

namespace {

std::string describe_lights(const Rig& rig, const RigCoverage& coverage) {
    const auto near = static_cast<std::size_t>(
        std::count_if(rig.lights.begin(), rig.lights.end(),
                      [](const RigLight& light) { return light.place.near; }));
    const std::string kind = near == 0                   ? "far away"
                             : near == rig.lights.size() ? "near"
                                                         : fmt::format("{} of them near", near);
    const std::string lowest = fmt::format("{:.1f}", coverage.lowest_light);
    const std::string highest = fmt::format("{:.1f}", coverage.highest_light);
    return fmt::format("  {}, {}, {} deg over the sample, {:.0f} deg of azimuth{}\n",
                       plural(rig.lights.size(), "light"), kind,
                       lowest == highest ? lowest : lowest + " to " + highest,
                       coverage.azimuth_spread,
                       rig.intensity_stated ? "" : ", intensities not stated");
}

std::string describe_camera(const Rig& rig, const RigCoverage& coverage) {
    const bool own = std::all_of(rig.lights.begin(), rig.lights.end(),
                                 [](const RigLight& light) { return light.camera.has_value(); });
    const Vec3d& at = rig.camera.at;
    const std::string place =
        own ? std::string("one for each light")
            : fmt::format("{} ({:.4g}, {:.4g}, {:.4g}){}", rig.camera.near ? "at" : "towards",
                          at[0], at[1], at[2], rig.camera.near ? " mm" : "");
    return fmt::format("  camera {}, {:.1f} deg from the normal\n", place,
                       coverage.center.theta_view);
}

bool is_raw(const Rig& rig) {
    return std::any_of(rig.lights.begin(), rig.lights.end(), [](const RigLight& light) {
        return std::any_of(light.images.begin(), light.images.end(),
                           [](const RigExposure& e) { return is_raw_camera_name(e.image); });
    });
}

std::string describe_pictures(const Rig& rig) {
    std::size_t all = 0, there = 0;
    std::string missing;  // the first missing picture
    for (const RigLight& light : rig.lights)
        for (const RigExposure& exposure : light.images) {
            std::error_code error;
            ++all;
            if (std::filesystem::is_regular_file(exposure.image, error)) {
                ++there;
            } else if (missing.empty()) {
                missing = fmt::format("{}: {}", light.where, shown(exposure.image.string()));
            }
        }
    if (all == 0) return "  no pictures\n";
    return fmt::format("  {}{}, {}\n", plural(all, "picture"),
                       there == all ? "" : fmt::format(", {} missing ({})", all - there, missing),
                       rig.response == RigResponse::srgb ? "sRGB"
                       : is_raw(rig)                     ? "linear (raw files)"
                                                         : "linear");
}

// "12.3", or "12.3 to 14.5" if the points differ.
std::string range(std::span<const PointCoverage> points, double PointCoverage::*member,
                  double factor, int digits) {
    double low = points.front().*member, high = low;
    for (const PointCoverage& point : points) {
        low = std::min(low, point.*member);
        high = std::max(high, point.*member);
    }
    const std::string from = fmt::format("{:.{}f}", low * factor, digits);
    const std::string to = fmt::format("{:.{}f}", high * factor, digits);
    return from == to ? from : from + " to " + to;
}

std::string describe_points(std::string_view where, std::span<const PointCoverage> points) {
    using P = PointCoverage;
    return fmt::format(
        "  {}: half vectors tilt up to {} deg (at most {}), {} deg apart; they cover {} % of the "
        "hemisphere, {} % when turned about the normal\n",
        where, range(points, &P::theta_h_max, 1, 1), range(points, &P::theta_h_limit, 1, 1),
        range(points, &P::spacing, 1, 1), range(points, &P::covered, 100, 0),
        range(points, &P::covered_turned, 100, 0));
}

}  // namespace

std::string describe_rig(const std::string& path, const RigOverrides& overrides) {
    const Rig rig = read_rig(path, false, overrides);
    const RigCoverage coverage = rig_coverage(rig);
    std::string text = fmt::format(
        "{}: rig, {}\n", path,
        rig.width_mm > 0 ? fmt::format("sample {:g} x {:g} mm", rig.width_mm, rig.height_mm)
                         : std::string("size of the sample not known"));
    text += describe_pictures(rig);
    if (!rig.missing.empty()) text += "  missing: " + rig.missing + "\n";
    text += describe_camera(rig, coverage);
    text += describe_lights(rig, coverage);
    text += describe_points("centre", {&coverage.center, 1});
    if (!coverage.corners.empty()) text += describe_points("corners", coverage.corners);
    if (coverage.narrowest_ggx > 0)
        text += fmt::format(
            "  narrowest lobe these lights sample: alpha {:.3f} (ggx), {:.3f} "
            "(beckmann)\n",
            coverage.narrowest_ggx, coverage.narrowest_beckmann);
    for (const std::string& line : coverage.diagnosis) text += "  " + line + "\n";
    for (const std::string& warning : rig.warnings) text += "  warning: " + warning + "\n";
    return text;
}

}  // namespace burnish
