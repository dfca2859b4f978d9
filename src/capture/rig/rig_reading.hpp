// Declarations shared by the readers of the three rig formats. Private to src/capture/rig*.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "burnish/rig.hpp"

namespace burnish::rig_reading {

// Ten thousand lights with every key spelled out take four megabytes.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;
constexpr std::size_t kMostLights = 10000;
constexpr double kFarthest = 1e6;                     // mm; a light a kilometer away is at infinity
constexpr double kSmallest = 1e-3, kLargest = 1e5;    // mm, sides of a sample
constexpr double kFaintest = 1e-9, kBrightest = 1e9;  // intensities, exposures
constexpr double kShortest = 1e-12;                   // length of the shortest valid direction
constexpr double kNearlyUnit = 0.02;                  // error of a length with two digits

double length(const Vec3d& v);
Vec3d normalized(const Vec3d& v);  // a unit vector stays bit for bit

// Throws unless `name` can be a file's name: no control characters.
void require_name(const std::string& file, const std::string& where, const std::string& name);
[[noreturn]] void fail_missing(const std::string& file, const std::string& where,
                               const std::string& name);
bool is_there(const std::filesystem::path& path);
std::string lower_extension(const std::filesystem::path& path);

// Each reader fills lights, camera, sizes and its format's other members; read_rig does the rest.
struct Request {
    const std::filesystem::path& path;
    std::string_view text;
    bool needs_images;
    bool has_camera;  // the caller gives one
};
struct Reading {
    Rig rig;
    std::optional<RigResponse> response;  // if the file states it
};
Reading read_lp(const Request& request);
Reading read_dome(const Request& request);
Reading read_rig_json(const Request& request);

}  // namespace burnish::rig_reading
