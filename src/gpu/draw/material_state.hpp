// From a Material to the variant of the surface shader it needs and the uniforms it sets.
#pragma once

#include "burnish/scene.hpp"
#include "gpu/device/program.hpp"
#include "gpu/draw/surface_variant.hpp"
#include "gpu/upload/texture_upload.hpp"

namespace burnish::gpu {

// Everything but the light and the mesh: lights, image_light and vertex_color are left 0.
// `with_normal_map` false: the material as if it had none.
SurfaceVariant variant_of(const Material& material, const TextureStore::Slots& textures,
                          bool with_normal_map);

// Binds the textures to the units that set_material names to programs.
void bind_textures(const Material& material, TextureStore& textures);

// Sets the uniforms of shaders/lib/material.glsl.
void set_material(Program& program, const Material& material, const TextureStore& textures,
                  float lod_bias);

// The uniforms of surface.vert for the one texture transform in use.
void set_shared_uv(Program& program, const Material& material);

}  // namespace burnish::gpu
