#include "formats/own_folder.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "burnish/error.hpp"
#include "core/files.hpp"
#include "formats/json_text.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

struct Description {
    OwnFolderKind kind;
    std::string_view file;  // the description
    std::string_view format;
    std::string_view command;
};
// The order of the enumeration.
constexpr std::array<Description, 4> kDescriptions = {
    {{OwnFolderKind::scratch, "scratch.json", "burnish-scratch", "burnish scratch"},
     {OwnFolderKind::weave, "weave.json", "burnish-weave", "burnish weave"},
     {OwnFolderKind::material, "material.json", "burnish-material", "burnish export material"},
     {OwnFolderKind::sample, "material.gltf", "", "burnish capture export"}}};

constexpr std::uintmax_t kMostOfDescription = std::uintmax_t{16} << 20;
constexpr double kMostTexels = 65536;  // a side
constexpr double kMostMm = 1e9;

void read_own_size(const JsonPlace& root, OwnFolder& out) {
    if (!root.has("size")) return;
    const JsonPlace size = root.at("size");
    if (!size.value().is_array()) {
        out.width = out.height = static_cast<int>(size.number(1, kMostTexels));
        return;
    }
    size.require_array(2);
    if (size.size() != 2) size.fail("[width, height]");
    out.width = static_cast<int>(size.at(std::size_t{0}).number(1, kMostTexels));
    out.height = static_cast<int>(size.at(std::size_t{1}).number(1, kMostTexels));
}

void read_own_tile(const JsonPlace& root, OwnFolder& out) {
    if (!root.has("tile_mm")) return;
    const JsonPlace tile = root.at("tile_mm");
    if (!tile.value().is_array()) {
        out.width_mm = out.height_mm = tile.number(0, kMostMm);
        return;
    }
    tile.require_array(2);
    if (tile.size() != 2) tile.fail("[width, height]");
    out.width_mm = tile.at(std::size_t{0}).number(0, kMostMm);
    out.height_mm = tile.at(std::size_t{1}).number(0, kMostMm);
}

void read_own_maps(const JsonPlace& root, OwnFolder& out) {
    if (!root.has("maps")) return;
    const JsonPlace maps = root.at("maps");
    maps.require_object();
    for (const std::string& name : maps.keys()) {
        const JsonPlace file = maps.at(name).at("file");
        const std::string text = file.text();
        if (fs::path(text).filename() != fs::path(text)) file.fail("a name without a folder");
        out.maps.push_back(text);
    }
}

// A name or a command, which programs may leave empty.
std::string maybe_empty(const JsonPlace& place) {
    if (!place.is_text()) place.fail("a text");
    return place.value().get<std::string>();
}

void read_own_texts(const JsonPlace& root, OwnFolder& out) {
    for (const char* key : {"name", "weave"})
        if (root.has(key)) out.name = maybe_empty(root.at(key));
    if (root.has("repeats") && root.at("repeats").value().is_boolean())
        out.repeats = root.at("repeats").value().get<bool>();
    if (root.has("approximated")) {
        const JsonPlace lines = root.at("approximated");
        lines.require_array(1000);
        for (std::size_t i = 0; i < lines.size(); ++i)
            out.approximated.push_back(lines.at(i).text());
    }
    if (root.has("made") && root.at("made").has("command"))
        out.made_by = maybe_empty(root.at("made").at("command"));
}

std::optional<OwnFolder> read_own(const Description& row, const fs::path& file) {
    OwnFolder out;
    out.kind = row.kind;
    out.description = file;
    if (row.format.empty()) return out;
    const std::string name = file.string();
    const nlohmann::json document = parse_json(name, read_text_file(file, kMostOfDescription));
    if (!document.is_object()) return std::nullopt;
    const auto format = document.find("format");
    if (format == document.end() || *format != row.format) return std::nullopt;
    const JsonPlace root(name, document);
    read_own_size(root, out);
    read_own_tile(root, out);
    read_own_texts(root, out);
    if (row.kind == OwnFolderKind::material) read_own_maps(root, out);
    return out;
}

}  // namespace

std::string_view command_of(OwnFolderKind kind) {
    return kDescriptions[static_cast<std::size_t>(kind)].command;
}

std::optional<OwnFolderKind> own_folder_kind(const fs::path& folder) {
    std::error_code error;
    const auto has = [&](std::string_view name) { return fs::exists(folder / name, error); };
    if (has("material.json")) return OwnFolderKind::material;
    if (has("scratch.json")) return OwnFolderKind::scratch;
    if (has("weave.json")) return OwnFolderKind::weave;
    // Any exporter writes a material.gltf; only ours lays angles of the grain beside it.
    if (has("material.gltf") && has("grain_angle.exr")) return OwnFolderKind::sample;
    return std::nullopt;
}

std::optional<OwnFolder> find_own_folder(const fs::path& folder) {
    const std::optional<OwnFolderKind> kind = own_folder_kind(folder);
    if (!kind) return std::nullopt;
    const Description& row = kDescriptions[static_cast<std::size_t>(*kind)];
    return read_own(row, folder / row.file);
}

std::optional<OwnFolder> read_own_description(const fs::path& file) {
    for (const Description& row : kDescriptions)
        if (!row.format.empty() && file.filename() == row.file) return read_own(row, file);
    return std::nullopt;
}

}  // namespace burnish
