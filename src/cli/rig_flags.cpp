#include "cli/rig_flags.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <cstdio>

#include "burnish/error.hpp"
#include "core/text.hpp"

namespace burnish::cli {
namespace {

Vec3d parse_vector(const std::string& text, const char* flag) {
    Vec3d v{};
    char rest = 0;
    if (std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &v[0], &v[1], &v[2], &rest) != 3)
        throw UsageError(flag, "", "X,Y,Z", shown(text));
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (!(length > 1e-9) || !std::isfinite(length) || !(v[2] > 0.0))
        throw UsageError(flag, "", "a direction from the sample with Z above 0", shown(text));
    return {v[0] / length, v[1] / length, v[2] / length};
}

}  // namespace

RigResponse parse_response(const std::string& text, const char* flag) {
    constexpr std::array<std::string_view, 2> kResponses = {"linear", "srgb"};
    return static_cast<RigResponse>(index_of_name(kResponses, text, "response", flag));
}

void RigFlags::add_to(CLI::App& command) {
    command.add_option("--response", response_, "linear or srgb, in place of the file's")
        ->type_name("NAME");
    command.add_option("--camera", camera_, "direction of the camera, in place of the file's")
        ->type_name("X,Y,Z");
    command.add_flag("--flip-y", flip_y_, "the file's y points down");
    command
        .add_option("--intensity", intensity_,
                    "multiplies the intensities of all lights: states them in the pictures' unit, "
                    "where the file cannot")
        ->type_name("F");
    command.add_flag("--by-order", by_order_,
                     "the pictures beside the rig's file are those of its lights, in the order of "
                     "the numbers in their names");
    command.add_flag("--skip-missing", skip_missing_,
                     "leave out lights whose pictures are missing");
    command.add_option("--width-mm", width_mm_, "of the sample, where the file cannot say")
        ->type_name("MM");
}

void RigFlags::add_to_new(CLI::App& command) {
    command
        .add_option("--response", response_,
                    "linear or srgb: what the pictures hold (default: by their ending)")
        ->type_name("NAME");
    command.add_option("--camera", camera_, "direction of the camera (default 0,0,1)")
        ->type_name("X,Y,Z");
    command.add_option("--width-mm", width_mm_, "of the sample (default: 1 mm a pixel)")
        ->type_name("MM");
}

RigOverrides RigFlags::overrides() const {
    RigOverrides out;
    out.flip_y = flip_y_;
    out.by_order = by_order_;
    out.skip_missing = skip_missing_;
    if (!response_.empty()) out.response = parse_response(response_, "--response");
    if (!camera_.empty()) out.camera = RigPlace{false, parse_vector(camera_, "--camera")};
    if (width_mm_ != 0.0) {
        if (!(width_mm_ > 0.0 && width_mm_ <= 1e6))
            throw UsageError("--width-mm", "", "above 0, at most 1000000",
                             fmt::format("{}", width_mm_));
        out.width_mm = width_mm_;
    }
    if (intensity_ != 0.0) {
        if (!(intensity_ >= 1e-15 &&
              intensity_ <= 1e15))  // times those of a file: within its limits
            throw UsageError("--intensity", "", "1e-15 to 1e15", fmt::format("{}", intensity_));
        out.intensity = intensity_;
    }
    return out;
}

}  // namespace burnish::cli
