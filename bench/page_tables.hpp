// Tables that a program writes into a page, behind a line that marks where they begin.
#pragma once

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "burnish/error.hpp"

namespace burnish::bench {

// Replaces what stands behind the marker. Throws Error when the page has no marker.
inline void write_tables(const char* path, std::string_view marker, const std::string& tables) {
    std::ifstream in(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::size_t found = text.find(marker);
    if (found == std::string::npos) throw Error(path, "", "the marker line", "none");
    text.resize(found + marker.size());
    std::ofstream(path, std::ios::binary) << text << tables;
}

}  // namespace burnish::bench
