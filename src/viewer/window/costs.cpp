#include "viewer/window/costs.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <numeric>
#include <string>
#include <vector>

#include "gpu/device/program.hpp"
#include "viewer/window/panels.hpp"

namespace burnish::viewer {
namespace {

// A mean in which the last frame counts 0.3; the first frame, and a pass that is not drawn any more, at
// once.
void blend(double& mean, double last) {
    mean = mean > 0 && last > 0 ? 0.7 * mean + 0.3 * last : last;
}

void passes(const Costs& costs) {
    const double frame_ms = costs.ms("frame").value_or(0.0);
    std::vector<std::string_view> names(gpu::pass_names().begin(), gpu::pass_names().end());
    names.insert(names.end(), {"interface", "frame"});
    if (ImGui::BeginTable("passes", 2)) {
        for (const std::string_view name : names) {
            const double ms = costs.ms(name).value_or(0.0);
            if (!(ms > 0)) continue;
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            std::string words(name);
            for (char& c : words)
                if (c == '-') c = ' ';
            ImGui::AlignTextToFramePadding();
            ImGui::TextUnformatted(words.c_str());
            ImGui::TableNextColumn();
            const std::string text = fmt::format("{:.2f} ms", ms);
            if (name == "frame")
                ImGui::TextUnformatted(text.c_str());
            else
                ImGui::ProgressBar(static_cast<float>(ms / frame_ms), {-1, 0}, text.c_str());
        }
        ImGui::EndTable();
    }
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("One sample of one pane; display and interface: one frame. %s",
                       costs.by_device() ? "By the device's timer."
                                         : "By the clock, as the device has no timer that can be "
                                           "believed: each pass waits for the one before, which "
                                           "slows frames down while this panel is open.");
    ImGui::PopStyleColor();
}

}  // namespace

void Costs::follow(bool wanted, Picture& picture) {
    if (wanted != on_) {
        on_ = wanted;
        picture.renderer().measure_passes(on_);
        interface_.measure(on_);
        passes_ms_ = {};
        interface_ms_ = 0;
        if (on_) picture.restart();
        return;
    }
    if (!on_) return;
    const gpu::PassTimes times = picture.renderer().take_pass_times();
    by_device_ = times.by_device;
    for (std::size_t i = 0; i < gpu::kPassCount; ++i) {
        const bool once_a_frame = static_cast<gpu::Pass>(i) == gpu::Pass::display;
        const int count = once_a_frame ? times.presents : times.samples;
        if (count > 0) blend(passes_ms_[i], 1000 * times.seconds[i] / count);
    }
    blend(interface_ms_, 1000 * interface_.take().front());
}

std::optional<double> Costs::ms(std::string_view name) const {
    if (name == "interface") return interface_ms_;
    if (name == "frame")
        return std::accumulate(passes_ms_.begin(), passes_ms_.end(), interface_ms_);
    for (std::size_t i = 0; i < gpu::kPassCount; ++i)
        if (gpu::pass_names()[i] == name) return passes_ms_[i];
    return std::nullopt;
}

void costs_panel(App& app) {
    ImGui::Text("device: %s", app.context.renderer().c_str());
    ImGui::Text("picture: %d x %d pixels", app.picture_width, app.picture_height);
    ImGui::Text("resolution while moving: %.0f %%", 100 * app.picture.scale());
    ImGui::Text("frames a second: %.1f, at the least %.1f", app.frames_per_second,
                app.lowest_frames_per_second);
    ImGui::Text("samples: %d of %d", app.picture.samples(), app.picture.wanted_samples());
    ImGui::Text("last samples: %.1f ms", 1000 * app.picture.last_sample_s());
    ImGui::Separator();
    passes(app.costs);
    ImGui::Separator();
    const auto counts = app.picture.renderer().uploads();
    ImGui::Text("uploads: %d meshes, %d textures", static_cast<int>(counts.meshes),
                static_cast<int>(counts.textures));
    ImGui::Text("%d environments, programs compiled: %zu", static_cast<int>(counts.environments),
                app.context.programs().size());
}

}  // namespace burnish::viewer
