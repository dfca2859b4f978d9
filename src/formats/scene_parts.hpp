// Parts of a scene file that are read one at a time: lights, places of objects, names.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>

#include "burnish/scene.hpp"
#include "burnish/scene_file.hpp"
#include "formats/json_text.hpp"

namespace burnish {

// Throws Error for a name that is not in `known`; suggests the nearest one. `kind` says what was
// expected: "a type of light".
[[noreturn]] void refuse_name(const JsonPlace& place, std::span<const std::string_view> known,
                              const std::string& kind);

// Whether the value `name` of the text parameter `key` is a file name, not that of a preset.
bool names_file(std::string_view key, std::string_view name);

// `v` of unit length. A vector that is unit to the rounding of floats stays as it is: what was written
// from a scene is read back identically.
glm::vec3 unit(const glm::vec3& v);

// `folder`: where file names are relative to.
Light read_light(const JsonPlace& place, const std::filesystem::path& folder);

// Translation, rotation and scale of the object at `place`, those of the default where it names none.
void read_placing(const JsonPlace& place, SceneFile::Object& object);
// Scales first, then rotates about x, y and z, then moves.
glm::mat4 placing_of(const SceneFile::Object& object);

}  // namespace burnish
