// Frame costs relative to their budgets: the same measurement as `burnish bench frame`
// (bench/frame/frame_bench.hpp), each method relative to normal-map, on the available GL.
#include <fmt/format.h>

#include <array>

#include "bench/frame/frame_bench.hpp"
#include "burnish/context.hpp"
#include "burnish/renderer.hpp"
#include "report.hpp"

namespace burnish::bench {

namespace {

// Median and spread of subject/base over interleaved pairs, in alternating order.
Row compare(FrameBench& bench, std::string_view subject, std::string_view base) {
    const std::array<const Technique*, 2> pair = {&technique_named(subject, "bench"),
                                                  &technique_named(base, "bench")};
    InterleaveOptions options;
    options.rounds = 15;
    options.sample_s = 0.1;
    const RoundSamples samples = bench.interleave(pair, options, [](double) {});
    const Estimate e = ratio(samples, 0, 1, Clock::wall).value();
    return {"", 0, e.median, e.spread, "x"};
}

bool is_method(const Technique& technique) {
    return technique.variant == gpu::ShadingVariant::full && !technique.lit_by_image() &&
           !technique.tabulated() && technique.method != Method::normal_map;
}

}  // namespace

void measure_frames(Report& report) {
    gpu::Context context;
    report.device = context.renderer();
    for (const auto& [triangles, budget] : {std::pair{102400, 1.06}, std::pair{4096, 1.12}}) {
        FrameBench bench(context, {triangles, 1280, 720}, false);
        const std::string size = fmt::format("{} k triangles", triangles / 1000);
        for (const Technique& technique : techniques()) {
            if (!is_method(technique)) continue;
            Row row = compare(bench, technique.name, "normal-map");
            row.work = fmt::format("{} against normal-map, {}", technique.name, size);
            row.budget = budget;
            report.rows.push_back(row);
        }
        for (const char* name : {"tabulated", "tabulated-one"}) {
            Row row = compare(bench, name, "normal-map");
            row.work = fmt::format("{} against normal-map, {}", name, size);
            report.rows.push_back(row);
        }
        Row against_gouraud = compare(bench, "normal-map", "gouraud");
        against_gouraud.work = fmt::format("normal-map against Gouraud, {}", size);
        against_gouraud.budget = triangles > 100000 ? 2.0 : 0.0;
        report.rows.push_back(against_gouraud);
        Row aniso = compare(bench, "aniso", "gouraud");
        aniso.work = fmt::format("anisotropic without normal map against Gouraud, {}", size);
        report.rows.push_back(aniso);
    }
}

}  // namespace burnish::bench
