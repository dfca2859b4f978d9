// What a material is at a point of its tile, for the bake of its maps.
#pragma once

#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "burnish/image.hpp"
#include "burnish/scene.hpp"

namespace burnish {

struct MaterialPoint {
    glm::vec4 base_color{1.0f};  // linear, alpha
    float metallic = 0.0f;
    float occlusion = 1.0f;
    glm::vec3 emissive{0.0f};
    glm::vec2 alpha{1.0f};            // along `direction` and across it
    glm::vec2 direction{1.0f, 0.0f};  // unit, against tangent and bitangent
    glm::vec2 slope{0.0f};            // (n.x/n.z, n.y/n.z) of the perturbed normal
};

struct MaterialPoints {
    // Of a point of the tile, both coordinates in [0, 1], v running down. Thread-safe.
    std::function<MaterialPoint(glm::vec2)> at;
    glm::mat3 tile{1.0f};    // from texture coordinates to the tile
    glm::vec2 detail{1.0f};  // points across the tile that show all of its detail
    bool has_alpha = false;
    bool has_emission = false;
};

// The material and the textures must outlive what is returned.
MaterialPoints points_of_textures(const Material& material, std::span<const Texture> textures);
MaterialPoints points_of_cloth(const Material& material, std::span<const Texture> textures);
MaterialPoints points_of_table(const Material& material, std::span<const Texture> textures);

// Whether the material has any texture that its kind of lobe reads.
bool has_textures(const Material& material);

// Whole repeats of the draft that a tile of it shows: at least 16 yarns a side.
glm::ivec2 cloth_repeats(const Draft& draft);

}  // namespace burnish
