// Looks: a neutral gray, so that colors of the picture are judged without a tint, and a font that reads.
#pragma once

namespace burnish::viewer {

// Style and font of ImGui's context at `scale` device pixels a unit. Call it again when the scale
// changes. Without the DejaVu fonts ImGui's own font is used.
void set_theme(float scale);

// Widths of the panels at the sides and height of the status bar, in device pixels. The right panel has room
// for the numbers of four methods.
struct Measures {
    float left = 300, right = 380, status = 24;
};
Measures measures(float scale);

}  // namespace burnish::viewer
