// Pictures in memory, as glTF files carry them: our walk over the container, then the library's
// decoder.
#include <cstddef>
#include <span>

#include "burnish/image_io.hpp"
#include "harness.hpp"
#include "scene_check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = std::as_bytes(std::span(data, size));
    burnish::fuzz::expect_answer([&] {
        burnish::Scene scene;
        scene.textures.push_back(
            burnish::decode_texture(bytes, "picture", burnish::ColorSpace::srgb));
        burnish::fuzz::expect_sound(scene);
    });
    return 0;
}
