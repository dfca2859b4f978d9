#include "viewer/script/script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "burnish/error.hpp"
#include "burnish/parameters.hpp"
#include "burnish/scratch_settings.hpp"
#include "burnish/shading_names.hpp"
#include "burnish/stage.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "viewer/script/scene_commands.hpp"
#include "viewer/script/script_words.hpp"

namespace burnish::viewer {
namespace {

using Name = std::string_view;

constexpr std::uintmax_t kMostScriptBytes = std::uintmax_t{16} << 20;
constexpr double kFarthestPixel = 1e6;  // more than any screen has
constexpr int kLargestSide = 16384;     // pixels, as width and height in the parameter table

// --- words of several commands ------------------------------------------------------------------

Size read_size(WordReader& words, Name what) {
    const std::string expected = fmt::format("{}, WIDTHxHEIGHT such as 1280x720", what);
    const std::string& word = words.word(expected);
    Size size;
    const char* const end = word.data() + word.size();
    const auto [x, first] = std::from_chars(word.data(), end, size.width);
    if (first != std::errc() || x == end || *x != 'x') words.fail(expected, shown(word));
    const auto [stop, second] = std::from_chars(x + 1, end, size.height);
    if (second != std::errc() || stop != end || std::min(size.width, size.height) < 1 ||
        std::max(size.width, size.height) > kLargestSide)
        words.fail(fmt::format("{}, each side from 1 to {}", expected, kLargestSide), shown(word));
    return size;
}

double read_place(WordReader& words, Name axis) {
    return words.number(fmt::format("{} in pixels", axis), -kFarthestPixel, kFarthestPixel);
}

std::optional<std::string> read_material(WordReader& words) {
    if (!words.more()) return std::nullopt;
    return words.word("a material");
}

int read_steps(WordReader& words) {
    return words.more() ? words.whole("steps", 1, 1000) : 1;
}

// --- one function a command ---------------------------------------------------------------------

Name read_parameter_name(WordReader& words) {
    static const std::vector<Name> names = [] {
        std::vector<Name> all;
        for (const Parameter& parameter : parameter_table()) all.push_back(parameter.name);
        return all;
    }();
    const std::string& word = words.word("the name of a parameter");
    if (find_parameter(word) != nullptr) return word;
    const std::string_view nearest = nearest_name(names, word);
    words.fail("the name of a parameter",
               nearest.empty() ? shown(word)
                               : fmt::format("{}; did you mean '{}'?", shown(word), nearest));
}

Action read_set(WordReader& words) {
    SetCommand command;
    command.name = read_parameter_name(words);
    command.value = words.word(fmt::format("a value of {}", command.name));
    in_line(words, [&] { ParameterValues().set(command.name, command.value, command.name); });
    command.material = read_material(words);
    return command;
}

Action read_unset(WordReader& words) {
    UnsetCommand command;
    command.name = read_parameter_name(words);
    command.material = read_material(words);
    return command;
}

Action read_light_command(WordReader& words) {
    const std::string& word =
        words.word("AZIMUTH,ELEVATION[,INTENSITY], point:X,Y,Z[,INTENSITY] or none");
    LightCommand command;
    if (word != "none") in_line(words, [&] { command.light = parse_light(word); });
    return command;
}

Action read_drag(WordReader& words) {
    static constexpr std::array<Name, 5> kKinds = {"orbit", "pan", "zoom", "light", "environment"};
    DragCommand command;
    command.kind = static_cast<DragKind>(words.one_of(kKinds, "what is dragged"));
    command.dx = read_place(words, "DX");
    command.dy = read_place(words, "DY");
    if (words.more()) command.frames = words.whole("frames", 1, 100000);
    return command;
}

Action read_click(WordReader& words) {
    static constexpr std::array<Name, 1> kModifiers = {"shift"};
    ClickCommand command;
    command.x = read_place(words, "X");
    command.y = read_place(words, "Y");
    command.shift = words.more() && words.one_of(kModifiers, "a key that is held") == 0;
    return command;
}

std::string read_modifier(WordReader& words) {
    static constexpr std::array<Name, 3> kModifiers = {"shift", "ctrl", "alt"};
    if (!words.more()) return "";
    return std::string(
        kModifiers[static_cast<std::size_t>(words.one_of(kModifiers, "a key that is held"))]);
}

Action read_mouse(WordReader& words) {
    static constexpr std::array<Name, 3> kButtons = {"left", "right", "middle"};
    MouseCommand command;
    command.button = words.one_of(kButtons, "a button");
    command.dx = read_place(words, "DX");
    command.dy = read_place(words, "DY");
    if (words.more() && !number_of(words.peek())) command.modifier = read_modifier(words);
    if (words.more()) command.frames = words.whole("frames", 1, 100000);
    return command;
}

Action read_type(WordReader& words) {
    static constexpr std::array<Name, 1> kKeys = {"enter"};
    TypeCommand command;
    command.text = words.word("a text");
    command.enter = words.more() && words.one_of(kKeys, "the key at the end") == 0;
    return command;
}

Action read_scroll(WordReader& words) {
    MouseCommand command;
    command.button = -1;
    command.dx = words.number("steps to the right", -100.0, 100.0);
    command.dy = words.number("steps up", -100.0, 100.0);
    command.modifier = read_modifier(words);
    return command;
}

Action read_navigation(WordReader& words) {
    NavigationCommand command;
    command.navigation =
        static_cast<Navigation>(words.one_of(navigation_names(), "whose conventions"));
    return command;
}

Action read_touchpad(WordReader& words) {
    static constexpr std::array<Name, 2> kStates = {"on", "off"};
    NavigationCommand command;
    command.touchpad = words.one_of(kStates, "whether two fingers orbit") == 0;
    return command;
}

Action read_wait(WordReader& words) {
    WaitCommand command;
    const std::string& word = words.word("frames, rest, or seconds and their number");
    if (word == "rest") {
        command.kind = WaitKind::rest;
    } else if (word == "seconds") {
        command.kind = WaitKind::seconds;
        command.amount = words.number("seconds", 0.0, 86400.0);
    } else {
        const std::optional<double> frames = number_of(word);
        if (!frames || *frames < 1.0 || *frames > 1e6 || *frames != std::floor(*frames))
            words.fail(
                "frames (a whole number from 1 to 1000000), rest, or seconds and their number",
                shown(word));
        command.amount = *frames;
    }
    return command;
}

Action read_compare_command(WordReader& words) {
    CompareCommand command;
    command.mode =
        static_cast<CompareMode>(words.one_of(compare_mode_names(), "a way of comparing"));
    if (words.more() && words.peek() == "material") {
        words.word("material");
        CompareCommand::Materials pair;
        pair.first = words.word("a material of the scene");
        pair.second = words.word("another material of the scene, or a file");
        command.materials = std::move(pair);
        return command;
    }
    while (words.more()) {
        const auto method = static_cast<Method>(words.one_of(method_names(), "a method"));
        if (std::find(command.methods.begin(), command.methods.end(), method) !=
            command.methods.end())
            words.fail("each method once", fmt::format("{} again", name_of(method)));
        command.methods.push_back(method);
    }
    const std::size_t count = command.methods.size();
    if (count != 0 && (count < kLeastCompared || count > kMostCompared))
        words.fail(fmt::format("{} to {} methods, or none", kLeastCompared, kMostCompared),
                   std::to_string(count));
    return command;
}

Action read_panel(WordReader& words) {
    static constexpr std::array<Name, 2> kStates = {"on", "off"};
    PanelCommand command;
    command.name = words.word("the name of a panel");
    command.open = words.one_of(kStates, "its state") == 0;
    return command;
}

Action read_generate(WordReader& words) {
    static constexpr std::array<Name, 1> kKinds = {"scratch"};
    static constexpr std::array<Name, 11> kKeys = {"preset", "amount", "strength", "seed",
                                                   "size",   "tile",   "angle",    "range",
                                                   "length", "width",  "depth"};
    words.one_of(kKinds, "what is generated");
    GenerateCommand c;
    const auto number = [&](Name key, double low, double high, std::optional<double>& to) {
        to = words.number(key, low, high);
    };
    while (words.more()) {
        const Name key = kKeys[static_cast<std::size_t>(words.one_of(kKeys, "a setting"))];
        if (key == "preset") {
            const auto names = scratch_preset_names();
            c.preset =
                std::string(names[static_cast<std::size_t>(words.one_of(names, "a preset"))]);
        }
        if (key == "seed") c.seed = words.whole("a seed", 0, 2147483647);
        if (key == "size") c.size = words.whole("texels a side", 16, 16384);
        if (key == "amount") number(key, 0.0, 8.0, c.amount);
        if (key == "strength") number(key, 0.0, 4.0, c.strength);
        if (key == "tile") number(key, 0.1, 1e4, c.tile_mm);
        if (key == "angle") number(key, -360.0, 360.0, c.angle_deg);
        if (key == "range") number(key, 0.0, 90.0, c.range_deg);
        if (key == "length") number(key, 1e-4, 4e4, c.length_mm);
        if (key == "width") number(key, 1e-5, 5e3, c.width_mm);
        if (key == "depth") number(key, 0.0, 1e4, c.depth_mm);
    }
    return c;
}

Action read_save(WordReader& words) {
    static constexpr std::array<Name, 4> kKinds = {"scene", "picture", "maps", "gltf"};
    SaveCommand command;
    command.kind = static_cast<SaveKind>(words.one_of(kKinds, "what is saved"));
    command.file = words.word("a file");
    if (words.more() && command.kind == SaveKind::picture)
        command.size = read_size(words, "the size of the picture");
    return command;
}

Action read_expect(WordReader& words) {
    static constexpr std::array<Name, 6> kOperators = {"=", "!=", "<", "<=", ">", ">="};
    ExpectCommand command;
    command.name = words.word("the name of a value");
    command.comparison = static_cast<Comparison>(words.one_of(kOperators, "a comparison"));
    command.value = words.word("a value");
    command.number = number_of(command.value);
    const bool equality =
        command.comparison == Comparison::equal || command.comparison == Comparison::unequal;
    if (!equality && !command.number) words.fail("a number behind < <= > >=", shown(command.value));
    if (!words.more()) return command;
    if (!equality || !command.number)
        words.fail("no tolerance but behind = or != and a number", shown(words.peek()));
    command.tolerance = words.number("a tolerance", 0.0, 1e300);
    return command;
}

using Reader = Action (*)(WordReader&);
struct VerbRow {
    Name name;
    Reader read;
};

constexpr VerbRow kVerbs[] = {
    {"open",
     [](WordReader& w) -> Action {
         if (!w.more()) w.fail("a file", "the end of the line");
         return OpenCommand{w.rest()};
     }},
    {"set", read_set},
    {"unset", read_unset},
    {"light", read_light_command},
    {"environment",
     [](WordReader& w) -> Action {
         return EnvironmentCommand{w.word("a file, builtin:<name> or none")};
     }},
    {"drag", read_drag},
    {"move",
     [](WordReader& w) -> Action {
         const double x = read_place(w, "X");
         return MoveCommand{x, read_place(w, "Y")};
     }},
    {"click", read_click},
    {"mouse", read_mouse},
    {"scroll", read_scroll},
    {"type", read_type},
    {"navigation", read_navigation},
    {"touchpad", read_touchpad},
    {"key", [](WordReader& w) -> Action { return KeyCommand{w.word("a key, such as ctrl+z")}; }},
    {"wait", read_wait},
    {"pick",
     [](WordReader& w) -> Action {
         const double x = read_place(w, "X");
         return PickCommand{x, read_place(w, "Y")};
     }},
    {"compare", read_compare_command},
    {"view", [](WordReader& w) -> Action { return ViewCommand{w.word("the name of a view")}; }},
    {"panel", read_panel},
    {"generate", read_generate},
    {"material", [](WordReader& w) -> Action { return read_material_command(w); }},
    {"object", [](WordReader& w) -> Action { return read_object_command(w); }},
    {"lights", [](WordReader& w) -> Action { return read_lights_command(w); }},
    {"background", [](WordReader& w) -> Action { return read_background_command(w); }},
    {"bookmark", [](WordReader& w) -> Action { return read_bookmark_command(w); }},
    {"recover", [](WordReader& w) -> Action { return read_recover_command(w); }},
    {"simulate", [](WordReader& w) -> Action { return read_simulate_command(w); }},
    {"undo", [](WordReader& w) -> Action { return UndoCommand{read_steps(w)}; }},
    {"redo", [](WordReader& w) -> Action { return RedoCommand{read_steps(w)}; }},
    {"save", read_save},
    {"turntable",
     [](WordReader& w) -> Action {
         TurntableCommand command;
         command.frames = w.whole("pictures of a full turn", 1, 9999);
         command.file = w.word("a file");
         if (w.more()) command.turn = static_cast<Turn>(w.one_of(turn_names(), "what turns"));
         return command;
     }},
    {"screenshot", [](WordReader& w) -> Action { return ScreenshotCommand{w.word("a file")}; }},
    {"expect", read_expect},
    {"log",
     [](WordReader& w) -> Action {
         if (!w.more()) w.fail("the name of a value", "the end of the line");
         return LogCommand{w.rest()};
     }},
    {"resize",
     [](WordReader& w) -> Action { return ResizeCommand{read_size(w, "the size of the window")}; }},
    {"quit",
     [](WordReader& w) -> Action {
         return QuitCommand{w.more() ? w.number("seconds", 0.0, 1e6) : 0.0};
     }},
};

std::vector<Name> verb_names() {
    std::vector<Name> names;
    for (const VerbRow& row : kVerbs) names.push_back(row.name);
    return names;
}

}  // namespace

std::vector<Command> parse_script(std::string_view text, const std::string& name) {
    const std::vector<Name> verbs = verb_names();
    std::vector<Command> commands;
    for (const ScriptLine& line : script_lines(text, name)) {
        WordReader words(name, line);
        const bool may_fail = words.peek() == "try";
        if (may_fail) words.word("try");
        const int verb = words.one_of(verbs, "a command");
        Action action = kVerbs[verb].read(words);
        words.end();
        commands.push_back({line.number, line.text, std::move(action), may_fail});
    }
    return commands;
}

std::vector<Command> load_script(const std::filesystem::path& path) {
    return parse_script(read_text_file(path, kMostScriptBytes), path.string());
}

bool meets(const ExpectCommand& expected, double found) {
    if (!expected.number) return expected.comparison == Comparison::unequal;
    const double value = *expected.number;
    switch (expected.comparison) {
        case Comparison::equal:
            return std::abs(found - value) <= expected.tolerance;
        case Comparison::unequal:
            return !(std::abs(found - value) <= expected.tolerance);
        case Comparison::less:
            return found < value;
        case Comparison::at_most:
            return found <= value;
        case Comparison::greater:
            return found > value;
        case Comparison::at_least:
            return found >= value;
    }
    return false;
}

bool meets(const ExpectCommand& expected, std::string_view found) {
    if (const std::optional<double> number = number_of(found); number && expected.number)
        return meets(expected, *number);
    const bool same = found == expected.value;
    return expected.comparison == Comparison::equal     ? same
           : expected.comparison == Comparison::unequal ? !same
                                                        : false;
}

}  // namespace burnish::viewer
