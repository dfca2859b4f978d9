// `burnish info` of folders of maps and of their descriptions.
#pragma once

#include <optional>
#include <string>

namespace burnish {

// Several lines: of a folder that Burnish wrote what its description says, of a rig's folder the rig,
// and of each folder of maps what --maps takes for what. Throws Error for a folder with none of these.
std::string describe_folder(const std::string& folder);

// The same for a description, such as "gold/material.json". None for other files.
std::optional<std::string> describe_own_description(const std::string& file);

}  // namespace burnish
