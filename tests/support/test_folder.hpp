// A folder for the files of one test, and the one-line message of a thrown error.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "burnish/error.hpp"
#include "support/paths.hpp"

namespace burnish::test {

// A unique folder, removed by the destructor.
class ScratchFolder {
  public:
    ScratchFolder() {
        std::string name =
            (std::filesystem::temp_directory_path() / "burnish-scene-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        path_ = name;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
    std::filesystem::path write(std::string_view name, std::string_view text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path_ / name;
    }

  private:
    std::filesystem::path path_;
};

// what() of the `Kind` that `work` throws, checked to be one line; fails the test and returns "" if
// none is thrown.
template <typename Kind = Error, typename Work>
std::string error_line(const Work& work) {
    try {
        work();
    } catch (const Kind& error) {
        const std::string line = error.what();
        EXPECT_EQ(line.find_first_of("\n\r"), std::string::npos) << line;
        return line;
    }
    ADD_FAILURE() << "no error was thrown";
    return {};
}

// The folder of sample data, or "" if it is missing.
inline std::filesystem::path sample_data() {
    const std::filesystem::path folder = data_folder();
    return std::filesystem::is_directory(folder) ? folder : std::filesystem::path();
}

}  // namespace burnish::test
