#include "jobs/maps/scratch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/scratch_maps.hpp"
#include "burnish/version.hpp"
#include "core/files.hpp"
#include "core/memory.hpp"
#include "jobs/map_folder.hpp"
#include "jobs/maps/occlusion_pictures.hpp"
#include "jobs/maps/scratch_preview.hpp"
#include "jobs/maps/scratch_recipe.hpp"
#include "maps/normal/height_occlusion.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;

Image one_channel(const Image& image) {
    if (image.channels == 1) return image;
    Image out(image.width, image.height, 1);
    const auto from = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < out.pixels.size(); ++i) out.pixels[i] = image.pixels[i * from];
    return out;
}

Image read_square(const fs::path& path, int least_channels, const char* channels) {
    const ImageInfo info = read_image_info(path);
    if (info.width != info.height)
        throw Error(path.string(), "size", "a square picture, which is stretched over the tile",
                    fmt::format("{}x{}", info.width, info.height));
    // A gray picture with alpha would have four channels after reading.
    if (info.channels < least_channels)
        throw Error(path.string(), "channels", channels, std::to_string(info.channels));
    return read_image(path, {.as_data = true});
}

// Values of the height, converted by `value`.
DataPicture height_picture(const ScratchMaps& maps, DataFormat format,
                           const std::function<float(float)>& value) {
    return picture_of_rows(
        format, {"Y"}, maps.size, maps.size, [&maps, value](int begin, int end, float* to) {
            std::transform(maps.height.at(0, begin),
                           maps.height.at(0, begin) + (end - begin) * maps.size, to, value);
        });
}

DataPicture direction_picture(const ScratchMaps& maps) {
    return picture_of_rows(
        DataFormat::png16, kRgb, maps.size, maps.size, [&maps](int begin, int end, float* to) {
            const float* from = maps.direction.at(0, begin);
            for (int i = 0; i < (end - begin) * maps.size; ++i, from += 2, to += 3) {
                to[0] = 0.5f + 0.5f * from[0];
                to[1] = 0.5f + 0.5f * from[1];
                to[2] = from[0] == 0.0f && from[1] == 0.0f ? 0.0f : 1.0f;
            }
        });
}

DataPicture moments_picture(const ScratchMaps& maps) {
    DataPicture out = picture_of_rows(
        DataFormat::exr, {"sx", "sy", "sxx", "syy", "sxy"}, maps.size, maps.size,
        [&maps](int begin, int end, float* to) { moment_rows(maps, begin, end, to); });
    for (const MomentLevel& level : maps.moments)
        out.levels.push_back({level.size, level.size, [&level](int begin, int end, float* to) {
                                  const auto side = static_cast<std::size_t>(level.size);
                                  for (std::size_t i = static_cast<std::size_t>(begin) * side;
                                       i < static_cast<std::size_t>(end) * side; ++i) {
                                      const SlopeMoments& m = level.texels[i];
                                      for (const float v : {m.sx, m.sy, m.sxx, m.syy, m.sxy})
                                          *to++ = v;
                                  }
                              }});
    return out;
}

DataPicture anisotropy_picture(const ScratchMaps& maps, const ScratchLayer& ground) {
    return picture_of_rows(DataFormat::png16, kRgb, maps.size, maps.size,
                           [&maps, &ground](int begin, int end, float* to) {
                               stretch_rows(maps, ground, begin, end, to);
                           });
}

DataPicture normal_picture(const ScratchMaps& maps) {
    return picture_of_rows(
        DataFormat::png16, kRgb, maps.size, maps.size,
        [&maps](int begin, int end, float* to) { normal_rows(maps, begin, end, to); });
}

std::vector<NamedPicture> drawn_pictures_of(const ScratchMaps& maps, const ScratchLayer& ground) {
    std::vector<NamedPicture> all;
    all.push_back({"normal.png", normal_picture(maps)});
    all.push_back({"anisotropy.png", anisotropy_picture(maps, ground)});
    return all;
}

std::vector<NamedPicture> pictures_of(const ScratchMaps& maps, const ScratchLayer& ground,
                                      const ScratchReport& report) {
    const auto low = static_cast<float>(report.low_mm);
    const auto range = static_cast<float>(report.high_mm - report.low_mm);
    const float scale = range > 0.0f ? 1.0f / range : 0.0f;
    std::vector<NamedPicture> all;
    all.push_back({"height.exr", height_picture(maps, DataFormat::exr, [](float h) { return h; })});
    all.push_back({"height.png", height_picture(maps, DataFormat::png16,
                                                [=](float h) { return (h - low) * scale; })});
    all.push_back({"normal.png", normal_picture(maps)});
    all.push_back({"direction.png", direction_picture(maps)});
    all.push_back({"anisotropy.png", anisotropy_picture(maps, ground)});
    all.push_back({"moments.exr", moments_picture(maps)});
    return all;
}

void measure(const ScratchMaps& maps, ScratchReport& report) {
    const auto [low, high] =
        std::minmax_element(maps.height.pixels.begin(), maps.height.pixels.end());
    report.low_mm = static_cast<double>(*low);
    report.high_mm = static_cast<double>(*high);
    const SlopeMoments& mean = maps.moments.back().texels.front();
    report.rms_slope = std::sqrt(static_cast<double>(mean.sxx + mean.syy));
}

using Metadata = std::map<std::string, std::string>;

Metadata metadata_of(const ScratchRequest& request, const ScratchReport& report) {
    return {{"burnish:version", std::string(version())},
            {"burnish:command", request.command},
            {"burnish:process", std::string(name_of(kScratchProcess))},
            {"burnish:tile_mm", fmt::format("{}", request.recipe.settings.tile_mm)},
            {"burnish:height_black_mm", fmt::format("{}", report.low_mm)},
            {"burnish:height_white_mm", fmt::format("{}", report.high_mm)}};
}

}  // namespace

ScratchInputs read_scratch_inputs(const ScratchRecipe& recipe) {
    ScratchInputs inputs;
    if (!recipe.wear_mask.empty())
        inputs.wear_mask = one_channel(read_square(recipe.wear_mask, 1, "1 or more"));
    if (!recipe.direction_image.empty())
        inputs.direction =
            read_square(recipe.direction_image, 3, "3 or more: red and green are the direction");
    inputs.direction_is_double_angle = recipe.direction_is_double_angle;
    return inputs;
}

ScratchReport make_scratch_maps(const ScratchRequest& request, const Progress& progress) {
    const ScratchSettings& settings = request.recipe.settings;
    check_scratch_settings(settings, "scratch settings");
    const ScratchInputs inputs = read_scratch_inputs(request.recipe);
    ScratchReport report;
    report.memory = scratch_memory(settings);
    const OutputFolder folder(request.output);
    const ScratchMaps maps = engrave(settings, inputs, available_memory(), progress);
    measure(maps, report);

    const Metadata metadata = metadata_of(request, report);
    std::vector<FileToWrite> others;
    others.push_back({request.output / "scratch.json", [&](const fs::path& path) {
                          write_text_file(
                              path, scratch_recipe_text(request.recipe, report, request.command,
                                                        request.output));
                      }});
    if (!request.drawn_only)
        others.push_back({request.output / "preview.png", [&](const fs::path& path) {
                              write_image(path, scratch_preview(maps), metadata);
                          }});
    const ScratchLayer& ground = settings.layers.front();
    std::vector<NamedPicture> pictures =
        request.drawn_only ? drawn_pictures_of(maps, ground) : pictures_of(maps, ground, report);
    Image occlusion;
    if (request.orm) {
        const double texel_mm = maps.tile_mm / maps.size;
        occlusion = height_occlusion(maps.height, texel_mm, texel_mm, progress);
        std::ranges::move(occlusion_pictures(occlusion, kScratchOrmRoughness, 1.0f),
                          std::back_inserter(pictures));
    }
    report.written = write_map_folder(request.output, std::move(others), std::move(pictures),
                                      metadata, progress);
    return report;
}

}  // namespace burnish
