#include "plot/depth_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "burnish/image_io.hpp"

namespace burnish::plot {
namespace {

std::array<float, 3> linear_of(const Rgb& color) {
    return {linear_from_srgb(static_cast<float>(color.r)),
            linear_from_srgb(static_cast<float>(color.g)),
            linear_from_srgb(static_cast<float>(color.b))};
}

double edge(const DepthPoint& a, const DepthPoint& b, double x, double y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

}  // namespace

DepthPicture::DepthPicture(int width, int height, const Rgb& background)
    : width_(width),
      height_(height),
      linear_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3),
      depth_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
             -std::numeric_limits<double>::infinity()) {
    const std::array<float, 3> color = linear_of(background);
    for (std::size_t i = 0; i < linear_.size(); ++i) linear_[i] = color[i % 3];
}

void DepthPicture::triangle(const Corner& a, const Corner& b, const Corner& c, const Rgb& color) {
    const double area = edge(a.at, b.at, c.at.x, c.at.y);
    if (!(std::abs(area) > 1e-9)) return;  // the triangle is seen edge-on and covers no pixel
    const std::array<float, 3> linear = linear_of(color);
    const auto first = [](double v) { return static_cast<int>(std::ceil(std::max(v, 0.0) - 0.5)); };
    const auto last = [](double v, int size) {
        return static_cast<int>(std::floor(std::min(v, static_cast<double>(size)) - 0.5));
    };
    const int x0 = first(std::min({a.at.x, b.at.x, c.at.x}));
    const int x1 = std::min(last(std::max({a.at.x, b.at.x, c.at.x}), width_), width_ - 1);
    const int y0 = first(std::min({a.at.y, b.at.y, c.at.y}));
    const int y1 = std::min(last(std::max({a.at.y, b.at.y, c.at.y}), height_), height_ - 1);
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const double px = x + 0.5, py = y + 0.5;
            const double u = edge(b.at, c.at, px, py) / area, v = edge(c.at, a.at, px, py) / area;
            const double w = 1 - u - v;
            // 1e-9: neighboring triangles leave no gap along their common edge.
            if (u < -1e-9 || v < -1e-9 || w < -1e-9) continue;
            const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                   static_cast<std::size_t>(x);
            const double depth = u * a.at.depth + v * b.at.depth + w * c.at.depth;
            if (depth <= depth_[at]) continue;
            depth_[at] = depth;
            const auto light = static_cast<float>(u * a.light + v * b.light + w * c.light);
            for (std::size_t i = 0; i < 3; ++i) linear_[3 * at + i] = linear[i] * light;
        }
    }
}

void DepthPicture::line(const DepthPoint& from, const DepthPoint& to, const Line& style) {
    const double dx = to.x - from.x, dy = to.y - from.y;
    const double length = std::hypot(dx, dy);
    if (!(length > 1e-9)) return;
    const double half = style.thickness / 2;
    const std::array<float, 3> linear = linear_of(style.color);
    const auto opacity = static_cast<float>(style.opacity);
    const int x0 = std::max(0, static_cast<int>(std::min(from.x, to.x) - half));
    const int x1 = std::min(width_ - 1, static_cast<int>(std::max(from.x, to.x) + half));
    const int y0 = std::max(0, static_cast<int>(std::min(from.y, to.y) - half));
    const int y1 = std::min(height_ - 1, static_cast<int>(std::max(from.y, to.y) + half));
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const double px = x + 0.5 - from.x, py = y + 0.5 - from.y;
            const double along = std::clamp((px * dx + py * dy) / (length * length), 0.0, 1.0);
            if (std::hypot(px - along * dx, py - along * dy) > half) continue;
            if (style.off > 0 && std::fmod(along * length, style.on + style.off) > style.on)
                continue;
            const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                   static_cast<std::size_t>(x);
            const double depth = from.depth + along * (to.depth - from.depth);
            if (depth + style.bias < depth_[at]) continue;
            if (style.opacity >= 1) depth_[at] = std::max(depth_[at], depth);
            for (std::size_t i = 0; i < 3; ++i) {
                float& value = linear_[3 * at + i];
                value += opacity * (linear[i] - value);
            }
        }
    }
}

Image DepthPicture::reduced(int factor) const {
    Image image(width_ / factor, height_ / factor, 3);
    const auto share = 1.0f / static_cast<float>(factor * factor);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                float sum = 0;
                for (int j = 0; j < factor; ++j)
                    for (int i = 0; i < factor; ++i)
                        sum += linear_[3 * static_cast<std::size_t>((y * factor + j) * width_ +
                                                                    x * factor + i) +
                                       static_cast<std::size_t>(c)];
                image.at(x, y)[c] = srgb_from_linear(sum * share);
            }
        }
    }
    return image;
}

}  // namespace burnish::plot
