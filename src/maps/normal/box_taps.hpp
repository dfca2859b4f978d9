// The texels of a row that one texel of a smaller row covers, with their weights.
#pragma once

#include <algorithm>

namespace burnish {

struct Taps {
    int first = 0;
    int count = 0;
    double weight[3] = {};
};

// The taps of texel i of `to` texels on a row of `from` texels, 1 <= from / to < 3.
inline Taps taps_of(int i, int from, int to) {
    const double ratio = static_cast<double>(from) / to;
    const double begin = i * ratio, end = (i + 1) * ratio;
    Taps taps;
    taps.first = static_cast<int>(begin);
    for (int j = taps.first; j < from && taps.count < 3; ++j) {
        const double covered = std::min(end, j + 1.0) - std::max(begin, static_cast<double>(j));
        // 1e-9: rounding error of a texel that is not covered.
        if (covered <= 1e-9) break;
        taps.weight[taps.count++] = covered / ratio;
    }
    return taps;
}

}  // namespace burnish
