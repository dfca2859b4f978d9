// Ratio of the frame times of procedural cloth and a textured normal map: the same torus, lobe and
// method, one light, one sample per pixel.
#include <fmt/format.h>

#include "frame_subject.hpp"

namespace burnish::bench {

namespace {

// Distances from close (a pixel shows a point of a yarn) to far (a pixel shows the mean of many
// yarns). The camera stays, so that all frames cover equally many pixels.
struct Distance {
    const char* name;
    const char* yarns;
};
constexpr Distance kDistances[] = {
    {"close, points of yarns", "24"}, {"yarns of about two pixels", "320"}, {"far, means", "6000"}};

Scene make_scene(int triangles, const Values& detail) {
    Values values = {{"mdf", "ggx"},
                     {"alpha_x", "0.2"},
                     {"alpha_y", "0.45"},
                     {"metallic", "0"},
                     {"method", "follow-grain"}};
    values.insert(values.end(), detail.begin(), detail.end());
    Scene scene = torus_with(triangles, values);
    scene.lights = {lamp_from_above()};
    return scene;
}

}  // namespace

void measure_cloth(Report& report) {
    gpu::Context context;
    report.device = context.renderer();
    for (const int triangles : {102400, 4096}) {
        FrameSubject map(context, make_scene(triangles, {{"normal_map", "builtin:bumps"}}));
        for (const Distance& distance : kDistances) {
            FrameSubject cloth(context, make_scene(triangles, {{"weave", "twill-2-2"},
                                                               {"weave_yarns", distance.yarns}}));
            report.rows.push_back(
                ratio_of(cloth, map,
                         fmt::format("cloth against a normal map, {} k triangles: {}",
                                     triangles / 1000, distance.name),
                         1.5));
        }
    }
}

}  // namespace burnish::bench
