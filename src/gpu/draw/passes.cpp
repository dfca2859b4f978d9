#include "gpu/draw/passes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "burnish/render_settings.hpp"
#include "gpu/device/texture_units.hpp"

namespace burnish::gpu {
namespace {

// Sub-pixel samples see less of a texture each, so they may read finer mips: half the pixel's side
// at 4 samples. -2: beyond 16 samples nothing more is seen.
float lod_bias(int samples) {
    return std::max(-0.5f * std::log2(static_cast<float>(std::max(samples, 1))), -2.0f);
}

void set_culling(bool cull, bool mirrored) {
    if (cull) {
        glEnable(GL_CULL_FACE);
    } else {
        glDisable(GL_CULL_FACE);
    }
    glFrontFace(mirrored ? GL_CW : GL_CCW);
}

void set_rays(Program& program, const View& view) {
    program.set("u_ray_center", view.ray_center);
    program.set("u_ray_x", view.ray_x);
    program.set("u_ray_y", view.ray_y);
}

// Below this average size of a triangle shading once a pixel is the faster way (measured on
// llvmpipe: renderer.hpp).
constexpr double kPixelsPerTriangle = 40.0;
// Likewise of tabulated materials, whose pixels are dear.
constexpr double kTabulatedPixelsPerTriangle = 400.0;

bool blended(const Material& m) {
    return m.alpha_mode == AlphaMode::blend;
}

std::size_t triangles_of(const Scene& scene, const std::vector<DrawItem>& items) {
    std::size_t indices = 0;
    for (const DrawItem& item : items)
        indices += scene.meshes[static_cast<std::size_t>(item.mesh)].indices.size();
    return indices / 3;
}

}  // namespace

DeviceScene::DeviceScene(Context& context, const Scene& scene, const Environment* light)
    : materials(drawn_materials(scene.materials)),
      items(draw_items(scene)),
      bounds(gpu::bounds_of(items)),
      ground(bounds, triangles_of(scene, items), light),
      textures(context, scene),
      lights(scene.lights),
      shadows(scene.lights, bounds) {
    for (const Mesh& mesh : scene.meshes) meshes.emplace_back(mesh);
    if (light != nullptr && !light->radiance.empty()) environment.emplace(context, *light);
}

Painter::Painter(Context& context, DeviceScene& scene)
    : scene_(scene), programs_(context.is_es() ? ShaderDialect::es300 : ShaderDialect::gl330) {}

bool Painter::shows_environment(const Frame& frame) const {
    return scene_.environment && frame.options->background == BackgroundKind::environment;
}

bool Painter::defers(const Frame& frame) const {
    if (frame.variant == ShadingVariant::gouraud) return false;
    if (frame.options->surface_pass != SurfacePass::automatic) {
        return frame.options->surface_pass == SurfacePass::deferred;
    }
    std::size_t triangles = 0;
    for (const DrawItem& item : scene_.items)
        triangles += scene_.meshes[static_cast<std::size_t>(item.mesh)].triangles();
    const double pixels =
        static_cast<double>(frame.options->width) * static_cast<double>(frame.options->height);
    return static_cast<double>(triangles) *
               (needs_shape() ? kTabulatedPixelsPerTriangle : kPixelsPerTriangle) >
           pixels;
}

bool Painter::can_defer(const Frame& frame, const DrawItem& item) const {
    // 254: the stencil has one number a material.
    const bool color = scene_.meshes[static_cast<std::size_t>(item.mesh)].has_color();
    return item.material < 254 && variant_for(frame, item.material, color).can_resolve();
}

SurfaceVariant Painter::variant_for(const Frame& frame, int material, bool vertex_color) const {
    SurfaceVariant v =
        variant_of(scene_.materials[static_cast<std::size_t>(material)], scene_.textures,
                   vertex_color, frame.variant == ShadingVariant::full);
    v.lights = scene_.lights.count();
    v.position = needs_position(frame);
    v.shadow_maps = casts_shadows(frame) ? scene_.shadows.count() : 0;
    const bool lit = scene_.environment && frame.options->environment_intensity > 0.0f;
    v.image_light = lit ? static_cast<int>(frame.options->image_light) : 0;
    return v;
}

void Painter::set_common(Program& program, const Frame& frame) {
    const RenderSettings& o = *frame.options;
    program.set("u_clip_from_world", frame.view.clip_from_world);
    program.set("u_eye", frame.view.eye);
    program.set("u_tile_origin", glm::ivec2(frame.tile.x, frame.tile.y));
    program.set("u_image_samples", o.image_light_samples);
    program.set("u_frame", static_cast<unsigned>(frame.sample));
    // A sample of so many stands for no more than a texel of the sharpest mip.
    constexpr float kSharp = 1e12f;
    program.set("u_total_samples", o.filter_image_samples
                                       ? static_cast<float>(o.image_light_samples) *
                                             static_cast<float>(std::max(o.samples, 1))
                                       : kSharp);
    program.set("u_seed", o.seed);
    scene_.lights.set(program);
    if (casts_shadows(frame)) scene_.shadows.bind(program);
    if (scene_.environment) {
        scene_.environment->bind(program, o.environment_intensity, o.environment_rotation);
    }
}

void Painter::set_surface(Program& program, const Frame& frame, int material) {
    const Material& m = scene_.materials[static_cast<std::size_t>(material)];
    set_common(program, frame);
    set_material(program, m, scene_.textures, lod_bias(frame.options->samples));
    if (cloth_of(m) && frame.variant == ShadingVariant::full) {
        cloths_.bind(program, material, m);
        program.set("u_weave_filter", frame.options->filter_cloth ? 1.0f : 0.0f);
    }
    if (tabulated_of(m)) {
        const bool sampled =
            scene_.environment && frame.options->image_light == ImageLight::importance;
        tabulated_.bind(program, m, sampled);
        program.set("u_tabulated_part",
                    1.0f / std::sqrt(static_cast<float>(std::max(frame.options->samples, 1))));
        return;
    }
    if (frame.options->image_light != ImageLight::prefiltered || !has_half_vectors(m.brdf)) return;
    albedos_.bind(m.brdf, m.mdf);
    program.set("u_albedo", static_cast<int>(kAlbedoUnit));
}

void Painter::draw_fullscreen(Program& program, float depth) {
    program.set("u_depth", depth);
    glBindVertexArray(empty_.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

bool Painter::casts_shadows(const Frame& frame) const {
    return frame.options->shadows && scene_.shadows.count() > 0 &&
           frame.variant != ShadingVariant::gouraud;
}

bool Painter::needs_position(const Frame& frame) const {
    return scene_.lights.any_positional() || casts_shadows(frame);
}

bool Painter::needs_shape() const {
    return std::any_of(scene_.materials.begin(), scene_.materials.end(),
                       [](const Material& m) { return tabulated_of(m) != nullptr; });
}

// Masked surfaces cast the shadow of all their triangles, blended ones none.
void Painter::draw_casters(const glm::mat4& clip_from_world) {
    Program& program = programs_.get("surface.vert", "shadow.frag", "");
    program.use();
    program.set("u_clip_from_world", clip_from_world);
    set_culling(false, false);
    for (const DrawItem& item : scene_.items) {
        if (blended(scene_.materials[static_cast<std::size_t>(item.material)])) continue;
        program.set("u_world_from_local", item.world_from_local);
        scene_.meshes[static_cast<std::size_t>(item.mesh)].draw();
    }
}

void Painter::draw_shadows(const Frame& frame) {
    for (int map = 0; map < scene_.shadows.count(); ++map)
        draw_casters(scene_.shadows.begin(map, frame.sample));
    scene_.shadows.end();
}

bool Painter::shows_ground(const Frame& frame) const {
    return frame.options->ground && frame.variant != ShadingVariant::gouraud &&
           scene_.ground.faces(frame.view.eye);
}

void Painter::draw_ground_shadow(const Frame& frame) {
    const RenderSettings& o = *frame.options;
    // An environment that is shown but lights nothing casts no shadow either.
    const bool lit = o.image_light != ImageLight::off;
    scene_.ground.require(programs_, empty_.get(), scene_.lights,
                          {lit ? o.environment_intensity : 0.0f, o.environment_rotation},
                          [&](const glm::mat4& clip) { draw_casters(clip); });
}

void Painter::paint_ground(const Frame& frame) {
    scene_.ground.paint(programs_, empty_.get(), scene_.lights, frame.view.clip_from_world,
                        frame.options->background == BackgroundKind::transparent);
}

void Painter::clear(const Frame& frame, Targets& targets) {
    targets.bind_frame();
    glViewport(0, 0, frame.tile.width, frame.tile.height);
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_TRUE);
    glStencilMask(0xFF);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    const bool transparent = frame.options->background == BackgroundKind::transparent;
    const glm::vec4 color =
        transparent ? glm::vec4(0.0f) : glm::vec4(frame.options->background_color, 1.0f);
    glClearBufferfv(GL_COLOR, 0, &color.x);
    glClearBufferfi(GL_DEPTH_STENCIL, 0, 1.0f, 0);
}

void Painter::paint(const Frame& frame, Targets& targets) {
    const ImageLight light = frame.options->image_light;
    if (scene_.environment &&
        (light == ImageLight::prefiltered || light == ImageLight::bent_normal)) {
        scene_.environment->require_lobes(programs_, empty_.get());
    }
    if (casts_shadows(frame)) draw_shadows(frame);
    if (shows_ground(frame)) draw_ground_shadow(frame);
    clear(frame, targets);
    std::vector<std::size_t> forward(scene_.items.size());
    std::iota(forward.begin(), forward.end(), std::size_t{0});
    if (defers(frame)) paint_deferred(frame, targets, forward);
    const bool gouraud = frame.variant == ShadingVariant::gouraud;
    for (const std::size_t i : forward) {
        const DrawItem& item = scene_.items[i];
        if (gouraud) {
            paint_gouraud(frame, item);
        } else if (!blended(scene_.materials[static_cast<std::size_t>(item.material)])) {
            paint_item(frame, item);
        }
    }
    if (shows_environment(frame)) paint_background(frame);
    if (shows_ground(frame)) paint_ground(frame);
    if (!gouraud) paint_blended(frame);
}

// The surfaces into the images of gbuffer.frag, then each material where it is seen: the stencil
// has its number, and a full-screen triangle at the far plane passes where something is nearer.
void Painter::paint_deferred(const Frame& frame, Targets& targets,
                             std::vector<std::size_t>& forward) {
    targets.bind_gbuffer(needs_position(frame), needs_shape());
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    std::map<int, Bounds> seen;  // by material
    std::erase_if(forward, [&](std::size_t i) {
        const DrawItem& item = scene_.items[i];
        if (!can_defer(frame, item)) return false;
        glStencilFunc(GL_ALWAYS, item.material + 1, 0xFF);
        write_gbuffer(frame, item);
        Bounds& box = seen.try_emplace(item.material, item.bounds).first->second;
        box = {glm::min(box.low, item.bounds.low), glm::max(box.high, item.bounds.high)};
        return true;
    });
    targets.bind_frame();
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_GREATER);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    set_culling(false, false);
    if (seen.size() == 1) glDisable(GL_STENCIL_TEST);
    glEnable(GL_SCISSOR_TEST);
    for (const auto& [material, box] : seen) {
        const Tile part = screen_bounds(frame.view, box, frame.tile);
        glScissor(part.x, part.y, part.width, part.height);
        glStencilFunc(GL_EQUAL, material + 1, 0xFF);
        resolve_material(frame, targets, material);
    }
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LEQUAL);
}

void Painter::write_gbuffer(const Frame& frame, const DrawItem& item) {
    const Material& material = scene_.materials[static_cast<std::size_t>(item.material)];
    std::string defines = needs_position(frame) ? "#define POSITION\n" : "";
    if (needs_shape()) defines += "#define SHAPE\n";
    if (material.double_sided) defines += "#define DOUBLE_SIDED\n";
    Program& program = programs_.get("surface.vert", "gbuffer.frag", defines);
    program.use();
    program.set("u_clip_from_world", frame.view.clip_from_world);
    set_shared_uv(program, material);
    place(program, item);
}

void Painter::resolve_material(const Frame& frame, Targets& targets, int material) {
    const SurfaceVariant variant = variant_for(frame, material, false);
    Program& program = programs_.get("fullscreen.vert", "resolve.frag", variant.defines());
    program.use();
    set_surface(program, frame, material);
    set_rays(program, frame.view);
    targets.bind_gbuffer_textures(program);
    draw_fullscreen(program, 1.0f);
}

// Sets where an item is and draws it.
void Painter::place(Program& program, const DrawItem& item) {
    program.set("u_world_from_local", item.world_from_local);
    program.set("u_normal_from_local", item.normal_from_local);
    program.set("u_mirror", item.mirrored ? -1.0f : 1.0f);
    set_culling(!scene_.materials[static_cast<std::size_t>(item.material)].double_sided,
                item.mirrored);
    scene_.meshes[static_cast<std::size_t>(item.mesh)].draw();
}

void Painter::paint_item(const Frame& frame, const DrawItem& item) {
    const bool color = scene_.meshes[static_cast<std::size_t>(item.mesh)].has_color();
    const SurfaceVariant variant = variant_for(frame, item.material, color);
    Program& program = programs_.get("surface.vert", "surface.frag", variant.defines());
    program.use();
    set_surface(program, frame, item.material);
    place(program, item);
}

void Painter::paint_gouraud(const Frame& frame, const DrawItem& item) {
    std::string defines = "#define LIGHTS " + std::to_string(scene_.lights.count()) + "\n";
    if (scene_.lights.any_positional()) defines += "#define POSITION\n";
    Program& program = programs_.get("gouraud.vert", "gouraud.frag", defines);
    program.use();
    set_common(program, frame);
    set_material(program, scene_.materials[static_cast<std::size_t>(item.material)],
                 scene_.textures, 0.0f);
    place(program, item);
}

void Painter::paint_background(const Frame& frame) {
    Program& program = programs_.get("fullscreen.vert", "background.frag", "");
    program.use();
    set_common(program, frame);
    set_rays(program, frame.view);
    program.set("u_background_lod", std::clamp(frame.options->background_blur, 0.0f, 1.0f) *
                                        std::max(scene_.environment->last_lod() - 1.0f, 0.0f));
    set_culling(false, false);
    glDepthMask(GL_FALSE);
    draw_fullscreen(program, 1.0f);
    glDepthMask(GL_TRUE);
}

void Painter::paint_blended(const Frame& frame) {
    std::vector<std::pair<float, std::size_t>> order;
    for (std::size_t i = 0; i < scene_.items.size(); ++i) {
        const DrawItem& item = scene_.items[i];
        if (!blended(scene_.materials[static_cast<std::size_t>(item.material)])) continue;
        const glm::vec4 clip = frame.view.clip_from_world * glm::vec4(item.bounds.center(), 1.0f);
        // Orthographic views have w = 1 and depth in z; z grows with depth in both.
        order.emplace_back(-(frame.view.eye.w > 0.0f ? clip.w : clip.z), i);
    }
    if (order.empty()) return;
    std::ranges::stable_sort(order, {}, &std::pair<float, std::size_t>::first);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    for (const auto& [depth, index] : order) paint_item(frame, scene_.items[index]);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void Painter::accumulate(Targets& targets) {
    Program& program = programs_.get("fullscreen.vert", "accumulate.frag", "");
    set_culling(false, false);
    targets.accumulate(program, empty_.get());
}

}  // namespace burnish::gpu
