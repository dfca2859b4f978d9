// Paths of the checkout and of the program under test.
#pragma once

#include <filesystem>

namespace burnish::test {

std::filesystem::path source_folder();  // the root of the checkout
std::filesystem::path build_folder();   // the root of this build
const char* program_path();             // bin/burnish of this build

// The folder of sample data by others: BURNISH_DATA, or ../shared/data beside the checkout. Tests
// skip with a message if it is missing.
std::filesystem::path data_folder();

}  // namespace burnish::test
