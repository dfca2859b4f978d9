// Functions that tests of glTF files share: write, load, inspect.
#pragma once

#include <string>
#include <string_view>

#include "formats/gltf/gltf.hpp"
#include "support/glb_writer.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {

inline Scene load_bytes(const GlbWriter& writer) {
    const TemporaryFolder folder;
    return load_gltf(folder.write("model.glb", writer.glb()));
}

inline std::string error_of(const GlbWriter& writer) {
    return error_line([&] { load_bytes(writer); });
}

inline bool warns(const Scene& scene, std::string_view text) {
    for (const std::string& line : scene.warnings)
        if (line.find(text) != std::string::npos) return true;
    return false;
}

inline GlbWriter writer_of(const GlbPrimitive& primitive) {
    GlbWriter writer;
    writer.add_node(writer.add_mesh(primitive));
    return writer;
}

// One square with the given material; texture 0 is a small picture.
inline GlbWriter square_with(const nlohmann::json& material) {
    GlbWriter writer;
    writer.add_png(png_gradient(4, 2));
    GlbPrimitive square = unit_square(1, true);
    square.material = writer.add_material(material);
    writer.add_node(writer.add_mesh(square));
    return writer;
}

}  // namespace burnish::test
