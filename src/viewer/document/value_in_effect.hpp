// The value in effect of a parameter: with which the stage is drawn, whoever states it.
//
// Threads: functions may be called from any thread. Lifetime: what they return refers to nothing
// else.
#pragma once

#include <optional>
#include <string_view>

#include "burnish/stage.hpp"
#include "viewer/document/document.hpp"

namespace burnish::viewer {

struct ValueInEffect {
    // None: no value of this parameter says what is drawn, such as the alpha of a measured material, or
    // the file of a normal map that is inside a model.
    std::optional<ParameterValue> value;
    bool set_here = false;  // the document sets it: for the material, or without one for all
};

// What the document sets, else the scene file's value, else what the model has (its material, its
// camera), else the table's default. `stage`: of this document. `material`: an index into
// Scene::materials; none: all materials, of which the first one counts where the document sets nothing.
// Throws UsageError for an unknown name.
ValueInEffect value_in_effect(const Document& document, const Stage& stage, std::string_view name,
                              std::optional<int> material = std::nullopt);

// Whether two materials have different values of a parameter of materials.
bool materials_differ(const Stage& stage, const Parameter& parameter);

// The value that a person begins with who sets a parameter: the one in effect, else one that is close to
// what is drawn.
ParameterValue start_value(const Document& document, const Stage& stage, const Parameter& parameter,
                           std::optional<int> material = std::nullopt);

}  // namespace burnish::viewer
