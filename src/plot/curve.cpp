#include "plot/curve.hpp"

#include <algorithm>
#include <cmath>

namespace burnish::plot {
namespace {

constexpr int kEven = 240;
constexpr int kMostHalvings = 10;
constexpr std::size_t kMostPoints = 20000;

std::vector<double> first_places(double low, double high, std::span<const double> hints) {
    std::vector<double> places;
    for (int i = 0; i <= kEven; ++i) places.push_back(low + (high - low) * i / kEven);
    const auto add = [&](double x) {
        if (x > low && x < high) places.push_back(x);
    };
    for (const double hint : hints) {
        add(hint);
        for (double step = 1e-7; step < 1; step *= 1.6) {
            add(hint - step * (high - low));
            add(hint + step * (high - low));
        }
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

}  // namespace

std::vector<Point> sampled_curve(const std::function<double(double)>& f, double low, double high,
                                 std::span<const double> hints) {
    std::vector<Point> points;
    double most = 0;
    for (const double x : first_places(low, high, hints)) {
        points.push_back({x, f(x)});
        most = std::max(most, std::abs(points.back().y));
    }
    for (int halving = 0; halving < kMostHalvings && points.size() < kMostPoints; ++halving) {
        std::vector<Point> finer{points.front()};
        for (std::size_t i = 1; i < points.size(); ++i) {
            const Point a = points[i - 1], b = points[i];
            const Point middle{0.5 * (a.x + b.x), f(0.5 * (a.x + b.x))};
            const double off = std::abs(middle.y - 0.5 * (a.y + b.y));
            // 1e-6: a logarithmic plot ends five decades below its top.
            const bool bends =
                off > 2e-3 * most || (off > 0.03 * middle.y && middle.y > 1e-6 * most);
            const bool wide = b.x - a.x > 1e-8 * (high - low);
            if (bends && wide) finer.push_back(middle);
            finer.push_back(b);
        }
        if (finer.size() == points.size()) break;
        points = std::move(finer);
    }
    return points;
}

}  // namespace burnish::plot
