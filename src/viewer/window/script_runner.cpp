#include "viewer/window/script_runner.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <imgui.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <numeric>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/machine.hpp"
#include "scene/parameters/parameter_text.hpp"
#include "viewer/window/panels.hpp"

namespace burnish::viewer {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point t) {
    return std::chrono::duration<double>(Clock::now() - t).count();
}

// Of the process, now; 0 where the kernel does not say.
double resident_memory_mb() {
    std::ifstream in("/proc/self/statm");
    double pages = 0, resident = 0;
    in >> pages >> resident;
    return in ? resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6 : 0;
}

Drag drag_of(DragKind kind) {
    switch (kind) {
        case DragKind::orbit: return Drag::orbit;
        case DragKind::pan: return Drag::pan;
        case DragKind::zoom: return Drag::zoom;
        case DragKind::light: return Drag::light;
        case DragKind::environment: return Drag::environment;
    }
    return Drag::none;
}

}  // namespace

void save_screenshot(const Window& window, const std::string& file) {
    const int width = window.width(), height = window.height();
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
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
    : app_(app), commands_(std::move(commands)), name_(std::move(name)) {}

void ScriptRunner::fail(const std::string& what) const {
    throw Error(fmt::format("{}: line {}: {}", name_, line_, what));
}

void ScriptRunner::feed_input() {
    if (!mouse_) return;
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {static_cast<float>(mouse_->x), static_cast<float>(mouse_->y)};
    io.MouseDown[0] = click_step_ == 3 || click_step_ == 2;
    io.KeyShift = click_shift_;
    if (click_step_ > 0 && --click_step_ == 0) click_shift_ = false;
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
            idle_cpu_ = 100 * (process_cpu_seconds() - waiting_->cpu_since) / seconds_since(waiting_->since);
            break;
        case WaitKind::rest:
            if (!app_.picture.at_rest()) return true;
            break;
    }
    waiting_.reset();
    return false;
}

bool ScriptRunner::needs_frame() const {
    return !waiting_ || waiting_->kind != WaitKind::seconds;
}

void ScriptRunner::run() {
    if (first_picture_s_ < 0 && app_.picture.samples() > 0) first_picture_s_ = seconds_since(start_);
    while (!still_busy() && next_ < commands_.size()) {
        const Command& command = commands_[next_++];
        line_ = command.line;
        const std::size_t errors = app_.messages.size();
        try {
            execute(command);
        } catch (const Error& error) {
            const std::string what = error.what();
            if (what.starts_with(name_ + ": line")) throw;
            fail(what);
        }
        for (std::size_t i = errors; i < app_.messages.size(); ++i)
            if (app_.messages[i].is_error) fail(app_.messages[i].text);
    }
}

void ScriptRunner::after_draw(double frame_s) {
    if (dragging_ && dragging_->frame > 1) drag_frames_s_.push_back(frame_s);
    if (!screenshot_) return;
    save_screenshot(app_.window, *screenshot_);
    screenshot_.reset();
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
    if (name == "samples") return app_.picture.samples();
    if (name == "scale") return app_.picture.scale();
    if (name == "idle_cpu") return idle_cpu_.value_or(0);
    if (name == "first_picture_s") return first_picture_s_;
    if (name == "undo_count") return static_cast<double>(app_.editor.history().undo_count());
    if (name == "redo_count") return static_cast<double>(app_.editor.history().redo_count());
    if (name == "lights") return static_cast<double>(app_.scene().lights.size());
    if (name == "warnings") return static_cast<double>(app_.editor.warnings().size());
    if (name == "flip" || name == "difference") return app_.compared.mean();
    if (name == "preview_ms") return app_.generator.preview_ms();
    if (name == "memory_mb") return resident_memory_mb();
    if (name.starts_with("picked.")) {
        if (!app_.picked) fail(fmt::format("expected a picked point for {}, found none", shown(name)));
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

void ScriptRunner::expect(const ExpectCommand& command) {
    if (find_parameter(command.name) != nullptr) {
        const auto value = parameter_of(app_.document(), command.name, app_.material);
        const std::string text = value ? text_of(*find_parameter(command.name), *value) : "";
        if (!meets(command, text) && !(command.number && value && std::holds_alternative<double>(*value) &&
                                       meets(command, std::get<double>(*value))))
            fail(fmt::format("expected {} {}, found {}", command.name, command.value, shown(text)));
        return;
    }
    const double found = measured(command.name);
    if (!meets(command, found))
        fail(fmt::format("expected {} {}, found {:.6g}", command.name, command.value, found));
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

void ScriptRunner::execute(const Command& command) {
    const auto material_of = [&](const std::optional<std::string>& word) -> std::optional<int> {
        if (!word) return std::nullopt;
        const auto& materials = app_.scene().materials;
        for (std::size_t i = 0; i < materials.size(); ++i)
            if (materials[i].name == *word || *word == fmt::format("#{}", i)) return static_cast<int>(i);
        fail(fmt::format("expected a material of the scene, found {}", shown(*word)));
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
                app_.edit(c.name, c.name, [&](Document& d) { set_parameter_text(d, c.name, c.value, material); });
                app_.editor.close_step();
            } else if constexpr (std::is_same_v<T, UnsetCommand>) {
                const auto material = material_of(c.material);
                app_.edit({}, c.name, [&](Document& d) { viewer::unset_parameter(d, c.name, material); });
            } else if constexpr (std::is_same_v<T, LightCommand>) {
                app_.edit({}, "light", [&](Document& d) {
                    d.lights.emplace();
                    if (c.light) d.lights->push_back(*c.light);
                });
            } else if constexpr (std::is_same_v<T, EnvironmentCommand>) {
                app_.edit({}, "environment", [&](Document& d) { d.environment = c.name; });
            } else if constexpr (std::is_same_v<T, DragCommand>) {
                drag_frames_s_.clear();
                dragging_ = Dragging{c, 0};
            } else if constexpr (std::is_same_v<T, MoveCommand>) {
                mouse_ = glm::dvec2(c.x, c.y);
                waiting_ = Waiting{WaitKind::frames, 1, Clock::now(), 0};
            } else if constexpr (std::is_same_v<T, ClickCommand>) {
                mouse_ = glm::dvec2(c.x, c.y);
                click_step_ = 3;
                click_shift_ = c.shift;
                waiting_ = Waiting{WaitKind::frames, 2, Clock::now(), 0};
            } else if constexpr (std::is_same_v<T, KeyCommand>) {
                if (!press_key(app_, c.keys)) fail(fmt::format("expected a key of the list under ?, found {}", shown(c.keys)));
            } else if constexpr (std::is_same_v<T, WaitCommand>) {
                waiting_ = Waiting{c.kind, c.amount, Clock::now(), process_cpu_seconds()};
            } else if constexpr (std::is_same_v<T, PickCommand>) {
                app_.pick(in_picture(c.x, c.y));
                if (!app_.picked) fail("expected a surface there, found the background");
            } else if constexpr (std::is_same_v<T, CompareCommand>) {
                app_.edit({}, "compare", [&](Document& d) {
                    d.compare.mode = c.mode;
                    if (!c.methods.empty()) {
                        d.compare.methods = c.methods;
                        d.compare.dividers.clear();
                    }
                });
                waiting_ = Waiting{WaitKind::frames, 1, Clock::now(), 0};
            } else if constexpr (std::is_same_v<T, ViewCommand>) {
                const auto names = surface_view_names();
                const auto found = std::ranges::find(names, c.name);
                if (found == names.end())
                    fail(fmt::format("expected a view ({}), found {}", fmt::join(names, ", "), shown(c.name)));
                app_.view = static_cast<SurfaceView>(found - names.begin());
                waiting_ = Waiting{WaitKind::frames, 1, Clock::now(), 0};
            } else if constexpr (std::is_same_v<T, PanelCommand>) {
                bool* panel = app_.panels.find(c.name);
                if (panel == nullptr)
                    fail(fmt::format("expected a panel ({}), found {}", fmt::join(Panels::names(), ", "), shown(c.name)));
                *panel = c.open;
                waiting_ = Waiting{WaitKind::frames, 2, Clock::now(), 0};
            } else if constexpr (std::is_same_v<T, GenerateCommand>) {
                generate(c);
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
                app_.save_turntable(c.file, c.frames);
            } else if constexpr (std::is_same_v<T, ScreenshotCommand>) {
                screenshot_ = c.file;
            } else if constexpr (std::is_same_v<T, ExpectCommand>) {
                expect(c);
            } else if constexpr (std::is_same_v<T, ResizeCommand>) {
                app_.window.resize(c.size.width, c.size.height);
                waiting_ = Waiting{WaitKind::frames, 3, Clock::now(), 0};
            } else if constexpr (std::is_same_v<T, QuitCommand>) {
                app_.window.close();
                next_ = commands_.size();
            }
        },
        command.action);
}

}  // namespace burnish::viewer
