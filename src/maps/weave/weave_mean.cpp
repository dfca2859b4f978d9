#include "maps/weave/weave_mean.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/parallel.hpp"

namespace burnish {
namespace {

using f32::vec2;
using f32::vec3;

vec2 opposite(vec2 rotation) {
    return {rotation.x, -rotation.y};
}

// The contribution of one slope to the mean at a half vector.
struct Facet {
    f32::Perturbation p;  // in the axes of the fibers
    vec3 n;               // normal for the cosines, in the axes of the yarn
    float weight;
};

std::vector<Facet> facets_of(std::span<const WeaveSlope> slopes, const WeaveLobe& lobe) {
    const bool along_x = f32::lobe_grooves_along_x(lobe.lobe.mdf, lobe.lobe.p0, lobe.lobe.p1);
    std::vector<Facet> facets;
    facets.reserve(slopes.size());
    for (const WeaveSlope& s : slopes) {
        const vec3 n =
            f32::seen_from_rotated(f32::normal_of_slopes(-s.along, -s.across), lobe.twist);
        Facet f;
        f.p = f32::perturb_make(lobe.method, n, along_x, lobe.conserve);
        f.n = f32::seen_from_rotated(f.p.n, opposite(lobe.twist));
        f.weight = s.weight;
        facets.push_back(f);
    }
    return facets;
}

void set_moments(std::span<const Facet> facets, WeaveMean& mean) {
    double xx = 0, yy = 0, z = 0, along = 0, across = 0, sum = 0;
    for (const Facet& f : facets) {
        const double w = f.weight, nx = f.n.x, ny = f.n.y, nz = f.n.z;
        xx += w * nx * nx;
        yy += w * ny * ny;
        z += w * nz;
        along += w * (nx / nz) * (nx / nz);
        across += w * (ny / nz) * (ny / nz);
        sum += w;
    }
    if (!(sum > 0)) return;
    mean.node = {std::sqrt(xx / sum), std::sqrt(yy / sum), z / sum};
    mean.variance = {along / sum, across / sum};
}

// Standard deviations of slopes that scale the table: those of the lobe, alpha^2/2, rotated by the
// twist, and of the surface.
glm::vec2 widths_of(const WeaveLobe& lobe, glm::vec2 variance) {
    const float ax = f32::lobe_alpha_x(lobe.lobe), ay = f32::lobe_alpha_y(lobe.lobe);
    const float c2 = lobe.twist.x * lobe.twist.x, s2 = lobe.twist.y * lobe.twist.y;
    return {std::sqrt(0.5f * (ax * ax * c2 + ay * ay * s2) + variance.x),
            std::sqrt(0.5f * (ax * ax * s2 + ay * ay * c2) + variance.y)};
}

std::array<float, 4> texel_at(std::span<const Facet> facets, const WeaveLobe& lobe, vec3 h,
                              float peak) {
    const vec3 in_fibers = f32::seen_from_rotated(h, lobe.twist);
    double sum = 0, nx = 0, ny = 0;
    for (const Facet& f : facets) {
        const f32::LobePoint q = f32::perturb_point(f.p, in_fibers);
        const auto value =
            static_cast<double>(f.weight * f32::brdf_lobe_factor(lobe.brdf, lobe.lobe, q));
        sum += value;
        nx += value * static_cast<double>(f.n.x);
        ny += value * static_cast<double>(f.n.y);
    }
    if (!(sum > 0)) return {0.0f, 0.0f, 0.0f, 0.0f};
    return {static_cast<float>(sum) / peak, static_cast<float>(nx / sum),
            static_cast<float>(ny / sum), 0.0f};
}

}  // namespace

WeaveMean weave_mean(std::span<const WeaveSlope> slopes, const WeaveLobe& lobe,
                     WeaveDetail detail) {
    const std::vector<Facet> facets = facets_of(slopes, lobe);
    WeaveMean mean;
    set_moments(facets, mean);
    mean.width = widths_of(lobe, mean.variance);
    mean.peak = 1.0f / (2.0f * f32::kPi * mean.width.x * mean.width.y);
    mean.side = weave_table_side(detail);
    const auto side = static_cast<std::size_t>(mean.side);
    mean.table.resize(side * side);
    const auto slope = [side](std::size_t i, float width) {
        const float c = static_cast<float>(2 * i + 1) / static_cast<float>(side) - 1.0f;
        return f32::weave_table_slope(c, width);
    };
    // h and -h have the same mean with mirrored normals, because slopes come in pairs.
    parallel_for(side * side / 2, side, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const vec3 h = f32::normalize(
                vec3(slope(i % side, mean.width.x), slope(i / side, mean.width.y), 1.0f));
            const std::array<float, 4> texel = texel_at(facets, lobe, h, mean.peak);
            mean.table[i] = texel;
            mean.table[side * side - 1 - i] = {texel[0], -texel[1], -texel[2], texel[3]};
        }
    });
    return mean;
}

WeaveMean weave_mean(const WeaveFamily& family, const f32::WeaveShape& shape, const WeaveLobe& lobe,
                     WeaveDetail detail) {
    const float ax = f32::lobe_alpha_x(lobe.lobe), ay = f32::lobe_alpha_y(lobe.lobe);
    const float least = std::min(ax, ay);  // the twist may rotate either axis onto the yarn
    const float across = 2 * shape.bulge / std::sqrt(1 - shape.bulge * shape.bulge);
    const float along = 2 * f32::kPi * shape.crimp;
    // Two steps per alpha, or one. The largest numbers take half a second on two cores, those of a coarse
    // mean a few milliseconds: its table has a ninth of the texels, each the mean over a sixteenth of the
    // slopes.
    const bool full = detail == WeaveDetail::full;
    const auto steps = [&](float range, int most) {
        const float each = full ? 0.5f * least : least;
        return std::clamp(static_cast<int>(std::ceil(range / each)), 4, most);
    };
    const int n = steps(across, full ? 32 : 8), m = steps(along, full ? 24 : 6);
    // Lobes are widened by the variance of a step; otherwise the steps would show for narrow lobes.
    const float da = across / static_cast<float>(n), db = along / static_cast<float>(2 * m);
    WeaveLobe wide = lobe;
    wide.lobe = f32::widen_lobe(lobe.lobe, db * db / 12, da * da / 12);
    return weave_mean(weave_slopes(family, shape, n, m), wide, detail);
}

bool ClothLobe::operator==(const ClothLobe& other) const {
    const auto words = [](const ClothLobe& c) {
        const WeaveLobe& l = c.lobe;
        return std::tuple(c.families.weft.upper, c.families.weft.bends, c.families.warp.upper,
                          c.families.warp.bends, c.shape.crimp, c.shape.bulge, c.shape.gap, l.brdf,
                          l.method, l.conserve, l.twist.x, l.twist.y, l.lobe.mdf, l.lobe.p0,
                          l.lobe.p1, l.lobe.paper_norm, l.lobe.projected_norm);
    };
    return words(*this) == words(other);
}

ClothMeans cloth_means(const ClothLobe& c, WeaveDetail detail) {
    return {weave_mean(c.families.weft, c.shape, c.lobe, detail),
            weave_mean(c.families.warp, c.shape, c.lobe, detail), detail};
}

}  // namespace burnish
