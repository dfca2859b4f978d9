#include "viewer/inspect/triangle_tree.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace burnish::viewer {
namespace {

constexpr std::uint32_t kMostInLeaf = 4;
constexpr int kBins = 12;  // more gain less than a percent of the boxes that rays meet
// Deeper nodes are halved, so that the tree of 2^32 triangles is at most 96 deep.
constexpr int kMostSkewedDepth = 64;
constexpr int kMostDepth = 96;

bool is_finite(glm::vec3 p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

// Where a ray with direction 1/inverse is inside a box.
bool meets(glm::vec3 low, glm::vec3 high, glm::dvec3 origin, glm::dvec3 inverse, double from,
           double to, double& entry) {
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (static_cast<double>(low[axis]) - origin[axis]) * inverse[axis];
        const double b = (static_cast<double>(high[axis]) - origin[axis]) * inverse[axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    entry = from;
    // 1e-12: rounding of the products, for boxes without thickness.
    return from <= to + 1e-12 * std::abs(to);
}

glm::dvec3 inverse_of(glm::dvec3 direction) {
    glm::dvec3 inverse(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        // 1e-280 for 0: 0 times its inverse is 0, where infinity would give no number.
        const double d = std::abs(direction[axis]) > 1e-280 ? direction[axis] : 1e-280;
        inverse[axis] = 1 / d;
    }
    return inverse;
}

}  // namespace

struct TriangleTree::Box {
    glm::vec3 low{std::numeric_limits<float>::max()};
    glm::vec3 high{std::numeric_limits<float>::lowest()};

    void include(glm::vec3 p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    void include(const Box& b) {
        low = glm::min(low, b.low);
        high = glm::max(high, b.high);
    }
    // Half its area; in double, as a scene may be 1e30 wide.
    double area() const {
        const glm::dvec3 d(glm::max(high - low, 0.0f));
        return d.x * d.y + d.y * d.z + d.z * d.x;
    }
};

// Boxes and middles of triangles, and the order in which the leaves hold them.
struct TriangleTree::Build {
    std::vector<Box> boxes;
    std::vector<glm::vec3> middles;
    std::vector<std::uint32_t> order;
    int depth = 0;

    Box bounds(std::uint32_t begin, std::uint32_t end) const {
        Box box;
        for (std::uint32_t i = begin; i < end; ++i) box.include(boxes[order[i]]);
        return box;
    }
    Box middle_bounds(std::uint32_t begin, std::uint32_t end) const {
        Box box;
        for (std::uint32_t i = begin; i < end; ++i) box.include(middles[order[i]]);
        return box;
    }

    // Where to part [begin, end): by the least area times number over bins of the longest axis.
    std::uint32_t part(std::uint32_t begin, std::uint32_t end);
    std::uint32_t halve(std::uint32_t begin, std::uint32_t end, int axis);
};

std::uint32_t TriangleTree::Build::halve(std::uint32_t begin, std::uint32_t end, int axis) {
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(
        order.begin() + begin, order.begin() + middle, order.begin() + end,
        [&](std::uint32_t a, std::uint32_t b) { return middles[a][axis] < middles[b][axis]; });
    return middle;
}

std::uint32_t TriangleTree::Build::part(std::uint32_t begin, std::uint32_t end) {
    const Box span = middle_bounds(begin, end);
    const glm::vec3 size = span.high - span.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    if (depth > kMostSkewedDepth || !(size[axis] > 0.0f) || !std::isfinite(size[axis]))
        return halve(begin, end, axis);
    const auto bin_of = [&](std::uint32_t triangle) {
        const float share = (middles[triangle][axis] - span.low[axis]) / size[axis];
        return std::clamp(static_cast<int>(share * kBins), 0, kBins - 1);
    };
    std::array<Box, kBins> bins;
    std::array<double, kBins> counts{};
    for (std::uint32_t i = begin; i < end; ++i) {
        const auto bin = static_cast<std::size_t>(bin_of(order[i]));
        bins[bin].include(boxes[order[i]]);
        counts[bin] += 1;
    }
    // Costs of what lies above each bin, then of both sides.
    std::array<double, kBins> above{};
    Box box;
    double count = 0;
    for (std::size_t i = kBins - 1; i > 0; --i) {
        box.include(bins[i]);
        count += counts[i];
        above[i - 1] = count > 0 ? box.area() * count : 0.0;
    }
    box = {};
    count = 0;
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < kBins; ++i) {
        box.include(bins[i]);
        count += counts[i];
        const double cost = (count > 0 ? box.area() * count : 0.0) + above[i];
        if (cost < least) {
            least = cost;
            best = static_cast<int>(i);
        }
    }
    const auto parted =
        std::partition(order.begin() + begin, order.begin() + end,
                       [&](std::uint32_t triangle) { return bin_of(triangle) <= best; });
    const auto middle = static_cast<std::uint32_t>(parted - order.begin());
    return middle == begin || middle == end ? halve(begin, end, axis) : middle;
}

std::uint32_t TriangleTree::add_node(Build& build, std::uint32_t begin, std::uint32_t end) {
    const auto place = static_cast<std::uint32_t>(nodes_.size());
    const Box box = build.bounds(begin, end);
    nodes_.push_back({box.low, box.high, begin, end - begin});
    if (end - begin <= kMostInLeaf) return place;
    const std::uint32_t middle = build.part(begin, end);
    ++build.depth;
    add_node(build, begin, middle);
    const std::uint32_t right = add_node(build, middle, end);
    --build.depth;
    nodes_[place].first = right;
    nodes_[place].count = 0;
    return place;
}

TriangleTree::TriangleTree(const Mesh& mesh) {
    std::vector<Triangle> read;
    Build build;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Triangle t;
        Box box;
        bool sound = true;
        for (std::size_t c = 0; c < 3; ++c) {
            t.corners[c] = mesh.positions[mesh.indices[i + c]];
            sound = sound && is_finite(t.corners[c]);
            box.include(t.corners[c]);
        }
        if (!sound) continue;
        t.index = static_cast<std::uint32_t>(i / 3);
        build.order.push_back(static_cast<std::uint32_t>(read.size()));
        build.boxes.push_back(box);
        build.middles.push_back(0.5f * box.low + 0.5f * box.high);
        read.push_back(t);
    }
    if (read.empty()) return;
    nodes_.reserve(read.size());
    add_node(build, 0, static_cast<std::uint32_t>(read.size()));
    triangles_.reserve(read.size());
    for (const std::uint32_t i : build.order) triangles_.push_back(read[i]);
}

namespace {

// Moller & Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
bool meets_triangle(const std::array<glm::vec3, 3>& corners, const TreeRay& ray,
                    TriangleTree::Faces faces, TreeHit& hit) {
    const glm::dvec3 a(corners[0]);
    const glm::dvec3 ab = glm::dvec3(corners[1]) - a, ac = glm::dvec3(corners[2]) - a;
    const glm::dvec3 p = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, p);
    const bool front = determinant > 0;
    // Written so that NaN fails. 0: the ray lies in the plane.
    if (!(front || (faces == TriangleTree::Faces::both && determinant < 0))) return false;
    const glm::dvec3 from_a = ray.origin - a;
    const double u = glm::dot(from_a, p) / determinant;
    const glm::dvec3 q = glm::cross(from_a, ab);
    const double v = glm::dot(ray.direction, q) / determinant;
    // 1e-10: by rounding a ray could pass between two triangles that share an edge.
    constexpr double kOutside = -1e-10;
    if (!(u >= kOutside && v >= kOutside && 1 - u - v >= kOutside)) return false;
    const double t = glm::dot(ac, q) / determinant;
    if (!(t >= ray.from && t <= ray.to)) return false;
    hit.t = t;
    hit.barycentric = {1 - u - v, u, v};
    hit.front = front;
    return true;
}

}  // namespace

std::optional<TreeHit> TriangleTree::nearest(const TreeRay& ray, Faces faces) const {
    std::optional<TreeHit> found;
    if (nodes_.empty()) return found;
    const glm::dvec3 inverse = inverse_of(ray.direction);
    TreeRay left = ray;  // its end moves to the nearest hit so far
    std::array<std::uint32_t, kMostDepth + 2> stack{};
    std::size_t waiting = 1;
    while (waiting > 0) {
        const std::uint32_t at = stack[--waiting];
        const Node& node = nodes_[at];
        double entry = 0;
        if (!meets(node.low, node.high, left.origin, inverse, left.from, left.to, entry)) continue;
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            TreeHit hit;
            if (!meets_triangle(triangles_[i].corners, left, faces, hit)) continue;
            hit.triangle = triangles_[i].index;
            left.to = hit.t;
            found = hit;
        }
        if (node.count > 0) continue;
        double near_entry = 0, far_entry = 0;
        std::uint32_t near_child = at + 1, far_child = node.first;
        const auto entry_of = [&](std::uint32_t child, double& into) {
            return meets(nodes_[child].low, nodes_[child].high, left.origin, inverse, left.from,
                         left.to, into);
        };
        bool near_met = entry_of(near_child, near_entry);
        bool far_met = entry_of(far_child, far_entry);
        if (far_entry < near_entry) {
            std::swap(near_child, far_child);
            std::swap(near_met, far_met);
        }
        if (far_met) stack[waiting++] = far_child;
        if (near_met) stack[waiting++] = near_child;
    }
    return found;
}

}  // namespace burnish::viewer
