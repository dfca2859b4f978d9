// The truth of docs/theory/visibility.md: a scene whose surfaces see one another, by brute force. Paths go from the
// eye through the maths of shading/ in double precision, from surface to surface by rays against all triangles;
// nothing is baked, filtered or cut off. Materials are read without textures.
// Usage: trace_stage SCENE PATHS REFLECTIONS OUT.exr [ENVIRONMENT]
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <random>
#include <string>
#include <vector>

#include "burnish/error.hpp"
#include "burnish/f64.hpp"
#include "burnish/image_io.hpp"
#include "burnish/stage.hpp"
#include "burnish/surface.hpp"
#include "core/parallel.hpp"
#include "rays/ray_scene.hpp"
#include "scene/camera/view.hpp"

namespace burnish::bench {
namespace {

using Random = std::mt19937_64;

class Tracer {
  public:
    Tracer(const Stage& stage, int reflections)
        : stage_(stage),
          reflections_(reflections),
          meshes_(world_meshes(stage.scene)),
          rays_(meshes_) {
        for (const Material& material : stage.scene.materials) surfaces_.emplace_back(material);
    }

    // Radiance along a ray, one path.
    glm::dvec3 along(Ray ray, Random& random) const {
        glm::dvec3 weight(1.0);
        for (int i = 0;; ++i) {
            const std::optional<RayHit> hit = rays_.nearest(ray);
            if (!hit) return weight * environment(ray.direction, i == 0);
            if (i > reflections_) return glm::dvec3(0.0);
            if (!reflect(*hit, ray, weight, random)) return glm::dvec3(0.0);
        }
    }

  private:
    glm::dvec3 environment(const glm::vec3& world, bool background) const {
        if (background && stage_.settings.background != BackgroundKind::environment)
            return glm::dvec3(stage_.settings.background_color);
        const Environment& sky = stage_.environment;
        const Image& map = background && !sky.backdrop.empty() ? sky.backdrop : sky.radiance;
        const double c = std::cos(static_cast<double>(stage_.settings.environment_rotation));
        const double s = std::sin(static_cast<double>(stage_.settings.environment_rotation));
        const glm::dvec3 d(c * world.x - s * world.z, world.y, s * world.x + c * world.z);
        const double u = 0.5 + std::atan2(d.x, -d.z) / (2.0 * f64::kPi);
        const double v = std::acos(std::clamp(d.y, -1.0, 1.0)) / f64::kPi;
        const int x = static_cast<int>(u * map.width) % map.width;
        const int y = std::min(static_cast<int>(v * map.height), map.height - 1);
        const float* texel = map.at(x, y);
        return glm::dvec3(texel[0], texel[1], texel[2]) *
               static_cast<double>(stage_.settings.environment_intensity);
    }

    // The axes of the surface at a hit, as surface.vert and surface_frame make them.
    f64::Frame frame_at(const RayHit& hit, const glm::vec3& to_eye) const {
        const WorldMesh& world = meshes_[hit.mesh];
        const Instance& instance = stage_.scene.instances[static_cast<std::size_t>(world.instance)];
        const Mesh& mesh = stage_.scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const std::array<float, 3> weights = {1.0f - hit.u - hit.v, hit.u, hit.v};
        glm::dvec3 normal(0.0), tangent(0.0);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex =
                world.indices[3 * static_cast<std::size_t>(hit.triangle) + k];
            normal += static_cast<double>(weights[k]) * glm::dvec3(world.normals[vertex]);
            if (mesh.tangents.empty()) continue;
            const glm::vec3 t = glm::mat3(instance.transform) * glm::vec3(mesh.tangents[vertex]);
            tangent += static_cast<double>(weights[k]) * glm::dvec3(t);
        }
        const f64::vec3 eye(glm::dvec3{to_eye});
        const f64::vec3 n = f64::normalize(f64::vec3(normal));
        const f64::vec3 t = f64::tangent_or_any(n, f64::vec3(tangent));
        const bool behind = glm::dot(hit.normal, to_eye) < 0.0f;
        return f64::surface_frame(n, t, 1.0, behind ? -1.0 : 1.0, eye);
    }

    // Moves the ray to where a path goes on, and its weight; false: it ends.
    bool reflect(const RayHit& hit, Ray& ray, glm::dvec3& weight, Random& random) const {
        const glm::vec3 to_eye = -1.0f * ray.direction;
        const f64::Frame axes = frame_at(hit, to_eye);
        const f64::vec3 wo = f64::frame_to_local(axes, f64::vec3(glm::dvec3(to_eye)));
        const SurfacePoint& surface =
            surfaces_[static_cast<std::size_t>(meshes_[hit.mesh].material)];
        const auto uniform = [&] { return std::uniform_real_distribution<double>()(random); };
        const auto sample = surface.sample({wo.x, wo.y, wo.z}, {uniform(), uniform(), uniform()});
        if (!sample) return false;
        weight *= sample->weight;
        const f64::vec3 wi = f64::frame_to_outer(axes, f64::vec3(sample->to_light));
        const glm::vec3 at = ray.origin + hit.distance * ray.direction;
        glm::vec3 side = glm::normalize(hit.normal);
        if (glm::dot(side, to_eye) < 0.0f) side = -1.0f * side;
        const glm::vec3 size = glm::abs(at);
        const float off = 1e-5f * std::max({size.x, size.y, size.z, 0.1f});
        ray = {at + off * side, glm::normalize(glm::vec3(wi.x, wi.y, wi.z)), 0.0f, 0.0f};
        return true;
    }

    const Stage& stage_;
    int reflections_;
    std::vector<WorldMesh> meshes_;
    RayScene rays_;
    std::vector<SurfacePoint> surfaces_;
};

Image picture(const Stage& stage, int paths, int reflections) {
    const Tracer tracer(stage, reflections);
    const RenderSettings& o = stage.settings;
    const CameraBasis camera = camera_basis(stage.camera);
    const double pixel = 2.0 * half_height_of(stage.camera) / o.height;
    Image image(o.width, o.height, 3);
    parallel_for(static_cast<std::size_t>(o.height), 1, [&](std::size_t begin, std::size_t) {
        const int y = static_cast<int>(begin);
        Random random(begin + 1);
        const auto uniform = [&] { return std::uniform_real_distribution<double>()(random); };
        for (int x = 0; x < o.width; ++x) {
            glm::dvec3 sum(0.0);
            for (int i = 0; i < paths; ++i) {
                // The filter of the renderer: a triangle of half width 1 pixel.
                const double px = (x + uniform() + uniform() - 0.5 - 0.5 * o.width) * pixel;
                const double py = (0.5 * o.height - (y + uniform() + uniform() - 0.5)) * pixel;
                const glm::dvec3 towards =
                    glm::normalize(camera.right * px + camera.up * py - camera.back);
                sum += tracer.along({glm::vec3(camera.position), glm::vec3(towards), 0.0f, 0.0f},
                                    random);
            }
            for (int c = 0; c < 3; ++c)
                image.at(x, y)[c] = static_cast<float>(sum[c] / static_cast<double>(paths));
        }
    });
    return image;
}

}  // namespace
}  // namespace burnish::bench

int main(int argc, char** argv) {
    if (argc < 5) {
        std::fprintf(stderr, "usage: trace_stage SCENE PATHS REFLECTIONS OUT.exr [ENVIRONMENT]\n");
        return 2;
    }
    try {
        burnish::StageRequest request;
        request.input = argv[1];
        if (argc > 5) request.environment = argv[5];
        const burnish::Stage stage = burnish::set_stage(request);
        burnish::write_image(argv[4],
                             burnish::bench::picture(stage, std::atoi(argv[2]), std::atoi(argv[3])),
                             {}, {});
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "trace_stage: %s\n", error.what());
        return 1;
    }
}
