// Tabulated materials made in code, and their reflection by a second derivation: tables are
// interpolated and integrated here in double, without src/scene/ndf_grid.cpp or shaders/.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

#include "burnish/f64.hpp"
#include "burnish/tabulated_material.hpp"

namespace burnish::test {

inline constexpr double kPiD = std::numbers::pi;

inline f64::vec3 direction_of(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// One table with bilinear interpolation in (u, phi), and its parts for integrals.
class ReferenceTable {
  public:
    ReferenceTable(const NdfGrid& grid, const float* table) : grid_(grid), table_(table) {
        const int rings = 4 * grid.rings, around = 3 * grid.azimuths;
        for (int r = 0; r < rings; ++r) {
            const double t0 = theta_at(static_cast<double>(r) / rings);
            const double t1 = theta_at(static_cast<double>(r + 1) / rings);
            const double cap = std::cos(t0) - std::cos(t1);
            for (int a = 0; a < around; ++a) {
                const f64::vec3 h = direction_of((t0 + t1) / 2, 2 * kPiD * a / around);
                parts_.push_back(
                    {h, at((r + 0.5) / rings, 2 * kPiD * a / around) * cap * 2 * kPiD / around});
            }
        }
    }

    double at(double u, double phi) const {
        const double row = std::clamp(u * grid_.rings - 0.5, 0.0, grid_.rings - 1.0);
        const double turns = phi / (2 * kPiD);
        const double column = (turns - std::floor(turns)) * grid_.azimuths;
        const int r = std::min(static_cast<int>(row), grid_.rings - 2);
        const int c = static_cast<int>(column) % grid_.azimuths;
        const auto cell = [&](int ring, int azimuth) {
            return static_cast<double>(table_[ring * grid_.azimuths + azimuth % grid_.azimuths]);
        };
        const double t = column - std::floor(column), s = row - r;
        return (1 - s) * ((1 - t) * cell(r, c) + t * cell(r, c + 1)) +
               s * ((1 - t) * cell(r + 1, c) + t * cell(r + 1, c + 1));
    }

    // |w| g(w / |w|).
    double area(f64::vec3 w) const {
        double sum = 0;
        for (const auto& [h, amount] : parts_) sum += std::max(f64::dot(h, w), 0.0) * amount;
        return sum;
    }

  private:
    static double theta_at(double u) { return kPiD / 2 * u * u; }
    NdfGrid grid_;
    const float* table_;
    std::vector<std::pair<f64::vec3, double>> parts_;
};

// A GGX lobe as a table, normalized to a mass of 1 by the parts of the reference.
inline std::vector<float> ggx_table(const NdfGrid& grid, double alpha_x, double alpha_y,
                                    double turn = 0) {
    const f64::Lobe lobe = f64::lobe_from_alpha(f64::kMdfGgx, alpha_x, alpha_y);
    const f64::Perturbation p = f64::perturb_make(f64::kMethodNone, {0, 0, 1}, true, false);
    std::vector<float> table;
    for (int r = 0; r < grid.rings; ++r)
        for (int a = 0; a < grid.azimuths; ++a)
            table.push_back(
                static_cast<float>(f64::lobe_D(lobe, p,
                                               direction_of(static_cast<double>(grid.theta(r)),
                                                            2 * kPiD * a / grid.azimuths - turn))));
    const double mass = ReferenceTable(grid, table.data()).area({0, 0, 1});
    for (float& D : table) D = static_cast<float>(static_cast<double>(D) / mass);
    return table;
}

// A flat, black material of width x height texels without exemplars.
inline TabulatedMaterial blank_material(const NdfGrid& grid, int width, int height) {
    TabulatedMaterial m;
    m.grid = grid;
    m.eta = 0;
    m.width = width;
    m.height = height;
    m.exemplar.assign(m.texels(), 0);
    m.angle.assign(m.texels(), 0.0F);
    m.diffuse = Image(width, height, 3);
    m.specular = Image(width, height, 3, 1.0F);
    m.normal = Image(width, height, 3);
    for (std::size_t i = 0; i < m.texels(); ++i) m.normal.pixels[3 * i + 2] = 1;
    return m;
}

inline void add_exemplar(TabulatedMaterial& m, const std::vector<float>& table, float groove) {
    m.D.insert(m.D.end(), table.begin(), table.end());
    m.origin.resize(m.D.size(), NdfOrigin::measured);
    m.groove.push_back(groove);
    ++m.exemplars;
}

// f cos of one texel, green channel: radiance under unit irradiance from wi, times the cosine.
inline double reflected_by_texel(const TabulatedMaterial& m, const ReferenceTable& table,
                                 std::size_t texel, int method, f64::vec3 wi, f64::vec3 wo) {
    const std::size_t exemplar = m.exemplar[texel];
    const double groove =
        method == f64::kMethodFollowGrain ? static_cast<double>(m.groove[exemplar]) : 0.0;
    const double turn = static_cast<double>(m.angle[texel]) + groove;
    const auto turned = [&](f64::vec3 v) {
        return f64::vec3(v.x * std::cos(turn) + v.y * std::sin(turn),
                         v.y * std::cos(turn) - v.x * std::sin(turn), v.z);
    };
    const float* n = m.normal.pixels.data() + 3 * texel;
    const f64::vec3 normal =
        turned({static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])});
    const f64::Perturbation p = f64::perturb_make(method, normal, true, false);
    const f64::vec3 i = turned(wi), o = turned(wo);
    const double cos_i = f64::dot(p.n, i), cos_o = f64::dot(p.n, o);
    if (cos_i <= 0 || cos_o <= 0) return 0;
    const f64::vec3 h = f64::normalize(i + o);
    const f64::LobePoint q = f64::lobe_point_unit(f64::perturb_point(p, h));
    const double u = std::sqrt(2 / kPiD * std::atan2(std::sqrt(q.s2), q.z));
    const double D = q.weight * table.at(u, std::atan2(q.y, q.x) + groove);
    const auto in_table = [&](f64::vec3 w) {
        const f64::vec3 v = f64::perturb_direction(p, w);
        return f64::vec3(v.x * std::cos(groove) - v.y * std::sin(groove),
                         v.y * std::cos(groove) + v.x * std::sin(groove), v.z);
    };
    double fresnel = 1;
    if (m.eta > 0) {
        fresnel = f64::fresnel_conductor(m.eta, 0.0, f64::dot(i, h)) /
                  f64::fresnel_conductor(m.eta, 0.0, 1.0);
    }
    const double specular = static_cast<double>(m.specular.pixels[3 * texel + 1]) * fresnel * D /
                            (4 * table.area(in_table(i)) * table.area(in_table(o)));
    return (static_cast<double>(m.diffuse.pixels[3 * texel + 1]) / kPiD + specular) * cos_i;
}

}  // namespace burnish::test
