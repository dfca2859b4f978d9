// Determines the variant of the surface shader that a Material needs, and sets its uniforms.
#pragma once

#include "burnish/render_settings.hpp"
#include "burnish/scene.hpp"
#include "gpu/device/program.hpp"
#include "gpu/draw/surface_variant.hpp"
#include "gpu/upload/texture_upload.hpp"

namespace burnish::gpu {

// All fields but those of light and mesh: lights, image_light and vertex_color stay 0.
// `with_normal_map` false: ignores the normal map.
SurfaceVariant variant_of(const Material& material, const TextureStore::Slots& textures,
                          bool with_normal_map);

// Whether the surface shader reads the albedo table of the material's model.
bool reads_albedos(const RenderSettings& settings, const Material& material);

// Binds the textures to the units that set_material passes to programs.
void bind_textures(const Material& material, TextureStore& textures);

// Sets the uniforms of shaders/lib/material.glsl.
void set_material(Program& program, const Material& material, const TextureStore& textures,
                  float lod_bias);

// Sets the uniforms of surface.vert for the one texture transform that all textures share.
void set_shared_uv(Program& program, const Material& material);

}  // namespace burnish::gpu
