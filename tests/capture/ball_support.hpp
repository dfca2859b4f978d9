// Renders pictures of mirror balls ray by ray.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "burnish/image.hpp"
#include "capture/rig/light_probe.hpp"

namespace burnish::test {

inline constexpr double kDegree = std::numbers::pi / 180;

inline Vec3d direction(double theta_deg, double phi_deg) {
    const double t = theta_deg * kDegree, p = phi_deg * kDegree;
    return {std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
}

inline double dot(const Vec3d& a, const Vec3d& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double angle_deg(const Vec3d& a, const Vec3d& b) {
    const Vec3d cross{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                      a[0] * b[1] - a[1] * b[0]};
    return std::atan2(std::hypot(cross[0], cross[1], cross[2]), dot(a, b)) / kDegree;
}

struct Lamp {
    Vec3d towards;
    double radius_deg, radiance;
    double least_cosine = std::cos(radius_deg * kDegree);
};

// A ball and the lamps as seen from it: near lamps differ between balls.
struct Ball {
    ProbeCircle circle;
    std::vector<Lamp> lamps;
};

// A ray along -z meets the sphere and leaves it by d - 2 (d.n) n.
inline double radiance_at(const std::vector<Ball>& balls, double px, double py) {
    for (const Ball& ball : balls) {
        const double radius = ball.circle.radius;
        const double x = px - ball.circle.x, y = -(py - ball.circle.y);
        const double under = radius * radius - x * x - y * y;
        if (!(under > 0)) continue;
        const Vec3d n{x / radius, y / radius, std::sqrt(under) / radius};
        const double dn = -n[2];  // d = (0, 0, -1)
        const Vec3d out{-2 * dn * n[0], -2 * dn * n[1], -1 - 2 * dn * n[2]};
        double radiance = 0.01;  // the room
        for (const Lamp& lamp : ball.lamps)
            if (dot(out, lamp.towards) > lamp.least_cosine) radiance = lamp.radiance;
        return radiance;
    }
    return 0.02;  // the table in the background
}

// A pixel is the mean of 8 x 8 rays and clips at 1.
inline Image picture_of_balls(const std::vector<Ball>& balls, int channels = 3, int width = 320,
                              int height = 260) {
    constexpr int kRays = 8;
    Image image(width, height, channels, 0.0f);
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            double sum = 0;
            for (int k = 0; k < kRays * kRays; ++k)
                sum += radiance_at(balls, column + (k % kRays + 0.5) / kRays,
                                   row + (k / kRays + 0.5) / kRays);
            const double mean = std::min(sum / (kRays * kRays), 1.0);
            for (int c = 0; c < channels; ++c) image.at(column, row)[c] = static_cast<float>(mean);
        }
    return image;
}

}  // namespace burnish::test
