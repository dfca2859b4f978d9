// Maps of woven cloth: a tile of a weave, every texel the point of shading/surface/weave.glsl in
// its middle.
//
// Maps have row 0 at the top; x runs right along u and the weft, y UP the picture along v and the
// warp, as glTF's tangent space has it. The first end is at the left, the first pick at the bottom.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/draft.hpp"
#include "burnish/f32.hpp"
#include "burnish/image.hpp"
#include "burnish/progress.hpp"

namespace BURNISH_API burnish {

struct WeaveMapSettings {
    Draft draft;
    f32::WeaveShape shape;             // in spacings of the yarns
    int width = 2048, height = 2048;   // texels, 16..16384
    int repeats_u = 1, repeats_v = 1;  // of the draft on the tile
    double yarn_mm = 1.0;              // from yarn to yarn, 0.001..1000
    glm::vec3 warp_color{0.45f, 0.43f, 0.38f},
        weft_color{0.06f, 0.08f, 0.14f};  // linear, of a draft without colours

    int ends() const { return draft.ends * repeats_u; }  // of the whole tile
    int picks() const { return draft.picks * repeats_v; }
    double width_mm() const { return ends() * yarn_mm; }
    double height_mm() const { return picks() * yarn_mm; }
};

struct WeaveMaps {
    int width = 0, height = 0;
    int ends = 0, picks = 0;
    Image heights;  // 1 channel, millimetres; 0 is the middle of the cloth
    Image normals;  // 2 channels, x and y of the unit normal, of the surface in millimetres
    Image
        direction;  // 2 channels, (cos 2a, sin 2a), a the direction of the fibres; (0, 0) in holes
    // 0 a hole, 1 to `ends` a warp yarn, from there on `picks` weft yarns.
    std::vector<std::uint16_t> yarns;
};

// Bytes that bake_weave needs.
std::uint64_t weave_map_memory(const WeaveMapSettings& settings);

// Throws UsageError "<where>: <key>: expected ..., found ..." for what is out of range: less than
// four texels a yarn do not show one.
void check_weave_map_settings(const WeaveMapSettings& settings, std::string_view where);

// The same settings give the same bytes on any number of threads. Throws as the check does, and
// Error with both figures when more than `memory_limit` bytes would be needed.
WeaveMaps bake_weave(const WeaveMapSettings& settings, std::uint64_t memory_limit,
                     const Progress& progress = {});

// Rows [begin, end) of the pictures that are made of these maps; `to` is packed RGB, 0..1.
void weave_normal_rows(const WeaveMaps& maps, int begin, int end, float* to);  // (1 + n) / 2
// (1 + cos 2a) / 2, (1 + sin 2a) / 2, and 1 where there is a yarn.
void weave_direction_rows(const WeaveMaps& maps, int begin, int end, float* to);
// RGB of KHR_materials_anisotropy: the direction of stretch, across the fibers, (1 + d) / 2 with y up;
// `strength` where there is a yarn, else 0.
void weave_stretch_rows(const WeaveMaps& maps, float strength, int begin, int end, float* to);
// Linear colour of a number of `yarns`; black for a hole.
glm::vec3 weave_yarn_color(const WeaveMaps& maps, const WeaveMapSettings& settings, int yarn);
// Display values (sRGB curve) of these.
void weave_color_rows(const WeaveMaps& maps, const WeaveMapSettings& settings, int begin, int end,
                      float* to);
// R 1 on a warp yarn, 1/2 on a weft yarn, 0 in a hole; G (number + 1/2) / yarns of that kind on the
// tile, numbers from 0 at the left and at the bottom; B 1 where the yarn is the upper one of its
// crossing, 0 where it shows beside the upper one.
void weave_id_rows(const WeaveMaps& maps, const WeaveMapSettings& settings, int begin, int end,
                   float* to);

}  // namespace burnish
