#include "tabulate_sample.hpp"

#include <cmath>

#include "core/constants.hpp"

namespace burnish::test {

namespace {

void append_table(const VirtualNdf& ndf, const NdfGrid& grid, std::vector<float>& to) {
    const std::size_t first = to.size();
    for (int ring = 0; ring < grid.rings; ++ring)
        for (int column = 0; column < grid.azimuths; ++column) {
            const double u = (ring + 0.5) / grid.rings, theta = u * u * kPi / 2;
            const double phi = 2 * kPi * column / grid.azimuths;
            to.push_back(
                static_cast<float>(ndf.D({std::sin(theta) * std::cos(phi),
                                          std::sin(theta) * std::sin(phi), std::cos(theta)})));
        }
    const auto scale = static_cast<float>(1.0 / ndf_mass(grid, to.data() + first));
    for (std::size_t i = first; i < to.size(); ++i) to[i] *= scale;
}

}  // namespace

TabulatedMaterial tabulated(const VirtualSample& sample, const NdfGrid& grid) {
    TabulatedMaterial m;
    m.grid = grid;
    m.exemplars = static_cast<int>(sample.ndfs.size());
    for (const VirtualNdf& ndf : sample.ndfs) append_table(ndf, grid, m.D);
    m.origin.assign(m.D.size(), NdfOrigin::measured);
    m.groove.assign(sample.ndfs.size(), 0.0f);
    m.eta = sample.eta;
    m.width = sample.width;
    m.height = sample.height;
    m.width_mm = sample.width_mm;
    m.height_mm = sample.height_mm;
    m.diffuse = m.specular = m.normal = Image(m.width, m.height, 3);
    for (std::size_t t = 0; t < m.texels(); ++t) {
        const VirtualTexel& texel = sample.texels[t];
        m.exemplar.push_back(static_cast<std::uint16_t>(texel.ndf));
        m.angle.push_back(static_cast<float>(texel.grain));
        for (std::size_t c = 0; c < 3; ++c) {
            m.diffuse.pixels[3 * t + c] = static_cast<float>(texel.diffuse[c]);
            m.specular.pixels[3 * t + c] = static_cast<float>(texel.specular[c]);
            m.normal.pixels[3 * t + c] = static_cast<float>(texel.normal[c]);
        }
    }
    return m;
}

}  // namespace burnish::test
