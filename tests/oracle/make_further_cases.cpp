#include <algorithm>
#include <cmath>

#include "brdf_directions.hpp"

namespace burnish::oracle {

namespace {

constexpr long double kPi = std::numbers::pi_v<long double>;

std::array<long double, 5> random_lafortune(Random& random) {
    std::array<long double, 5> p{random_share(random), -1, -1, 1, random_lobe(random, true)[0]};
    if (random.chance(0.3L)) return p;  // the mirror lobe, and retro-reflection
    if (random.chance(0.15L)) return {p[0], 1, 1, 1, p[4]};
    for (std::size_t k = 1; k < 4; ++k) p[k] = as_double(random.range(-1, 1));
    return p;
}

std::array<long double, 5> random_he(Random& random) {
    constexpr std::array<long double, 5> kSigmas{0.01L, 0.1L, 0.28L, 1, 5};
    constexpr std::array<long double, 4> kTaus{0.1L, 3, 16, 1000};
    const long double sigma =
        random.chance(0.2L) ? random.pick(kSigmas) : random.log_range(0.001L, 5);
    const long double tau = random.chance(0.2L) ? random.pick(kTaus) : random.log_range(0.1L, 1000);
    return {as_double(sigma), as_double(tau), random_share(random), 0, 0};
}

std::array<long double, 5> random_aps(Random& random) {
    constexpr std::array<std::array<long double, 2>, 5> kPairs{
        {{0, 0}, {1, 1}, {10, 10}, {200, 10}, {10000, 10000}}};
    std::array<long double, 2> e = random_lobe(random, true);
    if (random.chance(0.4L)) e = kPairs[static_cast<std::size_t>(random.range(0, 5))];
    return {e[0], e[1], random_share(random), 0, 0};
}

std::array<long double, 5> random_parameters(Random& random, const std::string& brdf) {
    if (brdf == "lafortune") return random_lafortune(random);
    if (brdf == "he") return random_he(random);
    if (brdf == "ashikhmin-premoze-shirley") return random_aps(random);
    const long double share = random_share(random);
    if (brdf == "phong") return {share, random_lobe(random, true)[0], 0, 0, 0};
    if (brdf == "ashikhmin-shirley-diffuse") return {share, random_share(random), 0, 0, 0};
    const std::array<long double, 2> lobe = random_lobe(random, false);
    if (brdf == "cook-torrance") return {share, lobe[0], random_share(random), 0, 0};
    if (brdf == "ggx-separable") return {lobe[0], lobe[1], share, 0, 0};
    return {share, lobe[0], lobe[1], 0, 0};
}

// A direction about `axis`, as far off as a cosine lobe of this exponent reaches.
Vec3 about(Random& random, Vec3 axis, long double exponent) {
    const Vec3 a = normalize(axis);
    const Vec3 side = fabsl(a.x) < 0.9L ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 s = normalize(cross(a, side));
    const long double spread = sqrtl(2 / (exponent + 2));
    const Vec3 v = sample_lobe(random, false, spread, spread, 1);
    return v.x * s + v.y * cross(a, s) + v.z * a;
}

// v_xy of Gaussian size: term m of the series is sqrt(m) / (pi tau) wide, and g tells which m
// count.
Vec3 he_direction(Random& random, const BrdfCase& c) {
    const long double sigma = c.p[0];
    const long double tau = c.p[1];
    const long double g = powl(4 * kPi * sigma * c.i.z, 2);
    const long double width = sqrtl(std::max(g, 1.0L)) / (kPi * tau);
    const long double r = random.range(0.3L, 2) * width * sqrtl(-logl(1 - random.unit()));
    const long double phi = random.range(0, 2 * kPi);
    const long double x = -c.i.x + r * cosl(phi);
    const long double y = -c.i.y + r * sinl(phi);
    const long double z2 = 1 - x * x - y * y;
    return {x, y, z2 > 0 ? sqrtl(z2) : -1};
}

// A direction in the lobe of i, or below the surface when this try does not hit.
Vec3 lobe_direction(Random& random, const BrdfCase& c) {
    const Vec3 mirror = mirror_of(c.i);
    if (c.brdf == "phong") return about(random, mirror, c.p[1]);
    if (c.brdf == "he") return he_direction(random, c);
    if (c.brdf == "ashikhmin-shirley-diffuse") return random_direction(random);
    if (c.brdf == "lafortune") {
        const Vec3 axis{c.p[1] * c.i.x, c.p[2] * c.i.y, c.p[3] * c.i.z};
        return length(axis) > 0 ? about(random, axis, c.p[4]) : mirror;
    }
    std::array<long double, 2> lobe{c.p[0], c.p[1]};
    if (c.brdf == "ward" || c.brdf == "ward-duer") lobe = {c.p[1], c.p[2]};
    if (c.brdf == "cook-torrance") lobe = {c.p[1], c.p[1]};
    const bool exponents = c.brdf == "ashikhmin-premoze-shirley";
    const Vec3 h = sample_lobe(random, exponents, lobe[0], lobe[1], 1);
    return 2 * dot(h, c.i) * h - c.i;
}

// Scales C to |C i| = 1 where a large exponent would else leave nothing, or overflow.
void brighten(BrdfCase& c) {
    const long double l = length({c.p[1] * c.i.x, c.p[2] * c.i.y, c.p[3] * c.i.z});
    if (c.p[4] <= 20 || l == 0) return;
    for (std::size_t k = 1; k < 4; ++k) c.p[k] = as_double(c.p[k] / l);
    const bool large = std::max({fabsl(c.p[1]), fabsl(c.p[2]), fabsl(c.p[3])}) > 2;
    if (large) c.p = {c.p[0], -1, -1, 1, c.p[4]};
}

constexpr KindShares kShares{0.55L, 0.67L, 0.73L, 0.79L, 0.87L, 0.96L};

void choose_directions(Random& random, BrdfCase& c) {
    choose_i(random, c);
    if (c.brdf == "lafortune") brighten(c);
    choose_o(random, c, kShares, [&] { return lobe_direction(random, c); });
    if (c.brdf == "lafortune") brighten(c);  // i may be another now, and C too bright for it
}

}  // namespace

std::vector<BrdfCase> further_cases(const std::string& brdf, unsigned seed, std::size_t n) {
    Random random(seed);
    std::vector<BrdfCase> cases;
    cases.reserve(n);
    for (std::size_t k = 0; k < n; ++k) {
        BrdfCase c;
        c.brdf = brdf;
        c.p = random_parameters(random, brdf);
        choose_directions(random, c);
        c.i = as_double(rescaled(random, c.i));
        c.o = as_double(rescaled(random, c.o));
        cases.push_back(c);
    }
    return cases;
}

}  // namespace burnish::oracle
