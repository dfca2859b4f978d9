#include "viewer/window/app.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "burnish/error.hpp"
#include "gpu/device/program.hpp"
#include "viewer/document/load_stage.hpp"
#include "viewer/document/open_files.hpp"
#include "viewer/motion/orbit.hpp"
#include "viewer/window/app_parts.hpp"

namespace burnish::viewer {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kAutosave_s = 30.0;
constexpr double kSettle_s = 0.2;  // after the last motion the picture refines
constexpr std::size_t kMostMessages = 200;
constexpr double kMessage_s = 6.0;  // in the status bar
constexpr double kTurn_s = 12.0;    // a turn of the turntable

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
    : window(w),
      context(c),
      picture(c),
      costs(c),
      generator(folder),
      state_folder(std::move(folder)) {
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
    last_look_ = Clock::now();
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
    if (keeps_autosave_) return;
    remove_autosave(state_folder);
    std::error_code error;
    if (!opened_recovery_.empty()) std::filesystem::remove(opened_recovery_, error);
}

void App::recover(Recovery choice) {
    if (!recovered) return say("no scene of an earlier session is offered", true);
    const std::filesystem::path file = recovered->file;
    recovered.reset();
    std::error_code error;
    if (choice == Recovery::remove) std::filesystem::remove(file, error);
    if (choice != Recovery::open) return;
    opened_recovery_ = file;
    load(document_for(std::vector{file.string()}), "recovered scene",
         [this](Document d, Stage stage) {
             editor.set_loaded(std::move(d), std::move(stage), "recover");
             material.reset();
             picked.reset();
         });
}

void App::require_context() {
    if (!window.context_was_reset()) return;
    std::string kept = "nothing was changed";
    if (!state_folder.empty() && editor.history().can_undo()) {
        autosave(state_folder, document(), editor.stage(), name_of_scene().path);
        keeps_autosave_ = true;
        kept = "the scene is kept, and the next start offers it";
    }
    throw Error("burnish view", "graphics device", "one that goes on",
                "a reset of the device or its driver: " + kept);
}

void App::say(std::string text, bool is_error) {
    if (is_error) {
        ++errors_said_;
        last_error_ = text;
    }
    messages.push_back({std::move(text), is_error, Clock::now()});
    if (messages.size() > kMostMessages) messages.pop_front();
}

bool App::has_fresh_message() const {
    return !messages.empty() && seconds_since(messages.back().since) < kMessage_s;
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
    const std::vector<ParameterValues> before = editor.stage().materials.values();
    const bool done = edit(name, name, [&](Document& d) {
        viewer::set_parameter(d, name, value, own ? material : std::nullopt);
    });
    if (done && std::holds_alternative<std::string>(value)) say_taken_back(before);
    // What is chosen shows at once as it is at rest, for which its programs were compiled (WarmUp); what is
    // dragged moves.
    if (!std::holds_alternative<ParameterChoice>(value)) last_motion_ = Clock::now();
}

void App::unset_parameter(std::string_view name) {
    const Parameter* parameter = find_parameter(name);
    const bool own = parameter != nullptr && parameter->group == ParameterGroup::material;
    edit({}, name,
         [&](Document& d) { viewer::unset_parameter(d, name, own ? material : std::nullopt); });
}

void App::step_history(bool forward) {
    generator.cancel(*this);
    const char* name = forward ? "redo" : "undo";
    const History& history = editor.history();
    const std::shared_ptr<const Document> to =
        forward ? history.redo_document() : history.undo_document();
    if (!to) return say(fmt::format("nothing to {}", name));
    try {
        if (needs_load(document(), *to)) {
            load(*to, name, [this, forward](const Document&, Stage stage) {
                forward ? editor.redo_loaded(std::move(stage))
                        : editor.undo_loaded(std::move(stage));
            });
            return;
        }
        forward ? editor.redo() : editor.undo();
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
    if (object && static_cast<std::size_t>(*object) >= scene().instances.size()) object.reset();
}

// --- once a frame ---------------------------------------------------------------------------------

bool App::needs_frames() const {
    const auto idles = [](const Picture& p) { return p.at_rest() || p.waits(); };
    const bool idle = at_rest() || (idles(picture) && (!shows_second() || idles(second->picture)));
    return !idle || turntable || generator.working() ||
           seconds_since(last_motion_) < kSettle_s + 0.1 || dragging_ != Drag::none;
}

bool App::needs_slow_frames() const {
    return loader_.running() || picture.prepares() || picture.waits() ||
           document().compare.mode == CompareMode::blink || has_fresh_message() != message_shown_;
}

// Nothing is open until the first file is read.
bool App::at_rest() const {
    return document().input.empty() || refused_ == editor.revisions() ||
           (picture.at_rest() && (!shows_second() || second->picture.at_rest()));
}

void App::update() {
    loader_.poll();
    fit_rig();
    if (turntable) {
        const double step = std::min(seconds_since(last_turn_), 0.2);
        if (step > 0 && !scene().instances.empty()) {
            const Camera moved =
                orbited_by(editor.stage().camera, glm::dvec3(editor.stage().camera.target),
                           glm::two_pi<double>() * step / kTurn_s, 0);
            move_camera(moved, "camera", "turntable");
        }
        last_motion_ = Clock::now();
    }
    last_turn_ = Clock::now();
    generator.settle(*this);
    if (refused_ != editor.revisions()) {
        try {
            editor.set_aspect(static_cast<double>(picture_width) / picture_height);
            picture.follow(editor);
            if (second) second->follow(editor);
        } catch (const std::exception& error) {
            say(one_line(error.what()), true);
            refused_ = editor.revisions();  // said once
        }
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
    const bool moving = seconds_since(last_motion_) < kSettle_s || dragging_ != Drag::none;
    picture.set_moving(moving);
    if (second) second->picture.set_moving(moving);
    follow_files();
    name_window();
    autosave_now_and_then();
}

void App::draw_picture(double budget_s) {
    costs.follow(panels.costs, picture);
    if (refused_ == editor.revisions()) return;
    try {
        picture.refine(budget_s);
        if (shows_second()) second->picture.refine(budget_s);
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
    message_shown_ = has_fresh_message();
    if (period > 0.5) return;  // the window was at rest
    const double now = 1 / std::max(period, 1e-4);
    // A mean over about ten frames.
    frames_per_second = frames_per_second > 0 ? 0.9 * frames_per_second + 0.1 * now : now;
    if (dragging_ != Drag::none)
        lowest_frames_per_second =
            lowest_frames_per_second > 0 ? std::min(lowest_frames_per_second, now) : now;
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

void App::autosave_now_and_then() {
    if (state_folder.empty() || seconds_since(last_autosave_) < kAutosave_s) return;
    // Nothing to lose, or nothing new. The first change is kept at once.
    if (!editor.history().can_undo() || autosaved_ == document()) return;
    if (dragging_ != Drag::none) return;
    last_autosave_ = Clock::now();
    try {
        autosave(state_folder, document(), editor.stage(), name_of_scene().path);
        autosaved_ = document();
    } catch (const Error& error) {
        say(error.what(), true);
    }
}

}  // namespace burnish::viewer
