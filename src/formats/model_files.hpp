// The files that the file of a model names: one way of looking for them, for every reader.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/find_file.hpp"

namespace burnish {

// Looks in the folder of the model and below it, never outside (core/find_file.hpp says how). Not for
// several threads at a time.
class ModelFiles {
  public:
    explicit ModelFiles(const std::filesystem::path& folder);

    // With another ending, where the name's own is not there. `from`: the folder of the file that
    // names the picture, relative to the model's; the picture may lie beside it.
    FoundFile find_picture(std::string_view name, const std::filesystem::path& from = {});

    FoundFile find(std::string_view name) { return others_.find(name); }

  private:
    FileFinder pictures_, others_;
};

// For a warning: "\"wood.jpg\": tex/Wood.png is used, of another folder and another ending".
std::string used_in_place(std::string_view name, const FoundFile& found);

}  // namespace burnish
