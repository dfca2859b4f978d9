// Environments with the maps that a renderer draws from, worked out off the frame.
//
// Threads: any number may call these functions at a time, and share what they return. Lifetime: what
// they return refers to nothing else.
#pragma once

#include <memory>

#include "burnish/api.hpp"
#include "burnish/progress.hpp"
#include "burnish/scene.hpp"

namespace BURNISH_API burnish {

// An environment and the maps that a renderer draws from: a cube of radiance with its mips and one
// of irradiance. It never changes, so that several threads and renderers may share it.
struct PreparedEnvironment;

// Works out those maps on the processor; no context is needed, so that a thread of its own may do
// it while frames are drawn. Throws Error for an empty picture, Interrupted when `progress` is
// cancelled.
std::shared_ptr<const PreparedEnvironment> prepare_environment(Environment environment,
                                                               const Progress& progress = {});

}  // namespace burnish
