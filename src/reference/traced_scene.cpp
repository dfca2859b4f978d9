#include "reference/traced_scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "core/index_of.hpp"
#include "rays/vectors.hpp"

namespace burnish {
namespace {

// Surfaces that a ray passes before it counts as ended: a pile of masked leaves.
constexpr int kMostPassed = 64;

struct Corners {
    std::array<std::uint32_t, 3> index{};
    std::array<float, 3> weight{};
};

Corners corners_of(const WorldMesh& world, const RayHit& hit) {
    Corners c;
    for (std::size_t k = 0; k < 3; ++k)
        c.index[k] = world.indices[3 * std::size_t{hit.triangle} + k];
    c.weight = {1.0f - hit.u - hit.v, hit.u, hit.v};
    return c;
}

template <typename T>
T mean_of(const std::vector<T>& values, const Corners& c) {
    return c.weight[0] * values[c.index[0]] + c.weight[1] * values[c.index[1]] +
           c.weight[2] * values[c.index[2]];
}

// The step that keeps a ray from meeting the triangle that it leaves: some hundred roundings of its place.
float step_off(const glm::vec3& at) {
    return 1e-5f * std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z), 0.1f});
}

// What a step over the surface moves in texture coordinates: least squares over the edges of the triangle.
class TriangleMap {
  public:
    TriangleMap(const glm::vec3& e1, const glm::vec3& e2, const glm::vec2& t1, const glm::vec2& t2)
        : e1_(e1), e2_(e2), t1_(t1), t2_(t2) {
        a_ = glm::dot(e1, e1);
        b_ = glm::dot(e1, e2);
        c_ = glm::dot(e2, e2);
        const float det = a_ * c_ - b_ * b_;
        inverse_ = det > 0.0f ? 1.0f / det : 0.0f;  // a triangle without area: the finest level
    }
    glm::vec2 operator()(const glm::vec3& step) const {
        const float x = glm::dot(step, e1_), y = glm::dot(step, e2_);
        return ((c_ * x - b_ * y) * inverse_) * t1_ + ((a_ * y - b_ * x) * inverse_) * t2_;
    }

  private:
    glm::vec3 e1_, e2_;
    glm::vec2 t1_, t2_;
    float a_ = 0.0f, b_ = 0.0f, c_ = 0.0f, inverse_ = 0.0f;
};

}  // namespace

TracedScene::TracedScene(const Scene& scene) : meshes_(world_meshes(scene)) {
    PyramidStore pyramids(scene.textures);
    for (const Material& material : drawn_materials(scene.materials))
        readers_.emplace_back(material, pyramids);
    bool blends = false;
    for (const WorldMesh& world : meshes_) {
        attributes_.push_back(attributes_of(scene, world));
        const AlphaMode mode = scene.materials[index_of(world.material)].alpha_mode;
        blends = blends || mode == AlphaMode::blend;
        masked_ = masked_ || mode == AlphaMode::mask;
        sees_through_ = sees_through_ || mode != AlphaMode::opaque;
    }
    if (blends) blocking_.emplace(meshes_);
    for (WorldMesh& world : meshes_) world.blocks = true;
    all_.emplace(meshes_);
}

TracedScene::Attributes TracedScene::attributes_of(const Scene& scene,
                                                   const WorldMesh& world) const {
    const Instance& instance = scene.instances[index_of(world.instance)];
    const Material& material = scene.materials[index_of(world.material)];
    Attributes out;
    out.mesh = &scene.meshes[index_of(instance.mesh)];
    out.reads_textures = readers_[index_of(world.material)].reads_textures();
    out.sees_through = material.alpha_mode != AlphaMode::opaque;
    out.culled = !material.double_sided;
    const glm::mat3 linear(instance.transform);
    for (std::size_t v = 0; v < out.mesh->tangents.size(); ++v) {
        // As surface.vert.
        glm::vec3 t = linear * glm::vec3(out.mesh->tangents[v]);
        t *= 1.0f / std::sqrt(std::max(glm::dot(t, t), 1e-30f));
        const f32::vec3 sound = f32::tangent_or_any(to_f32(world.normals[v]), to_f32(t));
        out.tangents.emplace_back(to_glm(sound),
                                  out.mesh->tangents[v].w * (world.mirrored ? -1.0f : 1.0f));
    }
    return out;
}

std::optional<RayHit> TracedScene::nearest(Ray ray, const RayCone& cone, bool camera,
                                           float chance) const {
    for (int passed = 0; passed < kMostPassed; ++passed) {
        const std::optional<RayHit> hit = all_->nearest(ray);
        if (!hit) return hit;
        const Attributes& attributes = attributes_[hit->mesh];
        const bool back = glm::dot(hit->normal, ray.direction) > 0.0f;
        bool passes = camera && back && attributes.culled;
        if (!passes && attributes.sees_through) {
            const SurfaceHit surface = at(*hit, ray, cone);
            const float alpha = reader(surface.material).alpha(surface);
            // One number serves all blended surfaces on the way: each is passed by its own part of the interval.
            passes = chance >= alpha;
            if (passes) chance = (chance - alpha) / std::max(1.0f - alpha, 1e-6f);
        }
        if (!passes) return hit;
        // A millionth farther: the next float that is not this triangle again.
        ray.nearest = hit->distance * (1.0f + 1e-6f) + 1e-7f * step_off(ray.origin);
    }
    return std::nullopt;
}

SurfaceHit TracedScene::at(const RayHit& hit, const Ray& ray, const RayCone& cone) const {
    const WorldMesh& world = meshes_[hit.mesh];
    const Attributes& attributes = attributes_[hit.mesh];
    const Corners c = corners_of(world, hit);
    SurfaceHit out;
    out.material = world.material;
    out.position = mean_of(world.positions, c);
    out.to_eye = -ray.direction;
    out.front = glm::dot(hit.normal, ray.direction) < 0.0f;
    out.side = glm::normalize(out.front ? hit.normal : -hit.normal);
    out.normal = mean_of(world.normals, c);
    if (!attributes.tangents.empty()) {
        out.tangent = mean_of(attributes.tangents, c);
    } else {
        const f32::vec3 n = f32::normalize(to_f32(out.normal));
        out.tangent = glm::vec4(to_glm(f32::tangent_or_any(n, {0.0f, 0.0f, 0.0f})), 1.0f);
    }
    if (!attributes.mesh->colors.empty()) out.color = mean_of(attributes.mesh->colors, c);
    glm::vec3 lifted(0.0f);
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::vec3 n = out.front ? world.normals[c.index[k]] : -world.normals[c.index[k]];
        const float below = std::min(glm::dot(out.position - world.positions[c.index[k]], n), 0.0f);
        lifted -= c.weight[k] * below * n;
    }
    out.smooth_position = out.position + lifted;
    put_texture_coordinates(out, hit, ray, cone);
    return out;
}

void TracedScene::put_texture_coordinates(SurfaceHit& out, const RayHit& hit, const Ray& ray,
                                          const RayCone& cone) const {
    const WorldMesh& world = meshes_[hit.mesh];
    const Mesh& mesh = *attributes_[hit.mesh].mesh;
    const Corners c = corners_of(world, hit);
    const std::array<const std::vector<glm::vec2>*, 2> sets = {&mesh.texcoord0, &mesh.texcoord1};
    for (std::size_t s = 0; s < 2; ++s) {
        const std::vector<glm::vec2>& uv = *sets[s];
        if (uv.empty()) continue;
        out.uv[s] = mean_of(uv, c);
        if (!attributes_[hit.mesh].reads_textures) continue;
        const TriangleMap map(world.positions[c.index[1]] - world.positions[c.index[0]],
                              world.positions[c.index[2]] - world.positions[c.index[0]],
                              uv[c.index[1]] - uv[c.index[0]], uv[c.index[2]] - uv[c.index[0]]);
        const float width = cone.width + cone.spread * hit.distance;
        // Across the way of the ray and along it, where the cone meets the surface at a slant. 0.01: the slant of a
        // ray half a degree above the surface.
        const float cosine = std::max(glm::dot(out.side, out.to_eye), 0.01f);
        const glm::vec3 across = glm::cross(out.side, ray.direction);
        const float length = glm::length(across);
        const glm::vec3 a = length > 1e-6f ? across / length : glm::vec3(out.tangent);
        const glm::vec3 b = glm::cross(a, out.side);
        out.footprint[s] = {map(width * a), map((width / cosine) * b)};
    }
}

Ray TracedScene::leaving(const SurfaceHit& from, const glm::vec3& direction) const {
    Ray ray;
    ray.origin = from.smooth_position + step_off(from.position) * from.side;
    ray.direction = direction;
    return ray;
}

bool TracedScene::is_blocked(Ray ray) const {
    const RayScene& rays = blocking_ ? *blocking_ : *all_;
    if (!masked_) return rays.is_blocked(ray);
    const float farthest = ray.farthest;
    for (int passed = 0; passed < kMostPassed; ++passed) {
        const std::optional<RayHit> hit = rays.nearest(ray);
        if (!hit) return false;
        if (!attributes_[hit->mesh].sees_through) return true;
        const SurfaceHit surface = at(*hit, ray, {});
        if (reader(surface.material).alpha(surface) > 0.0f) return true;
        ray.nearest = hit->distance * (1.0f + 1e-6f) + 1e-7f * step_off(ray.origin);
        if (farthest > 0.0f && ray.nearest >= farthest) return false;
    }
    return true;
}

bool TracedScene::is_blocked(const SurfaceHit& from, const glm::vec3& direction,
                             float distance) const {
    if (!(glm::dot(from.side, direction) > 0.0f)) return true;
    Ray ray = leaving(from, direction);
    // 1e-4: a light that lies on a surface is not kept away by that surface.
    if (distance > 0.0f) ray.farthest = distance * (1.0f - 1e-4f);
    return is_blocked(ray);
}

}  // namespace burnish
