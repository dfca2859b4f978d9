#include "gpu/passes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "gpu/texture_units.hpp"

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

bool blended(const Material& m) {
    return m.alpha_mode == AlphaMode::blend;
}

}  // namespace

DeviceScene::DeviceScene(Context& context, const Scene& scene, const Environment* light)
    : materials(scene.materials),
      items(draw_items(scene)),
      bounds(gpu::bounds_of(items)),
      textures(context, scene),
      lights(scene.lights) {
    for (const Mesh& mesh : scene.meshes) meshes.emplace_back(mesh);
    if (light != nullptr && !light->radiance.empty()) environment.emplace(context, *light);

    std::vector<std::size_t> chosen;
    std::size_t vertices = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(items[i].mesh)];
        const Material& material = materials[static_cast<std::size_t>(items[i].material)];
        const SurfaceVariant v = variant_of(material, textures, !mesh.colors.empty(), true);
        const bool plain =
            v.alpha_mode == AlphaMode::opaque && !v.vertex_color && !v.uv_per_texture;
        // 255: one value of the stencil a material.
        if (plain && !context.is_es() && items[i].material < 255 && !mesh.indices.empty()) {
            chosen.push_back(i);
            vertices += mesh.positions.size();
            baked_triangles += mesh.indices.size() / 3;
        } else {
            not_baked.push_back(i);
        }
    }
    if (BakedGeometry::fits(vertices, baked_triangles)) {
        baked.emplace(scene, items, chosen);
    } else {
        baked_triangles = 0;
    }
}

Painter::Painter(Context& context, DeviceScene& scene)
    : scene_(scene), programs_(context.is_es() ? ShaderDialect::es300 : ShaderDialect::gl330) {}

bool Painter::shows_environment(const Frame& frame) const {
    return scene_.environment && frame.options->background == BackgroundKind::environment;
}

bool Painter::uses_baked(const Frame& frame) const {
    if (!scene_.baked || frame.variant == ShadingVariant::gouraud) return false;
    if (frame.options->surface_pass != SurfacePass::automatic) {
        return frame.options->surface_pass == SurfacePass::visibility;
    }
    const double pixels =
        static_cast<double>(frame.options->width) * static_cast<double>(frame.options->height);
    // Half of the triangles look away, and about half the picture is covered.
    return static_cast<double>(scene_.baked_triangles) * 40.0 > pixels;
}

SurfaceVariant Painter::variant_for(const Frame& frame, int material, bool vertex_color) const {
    SurfaceVariant v =
        variant_of(scene_.materials[static_cast<std::size_t>(material)], scene_.textures,
                   vertex_color, frame.variant == ShadingVariant::full);
    v.lights = scene_.lights.count();
    const bool lit = scene_.environment && frame.options->environment_intensity > 0.0f;
    v.image_light = lit ? static_cast<int>(frame.options->image_light) : 0;
    return v;
}

void Painter::set_common(Program& program, const Frame& frame) {
    const RenderOptions& o = *frame.options;
    program.set("u_clip_from_world", frame.view.clip_from_world);
    program.set("u_eye", frame.view.eye);
    program.set("u_tile_origin", glm::ivec2(frame.tile.x, frame.tile.y));
    program.set("u_image_samples", o.image_light_samples);
    program.set("u_frame", static_cast<unsigned>(frame.sample));
    program.set("u_total_samples", static_cast<float>(o.image_light_samples) *
                                       static_cast<float>(std::max(o.samples, 1)));
    program.set("u_seed", o.seed);
    scene_.lights.set(program);
    if (scene_.environment) {
        scene_.environment->bind(program, o.environment_intensity, o.environment_rotation);
    }
}

void Painter::draw_fullscreen(Program& program, float depth) {
    program.set("u_depth", depth);
    glBindVertexArray(empty_.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
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
    clear(frame, targets);
    const bool baked = uses_baked(frame);
    if (baked) paint_baked(frame, targets);
    for (std::size_t i = 0; i < scene_.items.size(); ++i) {
        if (baked && !std::ranges::binary_search(scene_.not_baked, i)) continue;
        const DrawItem& item = scene_.items[i];
        if (frame.variant == ShadingVariant::gouraud) {
            paint_gouraud(frame, i);
        } else if (!blended(scene_.materials[static_cast<std::size_t>(item.material)])) {
            paint_item(frame, i);
        }
    }
    if (shows_environment(frame)) paint_background(frame);
    if (frame.variant != ShadingVariant::gouraud) paint_blended(frame);
}

// The triangles, then each material where its triangles are seen: the stencil has its number, and a
// full-screen triangle at the far plane passes where something is nearer.
void Painter::paint_baked(const Frame& frame, Targets& targets) {
    const BakedGeometry& baked = *scene_.baked;
    targets.bind_visibility();
    Program& program = programs_.get("visibility.vert", "visibility.frag", "");
    program.use();
    program.set("u_clip_from_world", frame.view.clip_from_world);
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    std::vector<int> seen;
    for (std::size_t part = 0; part < baked.parts(); ++part) {
        const int material = baked.material_of(part);
        set_culling(!scene_.materials[static_cast<std::size_t>(material)].double_sided, false);
        glStencilFunc(GL_ALWAYS, material + 1, 0xFF);
        baked.draw(part, program);
        if (std::ranges::find(seen, material) == seen.end()) seen.push_back(material);
    }
    targets.bind_frame();
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_GREATER);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    set_culling(false, false);
    if (seen.size() == 1) glDisable(GL_STENCIL_TEST);
    for (const int material : seen) {
        glStencilFunc(GL_EQUAL, material + 1, 0xFF);
        resolve_material(frame, targets, material);
    }
    glDisable(GL_STENCIL_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LEQUAL);
}

void Painter::resolve_material(const Frame& frame, Targets& targets, int material) {
    const SurfaceVariant variant = variant_for(frame, material, false);
    Program& program = programs_.get("fullscreen.vert", "resolve.frag", variant.defines());
    program.use();
    set_common(program, frame);
    set_material(program, scene_.materials[static_cast<std::size_t>(material)], scene_.textures,
                 lod_bias(frame.options->samples));
    targets.bind_visible_texture(program);
    scene_.baked->bind_for_shading(program);
    program.set("u_ndc_per_pixel", glm::vec2(2.0f / static_cast<float>(frame.tile.width),
                                             2.0f / static_cast<float>(frame.tile.height)));
    draw_fullscreen(program, 1.0f);
}

void Painter::paint_item(const Frame& frame, std::size_t index) {
    const DrawItem& item = scene_.items[index];
    const Material& material = scene_.materials[static_cast<std::size_t>(item.material)];
    const MeshBuffers& mesh = scene_.meshes[static_cast<std::size_t>(item.mesh)];
    const SurfaceVariant variant = variant_for(frame, item.material, mesh.has_color());
    Program& program = programs_.get("surface.vert", "surface.frag", variant.defines());
    program.use();
    set_common(program, frame);
    set_material(program, material, scene_.textures, lod_bias(frame.options->samples));
    program.set("u_world_from_local", item.world_from_local);
    program.set("u_normal_from_local", item.normal_from_local);
    program.set("u_mirror", item.mirrored ? -1.0f : 1.0f);
    set_culling(!material.double_sided, item.mirrored);
    mesh.draw();
}

void Painter::paint_gouraud(const Frame& frame, std::size_t index) {
    const DrawItem& item = scene_.items[index];
    const Material& material = scene_.materials[static_cast<std::size_t>(item.material)];
    Program& program =
        programs_.get("gouraud.vert", "gouraud.frag",
                      "#define LIGHTS " + std::to_string(scene_.lights.count()) + "\n");
    program.use();
    set_common(program, frame);
    set_material(program, material, scene_.textures, 0.0f);
    program.set("u_world_from_local", item.world_from_local);
    program.set("u_normal_from_local", item.normal_from_local);
    set_culling(!material.double_sided, item.mirrored);
    scene_.meshes[static_cast<std::size_t>(item.mesh)].draw();
}

void Painter::paint_background(const Frame& frame) {
    Program& program = programs_.get("fullscreen.vert", "background.frag", "");
    program.use();
    set_common(program, frame);
    program.set("u_ray_center", frame.view.ray_center);
    program.set("u_ray_x", frame.view.ray_x);
    program.set("u_ray_y", frame.view.ray_y);
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
    for (const auto& [depth, index] : order) paint_item(frame, index);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void Painter::accumulate(Targets& targets) {
    Program& program = programs_.get("fullscreen.vert", "accumulate.frag", "");
    set_culling(false, false);
    targets.accumulate(program, empty_.get());
}

}  // namespace burnish::gpu
