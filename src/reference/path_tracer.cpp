#include "reference/path_tracer.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "rays/vectors.hpp"

namespace burnish {
namespace {

// Groups of numbers of a path (PathPoints::group).
constexpr std::uint32_t kFilm =
    0;  // place in the pixel; blur of the background or texel of a table
constexpr std::uint32_t kGround = 1;   // and those of the areas behind it
constexpr std::uint32_t kVertex = 64;  // first of a vertex, and how many each has
constexpr std::uint32_t kDirection = 0, kLight = 1, kChance = 2, kAreas = 3;

// Surfaces that every path goes on from; beyond, dim ones end by chance and the others weigh more.
constexpr int kSurePaths = 3;
// The share of a lobe's width by which the cone of a ray widens in a reflection: far below what would be seen.
constexpr float kConeOfLobe = 0.25f;
// As the renderer's: the largest half float.
constexpr float kMostRadiance = 65504.0f;

// From the middle of a pixel, in pixels: the pixel filter, a tent of half width 1.
float tent(float u) {
    return u < 0.5f ? std::sqrt(2.0f * u) - 1.0f : 1.0f - std::sqrt(2.0f - 2.0f * u);
}

// The power heuristic (Veach 1997).
float share_of(float own, float other) {
    const float a = own * own, b = other * other;
    return std::isinf(a) ? 1.0f : a / (a + b);
}

bool is_black(const glm::vec3& v) {
    return !(v.x > 0.0f || v.y > 0.0f || v.z > 0.0f);
}

glm::vec3 divided(const glm::vec3& a, const glm::vec3& b) {
    glm::vec3 out(0.0f);
    for (int c = 0; c < 3; ++c)
        if (b[c] > 0.0f) out[c] = a[c] / b[c];
    return out;
}

// The direction, or where it leads into the surface its mirror image.
glm::vec3 above(const SurfaceHit& hit, const glm::vec3& direction) {
    const float height = glm::dot(hit.side, direction);
    return height < 0.0f ? direction - 2.0f * height * hit.side : direction;
}

std::uint32_t vertex_group(int depth, std::uint32_t what) {
    return kVertex * static_cast<std::uint32_t>(depth + 1) + what;
}

}  // namespace

PathTracer::PathTracer(const Scene& scene, const Environment& environment, const Camera& camera,
                       const RenderSettings& settings, int reflections, bool layers)
    : settings_(settings),
      reflections_(reflections),
      layers_(layers),
      scene_(scene),
      lamps_(scene.lights),
      sky_(environment, settings),
      camera_(camera_basis(camera)),
      orthographic_(camera.orthographic) {
    const double pixel = 2.0 * half_height_of(camera) / settings.height;
    pixel_ = static_cast<float>(pixel);
    step_right_ = glm::vec3(camera_.right * pixel);
    step_up_ = glm::vec3(camera_.up * pixel);
    forward_ = glm::vec3(-camera_.back);
    eye_ = glm::vec3(camera_.position);
    const Bounds bounds = bounds_of(scene);
    if (settings.ground) ground_.emplace(bounds, lamps_, sky_);
    // An orthographic view shows what lies behind its place.
    if (orthographic_) eye_ -= forward_ * (glm::length(bounds.center() - eye_) + bounds.radius());
}

PathTracer::Walk PathTracer::start(int x, int y, const std::array<float, 4>& xi) const {
    const float px =
        static_cast<float>(x) + 0.5f + tent(xi[0]) - 0.5f * static_cast<float>(settings_.width);
    const float py =
        0.5f * static_cast<float>(settings_.height) - (static_cast<float>(y) + 0.5f + tent(xi[1]));
    const glm::vec3 across = px * step_right_ + py * step_up_;
    Walk walk;
    if (orthographic_) {
        walk.ray.origin = eye_ + across;
        walk.ray.direction = forward_;
        walk.cone.width = pixel_;
    } else {
        walk.ray.origin = eye_;
        walk.ray.direction = glm::normalize(across + forward_);
        walk.cone.spread = pixel_;
    }
    return walk;
}

std::size_t PathTracer::light_count() const {
    return lamps_.punctual.size() + lamps_.areas.size() + (sky_.lights() ? 1 : 0);
}

// The first surface takes the light of all.
float PathTracer::chosen_from(int depth) const {
    return depth == 0 ? 1.0f : static_cast<float>(std::max<std::size_t>(light_count(), 1));
}

// ---- light that a vertex looks for -----------------------------------------------------------------

glm::vec3 PathTracer::lit_by_punctual(const Vertex& v, const PunctualLight& light) const {
    const PunctualLight::AtPoint at = light.at(v.hit.position);
    if (is_black(at.irradiance)) return glm::vec3(0.0f);
    const glm::vec3 reflected = v.surface.eval_cos(at.direction) * at.irradiance;
    if (is_black(reflected)) return reflected;
    if (settings_.shadows && scene_.is_blocked(v.hit, at.direction, at.distance))
        return glm::vec3(0.0f);
    return reflected * chosen_from(v.depth);
}

glm::vec3 PathTracer::lit_by_area(const Vertex& v, const AreaLamp& light,
                                  const glm::vec2& xi) const {
    const auto seen = light.sample(v.hit.position, xi);
    if (!seen || is_black(seen->radiance)) return glm::vec3(0.0f);
    const glm::vec3 reflected = v.surface.eval_cos(seen->direction) * seen->radiance;
    if (is_black(reflected)) return reflected;
    if (settings_.shadows && scene_.is_blocked(v.hit, seen->direction, seen->distance))
        return glm::vec3(0.0f);
    const float pdf = seen->pdf / chosen_from(v.depth);
    return reflected * (share_of(pdf, v.surface.pdf(seen->direction)) / pdf);
}

glm::vec3 PathTracer::lit_by_sky(const Vertex& v, const glm::vec2& xi) const {
    const Sky::Sample drawn = sky_.sample(xi);
    if (!(drawn.pdf > 0.0f) || is_black(drawn.radiance)) return glm::vec3(0.0f);
    const glm::vec3 reflected =
        left_by_occlusion(v.surface, drawn.direction, v.surface.eval_cos(drawn.direction)) *
        drawn.radiance;
    if (is_black(reflected)) return reflected;
    if (settings_.visibility &&
        scene_.is_blocked(scene_.leaving(v.hit, above(v.hit, drawn.direction))))
        return glm::vec3(0.0f);
    const float pdf = drawn.pdf / chosen_from(v.depth);
    return reflected * (share_of(pdf, v.surface.pdf(drawn.direction)) / pdf);
}

glm::vec3 PathTracer::lit_by(const Vertex& v, std::size_t light, const glm::vec2& xi) const {
    const std::size_t punctual = lamps_.punctual.size();
    if (light < punctual) return lit_by_punctual(v, lamps_.punctual[light]);
    if (light < punctual + lamps_.areas.size())
        return lit_by_area(v, lamps_.areas[light - punctual], xi);
    return lit_by_sky(v, xi);
}

glm::vec3 PathTracer::lit(const Vertex& v, const PathPoints& points) const {
    const std::size_t count = light_count();
    if (count == 0 || !v.surface.reflects) return glm::vec3(0.0f);
    const bool draws = v.depth > 0 || sky_.lights();
    const std::array<float, 4> xi =
        draws ? points.group(vertex_group(v.depth, kLight)) : std::array<float, 4>{};
    if (v.depth > 0) {
        const auto chosen = static_cast<std::size_t>(xi[2] * static_cast<float>(count));
        return lit_by(v, std::min(chosen, count - 1), {xi[0], xi[1]});
    }
    glm::vec3 sum(0.0f);
    for (std::size_t i = 0; i < count; ++i) {
        // Lights with an area have numbers of their own, two of them a group.
        const bool area = i >= lamps_.punctual.size() && i + (sky_.lights() ? 1 : 0) < count;
        if (!area) {
            sum += lit_by(v, i, {xi[0], xi[1]});
            continue;
        }
        const auto number = static_cast<std::uint32_t>(i - lamps_.punctual.size());
        const std::array<float, 4> own =
            points.group(vertex_group(v.depth, kAreas + number / 2 % (kVertex - kAreas)));
        sum +=
            lit_by(v, i, number % 2 == 0 ? glm::vec2(own[0], own[1]) : glm::vec2(own[2], own[3]));
    }
    return sum;
}

// An occlusion map stands for what rays would find: it is read where none are asked for.
glm::vec3 PathTracer::left_by_occlusion(const PointSurface& surface, const glm::vec3& wi,
                                        const glm::vec3& reflected) const {
    if (settings_.visibility || !(surface.occlusion < 1.0f)) return reflected;
    const glm::vec3 diffuse = glm::min(surface.diffuse_cos(wi), reflected);
    const float open = f32::specular_occlusion(surface.occlusion,
                                               std::max(f32::dot(surface.p.n, surface.wo), 0.0f),
                                               surface.material.lobe);
    return diffuse * surface.occlusion + (reflected - diffuse) * open;
}

// ---- light that a ray meets ------------------------------------------------------------------------

glm::vec3 PathTracer::lights_met(const Walk& walk, const std::optional<RayHit>& hit) const {
    const float chosen = chosen_from(walk.depth - 1);
    glm::vec3 sum(0.0f);
    // Lights do not shine through the surface, unless they cast no shadows.
    const bool areas_reach = !settings_.shadows || !walk.below;
    for (const AreaLamp& light : lamps_.areas) {
        const auto met = areas_reach ? light.met_by(walk.ray.origin, walk.drawn) : std::nullopt;
        if (!met || (settings_.shadows && hit && hit->distance < met->distance)) continue;
        sum += walk.weight * met->radiance * share_of(walk.pdf, met->pdf / chosen);
    }
    if (sky_.lights() && (!settings_.visibility || !hit))
        sum += walk.sky_weight * sky_.radiance(walk.drawn) *
               share_of(walk.pdf, sky_.pdf(walk.drawn) / chosen);
    return sum;
}

// The radiance of a light that stands before the first surface.
std::optional<glm::vec3> PathTracer::emitter_seen(const Walk& walk,
                                                  const std::optional<RayHit>& hit) const {
    std::optional<AreaLamp::Seen> nearest;
    for (const AreaLamp& light : lamps_.areas) {
        if (!light.is_visible()) continue;
        const auto met = light.met_by(walk.ray.origin, walk.ray.direction);
        if (!met || (hit && hit->distance < met->distance)) continue;
        if (!nearest || met->distance < nearest->distance) nearest = met;
    }
    return nearest ? std::optional(nearest->radiance) : std::nullopt;
}

void PathTracer::put_background(const Walk& walk, const std::array<float, 4>& xi, PathSample& out,
                                const PathPoints& points) const {
    const bool transparent = sky_.is_transparent();
    if (!transparent) out.radiance = sky_.background(walk.ray.direction, {xi[2], xi[3]});
    out.coverage = transparent ? 0.0f : 1.0f;
    if (!ground_) return;
    const auto left = ground_->left(walk.ray, scene_, [&](std::uint32_t number) {
        return points.group(kGround + number % (kVertex - kGround));
    });
    if (!left) return;
    out.radiance *= *left;
    if (transparent) out.coverage = 1.0f - f32::luminance(to_f32(*left));
}

void PathTracer::note_first(const Vertex& v, PathSample& out) const {
    out.meets_surface = true;
    out.normal = v.surface.world_normal();
    out.grain = v.surface.grain();
    out.depth =
        static_cast<float>(-glm::dot(glm::dvec3(v.hit.position) - camera_.position, camera_.back));
}

// Draws the next direction; false: the path ends.
bool PathTracer::go_on(const Vertex& v, Walk& walk, PathSample& out,
                       const PathPoints& points) const {
    const std::array<float, 4> xi = points.group(vertex_group(v.depth, kDirection));
    const auto drawn = v.surface.sample({xi[0], xi[1], xi[2]});
    if (!drawn) return false;
    if (v.depth == 0) out.albedo = drawn->weight;
    walk.weight *= drawn->weight;
    if (v.depth >= kSurePaths) {
        const float stay = std::min(std::max({walk.weight.x, walk.weight.y, walk.weight.z}), 0.95f);
        if (!(xi[3] < stay)) return false;
        walk.weight /= stay;
    }
    if (is_black(walk.weight)) return false;
    walk.sky_weight = walk.weight;
    if (!settings_.visibility && v.surface.occlusion < 1.0f) {
        const glm::vec3 all = v.surface.eval_cos(drawn->wi);
        walk.sky_weight *= divided(left_by_occlusion(v.surface, drawn->wi, all), all);
    }
    walk.below = !(glm::dot(v.hit.side, drawn->wi) > 0.0f);
    walk.drawn = drawn->wi;
    walk.ray = scene_.leaving(v.hit, above(v.hit, drawn->wi));
    walk.pdf = drawn->pdf;
    walk.cone.spread += kConeOfLobe * std::min(1.0f / std::sqrt(drawn->pdf), 1.0f);
    walk.depth = v.depth + 1;
    return true;
}

std::optional<RayHit> PathTracer::surface_on(const Walk& walk, const PathPoints& points) const {
    const bool camera = walk.depth == 0;
    if (!camera && !settings_.visibility && !settings_.shadows) return std::nullopt;
    const float chance =
        scene_.sees_through() ? points.group(vertex_group(walk.depth, kChance))[0] : 0.0f;
    return scene_.nearest(walk.ray, walk.cone, camera, chance);
}

PathSample PathTracer::sample(int x, int y, std::uint32_t number) const {
    const auto pixel = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(settings_.width) +
                       static_cast<std::uint32_t>(x);
    const PathPoints points(settings_.seed, pixel, number);
    const std::array<float, 4> film = points.group(kFilm);
    PathSample out;
    Walk walk = start(x, y, film);
    const bool meets_lights = sky_.lights() || !lamps_.areas.empty();
    for (;;) {
        const std::optional<RayHit> hit = surface_on(walk, points);
        if (walk.depth > 0) {
            out.radiance += lights_met(walk, hit);
            // Without visibility surfaces do not see one another.
            if (!hit || walk.depth > reflections_ || !settings_.visibility) break;
        } else if (const auto emitter = emitter_seen(walk, hit)) {
            out.radiance = *emitter;
            break;
        } else if (!hit) {
            put_background(walk, film, out, points);
            break;
        }
        const SurfaceHit surface = scene_.at(*hit, walk.ray, walk.cone);
        const Vertex v{surface, scene_.reader(surface.material).at(surface, {film[2], film[3]}),
                       walk.depth};
        if (v.depth == 0) note_first(v, out);
        walk.cone.width += walk.cone.spread * hit->distance;
        out.radiance += walk.weight * (v.surface.emitted + lit(v, points));
        const bool last = v.depth >= reflections_ && !meets_lights;
        if ((last && !(layers_ && v.depth == 0)) || !go_on(v, walk, out, points)) break;
    }
    for (int c = 0; c < 3; ++c)
        out.radiance[c] = std::isnan(out.radiance[c])
                              ? 0.0f
                              : std::clamp(out.radiance[c], -kMostRadiance, kMostRadiance);
    return out;
}

}  // namespace burnish
