// Rays against the projection of the renderer; picking against every triangle one by one.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <random>

#include "burnish/load_model.hpp"
#include "scene/camera/view.hpp"
#include "viewer/motion/orbit.hpp"
#include "viewer/viewer_scenes.hpp"

namespace burnish::viewer {
namespace {

constexpr WindowSize kWindow = {320, 200};

Camera camera_at(glm::vec3 position, bool orthographic) {
    Camera camera;
    camera.position = position;
    camera.target = {0.1f, 0.0f, -0.2f};
    camera.yfov = 0.8f;
    camera.ymag = 1.4f;
    camera.orthographic = orthographic;
    return camera;
}

// Where the renderer's matrices put a point, in pixels from the upper left corner.
glm::dvec2 drawn_at(const Camera& camera, glm::dvec3 point) {
    const Bounds bounds{glm::vec3(-1), glm::vec3(1)};
    const View view = make_view(camera, bounds, kWindow.width, kWindow.height,
                                {0, 0, kWindow.width, kWindow.height}, {0, 0});
    const glm::dvec4 clip = glm::dmat4(view.clip_from_world) * glm::dvec4(point, 1.0);
    return {(0.5 + 0.5 * clip.x / clip.w) * kWindow.width,
            (0.5 - 0.5 * clip.y / clip.w) * kWindow.height};
}

TEST(Ray, IsTheInverseOfTheRenderersProjection) {
    for (const bool orthographic : {false, true}) {
        for (const glm::vec3 position : {glm::vec3(0, 0.5f, 3), glm::vec3(-2, 1, -1.5f)}) {
            const Camera camera = camera_at(position, orthographic);
            for (const glm::dvec2 pixel : {glm::dvec2(0.5, 0.5), glm::dvec2(160, 100),
                                           glm::dvec2(301.25, 20), glm::dvec2(7, 199.5)}) {
                const Ray ray = ray_of(camera, pixel, kWindow);
                EXPECT_NEAR(glm::length(ray.direction), 1, 1e-14);
                for (const double t : {1.0, 2.0, 4.0}) {
                    // The matrix is in single precision: 2^-24 of 320 pixels, times a few terms.
                    EXPECT_LT(glm::distance(drawn_at(camera, ray.at(t)), pixel), 5e-4);
                    EXPECT_LT(glm::distance(*pixel_of(camera, ray.at(t), kWindow), pixel), 1e-9);
                }
            }
        }
    }
}

TEST(Ray, StartsAndEndsAtTheStatedPlanes) {
    Camera camera = camera_at({0, 0, 3}, false);
    camera.near_plane = 0.5f;
    camera.far_plane = 7.0f;
    const Ray ray = ray_of(camera, {10, 30}, kWindow);
    EXPECT_NEAR(depth_of(camera, ray.at(ray.from)), 0.5, 1e-7);
    EXPECT_NEAR(depth_of(camera, ray.at(ray.to)), 7.0, 1e-6);
    EXPECT_FALSE(pixel_of(camera, {0, 0, 9}, kWindow).has_value());
}

Scene two_spheres() {
    Scene scene = test::one_object(test::uv_sphere(24, 13), Material{});
    scene.materials.emplace_back();
    scene.materials[1].double_sided = true;
    Instance other;
    other.material = 1;
    other.transform = glm::translate(glm::mat4(1.0f), {0.4f, 0.3f, -0.7f});
    // Mirrored, turned and of three scales.
    other.transform = glm::rotate(other.transform, 0.7f, {1.0f, 2.0f, 0.5f});
    other.transform[0] *= -0.8f;
    other.transform[1] *= 1.3f;
    scene.instances.push_back(other);
    scene.instances.push_back({-1, 0, glm::mat4(1.0f)});  // erased
    return scene;
}

// The nearest front (or any) crossing of a ray with all triangles, by solving the 3 x 3 system of each.
struct Crossing {
    double t = std::numeric_limits<double>::infinity();
    int instance = -1;
    std::uint32_t triangle = 0;
    glm::dvec3 barycentric{0.0};
};

Crossing brute_force(const Scene& scene, const Ray& ray) {
    Crossing nearest;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        if (instance.mesh < 0) continue;
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const glm::dmat4 m(instance.transform);
        const bool mirrored = glm::determinant(glm::dmat3(m)) < 0;
        for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
            glm::dvec3 p[3];
            for (std::size_t c = 0; c < 3; ++c)
                p[c] = glm::dvec3(m * glm::dvec4(mesh.positions[mesh.indices[k + c]], 1.0));
            // origin + t d = p0 + u (p1 - p0) + v (p2 - p0)
            const glm::dmat3 system(-ray.direction, p[1] - p[0], p[2] - p[0]);
            if (glm::determinant(system) == 0) continue;
            const glm::dvec3 tuv = glm::inverse(system) * (ray.origin - p[0]);
            if (tuv.y < 0 || tuv.z < 0 || tuv.y + tuv.z > 1 || tuv.x < ray.from) continue;
            glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
            if (mirrored) normal = -normal;
            const bool front = glm::dot(normal, ray.direction) < 0;
            const auto material = static_cast<std::size_t>(instance.material);
            if (!front && !scene.materials[material].double_sided) continue;
            if (tuv.x < nearest.t)
                nearest = {tuv.x,
                           static_cast<int>(i),
                           static_cast<std::uint32_t>(k / 3),
                           {1 - tuv.y - tuv.z, tuv.y, tuv.z}};
        }
    }
    return nearest;
}

TEST(Picker, FindsTheNearestTriangleOfEveryRay) {
    const Scene scene = two_spheres();
    const Picker picker(scene);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(0, kWindow.width), y(0, kWindow.height);
    int hits = 0, doubled = 0;
    for (const bool orthographic : {false, true}) {
        // From outside, from inside of a sphere, from beyond.
        for (const glm::vec3 position :
             {glm::vec3(0, 0.5f, 3), glm::vec3(0.4f, 0.3f, -0.7f), glm::vec3(3, -2, -4)}) {
            const Camera camera = camera_at(position, orthographic);
            for (int i = 0; i < 400; ++i) {
                const Ray ray = ray_of(camera, {x(random), y(random)}, kWindow);
                const Crossing wanted = brute_force(scene, ray);
                const auto hit = picker.pick(scene, ray);
                ASSERT_EQ(hit.has_value(), wanted.instance >= 0) << i;
                if (!hit) continue;
                ++hits;
                doubled += hit->front ? 0 : 1;
                ASSERT_EQ(hit->instance, wanted.instance);
                ASSERT_EQ(hit->triangle, wanted.triangle);
                ASSERT_NEAR(hit->distance, wanted.t, 1e-9);
                ASSERT_LT(glm::distance(hit->barycentric, wanted.barycentric), 1e-7);
                ASSERT_LT(glm::distance(hit->position, ray.at(wanted.t)), 1e-9);
                ASSERT_EQ(glm::dot(hit->geometric_normal, ray.direction) < 0, hit->front);
            }
        }
    }
    EXPECT_GT(hits, 400);
    EXPECT_GT(doubled, 20);  // backs of the double-sided sphere
}

// A sphere of the positions, normals and tangents themselves: attributes are those of its surface.
TEST(Picker, InterpolatesTheAttributes) {
    Scene scene = test::one_object(test::uv_sphere(200, 100), Material{});
    const Picker picker(scene);
    const Camera camera = camera_at({2.0f, 1.5f, 2.5f}, false);
    for (const glm::dvec2 pixel :
         {glm::dvec2(160, 100), glm::dvec2(130, 90), glm::dvec2(185, 120)}) {
        const auto hit = pick(scene, picker, camera, pixel, kWindow);
        ASSERT_TRUE(hit.has_value());
        const glm::dvec3 radial = glm::normalize(hit->position);
        // A chord of 2 pi/200 bulges by 1e-4 of the radius; normals deviate in its second order too.
        EXPECT_LT(glm::distance(glm::dvec3(hit->normal), radial), 2e-4);
        EXPECT_LT(glm::distance(hit->geometric_normal, radial), 0.03);
        const glm::dvec3 east = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), radial));
        EXPECT_GT(glm::dot(glm::normalize(glm::dvec3(glm::vec3(hit->tangent))), east), 0.9999);
        EXPECT_EQ(hit->tangent.w, 1.0f);
        const double phi = std::atan2(radial.x, radial.z), theta = std::acos(radial.y);
        EXPECT_NEAR(hit->uv0.x, phi < 0 ? phi / 6.2831853 + 1 : phi / 6.2831853, 1e-4);
        EXPECT_NEAR(hit->uv0.y, 1 - theta / 3.14159265, 1e-4);
    }
    scene.instances[0].transform[0] *= -1.0f;
    const auto mirrored = pick(scene, Picker(scene), camera, {160, 100}, kWindow);
    ASSERT_TRUE(mirrored.has_value());
    EXPECT_TRUE(mirrored->front);
    EXPECT_EQ(mirrored->tangent.w, -1.0f);
    EXPECT_GT(glm::dot(glm::dvec3(mirrored->normal), mirrored->position), 0.999);
    EXPECT_GT(glm::dot(mirrored->geometric_normal, mirrored->position), 0.99);
}

TEST(Picker, FollowsInstancesThatMove) {
    Scene scene = two_spheres();
    Picker picker(scene);
    scene.instances[0].transform = glm::translate(glm::mat4(1.0f), {5.0f, 0.0f, 0.0f});
    scene.instances[1].mesh = -1;
    picker.update(scene);
    Ray ray;
    ray.origin = {5, 0, 10};
    ray.to = 100;
    ASSERT_TRUE(picker.pick(scene, ray).has_value());
    EXPECT_NEAR(picker.pick(scene, ray)->distance, 9, 0.05);
    ray.origin = {0.1, 0.1, 10};
    EXPECT_FALSE(picker.pick(scene, ray).has_value());
    EXPECT_FALSE(Picker(Scene{}).pick(Scene{}, ray).has_value());
    // A mesh that is changed in place, and one that only its instance moves.
    for (glm::vec3& p : scene.meshes[0].positions) p *= 0.5f;
    picker.update(scene);
    ray.origin = {5, 0, 10};
    EXPECT_NEAR(picker.pick(scene, ray)->distance, 9.5, 0.05);
    scene.instances[0].transform = glm::mat4(1.0f);
    picker.update_instances(scene);
    EXPECT_FALSE(picker.pick(scene, ray).has_value());
    ray.origin = {0, 0, 10};
    EXPECT_NEAR(picker.pick(scene, ray)->distance, 9.5, 0.05);
}

// Corners at infinity, triangles without area and many triangles in one place must neither hang nor
// crash.
TEST(Picker, TakesBadTriangles) {
    Mesh mesh = test::unit_plane();
    for (auto& tangent : mesh.tangents) tangent = glm::vec4(0.0f);
    const float infinity = std::numeric_limits<float>::infinity();
    mesh.positions.insert(mesh.positions.end(),
                          {{infinity, 0, 0}, {std::nanf(""), 0, 0}, {0, 0, 1}});
    mesh.normals.insert(mesh.normals.end(), 3, glm::vec3(0, 0, 1));
    mesh.tangents.insert(mesh.tangents.end(), 3, glm::vec4(0));
    mesh.texcoord0.insert(mesh.texcoord0.end(), 3, glm::vec2(0));
    for (int i = 0; i < 5000; ++i) mesh.indices.insert(mesh.indices.end(), {0, 4, 5, 6, 6, 6});
    for (int i = 0; i < 5000; ++i) mesh.indices.insert(mesh.indices.end(), {0, 1, 3});
    Scene scene = test::one_object(mesh, Material{});
    const Hit hit = test::hit_at(scene, 0.25, -0.5);
    EXPECT_NEAR(hit.distance, 10, 1e-12);
    EXPECT_TRUE(std::isfinite(hit.tangent.x));
    scene.instances[0].transform[2] = glm::vec4(0.0f);  // scaled to a plane: not picked
    EXPECT_FALSE(Picker(scene).pick(scene, Ray{{0, 0, 10}, {0, 0, -1}, 0, 100}).has_value());
}

// 300 rays through the corners and edges of a grid: none may pass between two triangles.
TEST(Picker, SharedEdgesHaveNoCracks) {
    const Scene scene = test::one_object(test::uv_sphere(16, 8), Material{});
    const Picker picker(scene);
    const Mesh& mesh = scene.meshes[0];
    const glm::dvec3 eye(0.3, 0.4, 5);
    for (std::size_t k = 0; k < mesh.indices.size(); ++k) {
        const glm::dvec3 a(mesh.positions[mesh.indices[k]]);
        const glm::dvec3 b(mesh.positions[mesh.indices[k / 3 * 3 + (k + 1) % 3]]);
        for (const double share : {0.0, 0.5, 0.3}) {
            const glm::dvec3 at = a + share * (b - a);
            // Inside of the silhouette, which is an edge without a neighbor.
            if (glm::dot(glm::normalize(at), glm::normalize(eye - at)) < 0.3) continue;
            Ray ray;
            ray.origin = eye;
            ray.direction = glm::normalize(at - eye);
            ray.to = 100;
            ASSERT_TRUE(picker.pick(scene, ray).has_value()) << k << " " << share;
            ASSERT_NEAR(picker.pick(scene, ray)->distance, glm::distance(at, eye), 1e-9);
        }
    }
}

}  // namespace
}  // namespace burnish::viewer
