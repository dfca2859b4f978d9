// Ratio of the frame times under a rectangle light and under a point light: the bench's torus of brushed steel with a
// bump map, no shadows, one sample per pixel.
#include "frame_subject.hpp"

namespace burnish::bench {

namespace {

Light light_of(LightType type) {
    Light light;
    light.type = type;
    light.position = {1.0f, 1.5f, 1.8f};
    light.direction = {-0.40f, -0.60f, -0.69f};
    light.size = {1.0f, 0.5f};
    light.intensity = 5.0f;
    light.visible = false;
    return light;
}

Scene torus_under(LightType type) {
    Scene scene = torus_with(102400, {{"mdf", "ggx"},
                                      {"alpha_x", "0.1"},
                                      {"alpha_y", "0.4"},
                                      {"metal", "steel"},
                                      {"normal_map", "builtin:bumps"}});
    scene.lights = {light_of(type)};
    return scene;
}

}  // namespace

void measure_area_lights(Report& report) {
    gpu::Context context;
    report.device = context.renderer();
    FrameSubject rectangle(context, torus_under(LightType::rectangle));
    FrameSubject point(context, torus_under(LightType::point));
    report.rows.push_back(
        ratio_of(rectangle, point, "a rectangle light against a point light, 1280x720", 1.6));
}

}  // namespace burnish::bench
