#include <fmt/format.h>

#include <cmath>
#include <span>
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

class Parts {
  public:
    Parts(const std::string& file, std::vector<ImagePart> parts)
        : file_(file), parts_(std::move(parts)) {}

    ImagePart* find(std::string_view name) {
        for (ImagePart& part : parts_)
            if (part.name == name) return &part;
        return nullptr;
    }
    ImagePart& require(std::string_view name) {
        ImagePart* part = find(name);
        if (!part) throw Error(file_, name, "a part of that name", "none");
        return *part;
    }
    int integer(const ImagePart& part, const std::string& key, int low, int high) const {
        const auto found = part.integers.find(key);
        if (found == part.integers.end())
            throw Error(file_, part.name + ": " + key, "a whole number", "none");
        if (found->second < low || found->second > high) {
            throw Error(file_, part.name + ": " + key, fmt::format("{} to {}", low, high),
                        std::to_string(found->second));
        }
        return found->second;
    }
    double real(const ImagePart& part, const std::string& key) const {
        const auto found = part.reals.find(key);
        if (found != part.reals.end()) return found->second;
        throw Error(file_, part.name + ": " + key, "a number", "none");
    }
    std::vector<float>& channel(ImagePart& part, const std::string& name) const {
        for (ImageChannel& candidate : part.channels)
            if (candidate.name == name) return candidate.values;
        throw Error(file_, part.name, "a channel " + name, "none of that name");
    }
    const std::string& file() const { return file_; }

  private:
    const std::string& file_;
    std::vector<ImagePart> parts_;
};

// The value of a channel as a whole number from `low` to `high`; throws Error for any other value.
int whole(const Parts& parts, const std::string& place, float value, int low, int high) {
    if (value >= static_cast<float>(low) && value <= static_cast<float>(high) &&
        value == std::floor(value)) {
        return static_cast<int>(value);
    }
    throw Error(parts.file(), place, fmt::format("whole numbers from {} to {}", low, high),
                fmt::format("{:g}", value));
}

void read_exemplars(Parts& parts, TabulatedMaterial& m) {
    ImagePart& part = parts.require("exemplars");
    parts.integer(part, std::string(kTabulatedVersionKey), kTabulatedVersion, kTabulatedVersion);
    m.grid.rings = parts.integer(part, "tabulated:rings", 2, kMostRings);
    m.grid.azimuths = parts.integer(part, "tabulated:azimuths", 4, kMostAzimuths);
    m.exemplars = parts.integer(part, "tabulated:exemplars", 1, kMostExemplars);
    check_cells(parts.file(), m.grid, m.exemplars);
    m.eta = parts.real(part, "tabulated:eta");
    const TabulatedAtlas atlas{
        m.grid, m.exemplars,
        parts.integer(part, "tabulated:columns", 1, kMostAtlasSide / m.grid.azimuths)};
    if (part.width != atlas.width() || part.height != atlas.height()) {
        throw Error(parts.file(), "exemplars",
                    fmt::format("{} x {} pixels", atlas.width(), atlas.height()),
                    fmt::format("{} x {}", part.width, part.height));
    }
    const std::vector<float>&D = parts.channel(part, "D"), &origin = parts.channel(part, "origin"),
          &groove = parts.channel(part, "groove");
    for (int e = 0; e < m.exemplars; ++e) {
        m.groove.push_back(groove[atlas.at(e, 0, 0)]);
        for (int r = 0; r < m.grid.rings; ++r) {
            for (int a = 0; a < m.grid.azimuths; ++a) {
                m.D.push_back(D[atlas.at(e, r, a)]);
                m.origin.push_back(static_cast<NdfOrigin>(
                    whole(parts, "exemplars: origin", origin[atlas.at(e, r, a)], 0, 2)));
            }
        }
    }
}

Image image_of(const Parts& parts, ImagePart& part, const std::string& name,
               std::string_view letters) {
    Image image(part.width, part.height, 3);
    for (std::size_t c = 0; c < 3; ++c) {
        const std::vector<float>& values = parts.channel(part, name + "." + letters[c]);
        for (std::size_t i = 0; i < values.size(); ++i) image.pixels[3 * i + c] = values[i];
    }
    return image;
}

void read_texels(Parts& parts, TabulatedMaterial& m) {
    ImagePart& part = parts.require("texels");
    m.width = part.width;
    m.height = part.height;
    m.width_mm = parts.real(part, "tabulated:width_mm");
    m.height_mm = parts.real(part, "tabulated:height_mm");
    m.exemplar.reserve(m.texels());
    for (const float index : parts.channel(part, "exemplar")) {
        const int exemplar = whole(parts, "texels: exemplar", index, -1, m.exemplars - 1);
        m.exemplar.push_back(exemplar < 0 ? TabulatedMaterial::kNoExemplar
                                          : static_cast<std::uint16_t>(exemplar));
    }
    m.angle = std::move(parts.channel(part, "angle"));
    m.diffuse = image_of(parts, part, "diffuse", "RGB");
    m.specular = image_of(parts, part, "specular", "RGB");
    m.normal = image_of(parts, part, "normal", "XYZ");
    for (const auto& [name, text] : part.texts)
        if (name.starts_with(kTabulatedMetadata))
            m.metadata.emplace(name.substr(kTabulatedMetadata.size()), text);
}

void read_maps(Parts& parts, TabulatedMaterial& m) {
    ImagePart* part = parts.find("maps");
    if (!part) return;
    if (part->width != m.width || part->height != m.height) {
        throw Error(parts.file(), "maps", fmt::format("{} x {} pixels", m.width, m.height),
                    fmt::format("{} x {}", part->width, part->height));
    }
    for (ImageChannel& channel : part->channels)
        m.maps.emplace(channel.name, std::move(channel.values));
}

}  // namespace

TabulatedMaterial read_tabulated_material(const std::filesystem::path& path) {
    const std::string file = path.string();
    Parts parts(file, read_image_parts(path));
    TabulatedMaterial material;
    read_exemplars(parts, material);
    read_texels(parts, material);
    read_maps(parts, material);
    check_tabulated_material(file, material);
    return material;
}

}  // namespace burnish
