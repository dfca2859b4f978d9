#include "jobs/capture/capture_relight.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/load_tabulated.hpp"
#include "burnish/relight.hpp"
#include "burnish/version.hpp"
#include "capture/stack/light_level.hpp"
#include "core/files.hpp"
#include "jobs/map_folder.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;

bool has_mask(const TabulatedMaterial& m) {
    return std::find(m.exemplar.begin(), m.exemplar.end(), TabulatedMaterial::kNoExemplar) !=
           m.exemplar.end();
}

Image mask_of(const TabulatedMaterial& m) {
    Image out(m.width, m.height, 1);
    for (std::size_t i = 0; i < out.pixels.size(); ++i)
        out.pixels[i] = m.exemplar[i] == TabulatedMaterial::kNoExemplar ? 0.0f : 1.0f;
    return out;
}

// The name of a light's picture without folders and ending, those of other machines too; empty if
// it names none.
std::string stem_of(const RigLight& light) {
    if (light.images.empty()) return {};
    std::string name = light.images.front().image.string();
    std::replace(name.begin(), name.end(), '\\', '/');
    return fs::path(name).stem().string();
}

// The names of the pictures to be written: those of the rig's, where each light has one of its own;
// else numbers.
std::vector<std::string> picture_names(const Rig& rig, std::vector<std::string>& warnings) {
    std::vector<std::string> names;
    std::map<std::string, std::size_t> lights;  // by their names in small letters
    std::string reason;
    for (std::size_t k = 0; k < rig.lights.size(); ++k) {
        const std::string stem = stem_of(rig.lights[k]);
        std::string letters = stem;
        for (char& c : letters)
            if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        const auto [first, is_new] = lights.emplace(letters, k);
        if (!is_new && !stem.empty() && reason.empty())
            reason = fmt::format("two pictures of the rig are named {}, those of {} and {}",
                                 shown(stem), rig.lights[first->second].where, rig.lights[k].where);
        names.push_back(stem + ".exr");
    }
    const bool all_named = !lights.contains("");
    if (!reason.empty())
        warnings.push_back(fmt::format("{}: {}: the written pictures are numbered, 0000.exr and on",
                                       rig.file.string(), reason));
    if (all_named && reason.empty()) return names;
    for (std::size_t k = 0; k < names.size(); ++k) names[k] = fmt::format("{:04}.exr", k);
    return names;
}

// Throws if a picture to be written is one of the pictures that are read.
void require_other_files(const Rig& rendered, const fs::path& folder,
                         std::initializer_list<const Rig*> read) {
    std::map<fs::path, fs::path> written;  // by name
    for (const RigLight& light : rendered.lights)
        written[light.images.front().image.filename()] = light.images.front().image;
    for (const Rig* rig : read)
        for (const RigLight& light : rig->lights)
            for (const RigExposure& exposure : light.images) {
                const auto same = written.find(exposure.image.filename());
                std::error_code error;
                if (same != written.end() && fs::equivalent(same->second, exposure.image, error))
                    throw Error(folder.string(), "", "a folder without the pictures of the rig",
                                shown(exposure.image.string()));
            }
}

// The rig of the written pictures, which form a stack.
Rig rendered_rig(const Rig& rig, const TabulatedMaterial& m, const fs::path& folder,
                 std::vector<std::string>& warnings) {
    Rig out = rig;
    out.response = RigResponse::linear;
    out.white.reset();
    out.mask.reset();
    if (has_mask(m)) out.mask = folder / "mask.png";
    const std::vector<std::string> names = picture_names(rig, warnings);
    for (std::size_t k = 0; k < out.lights.size(); ++k)
        out.lights[k].images = {{folder / names[k], 1.0}};
    return out;
}

std::string csv_of(const Rig& stack, const StackError& error) {
    std::string out = "light,picture,samples,rmse,psnr\n";
    for (std::size_t k = 0; k < error.lights.size(); ++k) {
        const LightError& light = error.lights[k];
        std::string name = stack.lights[k].images.front().image.filename().string();
        for (std::size_t at = 0; (at = name.find('"', at)) != name.npos; at += 2)
            name.insert(at, "\"");
        out += fmt::format("{},\"{}\",{},{:.6g},{:.3f}\n", k, one_line(name), light.samples,
                           light.rmse, light.psnr);
    }
    return out;
}

std::unique_ptr<StackComparison> comparison_of(const CaptureRelightRequest& request, const Rig& rig,
                                               const TabulatedMaterial& m, Rig& stack,
                                               std::vector<std::string>& warnings) {
    if (!request.compare) return nullptr;
    stack = read_rig(*request.compare, true, request.overrides);
    if (*request.compare != request.rig)
        for (std::string& warning : warnings_of(stack)) warnings.push_back(std::move(warning));
    if (stack.lights.size() != rig.lights.size())
        throw Error(request.compare->string(), "lights",
                    fmt::format("{}, as {} has", rig.lights.size(), request.rig.string()),
                    std::to_string(stack.lights.size()));
    return std::make_unique<StackComparison>(stack, m);
}

}  // namespace

std::vector<std::string> warnings_of(const Rig& rig) {
    std::vector<std::string> out;
    for (const std::string& warning : rig.warnings)
        out.push_back(fmt::format("{}: {}", rig.file.string(), warning));
    return out;
}

void take_size_of(const TabulatedMaterial& m, Rig& rig, std::vector<std::string>& warnings) {
    if (m.width_mm > 0.0 && m.height_mm > 0.0) {
        const double ratio = rig.width_mm / m.width_mm;
        if (rig.width_mm > 0.0 && std::abs(ratio - 1.0) > 0.01)
            warnings.push_back(fmt::format(
                "{}: sample: {:.4g} mm wide, but the material is {:.4g} mm wide, as which it is "
                "rendered",
                rig.file.string(), rig.width_mm, m.width_mm));
        rig.width_mm = m.width_mm;
        rig.height_mm = m.height_mm;
        return;
    }
    if (rig.width_mm > 0.0 && rig.height_mm > 0.0) return;
    rig.width_mm = m.width;
    rig.height_mm = m.height;
    warnings.push_back(fmt::format(
        "{}: neither the rig nor the material says how large the sample is; taken as 1 mm a texel",
        rig.file.string()));
}

void take_level_of(const TabulatedMaterial& m, Rig& rig, std::vector<std::string>& warnings) {
    const double factor = recorded_factor(m.metadata, rig);
    if (factor == 1.0) return;
    multiply_intensities(rig, factor);
    warnings.push_back(fmt::format(
        "{}: no intensity of the lights is stated: all are multiplied by {:.4g}, so that pictures "
        "are as bright as those that the material was fitted to",
        rig.file.string(), factor));
}

CaptureRelightResult capture_relight(const CaptureRelightRequest& request,
                                     const Progress& progress) {
    CaptureRelightResult report;
    const auto material = load_tabulated(request.material);
    Rig rig = read_rig(request.rig, false, request.overrides);
    report.warnings = warnings_of(rig);
    take_size_of(*material, rig, report.warnings);
    take_level_of(*material, rig, report.warnings);
    Rig stack;
    const auto comparison = comparison_of(request, rig, *material, stack, report.warnings);
    const Rig rendered = rendered_rig(rig, *material, request.output, report.warnings);
    require_other_files(rendered, request.output, {&rig, &stack});
    const OutputFolder folder(request.output);
    const Relighter relighter(*material);
    const std::map<std::string, std::string> metadata = {
        {"burnish:version", std::string(version())}, {"burnish:command", request.command}};

    // The first file is renamed to its final name last: if rig.json exists, all pictures do.
    std::vector<FileToWrite> files;
    files.push_back(
        {request.output / "rig.json", [&](const fs::path& path) { write_rig(path, rendered); }});
    if (rendered.mask)
        files.push_back({*rendered.mask, [&](const fs::path& path) {
                             write_image(path, mask_of(*material), metadata);
                         }});
    const auto count = rig.lights.size();
    for (std::size_t k = 0; k < count; ++k)
        files.push_back({rendered.lights[k].images.front().image, [&, k](const fs::path& path) {
                             progress.step("relight",
                                           static_cast<double>(k) / static_cast<double>(count));
                             const Image picture = relighter.picture(rig, k);
                             write_image(path, picture, metadata);
                             if (comparison) comparison->add(k, picture);
                         }});
    // This file is written last, after all pictures have been compared.
    if (comparison)
        files.push_back({request.output / "compare.csv", [&](const fs::path& path) {
                             report.error = comparison->result();
                             write_text_file(path, csv_of(stack, *report.error));
                         }});
    write_files_whole(files);
    for (const FileToWrite& file : files) report.written.push_back(file.path);
    return report;
}

}  // namespace burnish
