// Colours in which previews of maps show lines. Private to the scratch and weave commands.
#pragma once

namespace burnish {

// A line's hue goes once around in half a turn: red along x, cyan along y; dark grey for none.
// `line` is (cos 2a, sin 2a), or (0, 0).
void line_color(const float* line, float* rgb);

}  // namespace burnish
