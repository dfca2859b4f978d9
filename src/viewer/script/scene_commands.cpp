#include "viewer/script/scene_commands.hpp"

#include <algorithm>
#include <array>

#include "burnish/parameters.hpp"
#include "burnish/stage.hpp"

namespace burnish::viewer {
namespace {

using Name = std::string_view;
using Does = SceneCommand::Does;

// The meaning of the next word, one of `names`.
template <std::size_t N>
Does one_of(WordReader& words, const std::array<Name, N>& names, const std::array<Does, N>& does,
            Name what) {
    return does[static_cast<std::size_t>(words.one_of(names, what))];
}

glm::vec3 read_color(WordReader& words) {
    glm::vec3 color(1.0f);
    const std::string& word = words.word("a color, such as #ff8800");
    in_line(words, [&] {
        ParameterValues one;
        one.set("base_color", word, "color");
        color = std::get<glm::vec3>(one.set_values().begin()->second);
    });
    return color;
}

}  // namespace

SceneCommand read_material_command(WordReader& words) {
    SceneCommand command;
    command.name = words.word("a material, or all");
    if (command.name == "all") command.name.clear();
    return command;
}

SceneCommand read_object_command(WordReader& words) {
    static constexpr std::array<Name, 4> kNames = {"on", "off", "solo", "frame"};
    static constexpr std::array<Does, 4> kDoes = {Does::show_object, Does::hide_object,
                                                  Does::solo_object, Does::frame_object};
    SceneCommand command;
    command.name = words.word("an object, or all");
    if (command.name == "all") {
        static constexpr std::array<Name, 1> kOn = {"on"};
        words.one_of(kOn, "on");
        command.does = Does::show_all_objects;
        return command;
    }
    command.does = one_of(words, kNames, kDoes, "what to do with the object");
    return command;
}

SceneCommand read_lights_command(WordReader& words) {
    static constexpr std::array<Name, 5> kNames = {"on", "off", "remove", "to", "color"};
    static constexpr std::array<Does, 5> kDoes = {Does::switch_light_on, Does::switch_light_off,
                                                  Does::remove_light, Does::change_light,
                                                  Does::change_light};
    SceneCommand command;
    if (words.more() && words.peek() == "add") {
        static constexpr std::array<Name, 2> kKinds = {"directional", "point"};
        words.word("add");
        command.does = Does::add_light;
        command.type = static_cast<LightType>(words.one_of(kKinds, "a kind of light"));
        return command;
    }
    command.index = words.whole("the number of a light, or add", 1, 1000) - 1;
    const int verb = words.one_of(kNames, "what to do with the light");
    command.does = kDoes[static_cast<std::size_t>(verb)];
    if (kNames[static_cast<std::size_t>(verb)] == "color") command.color = read_color(words);
    if (kNames[static_cast<std::size_t>(verb)] != "to") return command;
    const std::string& word =
        words.word("AZIMUTH,ELEVATION[,INTENSITY] or point:X,Y,Z[,INTENSITY]");
    in_line(words, [&] { command.light = parse_light(word); });
    const auto commas = std::ranges::count(word, ',');
    command.has_intensity = commas == (word.starts_with("point:") ? 3 : 2);
    return command;
}

SceneCommand read_background_command(WordReader& words) {
    static constexpr std::array<Name, 2> kNames = {"on", "off"};
    static constexpr std::array<Does, 2> kDoes = {Does::show_background, Does::hide_background};
    SceneCommand command;
    command.does = one_of(words, kNames, kDoes, "whether it is shown");
    return command;
}

SceneCommand read_bookmark_command(WordReader& words) {
    static constexpr std::array<Name, 4> kNames = {"add", "go", "delete", "rename"};
    static constexpr std::array<Does, 4> kDoes = {Does::add_bookmark, Does::go_to_bookmark,
                                                  Does::delete_bookmark, Does::rename_bookmark};
    SceneCommand command;
    command.does = one_of(words, kNames, kDoes, "what to do with a bookmark");
    command.name = words.word("the name of a bookmark");
    if (command.does == Does::rename_bookmark) command.to = words.word("its new name");
    return command;
}

SceneCommand read_recover_command(WordReader& words) {
    static constexpr std::array<Name, 3> kNames = {"open", "later", "delete"};
    static constexpr std::array<Does, 3> kDoes = {Does::open_recovered, Does::leave_recovered,
                                                  Does::delete_recovered};
    SceneCommand command;
    command.does = one_of(words, kNames, kDoes, "what to do with the scene that was left");
    return command;
}

SceneCommand read_simulate_command(WordReader& words) {
    static constexpr std::array<Name, 1> kNames = {"device-reset"};
    static constexpr std::array<Does, 1> kDoes = {Does::reset_device};
    SceneCommand command;
    command.does = one_of(words, kNames, kDoes, "what to simulate");
    return command;
}

}  // namespace burnish::viewer
