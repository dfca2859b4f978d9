#include "jobs/render.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "burnish/context.hpp"
#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/render.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "burnish/stage.hpp"
#include "burnish/version.hpp"
#include "core/files.hpp"
#include "jobs/film.hpp"
#include "jobs/lit_visibility.hpp"
#include "jobs/turntable.hpp"
#include "plot/sheet.hpp"
#include "rays/closed_in_lights.hpp"
#include "stage/material_parameters.hpp"

namespace burnish {

namespace {

void check(const RenderRequest& request) {
    if (!is_film(request.output)) require_image_extension(request.output);
    check_turntable(request);
    const bool sheet = !request.compare.empty();
    if (sheet && request.compare.size() < 2)
        throw UsageError("--compare", "", "two or more methods", "one");
    if (sheet && request.turntable > 0)
        throw UsageError("--compare", "", "no --turntable beside it", "both");
    if (sheet && request.stage.values.is_set("method"))
        throw UsageError("--compare", "", "no --method beside it", "both");
    if (sheet && request.stage.values.is_set("process"))
        throw UsageError("--compare", "", "no --process beside it", "both");
    for (const Method method : request.compare)
        if (std::count(request.compare.begin(), request.compare.end(), method) > 1)
            throw UsageError("--compare", "", "each method once",
                             fmt::format("{} again", name_of(method)));
    if (sheet && holds_linear(request.output))
        throw UsageError(request.output.string(), "", "a .png, .jpg or .tif for a labelled sheet",
                         request.output.extension().string());
}

// Warns of requested transparency that the output cannot hold; empty: nothing is lost.
std::string warning_of_lost_transparency(const RenderRequest& request, const Stage& stage) {
    if (stage.settings.background != BackgroundKind::transparent) return "";
    if (!request.compare.empty()) return "--background transparent: a comparison sheet is opaque";
    if (is_film(request.output))
        return film_holds_alpha(request.output)
                   ? ""
                   : fmt::format(
                         "--background transparent: {} keeps no transparency (.apng does): "
                         "--background-color is behind the model",
                         request.output.extension().string());
    if (holds_alpha(request.output)) return "";
    return fmt::format(
        "--background transparent: {} keeps no transparency (.png, .tif and .exr do)",
        request.output.extension().string());
}

// Warns of parameters that the format of the output leaves without effect.
void warn_of_format(const RenderRequest& request, const Stage& stage,
                    std::vector<std::string>& warnings) {
    const std::string ending = request.output.extension().string();
    const auto warn = [&](std::string_view name, std::string_view why) {
        if (stage.values.is_set(name))
            warnings.push_back(fmt::format("{}: {} {}: nothing changes", name, ending, why));
    };
    if (holds_linear(request.output)) {
        warn("robust_mean", "holds the plain mean");
        warn("bit_depth", "holds 32-bit floats");
        warn("dither", "holds 32-bit floats");
        return;
    }
    if (!holds_alpha(request.output)) warn("bit_depth", "holds 8 bits a channel");
    if (write_options(stage.values).bits == 16 && holds_alpha(request.output))
        warn("dither", "of 16 bits shows no bands");
}

// Checks all pictures of a sheet before the first one is drawn.
void require_drawable(const std::vector<Material>& materials, const std::vector<Method>& methods) {
    for (const Method method : methods)
        for (const Material& material : materials) require_drawable(material, method);
}

void set_method(std::vector<Material>& materials, Method method) {
    for (Material& material : materials) material.method = method;
}

// Row 1: the pictures. Row 2: the difference of each from the reference, `follow-grain` if it is
// among them, else the last.
Image comparison_sheet(const std::vector<Method>& methods, const std::vector<Image>& pictures) {
    const auto grain = std::find(methods.begin(), methods.end(), Method::follow_grain);
    const std::size_t reference = grain == methods.end()
                                      ? methods.size() - 1
                                      : static_cast<std::size_t>(grain - methods.begin());
    const std::string reference_name(name_of(methods[reference]));
    const float gain = difference_gain(pictures[reference], pictures);
    std::vector<std::vector<SheetCell>> rows(2);
    for (std::size_t i = 0; i < methods.size(); ++i) {
        const std::string name(name_of(methods[i]));
        rows[0].push_back({pictures[i], name});
        if (i == reference) {
            rows[1].push_back({Image{}, "differences are against this"});
            continue;
        }
        rows[1].push_back(
            {difference_image(pictures[reference], pictures[i], gain),
             fmt::format("{} minus {}, shown x{:g}; RMSE {:.4f}", name, reference_name, gain,
                         rmse(pictures[i], pictures[reference]))});
    }
    return compose_sheet(rows);
}

void render_comparison(const RenderRequest& request, Stage& stage, gpu::Renderer& renderer,
                       const Metadata& metadata, const Progress& progress) {
    std::vector<Image> pictures;
    for (std::size_t i = 0; i < request.compare.size(); ++i) {
        set_method(stage.scene.materials, request.compare[i]);
        renderer.set_materials(stage.scene.materials);
        const Image linear = renderer.render(stage.camera, stage.settings,
                                             part_of(progress, i, request.compare.size()));
        pictures.push_back(to_display(linear, stage.exposure_ev, stage.tone_map));
    }
    write_image(request.output, comparison_sheet(request.compare, pictures), metadata,
                write_options(stage.values));
}

// A still or a sheet.
RenderReport render_one(const RenderRequest& request, Stage& stage, const Progress& progress) {
    gpu::Context context(request.gl_device);
    gpu::Renderer renderer(context);
    const LitVisibility visibility = put_stage(renderer, stage, progress);
    Metadata metadata = picture_metadata(request.command, stage);
    metadata["burnish:device"] = context.renderer();
    if (!request.compare.empty())
        render_comparison(request, stage, renderer, metadata, progress);
    else
        write_picture(request.output, renderer.render(stage.camera, stage.settings, progress),
                      stage, metadata);
    return {{request.output}, visibility.warnings(), {}, context.renderer()};
}

}  // namespace

std::filesystem::path numbered(const std::filesystem::path& path, int number) {
    return path.parent_path() /
           fmt::format("{}_{:04d}{}", path.stem().string(), number, path.extension().string());
}

Metadata picture_metadata(const std::string& command, const Stage& stage) {
    std::string parameters;
    for (const auto& [name, value] : stage.values.set_values())
        parameters += fmt::format("{}{}={}", parameters.empty() ? "" : "; ", name,
                                  text_of(*find_parameter(name), value));
    return {{"burnish:version", std::string(version())},
            {"burnish:command", command},
            {"burnish:parameters", parameters},
            {"burnish:environment", stage.environment.name}};
}

void write_picture(const std::filesystem::path& path, const Image& linear, const Stage& stage,
                   const Metadata& metadata) {
    const bool keep = holds_linear(path);
    write_image(path, keep ? linear : to_display(linear, stage.exposure_ev, stage.tone_map),
                metadata, write_options(stage.values));
}

Progress part_of(const Progress& whole, std::size_t index, std::size_t count) {
    return whole.with_report([=](std::string_view stage, double done) {
        whole.step(stage, (static_cast<double>(index) + done) / static_cast<double>(count));
    });
}

RenderReport render(const RenderRequest& request, const Progress& progress) {
    check(request);
    require_writable(request.output);
    if (is_film(request.output)) require_film_maker(request.output);
    progress.step("load", 0);
    StageRequest asked = request.stage;
    // Warnings are those of a method of the sheet, a deformation where there is one.
    for (const Method method : request.compare)
        if (method == request.compare.front() || is_deformation(method))
            asked.values.set_value("method", ParameterChoice{static_cast<int>(method)});
    Stage stage = set_stage(asked, request.turntable > 0);
    if (!request.compare.empty()) stage.values.erase("method");
    require_drawable(stage.scene.materials, request.compare);
    if (!holds_linear(request.output)) stage.settings.robust_limit = robust_limit(stage.values);

    std::vector<std::string> warnings = stage.scene.warnings;
    const std::string lost = warning_of_lost_transparency(request, stage);
    if (!lost.empty()) warnings.push_back(lost);
    warn_of_format(request, stage, warnings);
    if (stage.settings.shadows)
        for (std::string& line : warnings_of_closed_in_lights(stage.scene))
            warnings.push_back(std::move(line));
    RenderReport report =
        request.turntable > 0
            ? render_turntable(request, stage, picture_metadata(request.command, stage), progress)
            : render_one(request, stage, progress);
    report.warnings.insert(report.warnings.begin(), warnings.begin(), warnings.end());
    report.notes.insert(report.notes.begin(), stage.scene.notes.begin(), stage.scene.notes.end());
    return report;
}

}  // namespace burnish
