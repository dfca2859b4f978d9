// The part of App that reads and writes files.
#include <fmt/format.h>

#include "burnish/builtin_meshes.hpp"
#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "jobs/capture/capture_fit.hpp"
#include "jobs/export_material.hpp"
#include "viewer/document/file_names.hpp"
#include "viewer/document/load_stage.hpp"
#include "viewer/document/open_files.hpp"
#include "viewer/document/save_scene.hpp"
#include "viewer/document/taken_back.hpp"
#include "viewer/generate/save_maps.hpp"
#include "viewer/window/app.hpp"
#include "viewer/window/app_parts.hpp"

namespace burnish::viewer {
namespace {

constexpr double kLook_s = 1.0;  // between looks at the files on disk

}  // namespace

void App::load(Document document, std::string name, std::function<void(Document, Stage)> adopt) {
    generator.cancel(*this);
    const auto wanted = std::make_shared<const Document>(std::move(document));
    loader_.start<Stage>(
        name, [wanted](const Progress& progress) { return load_stage(*wanted, progress); },
        [this, wanted, adopt = std::move(adopt)](Stage stage) {
            try {
                const std::string before = this->document().input;
                adopt(*wanted, std::move(stage));
                if (this->document().input != before) {
                    saved_scene_.clear();
                    saved_document_.reset();
                }
                report_new_warnings();
                after_change();
            } catch (const std::exception& error) {
                say(one_line(error.what()), true);
            }
        },
        [this](const std::string& line) { say(line, true); });
}

void App::open_document(Document document, const std::string& name) {
    load(std::move(document), name, [this](Document d, Stage stage) {
        editor.open_loaded(std::move(d), std::move(stage));
        material.reset();
        picked.reset();
    });
}

std::vector<std::string> App::without_rigs(std::vector<std::string> paths) {
    std::erase_if(paths, [this](const std::string& path) {
        if (!is_unfitted_rig(path)) return false;
        rig_to_fit_ = std::filesystem::absolute(path).string();
        add_recent(remembered, *rig_to_fit_);
        return true;
    });
    return paths;
}

// The file is kept with the state, under a name that tells rigs and their changes apart.
void App::fit_rig() {
    if (!rig_to_fit_ || loader_.running()) return;
    const std::filesystem::path rig = *std::exchange(rig_to_fit_, std::nullopt);
    const std::filesystem::path folder =
        (state_folder.empty() ? std::filesystem::temp_directory_path() / "burnish-view"
                              : state_folder) /
        "captures";
    std::error_code error;
    const auto changed = std::filesystem::last_write_time(rig, error).time_since_epoch().count();
    const std::size_t number =
        std::hash<std::string>()(fmt::format("{} {}", rig.string(), changed));
    const std::filesystem::path fitted =
        folder / fmt::format("{}-{:016x}.exr", rig.parent_path().filename().string(), number);
    // In place of the scene of the start, or onto what is shown.
    const auto show = [this, fitted] {
        if (editor.history().can_undo()) return open({fitted.string()});
        open_document(document_for(std::vector{fitted.string()}), fitted.string());
    };
    if (std::filesystem::exists(fitted, error)) return show();
    std::filesystem::create_directories(folder, error);
    say(fmt::format("{}: fitted in the background; its material is shown when it is done",
                    rig.string()));
    CaptureFitRequest request;
    request.stack = rig;
    request.output = fitted;
    request.command = "burnish view";
    loader_.start<CaptureFitResult>(
        "fit of " + rig.filename().string(),
        [request](const Progress& progress) { return capture_fit(request, progress); },
        [this, show, fitted](const CaptureFitResult& result) {
            for (const std::string& line : result.warnings) say(line);
            say(fmt::format("fitted: {:.2g} % of the light unexplained, in {}",
                            100 * result.unexplained, fitted.string()));
            show();
        },
        [this](const std::string& line) { say(line, true); });
}

void App::open_first(std::vector<std::string> paths) {
    try {
        paths = without_rigs(std::move(paths));
        std::vector<std::string> notes;
        Document document = document_for(paths, &notes);
        for (const std::string& path : paths) add_recent(remembered, path);
        for (std::string& note : notes) say(std::move(note));
        open_document(std::move(document), paths.empty() ? "the first scene" : paths.front());
    } catch (const Error& error) {
        say(error.what(), true);
        open_document(first_document(), "the first scene");
    }
}

void App::open(const std::vector<std::string>& dropped) {
    try {
        const std::vector<std::string> paths = without_rigs(dropped);
        if (paths.empty()) return;
        std::vector<std::string> notes;
        Document next = document();
        for (const std::string& path : paths) next = opened(next, path, material, &notes);
        for (const std::string& path : paths) add_recent(remembered, path);
        for (std::string& note : notes) say(std::move(note));
        if (needs_load(document(), next)) {
            load(std::move(next), paths.front(), [this](Document d, Stage stage) {
                editor.set_loaded(std::move(d), std::move(stage), "open");
                material.reset();
                picked.reset();
            });
        } else {
            const std::vector<ParameterValues> before = editor.stage().materials.values();
            editor.set(std::move(next), {}, "open");
            report_new_warnings();
            say_taken_back(before);
            after_change();
        }
    } catch (const std::exception& error) {
        say(one_line(error.what()), true);
    }
}

void App::save_scene(const std::filesystem::path& path) {
    viewer::save_scene(document(), editor.stage(), path, generator.cache());
    saved_scene_ = path.string();
    saved_document_ = document();
    add_recent(remembered, path.string());
    say("saved " + path.string());
}

Image App::drawn(const Camera& camera, RenderSettings settings, bool linear) {
    settings.view = view;
    if (!linear) settings.robust_limit = robust_limit(editor.stage().values);
    Image image = picture.render(camera, settings, {});
    if (linear) return image;
    const bool radiance = view == SurfaceView::radiance;
    return to_display(image, radiance ? editor.stage().exposure_ev : 0.0,
                      radiance ? editor.stage().tone_map : ToneMap::linear);
}

void App::save_picture(const std::filesystem::path& path, std::optional<Size> size) {
    RenderSettings settings = editor.stage().settings;
    settings.width = size ? size->width : picture_width;
    settings.height = size ? size->height : picture_height;
    const Camera camera = editor.camera_of(static_cast<double>(settings.width) / settings.height);
    write_image(path, drawn(camera, settings, holds_linear(path)), {},
                write_options(editor.stage().values));
    say("saved " + path.string());
}

void App::save_gltf(const std::filesystem::path& folder) {
    // The job reads a scene file: the document goes through one that lies beside the folder.
    const std::filesystem::path scene_file =
        std::filesystem::absolute(folder).parent_path() / ".burnish-view-export.json";
    viewer::save_scene(document(), editor.stage(), scene_file);
    ExportMaterialRequest request;
    request.stage.input = scene_file.string();
    if (material) request.material = std::to_string(*material);
    request.preview = false;  // it would need a context of its own
    request.output = folder;
    request.command = "burnish view";
    loader_.start<ExportMaterialReport>(
        "export",
        [request, scene_file](const Progress& progress) {
            const ExportMaterialReport report = export_material(request, progress);
            std::error_code error;
            std::filesystem::remove(scene_file, error);
            return report;
        },
        [this, folder](const ExportMaterialReport& report) {
            for (const std::string& line : report.warnings) say(line);
            say(fmt::format("saved {} files in {}", report.written.size(), folder.string()));
        },
        [this, scene_file](const std::string& line) {
            std::error_code error;
            std::filesystem::remove(scene_file, error);
            say(line, true);
        });
}

void App::save_maps(const std::filesystem::path& folder) {
    const MapsRequest request = maps_request(editor.stage(), material, folder);
    loader_.start<SavedMaps>(
        "maps", [request](const Progress& progress) { return make_maps(request, progress); },
        [this, folder, what = request.what](const SavedMaps& saved) {
            for (const std::string& line : saved.warnings) say(line);
            say(fmt::format("saved the {}: {} files in {}", what, saved.written.size(),
                            folder.string()));
        },
        [this](const std::string& line) { say(line, true); });
}

SceneName App::name_of_scene() {
    if (!saved_scene_.empty()) return {absolute_name(saved_scene_), false};
    if (named_ != editor.revisions().scene) input_name_ = scene_name(document(), editor.stage());
    named_ = editor.revisions().scene;
    return input_name_;
}

void App::name_window() {
    const SceneName scene = name_of_scene();
    const bool is_file = !is_builtin(scene.path);
    std::string title =
        is_file ? std::filesystem::path(scene.path).filename().string() : scene.path;
    if (scene.recovered) title += " (recovered)";
    if (!watched_.missing().empty()) title += " (gone from disk)";
    if (title == title_) return;
    title_ = std::move(title);
    window.set_title(title_.empty() ? "Burnish" : one_line(title_) + " - Burnish");
}

void App::follow_files() {
    if (seconds_since(last_look_) < kLook_s || loader_.running()) return;
    last_look_ = std::chrono::steady_clock::now();
    const WatchedFiles::Changes changes = watched_.look(files_of(document(), editor.stage()));
    if (!changes.gone.empty()) say(missing_files());
    if (!changes.changed && changes.back.empty()) return;
    say(changes.back.empty() ? "a file has changed: read again"
                             : "a file is back on disk: read again");
    load(document(), "reload",
         [this](const Document&, Stage stage) { editor.reloaded(std::move(stage)); });
}

void App::say_taken_back(const std::vector<ParameterValues>& before) {
    std::string line = line_of_taken_back(before, editor.stage().materials.values());
    if (!line.empty()) say(std::move(line));
}

CommandLine App::command_line() const {
    const std::string scene = saved_scene_.empty() ? "scene.json" : saved_scene_;
    return render_command(document(), editor.stage(), scene, "picture.png");
}

void App::copy_command_line() {
    const CommandLine command = command_line();
    window.set_clipboard(command.text());
    if (command.needs_scene && saved_document_ != document())
        say(fmt::format("copied: {} (save the scene there first: flags cannot say {})",
                        command.text(), command.reason));
    else
        say("copied: " + command.text());
}

}  // namespace burnish::viewer
