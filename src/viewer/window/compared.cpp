#include "viewer/window/compared.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "burnish/compare.hpp"

namespace burnish::viewer {
namespace {

void upload(unsigned& texture, const Image& colors) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(colors.width) *
                                    static_cast<std::size_t>(colors.height) * 3);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(
            std::lround(std::clamp(colors.pixels[i], 0.0f, 1.0f) * 255.0f));
    if (texture == 0) glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, colors.width, colors.height, 0, GL_RGB,
                 GL_UNSIGNED_BYTE, bytes.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glBindTexture(GL_TEXTURE_2D, 0);
}

// Blue where `b` is darker than `a`, orange where it is brighter, black where they agree: the pair
// that every common kind of color vision tells apart.
Image signed_difference(const Image& a, const Image& b, double gain, double& mean, double& most) {
    Image colors(a.width, a.height, 3);
    double sum = 0;
    most = 0;
    for (std::size_t i = 0; i < colors.pixels.size(); i += 3) {
        const double d = (static_cast<double>(b.pixels[i] - a.pixels[i]) +
                          static_cast<double>(b.pixels[i + 1] - a.pixels[i + 1]) +
                          static_cast<double>(b.pixels[i + 2] - a.pixels[i + 2])) /
                         3.0;
        sum += std::abs(d);
        most = std::max(most, std::abs(d));
        const auto v = static_cast<float>(std::min(std::abs(d) * gain, 1.0));
        colors.pixels[i] = d > 0 ? v : 0.15f * v;
        colors.pixels[i + 1] = d > 0 ? 0.6f * v : 0.45f * v;
        colors.pixels[i + 2] = d > 0 ? 0.1f * v : v;
    }
    mean = sum / static_cast<double>(colors.pixels.size() / 3);
    return colors;
}

}  // namespace

Compared::~Compared() {
    if (texture_ != 0) glDeleteTextures(1, &texture_);
}

void Compared::update(const Picture& of_a, std::size_t pane_a, const Picture& of_b,
                      std::size_t pane_b, const Compare& compare) {
    if (of_a.texture(pane_a) == 0 || of_b.texture(pane_b) == 0) return;
    const bool rest = of_a.at_rest() && of_b.at_rest();
    const bool flip = compare.mode == CompareMode::flip;
    if (!rest) made_of_.reset();  // another picture may come to rest with as many samples
    if (flip && !rest) return;
    const Source now{compare.mode, of_a.samples() + of_b.samples(), of_b.scale(), compare.gain};
    if (rest && made_of_ == now) return;
    const Image a = of_a.shown(pane_a), b = of_b.shown(pane_b);
    if (a.width != b.width || a.height != b.height) return;
    if (flip) {
        const Image error = flip_error(a, b);
        mean_ = mean_of(error);
        most_ = static_cast<double>(*std::ranges::max_element(error.pixels));
        upload(texture_, flip_colors(error));
    } else {
        upload(texture_, signed_difference(a, b, compare.gain, mean_, most_));
    }
    made_of_ = now;
}

}  // namespace burnish::viewer
