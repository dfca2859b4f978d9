// Parts of messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace burnish {

// The count with its noun: "1 mesh", "2 meshes".
std::string plural(std::size_t count, std::string_view word);

}  // namespace burnish
