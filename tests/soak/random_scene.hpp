// Scenes drawn at random: parameters from the one table within its ranges, textures with texels of
// any bit pattern, lights, cameras; and scenes that are broken on purpose.
#pragma once

#include <random>
#include <string>

#include "burnish/stage.hpp"

namespace burnish::soak {

using Random = std::mt19937_64;

// One of the `count` numbers from 0.
inline std::size_t below(Random& random, std::size_t count) {
    return static_cast<std::size_t>(random() % count);
}
inline bool one_in(Random& random, std::size_t count) {
    return below(random, count) == 0;
}
double between(Random& random, double low, double high);

// A stage of a built-in mesh, small and quick to draw.
Stage random_stage(Random& random);

// What a renderer takes without being made anew: other methods and models, for which it compiles
// shaders; other factors, another camera, other numbers, which cost nothing.
void change_models(Stage& stage, Random& random);
void change_numbers(Stage& stage, Random& random);

Environment random_environment(Random& random);

// Breaks the scene, the camera or the options in one of the ways that must be refused. Returns the
// name of the way.
std::string break_stage(Stage& stage, Random& random);

// A parameter and a text that is no value of it.
struct BadValue {
    std::string name, text;
};
BadValue bad_value(Random& random);

}  // namespace burnish::soak
