// What the lists of a scene say: its materials, objects and lights.
//
// Threads: functions may be called from any thread. Lifetime: what they return refers to nothing
// else.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "burnish/stage.hpp"
#include "viewer/document/document.hpp"

namespace burnish::viewer {

struct MaterialRow {
    std::string name;          // the material's, else "#3"
    std::string kind;          // "captured", "weave", "scratch", "metal" or "dielectric"
    glm::vec3 color{1.0f};     // linear, in [0, 1]: what the base color is without its textures
    bool has_texture = false;  // of the base color
    int objects = 0;           // that use it, hidden ones too
};
std::vector<MaterialRow> material_rows(const Stage& stage);

struct ObjectRow {
    std::string name;  // of its mesh, else "object 3"
    std::size_t triangles = 0;
    int material = 0;
    bool shown = true;
};
std::vector<ObjectRow> object_rows(const Document& document, const Stage& stage);

// All lights with their own intensities: those of the document, else of the input.
std::vector<Light> all_lights(const Document& document, const Stage& stage);

// World space; hidden instances too. A point at the origin for an index without an instance.
Bounds bounds_of_object(const Stage& stage, std::size_t index);

// What the document shows becomes one object, or all again where that is so already.
void show_alone(Document& document, const Stage& stage, int index);

}  // namespace burnish::viewer
