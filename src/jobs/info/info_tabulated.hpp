// The contents of a tabulated material as text lines. Private to `burnish info`.
#pragma once

#include <string>

namespace burnish {

std::string describe_tabulated(const std::string& path);

}  // namespace burnish
