#include "make_cases.hpp"

#include <cmath>

#include "brdf_directions.hpp"
#include "facet_maps.hpp"

namespace burnish::oracle {

namespace {

// Carries v, near the pole, to where the perturbed lobe has it, roughly: the right rotation for
// the rotations, K11 Eq 3-4 for the deformations, somewhere between n and n~ otherwise.
Vec3 carry(Random& random, const MdfCase& c, Vec3 n, Vec3 v) {
    if (c.method == "none") return v;
    if (c.method == "normal-map") return normalize(v + random.range(0, 2) * n);
    if (c.method == "deform-linear" || c.method == "deform-smooth") {
        const long double left = 1 - sqrtl(v.x * v.x + v.y * v.y);
        const long double f = c.method == "deform-linear" ? left : sqrtl(left);
        const Vec3 p{v.x + f * n.x, v.y + f * n.y, 0};
        const long double z2 = 1 - dot(p, p);
        return z2 > 0 ? Vec3{p.x, p.y, sqrtl(z2)} : v;
    }
    if (moves_facets(c.method)) return normalize(moved_facet(c.method, n, v));
    // R v from the columns R^T x, R^T y, R^T z of the map, which is its own inverse's transpose.
    const auto column = [&](Vec3 axis) {
        return dot(mdf_transform(c.mdf, c.p0, c.p1, c.method, n, axis).v, v);
    };
    return normalize({column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})});
}

// One of 24 half vectors in and about the perturbed lobe: with probability in proportion to D, or,
// on the flank, any at which D is not zero.
Vec3 half_vector_in_lobe(Random& random, const MdfCase& c, Vec3 n, bool flank) {
    constexpr int kCandidates = 24;
    const bool exponents = c.mdf == "ashikhmin-shirley";
    Vec3 chosen = n;
    long double total = 0;
    for (int k = 0; k < kCandidates; ++k) {
        const Vec3 v = sample_lobe(random, exponents, c.p0, c.p1, flank ? 2.5L : 1);
        const Vec3 h = carry(random, c, n, v);
        const long double d = mdf_eval(c.mdf, c.p0, c.p1, c.method, n, h).D;
        const long double weight = flank && d > 0 ? 1 : d;
        total += weight;
        if (weight > 0 && random.unit() * total < weight) chosen = h;
    }
    return chosen;
}

Vec3 random_normal(Random& random) {
    const long double u = random.unit();
    if (u < 0.08L) return {0, 0, 1};
    if (u < 0.18L) return tilted_clean(85, random_azimuth(random));
    if (u < 0.28L) return tilted_clean(random.log_range(1e-7L, 1), random_azimuth(random));
    return tilted_clean(random.range(0, 85), random_azimuth(random));
}

void choose_half_vector(Random& random, MdfCase& c) {
    const long double u = random.unit();
    if (u < 0.54L) {
        c.kind = "alive";
        c.h = half_vector_in_lobe(random, c, c.n, false);
    } else if (u < 0.66L) {
        c.kind = "flank";
        c.h = half_vector_in_lobe(random, c, c.n, true);
    } else if (u < 0.77L) {
        c.kind = "far";
        c.h = random_direction(random);
        if (random.chance(0.7L)) c.h.z = fabsl(c.h.z);
    } else if (u < 0.82L) {
        c.kind = "pole";
        c.h = {0, 0, 1};
    } else if (u < 0.88L) {
        c.kind = "peak";
        c.h = c.n;
    } else if (u < 0.97L) {
        c.kind = "grazing";
        c.h = grazing_direction(random);
    } else {
        c.kind = "below";
        c.h = random_direction(random);
        c.h.z = -fabsl(c.h.z) - 1e-3L;
        c.h = normalize(c.h);
    }
}

}  // namespace

std::vector<MdfCase> mdf_cases(unsigned seed, std::size_t n) {
    const std::vector<std::string>& mdfs = mdf_names();
    const std::vector<std::string>& methods = method_names();
    Random random(seed);
    std::vector<MdfCase> cases;
    cases.reserve(n);
    for (std::size_t k = 0; k < n; ++k) {
        MdfCase c;
        c.mdf = mdfs[k % mdfs.size()];
        c.method = methods[k / mdfs.size() % methods.size()];
        const auto p = random_lobe(random, c.mdf == "ashikhmin-shirley");
        c.p0 = p[0];
        c.p1 = p[1];
        c.n = as_double(random_normal(random));
        choose_half_vector(random, c);
        c.n = as_double(rescaled(random, c.n));
        c.h = as_double(rescaled(random, c.h));
        cases.push_back(c);
    }
    return cases;
}

namespace {

std::array<long double, 5> random_brdf(Random& random, const std::string& brdf) {
    const auto lobe = random_lobe(random, brdf == "ashikhmin-shirley");
    const long double share = random_share(random);
    if (brdf == "ward-gmd") return {share, lobe[0], lobe[1], 0, 0};
    return {lobe[0], lobe[1], share, 0, 0};
}

// o = 2 (h.i) h - i for an h of the lobe.
Vec3 reflect_in_lobe(Random& random, const BrdfCase& c) {
    const std::size_t first = c.brdf == "ward-gmd" ? 1 : 0;
    const Vec3 h =
        sample_lobe(random, c.brdf == "ashikhmin-shirley", c.p[first], c.p[first + 1], 1);
    return 2 * dot(h, c.i) * h - c.i;
}

// None skims.
constexpr KindShares kShares{0.55L, 0.7L, 0.77L, 0.83L, 0.95L, 0.95L};

}  // namespace

std::vector<BrdfCase> brdf_cases(unsigned seed, std::size_t n) {
    const std::vector<std::string>& brdfs = brdf_names();
    Random random(seed);
    std::vector<BrdfCase> cases;
    cases.reserve(n);
    for (std::size_t k = 0; k < n; ++k) {
        BrdfCase c;
        c.brdf = brdfs[k % brdfs.size()];
        c.p = random_brdf(random, c.brdf);
        choose_i(random, c);
        choose_o(random, c, kShares, [&] { return reflect_in_lobe(random, c); });
        c.i = as_double(rescaled(random, c.i));
        c.o = as_double(rescaled(random, c.o));
        cases.push_back(c);
    }
    return cases;
}

}  // namespace burnish::oracle
