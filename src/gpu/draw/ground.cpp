#include "gpu/draw/ground.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "burnish/error.hpp"
#include "gpu/device/draw_state.hpp"
#include "gpu/device/texture_units.hpp"
#include "scene/camera/pixel_offsets.hpp"
#include "scene/camera/view.hpp"

namespace burnish::gpu {
namespace {

constexpr int kSide = 1024;
// Number of drawings that sample the sky's light. With 256, one step of a shadow is 1/256 of the
// sky's irradiance, a step of an 8-bit display. Fewer for large models, so that all drawings take a
// few seconds in software.
constexpr std::size_t kMostSkyLights = 256, kFewestSkyLights = 64;
constexpr std::size_t kTriangles = 25'000'000;  // in all drawings together

int sky_light_count(std::size_t triangles) {
    return static_cast<int>(std::clamp(kTriangles / std::max<std::size_t>(triangles, 1),
                                       kFewestSkyLights, kMostSkyLights));
}

// Drawings per lamp, shifted within a texel: the anti-aliasing of its shadow's edge.
constexpr int kLampDraws = 16;
// Points of a light with an area: of a long one, neighbors lie an eighth of its length apart. Few: for a coarse
// shadow.
constexpr int kAreaPoints = 64, kFewAreaPoints = 5;
// Number of the sky's lights for a coarse shadow: the shadow of a frame in motion.
constexpr int kFewSkyLights = 6;
// Half the square's side is half the model's diagonal and kHeights of its heights, room for long
// shadows.
constexpr float kHeights = 1.5f;

glm::vec3 turned(const glm::vec3& d, float rotation) {
    const float c = std::cos(rotation), s = std::sin(rotation);
    // The inverse of environment_direction() in shaders/lib/environment.glsl.
    return {c * d.x + s * d.z, d.y, c * d.z - s * d.x};
}

float largest(const glm::vec3& v) {
    return std::max({v.x, v.y, v.z});
}

void define(GLuint texture, GLint internal, GLenum layout, GLenum type) {
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, internal, kSide, kSide, 0, layout, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void draw_fullscreen(GLuint empty_vertex_array, GLsizei vertices) {
    glBindVertexArray(empty_vertex_array);
    glDrawArrays(GL_TRIANGLES, 0, vertices);
    glBindVertexArray(0);
}

// The part of the square that the box's shadow can reach, one texel larger for the sub-texel shift.
Tile reach_of(const Bounds& box, const glm::mat4& clip_from_world) {
    constexpr float kMiddle = 0.5f * static_cast<float>(kSide);
    glm::vec2 low(kSide), high(0.0f);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 p((corner & 1) != 0 ? box.high.x : box.low.x,
                          (corner & 2) != 0 ? box.high.y : box.low.y,
                          (corner & 4) != 0 ? box.high.z : box.low.z);
        const glm::vec4 clip = clip_from_world * glm::vec4(p, 1.0f);
        // A corner no nearer to the plane than the lamp has an infinite shadow.
        if (!(clip.w > 0.0f)) return {0, 0, kSide, kSide};
        const glm::vec2 place = kMiddle + kMiddle * glm::vec2(clip) / clip.w;
        low = glm::min(low, place - 2.0f);
        high = glm::max(high, place + 2.0f);
    }
    const glm::ivec2 first(glm::clamp(low, 0.0f, static_cast<float>(kSide)));
    const glm::ivec2 last(glm::clamp(high, 0.0f, static_cast<float>(kSide)));
    return {first.x, first.y, std::max(last.x - first.x, 0), std::max(last.y - first.y, 0)};
}

// One program for all numbers of lights: drawing takes moments, compiling a program does not.
std::string light_defines(const GroundLights& lights) {
    if (lights.points.count() + lights.areas.count() == 0)
        return "#define LIGHTS 0\n#define POSITION\n";
    std::string defines = "#define LIGHTS " + std::to_string(kMostLights) +
                          "\n#define LIGHT_COUNT_AT_RUN_TIME\n#define POSITION\n";
    if (lights.areas.count() > 0)
        defines += "#define AREA_LIGHTS " + std::to_string(kMostAreaLights) + "\n";
    return defines;
}

}  // namespace

glm::mat4 flattened(const glm::vec4& light, float height) {
    // (P.L) p - L (P.p) with the plane P = (0, 1, 0, -height).
    const float above = light.y - height * light.w;
    glm::mat4 m(above);
    m[1] -= light;
    m[3] += height * light;
    return m;
}

Ground::Ground(const Bounds& model, std::size_t triangles,
               std::shared_ptr<const Environment> environment)
    : model_(model), triangles_(triangles), environment_(std::move(environment)) {
    const glm::vec3 size = model.high - model.low;
    center_ = glm::vec3(model.center().x, model.low.y, model.center().z);
    // 1e-6: a point has no extent.
    half_ = std::max(0.5f * std::hypot(size.x, size.z) + kHeights * size.y, 1e-6f);
}

void Ground::find_sky_lights() {
    if (environment_ == nullptr) return;
    sky_lights_ = sky_lights(*environment_, sky_light_count(triangles_));
    few_sky_lights_ = sky_lights(*environment_, kFewSkyLights);
    for (const SkyLight& light : sky_lights_) sky_irradiance_ += light.irradiance;
    environment_.reset();
}

Bounds Ground::bounds() const {
    const glm::vec3 reach(half_, 0.0f, half_);
    return {center_ - reach, center_ + reach};
}

bool Ground::faces(const glm::vec4& eye) const {
    return eye.y > center_.y * eye.w;
}

Ground::Shadow::Shadow() {
    define(mask.get(), GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
    // Half floats, which every device filters and blends into; `scale` keeps values near 1.
    define(blocked.get(), GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT);
    for (const GLenum name :
         std::initializer_list<GLenum>{GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glSamplerParameteri(sampler.get(), name, GL_LINEAR);
    for (const GLenum name : std::initializer_list<GLenum>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glSamplerParameteri(sampler.get(), name, GL_CLAMP_TO_EDGE);
    glBindFramebuffer(GL_FRAMEBUFFER, mask_target.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, mask.get(), 0);
    const GLenum none = GL_NONE;
    glDrawBuffers(1, &none);
    glReadBuffer(GL_NONE);
    glBindFramebuffer(GL_FRAMEBUFFER, blocked_target.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, blocked.get(), 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error("render", "ground", "a device that renders to half floats", "none");
    check_gl("making the ground's shadow");
}

struct Ground::Tools {
    ProgramCache& programs;
    GLuint empty_vertex_array;
    const GroundLights& lights;
    const DrawCasters& draw_casters;
};

void Ground::set_place(Program& program, const GroundLights& lights, float scale) const {
    lights.points.set(program);
    lights.areas.set(program);
    program.set("u_ground_center", center_);
    program.set("u_ground_half", half_);
    program.set("u_ground_scale", scale);
}

bool Ground::is_made_for(const Sky& sky) const {
    if (!made_ || (made_->sky.coarse && !sky.coarse)) return false;
    Sky made = made_->sky;
    made.coarse = sky.coarse;
    return made == sky;
}

void Ground::require_programs(ProgramCache& programs, const GroundLights& lights) {
    programs.get("fullscreen.vert", "ground_add.frag", light_defines(lights));
    programs.get("ground.vert", "ground.frag", light_defines(lights));
}

void Ground::require(ProgramCache& programs, GLuint empty_vertex_array, const GroundLights& lights,
                     const Sky& sky, const DrawCasters& draw_casters, const Progress& progress) {
    if (is_made_for(sky)) return;
    constexpr std::string_view kStage = "shadow on the ground";
    progress.step(kStage, 0.0);
    find_sky_lights();
    auto shadow = std::make_unique<Shadow>();
    shadow->sky = sky;
    glm::vec3 brightest = sky_irradiance_ * sky.intensity;
    for (int i = 0; i < lights.points.count(); ++i)
        brightest += lights.points.irradiance(i, center_);
    // No light with an area gives more than its radiance from everywhere.
    for (int i = 0; i < lights.areas.count(); ++i)
        brightest += glm::vec3(lights.areas.radiance(i)) * std::numbers::pi_v<float>;
    shadow->scale = largest(brightest) > 0.0f ? 1.0f / largest(brightest) : 1.0f;
    glBindFramebuffer(GL_FRAMEBUFFER, shadow->blocked_target.get());
    apply(DrawState{});
    const float nothing[4] = {};
    glClearBufferfv(GL_COLOR, 0, nothing);
    glViewport(0, 0, kSide, kSide);
    const Tools tools{programs, empty_vertex_array, lights, draw_casters};
    for (int i = 0; i < lights.points.count(); ++i) {
        progress.step(kStage, 0.0);
        add(tools, *shadow,
            {.place = lights.points.place(i), .light = i, .draws = sky.coarse ? 1 : kLampDraws});
    }
    progress.step(kStage, 0.0);
    add_areas(tools, *shadow);
    if (sky.intensity > 0.0f) {
        const std::vector<SkyLight>& all = sky.coarse ? few_sky_lights_ : sky_lights_;
        for (std::size_t i = 0; i < all.size(); ++i) {
            // Progress at every fourth light: cancellation is prompt, and the device rarely waits.
            if (i % 4 == 0) {
                glFinish();
                progress.step(kStage, static_cast<double>(i) / static_cast<double>(all.size()));
            }
            const SkyLight& light = all[i];
            add(tools, *shadow,
                {.place = glm::vec4(turned(light.direction, sky.rotation), 0.0f),
                 .sky = light.irradiance * sky.intensity});
        }
    }
    check_gl("drawing the ground's shadow");
    made_ = std::move(shadow);
}

void Ground::add_areas(const Tools& tools, Shadow& shadow) const {
    const int points = shadow.sky.coarse ? kFewAreaPoints : kAreaPoints;
    for (int i = 0; i < tools.lights.areas.count(); ++i) {
        const Light& light = tools.lights.areas.lights()[static_cast<std::size_t>(i)];
        for (const glm::dvec2 offset : pixel_offsets(points))
            add(tools, shadow,
                {.place = glm::vec4(area_point(light, offset, model_.center()), 1.0f),
                 .area = i,
                 .share = 1.0f / static_cast<float>(points)});
    }
}

void Ground::add(const Tools& tools, Shadow& shadow, const Blocked& light) const {
    const glm::vec4& place = light.place;
    // Below the plane, which is dark with or without the model.
    if (!(place.y > center_.y * place.w)) return;
    // Seen from above: x to the right, z down. The plane has depth 0, the background 1.
    const float r = 1.0f / half_;
    glm::mat4 square(0.0f);
    square[0].x = r;
    square[2].y = r;
    square[3] = glm::vec4(-center_.x * r, -center_.z * r, 0.0f, 1.0f);
    const glm::mat4 flat = square * flattened(place, center_.y);
    Program& program =
        tools.programs.get("fullscreen.vert", "ground_add.frag", light_defines(tools.lights));
    const Tile reach = reach_of(model_, flat);
    const Rectangle part{reach.x, reach.y, reach.width, reach.height};
    for (const glm::dvec2 texels : pixel_offsets(light.draws)) {
        glm::mat4 shift(1.0f);
        const glm::dvec2 offset = texels * (2.0 / kSide);
        shift[3] = glm::vec4(static_cast<float>(offset.x), static_cast<float>(offset.y), 0, 1);
        glBindFramebuffer(GL_FRAMEBUFFER, shadow.mask_target.get());
        apply(DrawState{.scissor = part});
        const float deepest = 1.0f;
        glClearBufferfv(GL_DEPTH, 0, &deepest);
        tools.draw_casters(shift * flat);
        glBindFramebuffer(GL_FRAMEBUFFER, shadow.blocked_target.get());
        apply(DrawState{.depth_test = false, .blend = Blend::add, .scissor = part});
        program.use();
        set_place(program, tools.lights, shadow.scale);
        program.set("u_depth", 0.0f);
        program.set("u_light", light.light);
        program.set("u_area", light.area);
        program.set("u_sky", light.sky);
        program.set("u_share", light.share / static_cast<float>(light.draws));
        program.set("u_mask", static_cast<int>(kScratchUnit));
        glActiveTexture(GL_TEXTURE0 + kScratchUnit);
        glBindTexture(GL_TEXTURE_2D, shadow.mask.get());
        glBindSampler(kScratchUnit, 0);
        draw_fullscreen(tools.empty_vertex_array, 3);
        glBindTexture(GL_TEXTURE_2D, 0);
    }
}

void Ground::paint(ProgramCache& programs, GLuint empty_vertex_array, const GroundLights& lights,
                   const glm::mat4& clip_from_world, bool transparent) const {
    Program& program = programs.get("ground.vert", "ground.frag", light_defines(lights));
    program.use();
    set_place(program, lights, made_->scale);
    program.set("u_clip_from_world", clip_from_world);
    program.set("u_sky", sky_irradiance_ * made_->sky.intensity);
    program.set("u_transparent", transparent ? 1.0f : 0.0f);
    program.set("u_blocked", static_cast<int>(kScratchUnit));
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glBindTexture(GL_TEXTURE_2D, made_->blocked.get());
    glBindSampler(kScratchUnit, made_->sampler.get());
    // Over a background, multiply by the fraction of light left. Without one, blend black with the
    // coverage of the missing light.
    apply(DrawState{.depth_write = false,
                    .blend = transparent ? Blend::premultiplied : Blend::multiply});
    draw_fullscreen(empty_vertex_array, 6);
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindSampler(kScratchUnit, 0);
}

}  // namespace burnish::gpu
