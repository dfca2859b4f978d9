// `burnish info` of weaving drafts.
#pragma once

#include <string>

namespace burnish {

// Several lines, each ended by a newline. Throws as read_wif.
std::string describe_draft(const std::string& path);

}  // namespace burnish
