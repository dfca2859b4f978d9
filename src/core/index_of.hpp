// An index that is known not to be negative, as containers take it.
#pragma once

#include <cstddef>

namespace burnish {

constexpr std::size_t index_of(int i) {
    return static_cast<std::size_t>(i);
}

}  // namespace burnish
