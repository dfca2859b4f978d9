// Texels of a texture between its texels, on the CPU, as a renderer reads its finest level.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "burnish/image.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// The texel that stands at any whole number on a row of `size`.
int wrapped_texel(int i, int size, Wrap wrap);

// Red, green, blue and alpha of a texel of the texture, linear. One channel is gray, two are gray and alpha.
glm::vec4 linear_texel(const Texture& texture, int column, int row);

class TextureSampler {
  public:
    // Reads 1 everywhere where `use` names no texture. The textures must outlive the sampler.
    TextureSampler(const TextureUse& use, std::span<const Texture> textures);

    explicit operator bool() const { return texture_ != nullptr; }
    const Texture* texture() const { return texture_; }

    // As linear_texel, at a texture coordinate of the mesh: bilinear, or the nearest texel where the
    // texture asks for it.
    glm::vec4 at(glm::vec2 uv) const;

  private:
    glm::vec4 texel(int x, int y) const;

    const Texture* texture_ = nullptr;
    TextureUse use_;
};

}  // namespace burnish
