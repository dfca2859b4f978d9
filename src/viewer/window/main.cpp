// burnish-view: the window of `burnish view`, which starts it in its own place.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "burnish/context.hpp"
#include "burnish/error.hpp"
#include "burnish/version.hpp"
#include "gpu/device/gl.hpp"
#include "image/codecs.hpp"
#include "viewer/window/panels.hpp"
#include "viewer/window/script_runner.hpp"
#include "viewer/window/theme.hpp"

namespace burnish::viewer {
namespace {

constexpr const char* kExamples = R"(
Without a file a sphere of scratched, brushed steel is shown. Models, scenes, environments, maps, weaving
drafts, measured and captured materials can be dropped on the window. ? shows the keys.

Examples:
  burnish view
  burnish view model.glb sky.hdr
  burnish view scene.json --script pictures.txt)";

// Seconds of drawing between two looks at the events, while the picture refines.
constexpr double kBudget_s = 0.03;
// Between the frames that show progress, a blink and the end of a message.
constexpr double kSlowFrame_s = 0.1;
// Frames after an event in which ImGui settles.
constexpr int kSettleFrames = 3;

struct Flags {
    std::vector<std::string> files;
    std::string script, size, state;
    double ui_scale = 0;
};

class ImGuiContextOfWindow {
  public:
    explicit ImGuiContextOfWindow(const Window& window) {
        IMGUI_CHECKVERSION();
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
        ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
        ImGui_ImplOpenGL3_Init("#version 330 core");
    }
    ~ImGuiContextOfWindow() {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }
    ImGuiContextOfWindow(const ImGuiContextOfWindow&) = delete;
    ImGuiContextOfWindow& operator=(const ImGuiContextOfWindow&) = delete;
};

void draw_frame(App& app, ScriptRunner* script) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    if (script != nullptr) script->feed_input();
    ImGui::NewFrame();
    if (script != nullptr) script->run();
    draw_interface(app);
    // After the interface: what it has changed is in the picture of the same frame.
    app.update();
    app.draw_picture(kBudget_s);
    ImGui::Render();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, app.window.width(), app.window.height());
    glClearColor(0.1f, 0.1f, 0.1f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    {
        const auto time = app.costs.time_interface();
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    }
    if (script != nullptr) {
        glFinish();
        script->after_draw();
    }
    app.window.swap();
    app.require_context();
    app.count_frame();
}

void loop(App& app, ScriptRunner* script) {
    const auto busy = [&] {
        return app.needs_frames() || (script != nullptr && script->needs_frame());
    };
    int settle = kSettleFrames;
    while (!app.window.should_close()) {
        if (settle > 0 || busy()) {
            app.window.poll();
        } else {
            app.window.wait(script != nullptr         ? 0.05
                            : app.needs_slow_frames() ? kSlowFrame_s
                                                      : 1.0);
            app.update();  // files and autosave
        }
        if (app.window.take_events()) settle = kSettleFrames;
        const std::vector<std::string> dropped = app.window.take_dropped();
        if (!dropped.empty()) app.open(dropped);
        if (settle == 0 && !busy() && !app.needs_slow_frames()) {
            if (script != nullptr) script->run_idle();
        } else {
            settle = std::max(settle - 1, 0);
            draw_frame(app, script);
        }
        if (script != nullptr && script->done()) app.window.close();
    }
}

// WIDTHxHEIGHT, of a window that holds its menu and a picture.
WindowOptions size_of(const std::string& text) {
    WindowOptions options;
    const char* const end = text.data() + text.size();
    const auto [x, first] = std::from_chars(text.data(), end, options.width);
    const bool has_x = first == std::errc() && x != end && *x == 'x';
    const auto [stop, second] = std::from_chars(has_x ? x + 1 : end, end, options.height);
    if (!has_x || second != std::errc() || stop != end || options.width < 320 ||
        options.height < 240 || std::max(options.width, options.height) > 16384)
        throw UsageError("--size", "", "WIDTHxHEIGHT from 320x240 to 16384x16384, such as 1280x720",
                         shown(text));
    return options;
}

// The codecs of pictures, which take a quarter of a second to load.
void load_codecs() {
    try {
        codecs();
    } catch (const Error&) {
        // It is said where a picture is read.
    }
}

// Large blocks go back to the system when they are freed. Otherwise glibc raises the size from which they do
// with each one that is freed, and textures of models that were closed stay in its heaps.
void give_back_memory() {
#ifdef __GLIBC__
    constexpr int kLarge = 1 << 20;  // a page fault costs less than what is done with so many bytes
    mallopt(M_MMAP_THRESHOLD, kLarge);
    mallopt(M_TRIM_THRESHOLD, kLarge);
    mallopt(M_ARENA_MAX, 2);  // heaps; by default eight a processor
#endif
}

void run(const Flags& flags) {
    std::vector<Command> commands;
    if (!flags.script.empty()) commands = load_script(flags.script);
    const std::filesystem::path state = flags.state == "none" ? std::filesystem::path{}
                                        : flags.state.empty() ? state_folder()
                                                              : std::filesystem::path(flags.state);
    // While the window is made.
    std::future<void> loading;
    if (!flags.files.empty()) loading = std::async(std::launch::async, load_codecs);
    std::vector<std::string> ignored;
    WindowOptions options;
    // A script starts from the same window everywhere, unless it is given a state.
    if (!state.empty() && (flags.script.empty() || !flags.state.empty())) {
        const Remembered last = load_remembered(state, ignored);
        options = {last.width, last.height, last.x, last.y, last.maximized};
    }
    if (!flags.size.empty()) options = size_of(flags.size);
    Window window(options);
    gpu::Context context = gpu::Context::adopt_current();
    const ImGuiContextOfWindow imgui(window);
    App app(window, context, state);
    app.ui_scale =
        flags.ui_scale > 0 ? flags.ui_scale : static_cast<double>(window.content_scale());
    set_theme(static_cast<float>(app.ui_scale));
    std::unique_ptr<ScriptRunner> script;
    if (!flags.script.empty()) {
        app.panels = {};
        script = std::make_unique<ScriptRunner>(app, std::move(commands), flags.script);
    }
    app.open_first(flags.files);
    loop(app, script.get());
}

}  // namespace
}  // namespace burnish::viewer

int main(int argc, char** argv) {
    using namespace burnish;
    viewer::give_back_memory();
    viewer::Flags flags;
    CLI::App app(
        "The window in which highlights are judged: a model, a material or a scene, moved by hand.",
        "burnish view");
    app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    app.add_option("files", flags.files, "models, scenes, environments, maps, materials")
        ->type_name("FILE")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--script", flags.script, "commands to run (docs/guide/viewer.md), then quit")
        ->type_name("FILE");
    app.add_option("--size", flags.size, "of the window, in place of the remembered one")
        ->type_name("WxH");
    app.add_option("--ui-scale", flags.ui_scale, "size of text and panels (default: the desktop's)")
        ->check(CLI::Range(0.5, 4.0))
        ->type_name("NUMBER");
    app.add_option("--state", flags.state, "folder of what is remembered, or none")
        ->type_name("FOLDER");
    app.set_version_flag("--version", "burnish " + std::string(version()));
    app.footer(viewer::kExamples);
    try {
        app.parse(argc, argv);
        viewer::run(flags);
        return 0;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);
        std::fprintf(stderr, "burnish: %s\n", one_line(error.what()).c_str());
        return 2;
    } catch (const UsageError& error) {
        std::fprintf(stderr, "burnish: %s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "burnish: %s\n", one_line(error.what()).c_str());
        return 1;
    }
}
