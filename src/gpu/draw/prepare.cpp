// Prepares the data and programs of a frame.
#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include "gpu/device/albedo_tables.hpp"
#include "gpu/draw/material_state.hpp"
#include "gpu/draw/passes.hpp"

namespace burnish::gpu {
namespace {

// Average size of a triangle, in pixels of the picture, below which deferred shading is faster.
// Measured on llvmpipe, which shades blocks of 4 x 4 pixels: forward shading costs about twice the
// pixels of a triangle of 40 pixels. Tabulated materials cost more per pixel.
constexpr double kSoftwarePixels = 40.0;
constexpr double kSoftwareTabulatedPixels = 400.0;
// Hardware shades blocks of 2 x 2 pixels: forward shading costs about twice the pixels of a
// triangle of 8 pixels, estimated from its outline (8 pixels touch 4 to 5 blocks). Not measured.
constexpr double kHardwarePixels = 8.0;

Program& of(ProgramCache& programs, bool wait, const char* vertex, const char* fragment,
            const std::string& defines) {
    return wait ? programs.get(vertex, fragment, defines)
                : *programs.start(vertex, fragment, defines);
}

}  // namespace

MaterialSlot& Painter::slot_of(const Frame& frame, int material) {
    return scene_.material(material, frame.options->method);
}

// Whether the picture is of the albedo, which a white environment shows.
bool Painter::is_furnace(const Frame& frame) {
    return frame.options->view == SurfaceView::albedo;
}

bool Painter::shows_environment(const Frame& frame) const {
    return scene_.environment() != nullptr && frame.options->view == SurfaceView::radiance &&
           frame.options->background == BackgroundKind::environment;
}

bool Painter::lit_by_environment(const Frame& frame) const {
    const RenderSettings& o = *frame.options;
    return scene_.environment() != nullptr && o.environment_intensity > 0.0f &&
           o.image_light != ImageLight::off;
}

bool Painter::can_stand_in(const Frame& frame) const {
    return frame.options->view == SurfaceView::radiance &&
           (lit_by_environment(frame) || scene_.lights().count() > 0);
}

bool Painter::sees_ground(const Frame& frame) {
    return frame.options->ground && frame.options->view == SurfaceView::radiance &&
           frame.variant != ShadingVariant::gouraud && scene_.ground().faces(frame.view.eye);
}

// Whether vertices say what they see: of an environment that lights, or in the view of it.
bool Painter::sees_surroundings(const Frame& frame) const {
    const RenderSettings& o = *frame.options;
    if (!o.visibility || !scene_.has_visibility() || frame.variant == ShadingVariant::gouraud ||
        is_furnace(frame))
        return false;
    return lit_by_environment(frame) || o.view == SurfaceView::openness;
}

bool Painter::defers(const Frame& frame, bool shape) const {
    if (frame.variant == ShadingVariant::gouraud) return false;
    // Five images of gbuffer.frag, which every desktop has, and ES need not.
    if (draw_buffers_ < 5 && sees_surroundings(frame)) return false;
    if (frame.options->surface_pass != SurfacePass::automatic) {
        return frame.options->surface_pass == SurfacePass::deferred;
    }
    const double pixels =
        static_cast<double>(frame.options->width) * static_cast<double>(frame.options->height);
    const double per_triangle = !context_.is_software() ? kHardwarePixels
                                : shape                 ? kSoftwareTabulatedPixels
                                                        : kSoftwarePixels;
    return static_cast<double>(scene_.triangles(frame.options->coarse)) * per_triangle > pixels;
}

Painter::Needs Painter::needs_of(const Frame& frame) {
    Needs needs;
    needs.shape = scene_.any_tabulated();
    needs.defers = defers(frame, needs.shape);
    needs.shadows = frame.options->shadows && !is_furnace(frame) && scene_.shadows().count() > 0 &&
                    frame.variant != ShadingVariant::gouraud;
    needs.visibility = sees_surroundings(frame);
    needs.position =
        scene_.lights().any_positional() || scene_.area_lights().count() > 0 || needs.shadows;
    needs.ground = sees_ground(frame);
    needs.frame = new_uniform_version();
    const std::pair<int, bool> settings{frame.options->samples, frame.options->filter_cloth};
    if (settings_version_ == 0 || settings != material_settings_) {
        material_settings_ = settings;
        settings_version_ = new_uniform_version();
    }
    needs.settings = settings_version_;
    return needs;
}

SurfaceVariant Painter::variant_of(const Frame& frame, const MaterialSlot& slot, bool color) const {
    SurfaceVariant v = frame.variant == ShadingVariant::full ? slot.full : slot.flat;
    v.vertex_color = color;
    v.lights = is_furnace(frame) ? 0 : scene_.lights().count();
    v.position = needs_.position;
    v.shadow_maps = needs_.shadows ? scene_.shadows().count() : 0;
    v.area_lights = is_furnace(frame) ? 0 : scene_.area_lights().count();
    v.area_textures = v.area_lights > 0 && scene_.area_lights().any_texture();
    if (frame.light_count == LightCount::at_run_time && v.lights + v.area_lights > 0) {
        v.light_count_at_run_time = true;
        v.lights = static_cast<int>(kMostLights);
        if (v.area_lights > 0) v.area_lights = static_cast<int>(kMostAreaLights);
        if (v.shadow_maps > 0) v.shadow_maps = kMostShadowMaps;
    }
    v.image_light = lit_by_environment(frame) ? static_cast<int>(frame.options->image_light) : 0;
    v.view = frame.options->view != SurfaceView::radiance;
    v.visibility = needs_.visibility;
    if (is_furnace(frame)) {
        v.furnace = true;
        v.visibility = false;
        v.image_light = static_cast<int>(ImageLight::importance);
        v.occlusion_map = false;
    }
    if (v.view && v.alpha_mode == AlphaMode::blend) v.alpha_mode = AlphaMode::opaque;
    return v;
}

bool Painter::can_defer(const Frame& frame, const DrawItem& item) {
    // 254: the stencil has one number per material.
    return item.material < 254 &&
           variant_of(frame, slot_of(frame, item.material), scene_.mesh(item.mesh).has_color())
               .can_resolve();
}

Program& Painter::plain_program(const char* vertex, const char* fragment, bool wait) {
    return of(context_.programs(), wait, vertex, fragment, "");
}

Program& Painter::surface_program(MaterialSlot& slot, const SurfaceVariant& variant, bool resolve,
                                  bool wait) {
    const auto found = std::ranges::find_if(slot.programs, [&](const PreparedProgram& p) {
        return p.resolve == resolve && p.variant == variant;
    });
    const bool known = found != slot.programs.end();
    std::shared_ptr<Program> program = known ? found->program.lock() : nullptr;
    if (!program) {
        program =
            context_.programs().start(resolve ? "fullscreen.vert" : "surface.vert",
                                      resolve ? "resolve.frag" : "surface.frag", variant.defines());
        if (known)
            found->program = program;
        else
            slot.programs.push_back({variant, resolve, program});
    }
    if (wait) program->finish();
    return *program;  // the cache holds it
}

Program& Painter::gbuffer_program(const MaterialSlot& slot, bool wait) {
    std::string defines = needs_.position ? "#define POSITION\n" : "";
    if (needs_.shape) defines += "#define SHAPE\n";
    if (needs_.visibility) defines += "#define VISIBILITY\n";
    if (slot.material.double_sided) defines += "#define DOUBLE_SIDED\n";
    return of(context_.programs(), wait, "surface.vert", "gbuffer.frag", defines);
}

bool Painter::shows_emitters(const Frame& frame) const {
    return frame.options->view == SurfaceView::radiance &&
           frame.variant != ShadingVariant::gouraud &&
           std::ranges::any_of(scene_.area_lights().lights(), &Light::visible);
}

Program& Painter::emitter_program(bool wait) {
    return of(context_.programs(), wait, "area_emitter.vert", "area_emitter.frag",
              scene_.area_lights().any_texture() ? "#define AREA_TEXTURES\n" : "");
}

Program& Painter::gouraud_program(bool wait) {
    std::string defines = "#define LIGHTS " + std::to_string(scene_.lights().count()) + "\n";
    if (scene_.lights().any_positional()) defines += "#define POSITION\n";
    return of(context_.programs(), wait, "gouraud.vert", "gouraud.frag", defines);
}

Program& Painter::stand_in_program(const Frame& frame, bool wait) {
    std::string defines = "#define LIGHTS " + std::to_string(kMostLights) + "\n";
    defines += "#define LIGHT_COUNT_AT_RUN_TIME\n#define POSITION\n";
    if (lit_by_environment(frame)) defines += "#define LIT_BY_ENVIRONMENT\n";
    return of(context_.programs(), wait, "surface.vert", "stand_in.frag", defines);
}

bool Painter::is_stood_in(const Frame& frame, const DrawItem& item) {
    if (!frame.stands_in) return false;
    MaterialSlot& slot = slot_of(frame, item.material);
    const SurfaceVariant variant = variant_of(frame, slot, scene_.mesh(item.mesh).has_color());
    const bool resolve = needs_.defers && can_defer(frame, item);
    return std::ranges::none_of(slot.programs, [&](const PreparedProgram& p) {
        if (p.resolve != resolve || p.variant != variant) return false;
        const std::shared_ptr<Program> program = p.program.lock();
        return program && program->is_finished();
    });
}

int Painter::compile_some(const Frame& frame, double budget_s) {
    if (!frame.stands_in) return 0;
    needs_ = needs_of(frame);
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    bool compiled = false;
    const auto spent = [&] {
        if (!compiled) return budget_s <= 0.0;
        return std::chrono::duration<double>(Clock::now() - start).count() >= budget_s;
    };
    std::set<int> missing;
    for (const DrawItem& item : scene_.items()) {
        if (!is_stood_in(frame, item)) continue;
        if (spent()) {
            missing.insert(item.material);
            continue;
        }
        MaterialSlot& slot = slot_of(frame, item.material);
        surface_program(slot, variant_of(frame, slot, scene_.mesh(item.mesh).has_color()),
                        needs_.defers && can_defer(frame, item), true);
        compiled = true;
    }
    return static_cast<int>(missing.size());
}

// Sends every program that paint() needs to the compiler.
void Painter::start_programs(const Frame& frame, std::vector<Program*>& programs) {
    programs.push_back(&plain_program("fullscreen.vert", accumulation_of(*frame.options), false));
    if (needs_.shadows || frame.options->ground)
        programs.push_back(&plain_program("surface.vert", "shadow.frag", false));
    if (shows_emitters(frame)) programs.push_back(&emitter_program(false));
    if (shows_environment(frame))
        programs.push_back(&plain_program("fullscreen.vert", "background.frag", false));
    if (frame.variant == ShadingVariant::gouraud) {
        programs.push_back(&gouraud_program(false));
        return;
    }
    if (frame.stands_in) programs.push_back(&stand_in_program(frame, false));
    std::set<std::pair<int, bool>> done;  // material, and whether its mesh has colors
    for (const DrawItem& item : scene_.items()) {
        const bool color = scene_.mesh(item.mesh).has_color();
        if (!done.emplace(item.material, color).second) continue;
        MaterialSlot& slot = slot_of(frame, item.material);
        const bool resolve = needs_.defers && can_defer(frame, item);
        if (!frame.stands_in)
            programs.push_back(
                &surface_program(slot, variant_of(frame, slot, color), resolve, false));
        if (resolve) programs.push_back(&gbuffer_program(slot, false));
    }
}

void Painter::prepare_programs(const Frame& frame, const Progress& progress) {
    std::vector<Program*> programs;
    start_programs(frame, programs);
    std::erase_if(programs, [](const Program* program) { return program->is_finished(); });
    const std::size_t count = programs.size();
    while (!programs.empty()) {
        progress.step("shaders",
                      1.0 - static_cast<double>(programs.size()) / static_cast<double>(count));
        // Finish programs first that the compiler's threads have completed. Without such threads,
        // finish the last.
        auto next = programs.end();
        if (context_.programs().parallel())
            next =
                std::ranges::find_if(programs, [](const Program* p) { return p->is_compiled(); });
        if (next == programs.end()) --next;
        (*next)->finish();
        programs.erase(next);
    }
}

void Painter::prepare_tables(const Frame& frame, const Progress& progress) {
    scene_.area_lights().require_textures();
    const ImageLight light = frame.options->image_light;
    EnvironmentMaps* environment = scene_.environment();
    const bool blurred = light == ImageLight::prefiltered || light == ImageLight::bent_normal;
    if (environment != nullptr && blurred && !environment->has_lobes()) {
        progress.step("blurred environment", 0.0);
        environment->require_lobes(context_.programs(), empty_.get());
    }
    for (const MaterialSlot& slot : scene_.materials()) {
        const Material& m = slot.material;
        const bool sampled = environment != nullptr && light == ImageLight::importance;
        if (slot.tabulated && (sampled || is_furnace(frame))) slot.tabulated->require_draws();
        if (frame.options->view == SurfaceView::moments && wants_slopes(m))
            scene_.textures().require_covariances(m, progress);
        if (!reads_albedos(*frame.options, m)) continue;
        if (context_.albedos().has(m.brdf, m.mdf)) continue;
        progress.step("albedo tables", 0.0);
        context_.albedos().require(m.brdf, m.mdf);
    }
}

void Painter::prepare_ground(const Frame& frame, const Progress& progress) {
    const RenderSettings& o = *frame.options;
    Ground::require_programs(context_.programs(), ground_lights());
    // An environment that is visible but gives no light casts no shadow.
    const bool lit = o.image_light != ImageLight::off;
    scene_.ground().require(
        context_.programs(), empty_.get(), ground_lights(),
        {lit ? o.environment_intensity : 0.0f, o.environment_rotation, o.coarse},
        [&](const glm::mat4& clip) { draw_casters(clip, o.coarse); }, progress);
}

void Painter::prepare(const Frame& frame, bool ground, const Progress& progress) {
    needs_ = needs_of(frame);
    context_.programs().trim();
    prepare_programs(frame, progress);
    prepare_tables(frame, progress);
    if (ground) prepare_ground(frame, progress);
}

}  // namespace burnish::gpu
