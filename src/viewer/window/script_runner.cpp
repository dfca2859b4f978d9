#include "viewer/window/script_runner.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <imgui.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <sstream>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/machine.hpp"
#include "scene/parameters/parameter_text.hpp"
#include "viewer/document/file_names.hpp"
#include "viewer/document/value_in_effect.hpp"
#include "viewer/window/app_parts.hpp"
#include "viewer/window/panels.hpp"

namespace burnish::viewer {
namespace {

using Clock = std::chrono::steady_clock;

// Of the process, now; 0 where the kernel does not say.
double resident_memory_mb() {
    std::ifstream in("/proc/self/statm");
    double pages = 0, resident = 0;
    in >> pages >> resident;
    return in ? resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6 : 0;
}

// Since the process was started; to 10 ms, a tick of the kernel. 0 where the kernel does not say.
double process_age_s() {
    std::ifstream uptime("/proc/uptime"), stat("/proc/self/stat");
    double now_s = 0;
    std::string text;
    uptime >> now_s;
    std::getline(stat, text);
    // Behind the program's name in brackets come the fields from 3 on; 22 is the start, in ticks.
    std::istringstream fields(text.substr(std::min(text.rfind(')') + 1, text.size())));
    std::string field;
    for (int i = 3; i <= 22; ++i) fields >> field;
    const double start_ticks = fields ? std::stod(field) : 0;
    return start_ticks > 0 ? now_s - start_ticks / static_cast<double>(sysconf(_SC_CLK_TCK)) : 0;
}

double triangles_of(const Scene& scene) {
    std::size_t indices = 0;
    for (const Instance& instance : scene.instances)
        if (instance.mesh >= 0)  // below 0: hidden
            indices += scene.meshes[static_cast<std::size_t>(instance.mesh)].indices.size();
    return static_cast<double>(indices / 3);
}

Drag drag_of(DragKind kind) {
    switch (kind) {
        case DragKind::orbit:
            return Drag::orbit;
        case DragKind::pan:
            return Drag::pan;
        case DragKind::zoom:
            return Drag::zoom;
        case DragKind::light:
            return Drag::light;
        case DragKind::environment:
            return Drag::environment;
    }
    return Drag::none;
}

}  // namespace

void save_screenshot(const Window& window, const std::string& file) {
    const int width = window.width(), height = window.height();
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width) *
                                    static_cast<std::size_t>(height) * 3);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    Image image(width, height, 3);
    for (int y = 0; y < height; ++y)
        for (int i = 0; i < 3 * width; ++i)
            image.at(0, y)[i] = static_cast<float>(bytes[static_cast<std::size_t>(height - 1 - y) *
                                                             static_cast<std::size_t>(width) * 3 +
                                                         static_cast<std::size_t>(i)]) /
                                255.0f;
    write_image(file, image, {});
}

ScriptRunner::ScriptRunner(App& app, std::vector<Command> commands, std::string name)
    : app_(app),
      commands_(std::move(commands)),
      name_(std::move(name)),
      was_recoverable_(app.recovered.has_value()) {
    app_.asks_recovery = false;  // its dialog would stand before everything
}

void ScriptRunner::fail(const std::string& what) const {
    throw Error(fmt::format("{}: line {}: {}", name_, line_, what));
}

void ScriptRunner::feed_input() {
    if (type_command_) feed_type_command();
    if (!mouse_) return;
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {static_cast<float>(mouse_->x), static_cast<float>(mouse_->y)};
    io.MouseDown[0] = click_step_ == 3 || click_step_ == 2;
    io.KeyShift = click_shift_;
    if (click_step_ > 0 && --click_step_ == 0) click_shift_ = false;
    if (mouse_command_) feed_mouse_command();
}

// Whether the last command still takes frames.
bool ScriptRunner::still_busy() {
    if (app_.loading() || app_.generator.working() || click_step_ > 0 || screenshot_) return true;
    if (generating_) {
        generating_ = false;
        if (!app_.generator.fault().empty()) fail(app_.generator.fault());
    }
    if (dragging_) {
        const DragCommand& c = dragging_->command;
        if (dragging_->frame < c.frames) {
            app_.drag(drag_of(c.kind), glm::dvec2(c.dx, c.dy) / static_cast<double>(c.frames));
            ++dragging_->frame;
            return true;
        }
        app_.end_drag();
        dragging_.reset();
    }
    if (!waiting_) return false;
    switch (waiting_->kind) {
        case WaitKind::frames:
            if (waiting_->left-- > 0) return true;
            break;
        case WaitKind::seconds:
            if (seconds_since(waiting_->since) < waiting_->left) return true;
            idle_cpu_ = 100 * (process_cpu_seconds() - waiting_->cpu_since) /
                        seconds_since(waiting_->since);
            break;
        case WaitKind::rest:
            // What has changed is drawn in the next frame: until then the picture looks at rest.
            if (waiting_->left-- > 0 || !app_.at_rest()) return true;
            break;
    }
    waiting_.reset();
    return false;
}

bool ScriptRunner::needs_frame() const {
    return !app_.loading() && (!waiting_ || waiting_->kind != WaitKind::seconds);
}

bool ScriptRunner::done() const {
    return next_ >= commands_.size() && !waiting_ && !dragging_ && !generating_ && !screenshot_ &&
           !app_.loading() && errors_ == app_.errors_said();
}

// Whether the command in work was tried, or `expect error = TEXT` follows it.
bool ScriptRunner::may_go_on(const std::string& text) {
    if (may_fail_) return true;
    if (next_ >= commands_.size()) return false;
    const auto* expected = std::get_if<ExpectCommand>(&commands_[next_].action);
    if (expected == nullptr || expected->name != "error") return false;
    line_ = commands_[next_++].line;
    if (text.find(expected->value) == std::string::npos)
        fail(fmt::format("expected an error with {}, found {}", shown(expected->value),
                         shown(text)));
    return true;
}

// Errors that were said since the last look belong to the command in work.
void ScriptRunner::settle_errors() {
    while (errors_ < app_.errors_said()) {
        errors_ = app_.errors_said();
        if (may_go_on(app_.last_error())) continue;
        if (line_ == 0) throw Error(app_.last_error());  // of a file of the command line
        fail(app_.last_error());
    }
}

void ScriptRunner::run() {
    if (!app_.document().input.empty()) {
        if (first_picture_s_ < 0 && app_.picture.has_shown()) first_picture_s_ = process_age_s();
        if (whole_picture_s_ < 0 && app_.picture.samples() > 0) whole_picture_s_ = process_age_s();
    }
    while (!still_busy()) {
        settle_errors();
        if (next_ >= commands_.size()) return;
        const Command& command = commands_[next_++];
        line_ = command.line;
        may_fail_ = command.may_fail;
        try {
            execute(command);
        } catch (const Error& error) {
            const std::string what = error.what();
            if (may_go_on(what)) continue;
            if (what.starts_with(name_ + ": line")) throw;
            fail(what);
        }
    }
}

void ScriptRunner::after_draw() {
    const Clock::time_point now = Clock::now();
    // The first frame of a drag begins its time.
    const double cpu_s = process_cpu_seconds();
    const bool dragging = dragging_ || (mouse_command_ && mouse_command_->button >= 0);
    if (dragging && last_drag_frame_) {
        drag_frames_s_.push_back(std::chrono::duration<double>(now - *last_drag_frame_).count());
        drag_cpu_s_ += cpu_s - last_cpu_s_;
    }
    last_cpu_s_ = cpu_s;
    last_drag_frame_.reset();
    if (dragging) last_drag_frame_ = now;
    if (changed_ && app_.picture.samples() > 0) {
        change_s_ = seconds_since(*changed_);
        changed_.reset();
    }
    if (!screenshot_) return;
    save_screenshot(app_.window, *screenshot_);
    screenshot_.reset();
}

void ScriptRunner::forget_drag() {
    drag_frames_s_.clear();
    drag_cpu_s_ = 0;
    last_drag_frame_.reset();
}

double ScriptRunner::measured(const std::string& name) const {
    const auto fps = [&](double seconds) { return seconds > 0 ? 1 / seconds : 0; };
    if (name == "fps")
        return drag_frames_s_.empty()
                   ? 0
                   : fps(std::accumulate(drag_frames_s_.begin(), drag_frames_s_.end(), 0.0) /
                         static_cast<double>(drag_frames_s_.size()));
    if (name == "fps_min")
        return drag_frames_s_.empty() ? 0 : fps(*std::ranges::max_element(drag_frames_s_));
    // Of all threads, of a frame of the last drag: what other programs do changes it little.
    if (name == "frame_cpu_ms")
        return 1000 * drag_cpu_s_ /
               static_cast<double>(std::max<std::size_t>(drag_frames_s_.size(), 1));
    if (name == "drawn_samples") return app_.picture.samples();
    if (name == "scale") return app_.picture.scale();
    if (name == "idle_cpu") return idle_cpu_.value_or(0);
    if (name == "first_picture_s") return first_picture_s_;
    if (name == "whole_picture_s") return whole_picture_s_;
    if (name == "change_s") return change_s_;
    if (name == "recovered") return was_recoverable_ ? 1 : 0;
    if (name == "window_width") return app_.window.width();
    if (name == "window_height") return app_.window.height();
    if (name == "materials") return static_cast<double>(app_.scene().materials.size());
    if (name == "scene_triangles") return triangles_of(app_.scene());
    if (name == "undo_count") return static_cast<double>(app_.editor.history().undo_count());
    if (name == "redo_count") return static_cast<double>(app_.editor.history().redo_count());
    if (name == "bookmarks") return static_cast<double>(app_.document().bookmarks.size());
    if (name == "objects") return static_cast<double>(app_.scene().instances.size());
    if (name == "objects_shown")
        return static_cast<double>(std::ranges::count_if(
            app_.scene().instances, [](const Instance& i) { return i.mesh >= 0; }));
    if (name == "lights_on")
        return static_cast<double>(std::ranges::count_if(
            app_.scene().lights, [](const Light& l) { return l.intensity > 0; }));
    if (name == "selected_material") return app_.material.value_or(-1);
    if (name == "selected_object") return app_.object.value_or(-1);
    if (name == "lights") return static_cast<double>(app_.scene().lights.size());
    if (name == "warnings") return static_cast<double>(app_.editor.warnings().size());
    if (name == "flip" || name == "difference") return app_.compared.mean();
    if (name == "preview_ms") return app_.generator.preview_ms();
    if (name == "memory_mb") return resident_memory_mb();
    if (name.starts_with("cost.")) {
        if (!app_.costs.measuring())
            fail(fmt::format("expected the panel costs open for {}, found it closed", shown(name)));
        if (const auto ms = app_.costs.ms(name.substr(5))) return *ms;
    }
    if (name.starts_with("picked.")) {
        if (!app_.picked)
            fail(fmt::format("expected a picked point for {}, found none", shown(name)));
        const LobeReport& r = app_.picked->report;
        const std::string key = name.substr(7);
        if (key == "tilt") return r.tilt_deg;
        if (key == "alpha_x") return r.alpha.x;
        if (key == "alpha_y") return r.alpha.y;
        if (key == "grain") return r.grain_deg.value_or(-1);
        // picked.KEY or picked.METHOD.KEY
        const std::size_t dot = key.rfind('.');
        const std::string method = dot == std::string::npos ? "" : key.substr(0, dot);
        const std::string what = dot == std::string::npos ? key : key.substr(dot + 1);
        for (const MethodReport& m : r.methods) {
            if (!method.empty() && name_of(m.method) != method) continue;
            if (what == "D") return m.D;
            if (what == "G") return m.G;
            if (what == "f") return m.f.x;
            if (what == "highlight_error") return m.highlight_error_deg;
            break;
        }
    }
    fail(fmt::format("expected a measurement or a parameter, found {}", shown(name)));
}

void ScriptRunner::log(const std::string& name) const {
    std::string text;
    if (name == "command_line") {
        text = app_.command_line().text();
    } else if (name == "title") {
        text = app_.title();
    } else if (name == "message") {
        if (!app_.messages.empty()) text = app_.messages.back().text;
    } else if (name == "missing_files") {
        text = app_.missing_files();
    } else if (const Parameter* parameter = find_parameter(name)) {
        const auto value =
            value_in_effect(app_.document(), app_.editor.stage(), name, app_.material).value;
        text = value ? text_of(*parameter, *value) : "the input's";
    } else {
        text = fmt::format("{:.6g}", measured(name));
    }
    std::printf("%s %s\n", name.c_str(), one_line(text).c_str());
    std::fflush(stdout);
}

void ScriptRunner::expect(const ExpectCommand& command) {
    static constexpr std::array<std::string_view, 6> kSigns = {"=", "!=", "<", "<=", ">", ">="};
    const std::string wanted =
        fmt::format("{} {} {}", command.name, kSigns[static_cast<std::size_t>(command.comparison)],
                    command.value);
    if (command.name == "error") fail("expected an error of the command before, found none");
    if (find_parameter(command.name) != nullptr) {
        const auto value =
            value_in_effect(app_.document(), app_.editor.stage(), command.name, app_.material)
                .value;
        const std::string text = value ? text_of(*find_parameter(command.name), *value) : "";
        if (!meets(command, text) &&
            !(command.number && value && std::holds_alternative<double>(*value) &&
              meets(command, std::get<double>(*value))))
            fail(fmt::format("expected {}, found {}", wanted, shown(text)));
        return;
    }
    const double found = measured(command.name);
    if (!meets(command, found)) fail(fmt::format("expected {}, found {:.6g}", wanted, found));
}

void ScriptRunner::generate(const GenerateCommand& command) {
    app_.generator.change(app_, [&](ScratchChoice& choice) {
        if (command.preset) choice = scratch_choice(*command.preset);
        ScratchSettings& settings = choice.recipe.settings;
        ScratchLayer& layer = settings.layers.front();
        choice.amount = command.amount.value_or(choice.amount);
        choice.strength = command.strength.value_or(choice.strength);
        if (command.seed) settings.seed = static_cast<std::uint32_t>(*command.seed);
        settings.size = command.size.value_or(settings.size);
        settings.tile_mm = command.tile_mm.value_or(settings.tile_mm);
        layer.angle_deg = command.angle_deg.value_or(layer.angle_deg);
        layer.range_deg = command.range_deg.value_or(layer.range_deg);
        if (command.length_mm) set_typical(layer.length_mm, *command.length_mm);
        if (command.width_mm) set_typical(layer.width_mm, *command.width_mm);
        if (command.depth_mm) set_typical(layer.depth_mm, *command.depth_mm);
    });
    if (!app_.generator.fault().empty()) fail(app_.generator.fault());
    app_.note_motion();
    app_.generator.finish();
    generating_ = true;
}

std::optional<int> ScriptRunner::find_material(const std::string& word) const {
    const auto& materials = app_.scene().materials;
    for (std::size_t i = 0; i < materials.size(); ++i)
        if (materials[i].name == word || word == fmt::format("#{}", i)) return static_cast<int>(i);
    return std::nullopt;
}

int ScriptRunner::required_material(const std::string& word) const {
    if (const auto found = find_material(word)) return *found;
    fail(fmt::format("expected a material of the scene, found {}", shown(word)));
}

void ScriptRunner::compare(const CompareCommand& command) {
    if (!command.methods.empty()) return app_.compare_methods(command.methods, command.mode);
    if (!command.materials) {
        app_.edit({}, "compare", [&](Document& d) { d.compare.mode = command.mode; });
        return;
    }
    const int first = required_material(command.materials->first);
    const std::string& word = command.materials->second;
    const std::optional<int> second = find_material(word);
    app_.compare_materials({first, second ? fmt::format("#{}", *second) : absolute_name(word)},
                           command.mode);
}

void ScriptRunner::execute(const Command& command) {
    const auto material_of = [&](const std::optional<std::string>& word) -> std::optional<int> {
        if (!word) return std::nullopt;
        return required_material(*word);
    };
    const auto in_picture = [&](double x, double y) {
        return glm::dvec2(x - app_.picture_x, y - app_.picture_y);
    };
    std::visit(
        [&](const auto& c) {
            using T = std::decay_t<decltype(c)>;
            if constexpr (std::is_same_v<T, OpenCommand>) {
                app_.open(c.files);
            } else if constexpr (std::is_same_v<T, SetCommand>) {
                const auto material = material_of(c.material);
                app_.edit(c.name, c.name,
                          [&](Document& d) { set_parameter_text(d, c.name, c.value, material); });
                app_.editor.close_step();
                changed_ = Clock::now();
            } else if constexpr (std::is_same_v<T, UnsetCommand>) {
                const auto material = material_of(c.material);
                app_.edit({}, c.name,
                          [&](Document& d) { viewer::unset_parameter(d, c.name, material); });
            } else if constexpr (std::is_same_v<T, LightCommand>) {
                app_.edit({}, "light", [&](Document& d) {
                    d.lights.emplace();
                    d.dark.clear();
                    if (c.light) d.lights->push_back(*c.light);
                });
            } else if constexpr (std::is_same_v<T, EnvironmentCommand>) {
                app_.set_environment(c.name);
            } else if constexpr (std::is_same_v<T, DragCommand>) {
                forget_drag();
                dragging_ = Dragging{c, 0};
            } else if constexpr (std::is_same_v<T, MoveCommand>) {
                mouse_ = glm::dvec2(c.x, c.y);
                waiting_ = Waiting{WaitKind::frames, 1, Clock::now(), 0};
            } else if constexpr (std::is_same_v<T, ClickCommand>) {
                mouse_ = glm::dvec2(c.x, c.y);
                click_step_ = 3;
                click_shift_ = c.shift;
                waiting_ = Waiting{WaitKind::frames, 2, Clock::now(), 0};
            } else if constexpr (std::is_same_v<T, MouseCommand>) {
                if (!mouse_) fail("expected the mouse somewhere (move X Y), found it nowhere");
                forget_drag();
                mouse_command_ = c;
                mouse_frame_ = 0;
                waiting_ = Waiting{WaitKind::frames, frames_of(c) + 1.0, Clock::now(), 0};
            } else if constexpr (std::is_same_v<T, TypeCommand>) {
                if (!ImGui::GetIO().WantTextInput)
                    fail("expected a text field that has the keyboard (click one), found none");
                type_command_ = c;
                type_frame_ = 0;
                waiting_ = Waiting{WaitKind::frames, 5, Clock::now(), 0};
            } else if constexpr (std::is_same_v<T, NavigationCommand>) {
                Remembered& r = app_.remembered;
                r.navigation = c.navigation.value_or(r.navigation);
                r.touchpad = c.touchpad.value_or(r.touchpad);
            } else if constexpr (std::is_same_v<T, KeyCommand>) {
                if (!press_key(app_, c.keys))
                    fail(
                        fmt::format("expected a key of the list under ?, found {}", shown(c.keys)));
            } else if constexpr (std::is_same_v<T, WaitCommand>) {
                const double left = c.kind == WaitKind::rest ? 1 : c.amount;
                waiting_ = Waiting{c.kind, left, Clock::now(), process_cpu_seconds()};
            } else if constexpr (std::is_same_v<T, PickCommand>) {
                app_.pick(in_picture(c.x, c.y));
                if (!app_.picked) fail("expected a surface there, found the background");
            } else if constexpr (std::is_same_v<T, CompareCommand>) {
                compare(c);
                waiting_ = Waiting{WaitKind::frames, 1, Clock::now(), 0};
            } else if constexpr (std::is_same_v<T, ViewCommand>) {
                const auto names = surface_view_names();
                const auto found = std::ranges::find(names, c.name);
                if (found == names.end())
                    fail(fmt::format("expected a view ({}), found {}", fmt::join(names, ", "),
                                     shown(c.name)));
                app_.view = static_cast<SurfaceView>(found - names.begin());
                waiting_ = Waiting{WaitKind::frames, 1, Clock::now(), 0};
            } else if constexpr (std::is_same_v<T, PanelCommand>) {
                bool* panel = app_.panels.find(c.name);
                if (panel == nullptr)
                    fail(fmt::format("expected a panel ({}), found {}",
                                     fmt::join(Panels::names(), ", "), shown(c.name)));
                *panel = c.open;
                waiting_ = Waiting{WaitKind::frames, 2, Clock::now(), 0};
            } else if constexpr (std::is_same_v<T, GenerateCommand>) {
                generate(c);
            } else if constexpr (std::is_same_v<T, SceneCommand>) {
                change_scene(c);
                waiting_ = Waiting{WaitKind::frames, 1, Clock::now(), 0};
            } else if constexpr (std::is_same_v<T, UndoCommand>) {
                for (int i = 0; i < c.steps; ++i) app_.undo();
            } else if constexpr (std::is_same_v<T, RedoCommand>) {
                for (int i = 0; i < c.steps; ++i) app_.redo();
            } else if constexpr (std::is_same_v<T, SaveCommand>) {
                if (c.kind == SaveKind::scene) app_.save_scene(c.file);
                if (c.kind == SaveKind::picture) app_.save_picture(c.file, c.size);
                if (c.kind == SaveKind::gltf) app_.save_gltf(c.file);
                if (c.kind == SaveKind::maps) app_.save_maps(c.file);
            } else if constexpr (std::is_same_v<T, TurntableCommand>) {
                app_.save_turntable(c.file, c.frames, c.turn);
            } else if constexpr (std::is_same_v<T, ScreenshotCommand>) {
                screenshot_ = c.file;
            } else if constexpr (std::is_same_v<T, ExpectCommand>) {
                expect(c);
            } else if constexpr (std::is_same_v<T, LogCommand>) {
                for (const std::string& name : c.names) log(name);
            } else if constexpr (std::is_same_v<T, ResizeCommand>) {
                app_.window.resize(c.size.width, c.size.height);
                waiting_ = Waiting{WaitKind::frames, 3, Clock::now(), 0};
            } else if constexpr (std::is_same_v<T, QuitCommand>) {
                if (process_age_s() < c.after_s) return;
                app_.window.close();
                next_ = commands_.size();
            }
        },
        command.action);
}

}  // namespace burnish::viewer
