// Roles of maps, told by the names that libraries of materials give their files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

// orm: occlusion in red, roughness in green, metallic in blue. metallic_roughness: the same without
// occlusion, as in glTF.
enum class MapRole {
    base_color,
    normal,
    normal_directx,
    roughness,
    glossiness,
    metallic,
    occlusion,
    orm,
    metallic_roughness,
    anisotropy,
    height,
    emissive,
    opacity
};
inline constexpr std::size_t kMapRoles = 13;
std::string_view map_role_name(MapRole role);  // "base color"

// The role that the name of a picture states: "Metal032_2K_NormalGL.jpg", "rust_arm_4k.exr",
// "Door_BaseColor.png"; none: no role.
std::optional<MapRole> map_role_of(const std::filesystem::path& file);

// The words of a file's name, without its ending, in lower case: separated by other characters than
// letters and digits, and where a small letter is followed by a capital.
std::vector<std::string> words_of_name(const std::filesystem::path& file);

// Whether a word is a resolution or the number of a tile: "2k", "4096", "16bit", "1001".
bool is_size_word(const std::string& word);

}  // namespace burnish
