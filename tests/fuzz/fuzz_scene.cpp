// Scene files. What they may ask for and takes its time (large built-in meshes, a scratch map of
// 2048 texels a side) is left out: it is bounded, not cheap.
#include <string_view>

#include "burnish/layered_materials.hpp"
#include "burnish/scene_file.hpp"
#include "harness.hpp"
#include "scene_check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    for (const std::string_view costly :
         {"triangles", "brushed", "fine-random", "deep-gouges", "swirl-marks", "tool-marks",
          ":bumps", ":sphere", ":cylinder", ":torus", ":drape"})
        if (text.find(costly) != std::string_view::npos) return -1;
    const auto path = burnish::fuzz::put("scene.json", burnish::fuzz::Bytes(data, size));
    burnish::is_scene_file(path);
    burnish::fuzz::expect_answer([&] {
        burnish::SceneFile file = burnish::load_scene_file(path);
        burnish::LayeredMaterials materials(file.scene.materials, file.layers);
        materials.apply(file.scene, {});
        burnish::fuzz::expect_sound(file.scene);
    });
    return 0;
}
