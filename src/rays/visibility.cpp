#include "burnish/visibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <optional>
#include <utility>

#include "burnish/error.hpp"
#include "burnish/f32.hpp"
#include "core/parallel.hpp"
#include "rays/bounce_light.hpp"
#include "rays/bounce_material.hpp"
#include "rays/near_points.hpp"
#include "rays/ray_scene.hpp"
#include "rays/sample_mesh.hpp"
#include "rays/vectors.hpp"
#include "rays/vertex_rays.hpp"

namespace burnish {
namespace {

constexpr int kFewestRays = 16;
// Rays of all points together: 3 seconds of two cores.
constexpr double kMostRays = 1.5e7;
// Edges are split until they are shorter than this part of the scene's diagonal, and where visibility changes
// fast until they are shorter than the second.
constexpr float kCoarseEdges = 1.0f / 64.0f, kFineEdges = 1.0f / 500.0f;
// The root mean square over all directions of the difference of blocked shares from which on it changes fast:
// above what rays leave to chance.
constexpr float kFastChange = 0.12f;
// Edges that may be split: a third of the points, within these.
constexpr std::size_t kFewestSplitEdges = 10'000, kMostSplitEdges = 40'000;
constexpr int kRounds = 8;      // of splitting: each halves the edges
constexpr int kSmoothings = 2;  // of what is blocked, and of the light of surroundings
// Radii of smoothing, in diagonals of the scene: of what is blocked, and of light.
constexpr float kSmoothing = 1.0f / 120.0f, kLightSmoothing = 1.0f / 50.0f;
// The difference of blocked shares from which on two points do not share their light.
constexpr float kAlike = 0.15f;
// An instance whose points are all blocked beyond this share sees nothing.
constexpr float kSeesNothing = 0.995f;

void require_sound(const VisibilitySettings& settings) {
    if (settings.rays >= kFewestRays && settings.rays <= 4096) return;
    throw Error("visibility", "rays", "16 to 4096", std::to_string(settings.rays));
}

float diagonal_of(const std::vector<WorldMesh>& meshes) {
    glm::vec3 low(INFINITY), high(-INFINITY);
    for (const WorldMesh& mesh : meshes) {
        for (const glm::vec3& p : mesh.positions) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    }
    return low.x <= high.x ? glm::length(high - low) : 0.0f;
}

float root_mean_square(const f32::Harmonics& h) {
    return std::sqrt(f32::harmonics_product(h, h));
}

std::int16_t packed(float value) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0f, 1.0f) * 32767.0f));
}

std::array<std::int16_t, 16> packed(const f32::Harmonics& h) {
    return {packed(h.mean), packed(h.x1.x), packed(h.x1.y), packed(h.x1.z),
            packed(h.x2.x), packed(h.x2.y), packed(h.x2.z), packed(h.y2.x),
            packed(h.y2.y), packed(h.x3.x), packed(h.x3.y), packed(h.x3.z),
            packed(h.y3.x), packed(h.y3.y), packed(h.y3.z), packed(h.z3)};
}

// Surroundings::sky of either side of a point.
using Skies = std::array<float, 2>;

std::array<std::uint16_t, 8> packed(const f32::Surroundings& s, const Skies& skies) {
    const auto half = [](float value) {
        return glm::packHalf1x16(std::isfinite(value) ? std::clamp(value, -60000.0f, 60000.0f)
                                                      : 0.0f);
    };
    return {half(s.color.x), half(s.color.y), half(s.color.z),       half(s.slope.x),
            half(s.slope.y), half(s.slope.z), half(skies[0] - 1.0f), half(skies[1] - 1.0f)};
}

// The mean of an attribute of the parents of a vertex.
glm::vec3 middle(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 sum = a + b;
    const float length = glm::length(sum);
    return length > 0.0f ? sum / length : a;
}

// The mesh with the vertices that splitting has added.
std::shared_ptr<const Mesh> split_mesh(const Mesh& mesh, const WorldMesh& world,
                                       std::span<const SampleMesh::Parents> added) {
    auto out = std::make_shared<Mesh>(mesh);
    for (const auto [a, b] : added) {
        const auto average = [a = a, b = b](auto& values) {
            if (!values.empty()) values.push_back(0.5f * (values[a] + values[b]));
        };
        average(out->positions);
        average(out->texcoord0);
        average(out->texcoord1);
        average(out->colors);
        if (!out->normals.empty()) out->normals.push_back(middle(out->normals[a], out->normals[b]));
        if (!out->tangents.empty())
            out->tangents.emplace_back(
                middle(glm::vec3(out->tangents[a]), glm::vec3(out->tangents[b])),
                out->tangents[a].w);
    }
    out->indices = world.indices;
    if (world.mirrored)
        for (std::size_t c = 0; c + 2 < out->indices.size(); c += 3)
            std::swap(out->indices[c + 1], out->indices[c + 2]);
    return out;
}

}  // namespace

struct VisibilityFinder::Impl {
    Impl(const Scene& scene, const VisibilitySettings& settings, const Progress& progress)
        : mesh(world_meshes(scene)) {
        require_sound(settings);
        set_materials(scene.materials, scene.textures);
        diagonal = diagonal_of(mesh.meshes());
        split_left =
            settings.split ? std::clamp(mesh.points() / 3, kFewestSplitEdges, kMostSplitEdges) : 0;
        split_long_edges();
        rays = RayScene(mesh.meshes());
        count = ray_count(settings.rays);
        hits = HitTable(count, any_double_sided() ? 2 : 1);
        find(progress);
        split_fast_changes(progress);
        smooth();
        make_result(scene);
    }

    void set_materials(std::span<const Material> list, std::span<const Texture> textures) {
        materials.clear();
        for (const Material& material : list)
            materials.push_back(bounce_material(material, textures));
    }

    int ray_count(int wanted) const {
        const double points =
            static_cast<double>(std::max<std::size_t>(mesh.points() + split_left, 1));
        return std::clamp(static_cast<int>(kMostRays / points), kFewestRays, wanted);
    }

    bool any_double_sided() const {
        return std::ranges::any_of(mesh.meshes(), &WorldMesh::double_sided);
    }

    float length_of(std::uint32_t a, std::uint32_t b) const {
        return glm::length(mesh.position(a) - mesh.position(b));
    }

    // Splits edges in rounds, each of which halves them. Returns false when nothing is left to split.
    bool split(const SampleMesh::Wants& wants) {
        const std::size_t edges = split_left > 0 ? mesh.split(wants, split_left) : 0;
        split_left -= edges;
        return edges > 0;
    }

    void split_long_edges() {
        const float longest = kCoarseEdges * diagonal;
        const auto is_long = [&](auto a, auto b) { return length_of(a, b) > longest; };
        for (int round = 0; round < kRounds && split(is_long); ++round) {
        }
    }

    void split_fast_changes(const Progress& progress) {
        const float shortest = kFineEdges * diagonal;
        const auto changes = [&](std::uint32_t a, std::uint32_t b) {
            // What the points of this round see is not known yet.
            if (a >= blocked.size() || b >= blocked.size() || length_of(a, b) < shortest)
                return false;
            return root_mean_square(blocked[a] + blocked[b] * -1.0f) > kFastChange;
        };
        for (int round = 0; round < kRounds && split(changes); ++round) find(progress);
    }

    // Finds what the points see that have been added since the last call.
    void find(const Progress& progress) {
        fans = mesh.fans();
        const std::size_t first = blocked.size(), points = mesh.points();
        blocked.resize(points);
        hits.resize(points);
        const std::vector<glm::vec3> directions = even_hemisphere(count);
        constexpr std::size_t kGroup = 4096, kGrain = 64;
        for (std::size_t from = first; from < points; from += kGroup) {
            progress.step("visibility", static_cast<double>(from) / static_cast<double>(points));
            parallel_for(
                std::min(kGroup, points - from), kGrain, [&](std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i) {
                        const auto point = static_cast<std::uint32_t>(from + i);
                        blocked[point] = blocked_at(mesh, fans, rays, point, directions, hits);
                    }
                });
        }
        traced += (points - first) * static_cast<std::size_t>(count);
    }

    // How alike two points see, 0 to 1: differences that chance explains count little.
    float likeness(std::uint32_t a, std::uint32_t b, float chance) const {
        const float difference = root_mean_square(blocked[a] + blocked[b] * -1.0f) / chance;
        return std::exp(-difference * difference);
    }

    // Calls body(point, near points) for all points.
    template <typename Body>
    void for_points(const NearPoints& near, const Body& body) const {
        parallel_for(blocked.size(), 256, [&](std::size_t begin, std::size_t end) {
            std::vector<NearPoints::Near> found;
            for (std::size_t i = begin; i < end; ++i) {
                near.find(static_cast<std::uint32_t>(i), found);
                body(static_cast<std::uint32_t>(i), found);
            }
        });
    }

    // The mean with near points that differ by no more than chance explains: fewer rays, more chance.
    void smooth() {
        const NearPoints near(mesh, fans, kSmoothing * diagonal);
        for (int i = 0; i < kSmoothings; ++i) smooth_blocked(near);
    }

    void smooth_blocked(const NearPoints& near) {
        const float chance = 1.0f / std::sqrt(static_cast<float>(count));
        std::vector<f32::Harmonics> next(blocked.size());
        for_points(near, [&](std::uint32_t point, std::span<const NearPoints::Near> found) {
            f32::Harmonics sum = blocked[point];
            float weights = 1.0f;
            for (const NearPoints::Near& other : found) {
                const float weight = other.weight * likeness(point, other.point, chance);
                sum = sum + blocked[other.point] * weight;
                weights += weight;
            }
            next[point] = sum * (1.0f / weights);
        });
        blocked = std::move(next);
    }

    // The ratios of the sky, which shadows make differ more than chance does.
    std::vector<Skies> smoothed(const std::vector<Skies>& skies) const {
        const NearPoints near(mesh, fans, kSmoothing * diagonal);
        std::vector<Skies> next(skies.size());
        for_points(near, [&](std::uint32_t point, std::span<const NearPoints::Near> found) {
            Skies sum = skies[point];
            float weights = 1.0f;
            for (const NearPoints::Near& other : found) {
                const float weight = other.weight * likeness(point, other.point, kAlike);
                for (std::size_t side = 0; side < 2; ++side)
                    sum[side] += skies[other.point][side] * weight;
                weights += weight;
            }
            next[point] = {sum[0] / weights, sum[1] / weights};
        });
        return next;
    }

    // The light of surroundings from near points that see alike: what blocks more is known by more rays.
    void smooth_light(std::vector<f32::Surroundings>& around) const {
        const NearPoints near(mesh, fans, kLightSmoothing * diagonal);
        for (int i = 0; i < kSmoothings; ++i) smooth_light(around, near);
    }

    void smooth_light(std::vector<f32::Surroundings>& around, const NearPoints& near) const {
        std::vector<f32::Surroundings> next(around.size());
        for_points(near, [&](std::uint32_t point, std::span<const NearPoints::Near> found) {
            // 1e-6: a point that nothing blocks takes the light of its neighbors.
            float weights = blocked[point].mean + 1e-6f;
            f32::Surroundings sum{around[point].color * weights, around[point].slope * weights,
                                  0.0f};
            for (const NearPoints::Near& other : found) {
                const float weight =
                    blocked[other.point].mean * other.weight * likeness(point, other.point, kAlike);
                sum.color = sum.color + around[other.point].color * weight;
                sum.slope = sum.slope + around[other.point].slope * weight;
                weights += weight;
            }
            next[point] = {sum.color * (1.0f / weights), sum.slope * (1.0f / weights),
                           around[point].sky};
        });
        around = std::move(next);
    }

    // Whether nothing of the mesh sees out.
    bool sees_nothing(std::size_t m) const {
        return std::ranges::all_of(mesh.points_of(m), [&](std::uint32_t point) {
            return f32::blocked_about(blocked[point], to_f32(mesh.normal(point))) > kSeesNothing;
        });
    }

    void make_result(const Scene& scene) {
        result.instances.resize(scene.instances.size());
        for (std::size_t m = 0; m < mesh.meshes().size(); ++m) {
            const WorldMesh& world = mesh.meshes()[m];
            const auto index = static_cast<std::size_t>(world.instance);
            const Mesh& own = scene.meshes[static_cast<std::size_t>(scene.instances[index].mesh)];
            if (sees_nothing(m)) {
                result.warnings.push_back(
                    fmt::format("{}: visibility: none of its vertices sees out, as its normals "
                                "point inwards or it is "
                                "closed in: it is lit as if nothing stood before it "
                                "(visibility=false does so for all)",
                                own.name.empty() ? "mesh" : own.name));
                continue;
            }
            InstanceVisibility& instance = result.instances[index];
            if (!mesh.added(m).empty()) instance.mesh = split_mesh(own, world, mesh.added(m));
            for (const std::uint32_t point : mesh.points_of(m))
                instance.vertices.push_back({packed(blocked[point]), {}});
        }
    }

    Visibility lit_by(std::span<const f32::Surroundings> around,
                      std::span<const Skies> skies) const {
        Visibility lit = result;
        for (std::size_t m = 0; m < mesh.meshes().size(); ++m) {
            InstanceVisibility& instance =
                lit.instances[static_cast<std::size_t>(mesh.meshes()[m].instance)];
            const std::span<const std::uint32_t> points = mesh.points_of(m);
            for (std::size_t v = 0; v < instance.vertices.size(); ++v)
                instance.vertices[v].around = packed(around[points[v]], skies[points[v]]);
        }
        return lit;
    }

    SampleMesh mesh;
    SampleMesh::Fans fans;
    std::vector<BounceMaterial> materials;
    RayScene rays{{}};  // of the meshes before edges were split where visibility changes
    std::optional<RayScene> split_rays;   // of the meshes as they are
    std::vector<f32::Harmonics> blocked;  // of every point
    HitTable hits;
    float diagonal = 0.0f;
    int count = 0;               // rays a point
    std::size_t split_left = 0;  // edges that may still be split
    std::size_t traced = 0;
    Visibility result;
};

VisibilityFinder::VisibilityFinder(const Scene& scene, const VisibilitySettings& settings,
                                   const Progress& progress)
    : impl_(std::make_unique<Impl>(scene, settings, progress)) {}

VisibilityFinder::~VisibilityFinder() = default;
VisibilityFinder::VisibilityFinder(VisibilityFinder&&) noexcept = default;
VisibilityFinder& VisibilityFinder::operator=(VisibilityFinder&&) noexcept = default;

void VisibilityFinder::set_materials(std::span<const Material> materials,
                                     std::span<const Texture> textures) {
    impl_->set_materials(materials, textures);
}

std::shared_ptr<const Visibility> VisibilityFinder::visibility() const {
    return std::make_shared<const Visibility>(impl_->result);
}

std::shared_ptr<const Visibility> VisibilityFinder::lit(const SceneLight& light, int bounces,
                                                        const Progress& progress) {
    if (bounces < 0 || bounces > 8)
        throw Error("visibility", "bounces", "0 to 8", std::to_string(bounces));
    // Rays that carry light end on the triangles that the points belong to.
    if (!impl_->split_rays) impl_->split_rays.emplace(impl_->mesh.meshes());
    const BounceScene scene{impl_->mesh,    impl_->fans, *impl_->split_rays, impl_->materials,
                            impl_->blocked, impl_->hits, impl_->count};
    const BounceLight direct(scene, light, bounces, progress);
    std::vector<f32::Surroundings> around;
    for (int i = 0; i < bounces; ++i) around = direct.bounce(around, progress);
    around.resize(impl_->mesh.points(), {{}, {}, 1.0f});
    std::vector<Skies> skies(around.size());
    for (std::uint32_t i = 0; i < skies.size(); ++i)
        skies[i] = {direct.sky_ratio(i, 0), direct.sky_ratio(i, 1)};
    impl_->smooth_light(around);
    return std::make_shared<const Visibility>(impl_->lit_by(around, impl_->smoothed(skies)));
}

std::size_t VisibilityFinder::rays() const {
    return impl_->traced;
}

}  // namespace burnish
