#include "viewer/window/app.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/files.hpp"
#include "gpu/device/program.hpp"
#include "jobs/export_material.hpp"
#include "jobs/render.hpp"
#include "viewer/document/command_line.hpp"
#include "viewer/document/load_stage.hpp"
#include "viewer/document/open_files.hpp"
#include "viewer/document/save_scene.hpp"
#include "viewer/generate/save_maps.hpp"
#include "viewer/motion/light_sphere.hpp"
#include "viewer/motion/orbit.hpp"

namespace burnish::viewer {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kAutosave_s = 30.0;
constexpr double kLook_s = 1.0;    // between looks at the files on disk
constexpr double kSettle_s = 0.2;  // after the last motion the picture refines
constexpr std::size_t kMostMessages = 200;
constexpr double kTurn_s = 12.0;  // a turn of the turntable

double seconds_since(Clock::time_point t) {
    return std::chrono::duration<double>(Clock::now() - t).count();
}

// Files that the document names and that may change on disk.
std::vector<std::string> files_of(const Document& document) {
    std::vector<std::string> files;
    const auto add = [&](const std::string& name) {
        std::error_code error;
        if (!name.empty() && std::filesystem::exists(name, error)) files.push_back(name);
    };
    add(document.input);
    add(document.environment);
    const auto add_values = [&](const ParameterValues& values) {
        for (const auto& [name, value] : values.set_values())
            if (const auto* text = std::get_if<std::string>(&value)) add(*text);
    };
    add_values(document.values);
    for (const auto& [index, values] : document.material_values) add_values(values);
    return files;
}

}  // namespace

std::span<const std::string_view> Panels::names() {
    static constexpr std::array<std::string_view, 8> kNames = {
        "parameters", "scene", "compare", "inspector", "messages", "keys", "costs", "generator"};
    return kNames;
}

bool* Panels::find(std::string_view name) {
    const std::array<bool*, 8> all = {&parameters, &scene, &compare, &inspector,
                                      &messages,   &keys,  &costs,   &generator};
    for (std::size_t i = 0; i < all.size(); ++i)
        if (names()[i] == name) return all[i];
    return nullptr;
}

App::App(Window& w, gpu::Context& c, std::filesystem::path folder)
    : window(w), context(c), picture(c), generator(folder), state_folder(std::move(folder)) {
    loader_.on_done([] { Window::wake(); });
    std::vector<std::string> warnings;
    if (!state_folder.empty()) {
        remembered = load_remembered(state_folder, warnings);
        const std::vector<LeftBehind> left = autosaves_left_behind(state_folder);
        if (!left.empty()) recovered = left.front();
    }
    for (const auto& [name, open] : remembered.panels)
        if (bool* panel = panels.find(name)) *panel = open;
    for (const std::string& line : warnings) say(line);
    last_autosave_ = last_look_ = Clock::now();
}

App::~App() {
    loader_.stop();
    if (state_folder.empty()) return;
    const WindowOptions at = window.placement();
    remembered.width = at.width;
    remembered.height = at.height;
    remembered.x = at.x;
    remembered.y = at.y;
    remembered.maximized = at.maximized;
    for (const std::string_view name : Panels::names())
        remembered.panels[std::string(name)] = *panels.find(name);
    try {
        save_remembered(state_folder, remembered);
    } catch (const std::exception&) {
        // There is nobody left to tell.
    }
    remove_autosave(state_folder);
}

void App::say(std::string text, bool is_error) {
    messages.push_back({std::move(text), is_error, Clock::now()});
    if (messages.size() > kMostMessages) messages.pop_front();
}

// --- files ----------------------------------------------------------------------------------------

void App::load(Document document, std::string name, std::function<void(Document, Stage)> adopt) {
    generator.cancel(*this);
    const auto wanted = std::make_shared<const Document>(std::move(document));
    loader_.start<Stage>(
        name, [wanted](const Progress& progress) { return load_stage(*wanted, progress); },
        [this, wanted, adopt = std::move(adopt)](Stage stage) {
            try {
                adopt(*wanted, std::move(stage));
                report_new_warnings();
                after_change();
            } catch (const std::exception& error) {
                say(one_line(error.what()), true);
            }
        },
        [this](const std::string& line) { say(line, true); });
}

void App::open_document(Document document, const std::string& name) {
    load(std::move(document), name, [this](Document d, Stage stage) {
        editor.open_loaded(std::move(d), std::move(stage));
        material.reset();
        picked.reset();
    });
}

void App::open_first(std::vector<std::string> paths) {
    try {
        std::vector<std::string> notes;
        Document document = document_for(paths, &notes);
        for (const std::string& path : paths) add_recent(remembered, path);
        for (std::string& note : notes) say(std::move(note));
        open_document(std::move(document), paths.empty() ? "the first scene" : paths.front());
    } catch (const Error& error) {
        say(error.what(), true);
        open_document(first_document(), "the first scene");
    }
}

void App::open(const std::vector<std::string>& paths) {
    try {
        std::vector<std::string> notes;
        Document next = document();
        for (const std::string& path : paths) next = opened(next, path, material, &notes);
        for (const std::string& path : paths) add_recent(remembered, path);
        for (std::string& note : notes) say(std::move(note));
        if (needs_load(document(), next)) {
            load(std::move(next), paths.front(), [this](Document d, Stage stage) {
                editor.set_loaded(std::move(d), std::move(stage), "open");
                material.reset();
                picked.reset();
            });
        } else {
            editor.set(std::move(next), {}, "open");
            report_new_warnings();
            after_change();
        }
    } catch (const std::exception& error) {
        say(one_line(error.what()), true);
    }
}

void App::save_scene(const std::filesystem::path& path) {
    viewer::save_scene(document(), editor.stage(), path, generator.cache());
    saved_scene_ = path.string();
    add_recent(remembered, path.string());
    say("saved " + path.string());
}

void App::save_picture(const std::filesystem::path& path, std::optional<Size> size) {
    RenderSettings settings = editor.stage().settings;
    settings.width = size ? size->width : picture_width;
    settings.height = size ? size->height : picture_height;
    const Image linear = picture.render(editor.stage().camera, settings, {});
    write_image(path,
                holds_linear(path)
                    ? linear
                    : to_display(linear, editor.stage().exposure_ev, editor.stage().tone_map),
                {});
    say("saved " + path.string());
}

void App::save_turntable(const std::filesystem::path& path, int frames) {
    RenderSettings settings = editor.stage().settings;
    settings.width = picture_width;
    settings.height = picture_height;
    for (int i = 0; i < frames; ++i) {
        const double angle = glm::two_pi<double>() * i / frames;
        const Image linear =
            picture.render(turned(editor.stage().camera, angle), settings, {});
        const std::filesystem::path file = numbered(path, i);
        write_image(file,
                    holds_linear(file)
                        ? linear
                        : to_display(linear, editor.stage().exposure_ev, editor.stage().tone_map),
                    {});
    }
    say(fmt::format("saved {} frames beside {}", frames, path.string()));
}

void App::save_gltf(const std::filesystem::path& folder) {
    // The job reads a scene file: the document goes through one that lies beside the folder.
    const std::filesystem::path scene_file =
        std::filesystem::absolute(folder).parent_path() / ".burnish-view-export.json";
    viewer::save_scene(document(), editor.stage(), scene_file);
    ExportMaterialRequest request;
    request.stage.input = scene_file.string();
    if (material) request.material = std::to_string(*material);
    request.preview = false;  // it would need a context of its own
    request.output = folder;
    request.command = "burnish view";
    loader_.start<ExportMaterialReport>(
        "export",
        [request, scene_file](const Progress& progress) {
            const ExportMaterialReport report = export_material(request, progress);
            std::error_code error;
            std::filesystem::remove(scene_file, error);
            return report;
        },
        [this, folder](const ExportMaterialReport& report) {
            for (const std::string& line : report.warnings) say(line);
            say(fmt::format("saved {} files in {}", report.written.size(), folder.string()));
        },
        [this, scene_file](const std::string& line) {
            std::error_code error;
            std::filesystem::remove(scene_file, error);
            say(line, true);
        });
}

void App::save_maps(const std::filesystem::path& folder) {
    const MapsRequest request = maps_request(editor.stage(), material, folder);
    loader_.start<SavedMaps>(
        "maps", [request](const Progress& progress) { return make_maps(request, progress); },
        [this, folder, what = request.what](const SavedMaps& saved) {
            for (const std::string& line : saved.warnings) say(line);
            say(fmt::format("saved the {}: {} files in {}", what, saved.written.size(),
                            folder.string()));
        },
        [this](const std::string& line) { say(line, true); });
}

void App::copy_command_line() {
    const std::string scene = saved_scene_.empty() ? "scene.json" : saved_scene_;
    const CommandLine command = render_command(document(), editor.stage(), scene, "picture.png");
    window.set_clipboard(command.text());
    if (command.needs_scene)
        say(fmt::format("copied: {} (save the scene there first: flags cannot say {})",
                        command.text(), command.reason));
    else
        say("copied: " + command.text());
}

// --- changes --------------------------------------------------------------------------------------

bool App::edit(std::string_view key, std::string_view name,
               const std::function<void(Document&)>& change) {
    try {
        Document next = document();
        change(next);
        editor.set(std::move(next), key, name);
        report_new_warnings();
        after_change();
        return true;
    } catch (const std::exception& error) {
        say(one_line(error.what()), true);
        return false;
    }
}

void App::set_parameter(std::string_view name, const ParameterValue& value) {
    const Parameter* parameter = find_parameter(name);
    const bool own = parameter != nullptr && parameter->group == ParameterGroup::material;
    edit(name, name, [&](Document& d) {
        viewer::set_parameter(d, name, value, own ? material : std::nullopt);
    });
    last_motion_ = Clock::now();
}

void App::unset_parameter(std::string_view name) {
    const Parameter* parameter = find_parameter(name);
    const bool own = parameter != nullptr && parameter->group == ParameterGroup::material;
    edit({}, name, [&](Document& d) {
        viewer::unset_parameter(d, name, own ? material : std::nullopt);
    });
}

void App::undo() {
    generator.cancel(*this);
    const std::shared_ptr<const Document> to = editor.history().undo_document();
    if (!to) return say("nothing to undo");
    try {
        if (needs_load(document(), *to)) {
            load(*to, "undo", [this](const Document&, Stage stage) {
                editor.undo_loaded(std::move(stage));
            });
            return;
        }
        editor.undo();
        after_change();
    } catch (const std::exception& error) {
        say(one_line(error.what()), true);
    }
}

void App::redo() {
    generator.cancel(*this);
    const std::shared_ptr<const Document> to = editor.history().redo_document();
    if (!to) return say("nothing to redo");
    try {
        if (needs_load(document(), *to)) {
            load(*to, "redo", [this](const Document&, Stage stage) {
                editor.redo_loaded(std::move(stage));
            });
            return;
        }
        editor.redo();
        after_change();
    } catch (const std::exception& error) {
        say(one_line(error.what()), true);
    }
}

void App::report_new_warnings() {
    for (const std::string& line : editor.new_warnings()) say(line);
}

void App::after_change() {
    if (material && static_cast<std::size_t>(*material) >= scene().materials.size())
        material.reset();
    watched_.clear();
}

// --- moves ----------------------------------------------------------------------------------------

namespace {

// An orthographic camera that is moved becomes a perspective one that sees the same height at its target.
double fov_deg_of(const Camera& camera) {
    if (!camera.orthographic) return glm::degrees(static_cast<double>(camera.yfov));
    const double distance = static_cast<double>(glm::distance(camera.position, camera.target));
    return glm::degrees(2 * std::atan(static_cast<double>(camera.ymag) / std::max(distance, 1e-9)));
}

}  // namespace

int App::dragged_light() {
    const std::vector<Light>& lights = scene().lights;
    if (lights.empty()) {
        edit({}, "add light", [](Document& d) { d.lights = {parse_light("30,45")}; });
        light = 0;
    }
    light = std::clamp(light, 0, static_cast<int>(scene().lights.size()) - 1);
    return light;
}

void App::drag(Drag kind, glm::dvec2 by) {
    last_motion_ = Clock::now();
    dragging_ = kind;
    const Camera& camera = editor.stage().camera;
    const auto move_to = [&](const Camera& moved) {
        edit("camera", "camera", [&](Document& d) {
            viewer::set_camera(d, moved.position, moved.target,
                               std::clamp(fov_deg_of(moved), 1.0, 170.0));
        });
    };
    switch (kind) {
        case Drag::orbit:
            return move_to(orbited(camera, by, picture_height));
        case Drag::pan:
            return move_to(panned(camera, by, picture_height));
        case Drag::zoom:
            return move_to(zoomed(camera, std::exp(0.005 * by.y), glm::dvec3(camera.target)));
        case Drag::environment: {
            // A drag as long as the picture is wide turns the environment once.
            const double turn = 360.0 * by.x / std::max(picture_width, 1);
            edit("environment_rotation", "environment_rotation", [&](Document& d) {
                double angle = d.values.real("environment_rotation") + turn;
                angle -= 360.0 * std::floor((angle + 180.0) / 360.0);
                viewer::set_parameter(d, "environment_rotation", angle);
            });
            return;
        }
        case Drag::light: {
            const auto index = static_cast<std::size_t>(dragged_light());
            const glm::dvec3 pivot(bounds_of(scene()).center());
            std::vector<Light> lights = scene().lights;
            lights[index] = viewer::dragged_light(camera, lights[index], pivot, by, picture_height);
            edit("light", "light", [&](Document& d) { d.lights = lights; });
            return;
        }
        case Drag::highlight:
        case Drag::none:
            return;
    }
}

void App::note_motion() {
    last_motion_ = Clock::now();
}

void App::end_drag() {
    dragging_ = Drag::none;
    editor.close_step();
}

void App::zoom_at(glm::dvec2 pixel, double steps) {
    last_motion_ = Clock::now();
    const Camera moved =
        zoomed(editor.stage().camera, wheel_factor(steps), pixel, picture_size());
    edit("camera", "camera", [&](Document& d) {
        viewer::set_camera(d, moved.position, moved.target,
                           std::clamp(fov_deg_of(moved), 1.0, 170.0));
    });
}

void App::frame_all() {
    const Bounds bounds = bounds_of(scene());
    const Camera moved =
        framed(editor.stage().camera, bounds,
               static_cast<double>(picture_width) / std::max(picture_height, 1));
    edit({}, "frame", [&](Document& d) {
        viewer::set_camera(d, moved.position, moved.target,
                           std::clamp(fov_deg_of(moved), 1.0, 170.0));
    });
}

void App::put_highlight(glm::dvec2 pixel) {
    last_motion_ = Clock::now();
    dragging_ = Drag::highlight;
    const Camera& camera = editor.stage().camera;
    const auto hit = viewer::pick(scene(), picker_, camera, pixel, picture_size());
    if (!hit) return;
    const auto index = static_cast<std::size_t>(dragged_light());
    const auto placed = light_for_highlight(scene(), *hit, towards_eye(camera, hit->position),
                                            scene().lights[index]);
    if (!placed) return say("no light above the horizon puts the highlight there");
    std::vector<Light> lights = scene().lights;
    lights[index] = *placed;
    edit("light", "highlight", [&](Document& d) { d.lights = lights; });
}

void App::pick(glm::dvec2 pixel) {
    const Camera& camera = editor.stage().camera;
    const auto hit = viewer::pick(scene(), picker_, camera, pixel, picture_size());
    if (!hit) {
        picked.reset();
        return;
    }
    Picked found;
    found.hit = *hit;
    found.pixel = pixel;
    picked = std::move(found);
    pick_again();
    panels.inspector = true;
}

void App::pick_again() {
    if (!picked) return;
    const Camera& camera = editor.stage().camera;
    const glm::dvec3 at = picked->hit.position;
    std::vector<Method> methods = document().compare.mode == CompareMode::off
                                      ? std::vector<Method>{}
                                      : document().compare.methods;
    const Method own = scene().materials[static_cast<std::size_t>(picked->hit.material)].method;
    for (const Method m : {own, Method::normal_map, Method::follow_grain, Method::deform_smooth})
        if (std::ranges::find(methods, m) == methods.end() && methods.size() < kMostCompared)
            methods.push_back(m);
    const glm::dvec3 to_eye = towards_eye(camera, at);
    glm::dvec3 to_light(picked->hit.normal);
    if (!scene().lights.empty()) {
        light = std::clamp(light, 0, static_cast<int>(scene().lights.size()) - 1);
        to_light = towards_light(scene().lights[static_cast<std::size_t>(light)], at);
    }
    try {
        picked->report = inspect(scene(), picked->hit, to_eye, to_light, methods);
        picked->albedos.clear();
        for (const MethodReport& m : picked->report.methods)
            picked->albedos.push_back(
                m.lobe.has_meaning() ? lobe_albedo(m.lobe, picked->report.to_eye, 2048)
                                     : LobeAlbedo{});
    } catch (const Error& error) {
        say(error.what(), true);
        picked.reset();
    }
}

// --- once a frame ---------------------------------------------------------------------------------

bool App::needs_frames() const {
    return (!picture.at_rest() && refused_ != editor.revisions()) || turntable || loader_.running() ||
           generator.working() ||
           seconds_since(last_motion_) < kSettle_s + 0.1 || dragging_ != Drag::none ||
           document().compare.mode == CompareMode::blink ||
           (!messages.empty() && seconds_since(messages.back().since) < 6.0);
}

void App::update() {
    loader_.poll();
    if (turntable) {
        const double step = std::min(seconds_since(last_turn_), 0.2);
        if (step > 0 && !scene().instances.empty()) {
            const Camera moved =
                orbited_by(editor.stage().camera, glm::dvec3(editor.stage().camera.target),
                           glm::two_pi<double>() * step / kTurn_s, 0);
            edit("camera", "turntable", [&](Document& d) {
                viewer::set_camera(d, moved.position, moved.target, fov_deg_of(moved));
            });
        }
        last_motion_ = Clock::now();
    }
    last_turn_ = Clock::now();
    generator.settle(*this);
    try {
        picture.follow(editor);
    } catch (const std::exception& error) {
        say(one_line(error.what()), true);
    }
    generator.show(*this);
    if (picker_revisions_ != editor.revisions()) {
        Revisions as = editor.revisions();
        if (!picker_revisions_ || picker_revisions_->scene != as.scene) {
            picker_ = Picker(scene());
        } else if (picker_revisions_->geometry != as.geometry) {
            picker_.update(scene());
        }
        picker_revisions_ = as;
    }
    // The inspector follows what changes, at rest.
    if (picked && picked_revisions_ != editor.revisions() && dragging_ == Drag::none) {
        pick_again();
        picked_revisions_ = editor.revisions();
    }
    picture.set_moving(seconds_since(last_motion_) < kSettle_s || dragging_ != Drag::none);
    follow_files();
    autosave_now_and_then();
}

void App::draw_picture(double budget_s) {
    if (refused_ == editor.revisions()) return;
    try {
        picture.refine(budget_s);
        refused_.reset();
    } catch (const std::exception& error) {
        say(one_line(error.what()), true);
        refused_ = editor.revisions();
    }
}

void App::count_frame() {
    generator.shown();
    const double period = seconds_since(last_frame_);
    last_frame_ = Clock::now();
    if (period > 0.5) return;  // the window was at rest
    const double now = 1 / std::max(period, 1e-4);
    // A mean over about ten frames.
    frames_per_second = frames_per_second > 0 ? 0.9 * frames_per_second + 0.1 * now : now;
    if (dragging_ != Drag::none)
        lowest_frames_per_second = lowest_frames_per_second > 0 ? std::min(lowest_frames_per_second, now) : now;
}

void App::reload_shaders() {
    try {
        context.programs().reload();
        picture.restart();
        say("shaders reloaded");
    } catch (const Error& error) {
        say(error.what(), true);
    }
}

void App::follow_files() {
    if (seconds_since(last_look_) < kLook_s || loader_.running()) return;
    last_look_ = Clock::now();
    const bool known = !watched_.empty();
    std::vector<std::pair<std::string, std::filesystem::file_time_type>> now;
    for (const std::string& file : files_of(document())) {
        std::error_code error;
        const auto time = std::filesystem::last_write_time(file, error);
        if (!error) now.emplace_back(file, time);
    }
    if (known && now != watched_ && now.size() == watched_.size()) {
        say("a file has changed: read again");
        load(document(), "reload",
             [this](const Document&, Stage stage) { editor.reloaded(std::move(stage)); });
    } else if (known && now.size() < watched_.size()) {
        say("a file that is open is gone from disk: what was read stays");
    }
    watched_ = std::move(now);
}

void App::autosave_now_and_then() {
    if (state_folder.empty() || seconds_since(last_autosave_) < kAutosave_s) return;
    last_autosave_ = Clock::now();
    if (!editor.history().can_undo()) return;  // nothing to lose
    try {
        autosave(state_folder, document(), editor.stage());
    } catch (const Error& error) {
        say(error.what(), true);
    }
}

}  // namespace burnish::viewer
