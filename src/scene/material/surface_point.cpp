#include <algorithm>

#include "burnish/error.hpp"
#include "burnish/surface.hpp"
#include "core/text.hpp"
#include "models/albedo_table.hpp"
#include "scene/material/material_values.hpp"

namespace burnish {
namespace {

f64::vec3 of(glm::dvec3 v) {
    return {v.x, v.y, v.z};
}

glm::dvec3 of(f64::vec3 v) {
    return {v.x, v.y, v.z};
}

void require_point(const Material& m) {
    if (cloth_of(m) != nullptr || tabulated_of(m) != nullptr)
        throw UsageError("material", "lobe", "a glTF or an alpha lobe",
                         cloth_of(m) != nullptr ? "cloth" : "a tabulated material");
    if (f64::brdf_takes_method(static_cast<int>(m.brdf), static_cast<int>(m.method))) return;
    throw UsageError("material", "method",
                     "one that " + std::string(name_of(m.brdf)) + " has a meaning under",
                     std::string(name_of(m.method)));
}

}  // namespace

Mdf mdf_named(std::string_view name) {
    return static_cast<Mdf>(index_of_name(mdf_names(), name, "distribution", "mdf"));
}

Brdf brdf_named(std::string_view name) {
    return static_cast<Brdf>(index_of_name(brdf_names(), name, "model", "brdf"));
}

Method method_named(std::string_view name) {
    return static_cast<Method>(index_of_name(method_names(), name, "method", "method"));
}

SurfacePoint::SurfacePoint(const Material& material, glm::dvec3 normal) : normal_(of(normal)) {
    require_point(material);
    const auto values = material_values<f64::SurfaceMaterial>(material);
    material_ = values.surface;
    layers_ = values.layers;
    layered_ = values.layered;
    stretch_ = values.stretch;
    const bool bent = normal.x != 0.0 || normal.y != 0.0;
    method_ = static_cast<int>(bent ? untextured_method(material) : Method::none);
    grooves_along_x_ = values.grooves_along_x;
    conserve_ = values.conserve;
    if (values.compensated) albedos_ = albedo_table(material.brdf, material.mdf);
}

f64::vec3 SurfacePoint::local(glm::dvec3 w) const {
    return f64::seen_from_rotated(of(w), stretch_);
}

f64::Perturbation SurfacePoint::seen_from(f64::vec3 to_eye) const {
    return f64::surface_perturbation(method_, normal_, stretch_, grooves_along_x_, conserve_,
                                     to_eye);
}

f64::SurfaceMaterial SurfacePoint::material_towards(const f64::Perturbation& p,
                                                    f64::vec3 to_eye) const {
    return albedos_ ? compensated(material_, *albedos_, p, to_eye) : material_;
}

bool SurfacePoint::sees(const f64::Perturbation& p, f64::vec3 to_light) const {
    return f64::dot(p.n, to_light) > 0.0 || (layers_.coat.present && to_light.z > 0.0);
}

f64::vec3 SurfacePoint::eval_cos(const f64::SurfaceMaterial& material, const f64::Perturbation& p,
                                 f64::vec3 to_light, f64::vec3 to_eye) const {
    if (layered_) return f64::layered_eval(material, layers_, p, to_light, to_eye);
    return f64::surface_eval(material, p, to_light, to_eye) *
           std::max(f64::dot(p.n, to_light), 0.0);
}

glm::dvec3 SurfacePoint::eval_cos(glm::dvec3 to_light, glm::dvec3 to_eye) const {
    const f64::vec3 wo = local(to_eye);
    const f64::Perturbation p = seen_from(wo);
    return of(eval_cos(material_towards(p, wo), p, local(to_light), wo));
}

glm::dvec3 SurfacePoint::eval(glm::dvec3 to_light, glm::dvec3 to_eye) const {
    const f64::vec3 wo = local(to_eye);
    const f64::Perturbation p = seen_from(wo);
    const f64::vec3 wi = local(to_light);
    if (!layered_) return of(f64::surface_eval(material_towards(p, wo), p, wi, wo));
    const double cosine = f64::dot(p.n, wi);
    if (!(cosine > 0.0)) return glm::dvec3(0.0);
    return of(eval_cos(material_towards(p, wo), p, wi, wo)) / cosine;
}

double SurfacePoint::pdf(glm::dvec3 to_light, glm::dvec3 to_eye) const {
    const f64::vec3 wo = local(to_eye);
    const f64::vec3 wi = local(to_light);
    const f64::Perturbation p = seen_from(wo);
    // `sample` discards these directions.
    if (!sees(p, wi)) return 0.0;
    const f64::SurfaceMaterial material = material_towards(p, wo);
    return layered_ ? f64::layered_pdf(material, layers_, p, wi, wo)
                    : f64::surface_pdf(material, p, wi, wo);
}

std::optional<SurfacePoint::Sample> SurfacePoint::sample(
    glm::dvec3 to_eye, const std::array<double, 3>& uniform) const {
    const f64::vec3 wo = local(to_eye);
    const f64::Perturbation p = seen_from(wo);
    const f64::SurfaceMaterial material = material_towards(p, wo);
    const f64::vec2 xi(uniform[0], uniform[1]);
    Sample out;
    const f64::vec3 wi =
        layered_ ? f64::layered_sample(material, layers_, p, wo, xi, uniform[2], out.pdf)
                 : f64::surface_sample(material, p, wo, xi, uniform[2], out.pdf);
    if (!(out.pdf > 0.0) || !sees(p, wi)) return std::nullopt;
    out.weight = of(eval_cos(material, p, wi, wo) * (1.0 / out.pdf));
    // Back to the axes of the tangent, by the inverse rotation.
    out.to_light = of(f64::seen_from_rotated(wi, f64::vec2(stretch_.x, -stretch_.y)));
    return out;
}

}  // namespace burnish
