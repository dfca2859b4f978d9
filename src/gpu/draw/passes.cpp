#include "gpu/draw/passes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "gpu/device/albedo_tables.hpp"
#include "gpu/device/draw_state.hpp"
#include "gpu/device/texture_units.hpp"
#include "gpu/draw/material_state.hpp"

namespace burnish::gpu {
namespace {

// Offset of the mip level. Sub-pixel samples may read finer mips, because their average covers the
// pixel: at 4 samples those of half the pixel's side. At least -2: finer mips show nothing more
// beyond 16 samples.
float lod_bias(int samples) {
    return std::max(-0.5f * std::log2(static_cast<float>(std::max(samples, 1))), -2.0f);
}

}  // namespace

bool is_robust(const RenderSettings& settings) {
    return settings.robust_limit > 0.0f && settings.view == SurfaceView::radiance;
}

Painter::Painter(Context& context, DeviceScene& scene)
    : context_(context), scene_(scene), timer_(context, kPassCount) {
    glGetIntegerv(GL_MAX_DRAW_BUFFERS, &draw_buffers_);
}

// The points of shaders/lib/image_light.glsl.
void Painter::set_lattice(Program& program, int samples) {
    if (samples != lattice_samples_) {
        lattice_ = point_lattice(samples);
        lattice_samples_ = samples;
    }
    const double step = 4294967296.0 / samples;
    program.set("u_lattice_x", static_cast<unsigned>(samples > 1 ? step : 0.0));
    program.set(
        "u_lattice_y",
        static_cast<unsigned>(samples > 1 ? step * static_cast<double>(lattice_.generator) : 0.0));
    program.set("u_lattice_cell", glm::vec4(lattice_.edge[0].x, lattice_.edge[0].y,
                                            lattice_.edge[1].x, lattice_.edge[1].y));
}

void Painter::set_frame(Program& program, const Frame& frame) {
    if (!program.take(UniformGroup::frame, needs_.frame)) return;
    const RenderSettings& o = *frame.options;
    program.set("u_clip_from_world", frame.view.clip_from_world);
    program.set("u_eye", frame.view.eye);
    program.set("u_ray_center", frame.view.ray_center);
    program.set("u_ray_x", frame.view.ray_x);
    program.set("u_ray_y", frame.view.ray_y);
    program.set("u_tile_origin", glm::ivec2(frame.tile.x, frame.tile.y));
    program.set("u_image_samples", o.image_light_samples);
    program.set("u_frame", static_cast<unsigned>(frame.sample));
    // With so many samples, one covers no more than a texel of the sharpest mip.
    constexpr float kSharp = 1e12f;
    program.set("u_total_samples", o.filter_image_samples
                                       ? static_cast<float>(o.image_light_samples) *
                                             static_cast<float>(std::max(o.samples, 1))
                                       : kSharp);
    set_lattice(program, o.image_light_samples);
    program.set("u_seed", o.seed);
    program.set("u_view", static_cast<int>(o.view));
    scene_.lights().set(program);
    scene_.area_lights().set(program);
    program.set("u_area_frame", static_cast<unsigned>(frame.sample));
    program.set("u_area_seed", o.seed + 2u);  // other points than those of the image light
    if (needs_.shadows) scene_.shadows().bind(program);
    if (const EnvironmentMaps* environment = scene_.environment()) {
        environment->bind(program, o.environment_intensity, o.environment_rotation);
    }
}

// Binds textures when the last draw had another material, and sets uniforms when the program holds
// those of another version.
void Painter::set_surface(Program& program, const Frame& frame, int material) {
    const MaterialSlot& slot = slot_of(frame, material);
    const Material& m = slot.material;
    const RenderSettings& o = *frame.options;
    set_frame(program, frame);
    const bool bound = std::exchange(bound_material_, material) == material;
    if (!bound) bind_textures(m, scene_.textures());
    if (!bound && o.view == SurfaceView::moments && wants_slopes(m))
        scene_.textures().bind(kSlopeCovarianceUnit, m.normal_texture,
                               TextureForm::slope_covariance);
    // Versions stay below 2^32: a million edits a second for over an hour.
    const bool set = program.take(UniformGroup::material, slot.version + (needs_.settings << 32));
    if (set) set_material(program, m, scene_.textures(), lod_bias(o.samples));
    if (bound && !set) return;
    if (slot.cloth && frame.variant == ShadingVariant::full) {
        slot.cloth->bind(program, m);
        program.set("u_weave_filter", o.filter_cloth ? 1.0f : 0.0f);
    }
    if (slot.tabulated) {
        slot.tabulated->bind(program);
        program.set("u_tabulated_part",
                    1.0f / std::sqrt(static_cast<float>(std::max(o.samples, 1))));
        return;
    }
    if (!reads_albedos(o, m)) return;
    context_.albedos().bind(m.brdf, m.mdf);
    program.set("u_albedo", static_cast<int>(kAlbedoUnit));
}

void Painter::draw_fullscreen(Program& program, float depth) {
    program.set("u_depth", depth);
    glBindVertexArray(empty_.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

// Masked surfaces cast the shadow of all their triangles, blended ones none.
void Painter::draw_casters(const glm::mat4& clip_from_world, bool coarse) {
    Program& program = plain_program("surface.vert", "shadow.frag", true);
    program.use();
    program.set("u_clip_from_world", clip_from_world);
    for (const DrawItem& item : scene_.items()) {
        if (scene_.material(item.material).blended()) continue;
        program.set("u_world_from_local", item.world_from_local);
        scene_.mesh(item.mesh).draw(coarse);
    }
}

void Painter::draw_shadows(const Frame& frame) {
    ShadowMaps& shadows = scene_.shadows();
    std::vector<bool> casters;
    casters.reserve(scene_.items().size());
    for (const DrawItem& item : scene_.items())
        casters.push_back(!scene_.material(item.material).blended());
    const bool coarse = frame.options->coarse;
    shadows.set_casters(std::move(casters), coarse);
    const auto time = timed(Pass::shadow_maps);
    for (int map = 0; map < shadows.count(); ++map)
        if (!shadows.holds(map, frame.offset))
            draw_casters(shadows.begin(map, frame.offset), coarse);
}

void Painter::clear(const Frame& frame, Targets& targets) {
    const auto time = timed(Pass::shading);
    targets.bind_frame();
    glViewport(0, 0, frame.tile.width, frame.tile.height);
    apply(DrawState{});
    const bool transparent = frame.options->background == BackgroundKind::transparent;
    const glm::vec4 color =
        transparent ? glm::vec4(0.0f) : glm::vec4(frame.options->background_color, 1.0f);
    glClearBufferfv(GL_COLOR, 0, &color.x);
    glClearBufferfi(GL_DEPTH_STENCIL, 0, 1.0f, 0);
}

void Painter::paint(const Frame& frame, Targets& targets) {
    needs_ = needs_of(frame);
    bound_material_ = -1;
    if (needs_.shadows) draw_shadows(frame);
    std::vector<std::size_t> forward(scene_.items().size());
    std::iota(forward.begin(), forward.end(), std::size_t{0});
    clear(frame, targets);
    if (needs_.defers) paint_deferred(frame, targets, forward);
    paint_forward(frame, forward);
    if (shows_emitters(frame)) paint_emitters(frame);
    if (shows_environment(frame)) paint_background(frame);
    if (needs_.ground) {
        const auto time = timed(Pass::ground);
        scene_.ground().paint(context_.programs(), empty_.get(), ground_lights(),
                              frame.view.clip_from_world,
                              frame.options->background == BackgroundKind::transparent);
    }
    if (frame.variant != ShadingVariant::gouraud) paint_blended(frame);
}

// The items of these numbers that are not blended, shaded as they are rasterized.
void Painter::paint_forward(const Frame& frame, const std::vector<std::size_t>& items) {
    const auto time = timed(Pass::shading);
    apply(DrawState{});
    for (const std::size_t i : items) {
        const DrawItem& item = scene_.items()[i];
        if (frame.variant == ShadingVariant::gouraud) {
            paint_gouraud(frame, item);
        } else if (!scene_.material(item.material).blended()) {
            paint_item(frame, item);
        }
    }
}

// Draws the surfaces into the images of gbuffer.frag, then shades each material. The stencil holds
// the material's number, and a full-screen triangle at the far plane passes where a surface is
// nearer.
void Painter::paint_deferred(const Frame& frame, Targets& targets,
                             std::vector<std::size_t>& forward) {
    std::map<int, Bounds> seen;  // by material
    {
        const auto time = timed(Pass::surface_data);
        targets.bind_gbuffer(needs_.position, needs_.shape, needs_.visibility);
        std::erase_if(forward, [&](std::size_t i) {
            const DrawItem& item = scene_.items()[i];
            if (!can_defer(frame, item) || is_stood_in(frame, item)) return false;
            apply(DrawState{.stencil = Stencil{true, item.material + 1}});
            write_gbuffer(frame, item);
            Bounds& box = seen.try_emplace(item.material, item.bounds).first->second;
            box = {glm::min(box.low, item.bounds.low), glm::max(box.high, item.bounds.high)};
            return true;
        });
    }
    const auto time = timed(Pass::shading);
    targets.bind_frame();
    for (const auto& [material, box] : seen) {
        const Tile part = screen_bounds(frame.view, box, frame.tile);
        DrawState state{.depth_write = false, .depth_function = GL_GREATER};
        if (seen.size() > 1) state.stencil = Stencil{false, material + 1};
        state.scissor = Rectangle{part.x, part.y, part.width, part.height};
        resolve_material(frame, targets, material, state);
    }
}

void Painter::write_gbuffer(const Frame& frame, const DrawItem& item) {
    const MaterialSlot& slot = scene_.material(item.material);
    Program& program = gbuffer_program(slot, true);
    program.use();
    program.set("u_clip_from_world", frame.view.clip_from_world);
    set_shared_uv(program, slot.material);
    draw_item(program, item, frame.options->coarse);
}

void Painter::resolve_material(const Frame& frame, Targets& targets, int material,
                               const DrawState& state) {
    MaterialSlot& slot = slot_of(frame, material);
    Program& program = surface_program(slot, variant_of(frame, slot, false), true, true);
    program.use();
    set_surface(program, frame, material);
    targets.bind_gbuffer_textures(program);
    apply(state);
    draw_fullscreen(program, 1.0f);
}

// Sets the transform of an item and draws it.
void Painter::draw_item(Program& program, const DrawItem& item, bool coarse) {
    program.set("u_world_from_local", item.world_from_local);
    program.set("u_normal_from_local", item.normal_from_local);
    program.set("u_mirror", item.mirrored ? -1.0f : 1.0f);
    apply_culling(!scene_.material(item.material).material.double_sided, item.mirrored);
    scene_.draw(item, coarse, needs_.visibility);
}

void Painter::paint_item(const Frame& frame, const DrawItem& item) {
    if (is_stood_in(frame, item)) {
        paint_stand_in(frame, item);
        return;
    }
    MaterialSlot& slot = slot_of(frame, item.material);
    const SurfaceVariant variant = variant_of(frame, slot, scene_.mesh(item.mesh).has_color());
    Program& program = surface_program(slot, variant, false, true);
    program.use();
    set_surface(program, frame, item.material);
    draw_item(program, item, frame.options->coarse);
}

void Painter::paint_stand_in(const Frame& frame, const DrawItem& item) {
    Program& program = stand_in_program(frame, true);
    program.use();
    set_frame(program, frame);
    set_material(program, scene_.material(item.material).material, scene_.textures(), 0.0f);
    draw_item(program, item, frame.options->coarse);
}

void Painter::paint_gouraud(const Frame& frame, const DrawItem& item) {
    Program& program = gouraud_program(true);
    program.use();
    set_frame(program, frame);
    set_material(program, scene_.material(item.material).material, scene_.textures(), 0.0f);
    draw_item(program, item, frame.options->coarse);
}

// Lights with an area, from the sides that emit. A tube is the rectangle that shows the eye its outline.
void Painter::paint_emitters(const Frame& frame) {
    const auto time = timed(Pass::background);
    Program& program = emitter_program(true);
    program.use();
    program.set("u_clip_from_world", frame.view.clip_from_world);
    const AreaLightUniforms& uniforms = scene_.area_lights();
    uniforms.bind_textures(program);
    apply(DrawState{});
    for (int i = 0; i < uniforms.count(); ++i) {
        const Light& light = uniforms.lights()[static_cast<std::size_t>(i)];
        if (!light.visible) continue;
        const Emitter emitter = emitter_seen(light, frame.view.eye);
        if (!emitter.lit) continue;
        program.set("u_emitter_middle", light.position);
        program.set("u_emitter_x", emitter.axes.x);
        program.set("u_emitter_y", emitter.axes.y);
        program.set("u_emitter_radiance", glm::vec3(uniforms.radiance(i)));
        program.set("u_emitter_round", light.type == LightType::disc ? 1.0f : 0.0f);
        program.set("u_emitter_layer", uniforms.layer(i));
        glBindVertexArray(empty_.get());
        glDrawArrays(GL_TRIANGLES, 0, 6);
        glBindVertexArray(0);
    }
}

void Painter::paint_background(const Frame& frame) {
    const auto time = timed(Pass::background);
    Program& program = plain_program("fullscreen.vert", "background.frag", true);
    program.use();
    set_frame(program, frame);
    program.set("u_background_lod",
                std::clamp(frame.options->background_blur, 0.0f, 1.0f) *
                    std::max(scene_.environment()->backdrop_last_lod() - 1.0f, 0.0f));
    apply(DrawState{.depth_write = false});
    scene_.environment()->bind_backdrop();
    draw_fullscreen(program, 1.0f);
    scene_.environment()->bind_radiance();
}

void Painter::paint_blended(const Frame& frame) {
    std::vector<std::pair<float, std::size_t>> order;
    for (std::size_t i = 0; i < scene_.items().size(); ++i) {
        const DrawItem& item = scene_.items()[i];
        if (!scene_.material(item.material).blended()) continue;
        const glm::vec4 clip = frame.view.clip_from_world * glm::vec4(item.bounds.center(), 1.0f);
        // In orthographic views w = 1 and z holds the depth; z grows with depth in both kinds of
        // view.
        order.emplace_back(-(frame.view.eye.w > 0.0f ? clip.w : clip.z), i);
    }
    if (order.empty()) return;
    const auto time = timed(Pass::blended);
    std::ranges::stable_sort(order, {}, &std::pair<float, std::size_t>::first);
    apply(DrawState{.depth_write = false, .blend = Blend::premultiplied});
    for (const auto& [depth, index] : order) paint_item(frame, scene_.items()[index]);
}

void Painter::accumulate(const Frame& frame, Targets& targets) {
    const auto time = timed(Pass::sum);
    const RenderSettings& o = *frame.options;
    Program& program = plain_program("fullscreen.vert", accumulation_of(o), true);
    program.use();
    program.set("u_limit", o.robust_limit);
    program.set("u_transparent", o.background == BackgroundKind::transparent ? 1.0f : 0.0f);
    targets.accumulate(program, empty_.get());
}

}  // namespace burnish::gpu
