#include "viewer/inspect/point_lobe.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/constants.hpp"
#include "viewer/inspect/table_lobe.hpp"

namespace burnish::viewer {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

glm::dvec3 of(f64::vec3 v) {
    return {v.x, v.y, v.z};
}

f64::vec3 on_disk(double x, double y) {
    return {x, y, std::sqrt(std::max(1 - x * x - y * y, 0.0))};
}

// A half vector on its way to the highest value of a function of the disk.
struct Climber {
    double x = 0, y = 0, value = -1;
};

// Steps along both axes, halved when none of them rises. `steps`: of about the width of the lobe.
template <typename Value>
Climber climbed(Climber at, glm::dvec2 steps, const Value& value) {
    const auto try_step = [&](double dx, double dy) {
        const Climber next{at.x + dx, at.y + dy, 0};
        if (!(next.x * next.x + next.y * next.y < 1)) return false;
        const double v = value(on_disk(next.x, next.y));
        if (!(v > at.value)) return false;
        at = {next.x, next.y, v};
        return true;
    };
    // 2^-30: a billionth of the lobe's width. At most 200 steps of a size: a lobe wider than that is flat.
    for (int halvings = 0; halvings < 30; ++halvings, steps *= 0.5) {
        for (int i = 0; i < 200; ++i) {
            const bool rises = try_step(steps.x, 0) || try_step(-steps.x, 0) ||
                               try_step(0, steps.y) || try_step(0, -steps.y);
            if (!rises) break;
        }
    }
    return at;
}

}  // namespace

PointLobe::PointLobe(const SurfaceAt& at, Method method)
    : surface_(at.surface),
      specular_surface_(at.surface),
      n_(at.n),
      stretch_(at.stretch),
      drawn_(method == Method::normal_map && at.isotropic ? Method::gram_schmidt : method),
      grooves_along_x_(at.grooves_along_x),
      perturbed_(at.perturbed),
      half_vectors_(at.half_vectors),
      reflects_(at.reflects()),
      albedos_(at.albedos) {
    specular_surface_.has_diffuse = false;
    conserve_ = at.conserve && drawn_ == Method::deform_smooth;
    has_meaning_ = f64::brdf_takes_method(surface_.brdf, static_cast<int>(drawn_));
    if (at.surface.lobe.p0 != at.surface.lobe.p1) groove_rad_ = grooves_along_x_ ? 0.0 : kHalfPi;
    if (!at.exemplar) return;
    groove_rad_.reset();
    table_turns_ =
        f64::tabulated_rotation(static_cast<int>(drawn_), at.exemplar->groove_rad / kTwoPi);
    const double turn = at.exemplar->angle_rad + table_turns_ * kTwoPi;
    stretch_ = f64::direction_added({std::cos(turn), std::sin(turn)}, at.stretch);
    if (at.exemplar->exemplar < 0) return;
    groove_rad_ = at.exemplar->groove_rad - table_turns_ * kTwoPi;
    table_ = table_lobe(at.exemplar->material, at.exemplar->exemplar);
}

f64::vec3 PointLobe::local(glm::dvec3 w) const {
    return f64::seen_from_rotated(f64::vec3(w), stretch_);
}

glm::dvec3 PointLobe::outer(f64::vec3 w) const {
    return of(f64::seen_from_rotated(w, f64::vec2(stretch_.x, -stretch_.y)));
}

f64::Perturbation PointLobe::seen_from(glm::dvec3 to_eye) const {
    // Under the geometric normal all methods are one.
    if (!perturbed_) return f64::perturb_make(f64::kMethodNone, {0, 0, 1}, grooves_along_x_, false);
    return f64::surface_perturbation(static_cast<int>(drawn_), n_, stretch_, grooves_along_x_,
                                     conserve_, local(to_eye));
}

bool PointLobe::sees(glm::dvec3 to_eye) const {
    return reflects_ && has_meaning_ && to_eye.z > 0;
}

glm::dvec3 PointLobe::normal(glm::dvec3 to_eye) const {
    return outer(seen_from(to_eye).n);
}

std::optional<double> PointLobe::grain_deg(glm::dvec3 to_eye) const {
    if (!groove_rad_ || !half_vectors_ || !has_meaning_) return std::nullopt;
    const f64::Perturbation p = seen_from(to_eye);
    const auto along = [&](f64::vec3 h) {
        const f64::LobePoint q = f64::perturb_point(p, f64::normalize(h));
        return q.x * std::cos(*groove_rad_) + q.y * std::sin(*groove_rad_);
    };
    // The gradient on the sphere of half vectors. 1e-5: half of the digits of a difference are good.
    constexpr double kStep = 1e-5;
    f64::vec3 groove(0, 0, 0);
    for (const f64::vec3 axis : {f64::vec3(1, 0, 0), f64::vec3(0, 1, 0), f64::vec3(0, 0, 1)}) {
        const f64::vec3 e = axis - p.n * f64::dot(axis, p.n);
        groove = groove + axis * ((along(p.n + e * kStep) - along(p.n - e * kStep)) / (2 * kStep));
    }
    const glm::dvec3 seen = outer(groove);
    const double angle = std::atan2(seen.y, seen.x) * kDegreesPerRadian;
    return angle < 0 ? std::fmod(angle + 180.0, 180.0) : std::fmod(angle, 180.0);
}

// ---- values -------------------------------------------------------------------------------------

double PointLobe::lobe_at(const f64::Perturbation& p, f64::vec3 h) const {
    if (table_) return table_->D(f64::perturb_point(p, h), table_turns_);
    return f64::lobe_D(surface_.lobe, p, h);
}

f64::SurfaceMaterial PointLobe::towards(const f64::SurfaceMaterial& surface,
                                        const f64::Perturbation& p, f64::vec3 wo) const {
    return albedos_ ? compensated(surface, *albedos_, p, wo) : surface;
}

f64::LobeValues PointLobe::values(const f64::Perturbation& p, f64::vec3 wi, f64::vec3 wo) const {
    f64::LobeValues v = f64::no_lobe_values();
    if (!table_) return v;
    const f64::vec3 h = f64::half_vector(wi + wo, p.n);
    v.D = table_->D(f64::perturb_point(p, h), table_turns_);
    v.area_i = table_->area(f64::perturb_direction(p, wi), table_turns_);
    v.area_o = table_->area(f64::perturb_direction(p, wo), table_turns_);
    return v;
}

double PointLobe::D(glm::dvec3 half, glm::dvec3 to_eye) const {
    if (!half_vectors_) return kNoNumber;
    return sees(to_eye) ? lobe_at(seen_from(to_eye), local(half)) : 0.0;
}

std::optional<NdfOrigin> PointLobe::origin(glm::dvec3 half, glm::dvec3 to_eye) const {
    if (!table_) return std::nullopt;
    const f64::LobePoint q = f64::perturb_point(seen_from(to_eye), local(half));
    if (!(q.weight > 0)) return std::nullopt;
    return table_->origin(q, table_turns_);
}

std::optional<glm::dvec3> PointLobe::on_table(glm::dvec3 half, glm::dvec3 to_eye) const {
    if (!table_) return std::nullopt;
    const f64::LobePoint q = f64::perturb_point(seen_from(to_eye), local(half));
    if (!(q.weight > 0)) return std::nullopt;
    return outer(f64::normalize(f64::vec3(q.x, q.y, q.z)));
}

double PointLobe::G(glm::dvec3 to_light, glm::dvec3 to_eye) const {
    if (!half_vectors_) return kNoNumber;
    if (!sees(to_eye)) return 0.0;
    const f64::Perturbation p = seen_from(to_eye);
    const f64::vec3 wi = local(to_light), wo = local(to_eye);
    const double cos_i = f64::dot(p.n, wi), cos_o = f64::dot(p.n, wo);
    if (!(cos_i > 0 && cos_o > 0)) return 0.0;
    const f64::vec3 gi = f64::perturb_direction(p, wi), go = f64::perturb_direction(p, wo);
    if (surface_.brdf == f64::kBrdfMicrofacet) return f64::smith_G2(surface_.lobe, gi, go);
    if (surface_.brdf == f64::kBrdfMicrofacetSeparable)
        return f64::smith_G1(surface_.lobe, gi) * f64::smith_G1(surface_.lobe, go);
    if (table_) {
        return cos_i * cos_o / (table_->area(gi, table_turns_) * table_->area(go, table_turns_));
    }
    const f64::vec3 h = f64::half_vector(wi + wo, p.n);
    const double D = lobe_at(p, h);
    if (!(D > 0)) return kNoNumber;
    return f64::specular_eval(surface_, p, values(p, wi, wo), wi, wo) * 4 * cos_i * cos_o / D;
}

glm::dvec3 PointLobe::F(glm::dvec3 to_light, glm::dvec3 to_eye) const {
    return of(f64::specular_fresnel(
        surface_, f64::half_angle_cosine(f64::vec3(to_light), f64::vec3(to_eye))));
}

glm::dvec3 PointLobe::gain(glm::dvec3 to_eye) const {
    if (!sees(to_eye)) return glm::dvec3(1.0);
    return of(towards(surface_, seen_from(to_eye), local(to_eye)).gain);
}

glm::dvec3 PointLobe::specular(glm::dvec3 to_light, glm::dvec3 to_eye) const {
    if (!sees(to_eye)) return glm::dvec3(0.0);
    const f64::Perturbation p = seen_from(to_eye);
    const f64::vec3 wi = local(to_light), wo = local(to_eye);
    return of(f64::surface_eval(towards(specular_surface_, p, wo), p, values(p, wi, wo), wi, wo));
}

glm::dvec3 PointLobe::eval(glm::dvec3 to_light, glm::dvec3 to_eye) const {
    if (!sees(to_eye)) return glm::dvec3(0.0);
    const f64::Perturbation p = seen_from(to_eye);
    const f64::vec3 wi = local(to_light), wo = local(to_eye);
    return of(f64::surface_eval(towards(surface_, p, wo), p, values(p, wi, wo), wi, wo));
}

glm::dvec3 PointLobe::eval_cos(glm::dvec3 to_light, glm::dvec3 to_eye) const {
    if (!sees(to_eye)) return glm::dvec3(0.0);
    const f64::Perturbation p = seen_from(to_eye);
    const f64::vec3 wi = local(to_light), wo = local(to_eye);
    const double cosine = f64::dot(p.n, wi);
    if (!(cosine > 0 && f64::dot(p.n, wo) > 0)) return glm::dvec3(0.0);
    return of(f64::surface_eval(towards(surface_, p, wo), p, values(p, wi, wo), wi, wo) * cosine);
}

// ---- sampling -----------------------------------------------------------------------------------

double PointLobe::pdf(glm::dvec3 to_light, glm::dvec3 to_eye, Terms terms) const {
    if (!sees(to_eye)) return 0.0;
    const f64::Perturbation p = seen_from(to_eye);
    const f64::vec3 wi = local(to_light), wo = local(to_eye);
    if (!(f64::dot(p.n, wi) > 0)) return 0.0;
    f64::LobeValues v = f64::no_lobe_values();
    if (table_) {
        const f64::BasePoints q = f64::base_points(p, f64::half_vector(wi + wo, p.n));
        v.density = table_->density(q.at, table_turns_);
        v.density_round = table_->density(q.round, table_turns_);
    }
    const f64::SurfaceMaterial& drawn = terms == Terms::all ? surface_ : specular_surface_;
    return f64::surface_pdf(towards(drawn, p, wo), p, v, wi, wo);
}

std::optional<PointLobe::Sample> PointLobe::sample(glm::dvec3 to_eye,
                                                   const std::array<double, 3>& uniform,
                                                   Terms terms) const {
    if (!sees(to_eye)) return std::nullopt;
    const f64::Perturbation p = seen_from(to_eye);
    const f64::vec2 xi(uniform[0], uniform[1]);
    const f64::vec3 table_half = table_ ? table_->sample(xi, table_turns_) : p.n;
    bool drawn = false;
    const f64::vec3 wo = local(to_eye);
    const f64::SurfaceMaterial& surface = terms == Terms::all ? surface_ : specular_surface_;
    const f64::vec3 wi =
        f64::surface_direction(towards(surface, p, wo), p, table_half, wo, xi, uniform[2], drawn);
    if (!drawn) return std::nullopt;
    const Sample sample{outer(wi), pdf(outer(wi), to_eye, terms)};
    if (!(sample.pdf > 0)) return std::nullopt;
    return sample;
}

// ---- the peak -----------------------------------------------------------------------------------

// The highest value of a map of half vectors is the image of the base's, but for slope-shift, whose density changes
// within the lobe. normal-map is no such map.
f64::vec3 PointLobe::highest(const f64::Perturbation& p) const {
    f64::vec3 base = table_ ? table_->highest(table_turns_) : f64::vec3(0, 0, 1);
    const bool maps = p.method != f64::kMethodNormalMap;
    if (maps) base = f64::perturb_forward(p, base);
    if (maps && p.method != f64::kMethodSlopeShift) return base;
    const auto value = [&](f64::vec3 h) { return lobe_at(p, h); };
    Climber best;
    const auto start = [&](double x, double y) {
        const double v = value(on_disk(x, y));
        if (v > best.value) best = {x, y, v};
    };
    if (!maps) {
        constexpr int kSide =
            24;  // a first look at the disk, for a second rise far from both normals
        for (int i = 0; i < kSide; ++i) {
            for (int j = 0; j < kSide; ++j) {
                const double x = (2 * i + 1.0) / kSide - 1, y = (2 * j + 1.0) / kSide - 1;
                if (x * x + y * y < 1) start(x, y);
            }
        }
    }
    const double ax = f64::lobe_alpha_x(surface_.lobe), ay = f64::lobe_alpha_y(surface_.lobe);
    // A table's cells are at most 0.1 radians wide near its peak.
    const glm::dvec2 steps = table_ ? glm::dvec2(0.1) : glm::min(glm::dvec2(ax, ay), 0.3);
    Climber highest = climbed(best, steps, value);
    for (const f64::vec3 from : {base, p.n, f64::normalize(base + p.n)}) {
        const Climber other = climbed({from.x, from.y, value(from)}, steps, value);
        if (other.value > highest.value) highest = other;
    }
    return on_disk(highest.x, highest.y);
}

glm::dvec3 PointLobe::peak(glm::dvec3 to_eye) const {
    const f64::Perturbation p = seen_from(to_eye);
    if (half_vectors_) return outer(highest(p));
    const f64::vec3 wo = local(to_eye);
    const f64::vec3 wi = f64::cosine_lobe_direction(surface_.cosine, p, wo);
    return outer(f64::half_vector(wi + wo, p.n));
}

glm::dvec3 PointLobe::peak_to_light(glm::dvec3 to_eye) const {
    return of(f64::reflect_about(f64::vec3(to_eye), f64::vec3(peak(to_eye))));
}

}  // namespace burnish::viewer
