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
#include "viewer/document/watched_files.hpp"
#include "viewer/inspect/inspector.hpp"
#include "viewer/inspect/pick.hpp"
#include "viewer/motion/navigation.hpp"
#include "viewer/script/script.hpp"
#include "viewer/window/background.hpp"
#include "viewer/window/compared.hpp"
#include "viewer/window/costs.hpp"
#include "viewer/window/generator.hpp"
#include "viewer/window/picture.hpp"
#include "viewer/window/second_picture.hpp"
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
    std::uint64_t version = 0;        // of the report: another one has another
};

class App {
  public:
    App(Window& window, gpu::Context& context, std::filesystem::path state_folder);
    ~App();
    App(const App&) = delete;
    App& operator=(const App&) = delete;

    // --- files
    void open_first(std::vector<std::string> paths);  // of the command line
    void open(const std::vector<std::string>& dropped);
    void open_document(Document document, const std::string& name);
    void save_scene(const std::filesystem::path& path);
    void save_picture(const std::filesystem::path& path, std::optional<Size> size);
    // Numbered pictures of a full turn in the size of the view, or a film of them (film.hpp).
    void save_turntable(const std::filesystem::path& path, int frames, Turn turn);
    void save_gltf(const std::filesystem::path& folder);
    // The folder that `burnish scratch` or `burnish weave` makes with the material's settings.
    void save_maps(const std::filesystem::path& folder);
    // Of the window: "part.glb", "part.json (recovered)", "part.glb (gone from disk)".
    const std::string& title() const { return title_; }
    // What was saved under a name is called by it from then on.
    SceneName name_of_scene();
    // Files of the document that are not on disk, in a line; "" where all are there.
    std::string missing_files() const { return line_of_missing(watched_.missing()); }
    void copy_command_line();
    // Of `burnish render`, for the scene as it was saved last.
    CommandLine command_line() const;
    bool loading() const { return loader_.running() || rig_to_fit_; }
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
    // Rows of numbers that say the lobe of a method at the picked point, into the clipboard.
    void copy_lobe(std::size_t method);
    WindowSize picture_size() const { return {picture_width, picture_height}; }
    // The light that is dragged: the selected one; a first one is made where there is none.
    int dragged_light();

    // --- parts of the scene. Indices that there are not change nothing, with a message.
    void select_material(std::optional<int> index);
    void frame_object(int index);  // and selects it
    void show_object(int index, bool shown);
    void show_all_objects();
    void solo_object(int index);  // or all again
    void add_light(LightType type);
    void remove_light(int index);
    void switch_light(int index, bool on);
    void change_light(int index, const Light& light);
    // Files and builtin names; reads the file.
    void set_environment(const std::string& name);
    void show_background(bool shown);  // the environment, or the color in its place
    bool shows_background() const;
    void keep_view(std::string name);  // as a bookmark; "": a name that there is not yet
    void go_to_view(const std::string& name);
    void rename_view(const std::string& name, const std::string& to);
    void delete_view(const std::string& name);
    void next_view();

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
    std::optional<int> object;    // selected
    std::string search;           // of the parameters
    std::optional<Picked> picked;
    Compared compared;
    // The second picture of a comparison of two materials, or of what is shown now with a "before". Null for
    // methods, and where the other material cannot be drawn.
    std::unique_ptr<SecondPicture> second;
    // Makes `second` what the document asks for. To be called before the pictures are given to ImGui, which draws
    // them at the end of the frame.
    void choose_second();
    bool holds_before() const { return second && second->is_before(); }
    bool shows_second() const { return second && document().compare.mode != CompareMode::off; }
    void hold();     // what is shown now becomes the "before"
    void release();  // there is none
    // The objects of a material are compared with themselves under another one.
    void compare_materials(const MaterialPair& pair, CompareMode mode);
    // The same with a file, for the pair's objects, else those of the selected material.
    void compare_with_file(const std::string& path);
    // Methods are compared in place of materials or a "before"; without any, those of the document.
    void compare_methods(const std::vector<Method>& methods, CompareMode mode);
    bool turntable = false;  // turns by itself
    bool show_panels = true;
    double ui_scale = 1.0;
    int picture_x = 0, picture_y = 0;  // upper left corner in the window
    int picture_width = 1, picture_height = 1;
    double frames_per_second = 0, lowest_frames_per_second = 0;
    // An autosave that a crash has left: offered, by a dialog where `asks_recovery`.
    std::optional<LeftBehind> recovered;
    bool asks_recovery = true;
    enum class Recovery { open, later, remove };
    void recover(Recovery choice);
    // Throws Error where the graphics device was reset; the scene is kept for the next start.
    void require_context();

    const Document& document() const { return editor.document(); }
    const Scene& scene() const { return editor.stage().scene; }

  private:
    // The refined picture in the view that is shown, as a display has it or linear.
    Image drawn(const Camera& camera, RenderSettings settings, bool linear);
    // Fits a rig that was opened, once nothing else is read, and opens the material.
    void fit_rig();
    // The paths without unfitted rigs, of which the last is fitted.
    std::vector<std::string> without_rigs(std::vector<std::string> paths);
    void load(Document document, std::string name, std::function<void(Document, Stage)> adopt);
    void after_change();
    void step_history(bool forward);
    void autosave_now_and_then();
    void follow_files();
    void name_window();
    void say_taken_back(const std::vector<ParameterValues>& before);
    void report_new_warnings();
    // Whether there is such a one; else a message says so.
    bool has_object(int index);
    bool has_light(int index);
    bool has_view(const std::string& name);

    Background loader_;
    std::optional<std::string> rig_to_fit_;
    Picker picker_;
    std::optional<Revisions> picker_revisions_, picked_revisions_;
    std::uint64_t reports_made_ = 0;
    Drag dragging_ = Drag::none;
    std::chrono::steady_clock::time_point last_motion_{}, last_autosave_{}, last_look_{},
        last_turn_{};
    WatchedFiles watched_;
    std::string title_;                   // of the window now
    SceneName input_name_;                // of the input
    std::optional<std::uint64_t> named_;  // Revisions::scene, of which it is
    // What `second` was made of last, whether or not it could be.
    std::optional<std::pair<MaterialPair, std::uint64_t>> second_of_;
    std::string saved_scene_;                 // of this input; "": it was not saved
    std::optional<Document> saved_document_;  // what the saved scene shows
    std::optional<Document> autosaved_;
    std::size_t errors_said_ = 0;
    std::string last_error_;
    std::filesystem::path opened_recovery_;  // removed at an orderly end
    bool keeps_autosave_ = false;            // at the end
    bool message_shown_ = false;             // in the last frame
    std::optional<Revisions> refused_;       // those that the device could not draw
    std::chrono::steady_clock::time_point last_frame_{};
};

}  // namespace burnish::viewer
