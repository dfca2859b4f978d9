#include "gpu/draw/shadow_maps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <utility>

#include "gpu/device/draw_state.hpp"
#include "gpu/device/texture_units.hpp"
#include "gpu/upload/area_lights.hpp"

namespace burnish::gpu {
namespace {

// Texels of all maps. 128 MB of 32-bit depths at most: side 2048 for up to 8 maps, 1024 for up to
// 24.
constexpr std::size_t kMostTexels = std::size_t{1} << 25;
// Half angle in radians. A wider spot is rendered into six faces, because one plane cannot cover
// nearly 90 degrees.
constexpr float kWidestSpot = 1.3f;

// A point has no extent to project.
constexpr float kLeastRadius = 1e-6f;

struct Axis {
    glm::vec3 forward, up;
};

// The faces in the order of lights.glsl.
constexpr std::array<Axis, 6> kFaces = {{{{1, 0, 0}, {0, 1, 0}},
                                         {{-1, 0, 0}, {0, 1, 0}},
                                         {{0, 1, 0}, {0, 0, 1}},
                                         {{0, -1, 0}, {0, 0, 1}},
                                         {{0, 0, 1}, {0, 1, 0}},
                                         {{0, 0, -1}, {0, 1, 0}}}};

glm::vec3 up_for(const glm::vec3& forward) {
    return std::abs(forward.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
}

bool usable(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

int largest_side(std::size_t maps) {
    int side = 2048;
    while (static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * maps > kMostTexels) {
        side /= 2;
    }
    return side;
}

}  // namespace

ShadowMaps::ShadowMaps(std::span<const Light> lights, const Bounds& bounds) : bounds_(bounds) {
    for (const Light& light : lights) has_area(light) ? add_area_light(light) : add_light(light);
    current_.resize(maps_.size(), glm::mat4(1.0f));
    drawn_.resize(maps_.size());
    if (maps_.empty()) return;
    side_ = largest_side(maps_.size());
    for (Map& map : maps_) map.texel /= static_cast<float>(side_);
}

void ShadowMaps::add_area_light(const Light& light) {
    const float radius = std::max(bounds_.radius(), kLeastRadius);
    const float extent = 0.5f * glm::length(light.size);
    const float distance = glm::length(light.position - bounds_.center()) - extent;
    // Every point of it sees the whole scene within the widest angle of one plane.
    const bool one = distance * std::sin(kWidestSpot) > radius;
    const auto needed = static_cast<std::size_t>(one ? 1 : 6);
    const int number = static_cast<int>(area_lights_.size());
    area_lights_.push_back(light);
    area_points_.push_back(light.position);
    if (maps_.size() + needed > kMostShadowMaps || !usable(light.position)) {
        of_area_light_.emplace_back(-1.0f, 0.0f);
        return;
    }
    of_area_light_.emplace_back(static_cast<float>(maps_.size()), static_cast<float>(needed));
    // Of the six: 90 degrees. Of the one: the cone around the scene from the nearest point.
    const float sine = one ? radius / distance : 0.0f;
    const float side = one ? 2.0f * sine / std::sqrt(1.0f - sine * sine) : 2.0f;
    for (int face = 0; face < static_cast<int>(needed); ++face)
        maps_.push_back({glm::mat4(1.0f), side, number, one ? -1 : face});
}

glm::mat4 ShadowMaps::clip_of_area(const Map& map, const glm::vec3& point) const {
    const float radius = std::max(bounds_.radius(), kLeastRadius);
    const glm::vec3 to_center = bounds_.center() - point;
    const float distance = glm::length(to_center);
    const float far_plane = distance + 1.01f * radius;
    const float near_plane = std::max(distance - 1.01f * radius, far_plane / 500.0f);
    if (map.face >= 0) {
        const Axis& face = kFaces[static_cast<std::size_t>(map.face)];
        return glm::perspective(1.5707963f, 1.0f, near_plane * 0.57f, far_plane) *
               glm::lookAt(point, point + face.forward, face.up);
    }
    const float half = std::asin(std::min(radius / distance, std::sin(kWidestSpot))) * 1.01f;
    return glm::perspective(2.0f * half, 1.0f, near_plane, far_plane) *
           glm::lookAt(point, bounds_.center(), up_for(to_center / distance));
}

void ShadowMaps::add_light(const Light& light) {
    const float radius = std::max(bounds_.radius(), kLeastRadius);
    const glm::vec3 center = bounds_.center();
    const float travel_length = glm::length(light.direction);
    const glm::vec3 travel = travel_length > 0.0f && std::isfinite(travel_length)
                                 ? light.direction / travel_length
                                 : glm::vec3(0, 0, -1);
    const bool directional = light.type == LightType::directional;
    const bool one =
        directional || (light.type == LightType::spot && light.outer_cone < kWidestSpot);
    const auto needed = static_cast<std::size_t>(one ? 1 : 6);
    if (maps_.size() + needed > kMostShadowMaps || !usable(light.position)) {
        of_light_.emplace_back(-1.0f, 0.0f);
        return;
    }
    of_light_.emplace_back(static_cast<float>(maps_.size()), static_cast<float>(needed));
    if (directional) {
        const glm::mat4 view = glm::lookAt(center - 2.0f * radius * travel, center, up_for(travel));
        const glm::mat4 clip =
            glm::ortho(-radius, radius, -radius, radius, 0.9f * radius, 3.1f * radius);
        maps_.push_back({clip * view, 2.0f * radius, -1, -1});
        return;
    }
    const float distance = glm::length(light.position - center);
    const float far_plane = distance + 1.01f * radius;
    // Outside the scene nothing is nearer than its bounding sphere. Inside, 1/500 of the far
    // distance keeps 15 bits of depth.
    const float near_plane = std::max(distance - 1.01f * radius, far_plane / 500.0f);
    if (one) {
        const float half = std::max(light.outer_cone, 0.01f) * 1.02f;
        maps_.push_back({glm::perspective(2.0f * half, 1.0f, near_plane, far_plane) *
                             glm::lookAt(light.position, light.position + travel, up_for(travel)),
                         2.0f * std::tan(half), -1, -1});
        return;
    }
    // Adjacent faces meet at 45 degrees to their axes (1/sqrt(3) in the corners), so the near
    // planes of the cube are nearer.
    const glm::mat4 clip = glm::perspective(1.5707963f, 1.0f, near_plane * 0.57f, far_plane);
    for (const Axis& face : kFaces) {
        maps_.push_back({clip * glm::lookAt(light.position, light.position + face.forward, face.up),
                         2.0f, -1, -1});
    }
}

void ShadowMaps::take_device(ShadowMaps& before) {
    device_ = std::move(before.device_);
    before.device_.reset();
}

bool ShadowMaps::has_images() const {
    return device_ && device_->side == side_ && device_->layers == count();
}

void ShadowMaps::make_images() {
    if (!device_) device_ = Device{};
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glBindTexture(GL_TEXTURE_2D_ARRAY, device_->texture.get());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, side_, side_, count(), 0,
                 GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    const GLuint sampler = device_->sampler.get();
    for (const GLenum name :
         std::initializer_list<GLenum>{GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
        glSamplerParameteri(sampler, name, GL_LINEAR);
    }
    for (const GLenum name : std::initializer_list<GLenum>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
        glSamplerParameteri(sampler, name, GL_CLAMP_TO_EDGE);
    }
    glSamplerParameteri(sampler, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glSamplerParameteri(sampler, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    check_gl("making shadow maps");
    device_->side = side_;
    device_->layers = count();
}

void ShadowMaps::set_casters(std::vector<bool> casters, bool coarse) {
    if (casters == casters_ && coarse == coarse_) return;
    casters_ = std::move(casters);
    coarse_ = coarse;
    invalidate();
}

void ShadowMaps::invalidate() {
    std::ranges::fill(drawn_, std::nullopt);
}

bool ShadowMaps::holds(int index, glm::dvec2 offset) const {
    return has_images() && drawn_[static_cast<std::size_t>(index)] == offset;
}

glm::mat4 ShadowMaps::begin(int index, glm::dvec2 offset) {
    if (!has_images()) make_images();
    const auto i = static_cast<std::size_t>(index);
    const glm::dvec2 shift = offset * (2.0 / side_);
    glm::mat4 moved(1.0f);
    moved[3] = glm::vec4(static_cast<float>(shift.x), static_cast<float>(shift.y), 0.0f, 1.0f);
    if (const int light = maps_[i].area; light >= 0) {
        const auto number = static_cast<std::size_t>(light);
        area_points_[number] = area_point(area_lights_[number], offset, bounds_.center());
        current_[i] = moved * clip_of_area(maps_[i], area_points_[number]);
    } else {
        current_[i] = moved * maps_[i].clip_from_world;
    }
    drawn_[i] = offset;
    glBindFramebuffer(GL_FRAMEBUFFER, device_->target.get());
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, device_->texture.get(), 0,
                              index);
    const GLenum none = GL_NONE;
    glDrawBuffers(1, &none);
    glReadBuffer(GL_NONE);
    glViewport(0, 0, side_, side_);
    apply(DrawState{.depth_offset = true});
    const float deepest = 1.0f;
    glClearBufferfv(GL_DEPTH, 0, &deepest);
    // The slope factor covers a surface's slope over the 1.5 texels that the filter of the look-up
    // reaches.
    glPolygonOffset(2.0f, 4.0f);
    return current_[i];
}

void ShadowMaps::bind(Program& program) const {
    program.set("u_shadow_maps", static_cast<int>(kShadowUnit));
    if (maps_.empty() || !has_images()) return;
    glActiveTexture(GL_TEXTURE0 + kShadowUnit);
    glBindTexture(GL_TEXTURE_2D_ARRAY, device_->texture.get());
    glBindSampler(kShadowUnit, device_->sampler.get());
    std::vector<float> texels;
    for (const Map& map : maps_) texels.push_back(map.texel);
    program.set("u_shadow_clip", std::span<const glm::mat4>(current_));
    program.set("u_shadow_texel", std::span<const float>(texels));
    program.set("u_shadow_of_light", std::span<const glm::vec2>(of_light_));
    if (area_lights_.empty()) return;
    program.set("u_area_shadow", std::span<const glm::vec2>(of_area_light_));
    program.set("u_area_point", std::span<const glm::vec3>(area_points_));
}

}  // namespace burnish::gpu
