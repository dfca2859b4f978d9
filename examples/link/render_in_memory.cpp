// Builds a scene in memory, changes its material a hundred times and draws each: no file is read.
// Usage: render_in_memory [PICTURE.png], which keeps the last picture.
#include <burnish/builtin_meshes.hpp>
#include <burnish/context.hpp>
#include <burnish/display.hpp>
#include <burnish/image_io.hpp>
#include <burnish/renderer.hpp>
#include <cstdio>

int main(int argc, char** argv) {
    using namespace burnish;

    Scene scene;
    scene.meshes.push_back(make_builtin_mesh("sphere", 2000));
    scene.materials.emplace_back();
    scene.instances.emplace_back();
    Light lamp;
    lamp.direction = {-0.4f, -0.6f, -0.7f};
    lamp.intensity = 3.0f;
    scene.lights.push_back(lamp);
    const Environment white{"white", Image(64, 32, 3, 0.4f)};

    gpu::Context context;  // the first hardware device, else Mesa's software renderer
    gpu::Renderer renderer(context, scene, &white);
    Camera camera;
    camera.position = {0.0f, 0.0f, 5.0f};
    RenderSettings settings;
    settings.width = settings.height = 64;
    settings.samples = 1;
    settings.image_light_samples = 4;

    float darkest = 1e9f, brightest = 0.0f;
    Image picture;
    for (int i = 0; i < 100; ++i) {
        Material material;
        material.base_color = {0.01f * static_cast<float>(i), 0.5f, 0.2f, 1.0f};
        material.lobe = AlphaLobe{{0.1f, 0.1f + 0.005f * static_cast<float>(i)}};
        renderer.update_material(0, material);
        renderer.begin(camera, settings);
        renderer.add_sample();
        picture = renderer.picture();
        const float red = picture.at(32, 32)[0];
        darkest = red < darkest ? red : darkest;
        brightest = red > brightest ? red : brightest;
    }
    std::printf("red of the middle pixel: %.3f to %.3f on %s\n", darkest, brightest,
                context.renderer().c_str());
    if (argc > 1) write_image(argv[1], to_display(picture, 0.0, ToneMap::khronos_neutral), {});
    return darkest < brightest ? 0 : 1;
}
