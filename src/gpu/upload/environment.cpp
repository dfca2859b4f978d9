#include "gpu/upload/environment.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <string_view>

#include "burnish/error.hpp"
#include "gpu/device/draw_state.hpp"
#include "gpu/device/texture_units.hpp"
#include "scene/light/cube_map.hpp"

namespace burnish::gpu {
namespace {

// Irradiance is smooth but where a sun sets: 32 texels a face hold even that to 2 % of its peak.
constexpr int kIrradianceSize = 32;
// What irradiance is gathered from: finer levels differ by less than their texels' turn, 3 degrees.
constexpr int kIrradianceSource = 32;

void upload_level(const CubeMap& cube, int level, float scale) {
    const auto face_texels =
        static_cast<std::size_t>(cube.size) * static_cast<std::size_t>(cube.size);
    std::vector<std::uint64_t> half(face_texels);
    for (int face = 0; face < 6; ++face) {
        for (std::size_t i = 0; i < face_texels; ++i) {
            const glm::vec3 v =
                cube.texels[static_cast<std::size_t>(face) * face_texels + i] / scale;
            half[i] = glm::packHalf4x16(glm::vec4(v, 1.0f));
        }
        glTexImage2D(static_cast<GLenum>(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), level, GL_RGBA16F,
                     cube.size, cube.size, 0, GL_RGBA, GL_HALF_FLOAT, half.data());
    }
}

float highest(const CubeMap& cube) {
    float high = 0.0f;
    for (const glm::vec3& v : cube.texels) high = std::max({high, v.x, v.y, v.z});
    return high;
}

}  // namespace

EnvironmentMaps::EnvironmentMaps(const Context& context, const Environment& environment,
                                 const Progress& progress) {
    const Image& map = environment.radiance;
    if (map.width < 2 || map.height < 1 || map.channels < 1) {
        throw Error(environment.name, "environment", "a lat-long picture", "an empty one");
    }
    constexpr std::string_view kStage = "environment";
    progress.step(kStage, 0.0);
    const CubeMap base = cube_from_latlong(map, cube_size_for(map.width));
    progress.step(kStage, 0.4);
    const std::vector<CubeMap> mips = cube_mips(base);
    // Half floats end at 65504: a sun beyond that is stored at a fraction.
    scale_ = std::max(1.0f, highest(base) / 60000.0f);
    face_ = static_cast<float>(base.size);
    last_lod_ = static_cast<float>(mips.size());

    const CubeMap* source = &base;
    for (const CubeMap& level : mips) {
        if (source->size > kIrradianceSource) source = &level;
    }
    progress.step(kStage, 0.5);
    const CubeMap irradiance = cube_irradiance(*source, kIrradianceSize);
    progress.step(kStage, 0.8);

    if (!context.is_es()) glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);  // ES: always
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glBindTexture(GL_TEXTURE_CUBE_MAP, radiance_.get());
    upload_level(base, 0, scale_);
    for (std::size_t i = 0; i < mips.size(); ++i) {
        upload_level(mips[i], static_cast<int>(i) + 1, scale_);
    }
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(mips.size()));

    glBindTexture(GL_TEXTURE_CUBE_MAP, irradiance_.get());
    upload_level(irradiance, 0, scale_);
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
    glActiveTexture(GL_TEXTURE0 + kEnvironmentUnit);
    glBindTexture(GL_TEXTURE_CUBE_MAP, radiance_.get());
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

}  // namespace burnish::gpu
