#include "plot/surface_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "burnish/f64.hpp"
#include "core/parallel.hpp"

namespace burnish::plot {
namespace {

using Vec = Direction<double>;

constexpr std::size_t kRings = 220, kSectors = 180;
// First ring at 0.06 degrees, the width of the narrowest lobe; the last at 3.7 from the others.
constexpr double kCrowding = 5;
// Height above the horizon of directions on the rim of the hemisphere: below the horizon f is 0.
constexpr double kRim = 1e-6;

class Builder {
  public:
    Builder(const BrdfSubject& subject, Vec wi, const Scale& scale)
        : subject_(subject), wi_(wi), scale_(scale) {}

    Vec scaled(Vec direction) const {
        const double at = scale_.position(subject_.f(wi_, direction));
        return direction * (at > 0 ? std::min(at, 1.0) : 0.0);
    }
    // The grid of directions and their points.
    void grid(const f64::Frame& frame) {
        directions_.resize(1 + kRings * kSectors);
        mesh.points.resize(directions_.size());
        directions_[0] = frame.n;
        parallel_for(kRings, 4, [&](std::size_t begin, std::size_t end) {
            for (std::size_t ring = begin; ring < end; ++ring) {
                const double u = static_cast<double>(ring + 1) / kRings;
                const double theta =
                    std::numbers::pi * std::sinh(kCrowding * u) / std::sinh(kCrowding);
                for (std::size_t sector = 0; sector < kSectors; ++sector) {
                    const double phi =
                        2 * std::numbers::pi * static_cast<double>(sector) / kSectors;
                    const Vec local{std::sin(theta) * std::cos(phi),
                                    std::sin(theta) * std::sin(phi), std::cos(theta)};
                    directions_[index(ring, sector)] = f64::frame_to_outer(frame, local);
                }
            }
        });
        parallel_for(directions_.size(), 512, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                if (directions_[i].z > 0) mesh.points[i] = scaled(directions_[i]);
        });
    }
    void triangles() {
        for (std::size_t s = 0; s < kSectors; ++s) cut(0, index(0, s), index(0, s + 1));
        for (std::size_t r = 0; r + 1 < kRings; ++r) {
            for (std::size_t s = 0; s < kSectors; ++s) {
                cut(index(r, s), index(r + 1, s), index(r + 1, s + 1));
                cut(index(r, s), index(r + 1, s + 1), index(r, s + 1));
            }
        }
    }
    void normals() {
        mesh.normals.resize(mesh.points.size());
        for (const auto& t : mesh.triangles) {
            const Vec a = mesh.points[t[0]];
            const Vec n = f64::cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a);
            for (const std::size_t i : t) mesh.normals[i] = mesh.normals[i] + n;
        }
        for (Vec& n : mesh.normals)
            if (!make_unit(n)) n = {0, 0, 1};
    }
    // Rings at a distance from each other on the surface, and spokes every 16 degrees from the
    // first ring outwards.
    void lines() {
        const std::vector<std::size_t> rings = rings_apart();
        for (std::size_t s = 0; s < kSectors && !rings.empty(); s += 8) {
            auto& line = mesh.lines.emplace_back();
            for (std::size_t r = rings.front(); r < kRings; ++r)
                if (directions_[index(r, s)].z > 0) line.push_back(index(r, s));
        }
        for (const std::size_t r : rings) {
            auto* line = &mesh.lines.emplace_back();
            for (std::size_t s = 0; s <= kSectors; ++s) {
                if (directions_[index(r, s)].z > 0) {
                    line->push_back(index(r, s));
                } else if (!line->empty()) {
                    line = &mesh.lines.emplace_back();
                }
            }
        }
    }

    SurfaceMesh mesh;

  private:
    // The mean distance between rings is a twelfth of the largest radius.
    std::vector<std::size_t> rings_apart() const {
        std::vector<std::size_t> rings;
        const auto apart = [&](std::size_t r, std::size_t s) {
            const std::size_t before = rings.empty() ? 0 : index(rings.back(), s);
            return f64::length(mesh.points[index(r, s)] - mesh.points[before]);
        };
        for (std::size_t r = 0; r < kRings; ++r) {
            double sum = 0;
            for (std::size_t s = 0; s < kSectors; ++s) sum += apart(r, s);
            if (sum > kSectors / 12.0) rings.push_back(r);
        }
        return rings;
    }
    static std::size_t index(std::size_t ring, std::size_t sector) {
        return 1 + ring * kSectors + sector % kSectors;
    }
    // The point where the edge from a to b meets the horizon.
    std::size_t rim_point(std::size_t a, std::size_t b) {
        const Vec da = directions_[a], db = directions_[b];
        const double u = da.z / (da.z - db.z);
        Vec d = da + (db - da) * u;
        d.z = kRim;
        make_unit(d);
        directions_.push_back(d);
        mesh.points.push_back(scaled(d));
        return mesh.points.size() - 1;
    }
    // The part of a triangle that is above the horizon.
    void cut(std::size_t a, std::size_t b, std::size_t c) {
        std::array<std::size_t, 4> kept{};
        std::size_t count = 0;
        const std::array<std::size_t, 3> corners = {a, b, c};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t from = corners[i], to = corners[(i + 1) % 3];
            const bool from_above = directions_[from].z > 0, to_above = directions_[to].z > 0;
            if (from_above) kept[count++] = from;
            if (from_above != to_above) kept[count++] = rim_point(from, to);
        }
        for (std::size_t i = 2; i < count; ++i)
            mesh.triangles.push_back({kept[0], kept[i - 1], kept[i]});
    }

    const BrdfSubject& subject_;
    Vec wi_;
    const Scale& scale_;
    std::vector<Vec> directions_;
};

}  // namespace

SurfaceMesh surface_mesh(const BrdfSubject& subject, Vec wi, const Scale& scale, Vec peak) {
    // A frame about the peak whose spokes run in the plane of incidence.
    const f64::Frame frame = f64::frame_shortest_arc(peak);
    Builder builder(subject, wi, scale);
    builder.grid(frame);
    builder.triangles();
    builder.normals();
    builder.lines();
    return std::move(builder.mesh);
}

}  // namespace burnish::plot
