// A folder of maps of one surface, told by the names that libraries of materials give their files.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

// orm: occlusion in red, roughness in green, metallic in blue.
enum class MapRole {
    base_color,
    normal,
    normal_directx,
    roughness,
    glossiness,
    metallic,
    occlusion,
    orm,
    anisotropy,
    height,
    emissive,
    opacity
};
inline constexpr std::size_t kMapRoles = 12;
std::string_view map_role_name(MapRole role);  // "base color"

struct MapSet {
    std::map<MapRole, std::filesystem::path> files;  // of normal and normal_directx one
    std::vector<std::string>
        notes;  // what was taken for what, and what was passed over: a line each
};

// The role that the name of a picture states: "Metal032_2K_NormalGL.jpg", "rust_arm_4k.exr",
// "Door_BaseColor.png"; none: no role.
std::optional<MapRole> map_role_of(const std::filesystem::path& file);

// Throws UsageError where `folder` is none or holds no map, and Error where two files have the same
// role: both are named, none is guessed. The reasons why one of two roles is taken are in `notes`.
MapSet find_map_set(const std::filesystem::path& folder);

}  // namespace burnish
