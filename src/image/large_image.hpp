// Images on large pages (core/large_pages.hpp).
#pragma once

#include "burnish/image.hpp"

namespace burnish {

// Image(width, height, channels), black.
Image image_on_large_pages(int width, int height, int channels);

}  // namespace burnish
