#include "scene/camera/pixel_offsets.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <numeric>

namespace burnish {
namespace {

// The whole number nearest to count / golden ratio that has no divisor in common with `count`, `step`
// apart from one candidate to the next: 2 looks among odd numbers alone.
std::int64_t golden_stride(std::int64_t count, std::int64_t step) {
    constexpr double kGolden = 0.6180339887498949;
    const std::int64_t middle = std::llround(static_cast<double>(count) * kGolden);
    const std::int64_t first = step == 2 ? middle | 1 : middle;
    for (std::int64_t away = 0;; away += step) {
        if (first - away >= 1 && std::gcd(first - away, count) == 1) return first - away;
        if (std::gcd(first + away, count) == 1) return first + away;
    }
}

// The inverse of the tent's cumulative distribution.
double tent(double u) {
    return u < 0.5 ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 * (1 - u));
}

// The first half of the points in the middles of n x n cells, one in each row and each column; the rest
// are their mirror images.
std::vector<glm::dvec2> half_of_points(std::int64_t n) {
    // A lattice of one generator. An odd generator makes point n - 1 - i the mirror image of point i.
    // Such lattices of 4 and 6 points lie near a diagonal, so these are lattices of a point more,
    // without the one at the corner.
    const bool one_more = n == 4 || n == 6;
    const std::int64_t generator = one_more ? golden_stride(n + 1, 1) : golden_stride(n, 2);
    const auto tent_of = [n](std::int64_t twice) {
        return tent(static_cast<double>(twice) / static_cast<double>(2 * n));
    };
    std::vector<glm::dvec2> half;
    for (std::int64_t i = 0; i < n / 2; ++i) {
        const std::int64_t twice =
            one_more ? 2 * (generator * (i + 1) % (n + 1)) - 1 : generator * (2 * i + 1) % (2 * n);
        half.emplace_back(tent_of(2 * i + 1), tent_of(twice));
    }
    return half;
}

}  // namespace

std::vector<glm::dvec2> pixel_offsets(int count) {
    const std::int64_t n = count;
    const std::vector<glm::dvec2> half = half_of_points(n);
    std::vector<glm::dvec2> offsets;
    if (n % 2 == 1) offsets.emplace_back(0.0, 0.0);
    if (half.empty()) return offsets;
    // The pair nearest to the middle comes first, so that a picture of one sample is hardly displaced.
    // The steps to the others spread the first few over the whole half.
    std::size_t place = 0;
    for (std::size_t i = 1; i < half.size(); ++i)
        if (glm::length(half[i]) < glm::length(half[place])) place = i;
    const auto stride =
        static_cast<std::size_t>(golden_stride(static_cast<std::int64_t>(half.size()), 1));
    for (std::size_t k = 0; k < half.size(); ++k, place = (place + stride) % half.size()) {
        offsets.push_back(half[place]);
        offsets.push_back(-half[place]);
    }
    return offsets;
}

}  // namespace burnish
