// Materials of every kind of lobe, for the tests of whole surfaces, and a table with what a caller
// of shading/surface looks up in it. Double precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "lobes_under_test.hpp"

namespace burnish::test {

// A table of D on rings x columns, its areas and its draws: GGX at the middles of cells, so that
// values between them are those of no lobe. Areas are Smith's for GGX, which is near enough to what
// the table shows: a test of sampling asks only that they are the same for value and density.
class TableUnderTest {
  public:
    static constexpr int kRings = 12, kColumns = 40, kAreaRings = 16, kAreaColumns = 32;
    static constexpr double kGroove = 0.13;  // turns

    TableUnderTest() {
        const f64::Lobe lobe = f64::lobe_from_alpha(f64::kMdfGgx, 0.3, 0.6);
        const f64::Perturbation flat = f64::perturb_make(f64::kMethodNone, {0, 0, 1}, true, false);
        for (int r = 0; r < kRings; ++r) {
            const double u = (r + 0.5) / kRings;
            for (int a = 0; a < kColumns; ++a) {
                D_.push_back(
                    f64::lobe_D(lobe, flat, direction(u * u * kPi / 2, 2 * kPi * a / kColumns)));
            }
        }
        for (int r = 0; r < kAreaRings; ++r) {
            const double s = static_cast<double>(r) / (kAreaRings - 1);
            for (int a = 0; a < kAreaColumns; ++a) {
                const vec3 w =
                    direction((1 - s * s) * kPi / 2 * 0.9999, 2 * kPi * a / kAreaColumns);
                more_.push_back(w.z * f64::smith_lambda(lobe, w));
            }
        }
        make_draws();
    }

    f64::LobeValues values(const f64::Perturbation& p, vec3 wi, vec3 wo) const {
        const vec3 h = f64::half_vector(wi + wo, p.n);
        f64::LobeValues v;
        const f64::LobePoint q = f64::lobe_point_unit(f64::perturb_point(p, h));
        v.D = q.weight * read(D_, kColumns, kRings, f64::tabulated_row(q, kRings),
                              f64::tabulated_turns(q.x, q.y) + kGroove);
        v.area_i = area(f64::perturb_direction(p, wi));
        v.area_o = area(f64::perturb_direction(p, wo));
        const f64::BasePoints points = f64::base_points(p, h);
        v.density = density(points.at);
        v.density_round = density(points.round);
        return v;
    }

    vec3 half_vector(double along, double across) const {
        const auto ring =
            std::min(std::upper_bound(rings_.begin(), rings_.end(), along) - rings_.begin(),
                     static_cast<std::ptrdiff_t>(kRings - 1));
        const auto first = cells_.begin() + ring * kColumns;
        const auto column = std::min(std::upper_bound(first, first + kColumns, across) - first,
                                     static_cast<std::ptrdiff_t>(kColumns - 1));
        f64::TableDraw draw;
        draw.ring = static_cast<int>(ring);
        draw.column = static_cast<int>(column);
        draw.along = f64::table_draw_part(along, ring > 0 ? rings_[index(ring - 1)] : 0.0,
                                          rings_[index(ring)]);
        draw.across = f64::table_draw_part(across, column > 0 ? *(first + column - 1) : 0.0,
                                           *(first + column));
        return f64::tabulated_half_vector(draw, kColumns, kRings, kGroove);
    }

  private:
    static std::size_t index(std::ptrdiff_t i) { return static_cast<std::size_t>(i); }

    static double read(const std::vector<double>& table, int columns, int rows, double row,
                       double turns) {
        const f64::TablePlace p = f64::table_place(columns, rows, row, turns);
        const auto at = [&](int r, int c) { return table[index(r * columns + c % columns)]; };
        return f64::table_value(p, at(p.row, p.column), at(p.row, p.column + 1),
                                at(p.row + 1, p.column), at(p.row + 1, p.column + 1));
    }

    double area(vec3 w) const {
        const double more =
            read(more_, kAreaColumns, kAreaRings, f64::tabulated_area_row(w, kAreaRings),
                 f64::tabulated_turns(w.x, w.y) + kGroove);
        return f64::tabulated_area(more, w);
    }

    double density(const f64::LobePoint& q) const {
        const f64::TableDraw cell = f64::tabulated_cell(q, kColumns, kRings, kGroove);
        return q.weight * density_[index(cell.ring * kColumns + cell.column)];
    }

    void make_draws() {
        std::vector<double> shares;
        double total = 0;
        for (int r = 0; r < kRings; ++r) {
            const double t0 = r * r * kPi / (2.0 * kRings * kRings);
            const double t1 = (r + 1) * (r + 1) * kPi / (2.0 * kRings * kRings);
            const double angle = (std::cos(t0) - std::cos(t1)) * 2 * kPi / kColumns;
            double ring = 0;
            for (int a = 0; a < kColumns; ++a) {
                // 0.1: nowhere 0, so that every direction that reflects can be drawn.
                const double weight =
                    (D_[index(r * kColumns + a)] + 0.1) * std::max(std::cos((t0 + t1) / 2), 0.05);
                density_.push_back(weight);
                ring += weight * angle;
                cells_.push_back(ring);
            }
            for (int a = 0; a < kColumns; ++a) cells_[index(r * kColumns + a)] /= ring;
            total += ring;
            rings_.push_back(total);
        }
        for (double& share : rings_) share /= total;
        for (double& one : density_) one /= total;
    }

    std::vector<double> D_, more_, rings_, cells_, density_;
};

// A material and what it looks up. p0 and p1: of the lobe.
struct SurfaceCase {
    std::string name;
    f64::SurfaceMaterial material;
    bool grooves_along_x = true;

    bool is_tabulated() const { return material.brdf == f64::kBrdfTabulated; }
};

inline const TableUnderTest& table_under_test() {
    static const TableUnderTest table;
    return table;
}

// The area of ashikhmin-premoze-shirley, of degree one; Smith's masking stands for the integral.
inline double area_of(const f64::Lobe& lobe, vec3 w) {
    const double z = std::max(w.z, 0.0);
    return std::max(z * (1 + f64::smith_lambda(lobe, w)), 1e-6 * f64::length(w));
}

inline f64::LobeValues looked_up(const SurfaceCase& c, const f64::Perturbation& p, vec3 wi,
                                 vec3 wo) {
    if (c.is_tabulated()) return table_under_test().values(p, wi, wo);
    f64::LobeValues v = f64::no_lobe_values();
    if (c.material.brdf == f64::kBrdfAshikhminPremozeShirley) {
        v.area_i = area_of(c.material.lobe, f64::perturb_direction(p, wi));
        v.area_o = area_of(c.material.lobe, f64::perturb_direction(p, wo));
    }
    if (c.material.brdf == f64::kBrdfHe) v.D = 0.3 + 0.2 * f64::dot(wi, wo);  // any value
    return v;
}

// The zero vector where the sample is thrown away.
inline vec3 surface_draw(const SurfaceCase& c, const f64::Perturbation& p, vec3 wo, double xi0,
                         double xi1, double select) {
    bool drawn = false;
    const vec3 half = table_under_test().half_vector(xi1, xi0);
    const vec3 wi = f64::surface_direction(c.material, p, half, wo, {xi0, xi1}, select, drawn);
    return drawn ? wi : vec3{0, 0, 0};
}

inline SurfaceCase surface_case(const std::string& name, int brdf, int mdf, double alpha_x,
                                double alpha_y, double metallic) {
    SurfaceCase c;
    c.name = name;
    const f64::Lobe lobe = f64::lobe_from_alpha(f64::brdf_mdf(brdf, mdf), alpha_x, alpha_y);
    c.grooves_along_x = f64::lobe_grooves_along_x(lobe.mdf, lobe.p0, lobe.p1);
    c.material = f64::surface_material(brdf, lobe, -1.0, {-1.1, -0.9, 0.8}, 0.05);
    c.material.has_diffuse = metallic < 1;
    c.material = f64::surface_colored(c.material, {0.7, 0.5, 0.3}, metallic);
    return c;
}

// Wide enough that quadrature on a fixed grid finds them.
inline std::vector<SurfaceCase> surface_cases() {
    std::vector<SurfaceCase> cases;
    for (int mdf = 0; mdf < static_cast<int>(mdf_names().size()); ++mdf) {
        cases.push_back(surface_case("microfacet " + std::to_string(mdf), f64::kBrdfMicrofacet, mdf,
                                     0.25, 0.6, 0.3));
    }
    cases.push_back(surface_case("metal", f64::kBrdfMicrofacet, f64::kMdfGgx, 0.25, 0.6, 1));
    cases.back().material.fresnel = f64::kFresnelConductor;
    cases.back().material.eta = {0.2, 0.9, 1.4};
    cases.back().material.k = {3.9, 2.4, 1.6};
    cases.push_back(surface_case("film", f64::kBrdfMicrofacet, f64::kMdfGgx, 0.25, 0.6, 1));
    cases.back().material.fresnel = f64::kFresnelCurve;
    f64::FresnelCurve& curve = cases.back().material.curve;
    curve.normal = {0.5, 0.6, 0.9};
    curve.pole = {0.3, -0.2, 0.1};
    curve.pole2 = {0.02, 0.01, -0.03};
    curve.c0 = {0.5, -0.5, 0.1};
    curve.c1 = {-1.0, 1.0, 0.2};
    curve.c2 = {0.5, -1.0, -0.4};
    for (int brdf = f64::kBrdfMicrofacetSeparable; brdf <= f64::kBrdfLafortune; ++brdf) {
        cases.push_back(surface_case("brdf " + std::to_string(brdf), brdf, f64::kMdfGgx, 0.3,
                                     f64::brdf_is_cosine_lobe(brdf) ? 0.3 : 0.55, 0.2));
    }
    cases.push_back(surface_case("tabulated", f64::kBrdfTabulated, f64::kMdfGgx, 0.3, 0.6, 0));
    cases.back().material.fresnel = f64::kFresnelDielectric;
    cases.back().material.eta.x = 1.5;
    cases.back().material.k.x = f64::fresnel_inverse_at_normal(1.5);
    cases.back().material.specular = {0.3, 0.4, 0.5};
    cases.push_back(surface_case("ashikhmin-premoze-shirley", f64::kBrdfAshikhminPremozeShirley, 0,
                                 0.25, 0.5, 0.4));
    cases.push_back(surface_case("he", f64::kBrdfHe, 0, 0.4, 0.4, 0.4));
    return cases;
}

}  // namespace burnish::test
