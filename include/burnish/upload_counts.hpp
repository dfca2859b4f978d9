// How often a renderer has put something onto the device: what tests and benchmarks of edits look
// at.
//
// Threads and lifetime: plain values; copies are independent, and any number of threads may read
// one.
#pragma once

#include "burnish/api.hpp"

namespace burnish {
namespace BURNISH_API gpu {

struct UploadCounts {
    int textures = 0;  // one a texture and form
    int meshes = 0;
    int environments = 0;
    int cloths = 0;
    int tables = 0;  // tabulated materials

    bool operator==(const UploadCounts&) const = default;
};

}  // namespace gpu
}  // namespace burnish
