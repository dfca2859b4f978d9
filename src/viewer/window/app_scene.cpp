// The part of App that changes what the scene is made of: objects, lights, environment, bookmarks.
#include <fmt/format.h>

#include <algorithm>

#include "burnish/error.hpp"
#include "core/text.hpp"
#include "viewer/document/file_names.hpp"
#include "viewer/document/scene_lists.hpp"
#include "viewer/motion/orbit.hpp"
#include "viewer/window/app.hpp"
#include "viewer/window/app_parts.hpp"

namespace burnish::viewer {
namespace {

// Sockets of a shader: more lights are drawn, but no person places them by hand.
constexpr std::size_t kMostByHand = 16;

auto bookmark_named(auto& bookmarks, const std::string& name) {
    return std::ranges::find(bookmarks, name, &Bookmark::name);
}

}  // namespace

// --- materials and objects ------------------------------------------------------------------------

void App::select_material(std::optional<int> index) {
    if (index && (*index < 0 || static_cast<std::size_t>(*index) >= scene().materials.size()))
        return say(fmt::format("there is no material #{}", *index), true);
    material = index;
}

void App::frame_object(int index) {
    if (!has_object(index)) return;
    object = index;
    const Bounds bounds = bounds_of_object(editor.stage(), static_cast<std::size_t>(index));
    if (!(bounds.radius() > 0)) return;
    const Camera moved = framed(editor.stage().camera, bounds,
                                static_cast<double>(picture_width) / std::max(picture_height, 1));
    move_camera(moved, {}, "frame object");
}

bool App::has_object(int index) {
    if (index >= 0 && static_cast<std::size_t>(index) < scene().instances.size()) return true;
    say(fmt::format("there is no object #{}", index), true);
    return false;
}

void App::show_object(int index, bool shown) {
    if (!has_object(index)) return;
    edit({}, shown ? "show object" : "hide object", [&](Document& d) {
        if (shown)
            d.hidden.erase(index);
        else
            d.hidden.insert(index);
    });
}

void App::show_all_objects() {
    edit({}, "show objects", [](Document& d) { d.hidden.clear(); });
}

void App::solo_object(int index) {
    if (!has_object(index)) return;
    object = index;
    edit({}, "solo", [&](Document& d) { show_alone(d, editor.stage(), index); });
}

// --- lights ---------------------------------------------------------------------------------------

void App::add_light(LightType type) {
    std::vector<Light> lights = all_lights(document(), editor.stage());
    if (lights.size() >= kMostByHand)
        return say(fmt::format("a scene has at most {} lights placed by hand", kMostByHand), true);
    Light added = parse_light("30,45");
    if (type == LightType::point) {
        // Above the scene, to the right, as far as it is large.
        const Bounds bounds = bounds_of(scene());
        const float far = std::max(2 * bounds.radius(), 0.1f);
        added = Light{};
        added.type = LightType::point;
        added.position = bounds.center() + glm::vec3(0.4f, 0.7f, 0.6f) * far;
        added.intensity = far * far;  // about one lux on the scene
    }
    lights.push_back(added);
    const bool done = edit({}, "add light", [&](Document& d) { d.lights = lights; });
    if (done) light = static_cast<int>(lights.size()) - 1;
}

bool App::has_light(int index) {
    if (index >= 0 && static_cast<std::size_t>(index) < scene().lights.size()) return true;
    say(fmt::format("there is no light {}", index + 1), true);
    return false;
}

void App::remove_light(int index) {
    if (!has_light(index)) return;
    std::vector<Light> lights = all_lights(document(), editor.stage());
    lights.erase(lights.begin() + index);
    edit({}, "remove light", [&](Document& d) {
        d.lights = lights;
        std::set<int> dark;
        for (const int i : d.dark)
            if (i != index) dark.insert(i > index ? i - 1 : i);
        d.dark = std::move(dark);
    });
}

void App::switch_light(int index, bool on) {
    if (!has_light(index)) return;
    edit({}, on ? "light on" : "light off", [&](Document& d) {
        if (on)
            d.dark.erase(index);
        else
            d.dark.insert(index);
    });
}

void App::change_light(int index, const Light& changed) {
    if (!has_light(index)) return;
    std::vector<Light> lights = all_lights(document(), editor.stage());
    lights[static_cast<std::size_t>(index)] = changed;
    edit("light", "light", [&](Document& d) { d.lights = lights; });
    note_motion();
}

// --- environment ----------------------------------------------------------------------------------

void App::set_environment(const std::string& name) {
    const bool is_word = name.empty() || name == "none";
    const std::string file = is_word ? name : absolute_name(name);
    if (edit({}, "environment", [&](Document& d) { d.environment = file; }) && !is_word)
        add_recent(remembered, file);
}

bool App::shows_background() const {
    return editor.stage().settings.background == BackgroundKind::environment;
}

void App::show_background(bool shown) {
    edit({}, "background", [&](Document& d) {
        viewer::set_parameter_text(d, "background", shown ? "environment" : "color");
    });
}

// --- bookmarks ------------------------------------------------------------------------------------

void App::keep_view(std::string name) {
    const Camera& camera = editor.stage().camera;
    const std::vector<Bookmark>& all = document().bookmarks;
    for (std::size_t i = all.size() + 1; name.empty(); ++i) {
        name = fmt::format("view {}", i);
        if (bookmark_named(all, name) != all.end()) name.clear();
    }
    const Bookmark kept{name, camera.position, camera.target, fov_deg_of(camera)};
    const bool done = edit({}, "keep view", [&](Document& d) {
        const auto known = bookmark_named(d.bookmarks, name);
        if (known == d.bookmarks.end())
            d.bookmarks.push_back(kept);
        else
            *known = kept;
    });
    if (done) say("kept: " + one_line(name));
}

bool App::has_view(const std::string& name) {
    const std::vector<Bookmark>& all = document().bookmarks;
    if (bookmark_named(all, name) != all.end()) return true;
    say(fmt::format("there is no bookmark {}", shown(name)), true);
    return false;
}

void App::go_to_view(const std::string& name) {
    if (!has_view(name)) return;
    const Bookmark to = *bookmark_named(document().bookmarks, name);
    edit({}, "view " + name,
         [&](Document& d) { viewer::set_camera(d, to.position, to.target, to.fov_deg); });
    note_motion();
}

void App::rename_view(const std::string& name, const std::string& to) {
    if (!has_view(name) || name == to) return;
    edit({}, "rename view", [&](Document& d) {
        if (bookmark_named(d.bookmarks, to) != d.bookmarks.end())
            throw UsageError("bookmark", "", "a name that no bookmark has yet", shown(to));
        bookmark_named(d.bookmarks, name)->name = to;
    });
}

void App::delete_view(const std::string& name) {
    if (!has_view(name)) return;
    edit({}, "delete view",
         [&](Document& d) { d.bookmarks.erase(bookmark_named(d.bookmarks, name)); });
}

// The one behind that at which the camera is.
void App::next_view() {
    const std::vector<Bookmark>& all = document().bookmarks;
    if (all.empty()) return say("no view is kept: B keeps this one");
    const Camera& camera = editor.stage().camera;
    const auto here = std::ranges::find_if(all, [&](const Bookmark& b) {
        return b.position == camera.position && b.target == camera.target;
    });
    const std::size_t next =
        here == all.end() ? 0 : static_cast<std::size_t>(here - all.begin()) + 1;
    go_to_view(std::string(all[next % all.size()].name));
}

}  // namespace burnish::viewer
