#include "burnish/rgl_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "burnish/error.hpp"
#include "core/constants.hpp"
#include "formats/bsdf/rgl_brdf.hpp"

namespace burnish {
namespace {

// Rings and azimuths: the resolution of the largest tables of the database.
constexpr NdfGrid kBsdfGrid = {96, 192};

}  // namespace

TabulatedMaterial tabulated_from_bsdf(const std::filesystem::path& path) {
    const RglBrdf brdf = RglBrdf::load(path);
    TabulatedMaterial m;
    m.grid = kBsdfGrid;
    m.exemplars = 1;
    std::size_t best = 0;
    std::vector<double> second(static_cast<std::size_t>(m.grid.azimuths) / 2);
    for (int r = 0; r < m.grid.rings; ++r) {
        const double theta = static_cast<double>(m.grid.theta(r));
        for (int a = 0; a < m.grid.azimuths; ++a) {
            const double D = std::max(brdf.ndf(theta, 2 * kPi * a / m.grid.azimuths), 0.0);
            m.D.push_back(static_cast<float>(D));
            // Mean square slope along each line through the normal.
            second[static_cast<std::size_t>(a) % second.size()] +=
                D * m.grid.solid_angle(r) * std::pow(std::sin(theta), 2);
        }
    }
    const double mass = ndf_mass(m.grid, m.D.data());
    if (!(mass > 0) || !std::isfinite(mass)) {
        throw Error(path.string(), "ndf", "a distribution of normals above the horizon",
                    fmt::format("an integral of {:g}", mass));
    }
    for (float& D : m.D) D = static_cast<float>(static_cast<double>(D) / mass);
    m.origin.assign(m.D.size(), NdfOrigin::measured);
    for (std::size_t i = 0; i < second.size(); ++i)
        if (second[i] > second[best]) best = i;
    // The lobe is widest across the groove: the groove is 90 degrees from there.
    const double across = 2 * kPi * static_cast<double>(best) / m.grid.azimuths;
    m.groove = {brdf.isotropic() ? 0.0F : static_cast<float>(std::fmod(across + kPi / 2, kPi))};
    m.eta = 0;
    m.width = m.height = 1;
    m.exemplar = {0};
    m.angle = {0.0F};
    m.diffuse = Image(1, 1, 3, 0.0F);
    m.specular = Image(1, 1, 3, 1.0F);
    m.normal = Image(1, 1, 3, 0.0F);
    m.normal.at(0, 0)[2] = 1.0F;
    m.metadata["source"] = brdf.description();
    return m;
}

}  // namespace burnish
