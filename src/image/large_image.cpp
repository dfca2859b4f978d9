#include "image/large_image.hpp"

#include <cstddef>

#include "core/large_pages.hpp"

namespace burnish {

Image image_on_large_pages(int width, int height, int channels) {
    Image image;
    image.width = width;
    image.height = height;
    image.channels = channels;
    image.pixels = zeros_on_large_pages<float>(static_cast<std::size_t>(width) *
                                               static_cast<std::size_t>(height) *
                                               static_cast<std::size_t>(channels));
    return image;
}

}  // namespace burnish
