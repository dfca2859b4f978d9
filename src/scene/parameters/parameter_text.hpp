// Parameter values from text and back.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "burnish/parameters.hpp"

namespace burnish {

// The value that `text` states, of the parameter's kind; none when it states none. The range is not
// looked at.
std::optional<ParameterValue> parse_value(const Parameter& parameter, std::string_view text);

// Whether `value` is of the parameter's kind and within its range and choices.
bool is_valid(const Parameter& parameter, const ParameterValue& value);

// Any value in words, whatever parameter it is given to: for error lines.
std::string any_text(const ParameterValue& value);

// What an error line says that the parameter takes: "a number from 0 to 1".
std::string expectation(const Parameter& parameter);

}  // namespace burnish
