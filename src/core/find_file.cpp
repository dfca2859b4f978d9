#include "core/find_file.hpp"

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include "core/utf8.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostNames = 100000;  // of one folder; a rig has up to 10000 pictures
// The longest path and the longest name that Linux opens. They also bound the number of places.
constexpr std::size_t kLongestPath = 4096;
constexpr std::size_t kLongestName = 255;

// What names are compared by. The names of a folder may be in the encoding of an old system.
std::string small_letters(std::string text) {
    text = as_utf8(std::move(text));
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

bool is_file(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

// The name as a path; empty when it cannot be one.
fs::path path_of(std::string_view name) {
    if (name.size() >= 2 && name.front() == '"' && name.back() == '"')
        name = name.substr(1, name.size() - 2);
    if (name.size() > kLongestPath || name.find('\0') != name.npos) return {};
    std::string text(name);
    std::replace(text.begin(), text.end(), '\\', '/');
    fs::path path = fs::path(text).lexically_normal();
    for (const fs::path& part : path)
        if (part.native().size() > kLongestName) return {};
    return path.has_filename() ? path : fs::path();
}

bool leaves_folder(const fs::path& path) {
    return path.is_absolute() || *path.begin() == "..";
}

// The path without its root and without the ".." at its start.
std::vector<fs::path> parts_below(const fs::path& path) {
    std::vector<fs::path> parts;
    for (const fs::path& part : path.relative_path())
        if (part != ".." && part != ".") parts.push_back(part);
    return parts;
}

}  // namespace

std::span<const std::string_view> picture_endings() {
    static constexpr std::array<std::string_view, 13> kEndings = {
        ".png",  ".tif", ".tiff", ".tga",  ".bmp",  ".jpg", ".jpeg",
        ".webp", ".exr", ".hdr",  ".heic", ".heif", ".avif"};
    return kEndings;
}

std::string difference_of(const FoundFile& found) {
    std::vector<std::string_view> words;
    if (found.other_folder) words.push_back("another folder");
    if (found.other_case) words.push_back("other letter case");
    if (found.other_ending) words.push_back("another ending");
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
        text += words[i];
    }
    return text;
}

FileFinder::FileFinder(fs::path folder, const FileSearch& search)
    : folder_(std::move(folder)),
      endings_(search.endings.begin(), search.endings.end()),
      subfolders_(search.subfolders.begin(), search.subfolders.end()),
      may_leave_folder_(search.may_leave_folder) {}

const FileFinder::Names& FileFinder::names_in(const fs::path& folder) {
    const auto [at, fresh] = listed_.try_emplace(folder);
    Names& names = at->second;
    if (!fresh) return names;
    std::error_code error;
    fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error);
    std::size_t count = 0;
    for (; !error && entry != fs::directory_iterator() && count < kMostNames; ++count) {
        std::string name = entry->path().filename().string();
        names[small_letters(name)].push_back(std::move(name));
        entry.increment(error);
    }
    for (auto& [letters, same] : names) std::sort(same.begin(), same.end());
    return names;
}

// A path below the folder, as written, then in any letter case part by part.
FoundFile FileFinder::find_at(const fs::path& relative) {
    if (is_file(folder_ / relative)) return {folder_ / relative};
    fs::path place = folder_;
    for (const fs::path& part : relative) {
        const Names& names = names_in(place);
        const auto same = names.find(small_letters(part.string()));
        if (same == names.end()) return {};
        const std::vector<std::string>& spellings = same->second;
        const bool written = std::binary_search(spellings.begin(), spellings.end(), part.string());
        place /= written ? part : fs::path(spellings.front());
    }
    FoundFile found;
    if (!is_file(place)) return found;
    found.path = place;
    found.other_case = true;
    return found;
}

FoundFile FileFinder::find_in_places(const fs::path& written) {
    const bool leaves = leaves_folder(written);
    if (leaves && may_leave_folder_ && is_file(folder_ / written)) return {folder_ / written};
    const std::vector<fs::path> parts = parts_below(written);
    for (std::size_t first = 0; first < parts.size(); ++first) {
        // A tail is put together only where its first folder is there: a path may have thousands.
        if (first > 0 && !names_in(folder_).contains(small_letters(parts[first].string())))
            continue;
        fs::path tail;
        for (std::size_t i = first; i < parts.size(); ++i) tail /= parts[i];
        if (FoundFile found = find_at(tail)) {
            found.other_folder = leaves || first > 0;
            return found;
        }
    }
    for (const std::string& subfolder : subfolders_) {
        if (FoundFile found = find_at(fs::path(subfolder) / written.filename())) {
            found.other_folder = true;
            // The letter case of the subfolder is no difference: the name does not say it.
            found.other_case = found.path.filename() != written.filename();
            return found;
        }
    }
    return {};
}

FoundFile FileFinder::find(std::string_view name) {
    const fs::path written = path_of(name);
    if (written.empty()) return {};
    if (FoundFile found = find_in_places(written)) return found;
    for (const std::string& ending : endings_) {
        fs::path other = written;
        other.replace_extension(ending);
        if (small_letters(other.string()) == small_letters(written.string())) continue;
        FoundFile found = find_in_places(other);
        if (!found) continue;
        // The letter case of the ending is no difference: the ending is another one.
        found.other_case = found.other_case && found.path.stem() != written.stem();
        found.other_ending = true;
        return found;
    }
    return {};
}

}  // namespace burnish
