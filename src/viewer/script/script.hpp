// The text of `burnish view --script FILE` as commands: one a line, words separated by blanks, "quoted
// words" with \" and \\ inside, # before a comment.
//
// Threads: functions may be called from any thread. Lifetime: what they return refers to nothing
// else.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "burnish/scene.hpp"
#include "burnish/turntable.hpp"
#include "viewer/document/document.hpp"
#include "viewer/motion/navigation.hpp"

namespace burnish::viewer {

struct Size {
    int width = 0, height = 0;  // pixels, 1 to 16384
    bool operator==(const Size&) const = default;
};

// open FILE...
struct OpenCommand {
    std::vector<std::string> files;  // at least one
};
// set NAME VALUE [MATERIAL]: the name is in the parameter table, and the value suits it.
struct SetCommand {
    std::string name, value;
    std::optional<std::string> material;  // a name, or "#" and an index; none: all materials
};
// unset NAME [MATERIAL]
struct UnsetCommand {
    std::string name;
    std::optional<std::string> material;
};
// light AZIMUTH,ELEVATION[,INTENSITY], light point:X,Y,Z[,INTENSITY] or light none: in place of all
// lights.
struct LightCommand {
    std::optional<Light> light;  // none: no light
};
// environment NAME: a file, builtin:<name> or none
struct EnvironmentCommand {
    std::string name;
};
enum class DragKind { orbit, pan, zoom, light, environment };
// drag KIND DX DY [FRAMES]
struct DragCommand {
    DragKind kind = DragKind::orbit;
    double dx = 0, dy = 0;  // pixels, right and down
    int frames = 1;         // over which the way is spread evenly, 1 to 100000
};
// move X Y
struct MoveCommand {
    double x = 0, y = 0;  // pixels from the upper left corner of the window
};
// click X Y [shift]
struct ClickCommand {
    double x = 0, y = 0;
    bool shift = false;
};
// mouse BUTTON DX DY [MODIFIER] [FRAMES]: from where the mouse is, a drag with left, right or middle
// scroll DX DY [MODIFIER]: steps of the wheel, or of two fingers
struct MouseCommand {
    int button = 0;         // as ImGui has it; -1: scrolling
    double dx = 0, dy = 0;  // pixels, or steps
    std::string modifier;   // "", "shift", "ctrl" or "alt"
    int frames = 3;         // over which the way is spread evenly, 1 to 100000; not of scrolling
};
// type TEXT [enter]: into the text field that has the keyboard, in place of what it holds
struct TypeCommand {
    std::string text;
    bool enter = false;  // the key at the end
};
// navigation viewer|blender, touchpad on|off
struct NavigationCommand {
    std::optional<Navigation> navigation;
    std::optional<bool> touchpad;
};
// key KEYS: such as "ctrl+z", "f", "?"
struct KeyCommand {
    std::string keys;
};
enum class WaitKind { frames, rest, seconds };
// wait FRAMES | wait rest | wait seconds N. rest: until the picture is refined and nothing is drawn.
struct WaitCommand {
    WaitKind kind = WaitKind::frames;
    double amount = 0;  // frames (whole, 1 to 1000000) or seconds (0 to 86400); 0 for rest
};
// pick X Y
struct PickCommand {
    double x = 0, y = 0;
};
// compare MODE [METHOD...]: 2 to 4 different methods; none: what is set
// compare MODE material A B: the objects of material A with it, and with B, a material or a file
struct CompareCommand {
    struct Materials {
        std::string first, second;  // a name, "#" and an index, or for the second a file
    };
    CompareMode mode = CompareMode::off;
    std::vector<Method> methods;
    std::optional<Materials> materials;
};
// view NAME: a view of what is behind the picture
struct ViewCommand {
    std::string name;
};
// panel NAME on|off
struct PanelCommand {
    std::string name;
    bool open = false;
};
// generate scratch [preset NAME] [amount N] [strength N] [seed N] [size N] [tile MM] [angle DEG]
// [range DEG] [length MM] [width MM] [depth MM]: what is not named stays as the panel has it; angle to
// depth are of the first layer.
struct GenerateCommand {
    std::optional<std::string> preset;
    std::optional<double> amount, strength;  // 0 to 8, 0 to 4
    std::optional<int> seed, size;           // 0 to 2147483647; 16 to 16384 texels
    std::optional<double> tile_mm, angle_deg, range_deg, length_mm, width_mm, depth_mm;
};
// What the lists of the panel Scene do:
//   material NAME | material all                       selects
//   object NAME on|off|solo|frame | object all on
//   lights add directional|point | lights N on|off|remove | lights N to LIGHT | lights N color COLOR
//   background on|off
//   bookmark add|go|delete NAME | bookmark rename NAME TO
//   recover open|later|delete                          the scene that a crash has left
//   simulate device-reset                              for tests
struct SceneCommand {
    enum class Does {
        select_material,
        show_object,
        hide_object,
        solo_object,
        frame_object,
        show_all_objects,
        add_light,
        switch_light_on,
        switch_light_off,
        remove_light,
        change_light,
        show_background,
        hide_background,
        add_bookmark,
        go_to_bookmark,
        delete_bookmark,
        rename_bookmark,
        open_recovered,
        leave_recovered,
        delete_recovered,
        reset_device
    };
    Does does = Does::select_material;
    std::string name, to;  // "": all; of materials and objects also "#" and an index
    int index = 0;         // of a light, from 0
    LightType type = LightType::directional;  // of a light to add
    std::optional<Light> light;               // change_light: place or direction, and intensity
    std::optional<glm::vec3> color;           // change_light
    bool has_intensity = false;               // `light` states one
};
// undo [N], redo [N]
struct UndoCommand {
    int steps = 1;  // 1 to 1000
};
struct RedoCommand {
    int steps = 1;
};
enum class SaveKind { scene, picture, maps, gltf };
// save KIND FILE [WxH]: a size goes with a picture alone
struct SaveCommand {
    SaveKind kind = SaveKind::scene;
    std::string file;
    std::optional<Size> size;  // none: that of the view
};
// turntable N FILE [TURN]
struct TurntableCommand {
    int frames = 1;  // 1 to 9999
    std::string file;
    Turn turn = Turn::object;
};
// screenshot FILE: of the whole window
struct ScreenshotCommand {
    std::string file;
};
enum class Comparison { equal, unequal, less, at_most, greater, at_least };
// expect NAME OP VALUE [TOLERANCE]: OP is one of = != < <= > >=. The script fails where it does not
// hold.
struct ExpectCommand {
    // "fps", "drawn_samples", "picked.D", a parameter ... "error": a part of the message with which the
    // command before fails.
    std::string name;
    Comparison comparison = Comparison::equal;
    std::string value;
    std::optional<double> number;  // `value` where it is a number; set for < <= > >=
    double tolerance = 0;          // absolute, >= 0; of = and != with a number
};
// log NAME...: measurements, parameters and command_line, one a line of standard output
struct LogCommand {
    std::vector<std::string> names;  // at least one
};
// resize WxH: the window
struct ResizeCommand {
    Size size;
};
// quit [SECONDS]: now, or if the process was started so long ago
struct QuitCommand {
    double after_s = 0;
};

using Action = std::variant<OpenCommand, SetCommand, UnsetCommand, LightCommand, EnvironmentCommand,
                            DragCommand, MoveCommand, ClickCommand, MouseCommand, TypeCommand,
                            NavigationCommand, KeyCommand, WaitCommand, PickCommand, CompareCommand,
                            ViewCommand, PanelCommand, GenerateCommand, SceneCommand, UndoCommand,
                            RedoCommand, SaveCommand, TurntableCommand, ScreenshotCommand,
                            ExpectCommand, LogCommand, ResizeCommand, QuitCommand>;

struct Command {
    int line = 0;      // from 1
    std::string text;  // the line without its comment, for logs and messages
    Action action;
    bool may_fail = false;  // "try COMMAND": the script goes on where it fails
};

// Throws Error "<name>: line 7: expected ..., found ...", with the nearest known word where one is
// misspelt. Names of views, panels, keys and measurements are checked when the script runs.
std::vector<Command> parse_script(std::string_view text, const std::string& name);
// Throws Error too for a file that cannot be read or has more than 16 MB.
std::vector<Command> load_script(const std::filesystem::path& path);

// Whether `found` meets the expectation. A text is compared with = and != as it is.
bool meets(const ExpectCommand& expected, double found);
bool meets(const ExpectCommand& expected, std::string_view found);

}  // namespace burnish::viewer
