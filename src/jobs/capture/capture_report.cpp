#include "jobs/capture/capture_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/load_tabulated.hpp"
#include "burnish/version.hpp"
#include "capture/solve/capture_fit.hpp"
#include "core/files.hpp"
#include "jobs/capture/capture_relight.hpp"
#include "jobs/capture/capture_report_parts.hpp"
#include "jobs/info/info_rig.hpp"
#include "jobs/map_folder.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;

// Checks the size before all pictures are read.
void require_same_size(const Rig& rig, const TabulatedMaterial& m) {
    const fs::path& first = rig.lights.front().images.front().image;
    const ImageInfo info = read_image_info(first);
    if (info.width == m.width && info.height == m.height) return;
    throw Error(first.string(), "",
                fmt::format("{} x {} pixels, as the material has", m.width, m.height),
                fmt::format("{} x {}", info.width, info.height));
}

// Reads the stack into a cache file without a name, which the system removes when it is closed.
std::unique_ptr<ImageStack> open_stack(const Rig& rig, const fs::path& folder,
                                       const Progress& progress) {
    const fs::path cache = folder / ".pictures.bin";
    auto stack = std::make_unique<ImageStack>(rig, cache, progress);
    fs::remove(cache);
    return stack;
}

// The `--hold-out` of the command that made the material; 0: none recorded.
int recorded_hold_out(const TabulatedMaterial& m) {
    constexpr std::string_view kFlag = "--hold-out";
    const auto found = m.metadata.find("burnish:command");
    if (found == m.metadata.end()) return 0;
    const std::size_t at = found->second.find(kFlag);
    if (at == std::string::npos) return 0;
    std::string_view rest = std::string_view(found->second).substr(at + kFlag.size());
    rest.remove_prefix(std::min(rest.find_first_not_of(" ='\""), rest.size()));
    int value = 0;
    std::from_chars(rest.data(), rest.data() + rest.size(), value);
    return std::max(value, 0);
}

// Chooses the lights that judge the fit: 0 in the result of fitted_lights.
std::vector<std::uint8_t> judges(const CaptureReportRequest& request, const TabulatedMaterial& m,
                                 const Rig& rig, std::string& text) {
    constexpr int kUsual = 10;
    const int recorded = recorded_hold_out(m);
    const auto lights = static_cast<int>(rig.lights.size());
    int every = request.hold_out.value_or(recorded);
    const bool apart = every >= 2;
    if (!apart) every = std::clamp(lights / 2, 2, kUsual);
    std::vector<std::uint8_t> keep = fitted_lights(rig.lights.size(), every);
    const auto count = std::count(keep.begin(), keep.end(), 0);
    if (count == 0)
        throw Error(rig.file.string(), "lights",
                    fmt::format("more than {}, of which every {}th is held out", every / 2, every),
                    fmt::to_string(lights));
    if (!apart)
        text = fmt::format(
            "Judged on {} of {} lights, which took part in the fit: how well it describes what it "
            "was given, not how well it predicts. capture fit --hold-out keeps lights apart.",
            count, lights);
    else if (!request.hold_out)
        text = fmt::format(
            "Judged on {} of {} lights, which took no part in the fit, as the material's file says "
            "(--hold-out {}).",
            count, lights, every);
    else if (recorded == every)
        text =
            fmt::format("Judged on {} of {} lights, which took no part in the fit.", count, lights);
    else
        text = fmt::format(
            "Judged on {} of {} lights, every {}th, as was asked for; the material's file {}.",
            count, lights, every,
            recorded > 0 ? fmt::format("says that every {}th took no part", recorded)
                         : std::string("does not say that any of them took no part"));
    return keep;
}

void write_report(const CaptureReportRequest& request, const report::Page& page,
                  const report::Pictures& pictures, CaptureReportResult& result) {
    const std::map<std::string, std::string> metadata = {
        {"burnish:version", std::string(version())}, {"burnish:command", request.command}};
    std::vector<FileToWrite> files;
    // The first file is renamed to its final name last: if the page exists, so do its pictures.
    files.push_back({request.output / "index.html", [&](const fs::path& path) {
                         write_text_file(path, report::page_html(page));
                     }});
    for (const report::Picture& picture : pictures)
        files.push_back({request.output / picture.name, [&](const fs::path& path) {
                             write_image(path, picture.image, metadata);
                         }});
    write_files_whole(files);
    for (const FileToWrite& file : files) result.written.push_back(file.path);
}

}  // namespace

CaptureReportResult capture_report(const CaptureReportRequest& request, const Progress& progress) {
    CaptureReportResult result;
    const auto material = load_tabulated(request.material);
    Rig rig = read_rig(request.stack, true, request.overrides);
    result.warnings = warnings_of(rig);
    require_same_size(rig, *material);
    take_size_of(*material, rig, result.warnings);
    take_level_of(*material, rig, result.warnings);

    report::Page page;
    report::Pictures pictures;
    page.request = &request;
    page.material = material.get();
    page.lights = rig.lights.size();
    page.rig_text = describe_rig(request.stack.string(), request.overrides);
    const std::vector<std::uint8_t> keep = judges(request, *material, rig, page.held_out_text);
    const OutputFolder folder(request.output);
    const auto stack = open_stack(rig, request.output, progress);
    page.census = stack->census();
    page.rig_coverage = rig_coverage(rig);
    pictures.push_back(report::coverage_picture(page.rig_coverage, keep));
    page.coverage = pictures.back().name;
    progress.step("fit lobes", 0.0);
    const std::vector<LobeFit> lobes = fit_lobes(*material, Mdf::ggx);
    report::add_exemplars(*material, lobes, page, pictures);
    report::add_maps(*material, lobes, page, pictures);
    report::add_comparison(*stack, rig, *material, keep, page, pictures, progress);
    report::add_renderings(request, page, pictures, progress);
    for (const std::string& warning : result.warnings) page.notes.push_back(warning);
    write_report(request, page, pictures, result);
    return result;
}

}  // namespace burnish
