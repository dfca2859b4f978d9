#include "capture/solve/training_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burnish {

namespace {

// Upper bound of the memory of training values in bytes, also for a requested number of points.
constexpr std::size_t kMostBytes = std::size_t{256} << 20;
// Default number of training points. A tenth of them gave the figures of
// docs/evidence/capture-results.md.
constexpr std::size_t kUsualPoints = 8192;
// Upper bound of the samples of the default number of points: the time to find exemplars is
// proportional to them.
constexpr std::size_t kUsualSamples = 4000000;
// Least number of points, for any number of lights.
constexpr std::size_t kFewest = 16;

// Chooses pixels spread evenly over the mask.
std::vector<std::size_t> spread_pixels(const ImageStack& stack, int wanted) {
    std::vector<std::size_t> all;
    for (std::size_t p = 0; p < stack.pixels(); ++p)
        if (stack.mask()[p]) all.push_back(p);
    const std::size_t fits =
        std::max<std::size_t>(kMostBytes / (3 * sizeof(float) * stack.lights()), kFewest);
    const std::size_t asked =
        wanted > 0 ? static_cast<std::size_t>(wanted)
                   : std::min(kUsualPoints,
                              std::max<std::size_t>(kUsualSamples / stack.lights(), kFewest));
    const std::size_t most = std::min({asked, all.size(), fits});
    if (most == all.size()) return all;
    std::vector<std::size_t> chosen(most);
    const double step = static_cast<double>(all.size()) / static_cast<double>(most);
    for (std::size_t k = 0; k < most; ++k) {
        // Multiples of an irrational number avoid aliasing with the rows of the picture.
        const double jitter = std::fmod(static_cast<double>(k) * std::numbers::phi, 1.0);
        const auto at = static_cast<std::size_t>((static_cast<double>(k) + jitter) * step);
        chosen[k] = all[std::min(all.size() - 1, at)];
    }
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

}  // namespace

TrainingPoints some_of(const TrainingPoints& points, std::size_t most, std::size_t lights) {
    const std::size_t all = points.pixels.size(), count = std::min(all, most);
    const std::size_t per_point = 3 * lights;
    TrainingPoints out;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t p = k * all / count;
        out.pixels.push_back(points.pixels[p]);
        const auto from = points.values.begin() + static_cast<std::ptrdiff_t>(p * per_point);
        out.values.insert(out.values.end(), from, from + static_cast<std::ptrdiff_t>(per_point));
    }
    return out;
}

TrainingPoints training_points(const ImageStack& stack, int wanted, const Progress& progress) {
    TrainingPoints out;
    out.pixels = spread_pixels(stack, wanted);
    const std::size_t per_point = 3 * stack.lights();
    out.values.resize(out.pixels.size() * per_point);
    std::size_t next = 0;
    for (std::size_t b = 0; b < stack.bands() && next < out.pixels.size(); ++b) {
        progress.step("training points",
                      static_cast<double>(b) / static_cast<double>(stack.bands()));
        const std::size_t end = std::min((b + 1) * stack.band_pixels(), stack.pixels());
        if (out.pixels[next] >= end) continue;
        const StackBand band = stack.load(b);
        for (; next < out.pixels.size() && out.pixels[next] < end; ++next)
            stack.decode(band, out.pixels[next] - band.first, 1,
                         out.values.data() + next * per_point);
    }
    return out;
}

}  // namespace burnish
