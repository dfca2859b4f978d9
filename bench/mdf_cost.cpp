// Costs of distributions on the CPU: 16 M pairs of n~ and h, one thread, by thread time.
#include <fmt/format.h>
#include <time.h>

#include <cmath>
#include <random>
#include <vector>

#include "burnish/f32.hpp"
#include "core/large_pages.hpp"
#include "models/batch/mdf_batch.hpp"
#include "report.hpp"

namespace burnish::bench {

namespace {

constexpr std::size_t kPairs = std::size_t{1} << 24;
constexpr int kRuns = 5;

struct Columns {
    std::vector<float> nx, ny, nz, hx, hy, hz;
};

void add_directions(std::vector<float>& x, std::vector<float>& y, std::vector<float>& z,
                    float lowest_cosine, std::mt19937& random) {
    std::uniform_real_distribution<float> cosine(lowest_cosine, 1.0f), azimuth(0.0f, 6.2831853f);
    // Large pages: the benchmark measures arithmetic, not TLB misses of 4 kB pages.
    for (auto* column : {&x, &y, &z}) *column = zeros_on_large_pages<float>(kPairs);
    for (std::size_t i = 0; i < kPairs; ++i) {
        const float c = cosine(random), phi = azimuth(random), s = std::sqrt(1 - c * c);
        x[i] = s * std::cos(phi);
        y[i] = s * std::sin(phi);
        z[i] = c;
    }
}

double nanoseconds_a_pair(const auto& work, std::size_t pairs) {
    const auto now = [] {
        timespec t{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
        return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
    };
    const double start = now();
    work();
    return (now() - start) / static_cast<double>(pairs);
}

struct Lobe {
    Mdf mdf;
    float p0, p1;
};

// One pair after another, with the C library's exp and log: a sixteenth of the pairs.
void scalar(const Lobe& l, Method method, const Columns& c, std::vector<float>& D) {
    const f32::Lobe lobe = f32::lobe_make(static_cast<int>(l.mdf), l.p0, l.p1);
    for (std::size_t i = 0; i < kPairs / 16; ++i) {
        const auto p =
            f32::perturb_make(static_cast<int>(method), {c.nx[i], c.ny[i], c.nz[i]}, true, false);
        D[i] = f32::lobe_D(lobe, p, {c.hx[i], c.hy[i], c.hz[i]});
    }
}

void measure(Report& report, const Lobe& lobe, Method method, double budget, const Columns& c,
             std::vector<float>& D) {
    std::vector<double> batched, ratios;
    for (int run = 0; run < kRuns; ++run) {
        batched.push_back(nanoseconds_a_pair(
            [&] {
                mdf_table(lobe.mdf, lobe.p0, lobe.p1, method, false, {c.nx, c.ny, c.nz},
                          {c.hx, c.hy, c.hz}, D);
            },
            kPairs));
        ratios.push_back(nanoseconds_a_pair([&] { scalar(lobe, method, c, D); }, kPairs / 16) /
                         batched.back());
    }
    const std::string what = fmt::format("{} with {}, 16 M pairs, {}", name_of(lobe.mdf),
                                         name_of(method), mdf_batch_instructions());
    report.rows.push_back({what, budget, median(batched), half_quartile_distance(batched), "ns"});
    report.rows.push_back({what + ": times faster than pair by pair", 0, median(ratios),
                           half_quartile_distance(ratios), "x"});
}

}  // namespace

void measure_distributions(Report& report) {
    Columns c;
    std::mt19937 random(1);
    add_directions(c.nx, c.ny, c.nz, 0.5f, random);
    add_directions(c.hx, c.hy, c.hz, 0.0f, random);
    std::vector<float> D = zeros_on_large_pages<float>(kPairs);
    const Lobe shirley{Mdf::ashikhmin_shirley, 200.0f, 10.0f};
    measure(report, shirley, Method::rotate_approx, 3.0, c, D);
    measure(report, shirley, Method::follow_grain, 3.0, c, D);
    measure(report, shirley, Method::deform_smooth, 3.0, c, D);
    for (const Mdf mdf : {Mdf::ward, Mdf::beckmann, Mdf::ggx}) {
        measure(report, {mdf, 0.1f, 0.4f}, Method::follow_grain, 3.0, c, D);
    }
}

}  // namespace burnish::bench
