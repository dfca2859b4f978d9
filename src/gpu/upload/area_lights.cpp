#include "gpu/upload/area_lights.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "burnish/error.hpp"
#include "burnish/f32.hpp"
#include "burnish/f64.hpp"
#include "gpu/device/gl.hpp"
#include "gpu/device/texture_units.hpp"
#include "scene/light/area_lights.hpp"

namespace burnish::gpu {
namespace {

// Texels a side of every texture: a light is seen blurred by the lobes of surfaces.
constexpr int kSide = 256;

// Of the tent of half width 1: the share below x, as a place from -1 to 1.
double even_place(double x) {
    const double c = std::clamp(x, -1.0, 1.0);
    return c < 0 ? (1 + c) * (1 + c) - 1 : 1 - (1 - c) * (1 - c);
}

// The place from -1 to 1 at `times` as far around a circle.
double turned_place(double place, int times) {
    const double around = times * (0.5 + 0.5 * place);
    return 2 * (around - std::floor(around)) - 1;
}

// The mean over the part of the picture that a texel covers.
std::vector<float> resampled(const Image& image) {
    std::vector<float> texels;
    texels.reserve(std::size_t{kSide} * kSide * 3);
    const auto part = [](int i, int size) {
        const int first = static_cast<int>(static_cast<long>(i) * size / kSide);
        const int last = static_cast<int>((static_cast<long>(i) + 1) * size / kSide);
        return std::pair{first, std::max(last, first + 1)};
    };
    for (int y = 0; y < kSide; ++y) {
        const auto [top, bottom] = part(y, image.height);
        for (int x = 0; x < kSide; ++x) {
            const auto [left, right] = part(x, image.width);
            glm::vec3 sum(0.0f);
            for (int v = top; v < bottom; ++v) {
                for (int u = left; u < right; ++u) {
                    const float* p = image.at(u, v);
                    sum += image.channels < 3 ? glm::vec3(p[0]) : glm::vec3(p[0], p[1], p[2]);
                }
            }
            sum /= static_cast<float>((bottom - top) * (right - left));
            // The range of the half floats that hold it.
            for (int c = 0; c < 3; ++c) texels.push_back(std::clamp(sum[c], 0.0f, 65504.0f));
        }
    }
    return texels;
}

}  // namespace

glm::vec3 area_point(const Light& light, glm::dvec2 offset, const glm::vec3& seen) {
    AreaAxes axes = area_axes(light);
    // Odd multiples of a full turn: the middle stays, and the place in the light has little to do with that in the
    // pixel, which would make penumbrae narrower by up to a pixel.
    f64::vec2 place(turned_place(even_place(offset.x), 5), turned_place(even_place(offset.y), 7));
    if (light.type == LightType::disc) place = f64::disc_place(place);
    if (light.type == LightType::tube) {
        const glm::vec3 across = glm::cross(seen - light.position, axes.x);
        const float length = glm::length(across);
        if (length > 0.0f) axes.y = across * (glm::length(axes.y) / length);
    }
    return light.position + axes.x * static_cast<float>(place.x) +
           axes.y * static_cast<float>(place.y);
}

Emitter emitter_seen(const Light& light, const glm::vec4& eye) {
    // A parallel view is one from far away.
    constexpr float kFar = 1e4f;
    const glm::vec3 away = eye.w > 0.0f ? glm::vec3(eye) - light.position
                                        : glm::vec3(eye) * (kFar * glm::length(light.size));
    const AreaAxes axes = area_axes(light);
    const int shape = static_cast<int>(light.type) - static_cast<int>(LightType::rectangle);
    const f32::AreaLight seen = f32::area_light_seen(shape, f32::vec3(-away), f32::vec3(axes.x),
                                                     f32::vec3(axes.y), light.two_sided);
    const auto of = [](const f32::vec3& v) { return glm::vec3(v.x, v.y, v.z); };
    return {{of(seen.x), of(seen.y)}, seen.lit > 0.0f};
}

AreaLightUniforms::AreaLightUniforms(std::span<const Light> lights) {
    std::copy_if(lights.begin(), lights.end(), std::back_inserter(lights_), has_area);
    if (lights_.size() > kMostAreaLights)
        throw Error(
            "scene", "lights",
            "at most " + std::to_string(kMostAreaLights) + " with an area (rectangle, disc, tube)",
            std::to_string(lights_.size()));
    for (const Light& light : lights_) {
        const AreaAxes axes = area_axes(light);
        float layer = -1.0f;
        if (light.texture.image && light.type == LightType::rectangle) {
            if (light.texture.image->empty())
                throw Error("scene", "lights", "a texture with pixels", "an empty one");
            const auto found = std::find(textures_.begin(), textures_.end(), light.texture.image);
            layer = static_cast<float>(found - textures_.begin());
            if (found == textures_.end()) textures_.push_back(light.texture.image);
        }
        const int shape = static_cast<int>(light.type) - static_cast<int>(LightType::rectangle);
        middle_.emplace_back(light.position, static_cast<float>(shape));
        x_.emplace_back(axes.x, light.two_sided ? 1.0f : 0.0f);
        y_.emplace_back(axes.y, layer);
        radiance_.emplace_back(light.color * light.intensity, 0.0f);
    }
}

void AreaLightUniforms::require_textures() {
    if (textures_.empty() || array_) return;
    auto array = std::make_shared<GlTexture>();
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glBindTexture(GL_TEXTURE_2D_ARRAY, array->get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const auto layers = static_cast<GLsizei>(textures_.size());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA16F, kSide, kSide, layers, 0, GL_RGB, GL_FLOAT,
                 nullptr);
    for (GLsizei i = 0; i < layers; ++i) {
        const std::vector<float> texels = resampled(*textures_[static_cast<std::size_t>(i)]);
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, i, kSide, kSide, 1, GL_RGB, GL_FLOAT,
                        texels.data());
    }
    glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    check_gl("uploading textures of lights");
    array_ = std::move(array);
}

void AreaLightUniforms::bind_textures(Program& program) const {
    if (!array_) return;
    glActiveTexture(GL_TEXTURE0 + kAreaTextureUnit);
    glBindTexture(GL_TEXTURE_2D_ARRAY, array_->get());
    glBindSampler(kAreaTextureUnit, 0);
    program.set("u_area_textures", static_cast<int>(kAreaTextureUnit));
}

void AreaLightUniforms::set(Program& program) const {
    if (lights_.empty()) return;
    program.set("u_area_count", count());
    program.set("u_area_middle", std::span<const glm::vec4>(middle_));
    program.set("u_area_x", std::span<const glm::vec4>(x_));
    program.set("u_area_y", std::span<const glm::vec4>(y_));
    program.set("u_area_radiance", std::span<const glm::vec4>(radiance_));
    bind_textures(program);
}

}  // namespace burnish::gpu
