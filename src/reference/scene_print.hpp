// A number that tells what is traced: two traces whose samples may be added have the same.
#pragma once

#include <cstdint>

#include "burnish/render_settings.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// Of everything that a sample depends on: meshes, materials, textures, lights, environment, camera, settings.
std::uint64_t scene_print(const Scene& scene, const Environment& environment, const Camera& camera,
                          const RenderSettings& settings, int reflections);

}  // namespace burnish
