#include "burnish/plot/scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace burnish::plot {
namespace {

constexpr std::array<std::string_view, 3> kNames = {"linear", "gamma", "log"};

std::string with_minus(std::string text) {
    if (!text.empty() && text.front() == '-') text.replace(0, 1, "\u2212");
    return text;
}

// 1, 2, 2.5 or 5 times a power of ten, at least `least`.
double round_step(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double step : {1.0, 2.0, 2.5, 5.0})
        if (step * power >= least * (1 - 1e-9)) return step * power;
    return 10 * power;
}

std::string step_text(double value, double step) {
    // 1e-9: the rounding error of a sum of steps that should be zero.
    if (std::abs(value) < 1e-9 * step) return "0";
    if (std::abs(value) >= 1e5 || step < 1e-4) return number_text(value);
    int decimals = 0;
    for (double s = step; decimals < 6 && std::abs(s - std::round(s)) > 1e-6 * s; s *= 10)
        ++decimals;
    return with_minus(fmt::format("{:.{}f}", value, decimals));
}

std::vector<Tick> linear_ticks(const Scale& scale, int count) {
    std::vector<Tick> ticks;
    const double step = round_step((scale.high - scale.low) / std::max(count, 1));
    const double first = std::ceil(scale.low / step - 1e-9);
    for (int i = 0; i < 64; ++i) {
        const double value = (first + i) * step;
        if (value > scale.high + 1e-9 * step) break;
        ticks.push_back({scale.position(value), step_text(value, step)});
    }
    return ticks;
}

// The ticks of a linear scale, thinned where they crowd near the top, and round numbers below them.
std::vector<Tick> gamma_ticks(const Scale& scale, int count) {
    const double apart = 0.6 / std::max(count, 1);
    std::vector<double> taken;
    std::vector<Tick> ticks;
    const auto place = [&](double value) {
        const double at = scale.position(value);
        for (const double other : taken)
            if (std::abs(other - at) < apart) return;
        taken.push_back(at);
        ticks.push_back({at, number_text(value)});
    };
    place(scale.low);
    for (double top = std::pow(10.0, std::floor(std::log10(scale.high))); taken.size() < 24;
         top /= 10) {
        const std::size_t before = taken.size();
        for (const double factor : {5.0, 2.0, 1.0})
            if (factor * top <= scale.high && factor * top > scale.low) place(factor * top);
        if (taken.size() == before && scale.position(top) < apart) break;
    }
    return ticks;
}

std::vector<Tick> log_ticks(const Scale& scale, int count) {
    std::vector<Tick> ticks;
    const double low = std::log10(scale.low), high = std::log10(scale.high);
    const int every = std::max(1, static_cast<int>(std::ceil((high - low) / (1.6 * count))));
    for (int power = static_cast<int>(std::floor(low)); power <= high + 1e-9; ++power) {
        const double decade = std::pow(10.0, power);
        const bool fine = every == 1 && high - low < 6;
        for (int factor = 1; factor <= (fine ? 9 : 1); ++factor) {
            const double at = scale.position(factor * decade);
            if (at < -1e-9 || at > 1 + 1e-9) continue;
            const bool sparse = high - low < 2 && (factor == 2 || factor == 5);
            std::string label;
            if (factor == 1 && power % every == 0)
                label = std::abs(power) <= 2 ? number_text(decade)
                                             : with_minus(fmt::format("10^{{{}}}", power));
            else if (sparse)
                label = number_text(factor * decade);
            if (!label.empty() || fine) ticks.push_back({at, label});
        }
    }
    return ticks;
}

}  // namespace

std::span<const std::string_view> scale_names() {
    return kNames;
}

double Scale::position(double v) const {
    switch (kind) {
        case ScaleKind::linear:
            return (v - low) / (high - low);
        case ScaleKind::gamma:
            return v <= low ? (v - low) / (high - low)
                            : std::pow((v - low) / (high - low), 1 / kPlotGamma);
        case ScaleKind::log:
            return (std::log(v > 0 || std::isnan(v) ? v : 0.0) - std::log(low)) /
                   (std::log(high) - std::log(low));
    }
    return 0;
}

double Scale::value(double at) const {
    switch (kind) {
        case ScaleKind::linear:
            return low + at * (high - low);
        case ScaleKind::gamma:
            return low + (at > 0 ? std::pow(at, kPlotGamma) : at) * (high - low);
        case ScaleKind::log:
            return low * std::pow(high / low, at);
    }
    return 0;
}

std::vector<Tick> Scale::ticks(int count) const {
    switch (kind) {
        case ScaleKind::linear:
            return linear_ticks(*this, count);
        case ScaleKind::gamma:
            return gamma_ticks(*this, count);
        case ScaleKind::log:
            return log_ticks(*this, count);
    }
    return {};
}

Scale scale_to(ScaleKind kind, double high, double decades) {
    if (!(high > 0) || !std::isfinite(high)) high = 1;
    return {kind, kind == ScaleKind::log ? high * std::pow(10.0, -decades) : 0.0, high};
}

std::string number_text(double value, int digits) {
    if (std::isnan(value)) return "not a number";
    if (std::isinf(value)) return value > 0 ? "\u221e" : "\u2212\u221e";
    const double size = std::abs(value);
    if (size == 0 || (size >= 1e-3 && size < 99999.5))
        return with_minus(size >= 1000 ? fmt::format("{:.0f}", value)
                                       : fmt::format("{:.{}g}", value, digits));
    const std::string text = fmt::format("{:.{}e}", value, std::max(digits - 2, 0));
    const std::size_t e = text.find('e');
    const int power = std::stoi(text.substr(e + 1));
    const std::string ten = with_minus(fmt::format("{}", power));
    const std::string mantissa = text.substr(0, e);
    const bool one = std::stod(mantissa) == 1;
    return (one ? "" : with_minus(mantissa) + "\u2009\u00d7\u2009") + "10^{" + ten + "}";
}

}  // namespace burnish::plot
