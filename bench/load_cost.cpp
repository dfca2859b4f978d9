// Costs of loading a million-triangle model with four large textures, and of the first picture
// after a cold start.
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "formats/gltf/gltf.hpp"
#include "report.hpp"
#include "support/glb_writer.hpp"

namespace burnish::bench {

namespace {

constexpr int kRuns = 5;

double seconds_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// 708 x 708 squares have 1,002,528 triangles. Two textures compress like photographs of smooth
// surfaces, two hardly compress.
std::vector<std::byte> large_glb() {
    GlbWriter writer;
    GlbPrimitive grid = unit_square(708, true);
    const int smooth = writer.add_png(png_gradient(4096, 4096));
    const int smooth_too = writer.add_png(png_gradient(4096, 4096));
    const int rough = writer.add_png(png_noise(4096, 4096, 1));
    const int rough_too = writer.add_png(png_noise(4096, 4096, 2));
    grid.material = writer.add_material({{"pbrMetallicRoughness",
                                          {{"baseColorTexture", {{"index", smooth}}},
                                           {"metallicRoughnessTexture", {{"index", rough}}}}},
                                         {"normalTexture", {{"index", smooth_too}}},
                                         {"occlusionTexture", {{"index", rough_too}}}});
    writer.add_node(writer.add_mesh(grid));
    return writer.glb();
}

Row row_of(std::string work, double budget, const std::vector<double>& times) {
    return {std::move(work), budget, median(times), half_quartile_distance(times), "s"};
}

}  // namespace

void measure_loading(Report& report) {
    const TemporaryFolder folder;
    const auto path = folder.write("large.glb", large_glb());
    std::vector<double> times;
    times.reserve(kRuns);
    for (int i = 0; i < kRuns; ++i) times.push_back(seconds_of([&] { load_gltf(path); }));
    report.rows.push_back(row_of("load a 1 M-triangle glb with four 4096x4096 PNGs", 3.0, times));
}

void measure_first_picture(Report& report) {
    const TemporaryFolder folder;
    const std::string command = fmt::format(
        "\"{}\" render builtin:sphere --env none --light 40,30 --samples 1 "
        "--normal-map builtin:bumps --metal steel -o \"{}\" > /dev/null",
        BURNISH_PROGRAM, (folder.path() / "first.png").string());
    std::vector<double> times;
    times.reserve(kRuns);
    for (int i = 0; i < kRuns; ++i)
        times.push_back(seconds_of([&] {
            if (std::system(command.c_str()) != 0) throw std::runtime_error("render failed");
        }));
    report.rows.push_back(row_of("a first picture from a cold start, one light", 2.0, times));
}

}  // namespace burnish::bench
