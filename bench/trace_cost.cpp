// What a path costs beyond its rays: primary and shadow rays over the sphere, shaded, against the same rays bare.
#include <chrono>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "burnish/stage.hpp"
#include "core/parallel.hpp"
#include "reference/path_tracer.hpp"
#include "report.hpp"
#include "scene/camera/view.hpp"

namespace burnish::bench {
namespace {

constexpr int kWidth = 640, kHeight = 360, kRounds = 15;

Stage lit_sphere() {
    StageRequest request;
    request.input = "builtin:sphere";
    request.environment = "none";
    request.lights = {"30,40,3"};
    request.values.set("width", std::to_string(kWidth), "bench");
    request.values.set("height", std::to_string(kHeight), "bench");
    return set_stage(request);
}

// Seconds; `row` does the work of one row of pixels.
template <typename Row>
double seconds_of(const Row& row) {
    const auto start = std::chrono::steady_clock::now();
    parallel_for(kHeight, 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) row(static_cast<int>(y));
    });
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// A primary ray through the middle of every pixel, and a ray to the light from where it hits the lit side.
class BareRays {
  public:
    explicit BareRays(const Stage& stage)
        : rays_(world_meshes(stage.scene)), to_light_(-stage.scene.lights[0].direction) {
        const CameraBasis camera = camera_basis(stage.camera);
        const auto pixel = static_cast<float>(2.0 * half_height_of(stage.camera) / kHeight);
        eye_ = glm::vec3(camera.position);
        right_ = glm::vec3(camera.right) * pixel;
        up_ = glm::vec3(camera.up) * pixel;
        forward_ = glm::vec3(-camera.back);
    }
    int row(int y) const {
        int blocked = 0;
        for (int x = 0; x < kWidth; ++x) {
            Ray ray;
            ray.origin = eye_;
            ray.direction =
                glm::normalize(forward_ + right_ * (static_cast<float>(x) + 0.5f - 0.5f * kWidth) +
                               up_ * (0.5f * kHeight - static_cast<float>(y) - 0.5f));
            const auto hit = rays_.nearest(ray);
            if (!hit) continue;
            const glm::vec3 normal = glm::normalize(hit->normal);
            if (glm::dot(normal, to_light_) <= 0.0f) continue;
            Ray shadow;
            shadow.origin = ray.origin + hit->distance * ray.direction + 1e-4f * normal;
            shadow.direction = to_light_;
            blocked += rays_.is_blocked(shadow) ? 1 : 0;
        }
        return blocked;
    }

  private:
    RayScene rays_;
    glm::vec3 to_light_, eye_{0.0f}, right_{0.0f}, up_{0.0f}, forward_{0.0f};
};

}  // namespace

void measure_traces(Report& report) {
    const Stage stage = lit_sphere();
    const BareRays bare(stage);
    const PathTracer tracer(stage.scene, stage.environment, stage.camera, stage.settings, 0);
    std::vector<int> blocked(kHeight);
    std::vector<float> sums(kHeight);
    std::vector<double> ratios;
    for (int round = 0; round < kRounds; ++round) {
        const double rays_s =
            seconds_of([&](int y) { blocked[static_cast<std::size_t>(y)] = bare.row(y); });
        const double paths_s = seconds_of([&](int y) {
            float sum = 0.0f;
            for (int x = 0; x < kWidth; ++x)
                sum += tracer.sample(x, y, static_cast<std::uint32_t>(round)).radiance.x;
            sums[static_cast<std::size_t>(y)] = sum;
        });
        ratios.push_back(paths_s / rays_s);
    }
    // Of the throughput of bare rays, 60 %.
    report.rows.push_back(
        {"a traced sample of a sphere of 102 k triangles, one light, against its bare rays",
         1.0 / 0.6, median(ratios), half_quartile_distance(ratios), "x"});
}

}  // namespace burnish::bench
