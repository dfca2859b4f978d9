// The contents of a measured material as text lines. Private to `burnish info`.
#pragma once

#include <string>

namespace burnish {

// The fields of any tensor file; for a material of the RGL database also its description, the
// measured range and its albedo.
std::string describe_measured(const std::string& path);

}  // namespace burnish
