// The pairs of directions of make_cases.hpp, for every model: for the sources of the generators.

#pragma once

#include <cmath>
#include <utility>

#include "make_cases.hpp"
#include "random_inputs.hpp"

namespace burnish::oracle {

// Up to where a number from [0, 1) means each kind; what is left is `below`.
struct KindShares {
    long double alive, far, mirror, retro, grazing, skimming;
};

inline void choose_i(Random& random, BrdfCase& c) {
    c.i = as_double(tilted_clean(random.range(0, 89.9L), random_azimuth(random)));
    if (random.chance(0.05L)) c.i = {0, 0, 1};
}

inline Vec3 mirror_of(Vec3 i) {
    return {-i.x, -i.y, i.z};
}

inline void choose_skimming(Random& random, BrdfCase& c) {
    const auto skim = [&] { return tilted_clean(89.9L, random_azimuth(random)); };
    if (random.chance(0.6L)) c.i = as_double(skim());
    c.o = random.chance(0.5L) ? mirror_of(c.i) : skim();
}

// o, and for some kinds i again. `in_lobe()`: a direction in the lobe of c.i, below the surface
// when this try does not hit; the mirror direction if the surface hides all the tries.
template <typename InLobe>
void choose_o(Random& random, BrdfCase& c, const KindShares& shares, const InLobe& in_lobe) {
    const long double u = random.unit();
    c.o = mirror_of(c.i);
    if (u < shares.alive) {
        c.kind = "alive";
        for (int k = 0; k < 16; ++k) {
            const Vec3 o = in_lobe();
            if (o.z <= 0) continue;
            c.o = o;
            break;
        }
    } else if (u < shares.far) {
        c.kind = "far";
        c.o = random_direction(random);
        c.o.z = fabsl(c.o.z);
    } else if (u < shares.mirror) {
        c.kind = "mirror";
    } else if (u < shares.retro) {
        c.kind = "retro";
        c.o = c.i;
    } else if (u < shares.grazing) {
        c.kind = "grazing";
        if (random.chance(0.3L)) c.i = as_double(grazing_direction(random));
        c.o = grazing_direction(random);
    } else if (u < shares.skimming) {
        c.kind = "skimming";
        choose_skimming(random, c);
    } else {
        c.kind = "below";
        c.o = random_direction(random);
        c.o.z = -fabsl(c.o.z) - 1e-3L;
        c.o = normalize(c.o);
        if (random.chance(0.5L)) std::swap(c.i, c.o);
    }
}

}  // namespace burnish::oracle
