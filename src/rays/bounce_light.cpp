#include "rays/bounce_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "core/parallel.hpp"
#include "rays/vectors.hpp"
#include "rays/vertex_rays.hpp"
#include "scene/light/punctual_lights.hpp"

namespace burnish {
namespace {

constexpr std::array<float, 2> kUp = {1.0f, -1.0f};  // of the sides, along the normal
// (1 - c)^5 is its cosine-weighted mean, 1/21.
constexpr float kMeanCosine = 0.4561f;
constexpr int kSkyLamps = 64;
constexpr float kMostSkyRatio = 4.0f;
constexpr std::size_t kPointsOfTask = 64;  // points a task
// Rays of all points together that carry light: a second of two cores.
constexpr std::size_t kMostBounceRays = 3'000'000;

float luminance_of(const glm::vec3& color) {
    return f32::luminance(to_f32(color));
}

// Calls body(point) for all points on all cores, and reports between groups of them.
template <typename Body>
void for_points(std::size_t points, std::string_view stage, const Progress& progress,
                const Body& body) {
    constexpr std::size_t kGroup = 4096;
    for (std::size_t first = 0; first < points; first += kGroup) {
        progress.step(stage, static_cast<double>(first) / static_cast<double>(points));
        const std::size_t count = std::min(kGroup, points - first);
        parallel_for(count, kPointsOfTask, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) body(static_cast<std::uint32_t>(first + i));
        });
    }
}

// The mean color of what was hit, and how its luminance grows along the directions: the plane of least squares.
struct HitSums {
    glm::vec3 color{0.0f}, direction{0.0f}, weighted{0.0f};
    glm::mat3 squares{0.0f};
    float luminance = 0.0f, count = 0.0f;

    void add(const glm::vec3& w, const glm::vec3& radiance) {
        const float y = luminance_of(radiance);
        color += radiance;
        direction += w;
        weighted += y * w;
        squares += glm::outerProduct(w, w);
        luminance += y;
        count += 1.0f;
    }

    f32::Surroundings fit() const {
        f32::Surroundings s{{}, {}, 1.0f};
        if (!(count > 0.0f) || !(luminance > 0.0f)) return s;
        const glm::vec3 middle = direction / count;
        const float mean = luminance / count;
        // Ridge: with few hits, or hits in one direction, the slope is 0.
        glm::mat3 spread = squares / count - glm::outerProduct(middle, middle);
        const float ridge = 0.02f + 1.0f / count;
        for (int i = 0; i < 3; ++i) spread[i][i] += ridge;
        const glm::vec3 slope = glm::inverse(spread) * (weighted / count - mean * middle);
        // mean + slope.(w - middle) = base (1 + slope.w/base); a base below a quarter of the mean would let the
        // color of few hits grow without bound.
        const float base = std::max(mean - glm::dot(slope, middle), 0.25f * mean);
        s.color = to_f32(color / count * (base / mean));
        s.slope = to_f32(slope / base);
        return s;
    }
};

// The irradiance of a surface that faces the middle of a light with an area, over its radiance: as of a disc of the
// same area that faces the point by as much, pi A/(pi d^2 + A).
float area_share(const Light& light, const glm::vec3& position) {
    const glm::vec3 away = position - light.position;
    const float distance2 = std::max(glm::dot(away, away), 1e-12f);
    const float along = glm::dot(travel_of(light), away) / std::sqrt(distance2);
    float area = light.size.x * light.size.y;
    if (light.type == LightType::tube) {
        area *= std::sqrt(std::max(1.0f - along * along, 0.0f));  // its silhouette
    } else {
        if (light.type == LightType::disc) area *= 0.25f * std::numbers::pi_v<float>;
        area *= light.two_sided ? std::abs(along) : std::max(along, 0.0f);
    }
    return std::numbers::pi_v<float> * area / (std::numbers::pi_v<float> * distance2 + area);
}

}  // namespace

BounceLight::BounceLight(const BounceScene& scene, const SceneLight& light, int bounces,
                         const Progress& progress)
    : scene_(scene),
      environment_(light.environment.get(), light.intensity, light.rotation),
      directions_(even_hemisphere(scene.count)),
      step_(scene.hits.count() * static_cast<std::size_t>(bounces) / kMostBounceRays + 1),
      direct_{std::vector<Direct>(scene.mesh.points()), std::vector<Direct>(scene.mesh.points())} {
    const std::vector<EnvironmentLookup::SkyLamp> sky_lamps = environment_.lamps(kSkyLamps);
    for_points(scene.mesh.points(), "light", progress, [&](std::uint32_t point) {
        for (std::size_t side = 0; side < sides_of(point); ++side)
            direct_[side][point] = {sky_at(point, side, sky_lamps), lamps_at(point, side, light)};
    });
}

std::size_t BounceLight::sides_of(std::uint32_t point) const {
    return scene_.mesh.is_double_sided(point) ? 2 : 1;
}

// By the lamps that rays do not find blocked. The lamps of a smooth environment are few for it: what they find is
// taken as a ratio to their own sum without shadows.
glm::vec3 BounceLight::sky_at(std::uint32_t point, std::size_t side,
                              std::span<const EnvironmentLookup::SkyLamp> sky_lamps) const {
    const glm::vec3 normal = kUp[side] * scene_.mesh.normal(point);
    const RayOrigins origins(scene_.mesh, scene_.fans.of(point), point, kUp[side]);
    glm::vec3 reached(0.0f), all(0.0f);
    for (std::size_t i = 0; i < sky_lamps.size(); ++i) {
        const float cosine = glm::dot(normal, sky_lamps[i].direction);
        if (!(cosine > 0.0f)) continue;
        const glm::vec3 light = sky_lamps[i].irradiance * cosine;
        all += light;
        const RayOrigins::Start start = origins.at(i, sky_lamps[i].direction);
        if (!start.found ||
            !scene_.rays.is_blocked({start.origin, sky_lamps[i].direction, 0.0f, 0.0f}))
            reached += light;
    }
    if (!(luminance_of(all) > 0.0f))
        return (1.0f - f32::blocked_about(scene_.blocked[point], to_f32(normal))) *
               environment_.irradiance(normal);
    return environment_.irradiance(normal) * reached / glm::max(all, glm::vec3(1e-20f));
}

float BounceLight::sky_ratio(std::uint32_t point, std::size_t side) const {
    if (side >= sides_of(point)) return 1.0f;
    const f32::vec3 n = to_f32(kUp[side] * scene_.mesh.normal(point));
    const f32::Harmonics& blocked = scene_.blocked[point];
    const glm::vec3 open = to_glm(f32::open_direction(blocked, n));
    const float length = glm::length(open);
    if (!(length > 0.0f) || !(blocked.mean > 0.0f)) return 1.0f;
    const glm::vec3 shown =
        (1.0f - f32::blocked_about(blocked, n)) * environment_.irradiance(open / length);
    // 1e-3 of the open sky: what is darker has no ratio that matters.
    const float least = 1e-3f * luminance_of(environment_.irradiance(to_glm(n))) + 1e-20f;
    return std::clamp(
        (luminance_of(direct_[side][point].sky) + least) / (luminance_of(shown) + least), 0.0f,
        kMostSkyRatio);
}

glm::vec3 BounceLight::lamps_at(std::uint32_t point, std::size_t side,
                                const SceneLight& light) const {
    glm::vec3 sum(0.0f);
    const glm::vec3 position = scene_.mesh.position(point);
    const glm::vec3 normal = kUp[side] * scene_.mesh.normal(point);
    const RayOrigins origins(scene_.mesh, scene_.fans.of(point), point, kUp[side]);
    for (const Light& lamp : light.lights) {
        const PunctualValues values = punctual_values(lamp);
        const f32::LightAtPoint at =
            f32::light_at(to_f32(glm::vec3(values.place)), values.place.w, to_f32(values.axis),
                          {values.cone.x, values.cone.y}, values.inverse_range2, to_f32(position));
        const glm::vec3 wi = to_glm(at.wi);
        const float cosine = glm::dot(normal, wi);
        const float falloff = has_area(lamp) ? area_share(lamp, position) : at.falloff;
        if (!(cosine > 0.0f) || !(falloff > 0.0f)) continue;
        const RayOrigins::Start start = origins.at(0, wi);
        const float farthest = values.place.w > 0.0f ? glm::length(lamp.position - position) : 0.0f;
        if (start.found && scene_.rays.is_blocked({start.origin, wi, 0.0f, farthest})) continue;
        sum += lamp.color * (lamp.intensity * falloff * cosine / std::numbers::pi_v<float>);
    }
    return sum;
}

// Radiance of a point that a ray along `direction` has hit.
glm::vec3 BounceLight::radiance_of(const RayHit& hit, const glm::vec3& direction,
                                   std::span<const f32::Surroundings> before) const {
    const WorldMesh& mesh = scene_.mesh.meshes()[hit.mesh];
    const BounceMaterial& material = scene_.materials[static_cast<std::size_t>(mesh.material)];
    const std::span<const std::uint32_t> points = scene_.mesh.points_of(hit.mesh);
    const std::array<float, 3> weights = {1.0f - hit.u - hit.v, hit.u, hit.v};
    // The side that the ray has come to, whatever the order of the corners. One that is not drawn is black.
    glm::vec3 up(0.0f);
    for (std::size_t k = 0; k < 3; ++k)
        up += mesh.normals[mesh.indices[3 * static_cast<std::size_t>(hit.triangle) + k]];
    const float turned = glm::dot(hit.normal, up) < 0.0f ? -1.0f : 1.0f;
    const std::size_t side = turned * glm::dot(hit.normal, direction) > 0.0f ? 1 : 0;
    if (side == 1 && !mesh.double_sided) return glm::vec3(0.0f);
    glm::vec3 normal(0.0f), sky(0.0f), lamps(0.0f), color(0.0f), slope(0.0f);
    f32::Harmonics blocked{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = mesh.indices[3 * static_cast<std::size_t>(hit.triangle) + k];
        const std::uint32_t point = points[vertex];
        normal += weights[k] * kUp[side] * mesh.normals[vertex];
        sky += weights[k] * direct_[side][point].sky;
        lamps += weights[k] * direct_[side][point].lamps;
        blocked = blocked + scene_.blocked[point] * weights[k];
        if (before.empty()) continue;
        color += weights[k] * to_glm(before[point].color);
        slope += weights[k] * to_glm(before[point].slope);
    }
    const float length = glm::length(normal);
    normal = length > 0.0f ? normal / length : glm::normalize(kUp[side] * turned * hit.normal);
    const f32::Surroundings around{to_f32(color), to_f32(slope), 1.0f};
    const float share = f32::blocked_about(blocked, to_f32(normal));
    const glm::vec3 all =
        sky + lamps + to_glm(f32::surroundings_about(around, share, to_f32(normal)));
    const glm::vec3 mirror = direction - 2.0f * glm::dot(direction, normal) * normal;
    const float hidden = f32::blocked_towards(blocked, to_f32(mirror));
    // The highlight of a lamp is spread as that of a diffuse surface.
    const glm::vec3 reflected = (1.0f - hidden) * environment_.radiance(mirror, material.alpha) +
                                lamps +
                                hidden * to_glm(f32::surroundings_towards(around, to_f32(mirror)));
    // The mean over directions: the rise at grazing angles is more than a plane of least squares can follow.
    const float through = f32::diffuse_albedo(material.brdf, material.dielectric_f0,
                                              material.dielectric_f90, kMeanCosine);
    return material.emitted + material.diffuse * (all * through) + material.specular * reflected;
}

f32::Surroundings BounceLight::surroundings_of(std::uint32_t point,
                                               std::span<const f32::Surroundings> before) const {
    const glm::vec3 normal = scene_.mesh.normal(point);
    if (!(scene_.blocked[point].mean > 0.0f) || glm::dot(normal, normal) == 0.0f)
        return {{}, {}, 1.0f};
    HitSums sums;
    for (std::size_t side = 0; side < sides_of(point); ++side) {
        const RayOrigins origins(scene_.mesh, scene_.fans.of(point), point, kUp[side]);
        const HemisphereAxes axes(kUp[side] * normal, point);
        const std::span<const std::uint32_t> hits = scene_.hits.of(point, side);
        std::size_t number = 0;
        for (std::size_t i = 0; i < directions_.size(); ++i) {
            if ((hits[i / 32] >> (i % 32) & 1U) == 0 || number++ % step_ != 0) continue;
            const glm::vec3 w = axes(directions_[i]);
            const RayOrigins::Start start = origins.at(i, w);
            const std::optional<RayHit> hit = scene_.rays.nearest({start.origin, w, 0.0f, 0.0f});
            if (hit) sums.add(w, radiance_of(*hit, w, before));
        }
    }
    return sums.fit();
}

std::vector<f32::Surroundings> BounceLight::bounce(std::span<const f32::Surroundings> before,
                                                   const Progress& progress) const {
    std::vector<f32::Surroundings> after(scene_.mesh.points());
    for_points(after.size(), "light between surfaces", progress,
               [&](std::uint32_t point) { after[point] = surroundings_of(point, before); });
    return after;
}

}  // namespace burnish
