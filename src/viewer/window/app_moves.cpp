// The part of App that moves cameras and lights, picks, and holds a "before".
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "burnish/error.hpp"
#include "viewer/motion/light_sphere.hpp"
#include "viewer/motion/orbit.hpp"
#include "viewer/window/app.hpp"
#include "viewer/window/app_parts.hpp"

namespace burnish::viewer {

namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

double fov_deg_of(const Camera& camera) {
    double fov = static_cast<double>(camera.yfov);
    if (camera.orthographic) {
        const double distance = static_cast<double>(glm::distance(camera.position, camera.target));
        fov = 2 * std::atan(static_cast<double>(camera.ymag) / std::max(distance, 1e-9));
    }
    return std::clamp(glm::degrees(fov), 1.0, 170.0);  // the range of camera_fov
}

void App::move_camera(const Camera& camera, std::string_view key, std::string_view name) {
    edit(key, name, [&](Document& d) {
        viewer::set_camera(d, camera.position, camera.target, fov_deg_of(camera));
    });
}

int App::dragged_light() {
    const std::vector<Light>& lights = scene().lights;
    if (lights.empty()) {
        edit({}, "add light", [](Document& d) { d.lights = {parse_light("30,45")}; });
        light = 0;
    }
    light = std::clamp(light, 0, static_cast<int>(scene().lights.size()) - 1);
    return light;
}

void App::drag(Drag kind, glm::dvec2 by) {
    last_motion_ = Clock::now();
    dragging_ = kind;
    const Camera& camera = editor.stage().camera;
    const auto move_to = [&](const Camera& moved) { move_camera(moved, "camera", "camera"); };
    switch (kind) {
        case Drag::orbit:
            return move_to(orbited(camera, by, picture_height));
        case Drag::pan:
            return move_to(panned(camera, by, picture_height));
        case Drag::zoom:
            return move_to(zoomed(camera, std::exp(0.005 * by.y), glm::dvec3(camera.target)));
        case Drag::environment: {
            // A drag as long as the picture is wide turns the environment once.
            const double turn = 360.0 * by.x / std::max(picture_width, 1);
            edit("environment_rotation", "environment_rotation", [&](Document& d) {
                double angle = d.values.real("environment_rotation") + turn;
                angle -= 360.0 * std::floor((angle + 180.0) / 360.0);
                viewer::set_parameter(d, "environment_rotation", angle);
            });
            return;
        }
        case Drag::light: {
            const auto index = static_cast<std::size_t>(dragged_light());
            const glm::dvec3 pivot(bounds_of(scene()).center());
            std::vector<Light> lights = scene().lights;
            lights[index] = viewer::dragged_light(camera, lights[index], pivot, by, picture_height);
            edit("light", "light", [&](Document& d) { d.lights = lights; });
            return;
        }
        case Drag::highlight:
        case Drag::none:
            return;
    }
}

void App::note_motion() {
    last_motion_ = Clock::now();
}

void App::end_drag() {
    dragging_ = Drag::none;
    editor.close_step();
}

void App::zoom_at(glm::dvec2 pixel, double steps) {
    last_motion_ = Clock::now();
    const Camera moved = zoomed(editor.stage().camera, wheel_factor(steps), pixel, picture_size());
    move_camera(moved, "camera", "camera");
}

void App::frame_all() {
    const Bounds bounds = bounds_of(scene());
    const Camera moved = framed(editor.stage().camera, bounds,
                                static_cast<double>(picture_width) / std::max(picture_height, 1));
    move_camera(moved, {}, "frame");
}

void App::put_highlight(glm::dvec2 pixel) {
    last_motion_ = Clock::now();
    dragging_ = Drag::highlight;
    const Camera& camera = editor.stage().camera;
    const auto hit = viewer::pick(scene(), picker_, camera, pixel, picture_size());
    if (!hit) return;
    const auto index = static_cast<std::size_t>(dragged_light());
    const auto placed = light_for_highlight(scene(), *hit, towards_eye(camera, hit->position),
                                            scene().lights[index]);
    if (!placed) return say("no light above the horizon puts the highlight there");
    std::vector<Light> lights = scene().lights;
    lights[index] = *placed;
    edit("light", "highlight", [&](Document& d) { d.lights = lights; });
}

void App::pick(glm::dvec2 pixel) {
    const Camera& camera = editor.stage().camera;
    const auto hit = viewer::pick(scene(), picker_, camera, pixel, picture_size());
    if (!hit) {
        picked.reset();
        return;
    }
    Picked found;
    found.hit = *hit;
    found.pixel = pixel;
    picked = std::move(found);
    pick_again();
    panels.inspector = true;
}

void App::pick_again() {
    if (!picked) return;
    const Camera& camera = editor.stage().camera;
    const glm::dvec3 at = picked->hit.position;
    std::vector<Method> methods = document().compare.mode == CompareMode::off
                                      ? std::vector<Method>{}
                                      : document().compare.methods;
    const Method own = scene().materials[static_cast<std::size_t>(picked->hit.material)].method;
    for (const Method m : {own, Method::normal_map, Method::follow_grain, Method::deform_smooth})
        if (std::ranges::find(methods, m) == methods.end() && methods.size() < kMostCompared)
            methods.push_back(m);
    const glm::dvec3 to_eye = towards_eye(camera, at);
    glm::dvec3 to_light(picked->hit.normal);
    if (!scene().lights.empty()) {
        light = std::clamp(light, 0, static_cast<int>(scene().lights.size()) - 1);
        to_light = towards_light(scene().lights[static_cast<std::size_t>(light)], at);
    }
    try {
        picked->report = inspect(scene(), picked->hit, to_eye, to_light, methods);
        picked->albedos.clear();
        for (const MethodReport& m : picked->report.methods)
            picked->albedos.push_back(m.lobe.has_meaning()
                                          ? lobe_albedo(m.lobe, picked->report.to_eye, 2048)
                                          : LobeAlbedo{});
    } catch (const Error& error) {
        say(error.what(), true);
        picked.reset();
    }
}

// --- before and after -----------------------------------------------------------------------------

Document seen_as(const Document& held, const Document& now) {
    Document document = held;
    for (const Parameter& p : parameter_table())
        if (p.group != ParameterGroup::material && p.group != ParameterGroup::mesh)
            document.values.erase(p.name);
    for (const auto& [name, value] : now.values.set_values()) {
        const ParameterGroup group = find_parameter(name)->group;
        if (group != ParameterGroup::material && group != ParameterGroup::mesh)
            document.values.set_value(name, value);
    }
    document.lights = now.lights;
    document.environment = now.environment;
    return document;
}

void App::hold() {
    before = std::make_unique<Editor>(editor);
    before_picture = std::make_unique<Picture>(context);
    if (document().compare.mode == CompareMode::off)
        edit({}, "compare", [](Document& d) { d.compare.mode = CompareMode::split; });
    say("held as before: changes are compared with it (H lets it go)");
}

void App::release() {
    before.reset();
    before_picture.reset();
    compared.invalidate();
}

}  // namespace burnish::viewer
