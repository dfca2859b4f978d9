// Costs of matching and fitting captures: the slides' search, brute force and ours in one run.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <random>
#include <vector>

#include "burnish/image_io.hpp"
#include "burnish/virtual_sample.hpp"
#include "capture/solve/capture_fit.hpp"
#include "capture/solve/rotation_match.hpp"
#include "report.hpp"

namespace burnish::bench {

namespace {

constexpr NdfGrid kGrid;
constexpr int kRuns = 5;

double seconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Tables {
    std::vector<float> values, weights;
    std::size_t count = 0;
    MaskedTables masked(std::size_t most) const { return {values, weights, std::min(most, count)}; }
};

// Lobes of many shapes, each known on half of the azimuths.
Tables random_tables(std::size_t count) {
    Tables out;
    out.count = count;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    for (std::size_t k = 0; k < count; ++k) {
        const float ax = 0.08f + 0.2f * uniform(random), ay = 0.2f + 0.4f * uniform(random);
        const float turn = 3.14159f * uniform(random), seen = 6.28318f * uniform(random);
        for (int r = 0; r < kGrid.rings; ++r)
            for (int c = 0; c < kGrid.azimuths; ++c) {
                const float theta = kGrid.theta(r), phi = 6.28318f * static_cast<float>(c) / 96.0f;
                const float t = std::tan(std::min(theta, 1.5f));
                const float x = t * std::cos(phi - turn) / ax, y = t * std::sin(phi - turn) / ay;
                out.values.push_back(1.0f / ((1.0f + x * x + y * y) * (1.0f + x * x + y * y)));
                out.weights.push_back(std::cos(phi - seen) > -0.2f && theta < 1.05f ? 1.0f : 0.0f);
            }
    }
    return out;
}

// Matches all rotations by the definition, one after another, in single precision: the "direct"
// cost.
float direct_match(const Tables& t, std::size_t p, std::size_t e) {
    const auto cells = static_cast<std::size_t>(kGrid.cells());
    const float *tv = t.values.data() + p * cells, *tw = t.weights.data() + p * cells;
    const float *cv = t.values.data() + e * cells, *cw = t.weights.data() + e * cells;
    const auto columns = static_cast<std::size_t>(kGrid.azimuths);
    float best = 1.0f;
    for (std::size_t s = 0; s < columns; ++s) {
        float a = 0.0f, b = 0.0f, x = 0.0f;
        for (std::size_t r = 0; r < static_cast<std::size_t>(kGrid.rings); ++r)
            for (std::size_t part = 0; part < 2; ++part) {
                // Two ranges without wraparound, so that the compiler can vectorize over columns.
                const std::size_t begin = part == 0 ? s : 0, end = part == 0 ? columns : s;
                const std::size_t back = part == 0 ? s : s - columns;
                for (std::size_t c = begin; c < end; ++c) {
                    const float w = tw[r * columns + c] * cw[r * columns + (c - back)];
                    const float v = tv[r * columns + c], u = cv[r * columns + (c - back)];
                    a += w * v * v;
                    b += w * u * u;
                    x += w * v * u;
                }
            }
        if (a > 0.0f && b > 0.0f) best = std::min(best, 1.0f - x * x / (a * b));
    }
    return best;
}

// The slides' search: codes of 32 numbers (principal components of 3,072), one entry for every
// rotation of every exemplar; the nearest entries are compared directly at their rotations.
class SlidesSearch {
  public:
    SlidesSearch(const Tables& t, std::size_t exemplars) : tables_(t) {
        const auto cells = static_cast<Eigen::Index>(kGrid.cells());
        const auto count = static_cast<Eigen::Index>(exemplars);
        Eigen::MatrixXf rows(count, cells);
        for (Eigen::Index e = 0; e < count; ++e) rows.row(e) = masked(static_cast<std::size_t>(e));
        const Eigen::MatrixXf gram = rows * rows.transpose();
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXf> solver(gram);
        const Eigen::Index codes = std::min<Eigen::Index>(32, count);
        basis_ = rows.transpose() * solver.eigenvectors().rightCols(codes);
        basis_.colwise().normalize();
        codes_.resize(count * kGrid.azimuths, codes);
        Eigen::VectorXf turned(cells);
        for (Eigen::Index e = 0; e < count; ++e)
            for (int s = 0; s < kGrid.azimuths; ++s) {
                for (int r = 0; r < kGrid.rings; ++r)
                    for (int c = 0; c < kGrid.azimuths; ++c)
                        turned[r * kGrid.azimuths + c] =
                            rows(e, r * kGrid.azimuths + (c - s + kGrid.azimuths) % kGrid.azimuths);
                codes_.row(e * kGrid.azimuths + s) = basis_.transpose() * turned;
            }
        norms_ = codes_.rowwise().squaredNorm();
    }

    float search(std::size_t p) const {
        const Eigen::VectorXf code = basis_.transpose() * masked(p).transpose();
        const Eigen::VectorXf distance = norms_ - 2.0f * codes_ * code;
        std::vector<Eigen::Index> order(static_cast<std::size_t>(distance.size()));
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Eigen::Index>(i);
        constexpr std::ptrdiff_t kNearest = 32;
        std::partial_sort(
            order.begin(), order.begin() + kNearest, order.end(),
            [&](Eigen::Index a, Eigen::Index b) { return distance[a] < distance[b]; });
        float best = 1.0f;
        for (std::ptrdiff_t k = 0; k < kNearest; ++k) {
            const Eigen::Index at = order[static_cast<std::size_t>(k)];
            best = std::min(best, at_turn(p, static_cast<std::size_t>(at / kGrid.azimuths),
                                          static_cast<int>(at % kGrid.azimuths)));
        }
        return best;
    }

  private:
    Eigen::RowVectorXf masked(std::size_t p) const {
        const Eigen::Index cells = kGrid.cells();
        const auto at = static_cast<std::ptrdiff_t>(p) * cells;
        const Eigen::Map<const Eigen::RowVectorXf> v(tables_.values.data() + at, cells);
        const Eigen::Map<const Eigen::RowVectorXf> w(tables_.weights.data() + at, cells);
        return v.cwiseProduct(w);
    }
    float at_turn(std::size_t p, std::size_t e, int s) const {
        float a = 0.0f, b = 0.0f, x = 0.0f;
        for (int r = 0; r < kGrid.rings; ++r)
            for (int c = 0; c < kGrid.azimuths; ++c) {
                const auto at = p * static_cast<std::size_t>(kGrid.cells()) +
                                static_cast<std::size_t>(r * kGrid.azimuths + c);
                const auto from =
                    e * static_cast<std::size_t>(kGrid.cells()) +
                    static_cast<std::size_t>(r * kGrid.azimuths +
                                             (c - s + kGrid.azimuths) % kGrid.azimuths);
                const float w = tables_.weights[at] * tables_.weights[from];
                const float v = tables_.values[at], u = tables_.values[from];
                a += w * v * v;
                b += w * u * u;
                x += w * v * u;
            }
        return a > 0.0f && b > 0.0f ? 1.0f - x * x / (a * b) : 1.0f;
    }

    const Tables& tables_;
    Eigen::MatrixXf basis_, codes_;
    Eigen::VectorXf norms_;
};

void measure_matching(Report& report) {
    constexpr std::size_t kPoints = 512, kExemplars = 512, kDirect = 24;
    const Tables t = random_tables(kExemplars);
    RotationMatcher matcher(kGrid);
    matcher.set_exemplars(t.masked(kExemplars));
    const SlidesSearch slides(t, kExemplars);
    std::vector<double> spectral, direct, searched;
    volatile float sink = 0.0f;
    for (int run = 0; run < kRuns; ++run) {
        spectral.push_back(1e6 / (kPoints * kExemplars) * seconds([&] {
                               matcher.match(t.masked(kPoints),
                                             [&](std::size_t, std::span<const RotationMatch> m) {
                                                 sink = m[0].residual;
                                             });
                           }));
        direct.push_back(1e6 / (kDirect * kDirect) * seconds([&] {
                             for (std::size_t p = 0; p < kDirect; ++p)
                                 for (std::size_t e = 0; e < kDirect; ++e)
                                     sink = direct_match(t, p, e);
                         }));
        searched.push_back(1e6 / (kDirect * kExemplars) * seconds([&] {
                               for (std::size_t p = 0; p < kDirect; ++p) sink = slides.search(p);
                           }));
    }
    report.rows.push_back({"spectral match, all 96 turns of a pair, both cores", 2.0,
                           median(spectral), half_quartile_distance(spectral), "us"});
    report.rows.push_back(
        {"the slides' search, a pair of point and exemplar (codes of 32, the nearest 32 turns "
         "directly), one core",
         0, median(searched), half_quartile_distance(searched), "us"});
    report.rows.push_back({"direct match, all 96 turns of a pair, one core", 0, median(direct),
                           half_quartile_distance(direct), "us"});
    const double pairs = 6400.0 * 6400.0;
    report.rows.push_back({"6,400 x 6,400 exemplars, from the pair: spectral", 90.0,
                           pairs * 1e-6 * median(spectral),
                           pairs * 1e-6 * half_quartile_distance(spectral), "s"});
    report.rows.push_back({"the same, direct", 0, pairs * 1e-6 * median(direct), 0, "s"});
    const double brute = 640000.0 * 640000.0 * 1e-6 * median(direct) / 86400.0 / 365.25;
    report.rows.push_back({"640,000 x 640,000 points, brute force", 0, brute, 0, "years"});
}

// The whole fit at two sizes: cost is linear in pixels, plus the constant cost of exemplars.
void measure_fit(Report& report) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / fmt::format("burnish-bench-{}", std::rand());
    std::vector<double> texels;
    double exemplars = 0.0;
    for (const int size : {32, 64}) {
        VirtualSettings settings;
        settings.width = settings.height = size;
        const VirtualSample sample = make_virtual_sample("classes", settings);
        Rig rig = make_bar_rig(sample, 40, 40, {});
        std::filesystem::create_directories(folder);
        for (std::size_t k = 0; k < rig.lights.size(); ++k) {
            const auto path = folder / fmt::format("{:05}.exr", k);
            write_image(path, virtual_picture(sample, rig, k, {.noise = 0.01}), {});
            rig.lights[k].images = {{path, 1.0}};
        }
        CaptureFitSettings fit_settings;
        fit_settings.eta = 1.5;
        CaptureFit fit(rig, fit_settings, folder / "stages", {});
        exemplars = seconds([&] { fit.find_exemplars(); });
        texels.push_back(seconds([&] { fit.fit_texels(); }));
        std::filesystem::remove_all(folder);
    }
    const double pixel = (texels[1] - texels[0]) / (64.0 * 64.0 - 32.0 * 32.0);
    report.rows.push_back({"fit: a pixel of 1,600 lights, models too", 0, 1e3 * pixel, 0, "ms"});
    report.rows.push_back(
        {"fit: exemplars of 1,600 lights, from as many points as are usual", 0, exemplars, 0, "s"});
    report.rows.push_back({"fit: 640,000 pixels of 1,600 lights beyond reading, from the pixel",
                           600.0, 640000.0 * pixel + exemplars, 0, "s"});
    report.rows.push_back({"fit: pixels four times as many take this much longer", 4.4,
                           texels[1] / texels[0], 0, "x"});
}

}  // namespace

void measure_capture(Report& report) {
    measure_matching(report);
    measure_fit(report);
}

}  // namespace burnish::bench
