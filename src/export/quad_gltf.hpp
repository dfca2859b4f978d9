// A flat quad with one textured material as glTF.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace burnish {

struct SampleQuad {
    std::string name;
    double width_mm = 0.0, height_mm = 0.0;
    // Left out, whoever reads the glTF makes them of the transformed texture coordinates: where the
    // transform rotates or mirrors.
    bool tangents = true;
};

struct QuadMaterial {
    nlohmann::ordered_json json;          // an element of glTF's "materials"
    std::vector<std::string> images;      // files beside the glTF, by the index of the texture
    std::vector<std::string> extensions;  // of the material
    bool repeats = false;                 // the textures repeat; else they end at their edges
};

// The quad lies in z = 0 about the origin, in meters, its x and y those of the sample, its texture
// upright; tangents along x, bitangents along y. Vertices and indices are those of quad_bytes, in
// the file `buffer` beside the glTF.
std::string quad_gltf(const SampleQuad& quad, const QuadMaterial& material,
                      const std::string& buffer);
std::vector<std::byte> quad_bytes(const SampleQuad& quad);

}  // namespace burnish
