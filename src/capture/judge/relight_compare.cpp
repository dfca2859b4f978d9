#include "capture/judge/relight_compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "burnish/compare.hpp"
#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "capture/stack/image_stack.hpp"
#include "core/statistics.hpp"

namespace burnish {

namespace {

void require_sizes(const Rig& stack, const TabulatedMaterial& m) {
    for (const RigLight& light : stack.lights)
        for (const RigExposure& exposure : light.images) {
            const ImageInfo info = read_image_info(exposure.image);
            if (info.width == m.width && info.height == m.height) continue;
            throw Error(exposure.image.string(), "",
                        fmt::format("{} x {} pixels, as the material has", m.width, m.height),
                        fmt::format("{} x {}", info.width, info.height));
        }
}

}  // namespace

StackComparison::StackComparison(const Rig& stack, const TabulatedMaterial& material)
    : stack_(stack), sums_(stack.lights.size()), width_(material.width), height_(material.height) {
    require_sizes(stack, material);
    white_ = read_flat_field(stack);
    counts_ = read_mask(stack, width_, height_);
    for (std::size_t i = 0; i < counts_.size(); ++i)
        if (material.exemplar[i] == TabulatedMaterial::kNoExemplar) counts_[i] = 0;
}

void StackComparison::add(std::size_t light, const Image& rendered) {
    const LightImage real = read_light_image(stack_, stack_.lights[light], white_, width_, height_);
    Sums& sums = sums_[light];
    sums = {};
    for (std::size_t k = 0; k < real.rgb.pixels.size(); ++k) {
        if (!counts_[k / 3] || (!real.clipped.empty() && real.clipped[k])) continue;
        const auto value = static_cast<double>(real.rgb.pixels[k]);
        const double difference = static_cast<double>(rendered.pixels[k]) - value;
        if (value > sums.top) {
            sums.next = sums.top;
            sums.top = value;
            sums.at_top = {};
        } else if (value < sums.top) {
            sums.next = std::max(sums.next, value);
        }
        sums.all.add(difference);
        if (value == sums.top) sums.at_top.add(difference);
    }
}

StackError StackComparison::result() const {
    double brightest = 0.0;
    for (const Sums& sums : sums_) brightest = std::max(brightest, sums.top);
    StackError out;
    SquaredError total;
    for (const Sums& sums : sums_) {
        // As a stack is read: more samples at the top show an even card (image_stack.hpp).
        const bool clips = sums.top > 0.0 && sums.top == brightest &&
                           sums.at_top.count >= kRepeatsOfClipping &&
                           static_cast<double>(sums.at_top.count) <=
                               kMostOfClipping * static_cast<double>(sums.all.count);
        out.peak = std::max(out.peak, clips ? sums.next : sums.top);
        SquaredError kept = sums.all;
        if (clips)
            kept = {std::max(kept.squares - sums.at_top.squares, 0.0),
                    kept.count - sums.at_top.count};
        out.lights.push_back({kept.count, kept.rmse(), 0.0});
        total.merge(kept);
    }
    out.samples = total.count;
    if (out.samples == 0 || !(out.peak > 0.0))
        throw Error(stack_.file.string(), "lights", "pictures that show something within the mask",
                    out.samples == 0 ? "clipped samples only" : "black only");
    out.rmse = total.rmse();
    std::vector<double> decibels;
    double sum = 0.0;
    for (std::size_t k = 0; k < out.lights.size(); ++k) {
        LightError& light = out.lights[k];
        light.psnr = light.samples > 0 ? psnr(light.rmse, out.peak)
                                       : std::numeric_limits<double>::quiet_NaN();
        if (light.samples == 0) continue;
        if (decibels.empty() || light.psnr < out.psnr_worst) {
            out.psnr_worst = light.psnr;
            out.worst = k;
        }
        decibels.push_back(light.psnr);
        sum += light.psnr;
    }
    out.psnr_mean = sum / static_cast<double>(decibels.size());
    out.psnr_median = median(decibels);
    return out;
}

}  // namespace burnish
