// Meshes and scenes of simple shapes, and what visibility finds of them.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "burnish/f64.hpp"
#include "burnish/scene.hpp"
#include "burnish/visibility.hpp"

namespace burnish::test {

// A surface of (columns + 1) x (rows + 1) vertices. `place` gives position and unit normal of (u, v) in [0, 1];
// corners are counter-clockwise about the normals, triangles without area are left out. A surface `closed` in u
// has the same positions at both ends.
struct Place {
    glm::dvec3 position, normal;
};
Mesh surface(int columns, int rows, bool closed,
             const std::function<Place(double u, double v)>& place);

// A rectangle from `corner` along `u` and `v`; its normal is cross(u, v).
Mesh rectangle(glm::dvec3 corner, glm::dvec3 u, glm::dvec3 v, int columns, int rows);
// The square of half width `half` about the origin in the plane y = 0, facing up.
Mesh ground(double half, int cells);
Mesh disc(glm::dvec3 center, double radius, glm::dvec3 normal, int segments = 128);
// Facing outwards, or inwards as seen from within.
Mesh sphere(glm::dvec3 center, double radius, int rows, bool inwards = false);
Mesh box(glm::dvec3 low, glm::dvec3 high, int cells, bool inwards = false);
// The lower half of the unit sphere about the origin, seen from within; its rim lies in y = 0.
Mesh bowl(int rows);
// Side and top, standing on y = 0.
Mesh cylinder(glm::dvec3 foot, double radius, double height, int segments = 64);

Mesh joined(const Mesh& a, const Mesh& b);
// Positions and normals in the frame that the transform leads to, corners counter-clockwise again.
Mesh transformed(const Mesh& mesh, const glm::dmat4& transform);

// One instance a mesh, of an opaque white dielectric without highlights.
Material matt(glm::vec3 albedo = glm::vec3(1.0f));
Scene scene_of(std::vector<Mesh> meshes);

inline constexpr VisibilitySettings kWhole{256, false};  // the meshes as they are

// As they are stored.
f64::Harmonics blocked_of(const VertexVisibility& vertex);
f64::Surroundings around_of(const VertexVisibility& vertex);
f64::vec3 to_f64(glm::dvec3 v);

// The position and normal of a vertex of an instance in the world.
Place place_of(const Scene& scene, std::size_t instance, std::size_t vertex);
// The vertex of the mesh that is nearest to a position.
std::size_t vertex_at(const Mesh& mesh, glm::dvec3 position);

// Whether a ray from a point is blocked, by a closed form.
using IsBlocked = std::function<bool(glm::dvec3 from, glm::dvec3 direction)>;
IsBlocked by_disc(glm::dvec3 center, double radius, glm::dvec3 normal);
IsBlocked by_sphere(glm::dvec3 center, double radius);

// Harmonics of what a point of a surface sees, by 2^15 directions: those below the surface have the value of
// their mirror image.
f64::Harmonics expected_at(const Place& place, const IsBlocked& is_blocked);
// The blocked share weighted by the cosine, by the same directions, with all bands.
double expected_share(const Place& place, const IsBlocked& is_blocked);

// The greatest difference of a coefficient, in the order of the members.
double difference(const f64::Harmonics& a, const f64::Harmonics& b);

// Whether every coefficient is exactly 0.
bool is_open(const VertexVisibility& vertex);
bool is_open(const InstanceVisibility& instance);  // of all vertices, of which there are some

}  // namespace burnish::test
