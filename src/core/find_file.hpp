// Files that another file names: with the folders, the letter case and the ending of another machine.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

// Endings of pictures, in small letters with their dot; those without loss come first.
std::span<const std::string_view> picture_endings();

struct FileSearch {
    // Endings that are tried in place of the one that the name has, in this order.
    std::span<const std::string_view> endings = {};
    // Subfolders in which the bare name is tried, in this order and in any letter case.
    std::span<const std::string_view> subfolders = {};
    // True: an absolute path, and one with "..", is followed as it is written. False: nothing outside
    // the folder is found.
    bool may_leave_folder = false;
};

// What was found, and how it differs from what the name says. All false: it is exactly that.
struct FoundFile {
    std::filesystem::path path;  // empty: none was found
    bool other_folder = false;   // it lies elsewhere, at or below the folder of the search
    bool other_case = false;
    bool other_ending = false;

    explicit operator bool() const { return !path.empty(); }
    bool is_exact() const { return !other_folder && !other_case && !other_ending; }
};

// For messages: "other letter case", "another folder and another ending"; empty for an exact find.
std::string difference_of(const FoundFile& found);

// Finds files that a file in `folder` names. Each place is tried exactly as written, then in any
// letter case (of ASCII letters; the first in the order of bytes when several differ in case alone).
// Names that are not UTF-8 are compared as Windows-1252.
// The places are, in this order: the path that is written; the path without its first folders, one
// less each time, down to the bare name; the bare name in each subfolder. All of them are tried with
// the ending of the name before any other ending. '\' separates folders as '/' does, and a pair of
// quotation marks around the name is dropped.
//
// Only regular files are found (or links to them). Folders are listed once and then remembered, up
// to 100000 names each. Not for several threads at a time.
class FileFinder {
  public:
    explicit FileFinder(std::filesystem::path folder, const FileSearch& search = {});

    // Never throws for a name that cannot be a path: it finds nothing.
    FoundFile find(std::string_view name);

  private:
    using Names = std::map<std::string, std::vector<std::string>>;  // by their small letters
    const Names& names_in(const std::filesystem::path& folder);
    FoundFile find_at(const std::filesystem::path& relative);
    FoundFile find_in_places(const std::filesystem::path& written);

    std::filesystem::path folder_;
    std::vector<std::string> endings_, subfolders_;
    bool may_leave_folder_;
    std::map<std::filesystem::path, Names> listed_;
};

}  // namespace burnish
