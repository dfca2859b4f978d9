// What is common to all kinds of models.
#include "burnish/scene.hpp"

#include <glm/common.hpp>

namespace burnish {
namespace {

// Transforms the box's eight corners: a bound, not the tightest.
void include_box(const Bounds& box, const glm::mat4& transform, Bounds& bounds, bool& empty) {
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 local((corner & 1) ? box.high.x : box.low.x,
                              (corner & 2) ? box.high.y : box.low.y,
                              (corner & 4) ? box.high.z : box.low.z);
        const glm::vec3 world(transform * glm::vec4(local, 1.0f));
        bounds.low = empty ? world : glm::min(bounds.low, world);
        bounds.high = empty ? world : glm::max(bounds.high, world);
        empty = false;
    }
}

}  // namespace

Method drawn_method(const Material& m) {
    const bool isotropic = !m.anisotropy_texture && !m.tabulated &&
                           (m.alpha ? m.alpha->x == m.alpha->y : m.anisotropy_strength == 0.0f);
    return m.method == Method::normal_map && isotropic ? Method::gram_schmidt : m.method;
}

Bounds bounds_of(const Scene& scene) {
    std::vector<Bounds> boxes;
    boxes.reserve(scene.meshes.size());
    for (const Mesh& mesh : scene.meshes) boxes.push_back(bounds_of(mesh));
    Bounds bounds;
    bool empty = true;
    for (const Instance& instance : scene.instances) {
        const auto mesh = static_cast<std::size_t>(instance.mesh);
        if (!scene.meshes[mesh].positions.empty())
            include_box(boxes[mesh], instance.transform, bounds, empty);
    }
    return bounds;
}

}  // namespace burnish
