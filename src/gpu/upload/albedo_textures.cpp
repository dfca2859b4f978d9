#include "gpu/upload/albedo_textures.hpp"

#include <epoxy/gl.h>

#include <initializer_list>
#include <vector>

#include "burnish/f32.hpp"
#include "gpu/device/texture_units.hpp"
#include "models/albedo_table.hpp"

namespace burnish::gpu {

void AlbedoTables::bind(Brdf brdf, Mdf mdf) {
    const int model = static_cast<int>(brdf);
    const int key = model * 16 + f32::brdf_mdf(model, static_cast<int>(mdf));
    const bool known = tables_.contains(key);
    const GLuint texture = tables_[key].get();
    glActiveTexture(GL_TEXTURE0 + kAlbedoUnit);
    glBindTexture(GL_TEXTURE_3D, texture);
    if (known) return;
    const std::vector<float> table = albedo_table(brdf, mdf);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_R16F, kAlbedoAlphas, kAlbedoAlphas, kAlbedoCosines, 0, GL_RED,
                 GL_FLOAT, table.data());
    for (const GLenum name :
         std::initializer_list<GLenum>{GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
        glTexParameteri(GL_TEXTURE_3D, name, GL_LINEAR);
    }
    for (const GLenum name :
         std::initializer_list<GLenum>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTexParameteri(GL_TEXTURE_3D, name, GL_CLAMP_TO_EDGE);
    }
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
    check_gl("uploading an albedo table");
}

}  // namespace burnish::gpu
