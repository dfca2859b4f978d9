// The panel of comparisons: of methods, of two materials, of before and after.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "viewer/window/file_dialog.hpp"
#include "viewer/window/panels.hpp"

namespace burnish::viewer {
namespace {

CompareMode shown_mode(const Compare& compare) {
    return compare.mode == CompareMode::off ? CompareMode::split : compare.mode;
}

// --- methods --------------------------------------------------------------------------------------

bool is_used(const Compare& compare, Method method) {
    return std::ranges::find(compare.methods, method) != compare.methods.end();
}

void method_row(Compare& compare, std::size_t i) {
    ImGui::PushID(static_cast<int>(i));
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.75f);
    if (ImGui::BeginCombo("##method", std::string(name_of(compare.methods[i])).c_str(),
                          ImGuiComboFlags_HeightLarge)) {
        for (std::size_t m = 0; m < method_names().size(); ++m) {
            const auto method = static_cast<Method>(m);
            if (ImGui::Selectable(std::string(method_names()[m]).c_str(),
                                  compare.methods[i] == method,
                                  is_used(compare, method) ? ImGuiSelectableFlags_Disabled : 0))
                compare.methods[i] = method;
        }
        ImGui::EndCombo();
    }
    if (compare.methods.size() > kLeastCompared) {
        ImGui::SameLine();
        if (ImGui::SmallButton("x")) {
            compare.methods.erase(compare.methods.begin() + static_cast<std::ptrdiff_t>(i));
            compare.dividers.clear();
        }
    }
    ImGui::PopID();
}

void method_rows(Compare& compare) {
    for (std::size_t i = 0; i < compare.methods.size(); ++i) method_row(compare, i);
    if (compare.methods.size() >= kMostCompared || !ImGui::SmallButton("one more")) return;
    for (const Method m : {Method::gram_schmidt, Method::deform_smooth, Method::rotate_exact,
                           Method::none, Method::normal_map, Method::follow_grain}) {
        if (is_used(compare, m)) continue;
        compare.methods.push_back(m);
        compare.dividers.clear();
        return;
    }
}

// --- materials ------------------------------------------------------------------------------------

// Of a scene without another material there is none: a file is to be chosen.
std::optional<MaterialPair> first_pair(const App& app) {
    const int count = static_cast<int>(app.scene().materials.size());
    if (count < 2) return std::nullopt;
    const int of = std::clamp(app.material.value_or(0), 0, count - 1);
    return MaterialPair{of, fmt::format("#{}", of == 0 ? 1 : 0)};
}

bool may_be_a_material(const std::string& file) {
    static constexpr std::array<std::string_view, 3> kEndings = {".exr", ".bsdf", ".wif"};
    return std::ranges::any_of(kEndings, [&](std::string_view end) { return file.ends_with(end); });
}

std::string name_of_other(const App& app, const std::string& other) {
    const auto index = scene_material_of(other);
    const auto count = app.scene().materials.size();
    if (index && static_cast<std::size_t>(*index) < count)
        return material_name(app.scene(), *index);
    return std::filesystem::path(other).filename().string();
}

void objects_row(const App& app, MaterialPair& pair) {
    const int count = static_cast<int>(app.scene().materials.size());
    const std::string now = pair.material < count ? material_name(app.scene(), pair.material)
                                                  : fmt::format("#{}", pair.material);
    ImGui::TextDisabled("the objects of");
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##of", now.c_str())) return;
    for (int i = 0; i < count; ++i) {
        ImGui::PushID(i);
        if (ImGui::Selectable(material_name(app.scene(), i).c_str(), pair.material == i)) {
            if (scene_material_of(pair.other) == i) pair.other = fmt::format("#{}", pair.material);
            pair.material = i;
        }
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

void other_row(const App& app, MaterialPair& pair) {
    ImGui::TextDisabled("with it, and with");
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##with", name_of_other(app, pair.other).c_str(),
                           ImGuiComboFlags_HeightLarge))
        return;
    for (int i = 0; i < static_cast<int>(app.scene().materials.size()); ++i) {
        if (i == pair.material) continue;
        ImGui::PushID(i);
        const std::string index = fmt::format("#{}", i);
        if (ImGui::Selectable(material_name(app.scene(), i).c_str(), pair.other == index))
            pair.other = index;
        ImGui::PopID();
    }
    for (const std::string& file : app.remembered.recent) {
        if (!may_be_a_material(file)) continue;
        ImGui::PushID(file.c_str());
        if (ImGui::Selectable(std::filesystem::path(file).filename().c_str(), pair.other == file))
            pair.other = file;
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", file.c_str());
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

void file_button() {
    if (ImGui::SmallButton("a material of a file ..."))
        ask_for(Ask::compared, std::filesystem::current_path().string() + "/");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "a captured or measured material, a weaving draft,\na folder of scratches or of maps");
}

void material_rows(App& app) {
    const Compare& compare = app.document().compare;
    MaterialPair pair = *compare.materials;
    objects_row(app, pair);
    other_row(app, pair);
    file_button();
    if (compare.mode != CompareMode::off && !app.second)
        ImGui::TextWrapped("This material cannot be drawn: the panel Log says why.");
    if (pair != *compare.materials) app.compare_materials(pair, shown_mode(compare));
}

// --- the panel ------------------------------------------------------------------------------------

void mode_rows(Compare& compare) {
    for (std::size_t i = 0; i < compare_mode_names().size(); ++i) {
        const std::string name(compare_mode_names()[i]);
        if (i != 0 && i != 3) ImGui::SameLine();  // two rows fit the panel
        if (ImGui::RadioButton(name.c_str(), compare.mode == static_cast<CompareMode>(i)))
            compare.mode = static_cast<CompareMode>(i);
    }
}

// What is compared; a click changes it.
void subject_rows(App& app) {
    const Compare& compare = app.document().compare;
    const bool before = app.holds_before(), materials = !before && compare.materials.has_value();
    if (ImGui::RadioButton("methods", !before && !materials))
        app.compare_methods({}, shown_mode(compare));
    if (ImGui::RadioButton("two materials", materials) && !materials) {
        if (before) app.release();
        if (const auto pair = first_pair(app))
            app.compare_materials(*pair, shown_mode(compare));
        else
            ask_for(Ask::compared, std::filesystem::current_path().string() + "/");
    }
    if (ImGui::RadioButton("before and after", before) && !before) app.hold();
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "holds materials and models as they are now (H):\nwhat you change next is compared "
            "with them");
}

}  // namespace

void compare_panel(App& app) {
    ImGui::TextWrapped("The same camera, light and exposure, side by side or by turns.");
    ImGui::Spacing();
    Compare compare = app.document().compare;
    mode_rows(compare);
    ImGui::Separator();
    if (compare == app.document().compare) {
        subject_rows(app);
        compare = app.document().compare;
    }
    ImGui::Separator();
    if (app.holds_before()) {
        if (ImGui::Button("hold what is shown now")) app.hold();
        ImGui::SameLine();
        if (ImGui::Button("let it go")) app.release();
    } else if (compare.materials) {
        material_rows(app);
        if (compare.mode == app.document().compare.mode) compare = app.document().compare;
    } else {
        method_rows(compare);
    }
    if (compare.mode == CompareMode::difference) {
        auto gain = static_cast<float>(compare.gain);
        ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.6f);
        if (ImGui::SliderFloat("gain", &gain, 0.5f, 64, "%.3g", ImGuiSliderFlags_Logarithmic))
            compare.gain = static_cast<double>(gain);
    }
    if (compare.mode == CompareMode::flip)
        ImGui::TextWrapped(
            "FLIP (Andersson et al. 2020): the difference that a person sees between two "
            "pictures shown by turns, 0 to 1, at 67 pixels a degree.");
    if (compare.mode == CompareMode::difference || compare.mode == CompareMode::flip)
        ImGui::TextDisabled("%smean %.4f", app.shows_second() ? "" : "of the first two methods; ",
                            app.compared.mean());
    if (compare != app.document().compare)
        app.edit("compare", "compare", [&](Document& d) { d.compare = compare; });
}

}  // namespace burnish::viewer
