// The panel of the generator of scratches.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <random>

#include "viewer/window/panels.hpp"

namespace burnish::viewer {
namespace {

using Change = std::function<void(ScratchChoice&)>;

// Sliders show the coarse maps while they are dragged, and have the full ones made when they are let go.
class Rows {
  public:
    explicit Rows(App& app) : app_(app) {}

    void real(const char* label, double value, double low, double high, const char* format,
              const char* tip, const std::function<void(ScratchChoice&, double)>& set,
              bool logarithmic = true) {
        begin(label, tip);
        auto v = static_cast<float>(value);
        const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp |
                                       ImGuiSliderFlags_NoRoundToFormat |
                                       (logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
        if (ImGui::SliderFloat("##v", &v, static_cast<float>(low), static_cast<float>(high), format,
                               flags)) {
            // What the fingers set has the digits of a float, and no more.
            const double set_to = std::clamp(std::stod(fmt::format("{:.4g}", v)), low, high);
            app_.generator.change(app_, [&](ScratchChoice& c) { set(c, set_to); });
            app_.note_motion();
        }
        end(tip);
    }

    void whole(const char* label, int value, int low, int high, const char* tip,
               const std::function<void(ScratchChoice&, int)>& set) {
        begin(label, tip);
        int v = value;
        if (ImGui::DragInt("##v", &v, 0.1f, low, high, "%d", ImGuiSliderFlags_AlwaysClamp)) {
            app_.generator.change(app_, [&](ScratchChoice& c) { set(c, v); });
            app_.note_motion();
        }
        end(tip);
    }

    // A list; choosing is a complete change.
    void list(const char* label, const std::string& now, const std::vector<std::string>& names,
              const char* tip, const std::function<void(ScratchChoice&, std::size_t)>& set) {
        begin(label, tip);
        if (ImGui::BeginCombo("##v", now.c_str(), ImGuiComboFlags_HeightLarge)) {
            for (std::size_t i = 0; i < names.size(); ++i)
                if (ImGui::Selectable(names[i].c_str(), names[i] == now))
                    complete([&](ScratchChoice& c) { set(c, i); });
            ImGui::EndCombo();
        }
        ImGui::PopID();
    }

    void complete(const Change& change) {
        app_.generator.change(app_, change);
        app_.generator.finish();
        app_.note_motion();
    }

  private:
    void begin(const char* label, const char* tip) {
        ImGui::PushID(label);
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(label);
        explain(tip);
        ImGui::SameLine(ImGui::GetFontSize() * 6.6f);
        ImGui::SetNextItemWidth(-1);
    }
    void end(const char* tip) {
        if (ImGui::IsItemDeactivatedAfterEdit()) app_.generator.finish();
        if (!ImGui::IsItemActive()) explain(tip);
        ImGui::PopID();
    }
    static void explain(const char* tip) {
        if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 26);
        ImGui::TextUnformatted(tip);
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }

    App& app_;
};

// The strongest for which the grooves of all layers are no deeper than half their width.
double most_strength(const ScratchSettings& settings) {
    double most = kMostScratchStrength;
    for (const ScratchLayer& layer : settings.layers)
        if (layer.depth_mm.typical() > 0)
            most = std::min(most, 0.5 * layer.width_mm.typical() / layer.depth_mm.typical());
    return most;
}

void base_row(Rows& rows, const ScratchChoice& choice) {
    std::vector<std::string> names;
    for (const std::string_view name : scratch_preset_names()) names.emplace_back(name);
    // A folder of the cache has a name that says nothing.
    const bool preset = std::ranges::find(names, choice.base) != names.end();
    const std::string folder = std::filesystem::path(choice.base).filename().string();
    const bool generated =
        folder.size() == 16 && folder.find_first_not_of("0123456789abcdef") == std::string::npos;
    const std::string now = preset ? choice.base : generated ? "as saved" : folder;
    rows.list("preset", now, names, "What wore the surface. The rest of the panel starts from it.",
              [&](ScratchChoice& c, std::size_t i) {
                  // Size, tile and seed are no part of a preset.
                  const ScratchSettings before = c.recipe.settings;
                  c = scratch_choice(names[i]);
                  c.recipe.settings.size = before.size;
                  c.recipe.settings.tile_mm = before.tile_mm;
                  c.recipe.settings.seed = before.seed;
              });
}

void tile_rows(Rows& rows, const ScratchSettings& s) {
    rows.whole(
        "seed", static_cast<int>(std::min(s.seed, 2147483647u)), 0, 2147483647,
        "Of all random choices: another seed, other scratches of the same kind.",
        [](ScratchChoice& c, int v) { c.recipe.settings.seed = static_cast<std::uint32_t>(v); });
    rows.real("tile", s.tile_mm, 10, 200, "%.4g mm",
              "Side of the tile on the surface. Scratches keep their size in millimeters: a larger "
              "tile holds more of them. It repeats as uv_scale, or physical_size, says.",
              [](ScratchChoice& c, double v) { c.recipe.settings.tile_mm = v; });
    static constexpr std::array kSizes = {512, 1024, 2048, 4096};
    std::vector<std::string> names;
    for (const int size : kSizes) names.push_back(fmt::format("{} texels", size));
    rows.list("size", fmt::format("{} texels", s.size), names,
              "Side of the full map. Scratches narrower than two texels become wide and shallow.",
              [](ScratchChoice& c, std::size_t i) { c.recipe.settings.size = kSizes[i]; });
}

void layer_rows(Rows& rows, const ScratchChoice& choice) {
    const ScratchSettings& s = choice.recipe.settings;
    const ScratchLayer& layer = s.layers.front();
    const auto of_layer = [](double ScratchLayer::*member) {
        return
            [member](ScratchChoice& c, double v) { c.recipe.settings.layers.front().*member = v; };
    };
    const auto of_spread = [](Spread ScratchLayer::*member) {
        return [member](ScratchChoice& c, double v) {
            set_typical(c.recipe.settings.layers.front().*member, v);
        };
    };
    const auto share_of = [](const Spread& spread) {
        return spread.highest() > 0 ? spread.typical() / spread.highest() : 1.0;
    };
    const bool aimless = layer.field == ScratchField::random;
    ImGui::BeginDisabled(aimless);
    rows.real("angle", layer.angle_deg, -180, 180, "%.1f deg",
              aimless
                  ? "These scratches run in every direction."
                  : "Direction of the scratches, counter-clockwise; it turns circles into spirals.",
              of_layer(&ScratchLayer::angle_deg), false);
    rows.real("range", layer.range_deg, 0, 90, "%.2f deg",
              aimless ? "These scratches run in every direction."
                      : "Scatter to either side of the direction.",
              of_layer(&ScratchLayer::range_deg), false);
    ImGui::EndDisabled();
    const double width = layer.width_mm.typical(), length = layer.length_mm.typical();
    // The limits are those of `burnish scratch`, so that a slider does not end in a fault.
    rows.real("length", length, std::max(width, 0.2),
              std::max(4 * s.tile_mm * share_of(layer.length_mm), std::max(width, 0.2) * 1.01),
              "%.3g mm", "Median length. Long scratches are tapered over more of it.",
              of_spread(&ScratchLayer::length_mm));
    const double least_width = std::max(2 * layer.depth_mm.typical() * choice.strength, 0.005);
    rows.real(
        "width", width, least_width,
        std::max(std::min(0.5 * s.tile_mm * share_of(layer.width_mm), length), least_width * 1.01),
        "%.3g mm", "Median width, where a scratch is widest.", of_spread(&ScratchLayer::width_mm));
    rows.real("depth", layer.depth_mm.typical(), 0.0001,
              std::max(0.5 * width / std::max(choice.strength, 0.01), 0.00011), "%.3g mm",
              "Median depth before `strength`, at most half the width: a hemisphere.",
              of_spread(&ScratchLayer::depth_mm));
}

void state_rows(App& app) {
    const Generator& generator = app.generator;
    ImGui::Spacing();
    if (!generator.fault().empty()) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextColored({1.0f, 0.55f, 0.45f, 1}, "%s", generator.fault().c_str());
        ImGui::PopTextWrapPos();
        return;
    }
    if (!generator.working()) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextDisabled(
            "Drag a slider: a coarse map follows it. The full map is made when it is let go.");
        ImGui::PopTextWrapPos();
        return;
    }
    const auto [stage, done] = generator.background().progress();
    const auto button = 64 * static_cast<float>(app.ui_scale);
    ImGui::ProgressBar(static_cast<float>(done), {ImGui::GetContentRegionAvail().x - button, 0},
                       stage.c_str());
    ImGui::SameLine();
    if (ImGui::Button("cancel", {-1, 0})) app.generator.cancel(app);
}

}  // namespace

void generator_panel(App& app) {
    Rows rows(app);
    // A copy: a row may change it.
    const ScratchChoice choice = app.generator.choice();
    const ScratchSettings& s = choice.recipe.settings;
    ImGui::TextDisabled("%s", app.material ? "of the selected material" : "of all materials");
    base_row(rows, choice);
    rows.real(
        "amount", choice.amount, 0, kMostScratchAmount, "x %.2f",
        "Factor on the number of scratches.", [](ScratchChoice& c, double v) { c.amount = v; },
        false);
    rows.real(
        "strength", choice.strength, 0, most_strength(s), "x %.2f",
        "Factor on all depths. It ends where a groove would be deeper than half its width.",
        [](ScratchChoice& c, double v) { c.strength = v; }, false);
    tile_rows(rows, s);
    ImGui::Spacing();
    ImGui::TextDisabled("first layer of %d", static_cast<int>(s.layers.size()));
    layer_rows(rows, choice);
    state_rows(app);
    if (ImGui::Button("another seed"))
        rows.complete([](ScratchChoice& c) {
            c.recipe.settings.seed = c.recipe.settings.seed % 2147483647u + 1;
        });
    ImGui::SameLine();
    if (ImGui::Button("as the preset"))
        rows.complete([](ScratchChoice& c) {
            const int size = c.recipe.settings.size;
            c = scratch_choice(c.base);
            c.recipe.settings.size = size;
        });
}

}  // namespace burnish::viewer
