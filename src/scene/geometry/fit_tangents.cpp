#include "burnish/fit_tangents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "burnish/error.hpp"
#include "core/parallel.hpp"
#include "scene/geometry/tangents.hpp"
#include "scene/material/texture_uses.hpp"

namespace burnish {
namespace {

// The direction (u, v) in which u' of (u', v') = linear (u, v) grows while v' stays.
TangentSource source_of(const TextureUse& use) {
    TangentSource source;
    source.texcoord = use.texcoord;
    const glm::dvec2 u(use.transform[0]), v(use.transform[1]);
    const double determinant = u.x * v.y - u.y * v.x;
    // A transform without area reads one line of the picture: no frame belongs to it.
    if (!(std::abs(determinant) > 0.0)) return source;
    source.mirrored = determinant < 0.0;
    glm::dvec2 along = glm::normalize(glm::dvec2(v.y, -u.y) * (determinant < 0.0 ? -1.0 : 1.0));
    // cos(pi/2) in floats is 4e-8: a quarter turn is one exactly.
    for (int i = 0; i < 2; ++i)
        if (std::abs(along[i]) < 1e-7) along[i] = 0.0;
    source.along = glm::vec2(glm::normalize(along));
    return source;
}

// Cloth is woven along the coordinates of its own textures where all of them share some.
TangentSource cloth_source(const Material& m) {
    const TextureUse* first = nullptr;
    for (const TextureUse* use : texture_uses(m)) {
        if (!cloth_reads(m, *use)) continue;
        if (first == nullptr) first = use;
        if (use->texcoord != first->texcoord || use->transform != first->transform) return {};
    }
    return first == nullptr ? TangentSource{} : source_of(*first);
}

// Counter-clockwise from u in the picture, whose v runs down.
float angle_of(const TangentSource& source) {
    return std::atan2(-source.along.y, source.along.x);
}

// How directions of the anisotropy texture turn into the frame of the normal texture.
struct Turn {
    float angle = 0.0f;             // radians
    const char* inexact = nullptr;  // why it is an approximation, and what is right
};

Turn turn_of(const Material& m) {
    Turn turn;
    if (!m.anisotropy_texture || !m.normal_texture || cloth_of(m) || tabulated_of(m)) return turn;
    const TangentSource from = source_of(m.anisotropy_texture), to = source_of(m.normal_texture);
    if (from == to) return turn;
    if (from.texcoord != to.texcoord) {
        turn.inexact =
            "has other texture coordinates than the normal map: its directions are drawn in the "
            "normal map's frame";
        return turn;
    }
    const float difference = angle_of(from) - angle_of(to);
    turn.angle =
        std::remainder(to.mirrored ? -difference : difference, 2.0f * std::numbers::pi_v<float>);
    const float quarters = turn.angle / (0.5f * std::numbers::pi_v<float>);
    // 1e-5 of a quarter turn: rotations of five digits, as files state them.
    if (std::abs(quarters - std::round(quarters)) > 1e-5f)
        turn.inexact =
            "is turned against the normal map, not by quarter turns: its directions are right "
            "where "
            "u and v are equally long on the surface";
    if (from.mirrored != to.mirrored)
        turn.inexact =
            "is mirrored against the normal map: of its directions that along u alone is right";
    return turn;
}

// The set that the mesh has: materials whose textures lie in a set that it lacks draw none of them.
TangentSource available(TangentSource source, const Mesh& mesh) {
    return source.texcoord == 1 && mesh.texcoord1.empty() ? TangentSource{} : source;
}

struct Making {
    std::size_t mesh;
    TangentSource source;
};

// Gives every instance a mesh whose tangents will be of the right source; returns what to make.
std::vector<Making> plan(Scene& scene) {
    std::vector<std::vector<std::pair<TangentSource, int>>> meshes_of(scene.meshes.size());
    std::vector<Making> makings;
    const auto wanted_of = [&](const Instance& instance) {
        const Material& material = scene.materials[static_cast<std::size_t>(instance.material)];
        return available(tangent_source_of(material),
                         scene.meshes[static_cast<std::size_t>(instance.mesh)]);
    };
    const auto remade = [&](const Instance& instance) {
        return instance.mesh >= 0 &&
               scene.meshes[static_cast<std::size_t>(instance.mesh)].tangent_source;
    };
    // Meshes that are right for one of their instances stay as they are.
    for (const Instance& instance : scene.instances) {
        if (!remade(instance)) continue;
        const auto index = static_cast<std::size_t>(instance.mesh);
        const Mesh& mesh = scene.meshes[index];
        const TangentSource wanted = wanted_of(instance);
        if (meshes_of[index].empty() && wanted == *mesh.tangent_source) {
            meshes_of[index].emplace_back(wanted, instance.mesh);
            if (mesh.tangents.empty()) makings.push_back({index, wanted});
        }
    }
    for (Instance& instance : scene.instances) {
        if (!remade(instance)) continue;
        const auto index = static_cast<std::size_t>(instance.mesh);
        const TangentSource wanted = wanted_of(instance);
        auto& known = meshes_of[index];
        auto found = std::find_if(known.begin(), known.end(),
                                  [&](const auto& one) { return one.first == wanted; });
        if (found == known.end()) {
            int made = instance.mesh;
            if (!known.empty()) {
                made = static_cast<int>(scene.meshes.size());
                scene.meshes.push_back(Mesh(scene.meshes[index]));
            }
            makings.push_back({static_cast<std::size_t>(made), wanted});
            found = known.insert(known.end(), {wanted, made});
        }
        instance.mesh = found->second;
    }
    return makings;
}

}  // namespace

TangentSource tangent_source_of(const Material& m) {
    if (cloth_of(m)) return cloth_source(m);
    if (m.normal_texture || tabulated_of(m)) return source_of(m.normal_texture);
    if (m.anisotropy_texture) return source_of(m.anisotropy_texture);
    if (m.coat.normal_texture) return source_of(m.coat.normal_texture);
    return {};
}

std::vector<std::string> fit_tangents(Scene& scene) {
    std::vector<std::string> warnings;
    std::vector<char> stored(scene.materials.size(), 0);
    for (const Instance& instance : scene.instances) {
        if (instance.mesh < 0) continue;
        const bool own = !scene.meshes[static_cast<std::size_t>(instance.mesh)].tangent_source;
        if (own) stored[static_cast<std::size_t>(instance.material)] = 1;
    }
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        Material& material = scene.materials[i];
        // Stored tangents are one frame for all textures.
        const Turn turn = stored[i] ? Turn{} : turn_of(material);
        material.anisotropy_texture_turn = turn.angle;
        if (turn.inexact != nullptr)
            warnings.push_back(fmt::format(
                "{}: the anisotropy texture {}; store tangents, or read both textures alike",
                one_line(material.name), turn.inexact));
    }
    const std::vector<Making> makings = plan(scene);
    parallel_for(makings.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            make_tangents(scene.meshes[makings[i].mesh], makings[i].source);
    });
    return warnings;
}

}  // namespace burnish
