// THE parameter table: every number, choice and switch a person can set, once. It feeds the flags
// of the command line, the keys of scene files, their ranges, defaults and help.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/api.hpp"

namespace BURNISH_API burnish {

enum class ParameterKind { real, integer, boolean, choice, color, vector, text };
enum class ParameterGroup { material, render, camera, environment, mesh };

struct Parameter {
    std::string_view name;  // snake_case: scene-file key; the flag is --name with dashes
    ParameterGroup group;
    ParameterKind kind;
    double low;                     // inclusive range of real and integer, per component of color
    double high;                    // and vector
    std::string_view default_text;  // "" : unset, the file or the program decides
    std::string_view unit;          // "deg", "px", "EV", "" ...
    std::string_view help;          // one line
    std::span<const std::string_view> choices;  // for choice
};

std::span<const Parameter> parameter_table();
const Parameter* find_parameter(std::string_view name);  // nullptr when unknown
std::string flag_of(std::string_view name);              // "alpha_x" -> "--alpha-x"

// What somebody has set, by name; everything else answers with the table's default. Every setter
// checks kind, range and choice and throws UsageError naming `where`, the parameter, what was
// expected and what was found; an unknown name suggests the nearest.
class ParameterValues {
  public:
    // `where` that ends in the parameter's name (a flag, a key path) stands alone in messages; else
    // the name is added to it. `text`: "0.2", "true", "follow-grain", "1,0.8,0.3" or "#rrggbb"
    // (sRGB) for colours, "x,y,z".
    void set(std::string_view name, std::string_view text, std::string_view where);

    bool is_set(std::string_view name) const;
    bool has_value(std::string_view name) const;  // set, or the table has a default
    double real(std::string_view name) const;
    int integer(std::string_view name) const;
    bool boolean(std::string_view name) const;
    int choice(std::string_view name) const;      // index into Parameter::choices
    glm::vec3 vec3(std::string_view name) const;  // color (linear) and vector
    std::string text(std::string_view name) const;

    // `other` wins where both are set (flags over scene file).
    void merge(const ParameterValues& other);
    const std::map<std::string, std::string, std::less<>>& set_values() const { return values_; }

  private:
    std::string_view value_of(std::string_view name) const;
    std::map<std::string, std::string, std::less<>> values_;
};

}  // namespace burnish
