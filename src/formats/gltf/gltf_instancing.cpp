#include "formats/gltf/gltf_instancing.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "burnish/error.hpp"
#include "formats/model_limits.hpp"

namespace burnish {
namespace {

class InstanceReader {
  public:
    InstanceReader(const tinygltf::Value& attributes, std::string key, GltfAccessors& accessors,
                   GltfReport& report)
        : attributes_(attributes), key_(std::move(key)), accessors_(accessors), report_(report) {}

    std::vector<glm::dmat4> read() {
        check_counts();
        std::vector<glm::dmat4> transforms(count_, glm::dmat4(1.0));
        if (const int i = accessor("TRANSLATION"); i >= 0) {
            const auto items = accessors_.vec3s(i, 0, count_, user("TRANSLATION"));
            for (std::size_t k = 0; k < count_; ++k)
                transforms[k] = glm::translate(transforms[k], glm::dvec3(items[k]));
        }
        if (const int i = accessor("ROTATION"); i >= 0) {
            const auto items = accessors_.vec4s(i, 0, count_, user("ROTATION"));
            for (std::size_t k = 0; k < count_; ++k) transforms[k] *= rotation(items[k]);
        }
        if (const int i = accessor("SCALE"); i >= 0) {
            const auto items = accessors_.vec3s(i, 0, count_, user("SCALE"));
            for (std::size_t k = 0; k < count_; ++k)
                transforms[k] = glm::scale(transforms[k], glm::dvec3(items[k]));
        }
        return transforms;
    }

  private:
    std::string user(const std::string& name) const { return fmt::format("{}.{}", key_, name); }
    int accessor(const char* name) const {
        return attributes_.Has(name) ? attributes_.Get(name).GetNumberAsInt() : -1;
    }

    void check_counts() {
        std::string of;
        for (const std::string& name : attributes_.Keys()) {
            const std::size_t found =
                accessors_.element_count(attributes_.Get(name).GetNumberAsInt(), user(name));
            if (!of.empty() && found != count_)
                report_.fail(user(name), fmt::format("{} elements, as {} has", count_, of),
                             fmt::format("{}", found));
            of = name;
            count_ = found;
            if (name == "TRANSLATION" || name == "ROTATION" || name == "SCALE") continue;
            report_.warn(
                fmt::format("{}: not read: instances differ by TRANSLATION, ROTATION and "
                            "SCALE alone",
                            user(shown(name))));
        }
        if (count_ > kMostInstances)
            report_.fail(key_, fmt::format("at most {} instances", kMostInstances),
                         fmt::format("{}", count_));
        report_.pay(count_ * sizeof(glm::dmat4), key_);
    }

    // Integers that are not marked as normalized have the same direction.
    glm::dmat4 rotation(glm::vec4 item) const {
        const glm::dquat q(item.w, item.x, item.y, item.z);
        const double length = glm::length(q);
        if (!(length > 0.0) || !std::isfinite(length))
            report_.fail(user("ROTATION"), "unit quaternions", fmt::format("length {}", length));
        return glm::mat4_cast(q / length);
    }

    const tinygltf::Value& attributes_;
    std::string key_;
    GltfAccessors& accessors_;
    GltfReport& report_;
    std::size_t count_ = 0;
};

}  // namespace

std::optional<std::vector<glm::dmat4>> read_gltf_instances(const tinygltf::Node& node,
                                                           const std::string& key,
                                                           GltfAccessors& accessors,
                                                           GltfReport& report) {
    const auto it = node.extensions.find("EXT_mesh_gpu_instancing");
    if (it == node.extensions.end()) return std::nullopt;
    const tinygltf::Value& attributes = it->second.Get("attributes");
    if (attributes.Size() == 0) return std::nullopt;
    return InstanceReader(attributes, key + ".extensions.EXT_mesh_gpu_instancing.attributes",
                          accessors, report)
        .read();
}

}  // namespace burnish
