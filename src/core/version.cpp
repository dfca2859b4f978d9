#include "burnish/version.hpp"

namespace burnish {

std::string_view version() {
    return BURNISH_VERSION;
}

}  // namespace burnish
