// Parameters from the one table, with reset, search and tooltips.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/gtc/type_ptr.hpp>
#include <map>

#include "burnish/draft.hpp"
#include "burnish/image_io.hpp"
#include "burnish/scratch_settings.hpp"
#include "viewer/document/value_in_effect.hpp"
#include "viewer/window/file_dialog.hpp"
#include "viewer/window/panels.hpp"

namespace burnish::viewer {
namespace {

struct Section {
    const char* title;
    std::vector<std::string_view> names;
    bool open = true;  // at first
};

// The order in which a person meets them; every parameter of the table is in one section or the last.
const std::vector<Section>& sections() {
    static const std::vector<Section> all = {
        {"Model", {"method", "process", "conserve", "mdf", "brdf", "single_scattering"}},
        {"Roughness",
         {"alpha_x", "alpha_y", "anisotropy_rotation", "roughness", "anisotropy", "e_x", "e_y",
          "cosine_exponent", "ks", "lafortune_c"}},
        {"Color",
         {"metal", "oxide", "base_color", "metallic", "f0", "ior", "specular", "specular_color",
          "double_sided"}},
        {"Layers",
         {"coat", "coat_roughness", "coat_tint", "coat_normal_map", "sheen_color",
          "sheen_roughness"}},
        {"Detail",
         {"normal_map", "normal_scale", "flip_green", "normal_filter", "scratch",
          "scratch_direction", "physical_size", "height_map", "height_scale", "uv_scale"}},
        {"Weave",
         {"weave", "weave_yarns", "weave_yarns_per_cm", "weave_crimp", "weave_bulge", "weave_gap",
          "weave_twist", "weave_fuzz", "warp_color", "weft_color"},
         false},
        {"Maps",
         {"maps", "base_color_map", "roughness_map", "glossiness_map", "metallic_map", "orm_map",
          "ao_map", "anisotropy_map", "emissive_map", "tabulated"},
         false},
        {"Picture",
         {"exposure", "tone_map", "background", "background_color", "background_blur", "samples",
          "image_light", "image_light_samples", "robust_mean", "shadows", "ground", "seed", "width",
          "height", "bit_depth", "dither"}},
        {"Environment", {"environment_intensity", "environment_rotation"}},
        {"Camera", {"camera_fov", "camera_position", "camera_target", "camera_index"}, false},
        {"Mesh", {"triangles"}, false},
    };
    return all;
}

// Where the papers treat a parameter.
std::string_view paper_of(std::string_view name) {
    static const std::map<std::string_view, std::string_view> kPapers = {
        {"process", "docs/theory/processes.md"},
        {"method", "Kang & Cho 2011 section 2, 2012 sections 3 and 4 (docs/theory/papers.md)"},
        {"conserve", "Kang & Cho 2011 section 2.3"},
        {"single_scattering", "Turquin 2019 (docs/theory/energy.md)"},
        {"mdf", "Kang & Cho 2011 Table 1, 2012 Eq 1"},
        {"alpha_x", "Ward 1992; Kang & Cho 2011 Eq 1"},
        {"alpha_y", "Ward 1992; Kang & Cho 2011 Eq 1"},
        {"e_x", "Ashikhmin & Shirley 2000"},
        {"e_y", "Ashikhmin & Shirley 2000"},
        {"scratch", "Kang & Cho 2011 section 2.4"},
        {"tabulated", "Wang et al. 2008"},
        {"coat", "KHR_materials_clearcoat; Stokes 1862 (docs/theory/coats.md)"},
        {"coat_tint", "docs/theory/coats.md"},
        {"sheen_color", "Estevez & Kulla 2017 (docs/theory/coats.md)"},
        {"normal_filter", "docs/theory/normal-filtering.md"},
        {"weave", "docs/theory/cloth.md"},
        {"image_light", "docs/theory/image-light.md"},
    };
    const auto found = kPapers.find(name);
    return found == kPapers.end() ? std::string_view{} : found->second;
}

std::string label_of(std::string_view name) {
    std::string label(name);
    std::replace(label.begin(), label.end(), '_', ' ');
    return label;
}

// The text, or its beginning and two dots, no wider than `width`.
std::string fitted(std::string text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    while (!text.empty() && ImGui::CalcTextSize((text + "..").c_str()).x > width) text.pop_back();
    return text + "..";
}

// Words that a text parameter takes beside files.
std::vector<std::string> words_of(std::string_view name) {
    std::vector<std::string> words;
    if (name != "scratch") words.emplace_back("none");  // the one that has no such word
    const auto add = [&](std::span<const std::string_view> names) {
        words.insert(words.end(), names.begin(), names.end());
    };
    if (name == "scratch") add(scratch_preset_names());
    if (name == "weave") add(draft_names());
    if (name == "normal_map" || name == "coat_normal_map") words.emplace_back("builtin:bumps");
    return words;
}

// That of the file, else the present one; with a slash at the end.
std::string folder_of(const std::string& file) {
    std::error_code error;
    const bool is_file = std::filesystem::exists(file, error);
    const std::filesystem::path folder =
        is_file ? std::filesystem::path(file).parent_path() : std::filesystem::current_path(error);
    return (folder / "").string();
}

// Whether a warning says that the value changes nothing now: "name: why: nothing changes".
std::string idle_reason(const App& app, std::string_view name) {
    for (const std::string& line : app.editor.warnings()) {
        if (!line.ends_with("nothing changes") && line.find("change nothing") == std::string::npos)
            continue;
        const std::size_t colon = line.find(':');
        const std::string_view names = std::string_view(line).substr(0, colon);
        std::size_t from = 0;
        while (from < names.size()) {
            const std::size_t comma = std::min(names.find(", ", from), names.size());
            if (names.substr(from, comma - from) == name) return line;
            from = comma + 2;
        }
    }
    return {};
}

void tooltip(const App& app, const Parameter& p, bool set, const std::string& idle) {
    if (!ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 26);
    ImGui::TextUnformatted(std::string(p.help).c_str());
    std::string facts;
    if (p.kind == ParameterKind::real || p.kind == ParameterKind::integer)
        facts = fmt::format("{:g} to {:g}{}{}", p.low, p.high, p.unit.empty() ? "" : " ", p.unit);
    if (!p.default_text.empty())
        facts += fmt::format("{}default {}", facts.empty() ? "" : ", ", p.default_text);
    if (!facts.empty()) ImGui::TextDisabled("%s", facts.c_str());
    if (p.kind == ParameterKind::color)
        ImGui::TextDisabled("sRGB here, as displays have it; linear in scripts, flags and files");
    ImGui::TextDisabled("%s%s", flag_of(p.name).c_str(), set ? " (set)" : "");
    if (!app.material && materials_differ(app.editor.stage(), p))
        ImGui::TextDisabled("materials have different values: this is one of them");
    const std::string_view paper = paper_of(p.name);
    if (!paper.empty()) ImGui::TextDisabled("%s", std::string(paper).c_str());
    if (!idle.empty()) ImGui::TextColored({0.95f, 0.75f, 0.4f, 1}, "%s", idle.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

// --- widgets: true when the value has changed -----------------------------------------------------

bool real_widget(const Parameter& p, double& value) {
    auto v = static_cast<float>(value);
    const auto low = static_cast<float>(p.low), high = static_cast<float>(p.high);
    bool changed = false;
    const std::string format =
        p.unit.empty() ? std::string("%.3g") : fmt::format("%.4g {}", p.unit);
    if (p.unit == "deg" && p.high > 360) {
        changed = ImGui::DragFloat("##v", &v, 0.5f, low, high, "%.1f deg");
    } else if (p.high / std::max(p.low, 1e-3) > 99 || p.high > 100) {
        const bool both = p.low < 0;
        changed = both ? ImGui::DragFloat("##v", &v, 0.02f, low, high, format.c_str())
                       : ImGui::SliderFloat(
                             "##v", &v, low, high, format.c_str(),
                             ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoRoundToFormat);
    } else {
        changed = ImGui::SliderFloat("##v", &v, low, high, format.c_str(),
                                     ImGuiSliderFlags_NoRoundToFormat);
    }
    // What the fingers set has the digits of a float, and no more.
    if (changed) value = std::clamp(std::stod(fmt::format("{:.6g}", v)), p.low, p.high);
    return changed;
}

bool text_widget(const Parameter& p, const char* hint, std::string& value) {
    const float button = ImGui::GetFrameHeight();
    ImGui::SetNextItemWidth(ImGui::CalcItemWidth() - button - ImGui::GetStyle().ItemInnerSpacing.x);
    bool changed =
        ImGui::InputTextWithHint("##v", hint, &value, ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    if (ImGui::ArrowButton("##words", ImGuiDir_Down)) ImGui::OpenPopup("words");
    if (ImGui::BeginPopup("words")) {
        if (ImGui::Selectable("file ..."))
            ask_for(Ask::value, folder_of(value), std::string(p.name));
        for (const std::string& word : words_of(p.name))
            if (ImGui::Selectable(word.c_str())) {
                value = word;
                changed = true;
            }
        ImGui::EndPopup();
    }
    return changed;
}

bool widget(const Parameter& p, const char* hint, ParameterValue& value) {
    switch (p.kind) {
        case ParameterKind::real:
            return real_widget(p, std::get<double>(value));
        case ParameterKind::integer: {
            int& v = std::get<int>(value);
            const float speed = std::max(0.1f, 0.01f * static_cast<float>(std::abs(v)));
            const bool changed = ImGui::DragInt("##v", &v, speed, static_cast<int>(p.low),
                                                static_cast<int>(p.high), "%d");
            v = std::clamp(v, static_cast<int>(p.low), static_cast<int>(p.high));
            return changed;
        }
        case ParameterKind::boolean:
            return ImGui::Checkbox("##v", &std::get<bool>(value));
        case ParameterKind::choice: {
            auto& v = std::get<ParameterChoice>(value);
            bool changed = false;
            const std::string now(p.choices[static_cast<std::size_t>(v.index)]);
            if (ImGui::BeginCombo("##v", now.c_str(), ImGuiComboFlags_HeightLarge)) {
                for (std::size_t i = 0; i < p.choices.size(); ++i)
                    if (ImGui::Selectable(std::string(p.choices[i]).c_str(),
                                          static_cast<int>(i) == v.index)) {
                        v.index = static_cast<int>(i);
                        changed = true;
                    }
                ImGui::EndCombo();
            }
            return changed;
        }
        case ParameterKind::color: {
            glm::vec3& v = std::get<glm::vec3>(value);
            // The numbers are linear, the swatch shows them as a display does.
            float shown[3];
            for (int c = 0; c < 3; ++c) shown[c] = srgb_from_linear(v[c]);
            if (!ImGui::ColorEdit3("##v", shown, ImGuiColorEditFlags_Float)) return false;
            for (int c = 0; c < 3; ++c) v[c] = linear_from_srgb(std::clamp(shown[c], 0.0f, 1.0f));
            return true;
        }
        case ParameterKind::vector: {
            glm::vec3& v = std::get<glm::vec3>(value);
            return ImGui::DragFloat3("##v", glm::value_ptr(v), 0.01f, static_cast<float>(p.low),
                                     static_cast<float>(p.high), "%.3g");
        }
        case ParameterKind::text:
            return text_widget(p, hint, std::get<std::string>(value));
    }
    return false;
}

// What stands in the line of a text that names no file.
const char* hint_of(const App& app, const ValueInEffect& now) {
    if (now.value) return "drop a file, or pick";
    const auto index = static_cast<std::size_t>(app.material.value_or(0));
    const std::vector<ParameterValues>& values = app.editor.stage().materials.values();
    return index < values.size() && names_one(values[index], "maps") ? "of the folder of maps"
                                                                     : "the model's own";
}

// What holds once the document does not set the parameter.
std::string below(const App& app, const Parameter& p) {
    const bool of_input = p.group == ParameterGroup::material || p.default_text.empty() ||
                          app.editor.stage().file.values.is_set(p.name);
    return of_input ? "what the input says" : "the default, " + p.default_text;
}

void row(App& app, const Parameter& p) {
    const std::string name(p.name);
    ImGui::PushID(name.c_str());
    const bool material = p.group == ParameterGroup::material;
    const std::optional<int> own = material ? app.material : std::nullopt;
    const ValueInEffect now = value_in_effect(app.document(), app.editor.stage(), name, own);
    const bool set_here = now.set_here;
    ParameterValue edited =
        now.value ? *now.value : start_value(app.document(), app.editor.stage(), p, own);
    // Where no file is named the line is empty, with its hint.
    if (!set_here && p.kind == ParameterKind::text && edited == ParameterValue(std::string("none")))
        edited = std::string();

    const std::string idle = idle_reason(app, name);
    const float label_width = ImGui::GetFontSize() * 8.6f;
    if (!idle.empty()) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.5f);
    ImGui::AlignTextToFramePadding();
    const std::string label = fitted(label_of(name), label_width - ImGui::GetStyle().ItemSpacing.x);
    if (set_here)
        ImGui::TextUnformatted(label.c_str());
    else
        ImGui::TextDisabled("%s", label.c_str());
    tooltip(app, p, set_here, idle);
    ImGui::SameLine(label_width);
    const float reset = set_here ? ImGui::GetFrameHeight() : 0.0f;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - reset -
                            (set_here ? ImGui::GetStyle().ItemInnerSpacing.x : 0.0f));
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x - reset -
                         (set_here ? ImGui::GetStyle().ItemInnerSpacing.x : 0.0f));
    if (!now.value && p.kind == ParameterKind::real) {
        // No number says what is drawn: a press begins with one that is close to it.
        if (ImGui::Button("not set", {ImGui::CalcItemWidth(), 0})) app.set_parameter(name, edited);
    } else if (widget(p, hint_of(app, now), edited)) {
        app.set_parameter(name, edited);
    }
    ImGui::PopItemWidth();
    if (ImGui::IsItemDeactivated()) app.editor.close_step();
    tooltip(app, p, set_here, idle);
    if (!idle.empty()) ImGui::PopStyleVar();
    if (set_here) {
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
        if (ImGui::Button("x", {ImGui::GetFrameHeight(), 0})) app.unset_parameter(name);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("back to %s", below(app, p).c_str());
    }
    ImGui::PopID();
}

bool matches(const Parameter& p, const std::string& search) {
    if (search.empty()) return true;
    const auto lower = [](std::string_view text) {
        std::string result(text);
        for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
        std::replace(result.begin(), result.end(), '_', ' ');
        return result;
    };
    const std::string wanted = lower(search);
    return lower(p.name).find(wanted) != std::string::npos ||
           lower(p.help).find(wanted) != std::string::npos;
}

// Parameters that belong to another which says nothing are left out: yarns without a weave.
bool is_reachable(const App& app, const Parameter& p) {
    if (p.belongs_to.empty()) return true;
    const std::optional<ParameterValue> above =
        value_in_effect(app.document(), app.editor.stage(), p.belongs_to, app.material).value;
    if (above) {
        const std::string text = text_of(*find_parameter(p.belongs_to), *above);
        if (!text.empty() && text != "none") return true;
    }
    if (p.belongs_to == "weave")
        return std::ranges::any_of(app.scene().materials,
                                   [](const Material& m) { return cloth_of(m) != nullptr; });
    return false;
}

void material_choice(App& app) {
    const auto name_of_material = [&](int i) {
        const std::string& name = app.scene().materials[static_cast<std::size_t>(i)].name;
        return name.empty() ? fmt::format("material {}", i) : name;
    };
    if (app.scene().materials.size() < 2) {
        app.material.reset();
        return;
    }
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##material", app.material ? name_of_material(*app.material).c_str()
                                                     : "all materials")) {
        if (ImGui::Selectable("all materials", !app.material)) app.material.reset();
        for (int i = 0; i < static_cast<int>(app.scene().materials.size()); ++i) {
            ImGui::PushID(i);
            if (ImGui::Selectable(name_of_material(i).c_str(), app.material == i)) app.material = i;
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
}

}  // namespace

void parameter_panel(App& app) {
    material_choice(app);
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##search", "search parameters", &app.search);
    ImGui::Spacing();
    if (!ImGui::BeginChild("rows", {0, 0}, false)) return ImGui::EndChild();
    for (const Section& section : sections()) {
        std::vector<const Parameter*> rows;
        for (const std::string_view name : section.names) {
            const Parameter* p = find_parameter(name);
            if (p != nullptr && matches(*p, app.search) && is_reachable(app, *p)) rows.push_back(p);
        }
        if (rows.empty()) continue;
        const bool searching = !app.search.empty();
        if (searching) {
            ImGui::TextDisabled("%s", section.title);
        } else {
            ImGui::SetNextItemOpen(section.open, ImGuiCond_Once);
            if (!ImGui::CollapsingHeader(section.title)) continue;
        }
        for (const Parameter* p : rows) row(app, *p);
        ImGui::Spacing();
    }
    ImGui::EndChild();
}

}  // namespace burnish::viewer
