#include "formats/tabulated/tabulated_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "burnish/error.hpp"
#include "formats/tabulated/tabulated_parts.hpp"

namespace burnish {
namespace {

// Checks every value of a channel; `width` is that of the picture, for the position in messages.
void require_range(const std::string& file, const std::string& place, std::span<const float> values,
                   float low, float high, std::size_t width) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] >= low && values[i] <= high) continue;  // written so that NaN fails
        throw Error(file, place, fmt::format("numbers from {:g} to {:g}", low, high),
                    fmt::format("{:g} at ({}, {})", values[i], i % width, i / width));
    }
}

void require_count(const std::string& file, const std::string& place, std::size_t count,
                   std::size_t expected) {
    if (count == expected) return;
    throw Error(file, place, fmt::format("{} values", expected), std::to_string(count));
}

void check_sizes(const std::string& file, const TabulatedMaterial& m) {
    const auto within = [&](const char* key, int value, int low, int high) {
        if (value >= low && value <= high) return;
        throw Error(file, key, fmt::format("{} to {}", low, high), std::to_string(value));
    };
    within("rings", m.grid.rings, 2, kMostRings);
    within("azimuths", m.grid.azimuths, 4, kMostAzimuths);
    within("exemplars", m.exemplars, 1, kMostExemplars);
    within("width", m.width, 1, kMostAtlasSide);
    within("height", m.height, 1, kMostAtlasSide);
    check_cells(file, m.grid, m.exemplars);
    const TabulatedAtlas atlas = tabulated_atlas(m.grid, m.exemplars);
    if (atlas.width() > kMostAtlasSide || atlas.height() > kMostAtlasSide) {
        throw Error(file, "exemplars",
                    fmt::format("tables that fit {} x {}", kMostAtlasSide, kMostAtlasSide),
                    fmt::format("{} of {} x {}", m.exemplars, m.grid.azimuths, m.grid.rings));
    }
    if (!(m.eta == 0 || (m.eta >= 1.01 && m.eta <= 100)))
        throw Error(file, "eta", "0, or 1.01 to 100", fmt::format("{:g}", m.eta));
    for (const double side : {m.width_mm, m.height_mm})
        if (!(side >= 0 && side <= 1e9))
            throw Error(file, "width_mm, height_mm", "0 to 1e9", fmt::format("{:g}", side));
}

void check_exemplars(const std::string& file, const TabulatedMaterial& m) {
    const auto cells = static_cast<std::size_t>(m.grid.cells());
    const auto count = static_cast<std::size_t>(m.exemplars);
    require_count(file, "exemplars: D", m.D.size(), count * cells);
    require_count(file, "exemplars: origin", m.origin.size(), count * cells);
    require_count(file, "exemplars: groove", m.groove.size(), count);
    require_range(file, "exemplars: D", m.D, 0, kMostDistribution,
                  static_cast<std::size_t>(m.grid.azimuths));
    require_range(file, "exemplars: groove", m.groove, -2 * std::numbers::pi_v<float>,
                  2 * std::numbers::pi_v<float>, count);
    for (int e = 0; e < m.exemplars; ++e) {
        const double mass = ndf_mass(m.grid, m.table(e));
        if (std::fabs(mass - 1) <= kMassTolerance) continue;
        throw Error(file, fmt::format("exemplar {}", e),
                    fmt::format("an integral of D cos within {:g} of 1", kMassTolerance),
                    fmt::format("{:g}", mass));
    }
}

void check_image(const std::string& file, const char* name, const Image& image,
                 const TabulatedMaterial& m, float low, float high) {
    const std::string place = fmt::format("texels: {}", name);
    if (image.width != m.width || image.height != m.height || image.channels != 3) {
        throw Error(file, place, fmt::format("{} x {} of 3 channels", m.width, m.height),
                    fmt::format("{} x {} of {}", image.width, image.height, image.channels));
    }
    require_count(file, place, image.pixels.size(), 3 * m.texels());
    require_range(file, place, image.pixels, low, high, 3 * static_cast<std::size_t>(m.width));
}

// 1e-2: tolerance of unit length after storage as half floats or filtering.
void check_normals(const std::string& file, const TabulatedMaterial& m) {
    for (std::size_t i = 0; i < m.texels(); ++i) {
        const float* n = m.normal.pixels.data() + 3 * i;
        const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        if (std::fabs(length - 1) <= 1e-2F && n[2] > 0) continue;
        const auto width = static_cast<std::size_t>(m.width);
        throw Error(
            file, "texels: normal", "unit vectors with z above 0",
            fmt::format("({:g}, {:g}, {:g}) at ({}, {})", n[0], n[1], n[2], i % width, i / width));
    }
}

void check_texels(const std::string& file, const TabulatedMaterial& m) {
    require_count(file, "texels: exemplar", m.exemplar.size(), m.texels());
    require_count(file, "texels: angle", m.angle.size(), m.texels());
    const auto width = static_cast<std::size_t>(m.width);
    for (std::size_t i = 0; i < m.exemplar.size(); ++i) {
        if (m.exemplar[i] == TabulatedMaterial::kNoExemplar || m.exemplar[i] < m.exemplars)
            continue;
        throw Error(file, "texels: exemplar", fmt::format("-1, or 0 to {}", m.exemplars - 1),
                    fmt::format("{} at ({}, {})", m.exemplar[i], i % width, i / width));
    }
    // 1000 rad is more than a hundred turns; beyond, single precision cannot resolve 1e-4 rad.
    require_range(file, "texels: angle", m.angle, -1000, 1000, width);
    check_image(file, "diffuse", m.diffuse, m, 0, kMostColor);
    check_image(file, "specular", m.specular, m, 0, kMostColor);
    check_image(file, "normal", m.normal, m, -1.1F, 1.1F);
    check_normals(file, m);
    for (const auto& [name, values] : m.maps) {
        require_count(file, "maps: " + name, values.size(), m.texels());
        require_range(file, "maps: " + name, values, -1e30F, 1e30F, width);
    }
}

}  // namespace

void check_tabulated_material(const std::string& file, const TabulatedMaterial& material) {
    check_sizes(file, material);
    check_exemplars(file, material);
    check_texels(file, material);
}

}  // namespace burnish
