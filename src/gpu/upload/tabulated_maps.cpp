#include "gpu/upload/tabulated_maps.hpp"

#include <utility>

#include "gpu/device/texture_units.hpp"
#include "scene/material/tabulated_images.hpp"

namespace burnish::gpu {
namespace {

struct TableFormat {
    GLenum internal, layout, type;
};

// Uploads a picture that shaders read by texel, without filtering.
void upload(GLuint texture, const TableFormat& format, int width, int height, const void* texels) {
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format.internal), width, height, 0,
                 format.layout, format.type, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void upload(GLuint texture, const TableBlocks& blocks) {
    const TableFormat format = blocks.values == 4 ? TableFormat{GL_RGBA32F, GL_RGBA, GL_FLOAT}
                                                  : TableFormat{GL_RG32F, GL_RG, GL_FLOAT};
    upload(texture, format, blocks.total_width(), blocks.total_height(), blocks.texels.data());
}

int largest_side() {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    return most;
}

void bind_texture(Program& program, const char* name, int unit, GLuint texture) {
    glActiveTexture(GL_TEXTURE0 + kTabulatedUnits + static_cast<GLuint>(unit));
    glBindTexture(GL_TEXTURE_2D, texture);
    program.set(name, static_cast<int>(kTabulatedUnits) + unit);
}

}  // namespace

TabulatedMaps::TabulatedMaps(std::shared_ptr<const TabulatedMaterial> material)
    : material_(std::move(material)) {
    const TabulatedMaterial& m = *material_;
    const TabulatedImages images = tabulated_images(m, largest_side());
    columns_ = images.columns;
    area_rows_ = images.area_rows;
    upload(tables_.get(), images.tables);
    upload(areas_.get(), images.areas);
    const TableFormat words = {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT};
    upload(texels_.get(), words, m.width, m.height, images.texels.data());
    upload(colors_.get(), words, m.width, m.height, images.colors.data());
    check_gl("uploading a tabulated material");
}

void TabulatedMaps::require_draws() {
    if (draws_) return;
    GlTexture draws;
    upload(draws.get(), tabulated_draw_blocks(*material_, columns_));
    check_gl("uploading a tabulated material");
    draws_ = std::move(draws);
}

void TabulatedMaps::bind(Program& program) const {
    const TabulatedMaterial& m = *material_;
    bind_texture(program, "u_tabulated_tables", 0, tables_.get());
    bind_texture(program, "u_tabulated_areas", 1, areas_.get());
    bind_texture(program, "u_tabulated_texels", 2, texels_.get());
    bind_texture(program, "u_tabulated_colors", 3, colors_.get());
    if (draws_) bind_texture(program, "u_tabulated_draws", 4, draws_->get());
    program.set("u_tabulated_grid", glm::ivec2(m.grid.azimuths, m.grid.rings));
    program.set("u_tabulated_columns", columns_);
    program.set("u_tabulated_area_rows", area_rows_);
    program.set("u_tabulated_one", m.texels() == 1 ? 1 : 0);
}

}  // namespace burnish::gpu
