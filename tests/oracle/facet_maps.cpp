#include "facet_maps.hpp"

#include <cmath>

namespace burnish::oracle {
namespace {

constexpr Vec3 kUp{0, 0, 1};

// Where M takes the axes of the plate.
struct SurfaceMap {
    Vec3 x, y, z;

    Vec3 operator()(Vec3 v) const { return v.x * x + v.y * y + v.z * z; }
    long double volume() const { return dot(cross(x, y), z); }
};

// The tangents run along the slopes of the bump, -n~x/n~z and -n~y/n~z. What stands on the plate stays upright
// where height is added to height, and stays perpendicular to a sheet that is stamped.
SurfaceMap surface_map(const std::string& method, Vec3 n) {
    const Vec3 x{1, 0, -n.x / n.z}, y{0, 1, -n.y / n.z};
    return {x, y, method == "slope-shift" ? kUp : n};
}

// The vector of the area that a and b span, for one of the volume.
Vec3 facet_of(const SurfaceMap& map, Vec3 a, Vec3 b) {
    return (1 / map.volume()) * cross(map(a), map(b));
}

}  // namespace

bool moves_facets(const std::string& method) {
    return method == "slope-shift" || method == "stretch";
}

Vec3 moved_facet(const std::string& method, Vec3 n, Vec3 m) {
    const SurfaceMap map = surface_map(method, n);
    // Two vectors of the facet, a x b = m.
    const Vec3 away = std::fabs(m.x) < std::fabs(m.z) ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
    const Vec3 a = normalize(cross(away, m));
    return facet_of(map, a, cross(m, a));
}

Vec3 unmoved_facet(const std::string& method, Vec3 n, Vec3 h) {
    // h is perpendicular to the moved vectors M a exactly where M^T h is to a.
    const SurfaceMap map = surface_map(method, n);
    return {dot(map.x, h), dot(map.y, h), dot(map.z, h)};
}

long double facet_density(const std::string& method, Vec3 n, Vec3 h) {
    const SurfaceMap map = surface_map(method, n);
    const long double volume = map.volume();
    const long double plate = volume * length(facet_of(map, {1, 0, 0}, {0, 1, 0}));
    const long double l = length(unmoved_facet(method, n, h));
    // A facet's area grows by volume/l. The steradians about m are volume/l^3 times those about h.
    return volume / l * (volume / (l * l * l)) / plate;
}

Vec3 facets_seen(const std::string& method, Vec3 n, Vec3 w) {
    // w in the axes that M has made of those of the plate (Cramer's rule).
    const SurfaceMap map = surface_map(method, n);
    const long double volume = map.volume();
    const Vec3 v{dot(cross(map.y, map.z), w) / volume, dot(cross(map.z, map.x), w) / volume,
                 dot(cross(map.x, map.y), w) / volume};
    const long double plate = length(facet_of(map, {1, 0, 0}, {0, 1, 0}));
    return (1 / plate) * v;
}

}  // namespace burnish::oracle
