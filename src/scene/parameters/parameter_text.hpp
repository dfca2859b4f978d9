// Parameter values from text and back.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "burnish/parameters.hpp"

namespace burnish {

// The value that `text` states, of the parameter's kind; none when it states none. The range is not
// checked.
std::optional<ParameterValue> parse_value(const Parameter& parameter, std::string_view text);

// Whether `value` is of the parameter's kind and within its range and choices.
bool is_valid(const Parameter& parameter, const ParameterValue& value);

// Any value as text, for error messages; it need not suit a parameter.
std::string any_text(const ParameterValue& value);

// The values that the parameter takes, for error messages: "a number from 0 to 1".
std::string expectation(const Parameter& parameter);

}  // namespace burnish
