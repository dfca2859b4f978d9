#include "burnish/render_settings.hpp"

#include <array>

namespace burnish {

std::span<const std::string_view> image_light_names() {
    static constexpr std::array<std::string_view, 4> kNames = {"off", "importance", "bent-normal",
                                                               "prefiltered"};
    return kNames;
}

std::span<const std::string_view> background_names() {
    static constexpr std::array<std::string_view, 3> kNames = {"environment", "color",
                                                               "transparent"};
    return kNames;
}

std::span<const std::string_view> surface_view_names() {
    static constexpr std::array<std::string_view, 15> kNames = {"radiance",
                                                                "normal",
                                                                "perturbed-normal",
                                                                "tangent",
                                                                "grain",
                                                                "alpha-x",
                                                                "alpha-y",
                                                                "tilt",
                                                                "texture-coordinates",
                                                                "slope-variance",
                                                                "moments",
                                                                "albedo",
                                                                "not-finite",
                                                                "highlight-error",
                                                                "openness"};
    return kNames;
}

}  // namespace burnish
