// Small WIF files made of sections, and what is read of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "burnish/wif.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {

// Sections by name, so that a test can change one of them.
using Sections = std::map<std::string, std::string>;

// Three ends on three shafts, three picks, by treadles.
inline Sections small() {
    return {
        {"WIF", "Version=1.1\n"},         {"WEAVING", "Shafts=3\nTreadles=3\nRising Shed=yes\n"},
        {"WARP", "Threads=3\n"},          {"WEFT", "Threads=3\n"},
        {"THREADING", "1=1\n2=2\n3=3\n"}, {"TIEUP", "1=1,2\n2=3\n3=1,3\n"},
        {"TREADLING", "1=1\n2=2\n3=3\n"}};
}

inline std::string text_of(const Sections& sections) {
    std::string text = "[WIF]\n" + sections.at("WIF");
    for (const auto& [name, lines] : sections)
        if (name != "WIF") text += "\n[" + name + "]\n" + lines;
    return text;
}

inline WifFile read(const std::string& text) {
    const ScratchFolder folder;
    return read_wif(folder.write("cloth.wif", text));
}

inline std::string complaint(const std::string& text) {
    const ScratchFolder folder;
    const auto path = folder.write("cloth.wif", text);
    std::string line = error_line([&] { read_wif(path); });
    EXPECT_EQ(line.find(path.string()), 0u) << line;  // starts with the file's name
    return line.substr(std::min(line.size(), path.string().size()));
}

// Rows from the bottom, in the order of picks: "#.." is one end up and two down.
inline std::string drawn(const Draft& draft) {
    std::string text;
    for (int pick = 0; pick < draft.picks; ++pick) {
        for (int end = 0; end < draft.ends; ++end) text += draft.is_warp_up(end, pick) ? '#' : '.';
        text += ' ';
    }
    return text;
}

inline bool has(const std::vector<std::string>& warnings, const std::string& part) {
    return std::any_of(warnings.begin(), warnings.end(), [&](const std::string& warning) {
        return warning.find(part) != std::string::npos;
    });
}

}  // namespace burnish::test
