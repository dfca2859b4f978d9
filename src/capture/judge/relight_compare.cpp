#include "capture/judge/relight_compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "burnish/error.hpp"
#include "capture/stack/image_stack.hpp"
#include "core/statistics.hpp"
#include "image/image_io.hpp"

namespace burnish {

namespace {

double psnr_of(double rmse, double peak) {
    return rmse > 0.0 ? 20.0 * std::log10(peak / rmse) : std::numeric_limits<double>::infinity();
}

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
            sums.at_top = 0;
            sums.squares_at_top = 0.0;
        } else if (value < sums.top) {
            sums.next = std::max(sums.next, value);
        }
        ++sums.samples;
        sums.squares += difference * difference;
        if (value < sums.top) continue;
        ++sums.at_top;
        sums.squares_at_top += difference * difference;
    }
}

StackError StackComparison::result() const {
    double brightest = 0.0;
    for (const Sums& sums : sums_) brightest = std::max(brightest, sums.top);
    StackError out;
    double squares = 0.0;
    for (const Sums& sums : sums_) {
        const bool clips =
            sums.top > 0.0 && sums.top == brightest && sums.at_top >= kRepeatsOfClipping;
        out.peak = std::max(out.peak, clips ? sums.next : sums.top);
        LightError light;
        light.samples = sums.samples - (clips ? sums.at_top : 0);
        const double kept = std::max(sums.squares - (clips ? sums.squares_at_top : 0.0), 0.0);
        if (light.samples > 0) light.rmse = std::sqrt(kept / static_cast<double>(light.samples));
        squares += kept;
        out.samples += light.samples;
        out.lights.push_back(light);
    }
    if (out.samples == 0 || !(out.peak > 0.0))
        throw Error(stack_.file.string(), "lights", "pictures that show something within the mask",
                    out.samples == 0 ? "clipped samples only" : "black only");
    out.rmse = std::sqrt(squares / static_cast<double>(out.samples));
    std::vector<double> psnr;
    double sum = 0.0;
    for (std::size_t k = 0; k < out.lights.size(); ++k) {
        LightError& light = out.lights[k];
        light.psnr = light.samples > 0 ? psnr_of(light.rmse, out.peak)
                                       : std::numeric_limits<double>::quiet_NaN();
        if (light.samples == 0) continue;
        if (psnr.empty() || light.psnr < out.psnr_worst) {
            out.psnr_worst = light.psnr;
            out.worst = k;
        }
        psnr.push_back(light.psnr);
        sum += light.psnr;
    }
    out.psnr_mean = sum / static_cast<double>(psnr.size());
    out.psnr_median = median(psnr);
    return out;
}

}  // namespace burnish
