#include "jobs/info/info_tabulated.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "burnish/tabulated_file.hpp"
#include "burnish/tabulated_material.hpp"
#include "core/text.hpp"
#include "jobs/info/info_scene.hpp"

namespace burnish {
namespace {

std::array<double, 3> mean_of(const Image& image, const TabulatedMaterial& m, std::size_t seen) {
    std::array<double, 3> sum{};
    for (std::size_t i = 0; i < m.texels(); ++i) {
        if (m.exemplar[i] == TabulatedMaterial::kNoExemplar) continue;
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] += static_cast<double>(image.pixels[3 * i + c]) / static_cast<double>(seen);
    }
    return sum;
}

// Mean tilt of the normals, degrees.
double mean_tilt(const TabulatedMaterial& m, std::size_t seen) {
    double sum = 0;
    for (std::size_t i = 0; i < m.texels(); ++i) {
        if (m.exemplar[i] == TabulatedMaterial::kNoExemplar) continue;
        const float* n = m.normal.pixels.data() + 3 * i;
        sum += std::atan2(std::hypot(n[0], n[1]), n[2]);
    }
    return sum / static_cast<double>(seen) * 180 / std::numbers::pi;
}

std::string describe_exemplar(const TabulatedMaterial& m, int index, std::size_t texels) {
    std::array<std::size_t, 3> of{};
    const auto cells = static_cast<std::size_t>(m.grid.cells());
    const auto first = static_cast<std::size_t>(index) * cells;
    for (std::size_t i = 0; i < cells; ++i) ++of[static_cast<std::size_t>(m.origin[first + i])];
    const auto percent = [&](NdfOrigin origin) {
        return 100.0 * static_cast<double>(of[static_cast<std::size_t>(origin)]) /
               static_cast<double>(cells);
    };
    return fmt::format(
        "  exemplar {}: {}, D {:.4g} at the normal and {:.4g} at most, groove at {:.0f} degrees; "
        "cells {:.0f} % measured, {:.0f} % completed, {:.0f} % extrapolated\n",
        index, plural(texels, "texel"), m.table(index)[0],
        *std::max_element(m.table(index), m.table(index) + cells),
        static_cast<double>(m.groove[static_cast<std::size_t>(index)]) * 180 / std::numbers::pi,
        percent(NdfOrigin::measured), percent(NdfOrigin::completed),
        percent(NdfOrigin::extrapolated));
}

}  // namespace

std::string describe_tabulated(const std::string& path) {
    const TabulatedMaterial m = read_tabulated_material(path);
    std::vector<std::size_t> uses(static_cast<std::size_t>(m.exemplars));
    std::size_t seen = 0;
    for (const std::uint16_t index : m.exemplar) {
        if (index == TabulatedMaterial::kNoExemplar) continue;
        ++seen;
        ++uses[index];
    }
    std::string text = fmt::format("{}: tabulated material, {}x{} texels", path, m.width, m.height);
    if (m.width_mm > 0) text += fmt::format(" of {:g} x {:g} mm", m.width_mm, m.height_mm);
    text += fmt::format(", {} of {} rings x {} azimuths\n",
                        plural(static_cast<std::size_t>(m.exemplars), "exemplar"), m.grid.rings,
                        m.grid.azimuths);
    text += m.eta > 0 ? fmt::format("  Fresnel of refractive index {:g}\n", m.eta)
                      : std::string("  no Fresnel\n");
    if (seen < m.texels())
        text += fmt::format("  {} not measured\n", plural(m.texels() - seen, "texel"));
    if (seen > 0) {
        const auto d = mean_of(m.diffuse, m, seen), s = mean_of(m.specular, m, seen);
        text += fmt::format(
            "  diffuse albedo {:.3f} {:.3f} {:.3f}, specular {:.3f} {:.3f} {:.3f}, "
            "normals tilted by {:.2g} degrees, all on average\n",
            d[0], d[1], d[2], s[0], s[1], s[2], mean_tilt(m, seen));
    }
    // Number of exemplars that fit on a screen.
    constexpr int kShown = 16;
    for (int e = 0; e < std::min(m.exemplars, kShown); ++e)
        text += describe_exemplar(m, e, uses[static_cast<std::size_t>(e)]);
    if (m.exemplars > kShown) text += fmt::format("  and {} more\n", m.exemplars - kShown);
    for (const auto& [name, values] : m.maps) text += fmt::format("  map {}\n", name);
    for (const auto& [name, value] : m.metadata) text += fmt::format("  {}: {}\n", name, value);
    return text;
}

}  // namespace burnish
