// Costs of engraving a large scratch map, without file encoding.
#include <chrono>
#include <cstddef>
#include <ctime>
#include <limits>

#include "burnish/scratch_maps.hpp"
#include "report.hpp"

namespace burnish::bench {

namespace {

constexpr int kRuns = 5;

ScratchSettings handled_metal() {
    ScratchSettings settings;
    settings.size = 4096;
    ScratchLayer layer;
    layer.count = 20000;
    layer.length_mm = parse_spread("lognormal:5:0.6", "length");
    layer.width_mm = parse_spread("lognormal:0.1:0.3", "width");
    layer.depth_mm = constant_spread(0.01);
    layer.curvature_per_mm = parse_spread("normal:0:0.03", "curvature");
    settings.layers = {layer};
    return settings;
}

}  // namespace

void measure_scratches(Report& report) {
    const ScratchSettings settings = handled_metal();
    std::vector<double> wall, processor;
    for (int i = 0; i < kRuns; ++i) {
        const auto start = std::chrono::steady_clock::now();
        const std::clock_t used = std::clock();
        const ScratchMaps maps = engrave(settings, {}, std::numeric_limits<std::uint64_t>::max());
        const Image normals = normal_map(maps);
        processor.push_back(static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC);
        wall.push_back(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    report.rows.push_back(
        {"scratch map, 4096x4096, 20,000 scratches: height, direction, normals, moments", 2.0,
         median(wall), half_quartile_distance(wall), "s"});
    report.rows.push_back({"the same, processor time of all cores", 0, median(processor),
                           half_quartile_distance(processor), "s"});
}

}  // namespace burnish::bench
