// Tangents after Morten S. Mikkelsen, "Simulation of Wrinkled Surfaces Revisited" (2008), section
// 3.2, and the description of MikkTSpace at http://www.mikktspace.com.
#include "scene/geometry/tangents.hpp"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <glm/geometric.hpp>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "core/parallel.hpp"
#include "scene/geometry/weld.hpp"

namespace burnish {
namespace {

constexpr std::int32_t kNone = -1;
constexpr std::size_t kGrain = 32768;  // triangles or vertices per task: about a millisecond

// The direction of increasing u on one triangle.
struct Slope {
    glm::vec3 along_u{0.0f};  // unit
    bool preserving = false;  // u, v (upwards) and the normal are right-handed
    bool joins_any = true;    // degenerate coordinates: takes the orientation of the first group
    bool degenerate = false;  // two corners coincide: not part of the surface
};

// A corner is 3 triangle + {0, 1, 2}; edge i of a triangle goes from its corner i to the next.
constexpr std::size_t next_corner(std::size_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}
constexpr std::size_t previous_corner(std::size_t corner) {
    return corner % 3 == 0 ? corner + 2 : corner - 1;
}

class TangentMaker {
  public:
    // `coordinates`: one for each vertex.
    TangentMaker(Mesh& mesh, std::vector<glm::vec2> coordinates)
        : mesh_(mesh), coordinates_(std::move(coordinates)), triangles_(mesh.indices.size() / 3) {}
    void run();

  private:
    void weld_vertices();
    void find_slopes();
    Slope slope_of(std::size_t triangle) const;
    void list_corners();
    void find_neighbors();
    void pair_edges_of(std::uint32_t vertex);
    void form_groups();
    void spread_group(std::size_t corner, std::int32_t group);
    void join(std::size_t triangle, std::uint32_t vertex, std::int32_t group);
    void sum_groups();
    glm::vec3 contribution(std::size_t corner) const;
    void share_groups();
    void write_tangents();
    std::uint32_t split_vertex(std::uint32_t vertex);
    glm::vec4 tangent_of(std::uint32_t vertex, std::int32_t group) const;

    std::uint32_t vertex(std::size_t corner) const { return weld_.ids[mesh_.indices[corner]]; }
    glm::vec3 position(std::size_t corner) const { return mesh_.positions[mesh_.indices[corner]]; }

    struct Edge {
        std::uint32_t other;   // the end that is not the vertex in question
        std::uint32_t corner;  // where the edge starts
        bool outgoing;
    };

    Mesh& mesh_;
    std::vector<glm::vec2> coordinates_;
    std::size_t triangles_;
    Welding weld_;                        // vertex of the mesh -> welded vertex
    std::vector<Slope> slopes_;           // one per triangle
    std::vector<std::uint32_t> first_;    // start of each welded vertex in corners_
    std::vector<std::uint32_t> corners_;  // by welded vertex, without those of degenerate triangles
    std::vector<std::int32_t> neighbors_;  // triangle across each edge
    std::vector<std::int32_t> groups_;     // group of each corner
    std::vector<char> group_preserving_;
    std::vector<glm::vec3> group_tangents_;  // zero: no direction
    std::vector<std::size_t> pending_;       // corners still to visit of the growing group
};

void TangentMaker::run() {
    weld_vertices();
    find_slopes();
    list_corners();
    find_neighbors();
    form_groups();
    sum_groups();
    share_groups();
    write_tangents();
}

void TangentMaker::weld_vertices() {
    weld_ = weld<8>(mesh_.positions.size(), [this](std::size_t i, std::uint32_t* words) {
        const glm::vec3 p = mesh_.positions[i];
        const glm::vec3 n = mesh_.normals[i];
        const glm::vec2 uv = coordinates_[i];
        const float values[] = {p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y};
        for (std::size_t k = 0; k < 8; ++k) words[k] = weld_bits(values[k]);
    });
}

Slope TangentMaker::slope_of(std::size_t triangle) const {
    const std::size_t corner = 3 * triangle;
    const auto uv = [&](std::size_t i) { return coordinates_[mesh_.indices[corner + i]]; };
    const glm::vec3 p0 = position(corner);
    const glm::vec3 p1 = position(corner + 1);
    const glm::vec3 p2 = position(corner + 2);
    Slope slope;
    slope.degenerate = p0 == p1 || p1 == p2 || p2 == p0;

    // Solve the two edges for the direction of u; v runs upwards here.
    const float du1 = uv(1).x - uv(0).x;
    const float du2 = uv(2).x - uv(0).x;
    const float dv1 = uv(0).y - uv(1).y;
    const float dv2 = uv(0).y - uv(2).y;
    const float area = du1 * dv2 - dv1 * du2;
    slope.preserving = area > 0.0f;
    // Smaller areas are denormal: quotients by them are meaningless.
    if (!(std::abs(area) > FLT_MIN)) return slope;
    const float sign = area > 0.0f ? 1.0f : -1.0f;
    const glm::vec3 u = sign * (dv2 * (p1 - p0) - dv1 * (p2 - p0));
    const glm::vec3 v = sign * (du1 * (p2 - p0) - du2 * (p1 - p0));
    const float u_length = glm::length(u);
    const float v_length = glm::length(v);
    const float least = FLT_MIN * std::max(1.0f, std::abs(area));
    if (!(u_length > least && v_length > least && std::isfinite(u_length + v_length))) return slope;
    slope.along_u = u / u_length;
    slope.joins_any = false;
    return slope;
}

void TangentMaker::find_slopes() {
    slopes_.resize(triangles_);
    parallel_for(triangles_, kGrain, [this](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) slopes_[t] = slope_of(t);
    });
}

// Lists the corners by welded vertex (a counting sort), in the order of the triangles.
void TangentMaker::list_corners() {
    first_.assign(weld_.classes + std::size_t{1}, 0);
    for (std::size_t c = 0; c < 3 * triangles_; ++c)
        if (!slopes_[c / 3].degenerate) ++first_[vertex(c) + 1];
    for (std::size_t v = 0; v < weld_.classes; ++v) first_[v + 1] += first_[v];
    corners_.resize(first_.back());
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::size_t c = 0; c < 3 * triangles_; ++c)
        if (!slopes_[c / 3].degenerate) corners_[fill[vertex(c)]++] = static_cast<std::uint32_t>(c);
}

// Pairs each edge between vertex `at` and a vertex of higher number with an edge in the opposite
// direction. Where more than two triangles share an edge, the first of each direction are paired.
void TangentMaker::pair_edges_of(std::uint32_t at) {
    thread_local std::vector<Edge> edges;
    edges.clear();
    for (std::uint32_t k = first_[at]; k < first_[at + 1]; ++k) {
        const std::uint32_t corner = corners_[k];
        const std::size_t before = previous_corner(corner);
        const std::uint32_t to = vertex(next_corner(corner));
        const std::uint32_t from = vertex(before);
        if (to > at) edges.push_back({to, corner, true});
        if (from > at) edges.push_back({from, static_cast<std::uint32_t>(before), false});
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return a.other != b.other ? a.other < b.other : a.corner < b.corner;
    });
    // The edges without a partner are edges[waiting ..], all of one direction.
    for (std::size_t i = 0, waiting = 0; i < edges.size(); ++i) {
        if (edges[waiting].other != edges[i].other) waiting = i;
        while (waiting < i && neighbors_[edges[waiting].corner] != kNone) ++waiting;
        if (waiting == i || edges[waiting].outgoing == edges[i].outgoing) continue;
        neighbors_[edges[waiting].corner] = static_cast<std::int32_t>(edges[i].corner / 3);
        neighbors_[edges[i].corner] = static_cast<std::int32_t>(edges[waiting].corner / 3);
    }
}

void TangentMaker::find_neighbors() {
    neighbors_.assign(3 * triangles_, kNone);
    parallel_for(weld_.classes, kGrain, [this](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) pair_edges_of(static_cast<std::uint32_t>(v));
    });
}

void TangentMaker::join(std::size_t triangle, std::uint32_t at, std::int32_t group) {
    std::size_t corner = 3 * triangle;
    while (vertex(corner) != at) ++corner;
    if (groups_[corner] != kNone) return;
    Slope& slope = slopes_[triangle];
    const bool preserving = group_preserving_[static_cast<std::size_t>(group)];
    const bool untouched = groups_[3 * triangle] == kNone && groups_[3 * triangle + 1] == kNone &&
                           groups_[3 * triangle + 2] == kNone;
    if (slope.joins_any && untouched) slope.preserving = preserving;
    if (slope.preserving != preserving) return;
    groups_[corner] = group;
    pending_.push_back(corner);
}

void TangentMaker::spread_group(std::size_t start, std::int32_t group) {
    const std::uint32_t at = vertex(start);
    groups_[start] = group;
    pending_.assign(1, start);
    while (!pending_.empty()) {
        const std::size_t corner = pending_.back();
        pending_.pop_back();
        // Across the two edges of the triangle that meet here.
        const std::int32_t right = neighbors_[corner];
        const std::int32_t left = neighbors_[previous_corner(corner)];
        if (right != kNone) join(static_cast<std::size_t>(right), at, group);
        if (left != kNone) join(static_cast<std::size_t>(left), at, group);
    }
}

void TangentMaker::form_groups() {
    groups_.assign(3 * triangles_, kNone);
    for (std::size_t c = 0; c < 3 * triangles_; ++c) {
        const Slope& slope = slopes_[c / 3];
        if (slope.degenerate || slope.joins_any || groups_[c] != kNone) continue;
        const auto group = static_cast<std::int32_t>(group_preserving_.size());
        group_preserving_.push_back(slope.preserving);
        spread_group(c, group);
    }
}

// The triangle's direction of u, projected on the plane of the corner's normal, times the angle at
// the corner.
glm::vec3 TangentMaker::contribution(std::size_t corner) const {
    const glm::vec3 normal = mesh_.normals[mesh_.indices[corner]];
    const auto projected = [&](glm::vec3 v) {
        v -= normal * glm::dot(normal, v);
        const float length = glm::length(v);
        return length > FLT_MIN ? v / length : glm::vec3(0.0f);
    };
    const glm::vec3 here = position(corner);
    const glm::vec3 a = projected(position(previous_corner(corner)) - here);
    const glm::vec3 b = projected(position(next_corner(corner)) - here);
    const float angle = std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f));
    return angle * projected(slopes_[corner / 3].along_u);
}

// A group lives at one welded vertex, so vertices can be summed in parallel.
void TangentMaker::sum_groups() {
    group_tangents_.assign(group_preserving_.size(), glm::vec3(0.0f));
    parallel_for(weld_.classes, kGrain, [this](std::size_t begin, std::size_t end) {
        for (std::uint32_t k = first_[begin]; k < first_[end]; ++k) {
            const std::size_t corner = corners_[k];
            if (groups_[corner] == kNone || slopes_[corner / 3].joins_any) continue;
            group_tangents_[static_cast<std::size_t>(groups_[corner])] += contribution(corner);
        }
    });
    for (glm::vec3& tangent : group_tangents_) {
        const float length = glm::length(tangent);
        // Contributions that cancel leave rounding errors, which are not a direction: 1e-6 rad is
        // below the rounding of a sum of angles.
        tangent = length > 1e-6f ? tangent / length : glm::vec3(0.0f);
    }
}

// Corners without a group (of degenerate triangles) take the first group at their vertex.
void TangentMaker::share_groups() {
    std::vector<std::int32_t> first_group(weld_.classes, kNone);
    for (std::size_t c = 0; c < groups_.size(); ++c) {
        std::int32_t& group = first_group[vertex(c)];
        if (group == kNone) group = groups_[c];
    }
    for (std::size_t c = 0; c < groups_.size(); ++c)
        if (groups_[c] == kNone) groups_[c] = first_group[vertex(c)];
}

glm::vec4 TangentMaker::tangent_of(std::uint32_t at, std::int32_t group) const {
    const glm::vec3 fallback = tangent_of_normal(mesh_.normals[at]);
    if (group == kNone) return {fallback, 1.0f};
    const glm::vec3 tangent = group_tangents_[static_cast<std::size_t>(group)];
    const bool has_direction = tangent != glm::vec3(0.0f);
    return {has_direction ? tangent : fallback,
            group_preserving_[static_cast<std::size_t>(group)] ? 1.0f : -1.0f};
}

std::uint32_t TangentMaker::split_vertex(std::uint32_t at) {
    const auto again = [at](auto& items) {
        if (!items.empty())
            items.push_back(std::remove_reference_t<decltype(items[at])>(items[at]));
    };
    const auto copy = static_cast<std::uint32_t>(mesh_.positions.size());
    again(mesh_.positions);
    again(mesh_.normals);
    again(mesh_.tangents);
    again(mesh_.texcoord0);
    again(mesh_.texcoord1);
    again(mesh_.colors);
    return copy;
}

void TangentMaker::write_tangents() {
    constexpr std::int32_t kUnseen = -2;
    const std::size_t vertices = mesh_.positions.size();
    std::vector<std::int32_t> group_of(vertices, kUnseen);
    std::unordered_map<std::uint64_t, std::uint32_t> copies;  // by (vertex, further group)
    mesh_.tangents.resize(vertices);
    for (std::size_t c = 0; c < groups_.size(); ++c) {
        std::uint32_t& at = mesh_.indices[c];
        const std::int32_t group = groups_[c];
        if (group_of[at] == kUnseen) {
            group_of[at] = group;
            mesh_.tangents[at] = tangent_of(at, group);
        } else if (group_of[at] != group) {
            const std::uint64_t key = (std::uint64_t{at} << 32) | static_cast<std::uint32_t>(group);
            const auto [copy, fresh] = copies.try_emplace(key, 0);
            if (fresh) {
                copy->second = split_vertex(at);
                mesh_.tangents[copy->second] = tangent_of(at, group);
            }
            at = copy->second;
        }
    }
    for (std::uint32_t v = 0; v < vertices; ++v)
        if (group_of[v] == kUnseen) mesh_.tangents[v] = tangent_of(v, kNone);
}

// The coordinates under the rotation, and the mirroring, that `source` describes. Its scales are of
// no effect on tangents.
std::vector<glm::vec2> turned(std::vector<glm::vec2> coordinates, const TangentSource& source) {
    if (source.along == glm::vec2(1.0f, 0.0f) && !source.mirrored) return coordinates;
    const float sign = source.mirrored ? -1.0f : 1.0f;
    const glm::vec2 across(-sign * source.along.y, sign * source.along.x);
    for (glm::vec2& uv : coordinates)
        uv = glm::vec2(glm::dot(source.along, uv), glm::dot(across, uv));
    return coordinates;
}

}  // namespace

void make_tangents(Mesh& mesh, const TangentSource& source) {
    mesh.tangents.clear();
    mesh.tangent_source = source;
    const std::vector<glm::vec2>& set = source.texcoord == 1 ? mesh.texcoord1 : mesh.texcoord0;
    if (!set.empty()) {
        TangentMaker(mesh, turned(set, source)).run();
        return;
    }
    mesh.tangents.reserve(mesh.normals.size());
    for (const glm::vec3 normal : mesh.normals)
        mesh.tangents.emplace_back(tangent_of_normal(normal), 1.0f);
}

}  // namespace burnish
