#include "jobs/maps/weave.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "burnish/error.hpp"
#include "burnish/f32.hpp"
#include "burnish/image_io.hpp"
#include "burnish/scene.hpp"
#include "burnish/version.hpp"
#include "burnish/weave_maps.hpp"
#include "burnish/wif.hpp"
#include "core/constants.hpp"
#include "core/files.hpp"
#include "core/memory.hpp"
#include "jobs/map_folder.hpp"
#include "jobs/maps/occlusion_pictures.hpp"
#include "jobs/maps/weave_preview.hpp"
#include "maps/normal/height_occlusion.hpp"
#include "maps/weave/weave_cells.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> kParameters = {
    "weave_crimp", "weave_bulge", "weave_gap", "weave_twist", "warp_color", "weft_color"};
constexpr int kUsualSide = 2048;

// A built-in draft by name, or else a file; a word that is neither is reported as a misspelled
// name.
Draft draft_of(const std::string& weave, std::vector<std::string>& warnings) {
    const auto names = draft_names();
    const bool known = std::find(names.begin(), names.end(), weave) != names.end();
    std::error_code error;
    const bool file = fs::exists(weave, error) || weave.find_first_of("./\\") != weave.npos;
    if (known || !file) return builtin_draft(weave, "weave");
    return load_wif(weave, warnings);
}

// Sets the sides that are not given, with square texels.
void set_size(const WeaveRequest& request, WeaveMapSettings& settings) {
    const double aspect = static_cast<double>(settings.ends()) / settings.picks();
    const auto rounded = [](double side) {
        return static_cast<int>(std::lround(std::min(side, 1e9)));
    };
    settings.width =
        request.width.value_or(request.height ? rounded(*request.height * aspect)
                                              : rounded(kUsualSide * std::min(1.0, aspect)));
    settings.height = request.height.value_or(rounded(settings.width / aspect));
}

// A given color replaces the draft's.
void dye(std::string_view parameter, const ParameterValues& values, glm::vec3& color,
         std::vector<glm::vec3>& of_yarns) {
    if (!values.is_set(parameter)) return;
    color = values.vec3(parameter);
    of_yarns.clear();
}

WeaveMapSettings settings_of(const WeaveRequest& request, std::vector<std::string>& warnings) {
    WeaveMapSettings settings;
    settings.draft = draft_of(request.weave, warnings);
    settings.repeats_u = request.repeats_u.value_or(usual_repeats(settings.draft.ends));
    settings.repeats_v = request.repeats_v.value_or(usual_repeats(settings.draft.picks));
    settings.yarn_mm = request.yarn_mm;
    const ParameterValues& values = request.values;
    const auto real = [&](std::string_view name) { return static_cast<float>(values.real(name)); };
    const float twist = real("weave_twist") * static_cast<float>(kDegree);
    settings.shape.crimp = real("weave_crimp");
    settings.shape.bulge = real("weave_bulge");
    settings.shape.gap = real("weave_gap");
    settings.shape.twist = {std::cos(twist), std::sin(twist)};
    dye("warp_color", values, settings.warp_color, settings.draft.warp_colors);
    dye("weft_color", values, settings.weft_color, settings.draft.weft_colors);
    set_size(request, settings);
    check_weave_map_settings(settings, request.weave);
    return settings;
}

std::vector<NamedPicture> pictures_of(const WeaveMaps& maps, const WeaveMapSettings& settings,
                                      const WeaveReport& report) {
    const auto low = static_cast<float>(report.low_mm);
    const auto range = static_cast<float>(report.high_mm - report.low_mm);
    const float scale = range > 0.0f ? 1.0f / range : 0.0f;
    const auto heights = [&maps](int begin, int end, float* to, const auto& value) {
        const float* from = maps.heights.at(0, begin);
        std::transform(from, from + static_cast<std::ptrdiff_t>(end - begin) * maps.width, to,
                       value);
    };
    const auto rgb = [&maps](DataFormat format, auto rows) {
        return picture_of_rows(format, kRgb, maps.width, maps.height, std::move(rows));
    };
    const auto gray = [&maps](DataFormat format, auto rows) {
        return picture_of_rows(format, {"Y"}, maps.width, maps.height, std::move(rows));
    };
    std::vector<NamedPicture> all;
    all.push_back({"height.exr", gray(DataFormat::exr, [=](int begin, int end, float* to) {
                       heights(begin, end, to, [](float h) { return h; });
                   })});
    all.push_back({"height.png", gray(DataFormat::png16, [=](int begin, int end, float* to) {
                       heights(begin, end, to, [=](float h) { return (h - low) * scale; });
                   })});
    all.push_back({"normal.png", rgb(DataFormat::png16, [&maps](int begin, int end, float* to) {
                       weave_normal_rows(maps, begin, end, to);
                   })});
    all.push_back({"direction.png", rgb(DataFormat::png16, [&maps](int begin, int end, float* to) {
                       weave_direction_rows(maps, begin, end, to);
                   })});
    all.push_back(
        {"color.png", rgb(DataFormat::png8_srgb, [&maps, &settings](int begin, int end, float* to) {
             weave_color_rows(maps, settings, begin, end, to);
         })});
    all.push_back(
        {"id.png", rgb(DataFormat::png16, [&maps, &settings](int begin, int end, float* to) {
             weave_id_rows(maps, settings, begin, end, to);
         })});
    return all;
}

// The lobe of the fibers of a usual cloth, disorder included, in glTF's terms.
void append_lobe_pictures(const WeaveMaps& maps, const Image& occlusion,
                          std::vector<NamedPicture>& pictures) {
    const Cloth usual;
    const f32::Lobe lobe =
        f32::widen_lobe(f32::lobe_from_alpha(f32::kMdfGgx, usual.alpha.x, usual.alpha.y),
                        usual.fuzz * usual.fuzz, usual.fuzz * usual.fuzz);
    const float along = std::min(lobe.p0, lobe.p1), across = std::max(lobe.p0, lobe.p1);
    const float strength = std::sqrt((across - along) / (1.0f - along));
    std::ranges::move(occlusion_pictures(occlusion, std::sqrt(along), 0.0f),
                      std::back_inserter(pictures));
    pictures.push_back(
        {"anisotropy.png", picture_of_rows(DataFormat::png16, kRgb, maps.width, maps.height,
                                           [&maps, strength](int begin, int end, float* to) {
                                               weave_stretch_rows(maps, strength, begin, end, to);
                                           })});
}

using Metadata = std::map<std::string, std::string>;

Metadata metadata_of(const WeaveRequest& request, const WeaveMapSettings& settings,
                     const WeaveReport& report) {
    return {{"burnish:version", std::string(version())},
            {"burnish:command", request.command},
            {"burnish:process", std::string(name_of(kWeaveProcess))},
            {"burnish:weave", one_line(settings.draft.name)},
            {"burnish:width_mm", fmt::format("{}", settings.width_mm())},
            {"burnish:height_mm", fmt::format("{}", settings.height_mm())},
            {"burnish:height_black_mm", fmt::format("{}", report.low_mm)},
            {"burnish:height_white_mm", fmt::format("{}", report.high_mm)}};
}

// Describes the maps in JSON, for readers and programs.
std::string summary_of(const WeaveRequest& request, const WeaveMapSettings& settings,
                       const WeaveReport& report) {
    nlohmann::ordered_json out;
    out["format"] = "burnish-weave";
    out["version"] = 1;
    out["weave"] = settings.draft.name;
    out["draft"] = "draft.wif";
    out["size"] = {settings.width, settings.height};
    out["repeats"] = {settings.repeats_u, settings.repeats_v};
    out["yarns"] = {settings.ends(), settings.picks()};
    out["yarn_mm"] = settings.yarn_mm;
    out["tile_mm"] = {settings.width_mm(), settings.height_mm()};
    for (const std::string_view name : kParameters) {
        if (!request.values.has_value(name)) continue;
        auto& value = out["parameters"][std::string(name)];
        if (find_parameter(name)->kind == ParameterKind::color) {
            const glm::vec3 c = request.values.vec3(name);
            value = {c.x, c.y, c.z};
        } else {
            value = request.values.real(name);
        }
    }
    out["made"] = {{"version", version()},
                   {"command", request.command},
                   {"process", name_of(kWeaveProcess)},
                   {"height_png_black_mm", report.low_mm},
                   {"height_png_white_mm", report.high_mm}};
    // Titles of drafts need not be UTF-8.
    return out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

std::span<const std::string_view> weave_map_parameters() {
    return kParameters;
}

WeaveReport make_weave_maps(const WeaveRequest& request, const Progress& progress) {
    WeaveReport report;
    const WeaveMapSettings settings = settings_of(request, report.warnings);
    report.memory = weave_map_memory(settings);
    const OutputFolder folder(request.output);
    const WeaveMaps maps = bake_weave(settings, available_memory(), progress);
    const auto [low, high] =
        std::minmax_element(maps.heights.pixels.begin(), maps.heights.pixels.end());
    report.low_mm = static_cast<double>(*low);
    report.high_mm = static_cast<double>(*high);

    const Metadata metadata = metadata_of(request, settings, report);
    std::vector<FileToWrite> others;
    others.push_back({request.output / "weave.json", [&](const fs::path& path) {
                          write_text_file(path, summary_of(request, settings, report));
                      }});
    others.push_back({request.output / "draft.wif", [&](const fs::path& path) {
                          write_text_file(path, wif_text(settings.draft));
                      }});
    others.push_back({request.output / "preview.png", [&](const fs::path& path) {
                          write_image(path, weave_preview(maps, settings), metadata);
                      }});
    std::vector<NamedPicture> pictures = pictures_of(maps, settings, report);
    Image occlusion;
    if (request.orm) {
        occlusion = height_occlusion(maps.heights, settings.width_mm() / maps.width,
                                     settings.height_mm() / maps.height, progress);
        append_lobe_pictures(maps, occlusion, pictures);
    }
    report.written = write_map_folder(request.output, std::move(others), std::move(pictures),
                                      metadata, progress);
    return report;
}

}  // namespace burnish
