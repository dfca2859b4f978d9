// Declarations shared by the readers of the three rig formats. Private to src/capture/rig*.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "burnish/rig.hpp"
#include "capture/rig/rig_pictures.hpp"

namespace burnish::rig_reading {

// Ten thousand lights with every key spelled out take four megabytes.
constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;
constexpr std::size_t kMostLights = 10000;
constexpr double kFarthest = 1e6;                     // mm; a light a kilometer away is at infinity
constexpr double kSmallest = 1e-3, kLargest = 1e5;    // mm, sides of a sample
constexpr double kFaintest = 1e-9, kBrightest = 1e9;  // exposures, corrections of lights
// Intensities: in mm they are a hundred thousand times the values of pictures (light_level.hpp).
constexpr double kFaintestLight = 1e-24, kBrightestLight = 1e24;
constexpr double kShortest = 1e-12;   // length of the shortest valid direction
constexpr double kNearlyUnit = 0.02;  // error of a length with two digits

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
    bool by_order;    // pictures are taken by order afterwards: names are not looked for
    PictureFinder& pictures;

    // A picture of a light, as `where` names it. Throws for a name that no file can have.
    std::filesystem::path picture(const std::string& where, const std::string& name) const;
};
struct Reading {
    Rig rig;
    std::optional<RigResponse> response;  // if the file states it
};
Reading read_lp(const Request& request);
Reading read_dome(const Request& request);
Reading read_rig_json(const Request& request);

// Warns of a sample, of lights and of cameras whose lengths look as if they were in another unit than
// millimeters, and of lights whose intensities have two units.
void warn_of_scale(Rig& rig);

}  // namespace burnish::rig_reading
