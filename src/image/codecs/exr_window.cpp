#include "image/codecs/exr_window.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

namespace burnish {

void fit_to_display_window(Texture& texture, const PixelWindow& data, const PixelWindow& display) {
    if (data == display) return;
    const auto rows = static_cast<std::size_t>(data.height);
    const std::size_t row_bytes = texture.texels.size() / rows;
    const std::size_t texel = row_bytes / static_cast<std::size_t>(data.width);
    std::vector<std::byte> fitted(static_cast<std::size_t>(display.width) *
                                  static_cast<std::size_t>(display.height) * texel);
    const int left = std::max(data.x, display.x);
    const int right = std::min(data.x + data.width, display.x + display.width);
    const int top = std::max(data.y, display.y);
    const int bottom = std::min(data.y + data.height, display.y + display.height);
    for (int y = top; left < right && y < bottom; ++y) {
        const std::size_t from = static_cast<std::size_t>(y - data.y) * row_bytes +
                                 static_cast<std::size_t>(left - data.x) * texel;
        const std::size_t to =
            (static_cast<std::size_t>(y - display.y) * static_cast<std::size_t>(display.width) +
             static_cast<std::size_t>(left - display.x)) *
            texel;
        std::memcpy(fitted.data() + to, texture.texels.data() + from,
                    static_cast<std::size_t>(right - left) * texel);
    }
    texture.width = display.width;
    texture.height = display.height;
    texture.texels = std::move(fitted);
}

}  // namespace burnish
