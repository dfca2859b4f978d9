#include "formats/model_files.hpp"

#include <fmt/format.h>

#include <array>

#include "burnish/error.hpp"

namespace burnish {
namespace {

constexpr std::array<std::string_view, 7> kSubfolders = {"textures", "texture",   "tex",   "maps",
                                                         "images",   "materials", "source"};

}  // namespace

ModelFiles::ModelFiles(const std::filesystem::path& folder)
    : pictures_(folder, {picture_endings(), kSubfolders, false}),
      others_(folder, {{}, kSubfolders, false}) {}

FoundFile ModelFiles::find_picture(std::string_view name, const std::filesystem::path& from) {
    FoundFile found = pictures_.find(name);
    if (from.empty() || (found && found.is_exact())) return found;
    const FoundFile beside = pictures_.find((from / name).string());
    return beside && beside.is_exact() ? beside : found;
}

std::string used_in_place(std::string_view name, const FoundFile& found) {
    return fmt::format("{}: {} is used, of {}", shown(name), one_line(found.path.string()),
                       difference_of(found));
}

}  // namespace burnish
