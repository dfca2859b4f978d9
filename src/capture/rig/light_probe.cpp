#include "capture/rig/light_probe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "burnish/error.hpp"
#include "burnish/f64.hpp"

namespace burnish {

namespace {

double luminance(const Image& image, int x, int y) {
    const float* p = image.at(x, y);
    if (image.channels < 3) return static_cast<double>(p[0]);
    return f64::luminance({double{p[0]}, double{p[1]}, double{p[2]}});
}

// The part of the picture where the ball reflects directions with z > 0; -1 elsewhere in the
// rectangle.
struct View {
    int left = 0, top = 0, width = 0, height = 0;
    std::vector<double> values;
    double middle = 0.0, most = 0.0;  // median, maximum

    double& at(int x, int y) {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

View cut_out(const Image& image, const ProbeCircle& circle, const std::string& name) {
    // At n.z = 1/sqrt(2) the reflected direction has z = 0: lights farther out are behind the ball.
    const double radius = circle.radius * std::numbers::sqrt2 / 2.0;
    const auto clamped = [](double value, int size) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(size)));
    };
    View view;
    view.left = clamped(std::floor(circle.x - radius), image.width);
    view.top = clamped(std::floor(circle.y - radius), image.height);
    view.width = clamped(std::ceil(circle.x + radius), image.width) - view.left;
    view.height = clamped(std::ceil(circle.y + radius), image.height) - view.top;
    std::vector<double> seen;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const double away =
                std::hypot(view.left + x + 0.5 - circle.x, view.top + y + 0.5 - circle.y);
            const double value =
                away < radius ? luminance(image, view.left + x, view.top + y) : -1.0;
            view.values.push_back(value);
            if (away < radius) seen.push_back(value);
        }
    if (seen.empty())
        throw Error(name, "circle", "a circle inside the picture",
                    fmt::format("({:g}, {:g}) of radius {:g} in {} x {} pixels", circle.x, circle.y,
                                circle.radius, image.width, image.height));
    view.most = *std::max_element(seen.begin(), seen.end());
    const auto middle = seen.begin() + static_cast<std::ptrdiff_t>(seen.size() / 2);
    std::nth_element(seen.begin(), middle, seen.end());
    view.middle = *middle;
    return view;
}

struct Pixel {
    int x, y;
    double weight;
};

// Connected pixels above `threshold`; they are removed from the view.
std::vector<Pixel> take_spot(View& view, int x, int y, double threshold) {
    std::vector<Pixel> spot;
    const auto take = [&](int px, int py) {
        if (px < 0 || py < 0 || px >= view.width || py >= view.height) return;
        double& value = view.at(px, py);
        if (!(value > threshold)) return;
        spot.push_back({px, py, value - view.middle});
        value = -1.0;
    };
    take(x, y);
    for (std::size_t next = 0; next < spot.size(); ++next) {
        const Pixel from = spot[next];
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) take(from.x + dx, from.y + dy);
    }
    return spot;
}

double weight_of(const std::vector<Pixel>& spot) {
    double weight = 0.0;
    for (const Pixel& pixel : spot) weight += pixel.weight;
    return weight;
}

// Adds the pixels that the lamp covers partly; their values weight their directions.
void add_rim(std::vector<Pixel>& spot, View& view) {
    for (std::size_t k = 0, inside = spot.size(); k < inside; ++k) {
        const Pixel from = spot[k];
        for (int y = std::max(from.y - 1, 0); y <= std::min(from.y + 1, view.height - 1); ++y)
            for (int x = std::max(from.x - 1, 0); x <= std::min(from.x + 1, view.width - 1); ++x) {
                double& value = view.at(x, y);
                if (value > view.middle) spot.push_back({x, y, value - view.middle});
                value = -1.0;
            }
    }
}

// Averages the directions of a spot's pixels. A mirror ball seen from far away maps solid angle to
// area evenly (d omega = 4 dA / R^2), so that the mean over the pixels is the mean over the lamp.
// The lens draws streaks from a lamp that exceeds the picture's range, mostly to one side. They are
// excluded: pixels count within a circle about the mean direction of 1.5 times the solid angle of
// the spot's core, and the mean and the circle are updated alternately. With 1.5 a round lamp keeps
// its rim, which pixels resolve as a staircase.
void average(const std::vector<Pixel>& spot, std::size_t core, const View& view,
             const ProbeCircle& circle, ProbeLight& light) {
    constexpr int kRounds = 20;
    const double solid_angle = 4.0 * static_cast<double>(core) / (circle.radius * circle.radius);
    const double least_cosine = 1.0 - 1.5 * solid_angle / (2.0 * std::numbers::pi);
    std::vector<Vec3d> directions;
    directions.reserve(spot.size());
    for (const Pixel& pixel : spot)
        directions.push_back(
            probe_reflection(circle, view.left + pixel.x + 0.5, view.top + pixel.y + 0.5));
    for (int round = 0; round < kRounds; ++round) {
        double all = 0.0, square = 0.0, x = 0.0, y = 0.0;
        Vec3d sum{};
        for (std::size_t k = 0; k < spot.size(); ++k) {
            const Vec3d& d = directions[k];
            const double cosine =
                d[0] * light.direction[0] + d[1] * light.direction[1] + d[2] * light.direction[2];
            if (round > 0 && cosine < least_cosine) continue;
            all += spot[k].weight;
            for (std::size_t i = 0; i < 3; ++i) sum[i] += spot[k].weight * d[i];
            square += spot[k].weight * 2.0 * (1.0 - cosine);
            x += spot[k].weight * (view.left + spot[k].x + 0.5);
            y += spot[k].weight * (view.top + spot[k].y + 0.5);
        }
        if (all == 0.0) return;  // the spot is a ring around its mean: the mean of all pixels stays
        const double size = std::hypot(sum[0], sum[1], sum[2]);
        light.direction = {sum[0] / size, sum[1] / size, sum[2] / size};
        light.x = x / all;
        light.y = y / all;
        light.spread_deg = std::sqrt(square / all) * 180.0 / std::numbers::pi;
    }
}

}  // namespace

Vec3d probe_reflection(const ProbeCircle& circle, double x, double y) {
    const double nx = (x - circle.x) / circle.radius, ny = (circle.y - y) / circle.radius;
    const double nz = std::sqrt(std::max(1.0 - nx * nx - ny * ny, 0.0));
    return {2.0 * nz * nx, 2.0 * nz * ny, 2.0 * nz * nz - 1.0};  // 2 (n.v) n - v, v = (0, 0, 1)
}

Vec3d from_picture(const Vec3d& direction, const Vec3d& camera) {
    // right = y x camera, up = camera x right; z > 0 keeps the camera off the y axis.
    const double size = std::hypot(camera[0], camera[2]);
    const Vec3d right{camera[2] / size, 0.0, -camera[0] / size};
    const Vec3d up{camera[1] * right[2], camera[2] * right[0] - camera[0] * right[2],
                   -camera[1] * right[0]};
    Vec3d out{};
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = direction[0] * right[i] + direction[1] * up[i] + direction[2] * camera[i];
    return out;
}

ProbeLight light_from_probe(const Image& image, const ProbeCircle& circle,
                            const std::string& name) {
    if (!(circle.radius >= 4.0 && std::isfinite(circle.radius) && std::isfinite(circle.x) &&
          std::isfinite(circle.y)))
        throw Error(name, "circle", "a circle of at least 4 pixels",
                    fmt::format("radius {:g}", circle.radius));
    View view = cut_out(image, circle, name);
    // A highlight is a lamp if it is more than twice the median of the ball; else it is part of the
    // room.
    if (!(view.most > 0.0 && view.most > 2.0 * view.middle))
        throw Error(
            name, "", "a highlight on the ball",
            fmt::format("{:.3g} at most where the median is {:.3g}", view.most, view.middle));
    const double threshold = 0.5 * (view.middle + view.most);
    std::vector<Pixel> best;
    double first = 0.0, second = 0.0;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            if (!(view.at(x, y) > threshold)) continue;
            std::vector<Pixel> spot = take_spot(view, x, y, threshold);
            const double weight = weight_of(spot);
            second = std::max(second, std::min(weight, first));
            if (weight <= first) continue;
            first = weight;
            best = std::move(spot);
        }
    const std::size_t core = best.size();
    add_rim(best, view);
    ProbeLight light;
    average(best, core, view, circle, light);
    light.second = second / first;
    return light;
}

}  // namespace burnish
