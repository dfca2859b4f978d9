#include "viewer/document/watched_files.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "burnish/builtin_meshes.hpp"
#include "burnish/error.hpp"
#include "core/text.hpp"
#include "formats/scene_parts.hpp"

namespace burnish::viewer {
namespace {

namespace fs = std::filesystem;

void add_file(std::set<std::string>& files, const std::string& name) {
    if (!name.empty() && name != "none" && !is_builtin(name)) files.insert(name);
}

void add_values(std::set<std::string>& files, const ParameterValues& values) {
    for (const auto& [name, value] : values.set_values())
        if (const auto* text = std::get_if<std::string>(&value))
            if (names_file(name, *text)) add_file(files, *text);
}

}  // namespace

std::vector<std::string> files_of(const Document& document, const Stage& stage) {
    std::set<std::string> files;
    add_file(files, document.input);
    for (const SceneFile::Object& object : stage.file.objects) add_file(files, object.model);
    add_file(files, document.environment.empty() ? stage.file.environment : document.environment);
    // All layers, without those values of a lower one that are replaced.
    for (const ParameterValues& values : stage.materials.values()) add_values(files, values);
    if (document.compare.materials && !scene_material_of(document.compare.materials->other))
        add_file(files, document.compare.materials->other);
    return {files.begin(), files.end()};
}

WatchedFiles::Changes WatchedFiles::look(const std::vector<std::string>& files) {
    Changes changes;
    std::map<std::string, std::optional<fs::file_time_type>> now;
    for (const std::string& file : files) {
        std::error_code error;
        const fs::file_time_type time = fs::last_write_time(file, error);
        const std::optional<fs::file_time_type> found = error ? std::nullopt : std::optional(time);
        const auto before = known_.find(file);
        const bool was_there = before == known_.end() || before->second;
        if (!found && was_there) changes.gone.push_back(file);
        if (found && !was_there) changes.back.push_back(file);
        if (found && before != known_.end() && before->second && before->second != found)
            changes.changed = true;
        now[file] = found;
    }
    known_ = std::move(now);
    return changes;
}

std::vector<std::string> WatchedFiles::missing() const {
    std::vector<std::string> files;
    for (const auto& [file, time] : known_)
        if (!time) files.push_back(file);
    return files;
}

std::string line_of_missing(const std::vector<std::string>& files) {
    if (files.empty()) return "";
    const std::string first = one_line(fs::path(files.front()).filename().string());
    if (files.size() == 1) return fmt::format("{} is gone from disk: what was read stays", first);
    return fmt::format("{} and {} are gone from disk: what was read stays", first,
                       plural(files.size() - 1, "other file"));
}

}  // namespace burnish::viewer
