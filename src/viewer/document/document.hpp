// The document of the viewer: everything that undo takes back and that a saved scene keeps.
//
// Threads and lifetime: plain values; copies are independent, and any number of threads may read
// one.
#pragma once

#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"
#include "burnish/shading_names.hpp"

namespace burnish::viewer {

// A place of the camera that a person has named.
struct Bookmark {
    std::string name;             // not empty
    glm::vec3 position{0, 0, 3};  // world space, meters
    glm::vec3 target{0};          // world space, meters
    double fov_deg = 30.0;        // vertical, 1 to 170
    bool operator==(const Bookmark&) const = default;
};

enum class CompareMode {
    off,
    split,       // side by side, with draggable dividers
    blink,       // one after the other
    difference,  // signed difference of the second from the first
    flip         // perceived difference: FLIP
};
std::span<const std::string_view> compare_mode_names();  // in the order of the enumeration

inline constexpr std::size_t kLeastCompared = 2, kMostCompared = 4;

// A comparison of two materials on the same objects.
struct MaterialPair {
    int material = 0;  // of the objects; index into Scene::materials
    // What they have in the second picture: "#2", that material of the scene, or a file that `opened` puts
    // onto a material.
    std::string other;
    bool operator==(const MaterialPair&) const = default;
};
// The index that "#2" says; none for a file.
std::optional<int> scene_material_of(std::string_view other);

struct Compare {
    CompareMode mode = CompareMode::off;
    // 2 to 4 different methods, in the order of the pictures.
    std::vector<Method> methods{Method::normal_map, Method::follow_grain};
    // Places of the dividers of a split in parts of the picture's width, each in [0, 1], ascending,
    // one fewer than methods; empty: evenly spaced.
    std::vector<double> dividers{};
    double gain = 4.0;                        // of the signed difference, 0.01 to 1000
    std::optional<MaterialPair> materials{};  // compared in place of methods
    double middle =
        0.5;  // place of the divider between two materials or before and after, in [0, 1]
    bool operator==(const Compare&) const = default;
};

struct Document {
    // Model, scene file or builtin:<name>, as in StageRequest; "": nothing is open.
    std::string input{};
    // As in StageRequest: "": the scene file's, else builtin:studio; "none".
    std::string environment{};
    std::optional<std::vector<Light>> lights{};  // none: those of the input
    std::set<int> dark{};                        // indices of lights that are switched off
    // Over all materials, and of the groups render, camera, environment and mesh: what flags are to
    // `burnish render`. A camera that was moved is camera_position, camera_target and camera_fov.
    ParameterValues values{};
    // Over `values`, for single materials: of the group material, by index into Scene::materials.
    std::map<int, ParameterValues> material_values{};
    std::set<int> hidden{};  // indices into Scene::instances that are not drawn
    std::vector<Bookmark> bookmarks{};
    Compare compare{};
    bool operator==(const Document&) const = default;
};

// Sets a parameter as a person does: other ways of saying the same thing are erased (alpha_x takes
// the place of e_x, a weave that of a normal map), and so are the values that belong to a parameter
// which now says none (weave_gap without a weave). `material`: an index into
// Document::material_values; none: all materials, whose own value of this name is erased. Throws
// UsageError for an unknown name, a value out of range, and a material's value of a parameter of
// another group.
void set_parameter(Document& document, std::string_view name, const ParameterValue& value,
                   std::optional<int> material = std::nullopt);
// The same from text, as ParameterValues::set takes it; `where` begins the messages.
void set_parameter_text(Document& document, std::string_view name, std::string_view text,
                        std::optional<int> material = std::nullopt, std::string_view where = {});
// Takes the value back to that of the layer below, with all values that belong to it. Without
// `material` single materials keep theirs.
void unset_parameter(Document& document, std::string_view name,
                     std::optional<int> material = std::nullopt);
// Puts the camera into `values` so that place_camera gives position, target and field of view again:
// erases the other parameters of the camera. Throws UsageError for numbers out of range and for a
// position that is the target.
void set_camera(Document& document, const glm::vec3& position, const glm::vec3& target,
                double fov_deg);
// The input's own camera, or the one that frames it.
void unset_camera(Document& document);

// Throws UsageError when a scene file could not hold the light: a color outside [0, 1], an intensity
// outside 0 to 1e9, a direction that is not unit, a place further than 1e6 m, a range below 0, cones
// outside 0 <= inner <= outer <= 90 degrees, or a number that is not finite.
void require_valid(const Light& light);
// Throws UsageError when compare settings or bookmarks are outside the ranges that are stated above.
void require_valid(const Compare& compare);
void require_valid(const Bookmark& bookmark);
// All lights, compare settings and bookmarks of a document.
void require_valid(const Document& document);

}  // namespace burnish::viewer
