// Drives a session by the commands of a script, a few a frame.
//
// Threads: the main thread. Lifetime: refers to the app.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "viewer/script/script.hpp"
#include "viewer/window/app.hpp"

namespace burnish::viewer {

class ScriptRunner {
  public:
    ScriptRunner(App& app, std::vector<Command> commands, std::string name);

    // Whether the last command has ended, with the work that it began.
    bool done() const;
    // Whether the command in work goes on in frames, though nothing moves: all but a wait for time and
    // for a file that is read.
    bool needs_frame() const;
    // In place of a frame, where nothing is to be drawn: lets a wait for time go on.
    void run_idle() { run(); }
    // Before ImGui's frame begins: puts the mouse where the script has it.
    void feed_input();
    // Before the interface is drawn: runs commands until one takes frames. Throws Error "<name>: line 7:
    // ..." for a command that fails and an expectation that does not hold.
    void run();
    // After the frame was drawn, before it is swapped: takes the picture that was asked for.
    void after_draw();

  private:
    struct Waiting {
        WaitKind kind = WaitKind::frames;
        double left = 0;
        std::chrono::steady_clock::time_point since;
        double cpu_since = 0;
    };
    struct Dragging {
        DragCommand command;
        int frame = 0;
    };

    void execute(const Command& command);
    void settle_errors();
    void forget_drag();  // its measurements
    bool may_go_on(const std::string& error);
    void log(const std::string& name) const;
    void expect(const ExpectCommand& command);
    void generate(const GenerateCommand& command);
    void change_scene(const SceneCommand& command);
    void change_light(const SceneCommand& command);
    int required_object(const std::string& name_or_index) const;
    void compare(const CompareCommand& command);
    std::optional<int> find_material(const std::string& name_or_index) const;
    int required_material(const std::string& name_or_index) const;
    double measured(const std::string& name) const;
    bool still_busy();
    [[noreturn]] void fail(const std::string& what) const;

    App& app_;
    std::vector<Command> commands_;
    std::string name_;
    std::size_t next_ = 0;
    int line_ = 0;
    bool may_fail_ = false;  // the command in work
    std::optional<Waiting> waiting_;
    std::optional<Dragging> dragging_;
    std::optional<std::string> screenshot_;
    bool generating_ = false;
    std::vector<double> drag_frames_s_;
    double drag_cpu_s_ = 0, last_cpu_s_ = 0;  // of these frames; of the process at the last one
    std::optional<std::chrono::steady_clock::time_point> last_drag_frame_, changed_;
    std::optional<double> idle_cpu_;
    // Since the process started: something was shown, and every material by its own program.
    double first_picture_s_ = -1, whole_picture_s_ = -1;
    double change_s_ = 0;     // from the last `set` until it was drawn
    std::size_t errors_ = 0;  // that were met: of App::errors_said()
    bool was_recoverable_ = false;
    // The mouse of the script; none: the person's.
    std::optional<glm::dvec2> mouse_;
    int click_step_ = 0;  // 3: pressed next, 2: down, 1: released
    bool click_shift_ = false;
    // A drag or a scroll of the mouse, and the frame that it is in.
    std::optional<MouseCommand> mouse_command_;
    int mouse_frame_ = 0;
    void feed_mouse_command();
    std::optional<TypeCommand> type_command_;
    int type_frame_ = 0;
    void feed_type_command();
};

// That the mouse of a script takes.
int frames_of(const MouseCommand& command);

// The whole window as it was drawn, read before it is swapped.
void save_screenshot(const Window& window, const std::string& file);

}  // namespace burnish::viewer
