// Compares pictures on a turntable with a reference: the same pictures drawn so large that no
// detail is lost, box filtered. Luminance is the green channel.
#pragma once

#include <cmath>
#include <cstddef>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "burnish/image.hpp"
#include "burnish/scene.hpp"

namespace burnish::test {

inline Image reduced(const Image& image, int factor) {
    Image small(image.width / factor, image.height / factor, 1);
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            double sum = 0;
            for (int i = 0; i < factor * factor; ++i)
                sum += static_cast<double>(
                    image.at(x * factor + i % factor, y * factor + i / factor)[1]);
            *small.at(x, y) = static_cast<float>(sum / factor / factor);
        }
    }
    return small;
}

inline double mean(const Image& image) {
    double sum = 0;
    for (const float v : image.pixels) sum += static_cast<double>(v);
    return sum / static_cast<double>(image.pixels.size());
}

// Flicker of a pixel: the rms second difference over three frames, divided by the mean of the
// pictures. `draw` returns the picture of a scene, of one channel; the scene rotates by 1 degree a
// frame.
template <typename Draw>
double flicker_on_turntable(Scene& scene, Draw draw) {
    constexpr std::size_t kFrames = 9;
    std::vector<Image> frames;
    for (std::size_t i = 0; i < kFrames; ++i) {
        const float angle = glm::radians(static_cast<float>(i));
        scene.instances[0].transform =
            glm::rotate(glm::mat4(1.0f), angle, glm::vec3(0.0f, 1.0f, 0.0f));
        frames.push_back(draw(scene));
    }
    double sum = 0, level = 0;
    for (std::size_t i = 1; i + 1 < kFrames; ++i) {
        level += mean(frames[i]) / (kFrames - 2);
        for (std::size_t p = 0; p < frames[i].pixels.size(); ++p) {
            const double d = static_cast<double>(frames[i - 1].pixels[p]) -
                             2 * static_cast<double>(frames[i].pixels[p]) +
                             static_cast<double>(frames[i + 1].pixels[p]);
            sum += d * d / (static_cast<double>(frames[i].pixels.size()) * (kFrames - 2));
        }
    }
    return std::sqrt(sum) / level;
}

}  // namespace burnish::test
