// Textures with their mips, read by a footprint, as the renderer's samplers do.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "burnish/scene.hpp"
#include "maps/normal/slope_mips.hpp"

namespace burnish {

// What one pixel covers of the texture coordinates of a set: the steps along two sides of it, in units of the
// coordinates. Zeros: the finest level.
struct TextureFootprint {
    glm::vec2 a{0.0f}, b{0.0f};
};

// Texels that are not finite count as 0, in a normal map as flat.
enum class PyramidForm { plain, normal, slopes };

// Threads: immutable. Lifetime: refers to the texture's texels.
class TexturePyramid {
  public:
    // `slopes`: the slopes of a normal map and their variances (maps/normal/slope_mips.hpp).
    TexturePyramid(const Texture& texture, PyramidForm form);

    // Linear values at the coordinates `uv` of the mesh: between texels and levels, or the nearest of both where the
    // texture asks for it. Levels are finer than the footprint by kFinerLevels.
    glm::vec4 at(const TextureUse& use, glm::vec2 uv, const TextureFootprint& footprint) const;
    int channels() const { return texture_->channels; }

  private:
    struct Level {
        int width = 0, height = 0;
        std::vector<float> values;  // channels a texel; empty: the texture itself
    };
    void add_levels();
    glm::vec4 texel(std::size_t level, int x, int y, const TextureUse& use) const;
    glm::vec4 at_level(std::size_t level, glm::vec2 place, const TextureUse& use) const;
    glm::ivec2 size_of(std::size_t level) const;
    std::size_t level_count() const {
        return form_ == PyramidForm::slopes ? slopes_.size() : levels_.size();
    }

    const Texture* texture_;
    PyramidForm form_;
    std::vector<Level> levels_;       // of plain and normal
    std::vector<SlopeLevel> slopes_;  // of slopes
};

// As the renderer's at 16 samples and more: many samples within a pixel average what finer levels show.
inline constexpr float kFinerLevels = 2.0f;

}  // namespace burnish
