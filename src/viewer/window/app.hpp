// The session of a window: what is open, what is selected, and everything that a person can do. Panels
// and scripts call the same functions.
//
// Threads: the main thread. Lifetime: destroy it before the window.
#pragma once

#include <chrono>
#include <deque>
#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/document/command_line.hpp"
#include "viewer/document/editor.hpp"
#include "viewer/document/keep.hpp"
#include "viewer/inspect/inspector.hpp"
#include "viewer/inspect/pick.hpp"
#include "viewer/script/script.hpp"
#include "viewer/window/background.hpp"
#include "viewer/window/compared.hpp"
#include "viewer/window/costs.hpp"
#include "viewer/window/generator.hpp"
#include "viewer/window/picture.hpp"
#include "viewer/window/window.hpp"

namespace burnish::viewer {

// A line for the person, shown for a while and kept in the list of messages.
struct Message {
    std::string text;
    bool is_error = false;
    std::chrono::steady_clock::time_point since;
};

// Which panels are open. The names are those of scripts and of the remembered state.
struct Panels {
    bool parameters = true, scene = true, compare = false, inspector = false, messages = false,
         keys = false, costs = false, generator = false;
    bool* find(std::string_view name);  // nullptr: none of this name
    static std::span<const std::string_view> names();
};

struct Picked {
    Hit hit;
    glm::dvec2 pixel{0.0};  // of the picture, when it was picked
    LobeReport report;
    std::vector<LobeAlbedo> albedos;  // one a method
};

// What the mouse does in the picture while a button is down.
enum class Drag { none, orbit, pan, zoom, light, environment, highlight };

class App {
  public:
    App(Window& window, gpu::Context& context, std::filesystem::path state_folder);
    ~App();
    App(const App&) = delete;
    App& operator=(const App&) = delete;

    // --- files
    void open_first(std::vector<std::string> paths);  // of the command line
    void open(const std::vector<std::string>& paths);
    void open_document(Document document, const std::string& name);
    void save_scene(const std::filesystem::path& path);
    void save_picture(const std::filesystem::path& path, std::optional<Size> size);
    void save_turntable(const std::filesystem::path& path, int frames);
    void save_gltf(const std::filesystem::path& folder);
    // The folder that `burnish scratch` or `burnish weave` makes with the material's settings.
    void save_maps(const std::filesystem::path& folder);
    void copy_command_line();
    // Of `burnish render`, for the scene as it was saved last.
    CommandLine command_line() const;
    bool loading() const { return loader_.running(); }
    Background& loader() { return loader_; }

    // --- changes. `key` joins the changes of one drag into a step; errors become messages.
    bool edit(std::string_view key, std::string_view name,
              const std::function<void(Document&)>& change);
    void set_parameter(std::string_view name, const ParameterValue& value);
    void unset_parameter(std::string_view name);
    // The document's camera becomes this one.
    void move_camera(const Camera& camera, std::string_view key, std::string_view name);
    void undo() { step_history(false); }
    void redo() { step_history(true); }

    // --- moves; pixels are those of the picture, in device pixels
    void drag(Drag kind, glm::dvec2 by_px);
    void end_drag();
    void note_motion();  // the picture is quick rather than fine for a while
    void zoom_at(glm::dvec2 pixel, double steps);
    void frame_all();
    void put_highlight(glm::dvec2 pixel);
    void pick(glm::dvec2 pixel);
    void pick_again();  // the same surface point after a change
    WindowSize picture_size() const { return {picture_width, picture_height}; }
    // The light that is dragged: the selected one; a first one is made where there is none.
    int dragged_light();

    // --- messages
    void say(std::string text, bool is_error = false);
    std::size_t errors_said() const { return errors_said_; }
    const std::string& last_error() const { return last_error_; }
    // Whether the last message is shown in the status bar.
    bool has_fresh_message() const;

    // --- once a frame
    void update();              // settles background work, uploads changes, follows files
    bool needs_frames() const;  // something moves or refines
    // Something changes now and then: progress, a blink, the end of a message.
    bool needs_slow_frames() const;
    // The picture is refined, or the device has refused it.
    bool at_rest() const;
    void reload_shaders();
    // Refines the picture for about `budget_s`. A device that refuses is said once, until the document
    // changes.
    void draw_picture(double budget_s);
    void count_frame();  // after each frame that was shown

    Window& window;
    gpu::Context& context;
    Editor editor;
    Picture picture;
    Costs costs;
    Generator generator;
    Remembered remembered;
    Panels panels;
    std::filesystem::path state_folder;
    std::deque<Message> messages;

    SurfaceView view = SurfaceView::radiance;
    std::optional<int> material;  // selected: parameters are of this one, else of all
    int light = 0;                // selected
    std::string search;           // of the parameters
    std::optional<Picked> picked;
    Compared compared;
    // "Before" of a comparison with what is shown now: materials and model as they were when hold() was
    // called, under the present camera, light and exposure.
    std::unique_ptr<Editor> before;
    std::unique_ptr<Picture> before_picture;
    void hold();             // what is shown now becomes the "before"
    void release();          // there is none
    bool turntable = false;  // turns by itself
    bool show_panels = true;
    double ui_scale = 1.0;
    int picture_x = 0, picture_y = 0;  // upper left corner in the window
    int picture_width = 1, picture_height = 1;
    double frames_per_second = 0, lowest_frames_per_second = 0;
    std::optional<LeftBehind> recovered;  // an autosave that is offered

    const Document& document() const { return editor.document(); }
    const Scene& scene() const { return editor.stage().scene; }

  private:
    void load(Document document, std::string name, std::function<void(Document, Stage)> adopt);
    void after_change();
    void step_history(bool forward);
    void autosave_now_and_then();
    void follow_files();
    void report_new_warnings();

    Background loader_;
    Picker picker_;
    std::optional<Revisions> picker_revisions_, picked_revisions_;
    Drag dragging_ = Drag::none;
    std::chrono::steady_clock::time_point last_motion_{}, last_autosave_{}, last_look_{},
        last_turn_{};
    std::vector<std::pair<std::string, std::filesystem::file_time_type>> watched_;
    std::string saved_scene_;
    std::optional<Document> autosaved_;
    std::size_t errors_said_ = 0;
    std::string last_error_;
    bool message_shown_ = false;        // in the last frame
    std::optional<Revisions> refused_;  // those that the device could not draw
    std::chrono::steady_clock::time_point last_frame_{};
};

}  // namespace burnish::viewer
