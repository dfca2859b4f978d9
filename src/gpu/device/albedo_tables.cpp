#include "gpu/device/albedo_tables.hpp"

#include <initializer_list>
#include <memory>
#include <utility>

#include "burnish/f32.hpp"
#include "gpu/device/gl.hpp"
#include "gpu/device/texture_units.hpp"
#include "models/albedo_nodes.hpp"
#include "models/albedo_table.hpp"

namespace burnish::gpu {
namespace {

int key_of(Brdf brdf, Mdf mdf) {
    const int model = static_cast<int>(brdf);
    return model * 16 + f32::brdf_mdf(model, static_cast<int>(mdf));
}

}  // namespace

bool AlbedoTables::has(Brdf brdf, Mdf mdf) const {
    return tables_.contains(key_of(brdf, mdf));
}

void AlbedoTables::require(Brdf brdf, Mdf mdf) {
    if (has(brdf, mdf)) return;
    const std::shared_ptr<const AlbedoTable> table = albedo_table(brdf, mdf);
    GlTexture texture;
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glBindTexture(GL_TEXTURE_3D, texture.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB16F, kAlbedoAlphas, kAlbedoAlphas, kAlbedoCosines, 0,
                 GL_RGB, GL_FLOAT, table->nodes().data());
    for (const GLenum name :
         std::initializer_list<GLenum>{GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
        glTexParameteri(GL_TEXTURE_3D, name, GL_LINEAR);
    }
    for (const GLenum name :
         std::initializer_list<GLenum>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTexParameteri(GL_TEXTURE_3D, name, GL_CLAMP_TO_EDGE);
    }
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
    glBindTexture(GL_TEXTURE_3D, 0);
    check_gl("uploading an albedo table");
    tables_.emplace(key_of(brdf, mdf), std::move(texture));
}

void AlbedoTables::bind(Brdf brdf, Mdf mdf) const {
    glActiveTexture(GL_TEXTURE0 + kAlbedoUnit);
    glBindTexture(GL_TEXTURE_3D, tables_.at(key_of(brdf, mdf)).get());
}

}  // namespace burnish::gpu
