#include "scene/geometry/polygon.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numeric>

namespace burnish {
namespace {

using Point = glm::dvec2;

// Twice the signed area of the triangle.
double turn(Point a, Point b, Point c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The outline projected on the coordinate plane in which it is largest, counter-clockwise with
// respect to Newell's normal.
std::vector<Point> flattened(const std::vector<glm::vec3>& corners) {
    glm::dvec3 normal(0.0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a(corners[i]);
        const glm::dvec3 b(corners[(i + 1) % corners.size()]);
        normal += glm::cross(a - glm::dvec3(corners[0]), b - glm::dvec3(corners[0]));
    }
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    std::vector<Point> points;
    points.reserve(corners.size());
    for (const glm::vec3& corner : corners)
        points.emplace_back(corner[u], normal[axis] < 0.0 ? -corner[v] : corner[v]);
    return points;
}

class EarCutter {
  public:
    EarCutter(const std::vector<Point>& points,
              std::vector<std::array<std::uint32_t, 3>>& triangles)
        : points_(points),
          triangles_(triangles),
          ring_(points.size()),
          // Ordinary outlines need one or two tests per corner for each ear.
          looks_left_(4 * points.size() * points.size()) {
        std::iota(ring_.begin(), ring_.end(), 0u);
    }

    void run() {
        std::size_t at = 0;
        std::size_t misses = 0;
        while (ring_.size() > 3) {
            at %= ring_.size();
            // After a whole round without an ear, or when the tests are used up, cut any corner.
            if (misses <= ring_.size() && !is_ear(at)) {
                ++at;
                ++misses;
                continue;
            }
            cut(at);
            misses = 0;
        }
        triangles_.push_back({ring_[0], ring_[1], ring_[2]});
    }

  private:
    std::uint32_t before(std::size_t at) const {
        return ring_[(at + ring_.size() - 1) % ring_.size()];
    }
    std::uint32_t after(std::size_t at) const { return ring_[(at + 1) % ring_.size()]; }

    bool is_ear(std::size_t at) {
        const std::uint32_t ends[] = {before(at), ring_[at], after(at)};
        const Point a = points_[ends[0]];
        const Point b = points_[ends[1]];
        const Point c = points_[ends[2]];
        if (turn(a, b, c) <= 0.0) return false;
        for (const std::uint32_t other : ring_) {
            if (looks_left_ == 0) return true;
            --looks_left_;
            if (other == ends[0] || other == ends[1] || other == ends[2]) continue;
            const Point p = points_[other];
            if (p == a || p == b || p == c) continue;  // bridges to holes touch at corners
            if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return false;
        }
        return true;
    }

    void cut(std::size_t at) {
        triangles_.push_back({before(at), ring_[at], after(at)});
        ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(at));
    }

    const std::vector<Point>& points_;
    std::vector<std::array<std::uint32_t, 3>>& triangles_;
    std::vector<std::uint32_t> ring_;  // corners not cut off yet
    std::size_t looks_left_;
};

// Which diagonal to cut a quadrilateral along: true for corners 1-3.
bool cut_other_way(const std::vector<Point>& p, const std::vector<glm::vec3>& corners) {
    const bool first_inside = turn(p[0], p[1], p[2]) > 0.0 && turn(p[0], p[2], p[3]) > 0.0;
    const bool second_inside = turn(p[1], p[2], p[3]) > 0.0 && turn(p[1], p[3], p[0]) > 0.0;
    if (first_inside != second_inside) return second_inside;
    return glm::distance(corners[1], corners[3]) < glm::distance(corners[0], corners[2]);
}

}  // namespace

void triangulate(const std::vector<glm::vec3>& corners,
                 std::vector<std::array<std::uint32_t, 3>>& triangles) {
    if (corners.size() < 3) return;
    if (corners.size() == 3) {
        triangles.push_back({0, 1, 2});
        return;
    }
    const std::vector<Point> points = flattened(corners);
    if (corners.size() > 4) {
        EarCutter(points, triangles).run();
    } else if (cut_other_way(points, corners)) {
        triangles.push_back({0, 1, 3});
        triangles.push_back({1, 2, 3});
    } else {
        triangles.push_back({0, 1, 2});
        triangles.push_back({0, 2, 3});
    }
}

}  // namespace burnish
