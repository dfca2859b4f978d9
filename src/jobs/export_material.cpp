#include "jobs/export_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "burnish/builtin_meshes.hpp"
#include "burnish/context.hpp"
#include "burnish/display.hpp"
#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "burnish/gltf_material.hpp"
#include "burnish/image_io.hpp"
#include "burnish/renderer.hpp"
#include "burnish/tabulated_file.hpp"
#include "burnish/tabulated_material.hpp"
#include "burnish/version.hpp"
#include "burnish/wif.hpp"
#include "core/memory.hpp"
#include "export/gltf_material_text.hpp"
#include "export/material_points.hpp"
#include "image/texel_value.hpp"
#include "jobs/map_folder.hpp"
#include "stage/map_set.hpp"
#include "stage/scratch_material.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr int kUsualSide = 2048, kPreviewSide = 512;
constexpr const char* kTableFile = "measured.exr";
constexpr const char* kDraftFile = "draft.wif";

// What a map means, for material.json.
struct MapMeaning {
    std::string_view name;
    std::string_view channels;
    std::string_view color_space;
};
constexpr std::array<MapMeaning, 5> kMeanings = {
    {{"base_color", "red, green, blue: color of the base; alpha: coverage", "sRGB"},
     {"orm",
      "red: ambient occlusion; green: perceptual roughness, alpha = roughness^2; blue: metallic",
      "linear"},
     {"normal", "(1 + n) / 2, tangent space, +y up (OpenGL)", "linear"},
     {"anisotropy",
      "red, green: (1 + d) / 2, d the direction of the stretch, across the grooves; blue: strength "
      "(KHR_materials_anisotropy)",
      "linear"},
     {"emissive", "red, green, blue: emitted radiance over the factor of the glTF", "sRGB"}}};

struct Size {
    int width, height;
};

Size size_of(const ExportMaterialRequest& request, const Material& material) {
    const double aspect = gltf_tile_aspect(material);
    const auto rounded = [](double side) {
        return static_cast<int>(std::lround(std::clamp(side, 1.0, 1e9)));
    };
    Size size{};
    size.width =
        request.width.value_or(request.height ? rounded(*request.height * aspect)
                                              : rounded(kUsualSide * std::min(1.0, aspect)));
    size.height = request.height.value_or(rounded(size.width / aspect));
    return size;
}

DataPicture picture_of(const Texture& map) {
    const bool color = map.color_space == ColorSpace::srgb;
    const DataFormat format = color                       ? DataFormat::png8_srgb
                              : map.type == TexelType::u8 ? DataFormat::png8
                                                          : DataFormat::png16;
    std::vector<std::string> channels = kRgb;
    if (map.channels == 4) channels.emplace_back("A");
    return picture_of_rows(
        format, std::move(channels), map.width, map.height, [&map](int begin, int end, float* to) {
            const std::size_t row =
                static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.channels);
            for (std::size_t i = row * static_cast<std::size_t>(begin);
                 i < row * static_cast<std::size_t>(end); ++i)
                *to++ = texel_value(map, i);
        });
}

// Names that are safe as folders: letters, digits, '-', '_' and '.'; others become '_'.
std::string folder_name(const std::string& name, std::size_t index) {
    std::string out;
    for (const char c : name) {
        const bool keep = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                          (c >= 'A' && c <= 'Z') || c == '-' || c == '_' || c == '.';
        out.push_back(keep ? c : '_');
    }
    const bool empty = out.find_first_not_of("._") == std::string::npos;
    return empty ? fmt::format("material_{}", index) : out;
}

// The last folder of a path; that above it where it only says what is inside.
std::string folder_title(const fs::path& path) {
    fs::path folder = path.lexically_normal();
    if (!folder.has_filename()) folder = folder.parent_path();
    const std::string name = folder.filename().string();
    const bool says_nothing = name == "textures" || name == "maps";
    return says_nothing && folder.has_parent_path() ? folder.parent_path().filename().string()
                                                    : name;
}

// What the flags make of the material of a built-in mesh, which has no name: the title of the draft,
// the measured file, the folder of maps or the metal, and the scratches. Empty: nothing of these.
std::string name_of_values(const ParameterValues& values, const Material& material) {
    std::string name;
    if (const Cloth* cloth = cloth_of(material))
        name = cloth->draft->name;
    else if (names_one(values, "tabulated"))
        name = fs::path(values.text("tabulated")).stem().string();
    else if (names_one(values, "maps"))
        name = folder_title(values.text("maps"));
    else if (names_one(values, "metal"))
        name = values.text("metal");
    if (!values.is_set("scratch")) return name;
    return name + (name.empty() ? "" : "-") + folder_title(values.text("scratch"));
}

std::vector<std::size_t> chosen(const std::vector<Material>& materials, const std::string& wanted) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < materials.size(); ++i)
        if (wanted.empty() || materials[i].name == wanted) all.push_back(i);
    if (!all.empty()) return all;
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
    if (error == std::errc() && end == wanted.data() + wanted.size() && index < materials.size())
        return {index};
    std::string names;
    for (const Material& m : materials)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", one_line(m.name));
    throw UsageError(
        "--material", "",
        fmt::format("a name ({}) or an index from 0 to {}", names, materials.size() - 1),
        shown(wanted));
}

// The exported material on a sphere in the usual studio.
Image preview_of(const GltfMaterial& baked, const Stage& stage, int gl_device,
                 const Progress& progress) {
    Scene scene;
    scene.textures = baked.textures;
    scene.materials = {baked.material};
    scene.meshes.push_back(make_builtin_mesh("sphere", 0));
    scene.instances.emplace_back();
    ParameterValues values;
    values.set_value("camera_elevation", 20.0);
    RenderSettings settings;
    settings.width = settings.height = kPreviewSide;
    settings.samples = 8;
    settings.robust_limit = robust_limit(stage.values);
    const Camera camera = place_camera(scene, values, 1.0);
    gpu::Context context(gl_device);
    const bool lit = !stage.environment.radiance.empty();
    gpu::Renderer renderer(context, scene, lit ? &stage.environment : nullptr);
    return to_display(renderer.render(camera, settings, progress), stage.exposure_ev,
                      stage.tone_map);
}

// Physical width of the tile in mm, where it is known.
std::optional<double> tile_width_mm(const ExportMaterialRequest& request, const Stage& stage,
                                    const Material& m) {
    if (request.tile_mm) return request.tile_mm;
    if (const Cloth* cloth = cloth_of(m); cloth && stage.values.is_set("weave_yarns_per_cm")) {
        const int yarns = cloth->draft->ends * cloth_repeats(*cloth->draft).x;
        return yarns * 10.0 / stage.values.real("weave_yarns_per_cm");
    }
    if (stage.values.is_set("maps_tile_mm") && cloth_of(m) == nullptr && tabulated_of(m) == nullptr)
        return stage.values.real("maps_tile_mm");
    if (names_one(stage.values, "maps") && !stage.values.is_set("scratch") &&
        cloth_of(m) == nullptr && tabulated_of(m) == nullptr) {
        const double mm = map_folder_tile_mm(stage.values.text("maps"));
        if (mm > 0.0) return mm;
    }
    if (stage.values.is_set("scratch") && cloth_of(m) == nullptr && tabulated_of(m) == nullptr) {
        const double mm = scratch_tile_mm(stage.values.text("scratch"));
        if (mm > 0.0) return mm;
    }
    if (const Tabulated* t = tabulated_of(m); t && t->material->width_mm > 0.0)
        return t->material->width_mm;
    return {};
}

class FolderWriter {
  public:
    FolderWriter(const ExportMaterialRequest& request, const Stage& stage, std::size_t index,
                 fs::path folder)
        : request_(request),
          stage_(stage),
          source_(stage.scene.materials[index]),
          folder_(std::move(folder)) {}

    void write(const Progress& progress, ExportMaterialReport& report) {
        const OutputFolder made(folder_);
        const bool was_ours = fs::exists(folder_ / "material.json");
        const Size size = size_of(request_, source_);
        baked_ = bake_gltf_material(source_, stage_.scene.textures,
                                    {size.width, size.height, request_.bits}, available_memory(),
                                    progress);
        for (const std::string& loss : baked_.losses)
            report.warnings.push_back(fmt::format("{}: {}", one_line(source_.name), loss));
        size_mm();
        const std::map<std::string, std::string> metadata = {
            {"burnish:version", std::string(version())}, {"burnish:command", request_.command}};
        const auto written = write_map_folder(folder_, texts(metadata, progress, report),
                                              pictures(), metadata, progress);
        if (was_ours) remove_others(written);
        report.written.insert(report.written.end(), written.begin(), written.end());
    }

  private:
    bool has_table() const { return tabulated_of(source_) != nullptr; }
    std::string own_file() const {
        // Maps that lie over the weave or the table are in the baked ones alone.
        if (!request_.extras || has_textures(source_)) return "";
        return has_table() ? kTableFile : cloth_of(source_) ? kDraftFile : "";
    }

    // Files of an earlier export that this one does not write: they would be taken for its maps.
    void remove_others(const std::vector<fs::path>& written) const {
        std::vector<std::string> names = {kTableFile, kDraftFile, "preview.png"};
        for (const MapMeaning& m : kMeanings) names.push_back(std::string(m.name) + ".png");
        for (const std::string& name : names) {
            const fs::path file = folder_ / name;
            std::error_code ignored;
            if (std::find(written.begin(), written.end(), file) == written.end())
                fs::remove(file, ignored);
        }
    }

    // The quad shows the texture square: as many tiles as the tile's transform says.
    void size_mm() {
        tile_mm_ = tile_width_mm(request_, stage_, source_);
        const glm::mat3& tile = baked_.tile;
        const double across = std::hypot(tile[0][0], tile[0][1]);
        const double down = std::hypot(tile[1][0], tile[1][1]);
        const double tile_aspect = gltf_tile_aspect(source_);
        quad_.tangents = tile[0][1] == 0.0f && tile[0][0] > 0.0f && tile[1][1] > 0.0f;
        quad_.name = source_.name;
        quad_.width_mm = tile_mm_ ? *tile_mm_ * across : 100.0;
        quad_.height_mm = across > 0.0 ? quad_.width_mm / across * down / tile_aspect : 100.0;
    }

    std::vector<FileToWrite> texts(const std::map<std::string, std::string>& metadata,
                                   const Progress& progress, ExportMaterialReport& report) {
        std::vector<FileToWrite> files;
        files.push_back({folder_ / "material.json",
                         [this](const fs::path& path) { write_text_file(path, manifest()); }});
        files.push_back({folder_ / "material.gltf", [this](const fs::path& path) {
                             QuadMaterial text =
                                 gltf_material_text(baked_, source_, source_.name, own_file());
                             if (!request_.extras) text.json.erase("extras");
                             write_text_file(path, quad_gltf(quad_, text, "material.bin"));
                         }});
        files.push_back({folder_ / "material.bin",
                         [this](const fs::path& path) { write_bytes(path, quad_bytes(quad_)); }});
        if (own_file() == kTableFile)
            files.push_back({folder_ / kTableFile, [this](const fs::path& path) {
                                 write_tabulated_material(path, *tabulated_of(source_)->material);
                             }});
        if (const Cloth* cloth = cloth_of(source_); own_file() == kDraftFile)
            files.push_back({folder_ / kDraftFile, [cloth](const fs::path& path) {
                                 write_text_file(path, wif_text(*cloth->draft));
                             }});
        if (!request_.preview) return files;
        try {
            preview_ = preview_of(baked_, stage_, request_.gl_device, progress);
        } catch (const Interrupted&) {
            throw;
        } catch (const Error& error) {
            report.warnings.push_back(
                fmt::format("preview.png is left out: {} (--no-preview)", error.what()));
            return files;
        }
        files.push_back({folder_ / "preview.png", [this, metadata](const fs::path& path) {
                             write_image(path, preview_, metadata);
                         }});
        return files;
    }

    std::vector<NamedPicture> pictures() const {
        std::vector<NamedPicture> all;
        for (const Texture& map : baked_.textures)
            all.push_back({map.name + ".png", picture_of(map)});
        return all;
    }

    std::string manifest() const {
        ordered_json out;
        out["format"] = "burnish-material";
        out["version"] = 1;
        out["name"] = source_.name;
        out["gltf"] = "material.gltf";
        const Texture& map = baked_.textures.front();
        out["size"] = {map.width, map.height};
        out["repeats"] = !has_table();
        if (tile_mm_) out["tile_mm"] = {*tile_mm_, *tile_mm_ / gltf_tile_aspect(source_)};
        for (const Texture& texture : baked_.textures) {
            const auto meaning =
                std::find_if(kMeanings.begin(), kMeanings.end(),
                             [&](const MapMeaning& m) { return m.name == texture.name; });
            out["maps"][texture.name] = {{"file", texture.name + ".png"},
                                         {"channels", meaning->channels},
                                         {"color_space", meaning->color_space},
                                         {"bits", texture.type == TexelType::u8 ? 8 : 16}};
        }
        if (!baked_.losses.empty()) out["approximated"] = baked_.losses;
        out["made"] = {{"version", version()}, {"command", request_.command}};
        return out.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
    }

    const ExportMaterialRequest& request_;
    const Stage& stage_;
    const Material& source_;
    fs::path folder_;
    GltfMaterial baked_;
    SampleQuad quad_;
    std::optional<double> tile_mm_;
    Image preview_;
};

}  // namespace

ExportMaterialReport export_material(const ExportMaterialRequest& request,
                                     const Progress& progress) {
    ExportMaterialReport report;
    progress.step("load", 0.0);
    Stage stage = set_stage(request.stage);
    report.warnings = stage.scene.warnings;
    report.notes = stage.scene.notes;
    const std::vector<std::size_t> wanted = chosen(stage.scene.materials, request.material);
    if (is_builtin(request.stage.input))
        if (std::string name = name_of_values(stage.values, stage.scene.materials.front());
            !name.empty())
            stage.scene.materials.front().name = std::move(name);
    if (wanted.size() == 1) {
        FolderWriter(request, stage, wanted.front(), request.output).write(progress, report);
        return report;
    }
    const OutputFolder folder(request.output);
    std::vector<std::string> names;
    for (const std::size_t index : wanted) {
        std::string name = folder_name(stage.scene.materials[index].name, index);
        if (std::find(names.begin(), names.end(), name) != names.end())
            name += fmt::format("_{}", index);
        names.push_back(name);
        FolderWriter(request, stage, index, request.output / name).write(progress, report);
    }
    return report;
}

}  // namespace burnish
