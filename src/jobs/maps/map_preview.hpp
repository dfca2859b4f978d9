// Colors of lines in previews of maps. Private to the scratch and weave commands.
#pragma once

namespace burnish {

// The hue of a line has a period of half a turn: red along x, cyan along y; dark gray for no line.
// `line` is (cos 2a, sin 2a), or (0, 0).
void line_color(const float* line, float* rgb);

}  // namespace burnish
