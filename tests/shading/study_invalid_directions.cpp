// Writes the tables of docs/evidence/invalid-directions.md and its picture.
// Usage: study_invalid_directions PICTURE.jpg > tables.md
#include <cstdio>
#include <vector>

#include "burnish/image_io.hpp"
#include "core/parallel.hpp"
#include "horizon_strategies.hpp"

namespace burnish::test {
namespace {

constexpr int kStrategies = static_cast<int>(kStrategyNames.size());

double furnace(vec3) {
    return 1.0;
}

struct Figures {
    double mean = 0, least = 1e9, most = 0;  // albedo
    double black = 0;                        // share of views with albedo below 0.01
    double mirror_below = 0;                 // of the mean, what comes from below the surface
};

f64::Lobe lobe_of(double alpha_x, double alpha_y) {
    return f64::lobe_make(f64::kMdfGgx, alpha_x, alpha_y);
}

// Views spread evenly over the solid angle above 3 degrees, tilts over azimuths.
Figures figures(Strategy strategy, const f64::Lobe& lobe, double tilt_deg) {
    Figures f;
    constexpr int kViews = 400;
    for (int i = 0; i < kViews; ++i) {
        const auto xi = low_discrepancy(static_cast<std::uint32_t>(i), 0.5, 0.5);
        const double z = 0.05 + 0.95 * xi.x, phi = 2 * kPi * xi.y;
        const vec3 wo = direction(std::acos(z), phi);
        const vec3 n = direction(tilt_deg * kPi / 180, 2 * kPi * 0.61803 * i);
        const double albedo = reflected(strategy, lobe, n, wo, 256, 0.1, 0.2, furnace);
        const double from_above = reflected(strategy, lobe, n, wo, 256, 0.1, 0.2,
                                            [](vec3 wi) { return wi.z > 0 ? 1.0 : 0.0; });
        f.mean += albedo / kViews;
        f.least = std::min(f.least, albedo);
        f.most = std::max(f.most, albedo);
        f.black += (albedo < 0.01) / static_cast<double>(kViews);
        f.mirror_below += (albedo - from_above) / kViews;
    }
    return f;
}

// The largest change for a quarter of a degree of tilt under a sky that brightens upwards, in parts
// of its brightness: 0.02 or so is what a smooth surface shows there.
double jump(Strategy strategy, const f64::Lobe& lobe) {
    double largest = 0;
    for (const double view_deg : {30.0, 60.0, 80.0}) {
        for (const double azimuth_deg : {180.0, 150.0, 90.0}) {
            const vec3 wo = direction(view_deg * kPi / 180, 0.0);
            double before = -1;
            for (double tilt = 0; tilt <= 80; tilt += 0.25) {
                const vec3 n = direction(tilt * kPi / 180, azimuth_deg * kPi / 180);
                const double now = reflected(strategy, lobe, n, wo, 512, 0.1, 0.2,
                                             [](vec3 wi) { return 0.5 + 0.5 * wi.z; });
                if (before >= 0) largest = std::max(largest, std::abs(now - before));
                before = now;
            }
        }
    }
    return largest;
}

void print_tables() {
    const double alphas[2][2] = {{0.1, 0.4}, {0.3, 0.6}};
    for (const auto& a : alphas) {
        const f64::Lobe lobe = lobe_of(a[0], a[1]);
        std::printf("\nGGX, alphas %.1f, %.1f:\n\n", a[0], a[1]);
        std::printf(
            "| strategy | tilt | albedo, mean | least | most | black views |"
            " of it from below | largest jump |\n|---|---|---|---|---|---|---|---|\n");
        for (int s = 0; s < kStrategies; ++s) {
            const auto strategy = static_cast<Strategy>(s);
            const double leap = jump(strategy, lobe);
            for (const double tilt : {30.0, 60.0, 80.0}) {
                const Figures f = figures(strategy, lobe, tilt);
                std::printf("| %s | %.0f | %.3f | %.3f | %.3f | %.1f %% | %.3f | %.3f |\n",
                            std::string(kStrategyNames[static_cast<std::size_t>(s)]).c_str(), tilt,
                            f.mean, f.least, f.most, 100 * f.black, f.mirror_below, leap);
            }
        }
    }
}

// ---- the picture --------------------------------------------------------------------------------

constexpr int kSide = 300;

// A dim room with two soft boxes, +y up; also below the horizon of a surface there is a room.
double studio(vec3 d) {
    const auto box = [&](vec3 towards, double cosine) {
        const double c = f64::dot(d, f64::normalize(towards));
        return std::min(std::max((c - cosine) * 20, 0.0), 1.0);
    };
    return 0.25 + 0.2 * d.y + 3.0 * box({-0.6, 0.7, 0.5}, 0.86) + 1.5 * box({0.9, 0.2, 0.3}, 0.92);
}

// Round bumps in rows on longitude and latitude, up to 80 degrees steep.
vec3 bump_normal(double u, double v) {
    const double x = u - std::round(u), y = v - std::round(v), r = std::hypot(x, y) / 0.48;
    if (r >= 1 || r == 0) return {0, 0, 1};
    const double tilt = 80 * kPi / 180 * std::sin(kPi * r), s = std::sin(tilt) / std::hypot(x, y);
    return {s * x, s * y, std::cos(tilt)};
}

double pixel(Strategy strategy, const f64::Lobe& lobe, double x, double y, double shift) {
    const double r2 = x * x + y * y;
    if (r2 >= 1) return 0.18;
    const vec3 out{x, y, std::sqrt(1 - r2)};
    const vec3 east = f64::normalize(f64::cross(vec3{0, 1, 0}, out));
    const vec3 north = f64::cross(out, east);
    const auto to_world = [&](vec3 w) { return east * w.x + north * w.y + out * w.z; };
    const vec3 n = bump_normal(std::atan2(x, out.z) * 4.5, std::asin(y) * 4.5);
    const vec3 wo{east.z, north.z, out.z};  // the eye is at +z
    return reflected(strategy, lobe, n, wo, 12, shift, 1.618 * shift,
                     [&](vec3 wi) { return studio(to_world(wi)); });
}

void write_picture(const char* path) {
    Image image;
    image.width = kSide * kStrategies;
    image.height = kSide;
    image.channels = 3;
    image.pixels.resize(static_cast<std::size_t>(image.width) * kSide * 3);
    const f64::Lobe lobe = lobe_of(0.1, 0.4);
    parallel_for(kSide, 1, [&](std::size_t row, std::size_t) {
        for (int column = 0; column < image.width; ++column) {
            const auto strategy = static_cast<Strategy>(column / kSide);
            double sum = 0;
            for (int i = 0; i < 16; ++i) {
                const auto at = low_discrepancy(static_cast<std::uint32_t>(i), 0.3, 0.7);
                const double x = 2.1 * ((column % kSide + at.x) / kSide - 0.5);
                const double y = -2.1 * ((static_cast<double>(row) + at.y) / kSide - 0.5);
                const double v = pixel(strategy, lobe, x, y, 0.37 * i);
                sum += v / (1 + 0.35 * v) / 16;
            }
            float* p = image.at(column, static_cast<int>(row));
            p[0] = p[1] = p[2] = srgb_from_linear(static_cast<float>(std::min(sum, 1.0)));
        }
    });
    write_image(path, image, {});
}

}  // namespace
}  // namespace burnish::test

int main(int argc, char** argv) {
    burnish::test::print_tables();
    if (argc > 1) burnish::test::write_picture(argv[1]);
    return 0;
}
