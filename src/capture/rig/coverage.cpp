#include "burnish/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/constants.hpp"

namespace burnish {

namespace {

constexpr double kReachBySpacing = 0.75, kLongestReach = 10.0;
constexpr double kCoincident = 1e-6;  // radians; far below any spacing, far above rounding

double dot(const Vec3d& a, const Vec3d& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Uses the chord: the cosine loses its digits near 1.
double angle(const Vec3d& a, const Vec3d& b) {
    const double chord = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    return 2.0 * std::asin(std::min(0.5 * chord, 1.0));
}

double tilt_deg(const Vec3d& v) {
    return std::atan2(std::hypot(v[0], v[1]), v[2]) / kDegree;
}

Vec3d half_vector(const Vec3d& a, const Vec3d& b) {
    const Vec3d sum{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    const double size = std::hypot(sum[0], sum[1], sum[2]);  // both are above the sample: not zero
    return {sum[0] / size, sum[1] / size, sum[2] / size};
}

// Sorts by height: the search for the nearest vector stops when the height difference alone is too
// large.
std::vector<Vec3d> distinct(std::vector<Vec3d> vectors) {
    std::sort(vectors.begin(), vectors.end(),
              [](const Vec3d& a, const Vec3d& b) { return a[2] < b[2]; });
    std::vector<Vec3d> kept;
    for (const Vec3d& v : vectors) {
        bool is_new = true;
        for (auto other = kept.rbegin(); other != kept.rend() && is_new; ++other) {
            if (v[2] - (*other)[2] > kCoincident) break;
            is_new = angle(v, *other) > kCoincident;
        }
        if (is_new) kept.push_back(v);
    }
    return kept;
}

double median_spacing_deg(const std::vector<Vec3d>& by_height) {
    if (by_height.size() < 2) return 0.0;
    std::vector<double> nearest;
    const auto size = static_cast<std::ptrdiff_t>(by_height.size());
    for (std::ptrdiff_t i = 0; i < size; ++i) {
        const Vec3d& v = by_height[static_cast<std::size_t>(i)];
        double least = 4.0;  // squared chord
        for (const std::ptrdiff_t step : {-1, 1})
            for (std::ptrdiff_t k = i + step; k >= 0 && k < size; k += step) {
                const Vec3d& other = by_height[static_cast<std::size_t>(k)];
                const double rise = v[2] - other[2];
                if (rise * rise >= least) break;
                least = std::min(least, 2.0 - 2.0 * dot(v, other));
            }
        nearest.push_back(2.0 * std::asin(0.5 * std::sqrt(std::max(least, 0.0))) / kDegree);
    }
    const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
    std::nth_element(nearest.begin(), middle, nearest.end());
    return *middle;
}

// Counts points of equal solid angle on a spiral: equal steps in height, golden angles in azimuth.
double covered_share(const std::vector<Vec3d>& by_height, double reach_deg) {
    constexpr int kPoints = 20000;  // a cap of one degree holds three
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double least_cosine = std::cos(reach_deg * kDegree);
    const double highest_rise =
        2.0 * std::sin(0.5 * reach_deg * kDegree);  // not more than the chord
    int covered = 0;
    auto first = by_height.begin();
    for (int k = 0; k < kPoints; ++k) {
        const double z = (k + 0.5) / kPoints;
        const double r = std::sqrt(1.0 - z * z);
        const Vec3d point{r * std::cos(k * golden), r * std::sin(k * golden), z};
        while (first != by_height.end() && (*first)[2] < z - highest_rise) ++first;
        for (auto h = first; h != by_height.end() && (*h)[2] <= z + highest_rise; ++h)
            if (dot(*h, point) >= least_cosine) {
                ++covered;
                break;
            }
    }
    return static_cast<double>(covered) / kPoints;
}

// A half vector that is rotated about the normal covers a ring. A ring's share of the hemisphere is
// its extent in height.
double turned_share(const std::vector<Vec3d>& by_height, double reach_deg) {
    double share = 0.0, low = 1.0;  // the rings are visited from the top down
    for (auto h = by_height.rbegin(); h != by_height.rend(); ++h) {
        const double theta = tilt_deg(*h);
        const double top = std::cos(std::max(theta - reach_deg, 0.0) * kDegree);
        const double bottom = std::cos(std::min(theta + reach_deg, 90.0) * kDegree);
        share += std::max(std::min(top, low) - bottom, 0.0);
        low = std::min(low, bottom);
    }
    return share;
}

double azimuth_spread_deg(const Rig& rig) {
    constexpr double kUpright = 1.0;  // degrees; closer to the normal an azimuth means nothing
    std::vector<double> azimuths;
    for (const RigLight& light : rig.lights) {
        const Vec3d i = direction_to(light.place, {0.0, 0.0, 0.0});
        if (tilt_deg(i) >= kUpright) azimuths.push_back(std::atan2(i[1], i[0]) / kDegree);
    }
    if (azimuths.size() < 2) return 0.0;
    std::sort(azimuths.begin(), azimuths.end());
    double gap = azimuths.front() + 360.0 - azimuths.back();
    for (std::size_t i = 1; i < azimuths.size(); ++i)
        gap = std::max(gap, azimuths[i] - azimuths[i - 1]);
    return 360.0 - gap;
}

bool is_near(const Rig& rig) {
    return rig.camera.near || std::any_of(rig.lights.begin(), rig.lights.end(), [](const auto& l) {
               return l.place.near || (l.camera && l.camera->near);
           });
}

std::vector<std::string> diagnose(const RigCoverage& all) {
    constexpr double kOnTheNormal = 2.0, kAllRound = 270.0;  // degrees
    const PointCoverage& center = all.center;
    std::vector<std::string> lines;
    if (center.half_vectors.size() == 1) {
        lines.push_back("one light: nothing can be fitted");
        return lines;
    }
    // If the camera is on the normal and lights surround it, rotating the grain gives the same half
    // vectors.
    if (center.theta_view < kOnTheNormal && all.azimuth_spread >= kAllRound)
        lines.push_back("camera on the normal: turning adds nothing, completion is impossible");
    if (center.covered_turned < 0.99)
        lines.push_back(fmt::format(
            "no half vector tilts more than {:.0f} deg: beyond, a distribution is a guess",
            center.theta_h_max));
    if (all.azimuth_spread < 180.0)
        lines.push_back(
            fmt::format("all lights lie within {:.0f} deg of azimuth", all.azimuth_spread));
    if (all.narrowest_ggx > 0.3)
        lines.push_back(
            fmt::format("few lights: highlights narrower than alpha {:.2f} fall between them",
                        all.narrowest_ggx));
    if (all.lowest_light < 5.0)
        lines.push_back(
            fmt::format("lights down to {:.1f} deg over the sample: what stands up casts shadows",
                        all.lowest_light));
    return lines;
}

}  // namespace

// D(theta) / D(0) = (cos^2 theta + sin^2 theta / alpha^2)^-2 is 1/2 at theta = spacing.
double narrowest_ggx_alpha(double spacing_deg) {
    const double s = std::sin(spacing_deg * kDegree);
    return s / std::sqrt(s * s + std::numbers::sqrt2 - 1.0);
}

// exp(-tan^2 theta / alpha^2) / cos^4 theta = 1/2 at theta = spacing.
double narrowest_beckmann_alpha(double spacing_deg) {
    const double t = std::tan(spacing_deg * kDegree);
    const double log_two = std::numbers::ln2 + 2.0 * std::log1p(t * t);  // 1/cos^4 is (1 + t^2)^2
    return t / std::sqrt(log_two);
}

PointCoverage point_coverage(const Rig& rig, const Vec3d& point_mm) {
    PointCoverage out;
    out.point_mm = point_mm;
    for (const RigLight& light : rig.lights) {
        const Vec3d i = direction_to(light.place, point_mm);
        const Vec3d o = direction_to(light.camera ? *light.camera : rig.camera, point_mm);
        const Vec3d h = half_vector(i, o);
        out.half_vectors.push_back(h);
        out.theta_view += tilt_deg(o) / static_cast<double>(rig.lights.size());
        out.theta_h_max = std::max(out.theta_h_max, tilt_deg(h));
        out.theta_h_limit = std::max(out.theta_h_limit, 0.5 * (tilt_deg(i) + tilt_deg(o)));
    }
    const std::vector<Vec3d> by_height = distinct(out.half_vectors);
    out.spacing = median_spacing_deg(by_height);
    out.reach = std::min(kReachBySpacing * out.spacing, kLongestReach);
    out.covered = covered_share(by_height, out.reach);
    out.covered_turned = turned_share(by_height, out.reach);
    return out;
}

RigCoverage rig_coverage(const Rig& rig) {
    RigCoverage out;
    out.center = point_coverage(rig, {0.0, 0.0, 0.0});
    if (rig.width_mm > 0.0 && rig.height_mm > 0.0 && is_near(rig))
        for (const double y : {0.5, -0.5})
            for (const double x : {-0.5, 0.5})
                out.corners.push_back(
                    point_coverage(rig, {x * rig.width_mm, y * rig.height_mm, 0.0}));
    out.lowest_light = 90.0;
    for (const RigLight& light : rig.lights) {
        const double elevation = 90.0 - tilt_deg(direction_to(light.place, {0.0, 0.0, 0.0}));
        out.lowest_light = std::min(out.lowest_light, elevation);
        out.highest_light = std::max(out.highest_light, elevation);
    }
    out.azimuth_spread = azimuth_spread_deg(rig);
    if (out.center.spacing > 0.0) {
        out.narrowest_ggx = narrowest_ggx_alpha(out.center.spacing);
        out.narrowest_beckmann = narrowest_beckmann_alpha(out.center.spacing);
    }
    out.diagnosis = diagnose(out);
    return out;
}

}  // namespace burnish
