// The part of App that moves cameras and lights, picks, and holds a "before".
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "burnish/error.hpp"
#include "viewer/document/file_names.hpp"
#include "viewer/document/scene_lists.hpp"
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
    if (scene().lights.empty()) add_light(LightType::directional);
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
            std::vector<Light> lights = all_lights(document(), editor.stage());
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
                                            all_lights(document(), editor.stage())[index]);
    if (!placed) return say("no light above the horizon puts the highlight there");
    std::vector<Light> lights = all_lights(document(), editor.stage());
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
        picked->version = ++reports_made_;
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

void App::copy_lobe(std::size_t method) {
    if (!picked || method >= picked->report.methods.size()) return;
    const LobeReport& report = picked->report;
    const MethodReport& m = report.methods[method];
    if (const auto rows = csv_rows(report, m)) {
        window.set_clipboard(csv_header() + "\n" + *rows);
        return say("copied rows for `burnish brdf eval`");
    }
    if (const auto row = mdf_csv_row(report, m)) {
        window.set_clipboard(mdf_csv_header() + "\n" + *row);
        return say("copied a row for `burnish mdf eval`: brdf eval has no row for this method");
    }
    say("no row of numbers says the same as this lobe");
}

// --- the second picture of a comparison -------------------------------------------------------------

void App::hold() {
    const bool off = document().compare.mode == CompareMode::off;
    if (off || document().compare.materials)
        edit({}, "compare", [&](Document& d) {
            if (off) d.compare.mode = CompareMode::split;
            d.compare.materials.reset();
        });
    second = std::make_unique<SecondPicture>(context, editor);
    say("held as before: changes are compared with it (H lets it go)");
}

void App::release() {
    second.reset();
    compared.invalidate();
}

void App::compare_materials(const MaterialPair& pair, CompareMode mode) {
    try {
        // What cannot be drawn is not chosen.
        auto chosen = std::make_unique<SecondPicture>(context, editor, pair);
        const bool done = edit({}, "compare materials", [&](Document& d) {
            d.compare.mode = mode;
            d.compare.materials = pair;
        });
        if (!done) return;
        second = std::move(chosen);
        second_of_ = {pair, editor.revisions().scene};
        compared.invalidate();
    } catch (const std::exception& error) {
        say(one_line(error.what()), true);
    }
}

void App::compare_with_file(const std::string& path) {
    const Compare& now = document().compare;
    const int of = now.materials ? now.materials->material : material.value_or(0);
    compare_materials({of, absolute_name(path)},
                      now.mode == CompareMode::off ? CompareMode::split : now.mode);
}

void App::compare_methods(const std::vector<Method>& methods, CompareMode mode) {
    if (holds_before()) release();
    edit({}, "compare", [&](Document& d) {
        d.compare.mode = mode;
        d.compare.materials.reset();
        if (methods.empty() || methods == d.compare.methods) return;
        d.compare.methods = methods;
        d.compare.dividers.clear();
    });
}

void App::choose_second() {
    if (holds_before()) return;
    const std::optional<MaterialPair>& pair = document().compare.materials;
    if (!pair) {
        if (second) release();
        second_of_.reset();
        return;
    }
    const std::pair<MaterialPair, std::uint64_t> wanted{*pair, editor.revisions().scene};
    if (second_of_ == wanted || document().compare.mode == CompareMode::off) return;
    second_of_ = wanted;  // refused once, it is not tried again
    release();
    try {
        second = std::make_unique<SecondPicture>(context, editor, *pair);
    } catch (const std::exception& error) {
        say(one_line(error.what()), true);
    }
}

}  // namespace burnish::viewer
