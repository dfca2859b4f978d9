// What a tabulated material holds, in lines for a person. Private to `burnish info`.
#pragma once

#include <string>

namespace burnish {

std::string describe_tabulated(const std::string& path);

}  // namespace burnish
