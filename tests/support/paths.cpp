#include "support/paths.hpp"

#include <cstdlib>

namespace burnish::test {

std::filesystem::path source_folder() {
    return BURNISH_SOURCE_DIR;
}

std::filesystem::path build_folder() {
    return std::filesystem::path(BURNISH_PROGRAM).parent_path().parent_path();
}

const char* program_path() {
    return BURNISH_PROGRAM;
}

std::filesystem::path data_folder() {
    const char* named = std::getenv("BURNISH_DATA");
    return named != nullptr ? std::filesystem::path(named) : source_folder() / "../shared/data";
}

}  // namespace burnish::test
