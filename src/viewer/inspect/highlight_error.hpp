// How far the highlight of a method is from where the grain of the surface puts it: the angle between the
// half vector at which the method's lobe is highest and that of `follow-grain`. The light of the
// highlight is off by up to twice as much.
//
// Threads: functions of their arguments; the picture uses all processors.
#pragma once

#include <optional>

#include "burnish/image.hpp"
#include "burnish/scene.hpp"
#include "viewer/inspect/pick.hpp"
#include "viewer/inspect/surface_at.hpp"

namespace burnish::viewer {

// Degrees, 0 to 180. None where nothing reflects, or where the model has no meaning under `method`.
std::optional<double> highlight_error_deg(const SurfaceAt& at, Method method,
                                          glm::dvec3 to_eye_world);
// Of the material's own method.
std::optional<double> highlight_error_deg(const Scene& scene, const Hit& hit,
                                          glm::dvec3 to_eye_world);

struct HighlightErrors {
    Image degrees;  // one channel, `columns` wide, row 0 at the top; NaN where there is none
    double mean = 0, most = 0;  // degrees, over the places that have one; 0 without any
};
// At the middles of a grid of `columns` (at least 1) by as many rows as keep its cells nearly square. Every
// material is taken under its own method, or all under `method`.
HighlightErrors highlight_errors(const Scene& scene, const Picker& picker, const Camera& camera,
                                 WindowSize window, int columns,
                                 std::optional<Method> method = std::nullopt);

}  // namespace burnish::viewer
