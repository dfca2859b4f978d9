#include "core/text.hpp"

#include <fmt/format.h>

namespace burnish {

std::string plural(std::size_t count, std::string_view word) {
    const bool es = word.ends_with("sh");
    return fmt::format("{} {}{}", count, word, count == 1 ? "" : es ? "es" : "s");
}

}  // namespace burnish
