// Pictures in memory, as glTF files carry them: our walk over the container, then the library's
// decoder.
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "burnish/image_io.hpp"
#include "harness.hpp"
#include "scene_check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = std::as_bytes(std::span(data, size));
    burnish::fuzz::expect_answer([&] {
        burnish::Scene scene;
        std::vector<std::string> warnings;
        scene.textures.push_back(
            burnish::decode_texture(bytes, "picture", burnish::ColorSpace::srgb, &warnings));
        for (const std::string& line : warnings)
            if (line.empty() || line.find_first_of("\r\n") != line.npos)
                burnish::fuzz::broken("a warning of no or several lines");
        burnish::fuzz::expect_sound(scene);
    });
    return 0;
}
