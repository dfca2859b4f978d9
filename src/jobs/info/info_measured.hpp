// What a measured material holds, in lines for a person. Private to `burnish info`.
#pragma once

#include <string>

namespace burnish {

// The fields of any tensor file; of a material of the RGL database also what it is, where it was
// measured, and how much it reflects.
std::string describe_measured(const std::string& path);

}  // namespace burnish
