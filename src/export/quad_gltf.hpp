// The flat quad of a sample with four textures as glTF. Private to capture_export.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace burnish {

struct SampleQuad {
    std::string name;
    double width_mm = 0.0, height_mm = 0.0;
    bool masked = false;  // base_color.png has alpha: 0 outside the mask
};

// The quad lies in z = 0 about the origin, in meters, its x and y those of the sample, its texture
// upright; tangents along x, bitangents along y. Vertices and indices are those of quad_bytes, in
// the file `buffer`. Textures in the same folder: base_color.png, metallic_roughness.png,
// normal.png, anisotropy.png.
std::string quad_gltf(const SampleQuad& quad, const std::string& buffer);
std::vector<std::byte> quad_bytes(const SampleQuad& quad);

}  // namespace burnish
