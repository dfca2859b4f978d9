// The truth of docs/theory/processes.md without a model: a plate whose grain is a relief of real facets, all mirrors,
// moved as the process moves it and met by rays, with the hiding and shadowing of the triangles themselves.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <random>
#include <vector>

#include "burnish/f64.hpp"
#include "burnish/shading_names.hpp"
#include "core/constants.hpp"
#include "core/parallel.hpp"
#include "rays/ray_scene.hpp"

namespace burnish::test {
namespace {

constexpr int kSide = 384;    // points of the relief along an edge
constexpr int kWaves = 400;   // of which its height is the sum: slopes are then Gaussian
constexpr int kReliefs = 8;   // independent ones
constexpr int kRays = 60000;  // of a relief, a view and a process
constexpr double kAlphaX = 0.2, kAlphaY = 0.6;

// Heights on the unit square, in its units.
std::vector<double> heights(unsigned seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal(0, 1);
    std::uniform_real_distribution<double> uniform(0, 2 * kPi);
    std::vector<double> h(kSide * kSide);
    // Wave lengths of 16 points along y at a standard deviation: a triangle's slope is within 1 % of the wave's.
    const double ky = 2 * kPi * kSide / 16 / 3, kx = ky * kAlphaX / kAlphaY;
    // The slopes along y vary by alpha_y^2 / 2 = waves a^2 ky^2 / 2.
    const double amplitude = kAlphaY / (ky * std::sqrt(static_cast<double>(kWaves)));
    for (int wave = 0; wave < kWaves; ++wave) {
        const double x = kx * normal(generator), y = ky * normal(generator);
        const double phase = uniform(generator);
        parallel_for(kSide, 16, [&](std::size_t begin, std::size_t end) {
            for (std::size_t row = begin; row < end; ++row) {
                // The wave turns by the same angle from column to column.
                const std::complex<double> turn = std::polar(1.0, x / kSide);
                std::complex<double> at =
                    std::polar(amplitude, y * static_cast<double>(row) / kSide + phase);
                for (std::size_t column = 0; column < kSide; ++column, at *= turn)
                    h[row * kSide + column] += at.real();
            }
        });
    }
    return h;
}

const std::vector<std::vector<double>>& all_heights() {
    static const std::vector<std::vector<double>> all = [] {
        std::vector<std::vector<double>> made;
        for (unsigned r = 0; r < kReliefs; ++r) made.push_back(heights(r + 1));
        return made;
    }();
    return all;
}

// Columns: where the process takes x, y, z.
glm::dmat3 surface_map(Process process, glm::dvec3 n) {
    const glm::dvec3 x(1, 0, -n.x / n.z), y(0, 1, -n.y / n.z);
    if (process == Process::brushed_after) return {x, y, glm::dvec3(0, 0, 1)};
    if (process == Process::stamped) return {x, y, n};
    // A rigid frame; grooves run along x, the axis of the smaller alpha.
    const glm::dvec3 groove = glm::normalize(x);
    return {groove, glm::cross(n, groove), n};
}

WorldMesh relief(const std::vector<double>& h, const glm::dmat3& map) {
    WorldMesh mesh;
    for (std::uint32_t row = 0; row < kSide; ++row) {
        for (std::uint32_t column = 0; column < kSide; ++column) {
            const glm::dvec3 p(column / static_cast<double>(kSide) - 0.5,
                               row / static_cast<double>(kSide) - 0.5, h[row * kSide + column]);
            mesh.positions.emplace_back(map * p);
        }
    }
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 0, 1));
    for (std::uint32_t row = 0; row + 1 < kSide; ++row) {
        for (std::uint32_t column = 0; column + 1 < kSide; ++column) {
            const std::uint32_t i = row * kSide + column;
            for (const std::uint32_t corner :
                 {i, i + 1, i + kSide + 1, i, i + kSide + 1, i + kSide})
                mesh.indices.push_back(corner);
        }
    }
    return mesh;
}

glm::dvec3 direction_of(double tilt_deg, double azimuth_deg) {
    const double t = tilt_deg * kPi / 180, a = azimuth_deg * kPi / 180;
    return {std::sin(t) * std::cos(a), std::sin(t) * std::sin(a), std::cos(t)};
}

// A lamp: a cap of the sphere, of radiance 1.
struct Lamp {
    glm::dvec3 towards;
    double cosine;  // of its half angle
    bool holds(glm::dvec3 w) const { return glm::dot(towards, w) > cosine; }
};

std::vector<Lamp> lamps_about(glm::dvec3 mirror) {
    std::vector<Lamp> lamps;
    const glm::dvec3 t = glm::normalize(glm::cross(glm::dvec3(0, 1, 0.1), mirror));
    const glm::dvec3 b = glm::cross(mirror, t);
    for (const double off : {0.0, 0.35})
        for (int k = 0; k < (off > 0 ? 4 : 1); ++k)
            lamps.push_back({glm::normalize(mirror + off * (std::cos(k * kPi / 2) * t +
                                                            std::sin(k * kPi / 2) * b)),
                             std::cos(10 * kPi / 180)});
    return lamps;
}

// Radiance towards the eye in each lamp's light: shares of the rays that facets reflect there and nothing blocks.
std::vector<double> traced(const RayScene& scene, const glm::dmat3& map, glm::dvec3 wo,
                           const std::vector<Lamp>& lamps, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-0.25,
                                                   0.25);  // the middle: edges are out of sight
    std::vector<double> sums(lamps.size());
    for (int i = 0; i < kRays; ++i) {
        const glm::dvec3 at = map * glm::dvec3(uniform(generator), uniform(generator), 0);
        Ray ray;
        ray.origin = glm::vec3(at + wo * 2.0);
        ray.direction = glm::vec3(-wo);
        const auto hit = scene.nearest(ray);
        if (!hit) continue;
        glm::dvec3 m = glm::normalize(glm::dvec3(hit->normal));
        if (glm::dot(m, wo) < 0) m = -m;
        const glm::dvec3 wi = 2 * glm::dot(m, wo) * m - wo;
        for (std::size_t k = 0; k < lamps.size(); ++k) {
            if (!lamps[k].holds(wi)) continue;
            Ray on;
            on.origin = ray.origin + ray.direction * hit->distance;
            on.direction = glm::vec3(wi);
            // A hundredth of the distance of points: rounding of the place that was hit.
            on.nearest = 0.01f / kSide;
            if (!scene.is_blocked(on)) sums[k] += 1.0 / kRays;
        }
    }
    return sums;
}

// Int f cos over the lamp, on a grid of its cap.
double closed(const f64::Perturbation& p, glm::dvec3 wo, const Lamp& lamp) {
    const f64::Lobe lobe = f64::lobe_make(f64::kMdfBeckmann, kAlphaX, kAlphaY);
    const glm::dvec3 t = glm::normalize(glm::cross(glm::dvec3(0, 1, 0.1), lamp.towards));
    const glm::dvec3 b = glm::cross(lamp.towards, t);
    double sum = 0;
    constexpr int kRings = 24, kSectors = 48;
    for (int i = 0; i < kRings; ++i) {
        const double z = 1 - (1 - lamp.cosine) * (i + 0.5) / kRings, s = std::sqrt(1 - z * z);
        for (int k = 0; k < kSectors; ++k) {
            const double a = 2 * kPi * (k + 0.5) / kSectors;
            const glm::dvec3 wi = lamp.towards * z + (t * std::cos(a) + b * std::sin(a)) * s;
            sum += f64::brdf_eval(f64::kBrdfMicrofacet, lobe, p, f64::vec3(wi), f64::vec3(wo)) *
                   std::max(f64::dot(p.n, f64::vec3(wi)), 0.0);
        }
    }
    return sum * 2 * kPi * (1 - lamp.cosine) / (kRings * kSectors);
}

struct Comparison {
    double error = 0;   // relative RMSE over lamps and views, the noise of the rays taken away
    double noise = 0;   // its standard error, relative as well
    double energy = 0;  // mean of the closed form over that of the rays
};

constexpr std::array<Method, 4> kMethods = {Method::follow_grain, Method::rotate_arc,
                                            Method::stretch, Method::slope_shift};

std::array<Comparison, 4> compare(Process process, double tilt_deg) {
    const glm::dvec3 n = direction_of(tilt_deg, 30);
    const glm::dmat3 map = surface_map(process, n);
    struct Cell {
        glm::dvec3 wo;
        Lamp lamp;
        std::vector<double> values;  // of each relief
    };
    std::vector<Cell> cells;
    for (const glm::dvec3& wo : {direction_of(0, 0), direction_of(40, 250)})
        for (const Lamp& lamp : lamps_about(glm::normalize(2 * glm::dot(n, wo) * n - wo)))
            cells.push_back({wo, lamp, {}});
    for (unsigned r = 0; r < kReliefs; ++r) {
        const std::vector<WorldMesh> meshes = {relief(all_heights()[r], map)};
        const RayScene scene(meshes);
        for (std::size_t first = 0; first < cells.size(); first += 5) {
            std::vector<Lamp> lamps;
            for (std::size_t k = 0; k < 5; ++k) lamps.push_back(cells[first + k].lamp);
            const auto found = traced(scene, map, cells[first].wo, lamps, 100 + r);
            for (std::size_t k = 0; k < 5; ++k) cells[first + k].values.push_back(found[k]);
        }
    }
    std::array<Comparison, 4> result;
    for (std::size_t m = 0; m < kMethods.size(); ++m) {
        double squares = 0, noise = 0, truth2 = 0, all = 0, closed_all = 0;
        for (const Cell& cell : cells) {
            double mean = 0, spread = 0;
            for (const double v : cell.values) mean += v / kReliefs;
            for (const double v : cell.values) spread += (v - mean) * (v - mean);
            const f64::Perturbation p =
                f64::perturb_make(static_cast<int>(kMethods[m]), f64::vec3(n), true, false);
            const double want = closed(p, cell.wo, cell.lamp);
            squares += (want - mean) * (want - mean);
            noise += spread / (kReliefs - 1) / kReliefs;
            truth2 += mean * mean;
            all += mean;
            closed_all += want;
        }
        result[m] = {std::sqrt(std::max(squares - noise, 0.0) / truth2), std::sqrt(noise / truth2),
                     closed_all / all};
    }
    return result;
}

void expect_nearest(Process process, double tilt_deg) {
    const std::array<Comparison, 4> all = compare(process, tilt_deg);
    Comparison own, runner_up{1e9, 0, 0};
    for (std::size_t m = 0; m < kMethods.size(); ++m) {
        if (std::getenv("BURNISH_PRINT_FACETS"))
            std::printf("| %s | %.0f | %s | %.3f | %.3f | %.3f |\n", name_of(process).data(),
                        tilt_deg, name_of(kMethods[m]).data(), all[m].error, all[m].noise,
                        all[m].energy);
        if (kMethods[m] == method_of(process))
            own = all[m];
        else if (all[m].error < runner_up.error)
            runner_up = all[m];
    }
    // What Smith's masking leaves: it takes facets to be independent of their height.
    EXPECT_LT(own.error, 0.06) << name_of(process) << " " << tilt_deg;
    EXPECT_NEAR(own.energy, 1.0, 0.04) << name_of(process) << " " << tilt_deg;
    EXPECT_GT(runner_up.error, 1.5 * own.error) << name_of(process) << " " << tilt_deg;
}

TEST(CarvedRelief, BrushedAfterIsSlopeShift) {
    expect_nearest(Process::brushed_after, 30);
    expect_nearest(Process::brushed_after, 45);
}

TEST(CarvedRelief, StampedIsStretch) {
    expect_nearest(Process::stamped, 30);
    expect_nearest(Process::stamped, 45);
}

// The test itself: a relief that keeps its shape is the rotated lobe.
TEST(CarvedRelief, EmbossedIsFollowGrain) {
    expect_nearest(Process::embossed, 45);
}

}  // namespace
}  // namespace burnish::test
