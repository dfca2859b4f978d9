#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "burnish/error.hpp"
#include "burnish/tabulated_file.hpp"
#include "burnish/tabulated_material.hpp"
#include "formats/tabulated/tabulated_check.hpp"
#include "formats/tabulated/tabulated_parts.hpp"
#include "image/image_parts.hpp"

namespace burnish {
namespace {

ImagePart exemplar_part(const TabulatedMaterial& m) {
    const TabulatedAtlas atlas = tabulated_atlas(m.grid, m.exemplars);
    ImagePart part;
    part.name = "exemplars";
    part.width = atlas.width();
    part.height = atlas.height();
    const auto texels =
        static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height);
    std::vector<float> D(texels), origin(texels), groove(texels);
    for (int e = 0; e < m.exemplars; ++e) {
        for (int r = 0; r < m.grid.rings; ++r) {
            for (int a = 0; a < m.grid.azimuths; ++a) {
                const std::size_t to = atlas.at(e, r, a);
                const std::size_t from =
                    static_cast<std::size_t>(e) * static_cast<std::size_t>(m.grid.cells()) +
                    static_cast<std::size_t>(r * m.grid.azimuths + a);
                D[to] = m.D[from];
                origin[to] = static_cast<float>(m.origin[from]);
                groove[to] = m.groove[static_cast<std::size_t>(e)];
            }
        }
    }
    part.channels = {{"D", false, std::move(D)},
                     {"groove", false, std::move(groove)},
                     {"origin", true, std::move(origin)}};
    part.integers = {{std::string(kTabulatedVersionKey), kTabulatedVersion},
                     {"tabulated:rings", m.grid.rings},
                     {"tabulated:azimuths", m.grid.azimuths},
                     {"tabulated:exemplars", m.exemplars},
                     {"tabulated:columns", atlas.columns}};
    part.reals = {{"tabulated:eta", m.eta}};
    return part;
}

void append_image(ImagePart& part, const Image& image, const std::string& name, bool half,
                  std::string_view letters) {
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<float> values;
        values.reserve(image.pixels.size() / 3);
        for (std::size_t i = c; i < image.pixels.size(); i += 3) values.push_back(image.pixels[i]);
        part.channels.push_back({name + "." + letters[c], half, std::move(values)});
    }
}

ImagePart texel_part(const TabulatedMaterial& m) {
    ImagePart part;
    part.name = "texels";
    part.width = m.width;
    part.height = m.height;
    std::vector<float> exemplar;
    exemplar.reserve(m.exemplar.size());
    for (const std::uint16_t index : m.exemplar) {
        exemplar.push_back(index == TabulatedMaterial::kNoExemplar ? -1.0F
                                                                   : static_cast<float>(index));
    }
    part.channels = {{"exemplar", false, std::move(exemplar)}, {"angle", false, m.angle}};
    append_image(part, m.diffuse, "diffuse", true, "RGB");
    append_image(part, m.specular, "specular", true, "RGB");
    append_image(part, m.normal, "normal", false, "XYZ");
    part.reals = {{"tabulated:width_mm", m.width_mm}, {"tabulated:height_mm", m.height_mm}};
    for (const auto& [name, text] : m.metadata)
        part.texts.emplace(std::string(kTabulatedMetadata) + name, text);
    return part;
}

}  // namespace

void write_tabulated_material(const std::filesystem::path& path,
                              const TabulatedMaterial& material) {
    check_tabulated_material(path.string(), material);
    std::vector<ImagePart> parts = {exemplar_part(material), texel_part(material)};
    if (!material.maps.empty()) {
        ImagePart maps;
        maps.name = "maps";
        maps.width = material.width;
        maps.height = material.height;
        for (const auto& [name, values] : material.maps)
            maps.channels.push_back({name, false, values});
        parts.push_back(std::move(maps));
    }
    write_image_parts(path, parts);
}

}  // namespace burnish
