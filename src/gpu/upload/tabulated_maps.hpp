// What the shader of tabulated materials reads (shaders/lib/tabulated.glsl, tabulated_texels.glsl).
// Each exemplar has a block in three pictures, block i at (i % columns, i / columns):
//
//   tables  azimuths x rings: D, of the cell, the next around, the next ring's, and of both
//   draws   azimuths x rings: share of the ring's draws up to and with the cell, density of draws
//   in it areas   kAreaGrid: g - z, four as in the tables; the share of draws up to and with each
//   ring,
//           kAreaGrid.azimuths a row
//
// and of each texel, by 16 bits,
//
//   texels  exemplar, angle of its groove (2 pi / 65536); x, y of the normal; cosine and sine of
//           the angle; of angle and groove together
//   colors  diffuse and specular, as half floats
//
// One fetch gives what a value between four cells asks for: software renderers pay by the fetch.
#pragma once

#include <epoxy/gl.h>

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "burnish/scene.hpp"
#include "gpu/device/handles.hpp"
#include "gpu/device/program.hpp"
#include "scene/material/tabulated_draws.hpp"
#include "scene/material/tabulated_material.hpp"

namespace burnish::gpu {

class TabulatedMaps {
  public:
    // Of a material with `tabulated`; made when it is first seen. `draws`: the environment is
    // sampled. Throws Error when it is larger than the device's textures.
    void bind(Program& program, const Material& material, bool draws);

  private:
    struct Made {
        std::shared_ptr<const TabulatedMaterial> material;
        int columns = 1, area_rows = 0;
        GlTexture tables, areas, texels, colors;
        std::unique_ptr<GlTexture> draws;
    };
    static void make(Made& made, std::shared_ptr<const TabulatedMaterial> material);
    static void make_draws(Made& made);
    std::map<const TabulatedMaterial*, std::unique_ptr<Made>> made_;
};

}  // namespace burnish::gpu
