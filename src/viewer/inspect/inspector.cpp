#include "viewer/inspect/inspector.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/constants.hpp"
#include "viewer/inspect/highlight_error.hpp"

namespace burnish::viewer {
namespace {

glm::dvec2 alpha_of_surface(const SurfaceAt& at) {
    if (at.exemplar) return glm::dvec2(0.0);
    return {f64::lobe_alpha_x(at.surface.lobe), f64::lobe_alpha_y(at.surface.lobe)};
}

double degrees_of(f64::vec2 direction) {
    return std::atan2(direction.y, direction.x) * kDegreesPerRadian;
}

// The groove runs along the axis of the smaller alpha; a table knows its own.
std::optional<double> grain_of(const SurfaceAt& at) {
    double angle = 0;
    if (at.exemplar) {
        if (at.exemplar->exemplar < 0) return std::nullopt;
        angle = degrees_of(at.stretch) +
                (at.exemplar->angle_rad + at.exemplar->groove_rad) * kDegreesPerRadian;
    } else {
        if (at.surface.lobe.p0 == at.surface.lobe.p1) return std::nullopt;
        angle = degrees_of(at.stretch) + (at.grooves_along_x ? 0.0 : 90.0);
    }
    const double folded = std::fmod(angle, 180.0);
    return folded < 0 ? folded + 180.0 : folded;
}

MethodReport report_of(const LobeReport& report, Method method, glm::dvec3 to_eye_world,
                       Shapes shapes) {
    const PointLobe lobe(report.surface, method);
    MethodReport m{method, lobe};
    const glm::dvec3 wi = report.to_light, wo = report.to_eye;
    m.normal = lobe.normal(wo);
    m.grain_deg = lobe.grain_deg(wo);
    m.D = lobe.D(report.half, wo);
    m.G = lobe.G(wi, wo);
    if (!lobe.has_meaning()) return m;
    m.F = lobe.F(wi, wo);
    m.gain = lobe.gain(wo);
    m.f_specular = lobe.specular(wi, wo) / m.gain;
    m.f = lobe.eval(wi, wo);
    m.f_cos = lobe.eval_cos(wi, wo);
    m.pdf = lobe.pdf(wi, wo);
    m.peak = lobe.peak(wo);
    m.peak_to_light = lobe.peak_to_light(wo);
    m.highlight_error_deg = highlight_error_deg(report.surface, method, to_eye_world).value_or(0.0);
    if (shapes == Shapes::none) return m;
    m.disk = lobe_disk(lobe, wo);
    m.mesh = lobe_mesh(lobe, wi, wo);
    m.cuts = polar_cuts(lobe, wi, wo);
    return m;
}

}  // namespace

LobeReport inspect(const Scene& scene, const Hit& hit, glm::dvec3 to_eye, glm::dvec3 to_light,
                   std::span<const Method> methods, Shapes shapes) {
    LobeReport report;
    report.surface = surface_at(scene, hit, to_eye);
    const SurfaceAt& at = report.surface;
    report.to_eye = to_tangent_frame(at, to_eye);
    report.to_light = to_tangent_frame(at, to_light);
    report.normal = {at.n.x, at.n.y, at.n.z};
    report.normal_world = to_world(at, report.normal);
    const f64::vec3 half =
        f64::half_vector(f64::vec3(report.to_light) + f64::vec3(report.to_eye), at.n);
    report.half = {half.x, half.y, half.z};
    report.tilt = std::hypot(at.n.x, at.n.y);
    report.tilt_deg = std::atan2(report.tilt, at.n.z) * kDegreesPerRadian;
    report.alpha = alpha_of_surface(at);
    report.grain_deg = grain_of(at);
    for (const Method method : methods)
        report.methods.push_back(report_of(report, method, to_eye, shapes));
    report.stretch_deg =
        degrees_of(report.methods.empty() ? at.stretch : report.methods.front().lobe.stretch());
    return report;
}

}  // namespace burnish::viewer
