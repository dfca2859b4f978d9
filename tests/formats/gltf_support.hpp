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

}  // namespace burnish::test
