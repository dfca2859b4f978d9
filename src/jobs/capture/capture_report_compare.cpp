// Compares pictures of held-out lights with the predictions of the material and other models.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "burnish/compare.hpp"
#include "burnish/f64.hpp"
#include "burnish/image_io.hpp"
#include "burnish/plot/color_map.hpp"
#include "burnish/relight.hpp"
#include "capture/model/parametric_maps.hpp"
#include "capture/stack/light_geometry.hpp"
#include "core/constants.hpp"
#include "core/statistics.hpp"
#include "jobs/capture/capture_report_parts.hpp"

namespace burnish::report {

namespace {

// Difference relative to white that is shown in full color.
constexpr double kFullDifference = 0.25;
// Quantile of a picture's samples that is shown as white.
constexpr double kWhiteQuantile = 0.995;

double luminance(const float* rgb) {
    return f64::luminance(f64::vec3(static_cast<double>(rgb[0]), static_cast<double>(rgb[1]),
                                    static_cast<double>(rgb[2])));
}

// Calls use(texel, values) with the values of all lights, for every texel with an exemplar.
template <typename Use>
void for_texels(const ImageStack& stack, const TabulatedMaterial& m, const char* what,
                const Progress& progress, Use use) {
    constexpr std::size_t kTile = 256;
    const std::size_t per_texel = 3 * stack.lights();
    std::vector<float> values(kTile * per_texel);
    for (std::size_t b = 0; b < stack.bands(); ++b) {
        progress.step(what, static_cast<double>(b) / static_cast<double>(stack.bands()));
        const StackBand band = stack.load(b);
        for (std::size_t from = 0; from < band.pixels; from += kTile) {
            const std::size_t count = std::min(kTile, band.pixels - from);
            stack.decode(band, from, count, values.data());
            for (std::size_t k = 0; k < count; ++k) {
                const std::size_t t = band.first + from + k;
                if (stack.mask()[t] && m.exemplar[t] != TabulatedMaterial::kNoExemplar)
                    use(t, values.data() + k * per_texel);
            }
        }
    }
}

// Mean luminance of every judging light, and the brightest sample of them all.
struct Levels {
    std::vector<double> mean;
    double peak = 0.0;
};

Levels levels_of(const ImageStack& stack, const TabulatedMaterial& m,
                 const std::vector<std::size_t>& lights, const Progress& progress) {
    Levels levels;
    levels.mean.assign(lights.size(), 0.0);
    std::vector<double> counts(lights.size(), 0.0);
    for_texels(stack, m, "levels", progress, [&](std::size_t, const float* values) {
        for (std::size_t k = 0; k < lights.size(); ++k) {
            const double v = luminance(values + 3 * lights[k]);
            if (!std::isfinite(v)) continue;
            levels.mean[k] += v;
            counts[k] += 1.0;
            levels.peak = std::max(levels.peak, v);
        }
    });
    for (std::size_t k = 0; k < lights.size(); ++k) levels.mean[k] /= std::max(counts[k], 1.0);
    return levels;
}

// Chooses the brightest, the median and the dimmest light, among lights as high as a fit requires.
std::vector<std::pair<std::size_t, std::string>> chosen(const Rig& rig,
                                                        const std::vector<std::size_t>& lights,
                                                        const Levels& levels) {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < lights.size(); ++k)
        if (arrival(rig.lights[lights[k]], {0.0, 0.0, 0.0}).to_light[2] >=
            static_cast<double>(kLeastLightCosine))
            order.emplace_back(levels.mean[k], lights[k]);
    std::sort(order.begin(), order.end(), std::greater<>());
    std::vector<std::pair<std::size_t, std::string>> out;
    if (order.empty()) return out;
    out.emplace_back(order.front().second, "brightest");
    if (order.size() > 2) out.emplace_back(order[order.size() / 2].second, "median");
    if (order.size() > 1) out.emplace_back(order.back().second, "dimmest");
    return out;
}

// Pictures of the lights; infinite where clipped, NaN where nothing was measured.
std::vector<Image> real_pictures(const ImageStack& stack, const TabulatedMaterial& m,
                                 const std::vector<LightEntry>& lights, const Progress& progress) {
    std::vector<Image> out(lights.size(),
                           Image(m.width, m.height, 3, std::numeric_limits<float>::quiet_NaN()));
    for_texels(stack, m, "pictures", progress, [&](std::size_t t, const float* values) {
        for (std::size_t k = 0; k < lights.size(); ++k)
            std::copy_n(values + 3 * lights[k].light, 3, out[k].pixels.data() + 3 * t);
    });
    return out;
}

double white_of(const Image& real) {
    std::vector<double> values;
    for (std::size_t t = 0; t < real.pixels.size(); t += 3) {
        const double v = luminance(real.pixels.data() + t);
        if (std::isfinite(v)) values.push_back(v);
    }
    const double white = values.empty() ? 0.0 : quantile(values, kWhiteQuantile);
    return white > 0.0 ? white : 1.0;
}

constexpr float kMasked = 0.8f;  // display value outside the mask

Image displayed(const Image& linear, const Image& real, double white) {
    Image shown_at = linear;
    const auto scale = static_cast<float>(1.0 / white);
    // Large pictures are averaged in linear light, not in display values.
    const float masked = linear_from_srgb(kMasked);
    for (std::size_t i = 0; i < shown_at.pixels.size(); ++i)
        shown_at.pixels[i] = std::isnan(real.pixels[i])
                                 ? masked
                                 : std::clamp(shown_at.pixels[i] * scale, 0.0f, 1.0f);
    Image out = at_viewing_size(shown_at);
    for (float& v : out.pixels) v = srgb_from_linear(v);
    return out;
}

Image difference(const Image& made, const Image& real, double white) {
    Image out(real.width, real.height, 3, kMasked);
    for (std::size_t t = 0; t < real.pixels.size(); t += 3) {
        const double off = luminance(made.pixels.data() + t) - luminance(real.pixels.data() + t);
        if (!std::isfinite(off)) continue;
        const plot::Rgb c =
            plot::diverging_color(std::clamp(off / (white * kFullDifference), -1.0, 1.0));
        out.pixels[t] = static_cast<float>(c.r);
        out.pixels[t + 1] = static_cast<float>(c.g);
        out.pixels[t + 2] = static_cast<float>(c.b);
    }
    return at_viewing_size(out);
}

// PSNR of luminance, relative to the brightest sample of this picture. Relative to the brightest of
// all pictures, the error of a dim picture would look too small.
double psnr_of(const Image& made, const Image& real) {
    SquaredError error;
    double peak = 0.0;
    for (std::size_t t = 0; t < real.pixels.size(); t += 3) {
        const double truth = luminance(real.pixels.data() + t);
        const double off = luminance(made.pixels.data() + t) - truth;
        if (!std::isfinite(off)) continue;
        error.add(off);
        peak = std::max(peak, truth);
    }
    return psnr(error.rmse(), peak);
}

void add_shot(const Image& made, const Image& real, const char* title, const std::string& name,
              LightEntry& entry, Pictures& pictures) {
    const std::string file = fmt::format("light_{}_{}", entry.rank, name);
    Shot shot{title, file + ".png", file + "_off.png", psnr_of(made, real)};
    pictures.push_back({shot.picture, displayed(made, real, entry.white)});
    pictures.push_back({shot.difference, difference(made, real, entry.white)});
    entry.shots.push_back(shot);
}

void add_models(const std::vector<ParametricMaps>& models, Page& page) {
    std::string missing;
    for (const std::string_view name : parametric_model_names())
        if (std::none_of(models.begin(), models.end(),
                         [&](const ParametricMaps& maps) { return maps.name == name; }))
            missing += (missing.empty() ? "" : ", ") + std::string(name);
    if (!missing.empty())
        page.notes.push_back(fmt::format(
            "The material has no maps of {} (capture fit --no-models?): left out of the "
            "comparison.",
            missing));
}

}  // namespace

void add_comparison(const ImageStack& stack, const Rig& rig, const TabulatedMaterial& m,
                    const std::vector<std::uint8_t>& keep, Page& page, Pictures& pictures,
                    const Progress& progress) {
    std::vector<std::size_t> lights;
    for (std::size_t k = 0; k < keep.size(); ++k)
        if (!keep[k]) lights.push_back(k);
    page.errors = held_out_errors(stack, rig, m, keep, progress);
    const Levels levels = levels_of(stack, m, lights, progress);
    page.peak = levels.peak;
    for (auto& [light, rank] : chosen(rig, lights, levels)) {
        LightEntry entry;
        entry.light = light;
        entry.rank = rank;
        entry.source = rig.lights[light].images.front().image.filename().string();
        const Vec3d to = arrival(rig.lights[light], {0.0, 0.0, 0.0}).to_light;
        entry.elevation = std::atan2(to[2], std::hypot(to[0], to[1])) / kDegree;
        entry.azimuth = std::atan2(to[1], to[0]) / kDegree;
        page.compared.push_back(entry);
    }
    const std::vector<ParametricMaps> models = parametric_maps(m);
    add_models(models, page);
    const Relighter relighter(m);
    const std::vector<Image> real = real_pictures(stack, m, page.compared, progress);
    // The same columns as B12's page: measured data, the method, anisotropic and isotropic Ward.
    constexpr std::pair<ParametricModel, const char*> kShown[] = {
        {ParametricModel::ward, "Ward, anisotropic"},
        {ParametricModel::ward_isotropic, "Ward, isotropic"}};
    for (std::size_t k = 0; k < real.size(); ++k) {
        progress.step("compare", static_cast<double>(k) / static_cast<double>(real.size()));
        LightEntry& entry = page.compared[k];
        entry.white = white_of(real[k]);
        entry.shots.push_back({"real", fmt::format("light_{}_real.png", entry.rank), "", 0.0});
        pictures.push_back({entry.shots.back().picture, displayed(real[k], real[k], entry.white)});
        add_shot(relighter.picture(rig, entry.light), real[k], "synthesised", "tabulated", entry,
                 pictures);
        for (const auto& [model, title] : kShown)
            for (const ParametricMaps& maps : models)
                if (maps.model == model)
                    add_shot(parametric_picture(m, maps, rig, entry.light), real[k], title,
                             maps.name, entry, pictures);
    }
}

}  // namespace burnish::report
