#include "reference/point_surface.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "rays/vectors.hpp"

namespace burnish {
namespace {

// As the renderer has it: what is no number reflects nothing.
glm::vec3 finite(const f32::vec3& v) {
    const bool sound = std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    return sound ? glm::vec3(std::max(v.x, 0.0f), std::max(v.y, 0.0f), std::max(v.z, 0.0f))
                 : glm::vec3(0.0f);
}

}  // namespace

f32::LobeValues PointSurface::values(const f32::vec3& wi, bool with_density) const {
    f32::LobeValues v = f32::no_lobe_values();
    if (table == nullptr) return v;
    const f32::vec3 h = f32::half_vector(wi + wo, p.n);
    v.D = table->D(f32::perturb_point(p, h), table_groove);
    v.area_i = table->area(f32::perturb_direction(p, wi), table_groove);
    v.area_o = table->area(f32::perturb_direction(p, wo), table_groove);
    if (!with_density) return v;
    const f32::BasePoints q = f32::base_points(p, h);
    v.density = table->density(q.at, table_groove);
    v.density_round = table->density(q.round, table_groove);
    return v;
}

glm::vec3 PointSurface::eval_cos(const f32::SurfaceMaterial& m, const f32::vec3& wi) const {
    const f32::LobeValues v = values(wi, false);
    if (layered) return finite(f32::layered_eval(m, layers, seen, p, v, wi, wo));
    return finite(f32::surface_eval(m, p, v, wi, wo) * std::max(f32::dot(p.n, wi), 0.0f));
}

glm::vec3 PointSurface::eval_cos(const glm::vec3& wi) const {
    if (!reflects) return glm::vec3(0.0f);
    return eval_cos(material, f32::frame_to_local(axes, to_f32(wi)));
}

glm::vec3 PointSurface::diffuse_cos(const glm::vec3& wi) const {
    if (!reflects || !material.has_diffuse) return glm::vec3(0.0f);
    const f32::vec3 local = f32::frame_to_local(axes, to_f32(wi));
    f32::SurfaceMaterial bare = material;
    bare.has_diffuse = false;
    return glm::max(eval_cos(material, local) - eval_cos(bare, local), glm::vec3(0.0f));
}

bool PointSurface::sees(const f32::vec3& wi) const {
    return f32::dot(p.n, wi) > 0.0f ||
           (layered && layers.coat.present && f32::dot(layers.coat.at.n, wi) > 0.0f);
}

float PointSurface::pdf(const f32::vec3& wi) const {
    // `sample` discards these directions.
    if (!reflects || !sees(wi)) return 0.0f;
    float density = f32::surface_pdf(material, p, values(wi, true), wi, wo);
    if (layered) {
        const f32::LayerShares s = f32::layer_shares(material, layers, p, wo);
        density *= 1.0f - s.coat - s.sheen;
        if (layers.coat.present) density += s.coat * f32::coat_pdf(layers.coat, wi, wo);
        if (layers.sheen.present) density += s.sheen * f32::sheen_pdf(p.n, wi);
    }
    return std::isfinite(density) ? density : 0.0f;
}

float PointSurface::pdf(const glm::vec3& wi) const {
    return pdf(f32::frame_to_local(axes, to_f32(wi)));
}

// From one of the layers, or from what lies below them.
f32::vec3 PointSurface::draw(const std::array<float, 3>& xi, bool& drawn) const {
    const f32::vec2 square(xi[0], xi[1]);
    const f32::vec3 half = table != nullptr ? table->sample(square, table_groove) : p.n;
    if (!layered) return f32::surface_direction(material, p, half, wo, square, xi[2], drawn);
    const f32::LayerShares s = f32::layer_shares(material, layers, p, wo);
    const float below = 1.0f - s.coat - s.sheen;
    if (xi[2] < below)
        return f32::surface_direction(material, p, half, wo, square, xi[2] / below, drawn);
    float density = 0.0f;
    const f32::vec3 wi = xi[2] < below + s.sheen
                             ? f32::sheen_sample(p.n, square, density)
                             : f32::coat_sample(layers.coat, wo, square, density);
    drawn = density > 0.0f;
    return wi;
}

std::optional<PointSurface::Sample> PointSurface::sample(const std::array<float, 3>& xi) const {
    if (!reflects) return std::nullopt;
    bool drawn = false;
    const f32::vec3 wi = draw(xi, drawn);
    if (!drawn || !sees(wi)) return std::nullopt;
    Sample out;
    out.pdf = pdf(wi);
    if (!(out.pdf > 0.0f)) return std::nullopt;
    out.weight = eval_cos(material, wi) / out.pdf;
    out.wi = glm::normalize(to_glm(f32::frame_to_outer(axes, wi)));
    const bool sound = std::isfinite(out.weight.x + out.weight.y + out.weight.z) &&
                       std::isfinite(out.wi.x + out.wi.y + out.wi.z);
    return sound ? std::optional(out) : std::nullopt;
}

glm::vec3 PointSurface::world_normal() const {
    return to_glm(f32::frame_to_outer(axes, p.n));
}

glm::vec3 PointSurface::grain() const {
    const float ax = f32::lobe_alpha_x(material.lobe), ay = f32::lobe_alpha_y(material.lobe);
    // 1e-4: rounding of one roughness that is stated as two.
    if (table == nullptr && std::abs(ax - ay) <= 1e-4f * (ax + ay)) return glm::vec3(0.0f);
    const glm::vec3 n = world_normal();
    const glm::vec3 along = to_glm(grooves_along_x ? axes.t : axes.b);
    const glm::vec3 flat = along - n * glm::dot(n, along);
    const float length = glm::length(flat);
    // 1e-6: a groove that is seen along the normal has no direction.
    return length > 1e-6f ? flat / length : glm::vec3(0.0f);
}

}  // namespace burnish
