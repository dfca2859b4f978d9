#include "viewer/window/theme.hpp"

#include <imgui.h>

#include <filesystem>

namespace burnish::viewer {
namespace {

constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr float kFontSize = 14.0f;

ImVec4 gray(float value, float alpha = 1.0f) {
    return {value, value, value, alpha};
}

}  // namespace

void set_theme(float scale) {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    // Latin, and signs of the texts: degree, multiplication, n with a tilde, arrows, middle dot, Greek.
    static constexpr ImWchar kRanges[] = {0x20,   0x17f,  0x370,  0x3ff,  0x2010, 0x2027, 0x2190,
                                          0x21ff, 0x2200, 0x22ff, 0x25a0, 0x25ff, 0};
    std::error_code error;
    if (std::filesystem::exists(kFont, error)) {
        io.Fonts->AddFontFromFileTTF(kFont, kFontSize * scale, nullptr, kRanges);
    } else {
        ImFontConfig config;
        config.SizePixels = 13.0f * scale;
        io.Fonts->AddFontDefault(&config);
    }
    ImGuiStyle style;
    ImGui::StyleColorsDark(&style);
    style.WindowRounding = 0;
    style.FrameRounding = 3;
    style.GrabRounding = 3;
    style.ScrollbarRounding = 3;
    style.WindowBorderSize = 0;
    style.FramePadding = {6, 3};
    style.ItemSpacing = {6, 4};
    style.IndentSpacing = 12;
    style.ScrollbarSize = 11;
    ImVec4* c = style.Colors;
    const ImVec4 accent{0.42f, 0.55f, 0.70f, 1.0f};
    c[ImGuiCol_WindowBg] = gray(0.13f);
    c[ImGuiCol_PopupBg] = gray(0.11f, 0.98f);
    c[ImGuiCol_MenuBarBg] = gray(0.11f);
    c[ImGuiCol_FrameBg] = gray(0.20f);
    c[ImGuiCol_FrameBgHovered] = gray(0.26f);
    c[ImGuiCol_FrameBgActive] = gray(0.30f);
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = gray(0.10f);
    c[ImGuiCol_Button] = gray(0.24f);
    c[ImGuiCol_ButtonHovered] = gray(0.31f);
    c[ImGuiCol_ButtonActive] = gray(0.37f);
    c[ImGuiCol_Header] = gray(0.22f);
    c[ImGuiCol_HeaderHovered] = gray(0.28f);
    c[ImGuiCol_HeaderActive] = gray(0.33f);
    // A slider writes its number over its knob: a dark and narrow one leaves it legible.
    c[ImGuiCol_SliderGrab] = {0.22f, 0.36f, 0.53f, 1.0f};
    c[ImGuiCol_SliderGrabActive] = {0.27f, 0.44f, 0.64f, 1.0f};
    style.GrabMinSize = 6;
    c[ImGuiCol_CheckMark] = {0.62f, 0.74f, 0.88f, 1.0f};
    c[ImGuiCol_Tab] = gray(0.17f);
    c[ImGuiCol_TabHovered] = gray(0.32f);
    c[ImGuiCol_TabActive] = gray(0.27f);
    c[ImGuiCol_TextSelectedBg] = {0.30f, 0.42f, 0.56f, 0.8f};
    c[ImGuiCol_Text] = gray(0.90f);
    c[ImGuiCol_TextDisabled] = gray(0.55f);
    c[ImGuiCol_Separator] = gray(0.25f);
    c[ImGuiCol_PlotHistogram] = accent;
    c[ImGuiCol_NavHighlight] = accent;
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

Measures measures(float scale) {
    return {300.0f * scale, 380.0f * scale, 24.0f * scale};
}

}  // namespace burnish::viewer
