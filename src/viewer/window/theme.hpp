// Looks: a neutral gray, so that colors of the picture are judged without a tint, and a font that reads.
#pragma once

namespace burnish::viewer {

// Style and font of ImGui's context at `scale` device pixels a unit. Call it again when the scale
// changes. Without the DejaVu fonts ImGui's own font is used.
void set_theme(float scale);

// Widths of a side panel and of the wide one, and height of the status bar, in device pixels.
struct Measures {
    float panel = 300, wide = 460, status = 24;
};
Measures measures(float scale);

}  // namespace burnish::viewer
