// Images in memory. `Image` is what is computed with (float, linear Rec. 709, row 0 at the top);
// `Texture` is what a file holds, kept at its own depth so that large maps stay small.
//
// Threads and lifetime: plain values; copies are independent, and any number of threads may read
// one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace burnish {

struct Image {
    int width = 0;
    int height = 0;
    int channels = 0;           // 1 grey, 3 RGB, 4 RGBA (alpha not premultiplied)
    std::vector<float> pixels;  // height x width x channels, row 0 at the top

    Image() = default;
    Image(int width_, int height_, int channels_, float value = 0.0f)
        : width(width_),
          height(height_),
          channels(channels_),
          pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) *
                     static_cast<std::size_t>(channels_),
                 value) {}

    bool empty() const { return pixels.empty(); }
    float* at(int x, int y) { return pixels.data() + offset(x, y); }
    const float* at(int x, int y) const { return pixels.data() + offset(x, y); }

  private:
    std::size_t offset(int x, int y) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(channels);
    }
};

enum class TexelType { u8, u16, f32 };
enum class ColorSpace { linear, srgb };  // how the stored numbers are to be read

// One material texture as stored: base colour and emission are sRGB, everything else linear.
struct Texture {
    std::string name;  // file or "model.glb: image 3", for messages
    int width = 0;
    int height = 0;
    int channels = 0;  // 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA (alpha not premultiplied)
    TexelType type = TexelType::u8;
    ColorSpace color_space = ColorSpace::linear;
    std::vector<std::byte> texels;  // tightly packed, row 0 at the top

    bool empty() const { return texels.empty(); }
};

}  // namespace burnish
