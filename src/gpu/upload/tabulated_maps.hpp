// A tabulated material on the device: the pictures of scene/material/tabulated_images.hpp.
#pragma once

#include <memory>
#include <optional>

#include "burnish/tabulated_material.hpp"
#include "gpu/device/handles.hpp"
#include "gpu/device/program.hpp"

namespace burnish::gpu {

class TabulatedMaps {
  public:
    // Throws Error when a picture is larger than the device's textures.
    explicit TabulatedMaps(std::shared_ptr<const TabulatedMaterial> material);

    // Makes the picture that sampling an environment reads, if it is missing.
    void require_draws();
    // Binds all existing pictures and sets the uniforms of shaders/lib/tabulated.glsl.
    void bind(Program& program) const;

    const std::shared_ptr<const TabulatedMaterial>& material() const { return material_; }

  private:
    std::shared_ptr<const TabulatedMaterial> material_;
    int columns_ = 1, area_rows_ = 0;
    GlTexture tables_, areas_, texels_, colors_;
    std::optional<GlTexture> draws_;
};

}  // namespace burnish::gpu
