#include "bench/frame/frame_tabulated.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "burnish/f64.hpp"

namespace burnish {

namespace {

constexpr int kSide = 64;  // texels
constexpr double kTurn = 2 * std::numbers::pi;

// A mixture of two GGX lobes, rotated together by `turn`; grooves along x before the rotation.
struct TwoLobes {
    double share;
    std::array<double, 2> first, second;  // alphas
    double turn;                          // radians
};

// About as wide as the steel of the other techniques.
constexpr std::array<TwoLobes, 4> kExemplars = {{
    {1.0, {0.10, 0.40}, {0.10, 0.40}, 0.0},
    {1.0, {0.14, 0.35}, {0.14, 0.35}, 0.6},
    {0.7, {0.10, 0.40}, {0.40, 0.60}, 0.0},
    {0.5, {0.15, 0.30}, {0.30, 0.80}, 2.1},
}};

double ggx(const std::array<double, 2>& alpha, const f64::vec3& h) {
    static const f64::Perturbation flat =
        f64::perturb_make(f64::kMethodNone, {0, 0, 1}, true, false);
    return f64::lobe_D(f64::lobe_from_alpha(f64::kMdfGgx, alpha[0], alpha[1]), flat, h);
}

void add_exemplar(TabulatedMaterial& m, const TwoLobes& lobes) {
    std::vector<float> table;
    for (int r = 0; r < m.grid.rings; ++r) {
        const double theta = static_cast<double>(m.grid.theta(r));
        for (int a = 0; a < m.grid.azimuths; ++a) {
            const double phi = kTurn * a / m.grid.azimuths - lobes.turn;
            const f64::vec3 h(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                              std::cos(theta));
            table.push_back(static_cast<float>(lobes.share * ggx(lobes.first, h) +
                                               (1 - lobes.share) * ggx(lobes.second, h)));
        }
    }
    const auto mass = static_cast<float>(ndf_mass(m.grid, table.data()));
    for (const float D : table) m.D.push_back(D / mass);
    m.origin.resize(m.D.size(), NdfOrigin::measured);
    m.groove.push_back(static_cast<float>(lobes.turn));
    ++m.exemplars;
}

// Metal with little diffuse light; all texels use exemplar 0, flat and without rotation.
void lay_texels(TabulatedMaterial& m, int side) {
    m.width = m.height = side;
    m.exemplar.assign(m.texels(), 0);
    m.angle.assign(m.texels(), 0.0F);
    m.diffuse = Image(side, side, 3, 0.05F);
    m.specular = Image(side, side, 3, 0.55F);
    m.normal = Image(side, side, 3);
    for (std::size_t i = 0; i < m.texels(); ++i) m.normal.pixels[3 * i + 2] = 1.0F;
}

// Varies a texel's parameters periodically, without seams where the texture repeats.
void vary_texel(TabulatedMaterial& m, int x, int y) {
    const double u = kTurn * (x + 0.5) / kSide, v = kTurn * (y + 0.5) / kSide;
    const auto i = static_cast<std::size_t>(y * kSide + x);
    m.angle[i] = static_cast<float>(0.5 * std::sin(u) + 0.7 * std::cos(v));
    const double slope_x = 0.08 * std::cos(5 * u), slope_y = 0.08 * std::sin(3 * v);
    const double length = std::sqrt(1 + slope_x * slope_x + slope_y * slope_y);
    float* n = m.normal.at(x, y);
    n[0] = static_cast<float>(-slope_x / length);
    n[1] = static_cast<float>(-slope_y / length);
    n[2] = static_cast<float>(1 / length);
    for (int c = 0; c < 3; ++c)
        m.specular.at(x, y)[c] = static_cast<float>(0.55 + 0.1 * std::sin(u + v + c));
}

}  // namespace

TabulatedMaterial bench_material_of_texels() {
    TabulatedMaterial m;
    for (const TwoLobes& lobes : kExemplars) add_exemplar(m, lobes);
    lay_texels(m, kSide);
    std::mt19937 random(1);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            m.exemplar[static_cast<std::size_t>(y * kSide + x)] =
                static_cast<std::uint16_t>(random() % kExemplars.size());
            vary_texel(m, x, y);
        }
    }
    return m;
}

TabulatedMaterial bench_material_of_one() {
    TabulatedMaterial m;
    add_exemplar(m, kExemplars[0]);
    lay_texels(m, 1);
    return m;
}

}  // namespace burnish
