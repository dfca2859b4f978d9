#include "viewer/motion/navigation.hpp"

#include <array>

namespace burnish::viewer {

using Row = std::pair<const char*, const char*>;

std::span<const std::string_view> navigation_names() {
    static constexpr std::array<std::string_view, 2> kNames = {"viewer", "blender"};
    return kNames;
}

Drag drag_of(Navigation navigation, int button, const Modifiers& held) {
    if (button == 1) return Drag::pan;
    if (button == 2) return held.shift ? Drag::pan : held.ctrl ? Drag::zoom : Drag::orbit;
    if (held.shift) return Drag::highlight;
    if (held.ctrl) return Drag::light;
    if (held.alt) return Drag::environment;
    return navigation == Navigation::blender ? Drag::none : Drag::orbit;
}

Drag scroll_of(bool touchpad, const Modifiers& held) {
    if (!touchpad || held.ctrl) return Drag::zoom;
    return held.shift ? Drag::pan : Drag::orbit;
}

std::span<const Row> mouse_help(Navigation navigation, bool touchpad) {
    static constexpr Row kShift{"shift+drag", "put the highlight there"};
    static constexpr Row kCtrl{"ctrl+drag", "move the light"};
    static constexpr Row kAlt{"alt+drag", "turn the environment"};
    static constexpr Row kClick{"click", "the lobe at this point"};
    static constexpr Row kWheel{"wheel, ctrl+middle drag", "zoom"};
    static constexpr Row kFingers{"two fingers", "orbit; with shift pan, with ctrl zoom"};
    static constexpr Row kOrbit{"drag, middle drag", "orbit"};
    static constexpr Row kPan{"right drag, shift+middle drag", "pan"};
    static constexpr Row kMiddle{"middle drag", "orbit"};
    static constexpr std::array<Row, 7> kViewer = {kOrbit, kPan, kWheel, kShift,
                                                   kCtrl,  kAlt, kClick};
    static constexpr std::array<Row, 7> kBlender = {kMiddle, kPan, kWheel, kShift,
                                                    kCtrl,   kAlt, kClick};
    static constexpr std::array<Row, 7> kViewerPad = {kOrbit, kPan, kFingers, kShift,
                                                      kCtrl,  kAlt, kClick};
    static constexpr std::array<Row, 7> kBlenderPad = {kMiddle, kPan, kFingers, kShift,
                                                       kCtrl,   kAlt, kClick};
    if (navigation == Navigation::viewer) return touchpad ? kViewerPad : kViewer;
    return touchpad ? kBlenderPad : kBlender;
}

}  // namespace burnish::viewer
