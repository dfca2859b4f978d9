#include "scene/light/studio.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "core/constants.hpp"
#include "core/parallel.hpp"

namespace burnish {

namespace {

constexpr int kWidth = 1024, kHeight = 512;

float radians_of(float degrees) {
    return degrees * static_cast<float>(kDegree);
}

float smooth_step(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

// A box prepared for evaluation: the plane at distance 1 that contains it.
struct PlacedBox {
    glm::vec3 center, right, up;
    float half_width, half_height, corner, fade, rim;
    glm::vec3 radiance;
};

PlacedBox placed(const SoftBox& box, float texel) {
    PlacedBox out{};
    out.center = glm::normalize(box.towards);
    // Any axis but the line of sight serves as a start.
    const glm::vec3 axis =
        std::abs(out.center.y) < 0.999f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
    const glm::vec3 right = glm::normalize(glm::cross(out.center, axis));
    const glm::vec3 up = glm::cross(right, out.center);
    const float c = std::cos(radians_of(box.roll_deg)), s = std::sin(radians_of(box.roll_deg));
    out.right = c * right + s * up;
    out.up = c * up - s * right;
    out.half_width = std::tan(0.5f * radians_of(box.width_deg));
    out.half_height = std::tan(0.5f * radians_of(box.height_deg));
    const float shorter = std::min(out.half_width, out.half_height);
    out.corner = box.corner * shorter;
    out.fade = std::max(box.softness * shorter, 2.0f * texel);
    out.radiance = box.radiance;
    out.rim = box.rim;
    return out;
}

glm::vec3 radiance_of(const PlacedBox& box, const glm::vec3& direction) {
    const float facing = glm::dot(direction, box.center);
    if (facing <= 0.0f) return glm::vec3(0.0f);
    const float x = std::abs(glm::dot(direction, box.right)) / facing;
    const float y = std::abs(glm::dot(direction, box.up)) / facing;
    // Distance to a rectangle with rounded corners, negative inside.
    const float dx = x - (box.half_width - box.corner), dy = y - (box.half_height - box.corner);
    const float distance = std::hypot(std::max(dx, 0.0f), std::max(dy, 0.0f)) +
                           std::min(std::max(dx, dy), 0.0f) - box.corner;
    const float covered = 1.0f - smooth_step(-0.5f * box.fade, 0.5f * box.fade, distance);
    if (covered <= 0.0f) return glm::vec3(0.0f);
    // The lamp behind the diffuser is brightest in the middle.
    const float px = std::min(x / box.half_width, 1.0f), py = std::min(y / box.half_height, 1.0f);
    const float falloff = (1.0f - px * px) * (1.0f - py * py);
    return box.radiance * (covered * (box.rim + (1.0f - box.rim) * falloff));
}

// A dark room: cool ceiling, a faint horizon behind the model, neutral floor.
glm::vec3 room_radiance(const glm::vec3& d) {
    const float up = smooth_step(-0.16f, 0.14f, d.y);
    const glm::vec3 floor =
        glm::vec3(0.082f, 0.080f, 0.079f) * (0.35f + 0.65f * smooth_step(-0.95f, 0.0f, d.y));
    const float glow = std::exp(-7.0f * d.y * d.y) * (0.65f - 0.35f * d.z);
    const glm::vec3 wall =
        glm::vec3(0.045f, 0.049f, 0.056f) + glm::vec3(0.110f, 0.116f, 0.128f) * glow;
    return floor * (1.0f - up) + wall * up;
}

// The set. The default camera is at azimuth 30 degrees, right of +z. Key: large, high on the left,
// for the broad highlight. Strips: tall and narrow on both sides, for the streaks across brushed
// grain. Fill: wide and dim. Rims: behind, for the outline. Top: a long overhead bank.
const std::array<SoftBox, 7>& boxes() {
    static const std::array<SoftBox, 7> set = {{
        {{-0.62f, 0.62f, 0.75f}, 36.0f, 31.0f, 8.0f, 0.15f, 0.18f, {7.2f, 6.9f, 6.4f}, 0.55f},
        {{1.00f, 0.12f, 0.42f}, 7.0f, 80.0f, 4.0f, 0.6f, 0.35f, {11.0f, 10.8f, 10.4f}, 0.6f},
        {{-1.00f, 0.00f, -0.10f}, 5.0f, 70.0f, -3.0f, 0.6f, 0.35f, {5.4f, 5.7f, 6.2f}, 0.6f},
        {{0.55f, -0.12f, 1.00f}, 60.0f, 34.0f, 0.0f, 0.4f, 0.9f, {0.50f, 0.50f, 0.51f}, 0.3f},
        {{0.62f, 0.42f, -0.85f}, 13.0f, 40.0f, -14.0f, 0.3f, 0.25f, {6.8f, 7.2f, 7.9f}, 0.5f},
        {{-0.70f, 0.30f, -0.90f}, 18.0f, 18.0f, 10.0f, 0.3f, 0.4f, {3.0f, 2.8f, 2.5f}, 0.5f},
        {{0.12f, 1.00f, -0.22f}, 60.0f, 11.0f, 18.0f, 0.3f, 0.35f, {3.8f, 3.8f, 3.9f}, 0.6f},
    }};
    return set;
}

}  // namespace

glm::vec3 direction_of(double u, double v) {
    const double phi = 2.0 * std::numbers::pi * (u - 0.5), theta = std::numbers::pi * v;
    return glm::vec3(std::sin(theta) * std::sin(phi), std::cos(theta),
                     -std::sin(theta) * std::cos(phi));
}

Image render_studio(int width, int height, std::span<const SoftBox> set, bool room) {
    std::vector<PlacedBox> placed_boxes;
    const float texel = 2.0f * std::numbers::pi_v<float> / static_cast<float>(width);
    for (const SoftBox& box : set) placed_boxes.push_back(placed(box, texel));
    Image map(width, height, 3);
    parallel_for(static_cast<std::size_t>(height), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
            for (int x = 0; x < width; ++x) {
                const glm::vec3 direction =
                    direction_of((x + 0.5) / width, (static_cast<double>(y) + 0.5) / height);
                glm::vec3 sum = room ? room_radiance(direction) : glm::vec3(0.0f);
                for (const PlacedBox& box : placed_boxes) sum += radiance_of(box, direction);
                std::copy_n(&sum.x, 3, map.at(x, static_cast<int>(y)));
            }
        }
    });
    return map;
}

Environment make_studio() {
    // The boxes stand where no camera looks: only the room is seen, as smooth as 256 columns show it.
    return {"builtin:studio", render_studio(kWidth, kHeight, boxes(), true),
            render_studio(256, 128, {}, true)};
}

}  // namespace burnish
