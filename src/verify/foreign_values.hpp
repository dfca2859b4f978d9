// Somebody else's values of a BRDF held against ours, and the guess that explains them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "verify/slips.hpp"

namespace burnish::verify {

struct Fit {
    Guess guess;
    double error = 0;  // root mean square of the difference over that of the guess
};

struct Comparison {
    double error = 0;       // as Fit::error, of what was asked for
    std::size_t worst = 0;  // index of the largest difference
    double ours_at_worst = 0;
    double energy_ratio = 0;        // sum of f (n~.wi), theirs over ours; NaN where ours is 0
    bool all_zero = false;          // theirs
    std::size_t brightest = 0;      // index of their largest f (n~.wi)
    std::size_t our_brightest = 0;  // of ours
    Fit fit;
    // Methods that explain the values as well as that of the fit does, which the rows cannot tell from it.
    std::vector<int> alike;
};

// `theirs`: f of each row of `at`, which has at least one.
Comparison compare(const Subject& asked, const Sightings& at, std::span<const double> theirs);

// Largest error of a guess that is called a match, and of one that is called near.
inline constexpr double kMatch = 0.02, kNear = 0.1;

// What is wrong, or that nothing is: sentences without a line end.
std::string verdict(const Subject& asked, const Sightings& at, const Comparison& comparison);

}  // namespace burnish::verify
