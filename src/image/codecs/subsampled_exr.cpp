#include "image/codecs/subsampled_exr.hpp"

#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfRgbaFile.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <vector>

#include "burnish/error.hpp"
#include "image/codecs/exr_window.hpp"
#include "image/guard/format.hpp"

namespace burnish {
namespace {

// OpenEXR's view of bytes in memory.
class MemoryStream final : public Imf::IStream {
  public:
    MemoryStream(std::span<const std::byte> bytes, const std::string& name)
        : IStream(name.c_str()), bytes_(bytes) {}

    bool read(char to[], int count) override {
        const auto size = static_cast<std::uint64_t>(count);
        if (count < 0 || at_ > bytes_.size() || size > bytes_.size() - at_)
            throw Error(fileName(), "", "a readable OpenEXR image", "a file cut short");
        std::memcpy(to, bytes_.data() + at_, size);
        at_ += size;
        return at_ < bytes_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t position) override { at_ = position; }

  private:
    std::span<const std::byte> bytes_;
    std::uint64_t at_ = 0;
};

// Color divided by alpha; where alpha is 0 the color stays (it may be emission).
void write_texel(const Imf::Rgba& from, int channels, float* to) {
    const float alpha = channels == 4 ? static_cast<float>(from.a) : 1.0f;
    const float scale = alpha > 0.0f ? 1.0f / alpha : 1.0f;
    const float color[] = {from.r, from.g, from.b};
    for (int c = 0; c < 3; ++c) to[c] = scale * color[c];
    if (channels == 4) to[3] = alpha;
}

PixelWindow window_of(const Imath::Box2i& box) {
    return {box.min.x, box.min.y, box.max.x - box.min.x + 1, box.max.y - box.min.y + 1};
}

Texture decode(std::span<const std::byte> bytes, const std::string& name) {
    MemoryStream stream(bytes, name);
    Imf::RgbaInputFile file(stream, 0);
    const Imath::Box2i window = file.dataWindow();
    Texture texture;
    texture.name = name;
    texture.width = window.max.x - window.min.x + 1;
    texture.height = window.max.y - window.min.y + 1;
    texture.channels = (file.channels() & Imf::WRITE_A) != 0 ? 4 : 3;
    texture.type = TexelType::f32;
    texture.color_space = ColorSpace::linear;
    check_image_size(texture.width, texture.height, name);
    const auto width = static_cast<std::size_t>(texture.width);
    const auto height = static_cast<std::size_t>(texture.height);
    const auto channels = static_cast<std::size_t>(texture.channels);
    check_decoded_bytes(width * height * channels * sizeof(float), bytes.size(), name);
    const PixelWindow display = window_of(file.displayWindow());
    check_decoded_bytes(static_cast<std::uint64_t>(display.width) *
                            static_cast<std::uint64_t>(display.height) * channels * sizeof(float),
                        bytes.size(), name);

    std::vector<Imf::Rgba> pixels(width * height);
    // The frame buffer's origin is the pixel (0, 0), which may lie outside the window.
    const std::ptrdiff_t origin =
        -window.min.x - static_cast<std::ptrdiff_t>(window.min.y) * texture.width;
    file.setFrameBuffer(pixels.data() + origin, 1, width);
    file.readPixels(window.min.y, window.max.y);

    std::vector<float> texels(width * height * channels);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        write_texel(pixels[i], texture.channels, texels.data() + i * channels);
    texture.texels.resize(texels.size() * sizeof(float));
    std::memcpy(texture.texels.data(), texels.data(), texture.texels.size());
    fit_to_display_window(texture, window_of(window), display);
    return texture;
}

}  // namespace

Texture decode_subsampled_exr(std::span<const std::byte> bytes, const std::string& name) {
    try {
        return decode(bytes, name);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw Error(name, "", "a readable OpenEXR image of luminance and chroma",
                    one_line(error.what()));
    }
}

}  // namespace burnish
