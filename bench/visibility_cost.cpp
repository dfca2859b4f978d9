// What visibility costs: finding it, and a frame with it relative to one without.
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <vector>

#include "burnish/environments.hpp"
#include "burnish/prepared_environment.hpp"
#include "burnish/visibility.hpp"
#include "frame_subject.hpp"

namespace burnish::bench {
namespace {

constexpr int kTriangles = 102400;

Scene steel_torus() {
    return torus_with(kTriangles, {{"metal", "steel"},
                                   {"alpha_x", "0.1"},
                                   {"alpha_y", "0.4"},
                                   {"normal_map", "builtin:bumps"}});
}

}  // namespace

void measure_visibility(Report& report) {
    using SteadyClock = std::chrono::steady_clock;
    gpu::Context context;
    report.device = context.renderer();
    const Scene scene = steel_torus();
    const auto environment = prepare_environment(load_environment("builtin:studio"));
    std::vector<double> found_s, lit_s;
    std::shared_ptr<const Visibility> visibility;
    for (int round = 0; round < 5; ++round) {
        const auto start = SteadyClock::now();
        VisibilityFinder finder(scene, {});
        const auto found = SteadyClock::now();
        visibility = finder.lit({environment, 1.0f, 0.0f, {}}, 2);
        found_s.push_back(std::chrono::duration<double>(found - start).count());
        lit_s.push_back(std::chrono::duration<double>(SteadyClock::now() - found).count());
    }
    const std::string size = fmt::format("{} k triangles", kTriangles / 1000);
    report.rows.push_back({fmt::format("visibility of {}", size), 3.0, median(found_s),
                           half_quartile_distance(found_s), "s"});
    report.rows.push_back({fmt::format("light between surfaces, two bounces, {}", size), 0.0,
                           median(lit_s), half_quartile_distance(lit_s), "s"});

    const Environment studio = load_environment("builtin:studio");
    for (const ImageLight light : {ImageLight::prefiltered, ImageLight::importance}) {
        FrameSubject with(context, scene, light, &studio), without(context, scene, light, &studio);
        with.renderer().set_visibility(visibility);
        report.rows.push_back(
            ratio_of(with, without,
                     fmt::format("a frame with visibility against one without, {}, image light {}",
                                 size, image_light_names()[static_cast<std::size_t>(light)]),
                     1.1));
    }
}

}  // namespace burnish::bench
