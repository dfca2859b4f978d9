// The picture: its panes, dividers, labels, and the mouse.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

#include "viewer/inspect/ray.hpp"
#include "viewer/motion/light_sphere.hpp"
#include "viewer/window/panels.hpp"

namespace burnish::viewer {
namespace {

constexpr double kBlink_s = 0.7;

ImTextureID id_of(unsigned texture) {
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
}

std::vector<double> dividers_of(const Compare& compare) {
    if (compare.dividers.size() + 1 == compare.methods.size()) return compare.dividers;
    std::vector<double> even;
    for (std::size_t i = 1; i < compare.methods.size(); ++i)
        even.push_back(static_cast<double>(i) / static_cast<double>(compare.methods.size()));
    return even;
}

// Two pictures of a scene that differs, in place of methods.
bool compares_two(const App& app) {
    return app.document().compare.mode != CompareMode::off &&
           (app.holds_before() || app.document().compare.materials);
}

// What is shown now is the second picture against a "before", else the first.
bool now_is_first(const App& app) {
    return !app.holds_before();
}

std::vector<double> dividers_of(const App& app) {
    const Compare& compare = app.document().compare;
    if (!compares_two(app)) return dividers_of(compare);
    return {compare.middle};
}

// The pane of the first or the second picture of two.
std::vector<Pane> pane_of_two(const App& app, bool is_first) {
    Pane pane{std::nullopt, app.view, 0, 1};
    if (app.document().compare.mode == CompareMode::split)
        (is_first ? pane.right : pane.left) = dividers_of(app).front();
    return {pane};
}

std::vector<Pane> panes_of(const App& app) {
    const Compare& compare = app.document().compare;
    // Another material that cannot be drawn leaves the picture alone.
    if (compare.mode == CompareMode::off || (compares_two(app) && !app.second))
        return {Pane{std::nullopt, app.view, 0, 1}};
    if (compares_two(app)) return pane_of_two(app, now_is_first(app));
    std::vector<Pane> panes;
    const bool split = compare.mode == CompareMode::split;
    const bool two = compare.mode == CompareMode::difference || compare.mode == CompareMode::flip;
    const std::vector<double> dividers = dividers_of(compare);
    for (std::size_t i = 0; i < compare.methods.size() && !(two && i >= 2); ++i) {
        Pane pane{compare.methods[i], app.view, 0, 1};
        if (split) {
            pane.left = i == 0 ? 0.0 : dividers[i - 1];
            pane.right = i < dividers.size() ? dividers[i] : 1.0;
        }
        panes.push_back(pane);
    }
    return panes;
}

void label(ImDrawList& draw, ImVec2 at, const std::string& text) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float pad = ImGui::GetStyle().FramePadding.x;
    draw.AddRectFilled(at, {at.x + size.x + 2 * pad, at.y + size.y + pad},
                       IM_COL32(20, 20, 20, 190), 3.0f);
    draw.AddText({at.x + pad, at.y + 0.5f * pad}, IM_COL32(235, 235, 235, 255), text.c_str());
}

// The index of the pane that a blink shows now.
std::size_t blinking(std::size_t count) {
    return static_cast<std::size_t>(ImGui::GetTime() / kBlink_s) % std::max<std::size_t>(count, 1);
}

void draw_pane(const App& app, const Picture& picture, ImDrawList& draw, std::size_t index,
               const std::string& name) {
    const unsigned texture = picture.texture(index);
    if (texture == 0) return;
    const Pane& pane = picture.pane(index);
    const auto x = static_cast<float>(app.picture_x), y = static_cast<float>(app.picture_y);
    const auto w = static_cast<float>(app.picture_width),
               h = static_cast<float>(app.picture_height);
    const float left = std::round(static_cast<float>(pane.left) * w);
    const float right = std::round(static_cast<float>(pane.right) * w);
    // Textures have their first row at the bottom.
    draw.AddImage(id_of(texture), {x + left, y}, {x + right, y + h}, {0, 1}, {1, 0});
    if (!name.empty()) label(draw, {x + left + 8, y + 8}, name);
}

// The picture number `index` of a comparison of two.
const Picture& of_two(const App& app, std::size_t index) {
    return (index == 0) == now_is_first(app) ? app.picture : app.second->picture;
}

// The picture number `index` of a comparison.
void draw_compared(const App& app, ImDrawList& draw, std::size_t index) {
    if (app.shows_second())
        return draw_pane(app, of_two(app, index), draw, 0,
                         index == 0 ? app.second->first_name() : app.second->second_name());
    const std::optional<Method> method = app.picture.pane(index).method;
    draw_pane(app, app.picture, draw, index, method ? std::string(name_of(*method)) : "");
}

std::size_t compared_count(const App& app) {
    return app.shows_second() ? 2 : app.picture.pane_count();
}

bool all_at_rest(const App& app) {
    return app.picture.at_rest() && (!app.shows_second() || app.second->picture.at_rest());
}

// "B against A", the second picture first.
std::string names_of_compared(const App& app) {
    if (app.shows_second())
        return fmt::format("{} against {}", app.second->second_name(), app.second->first_name());
    const std::vector<Method>& methods = app.document().compare.methods;
    return fmt::format("{} against {}", name_of(methods[1]), name_of(methods[0]));
}

void draw_panes(App& app, ImDrawList& draw) {
    const Compare& compare = app.document().compare;
    const auto x = static_cast<float>(app.picture_x), y = static_cast<float>(app.picture_y);
    const auto w = static_cast<float>(app.picture_width),
               h = static_cast<float>(app.picture_height);
    switch (compare.mode) {
        case CompareMode::blink:
            return draw_compared(app, draw, blinking(compared_count(app)));
        case CompareMode::difference:
        case CompareMode::flip: {
            if (compared_count(app) < 2) return draw_compared(app, draw, 0);
            if (app.shows_second())
                app.compared.update(of_two(app, 0), 0, of_two(app, 1), 0, compare);
            else
                app.compared.update(app.picture, 0, app.picture, 1, compare);
            if (compare.mode == CompareMode::flip && !all_at_rest(app)) {
                draw_compared(app, draw, 1);
                return label(draw, {x + 8, y + h - 32}, "FLIP is computed at rest");
            }
            if (app.compared.texture() == 0) return;
            draw.AddImage(id_of(app.compared.texture()), {x, y}, {x + w, y + h});
            const std::string names = names_of_compared(app);
            label(draw, {x + 8, y + 8},
                  compare.mode == CompareMode::flip
                      ? fmt::format("FLIP of {}: mean {:.4f}, highest {:.3f}", names,
                                    app.compared.mean(), app.compared.most())
                      : fmt::format("{}, x {:g}: orange brighter, blue darker; mean {:.4f}", names,
                                    compare.gain, app.compared.mean()));
            return;
        }
        case CompareMode::split:
        case CompareMode::off:
            for (std::size_t i = 0; i < compared_count(app); ++i) draw_compared(app, draw, i);
    }
}

// Returns true while a divider is dragged or hovered.
bool dividers(App& app, ImDrawList& draw) {
    const Compare& compare = app.document().compare;
    if (compare.mode != CompareMode::split) return false;
    static int held = -1;
    const auto scale = static_cast<float>(app.ui_scale);
    const auto y = static_cast<float>(app.picture_y);
    const auto h = static_cast<float>(app.picture_height);
    std::vector<double> places = dividers_of(app);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    int near_one = -1;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const float x =
            static_cast<float>(app.picture_x) + static_cast<float>(places[i] * app.picture_width);
        if (std::abs(mouse.x - x) < 6 * scale && mouse.y > y && mouse.y < y + h)
            near_one = static_cast<int>(i);
        const bool lit = held == static_cast<int>(i) || near_one == static_cast<int>(i);
        draw.AddLine({x, y}, {x, y + h},
                     lit ? IM_COL32(255, 255, 255, 255) : IM_COL32(255, 255, 255, 170),
                     (lit ? 2.5f : 1.5f) * scale);
        draw.AddCircleFilled({x, y + 0.5f * h}, 5 * scale, IM_COL32(255, 255, 255, 220));
    }
    if (near_one >= 0 && ImGui::IsMouseClicked(0) && !ImGui::GetIO().WantCaptureMouse)
        held = near_one;
    if (!ImGui::IsMouseDown(0) && held >= 0) {
        held = -1;
        app.end_drag();
    }
    if (held >= 0 && static_cast<std::size_t>(held) < places.size()) {
        const auto i = static_cast<std::size_t>(held);
        const double low = i == 0 ? 0.02 : places[i - 1] + 0.02;
        const double high = i + 1 < places.size() ? places[i + 1] - 0.02 : 0.98;
        places[i] = std::clamp(
            static_cast<double>(mouse.x - static_cast<float>(app.picture_x)) / app.picture_width,
            std::min(low, high), high);
        app.edit("divider", "divider", [&](Document& d) {
            if (compares_two(app))
                d.compare.middle = places.front();
            else
                d.compare.dividers = places;
        });
    }
    if (held >= 0 || near_one >= 0) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    return held >= 0 || near_one >= 0;
}

Modifiers held_keys() {
    const ImGuiIO& io = ImGui::GetIO();
    return {io.KeyShift, io.KeyCtrl, io.KeyAlt};
}

glm::dvec2 in_picture(const App& app, ImVec2 mouse) {
    return {static_cast<double>(mouse.x) - app.picture_x,
            static_cast<double>(mouse.y) - app.picture_y};
}

void scroll(App& app, glm::dvec2 at) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseWheel == 0.0f && io.MouseWheelH == 0.0f) return;
    // A step of scrolling moves as much as a drag of so many pixels.
    constexpr double kStep_px = 24.0;
    const Drag drag = scroll_of(app.remembered.touchpad, held_keys());
    if (drag == Drag::zoom)
        app.zoom_at(at, static_cast<double>(io.MouseWheel));
    else
        app.drag(drag, kStep_px * app.ui_scale *
                           glm::dvec2(static_cast<double>(io.MouseWheelH),
                                      static_cast<double>(io.MouseWheel)));
    app.end_drag();
}

void mouse_in_picture(App& app) {
    static Drag drag = Drag::none;
    static int button = -1;
    static ImVec2 pressed_at{};
    const ImGuiIO& io = ImGui::GetIO();
    const glm::dvec2 at = in_picture(app, io.MousePos);
    const bool inside =
        at.x >= 0 && at.y >= 0 && at.x < app.picture_width && at.y < app.picture_height;
    if (button < 0 && inside && !io.WantCaptureMouse) {
        for (int b = 0; b < 3; ++b)
            if (ImGui::IsMouseClicked(b)) {
                button = b;
                drag = drag_of(app.remembered.navigation, b, held_keys());
                pressed_at = io.MousePos;
            }
        scroll(app, at);
    }
    if (button < 0) return;
    const float way = std::hypot(io.MousePos.x - pressed_at.x, io.MousePos.y - pressed_at.y);
    const bool moved = io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f;
    if (drag == Drag::highlight) {
        if (ImGui::IsMouseClicked(button) || moved) app.put_highlight(at);
    } else if (drag != Drag::none && moved && way > 3.0f) {
        app.drag(drag,
                 {static_cast<double>(io.MouseDelta.x), static_cast<double>(io.MouseDelta.y)});
    }
    if (ImGui::IsMouseDown(button)) return;
    const bool plain = drag == Drag::orbit || drag == Drag::none;
    if (button == 0 && plain && way <= 3.0f) app.pick(at);
    button = -1;
    drag = Drag::none;
    app.end_drag();
}

// Where the lights are: a small ball in the corner of the picture.
void light_ball(App& app, ImDrawList& draw) {
    const auto scale = static_cast<float>(app.ui_scale);
    const float radius = 34 * scale;
    const ImVec2 center{
        static_cast<float>(app.picture_x + app.picture_width) - radius - 12 * scale,
        static_cast<float>(app.picture_y + app.picture_height) - radius - 12 * scale};
    const std::vector<Light>& lights = app.scene().lights;
    if (lights.empty()) return;
    draw.AddCircleFilled(center, radius, IM_COL32(30, 30, 30, 150), 48);
    draw.AddCircle(center, radius, IM_COL32(200, 200, 200, 150), 48, 1.2f * scale);
    const glm::dvec3 pivot(bounds_of(app.scene()).center());
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const BallPlace place =
            place_on_ball(app.editor.stage().camera, towards_light(lights[i], pivot));
        const ImVec2 at{center.x + radius * static_cast<float>(place.at.x),
                        center.y - radius * static_cast<float>(place.at.y)};
        const bool selected = static_cast<int>(i) == app.light;
        const bool dark = app.document().dark.contains(static_cast<int>(i));
        const ImU32 color = dark       ? IM_COL32(110, 110, 110, 255)
                            : selected ? IM_COL32(255, 225, 140, 255)
                                       : IM_COL32(200, 200, 200, 255);
        if (place.front)
            draw.AddCircleFilled(at, (selected ? 5.0f : 3.5f) * scale, color);
        else
            draw.AddCircle(at, (selected ? 5.0f : 3.5f) * scale, color, 0, 1.5f * scale);
    }
}

void picked_mark(App& app, ImDrawList& draw) {
    if (!app.picked || !app.panels.inspector) return;
    const auto pixel =
        pixel_of(app.editor.stage().camera, app.picked->hit.position, app.picture_size());
    if (!pixel) return;
    const auto scale = static_cast<float>(app.ui_scale);
    const ImVec2 at{static_cast<float>(app.picture_x + pixel->x),
                    static_cast<float>(app.picture_y + pixel->y)};
    draw.AddCircle(at, 7 * scale, IM_COL32(0, 0, 0, 200), 0, 3.5f * scale);
    draw.AddCircle(at, 7 * scale, IM_COL32(255, 255, 255, 255), 0, 1.5f * scale);
}

// What the colors of a view mean, in the order of SurfaceView.
std::string legend_of(SurfaceView view) {
    static constexpr const char* kVector = "red, green, blue: (v + 1) / 2";
    static constexpr const char* kUnit = "dark blue 0, light yellow 1";
    static constexpr std::array<const char*, 15> kLegends = {
        "",
        kVector,
        kVector,
        kVector,
        "hue: angle from the tangent; gray: isotropic",
        kUnit,
        kUnit,
        kUnit,
        "red u, green v",
        kUnit,
        "roots of: red, green deviation along tangent, bitangent; blue covariance",
        "gray 0 to 1; red gains energy",
        "magenta: infinite or no number",
        "dark blue 0, light yellow 45 degrees",
        kUnit};
    const auto index = static_cast<std::size_t>(view);
    return fmt::format("view: {} ({})", surface_view_names()[index], kLegends.at(index));
}

}  // namespace

void picture_view(App& app) {
    app.choose_second();
    app.picture.set_size(app.picture_width, app.picture_height);
    app.picture.set_panes(panes_of(app));
    if (app.second) {
        app.second->picture.set_size(app.picture_width, app.picture_height);
        app.second->picture.set_panes(pane_of_two(app, !now_is_first(app)));
    }
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const auto x = static_cast<float>(app.picture_x), y = static_cast<float>(app.picture_y);
    draw.PushClipRect({x, y}, {x + static_cast<float>(app.picture_width),
                               y + static_cast<float>(app.picture_height)});
    draw_panes(app, draw);
    if (!dividers(app, draw)) mouse_in_picture(app);
    light_ball(app, draw);
    picked_mark(app, draw);
    if (app.view != SurfaceView::radiance)
        label(draw, {x + 8, y + static_cast<float>(app.picture_height) - 32}, legend_of(app.view));
    draw.PopClipRect();
}

}  // namespace burnish::viewer
