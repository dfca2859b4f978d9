#include "jobs/info/info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>

#include "burnish/builtin_meshes.hpp"
#include "burnish/context.hpp"
#include "burnish/environments.hpp"
#include "burnish/f64.hpp"
#include "burnish/image_io.hpp"
#include "burnish/load_model.hpp"
#include "burnish/rig.hpp"
#include "burnish/scene_file.hpp"
#include "burnish/tabulated_file.hpp"
#include "burnish/tabulated_material.hpp"
#include "burnish/wif.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "formats/bsdf/tensor_file.hpp"
#include "image/guard/format.hpp"
#include "jobs/info/info_draft.hpp"
#include "jobs/info/info_folder.hpp"
#include "jobs/info/info_measured.hpp"
#include "jobs/info/info_rig.hpp"
#include "jobs/info/info_scene.hpp"
#include "jobs/info/info_tabulated.hpp"
#include "stage/normal_map_check.hpp"

namespace burnish {

namespace {

// Radiance statistics weighted by solid angle, for pictures that may be environments.
std::string describe_radiance(const Image& image) {
    double sum = 0, weights = 0, peak = 0;
    for (int y = 0; y < image.height; ++y) {
        const double weight = std::sin((y + 0.5) / image.height * 3.14159265358979);
        for (int x = 0; x < image.width; ++x) {
            const float* p = image.at(x, y);
            const double luminance =
                image.channels < 3 ? static_cast<double>(p[0])
                                   : f64::luminance({double{p[0]}, double{p[1]}, double{p[2]}});
            sum += weight * luminance;
            weights += weight;
            peak = std::max(peak, luminance);
        }
    }
    return fmt::format("  as an environment: mean radiance {:.4g}, brightest {:.4g}\n",
                       sum / weights, peak);
}

// Metadata that OpenImageIO adds, and the default window of OpenEXR.
bool is_of_the_library(std::string_view key) {
    return key.starts_with("oiio:") || key.starts_with("screenWindow");
}

// Replaces `warnings` by those of reading the picture as an environment, which has them all.
std::string describe_as_environment(const std::string& path, std::vector<std::string>& warnings) {
    warnings.clear();
    return describe_radiance(load_environment(path, &warnings).radiance);
}

std::string describe_image(const std::string& path) {
    ImageInfo info = read_image_info(path);
    std::string text =
        fmt::format("{}: {} image, {}x{}, {}, {}\n", path, info.format, info.width, info.height,
                    plural(static_cast<std::size_t>(info.channels), "channel"), info.pixel_type);
    for (const auto& [key, value] : info.metadata)
        if (!is_of_the_library(key)) text += fmt::format("  {}: {}\n", key, value);
    if (info.width == 2 * info.height) text += describe_as_environment(path, info.warnings);
    for (const std::string& warning : info.warnings) text += fmt::format("  {}\n", warning);
    return text;
}

// Whether the file is a picture of a format that is not read.
bool is_unread_image(const std::string& path) {
    return is_foreign_image(read_file_head(path, kImageHeadBytes));
}

}  // namespace

std::string describe_file(const std::string& path) {
    constexpr std::string_view kBuiltin = "builtin:";
    const auto shapes = builtin_names();
    const bool mesh =
        path.starts_with(kBuiltin) &&
        std::find(shapes.begin(), shapes.end(), path.substr(kBuiltin.size())) != shapes.end();
    if (!mesh && path.starts_with(kBuiltin)) {
        const Environment environment = load_environment(path);
        return fmt::format("{}: environment, {}x{}\n{}", path, environment.radiance.width,
                           environment.radiance.height, describe_radiance(environment.radiance));
    }
    std::error_code error;
    if (!mesh && std::filesystem::is_directory(path, error)) return describe_folder(path);
    if (!mesh && is_tensor_file(path)) return describe_measured(path);
    if (!mesh && is_wif_file(path)) return describe_draft(path);
    if (!mesh && is_tabulated_material(path)) return describe_tabulated(path);
    if (!mesh && is_image_file(path)) return describe_image(path);
    if (!mesh && is_unread_image(path)) return describe_image(path);  // an error that says why
    // Before scenes: they are JSON too.
    if (const auto text = mesh ? std::nullopt : describe_own_description(path)) return *text;
    if (!mesh && is_rig_file(path)) return describe_rig(path);
    if (!mesh && is_scene_file(path)) return describe_scene_file(path);
    Scene scene = load_model(path);
    warn_of_odd_normal_maps(scene);
    return describe_scene(path, scene);
}

std::string describe_devices() {
    std::string text;
    for (const gpu::DeviceInfo& device : gpu::list_devices())
        text += fmt::format("device {}: {}{}\n", device.index, device.description,
                            device.software ? " (software)" : "");
    return text.empty() ? "no EGL device; Mesa's surfaceless software renderer is used\n" : text;
}

}  // namespace burnish
