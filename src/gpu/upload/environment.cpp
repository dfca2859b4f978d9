#include "gpu/upload/environment.hpp"

#include <cmath>

#include "gpu/device/draw_state.hpp"
#include "gpu/device/texture_units.hpp"

namespace burnish::gpu {
namespace {

void upload_level(const HalfCube& cube, int level) {
    for (int face = 0; face < 6; ++face) {
        glTexImage2D(static_cast<GLenum>(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), level, GL_RGBA16F,
                     cube.size, cube.size, 0, GL_RGBA, GL_HALF_FLOAT, cube.face(face));
    }
}

void upload_levels(GLuint texture, const std::vector<HalfCube>& cubes) {
    glBindTexture(GL_TEXTURE_CUBE_MAP, texture);
    int level = 0;
    for (const HalfCube& cube : cubes) upload_level(cube, level++);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, level - 1);
}

}  // namespace

EnvironmentMaps::EnvironmentMaps(const Context& context, const PreparedEnvironment& prepared)
    : scale_(prepared.scale),
      face_(static_cast<float>(prepared.radiance.front().size)),
      last_lod_(static_cast<float>(prepared.radiance.size() - 1)),
      backdrop_last_lod_(last_lod_) {
    if (!context.is_es()) glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);  // ES: always on
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    upload_levels(radiance_.get(), prepared.radiance);
    if (!prepared.backdrop.empty()) {
        upload_levels(backdrop_.emplace().get(), prepared.backdrop);
        backdrop_last_lod_ = static_cast<float>(prepared.backdrop.size() - 1);
    }

    glBindTexture(GL_TEXTURE_CUBE_MAP, irradiance_.get());
    upload_level(prepared.irradiance, 0);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, 0);
    glBindTexture(GL_TEXTURE_CUBE_MAP, 0);

    glSamplerParameteri(sampler_.get(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glSamplerParameteri(sampler_.get(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    check_gl("uploading the environment");
}

void EnvironmentMaps::require_lobes(ProgramCache& programs, GLuint empty_vertex_array) {
    if (lobes_) return;
    Program& program = programs.get("fullscreen.vert", "prefilter.frag", "");
    program.use();
    bind(program, 1.0f, 0.0f);
    program.set("u_depth", 0.0f);
    apply(DrawState{.depth_test = false, .depth_write = false});
    lobes_.emplace(program, static_cast<int>(face_), empty_vertex_array);
}

void EnvironmentMaps::bind(Program& program, float intensity, float rotation) const {
    bind_radiance();
    glBindSampler(kEnvironmentUnit, sampler_.get());
    glActiveTexture(GL_TEXTURE0 + kIrradianceUnit);
    glBindTexture(GL_TEXTURE_CUBE_MAP, irradiance_.get());
    glBindSampler(kIrradianceUnit, sampler_.get());
    if (lobes_) {
        glActiveTexture(GL_TEXTURE0 + kLobeUnit);
        glBindTexture(GL_TEXTURE_CUBE_MAP, lobes_->texture());
        glBindSampler(kLobeUnit, sampler_.get());
        program.set("u_lobe_log2_alpha", std::log2(lobes_->first_alpha()));
    }
    program.set("u_lobes", static_cast<int>(kLobeUnit));
    program.set("u_environment", static_cast<int>(kEnvironmentUnit));
    program.set("u_irradiance", static_cast<int>(kIrradianceUnit));
    program.set("u_environment_turn", glm::vec2(std::cos(rotation), std::sin(rotation)));
    program.set("u_environment_scale", scale_ * intensity);
    program.set("u_environment_face", face_);
    program.set("u_environment_last_lod", last_lod_);
}

void EnvironmentMaps::bind_backdrop() const {
    if (!backdrop_) return;
    glActiveTexture(GL_TEXTURE0 + kEnvironmentUnit);
    glBindTexture(GL_TEXTURE_CUBE_MAP, backdrop_->get());
}

void EnvironmentMaps::bind_radiance() const {
    glActiveTexture(GL_TEXTURE0 + kEnvironmentUnit);
    glBindTexture(GL_TEXTURE_CUBE_MAP, radiance_.get());
}

}  // namespace burnish::gpu
