// THE parameter table: every number, choice and switch of a material and of a picture that a person
// can set, once. It feeds the flags of the command line, the keys of scene files, their ranges,
// defaults and help. A program that needs no names fills Material and RenderSettings itself.
#pragma once

#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "burnish/api.hpp"

namespace BURNISH_API burnish {

enum class ParameterKind { real, integer, boolean, choice, color, vector, text };
enum class ParameterGroup { material, render, camera, environment, mesh };

// Index into Parameter::choices, which is the value of the enumeration that the choices name.
struct ParameterChoice {
    int index = 0;
    bool operator==(const ParameterChoice&) const = default;
};

// The value of a parameter, by its kind: real double, integer int, boolean bool, choice
// ParameterChoice, color (linear Rec. 709) and vector glm::vec3, text std::string.
using ParameterValue = std::variant<double, int, bool, ParameterChoice, glm::vec3, std::string>;

struct Parameter {
    std::string_view name;  // snake_case: scene-file key; the flag is --name with dashes
    ParameterGroup group;
    ParameterKind kind;
    double low;  // inclusive range of real and integer, and of each component of color and vector
    double high;
    std::optional<ParameterValue> default_value;  // none: the file or the program decides
    std::string default_text;                     // the same as text; "" when there is none
    std::string_view unit;                        // "deg", "px", "EV", "" ...
    std::string_view help;                        // one line
    std::span<const std::string_view> choices;    // names, of a choice
    // The parameter without which this one says nothing: weave_gap belongs to weave. "": none.
    std::string_view belongs_to;
    std::string_view names;  // of a text, what it names, for help texts: "FILE", "FOLDER"
};

// The table, in the order of help texts. Thread-safe, and the same for the life of the program.
std::span<const Parameter> parameter_table();
const Parameter* find_parameter(std::string_view name);  // nullptr when unknown
std::string flag_of(std::string_view name);              // "alpha_x" -> "--alpha-x"

// The value as text that ParameterValues::set reads back as the same value, "0.2", "follow-grain",
// "1,0.8,0.3". Throws Error when the value is not of the parameter's kind.
std::string text_of(const Parameter& parameter, const ParameterValue& value);

// The values that somebody has set, by name; a name that nobody set answers with the table's
// default. A plain value: copies are independent, and any number of threads may read one.
//
// Setters check kind, range and choice. They throw UsageError naming `where`, the parameter, what
// was expected and what was found; an unknown name suggests the nearest. `where` that ends in the
// parameter's name (a flag, a key path) stands alone in messages; else the name is added to it.
class ParameterValues {
  public:
    // `text`: "0.2", "true", "follow-grain", "1,0.8,0.3" or "#rrggbb" (sRGB) for colors, "x,y,z".
    void set(std::string_view name, std::string_view text, std::string_view where);
    // A value of the parameter's kind; an int does for a real.
    void set_value(std::string_view name, const ParameterValue& value, std::string_view where = "");
    void erase(std::string_view name);  // afterwards the name is unset

    bool is_set(std::string_view name) const;
    bool has_value(std::string_view name) const;  // set, or the table has a default

    // The value, or the default. They throw UsageError for an unknown name and where there is
    // neither, and Error when the parameter is not of the kind that is asked for.
    double real(std::string_view name) const;  // of real and integer
    int integer(std::string_view name) const;
    bool boolean(std::string_view name) const;
    int choice(std::string_view name) const;        // index into Parameter::choices
    glm::vec3 vec3(std::string_view name) const;    // color (linear) and vector
    std::string text(std::string_view name) const;  // of every kind

    // The values of `other` win where both are set. They also replace other ways of saying the same
    // thing: alpha_x takes the place of e_x, a weave that of a normal map with all its numbers.
    void merge(const ParameterValues& other);
    const std::map<std::string, ParameterValue, std::less<>>& set_values() const { return values_; }
    bool operator==(const ParameterValues&) const = default;

  private:
    const ParameterValue& value_of(std::string_view name,
                                   std::span<const ParameterKind> kinds) const;
    std::map<std::string, ParameterValue, std::less<>> values_;
};

// What scratch maps do to the grooves of the lobe: the parameter scratch_direction.
enum class ScratchDirection {
    keep,   // the material's own
    follow  // along the scratches
};
std::span<const std::string_view> scratch_direction_names();  // in the order of the enumeration

// Throws UsageError when `values` state the roughness pair in two ways, named as keys or as flags.
void require_one_roughness(const ParameterValues& values, bool as_flags);

}  // namespace burnish
