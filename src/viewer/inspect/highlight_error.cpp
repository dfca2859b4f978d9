#include "viewer/inspect/highlight_error.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/constants.hpp"
#include "core/parallel.hpp"
#include "viewer/inspect/point_lobe.hpp"

namespace burnish::viewer {
namespace {

// Of unit vectors; exact for small angles, where an arc cosine is not.
double angle_between_deg(glm::dvec3 a, glm::dvec3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * kDegreesPerRadian;
}

}  // namespace

std::optional<double> highlight_error_deg(const SurfaceAt& at, Method method,
                                          glm::dvec3 to_eye_world) {
    const PointLobe shown(at, method);
    if (!at.reflects() || !shown.has_meaning()) return std::nullopt;
    const glm::dvec3 eye = to_tangent_frame(at, to_eye_world);
    return angle_between_deg(shown.peak(eye), PointLobe(at, at.right).peak(eye));
}

std::optional<double> highlight_error_deg(const Scene& scene, const Hit& hit,
                                          glm::dvec3 to_eye_world) {
    const SurfaceAt at = surface_at(scene, hit, to_eye_world);
    return highlight_error_deg(at, at.method, to_eye_world);
}

HighlightErrors highlight_errors(const Scene& scene, const Picker& picker, const Camera& camera,
                                 WindowSize window, int columns, std::optional<Method> method) {
    const double cell = static_cast<double>(window.width) / columns;
    const int rows = std::max(static_cast<int>(std::lround(window.height / cell)), 1);
    HighlightErrors errors;
    errors.degrees = Image(columns, rows, 1, std::numeric_limits<float>::quiet_NaN());
    const auto error_at = [&](int column, int row) -> std::optional<double> {
        const glm::dvec2 pixel((column + 0.5) * cell, (row + 0.5) * window.height / rows);
        const std::optional<Hit> hit = pick(scene, picker, camera, pixel, window);
        if (!hit) return std::nullopt;
        const glm::dvec3 to_eye = towards_eye(camera, hit->position);
        const SurfaceAt at = surface_at(scene, *hit, to_eye);
        return highlight_error_deg(at, method.value_or(at.method), to_eye);
    };
    parallel_for(static_cast<std::size_t>(rows), 1, [&](std::size_t begin, std::size_t end) {
        for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
            for (int column = 0; column < columns; ++column)
                if (const auto error = error_at(column, row))
                    *errors.degrees.at(column, row) = static_cast<float>(*error);
    });
    double count = 0;
    for (const float error : errors.degrees.pixels) {
        if (std::isnan(error)) continue;
        count += 1;
        errors.mean += static_cast<double>(error);
        errors.most = std::max(errors.most, static_cast<double>(error));
    }
    if (count > 0) errors.mean /= count;
    return errors;
}

}  // namespace burnish::viewer
