#include "formats/gltf/gltf_nodes.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "burnish/error.hpp"
#include "formats/model_limits.hpp"

namespace burnish {
namespace {

glm::dmat4 local_transform(const tinygltf::Node& node, const std::string& key,
                           const GltfReport& report) {
    glm::dmat4 matrix(1.0);
    if (!node.matrix.empty()) {
        for (int i = 0; i < 16; ++i)
            matrix[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        return matrix;
    }
    if (!node.translation.empty()) {
        const auto& t = node.translation;
        matrix = glm::translate(matrix, glm::dvec3(t[0], t[1], t[2]));
    }
    if (!node.rotation.empty()) {
        const auto& r = node.rotation;
        const glm::dquat rotation(r[3], r[0], r[1], r[2]);
        const double length = glm::length(rotation);
        // Exporters round to about five digits; a length 0.1 away from 1 is not a rounded rotation.
        if (!(std::abs(length - 1.0) < 0.1))
            report.fail(key + ".rotation", "a unit quaternion", fmt::format("length {}", length));
        matrix *= glm::mat4_cast(rotation / length);
    }
    if (!node.scale.empty()) {
        const auto& s = node.scale;
        matrix = glm::scale(matrix, glm::dvec3(s[0], s[1], s[2]));
    }
    return matrix;
}

std::vector<int> root_nodes(const tinygltf::Model& model, const GltfReport& report) {
    if (model.defaultScene >= 0)
        return item_at(model.scenes, model.defaultScene, report, "scene").nodes;
    if (!model.scenes.empty()) return model.scenes.front().nodes;
    std::vector<char> is_child(model.nodes.size(), 0);
    for (const tinygltf::Node& node : model.nodes) {
        for (const int child : node.children) {
            item_at(model.nodes, child, report, "nodes.children");
            is_child[static_cast<std::size_t>(child)] = 1;
        }
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i)
        if (!is_child[i]) roots.push_back(static_cast<int>(i));
    return roots;
}

}  // namespace

bool in_reach(const glm::dmat4& matrix) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!(std::abs(matrix[c][r]) <= kFarthest)) return false;
    return true;
}

std::vector<GltfPlacement> walk_gltf_nodes(const tinygltf::Model& model, const GltfReport& report) {
    struct Pending {
        int node;
        glm::dmat4 parent;
    };
    // An explicit stack: nodes may be nested a hundred thousand deep.
    std::vector<Pending> pending;
    const std::vector<int> roots = root_nodes(model, report);
    for (auto root = roots.rbegin(); root != roots.rend(); ++root)
        pending.push_back({*root, glm::dmat4(1.0)});

    std::vector<char> seen(model.nodes.size(), 0);
    std::vector<GltfPlacement> placements;
    while (!pending.empty()) {
        const Pending next = pending.back();
        pending.pop_back();
        const std::string key = fmt::format("nodes[{}]", next.node);
        const auto& node = item_at(model.nodes, next.node, report, key);
        char& visited = seen[static_cast<std::size_t>(next.node)];
        if (visited) report.fail(key, "one parent", "two parents or a cycle");
        visited = 1;
        const glm::dmat4 world = next.parent * local_transform(node, key, report);
        if (!in_reach(world)) {
            report.fail(key, fmt::format("a transform with numbers up to {:g}", kFarthest),
                        "larger ones");
        }
        placements.push_back({next.node, world});
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
            pending.push_back({*child, world});
    }
    return placements;
}

}  // namespace burnish
