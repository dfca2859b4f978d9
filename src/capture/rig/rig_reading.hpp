// What the readers of the three rig formats share. Private to src/capture/rig*.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "burnish/rig.hpp"

namespace burnish::rig_reading {

// Ten thousand lights with every key spelled out take four megabytes.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;
constexpr std::size_t kMostLights = 10000;
constexpr double kFarthest = 1e6;                     // mm; a kilometre is far away for all
constexpr double kSmallest = 1e-3, kLargest = 1e5;    // mm, sides of a sample
constexpr double kFaintest = 1e-9, kBrightest = 1e9;  // intensities, exposures
constexpr double kShortest = 1e-12;                   // no direction is meant below
constexpr double kNearlyUnit = 0.02;                  // what rounding to two digits may do

double length(const Vec3d& v);
Vec3d normalized(const Vec3d& v);  // what is unit already stays bit for bit

// Throws unless `name` can be a file's name: no control characters.
void require_name(const std::string& file, const std::string& where, const std::string& name);
[[noreturn]] void fail_missing(const std::string& file, const std::string& where,
                               const std::string& name);
bool is_there(const std::filesystem::path& path);
std::string lower_extension(const std::filesystem::path& path);

// Each fills lights, camera, sizes and what else its format knows; read_rig does the rest.
struct Request {
    const std::filesystem::path& path;
    std::string_view text;
    bool needs_images;
    bool has_camera;  // the caller gives one
};
struct Reading {
    Rig rig;
    std::optional<RigResponse> response;  // where the file says it
};
Reading read_lp(const Request& request);
Reading read_dome(const Request& request);
Reading read_rig_json(const Request& request);

}  // namespace burnish::rig_reading
