// Roles of maps, told by the names that libraries of materials give their files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

// The roles that end the list are packed: each channel holds a property (packing_of).
enum class MapRole {
    base_color,
    normal,
    normal_directx,
    roughness,
    glossiness,
    metallic,
    occlusion,
    anisotropy,
    height,
    emissive,
    opacity,
    orm,
    mask_map,
    metallic_roughness,
    metallic_smoothness,
    occlusion_roughness
};
inline constexpr std::size_t kMapRoles = 16;
std::string_view map_role_name(MapRole role);  // "base color"

// The channels of a packed map, 0 red to 3 alpha; -1: it does not hold the property.
struct MapPacking {
    int occlusion = -1;
    int roughness = -1;
    int smoothness = -1;  // 1 - roughness
    int metallic = -1;
};

// None: the role is of one property. Of two packed maps of a folder the first in this order is read.
std::optional<MapPacking> packing_of(MapRole role);
inline constexpr MapRole kPackedRoles[] = {
    MapRole::orm, MapRole::mask_map, MapRole::metallic_roughness, MapRole::metallic_smoothness,
    MapRole::occlusion_roughness};

// The role that the name of a picture states: "Metal032_2K_NormalGL.jpg", "rust_arm_4k.exr",
// "Door_BaseColor.png"; none: no role. Normal maps of names that start with "T_" and do not say
// otherwise are DirectX's, as Unreal's are.
std::optional<MapRole> map_role_of(const std::filesystem::path& file);

// The words of a file's name, without its ending, in lower case: separated by other characters than
// letters and digits, and where a small letter is followed by a capital.
std::vector<std::string> words_of_name(const std::filesystem::path& file);

// Whether a word is a resolution or the number of a tile: "2k", "4096", "16bit", "1001".
bool is_size_word(const std::string& word);

}  // namespace burnish
