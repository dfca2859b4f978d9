// Primitives of glTF files compressed with Draco, for tests.
#pragma once

#include "support/glb_writer.hpp"

namespace burnish {

struct DracoOptions {
    bool edgebreaker = true;  // else sequential
    int position_bits = 16;   // 0: floats as they are
};

// Adds a mesh of one primitive whose positions, normals and coordinates are compressed: their
// accessors have no buffer view. Returns the mesh.
int add_draco_mesh(GlbWriter& writer, const GlbPrimitive& primitive, const DracoOptions& options);

}  // namespace burnish
