// What every reader of models promises of a scene that it returns.
#pragma once

#include "burnish/scene.hpp"

namespace burnish::fuzz {

// Ends the process (see broken) for an index out of range, a number that is not finite, an
// attribute of another length than the positions, or a texture whose texels are not as many as it
// says.
void expect_sound(const Scene& scene);

}  // namespace burnish::fuzz
