// An environment on the device: a cube map of radiance with all its mips, one of irradiance and, on
// request, one of radiance blurred by lobes.
#pragma once

#include <optional>

#include "burnish/context.hpp"
#include "gpu/device/handles.hpp"
#include "gpu/device/program.hpp"
#include "gpu/upload/lobe_map.hpp"
#include "scene/light/prepared_environment.hpp"

namespace burnish::gpu {

class EnvironmentMaps {
  public:
    EnvironmentMaps(const Context& context, const PreparedEnvironment& prepared);

    // Makes the lobe map if it is missing. Changes framebuffer, viewport and raster state.
    void require_lobes(ProgramCache& programs, GLuint empty_vertex_array);
    bool has_lobes() const { return lobes_.has_value(); }
    // Binds all to their units and sets the uniforms of shaders/lib/environment.glsl.
    void bind(Program& program, float intensity, float rotation) const;
    // For the background, after bind(): what is seen behind the scene in place of the radiance, and back.
    void bind_backdrop() const;
    void bind_radiance() const;
    float backdrop_last_lod() const { return backdrop_last_lod_; }

  private:
    GlTexture radiance_;
    GlTexture irradiance_;
    std::optional<GlTexture> backdrop_;
    std::optional<LobeMap> lobes_;
    Sampler sampler_;
    float scale_ = 1.0f;  // stored values times this are radiance
    float face_ = 1.0f;
    float last_lod_ = 0.0f, backdrop_last_lod_ = 0.0f;
};

}  // namespace burnish::gpu
