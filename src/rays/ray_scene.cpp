#include "rays/ray_scene.hpp"

#include <embree3/rtcore.h>

#include <cstring>
#include <limits>
#include <string>

#include "burnish/error.hpp"

namespace burnish {
namespace {

constexpr float kNoEnd = std::numeric_limits<float>::infinity();
// Triangles above which the tree is stored compactly, at about half the memory and speed.
constexpr std::size_t kManyTriangles = 1'000'000;

template <typename EmbreeRay>
void set_ray(EmbreeRay& to, const Ray& ray) {
    to.org_x = ray.origin.x;
    to.org_y = ray.origin.y;
    to.org_z = ray.origin.z;
    to.dir_x = ray.direction.x;
    to.dir_y = ray.direction.y;
    to.dir_z = ray.direction.z;
    to.tnear = ray.nearest;
    to.tfar = ray.farthest > 0.0f ? ray.farthest : kNoEnd;
    to.mask = ~0U;
    to.flags = 0;
    to.time = 0.0f;
}

}  // namespace

struct RayScene::Tree {
    Tree() : device(rtcNewDevice(nullptr)) {
        if (device == nullptr)
            throw Error("rays", "Embree", "a device",
                        "error " + std::to_string(static_cast<int>(rtcGetDeviceError(nullptr))));
        scene = rtcNewScene(device);
    }
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;
    ~Tree() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }

    void add(const WorldMesh& mesh, unsigned id) const {
        RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
        const auto fill = [&](RTCBufferType type, RTCFormat format, const auto& values,
                              std::size_t size, std::size_t count) {
            void* to = rtcSetNewGeometryBuffer(geometry, type, 0, format, size, count);
            if (to != nullptr) std::memcpy(to, values.data(), size * count);
        };
        fill(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions, sizeof(glm::vec3),
             mesh.positions.size());
        fill(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.indices, 3 * sizeof(std::uint32_t),
             mesh.indices.size() / 3);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene, geometry, id);
        rtcReleaseGeometry(geometry);
    }

    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
};

RayScene::RayScene(std::span<const WorldMesh> meshes) {
    auto tree = std::make_shared<Tree>();
    std::size_t triangles = 0;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        if (!meshes[i].blocks) continue;
        tree->add(meshes[i], static_cast<unsigned>(i));
        triangles += meshes[i].indices.size() / 3;
    }
    // Robust: no ray passes between two triangles that share an edge.
    unsigned flags = RTC_SCENE_FLAG_ROBUST;
    if (triangles > kManyTriangles) flags |= RTC_SCENE_FLAG_COMPACT;
    rtcSetSceneFlags(tree->scene, static_cast<RTCSceneFlags>(flags));
    rtcCommitScene(tree->scene);
    if (const RTCError error = rtcGetDeviceError(tree->device); error != RTC_ERROR_NONE)
        throw Error("rays", "Embree", "a tree over " + std::to_string(triangles) + " triangles",
                    error == RTC_ERROR_OUT_OF_MEMORY ? "no memory for it"
                                                     : "error " + std::to_string(error));
    tree_ = std::move(tree);
}

bool RayScene::is_blocked(const Ray& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay query{};
    set_ray(query, ray);
    rtcOccluded1(tree_->scene, &context, &query);
    return query.tfar < 0.0f;  // Embree's mark of a hit
}

std::optional<RayHit> RayScene::nearest(const Ray& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{};
    set_ray(query.ray, ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(tree_->scene, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    RayHit hit;
    hit.distance = query.ray.tfar;
    hit.mesh = query.hit.geomID;
    hit.triangle = query.hit.primID;
    hit.u = query.hit.u;
    hit.v = query.hit.v;
    hit.normal = {query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z};
    return hit;
}

}  // namespace burnish
