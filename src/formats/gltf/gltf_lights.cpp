#include "formats/gltf/gltf_lights.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "burnish/error.hpp"
#include "core/constants.hpp"
#include "formats/model_limits.hpp"

namespace burnish {
namespace {

// Color times intensity must be a finite float. The sun is 1e5 lux, a lighthouse 1e7 candela.
constexpr double kBrightestLight = 1e12;
constexpr const char* kBrightness = "0 to 1e12";

// Unit vector along a column of a transform; `otherwise` for a column without length.
glm::vec3 axis(const glm::dmat4& matrix, int column, glm::vec3 otherwise) {
    const glm::dvec3 direction(matrix[column]);
    const double length = glm::length(direction);
    return length > 0.0 ? glm::vec3(direction / length) : otherwise;
}

void check(bool good, const std::string& key, const char* expected, double found,
           const GltfReport& report) {
    if (!good) report.fail(key, expected, fmt::format("{}", found));
}

LightType light_type(const std::string& name, const std::string& key, const GltfReport& report) {
    if (name == "directional") return LightType::directional;
    if (name == "point") return LightType::point;
    if (name == "spot") return LightType::spot;
    report.fail(key + ".type", "directional, point or spot", shown(name));
}

Light read_light(const tinygltf::Light& from, const std::string& key, const GltfReport& report) {
    Light light;
    light.type = light_type(from.type, key, report);
    for (std::size_t i = 0; i < from.color.size(); ++i) {
        check(from.color[i] >= 0.0 && from.color[i] <= kBrightestLight, key + ".color", kBrightness,
              from.color[i], report);
        light.color[static_cast<int>(i)] = static_cast<float>(from.color[i]);
    }
    check(from.intensity >= 0.0 && from.intensity <= kBrightestLight, key + ".intensity",
          kBrightness, from.intensity, report);
    light.intensity = static_cast<float>(from.intensity);
    check(from.range >= 0.0, key + ".range", "more than 0", from.range, report);
    light.range = static_cast<float>(from.range);
    if (light.type == LightType::spot) {
        const double outer = from.spot.outerConeAngle;
        const double inner = from.spot.innerConeAngle;
        // Rounded angles of 90 degrees may slightly exceed pi/2.
        check(outer > 0.0 && outer <= kHalfPi + 1e-4, key + ".spot.outerConeAngle",
              "more than 0, up to pi/2", outer, report);
        check(inner >= 0.0 && inner < outer, key + ".spot.innerConeAngle",
              "0 or more, below outerConeAngle", inner, report);
        light.inner_cone = static_cast<float>(inner);
        light.outer_cone = static_cast<float>(outer);
    }
    return light;
}

void read_projection(const tinygltf::Camera& from, const std::string& key, const GltfReport& report,
                     Camera& camera) {
    camera.orthographic = from.type == "orthographic";
    double near = from.perspective.znear;
    double far = from.perspective.zfar;
    if (camera.orthographic) {
        near = from.orthographic.znear;
        far = from.orthographic.zfar;
        // Some exporters encode mirroring in the sign.
        const double ymag = std::abs(from.orthographic.ymag);
        check(ymag > 0.0 && ymag <= kFarthest, key + ".orthographic.ymag",
              "a number up to 1e9 other than 0", ymag, report);
        camera.ymag = static_cast<float>(ymag);
        check(near >= 0.0, key + ".orthographic.znear", "0 or more", near, report);
        check(far > near, key + ".orthographic.zfar", "more than znear", far, report);
    } else {
        const double yfov = from.perspective.yfov;
        check(yfov > 0.0 && yfov < kPi, key + ".perspective.yfov", "more than 0, less than pi",
              yfov, report);
        camera.yfov = static_cast<float>(yfov);
        check(near > 0.0, key + ".perspective.znear", "more than 0", near, report);
        check(far == 0.0 || far > near, key + ".perspective.zfar", "more than znear", far, report);
    }
    // No geometry is farther away than kFarthest, but some files say 1e38.
    camera.near_plane = static_cast<float>(std::min(near, kFarthest));
    camera.far_plane = static_cast<float>(std::min(far, 4.0 * kFarthest));
}

}  // namespace

void add_gltf_lights(const tinygltf::Model& model, const std::vector<GltfPlacement>& placements,
                     const GltfReport& report, Scene& scene) {
    constexpr const char* kExtension = "KHR_lights_punctual";
    for (const GltfPlacement& placement : placements) {
        const auto& extensions = model.nodes[static_cast<std::size_t>(placement.node)].extensions;
        const auto it = extensions.find(kExtension);
        if (it == extensions.end()) continue;
        const int index = it->second.Get("light").GetNumberAsInt();
        const auto& from =
            item_at(model.lights, index, report,
                    fmt::format("nodes[{}].extensions.{}.light", placement.node, kExtension));
        Light light =
            read_light(from, fmt::format("extensions.{}.lights[{}]", kExtension, index), report);
        light.position = glm::vec3(placement.world[3]);
        light.direction = -axis(placement.world, 2, {0.0f, 0.0f, 1.0f});
        scene.lights.push_back(light);
    }
}

void add_gltf_cameras(const tinygltf::Model& model, const std::vector<GltfPlacement>& placements,
                      const GltfReport& report, Scene& scene) {
    const glm::vec3 center = bounds_of(scene).center();
    for (const GltfPlacement& placement : placements) {
        const int index = model.nodes[static_cast<std::size_t>(placement.node)].camera;
        if (index < 0) continue;
        const auto& from =
            item_at(model.cameras, index, report, fmt::format("nodes[{}].camera", placement.node));
        Camera camera;
        read_projection(from, fmt::format("cameras[{}]", index), report, camera);
        camera.position = glm::vec3(placement.world[3]);
        const glm::vec3 forward = -axis(placement.world, 2, {0.0f, 0.0f, 1.0f});
        // At least one meter for a camera inside the scene, so that it can orbit the target.
        const float distance = std::max(glm::distance(camera.position, center), 1.0f);
        camera.target = camera.position + distance * forward;
        camera.up = axis(placement.world, 1, {0.0f, 1.0f, 0.0f});
        scene.cameras.push_back(camera);
    }
}

}  // namespace burnish
