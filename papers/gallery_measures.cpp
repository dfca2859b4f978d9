#include "papers/gallery_measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "burnish/f32.hpp"

namespace burnish {
namespace {

using plot::MdfSubject;

// Standard deviations along the principal axes of a mass distribution with these moments.
std::array<double, 2> principal_axes(double mass, double sx, double sy, double sxx, double sxy,
                                     double syy) {
    const double mx = sx / mass, my = sy / mass;
    const double xx = sxx / mass - mx * mx, yy = syy / mass - my * my, xy = sxy / mass - mx * my;
    const double middle = (xx + yy) / 2;
    const double reach = std::hypot((xx - yy) / 2, xy);
    return {std::sqrt(middle + reach), std::sqrt(std::max(middle - reach, 0.0))};
}

double angle_between_deg(Direction<double> a, Direction<double> b) {
    return kDegreesPerRadian * std::atan2(length(cross(a, b)), dot(a, b));
}

bool counts(const Image& mask, std::size_t pixel) {
    return mask.pixels[pixel] > 0.5f;
}

std::size_t pixels_of(const Image& image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

// The luminance that is exceeded by `share` of the pixels of the mask.
double bright_level(const Image& linear, const Image& mask, double share) {
    std::vector<float> values;
    for (std::size_t i = 0; i < pixels_of(linear); ++i)
        if (counts(mask, i)) values.push_back(luminance(linear, i));
    if (values.empty()) return 0;
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::nth_element(values.begin(), values.begin() + place, values.end(), std::greater<>());
    return double{values[static_cast<std::size_t>(place)]};
}

template <typename Where>
double difference_where(const Image& a, const Image& reference, const Where& where) {
    double difference = 0, sum = 0;
    for (std::size_t i = 0; i < pixels_of(a); ++i) {
        if (!where(i)) continue;
        const double r = double{luminance(reference, i)};
        const double d = double{luminance(a, i)} - r;
        difference += d * d;
        sum += r * r;
    }
    return sum > 0 ? std::sqrt(difference / sum) : 0;
}

}  // namespace

LobeMoments lobe_moments(const MdfSubject& subject) {
    constexpr int kSide = 1001;
    constexpr double kStep = 2.0 / kSide;
    MdfSubject projected = subject;
    projected.normalization = plot::Normalization::projected;
    double mass = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
    for (int j = 0; j < kSide; ++j) {
        const double y = -1 + (j + 0.5) * kStep;
        for (int i = 0; i < kSide; ++i) {
            const double x = -1 + (i + 0.5) * kStep;
            const double z2 = 1 - x * x - y * y;
            if (z2 <= 0) continue;
            const double D = projected.D({x, y, std::sqrt(z2)});
            mass += D;
            sx += D * x;
            sy += D * y;
            sxx += D * x * x;
            sxy += D * x * y;
            syy += D * y * y;
        }
    }
    LobeMoments moments;
    moments.energy = mass * kStep * kStep;
    const auto axes = principal_axes(mass, sx, sy, sxx, sxy, syy);
    moments.long_axis = axes[0];
    moments.short_axis = axes[1];
    return moments;
}

double peak_offset_deg(const MdfSubject& subject) {
    return angle_between_deg(plot::peak_of(subject).h, subject.n);
}

double half_width_deg(const MdfSubject& subject, plot::ProfileLine line) {
    const bool along_x = line == plot::ProfileLine::along_x;
    const double half = subject.D({0, 0, 1}) / 2;
    double inside = 0, outside = std::numbers::pi / 2;
    for (int step = 0; step < 50; ++step) {
        const double angle = (inside + outside) / 2;
        const double s = std::sin(angle);
        const bool above =
            subject.D({along_x ? s : 0.0, along_x ? 0.0 : s, std::cos(angle)}) > half;
        (above ? inside : outside) = angle;
    }
    return kDegreesPerRadian * inside;
}

double bend_at_center_deg(const MdfSubject& subject) {
    constexpr double kNear = 1e-4;  // small beside the radius of 1, above rounding
    constexpr int kDirections = 90;
    const Direction<double> center = plot::forward(subject, {0, 0, 1});
    double most = 0;
    for (int i = 0; i < kDirections; ++i) {
        const double angle = std::numbers::pi * i / kDirections;
        const double x = kNear * std::cos(angle), y = kNear * std::sin(angle);
        const double z = std::sqrt(1 - kNear * kNear);
        const Direction<double> a = plot::forward(subject, {x, y, z});
        const Direction<double> b = plot::forward(subject, {-x, -y, z});
        const Direction<double> to{a.x - center.x, a.y - center.y, 0};
        const Direction<double> from{center.x - b.x, center.y - b.y, 0};
        most = std::max(most, angle_between_deg(to, from));
    }
    return most;
}

float luminance(const Image& linear, std::size_t pixel) {
    const float* p = linear.pixels.data() + pixel * static_cast<std::size_t>(linear.channels);
    return f32::luminance({p[0], p[1], p[2]});
}

double relative_difference(const Image& a, const Image& reference, const Image& mask) {
    return difference_where(a, reference, [&](std::size_t i) { return counts(mask, i); });
}

double skirt_difference(const Image& a, const Image& reference, const Image& mask) {
    const double top = bright_level(reference, mask, 0.01);
    return difference_where(a, reference, [&](std::size_t i) {
        const double r = double{luminance(reference, i)};
        return counts(mask, i) && r > 0.02 * top && r < 0.5 * top;
    });
}

double flat_share(const Image& linear, const Image& mask, int side) {
    constexpr double kSeen = 0.25;
    int flat = 0, all = 0;
    for (int top = 0; top + side <= linear.height; top += side) {
        for (int left = 0; left + side <= linear.width; left += side) {
            double n = 0, s = 0, ss = 0;
            for (int y = top; y < top + side; ++y)
                for (int x = left; x < left + side; ++x) {
                    const std::size_t i =
                        static_cast<std::size_t>(y) * static_cast<std::size_t>(linear.width) +
                        static_cast<std::size_t>(x);
                    if (!counts(mask, i)) continue;
                    const double value = double{luminance(linear, i)};
                    n += 1;
                    s += value;
                    ss += value * value;
                }
            if (n < side * side) continue;
            ++all;
            if (std::sqrt(std::max(ss / n - s / n * (s / n), 0.0)) < kSeen * s / n) ++flat;
        }
    }
    return all > 0 ? static_cast<double>(flat) / all : 0;
}

double concentration(const Image& linear, const Image& mask) {
    double sum = 0, n = 0;
    for (std::size_t i = 0; i < pixels_of(linear); ++i) {
        if (!counts(mask, i)) continue;
        sum += double{luminance(linear, i)};
        n += 1;
    }
    return sum > 0 ? bright_level(linear, mask, 0.01) * n / sum : 0;
}

double correlation(const Image& a, const Image& b, const Image& mask) {
    double n = 0, sa = 0, sb = 0, saa = 0, sab = 0, sbb = 0;
    for (std::size_t i = 0; i < pixels_of(a); ++i) {
        if (!counts(mask, i)) continue;
        const double x = double{luminance(a, i)}, y = double{luminance(b, i)};
        n += 1;
        sa += x;
        sb += y;
        saa += x * x;
        sab += x * y;
        sbb += y * y;
    }
    const double va = saa - sa * sa / n, vb = sbb - sb * sb / n;
    return va > 0 && vb > 0 ? (sab - sa * sb / n) / std::sqrt(va * vb) : 0;
}

double highlight_elongation(const Image& linear, const Image& mask) {
    const double level = bright_level(linear, mask, 0.01) / 2;
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
    for (std::size_t i = 0; i < pixels_of(linear); ++i) {
        if (!counts(mask, i) || double{luminance(linear, i)} < level) continue;
        const double x = static_cast<double>(i % static_cast<std::size_t>(linear.width));
        const double y = static_cast<double>(i / static_cast<std::size_t>(linear.width));
        n += 1;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
        syy += y * y;
    }
    const auto axes = principal_axes(n, sx, sy, sxx, sxy, syy);
    return axes[1] > 0 ? axes[0] / axes[1] : 0;
}

}  // namespace burnish
