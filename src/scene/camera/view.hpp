// Turns a camera, a tile of the picture and a sub-pixel offset into the values that shaders need.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "burnish/mesh.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// A rectangle of the picture; y counts upwards from the bottom, as in OpenGL.
struct Tile {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

// Tiles of at most `side` pixels a side, row by row from the bottom.
std::vector<Tile> tiles_of(int width, int height, int side);

// Unit axes of a camera: it looks along -back.
struct CameraBasis {
    glm::dvec3 right, up, back, position;
};

// Throws Error for a camera whose target is its position.
CameraBasis camera_basis(const Camera& camera);

// Half the height of the picture: of an orthographic view in meters, else on the plane at distance 1.
// Throws Error for a view without height.
double half_height_of(const Camera& camera);

struct View {
    glm::mat4 clip_from_world{1.0f};
    glm::vec4 eye{0.0f};  // position, 1; orthographic: direction to the viewer, 0
    glm::vec3 ray_center{
        0.0f};  // of the middle of the tile, and what half its width and height add
    glm::vec3 ray_x{0.0f};
    glm::vec3 ray_y{0.0f};
};

// `offset_px`: position within the pixel, (0, 0) is its middle. `bounds`: the box from which near
// and far planes of 0 are chosen. Throws Error for a camera without a view (target = position, no
// field of view).
View make_view(const Camera& camera, const Bounds& bounds, int width, int height, const Tile& tile,
               glm::dvec2 offset_px);

// The part of the tile, in pixels of the tile, that the box can cover: the whole tile for a box
// that reaches behind the eye.
Tile screen_bounds(const View& view, const Bounds& box, const Tile& tile);

}  // namespace burnish
