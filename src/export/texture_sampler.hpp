// Texels of a texture between its texels, on the CPU, as a renderer reads its finest level.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "burnish/image.hpp"
#include "burnish/scene.hpp"

namespace burnish {

class TextureSampler {
  public:
    // Reads 1 everywhere where `use` names no texture. The textures must outlive the sampler.
    TextureSampler(const TextureUse& use, std::span<const Texture> textures);

    explicit operator bool() const { return texture_ != nullptr; }
    const Texture* texture() const { return texture_; }

    // Red, green, blue and alpha, linear, at a texture coordinate of the mesh: bilinear, or the
    // nearest texel where the texture asks for it. One channel is gray, two are gray and alpha.
    glm::vec4 at(glm::vec2 uv) const;

  private:
    glm::vec4 texel(int x, int y) const;

    const Texture* texture_ = nullptr;
    TextureUse use_;
};

}  // namespace burnish
