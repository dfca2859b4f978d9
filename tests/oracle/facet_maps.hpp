// The processes that move the facets of a lobe by a linear map, a second time: from the map M of the surface itself, on
// the vectors that span it. docs/theory/processes.md.
#pragma once

#include <string>

#include "oracle.hpp"

namespace burnish::oracle {

bool moves_facets(const std::string& method);  // slope-shift, stretch

// The normal of a facet whose normal was m, times the factor by which its area grew over that of M's volume.
Vec3 moved_facet(const std::string& method, Vec3 n, Vec3 m);

// The base facet, not unit, that has come to stand at h.
Vec3 unmoved_facet(const std::string& method, Vec3 n, Vec3 h);

// Facets of the displaced plate, a unit of its area, per steradian of h, for one of the base plate at the base facet.
long double facet_density(const std::string& method, Vec3 n, Vec3 h);

// The direction from which the base plate shows the same facets as the displaced one from w. Its z is n~.w.
Vec3 facets_seen(const std::string& method, Vec3 n, Vec3 w);

}  // namespace burnish::oracle
