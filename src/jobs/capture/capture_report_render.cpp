// Renders the material on models, lit by two lamps.
#include <fmt/format.h>

#include <memory>

#include "burnish/context.hpp"
#include "burnish/error.hpp"
#include "burnish/renderer.hpp"
#include "burnish/stage.hpp"
#include "jobs/capture/capture_report_parts.hpp"

namespace burnish::report {

namespace {

StageRequest stage_request(const CaptureReportRequest& request, const std::string& model) {
    StageRequest stage;
    stage.input = model;
    stage.environment = "none";
    stage.lights = {"-40,40,4", "110,25,2"};
    const auto set = [&](const char* name, const std::string& value) {
        stage.values.set(name, value, "report");
    };
    set("tabulated", request.material.string());
    set("width", "480");
    set("height", "360");
    set("samples", "8");
    set("background", "color");
    set("background_color", "0.03,0.03,0.03");
    return stage;
}

}  // namespace

void add_renderings(const CaptureReportRequest& request, Page& page, Pictures& pictures,
                    const Progress& progress) {
    std::vector<std::string> models = {"builtin:sphere", "builtin:drape"};
    if (!request.model.empty()) models = {request.model};
    std::unique_ptr<gpu::Context> context;
    for (std::size_t k = 0; k < models.size(); ++k) {
        // An invalid model is an error even if there is no renderer.
        const Stage stage = set_stage(stage_request(request, models[k]));
        for (const std::string& warning : stage.scene.warnings) page.notes.push_back(warning);
        try {
            if (!context) context = std::make_unique<gpu::Context>(request.gl_device);
        } catch (const Interrupted&) {
            throw;
        } catch (const Error& error) {
            page.notes.push_back(fmt::format(
                "Nothing was rendered: there is no OpenGL on this machine ({}).", error.what()));
            return;
        }
        page.device = context->renderer();
        gpu::Renderer renderer(*context, stage.scene, nullptr);
        RenderSettings settings = stage.settings;
        settings.robust_limit = robust_limit(stage.values);
        const Image linear = renderer.render(stage.camera, settings, progress);
        const std::string file = fmt::format("render_{}.png", k);
        pictures.push_back({file, to_display(linear, stage.exposure_ev, stage.tone_map)});
        page.renderings.emplace_back(models[k], file);
    }
}

}  // namespace burnish::report
