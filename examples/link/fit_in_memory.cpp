// Photographs a sample that is simulated under a dome of lights, fits a tabulated material to the
// pictures and relights it: everything in memory.
#include <burnish/capture_fit.hpp>
#include <burnish/relight.hpp>
#include <burnish/virtual_sample.hpp>
#include <cmath>
#include <cstdio>
#include <vector>

int main() {
    using namespace burnish;

    VirtualSettings size;
    size.width = size.height = 16;
    const VirtualSample sample = make_virtual_sample("satin", size);
    const Rig rig = make_dome_rig(sample, 100, {});
    std::vector<Image> pictures;
    for (std::size_t light = 0; light < rig.lights.size(); ++light)
        pictures.push_back(virtual_picture(sample, rig, light, {}));

    CaptureFitSettings settings;
    settings.eta = sample.eta;
    settings.models = false;
    const TabulatedMaterial material = fit_capture(rig, pictures, {}, settings);
    std::printf("%d exemplars for %d x %d texels\n", material.exemplars, material.width,
                material.height);

    // One of the lights again, from the material: how far from its picture?
    const Image again = Relighter(material).picture(rig, 37);
    double squares = 0.0, light = 0.0;
    for (std::size_t i = 0; i < again.pixels.size(); ++i) {
        const double difference = again.pixels[i] - pictures[37].pixels[i];
        squares += difference * difference;
        light += static_cast<double>(pictures[37].pixels[i]) * pictures[37].pixels[i];
    }
    const double error = std::sqrt(squares / light);
    std::printf("relative error under light 37: %.4f\n", error);
    return error < 0.05 ? 0 : 1;
}
