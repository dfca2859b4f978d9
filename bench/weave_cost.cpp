// Costs of baking large maps of cloth, without file encoding.
#include <chrono>
#include <ctime>
#include <limits>
#include <vector>

#include "burnish/weave_maps.hpp"
#include "report.hpp"

namespace burnish::bench {

namespace {

constexpr int kRuns = 5;

WeaveMapSettings twill() {
    WeaveMapSettings settings;
    settings.draft = builtin_draft("twill-2-2");
    settings.width = settings.height = 4096;
    settings.repeats_u = settings.repeats_v = 32;
    settings.shape.crimp = 0.15f;
    settings.shape.bulge = 0.7f;
    settings.shape.gap = 0.08f;
    settings.shape.twist = {0.94f, 0.34f};
    return settings;
}

// Computes the contents of all files without encoding them.
void fill_pictures(const WeaveMaps& maps, const WeaveMapSettings& settings) {
    constexpr int kRows = 64;
    std::vector<float> strip(static_cast<std::size_t>(maps.width) * kRows * 3);
    for (int y = 0; y < maps.height; y += kRows) {
        weave_normal_rows(maps, y, y + kRows, strip.data());
        weave_direction_rows(maps, y, y + kRows, strip.data());
        weave_color_rows(maps, settings, y, y + kRows, strip.data());
        weave_id_rows(maps, settings, y, y + kRows, strip.data());
    }
}

}  // namespace

void measure_weaves(Report& report) {
    const WeaveMapSettings settings = twill();
    std::vector<double> wall, processor;
    for (int i = 0; i < kRuns; ++i) {
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t used = std::clock();
        const WeaveMaps maps = bake_weave(settings, std::numeric_limits<std::uint64_t>::max());
        fill_pictures(maps, settings);
        processor.push_back(static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC);
        wall.push_back(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    report.rows.push_back(
        {"cloth, 4096x4096, 2/2 twill of 128x128 yarns: height, normals, direction, color, id", 2.0,
         median(wall), half_quartile_distance(wall), "s"});
    report.rows.push_back({"the same, processor time of all cores", 0, median(processor),
                           half_quartile_distance(processor), "s"});
}

}  // namespace burnish::bench
