#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/even_points.hpp"
#include "viewer/inspect/inspector.hpp"

namespace burnish::viewer {
namespace {

constexpr int kBatches = 16;

// The mean of f cos/pdf over the draws [begin, end) of the even sequence.
glm::dvec3 mean_weight(const PointLobe& lobe, glm::dvec3 to_eye, PointLobe::Terms terms, int begin,
                       int end) {
    const glm::dvec3 n = lobe.normal(to_eye);
    glm::dvec3 sum(0.0);
    for (int i = begin; i < end; ++i) {
        const auto drawn = lobe.sample(to_eye, even_point(i), terms);
        if (!drawn) continue;
        const glm::dvec3 wi = drawn->to_light;
        const glm::dvec3 f =
            terms == PointLobe::Terms::all ? lobe.eval(wi, to_eye) : lobe.specular(wi, to_eye);
        sum += f * (std::max(glm::dot(n, wi), 0.0) / drawn->pdf);
    }
    return sum / static_cast<double>(end - begin);
}

struct Mean {
    glm::dvec3 value{0.0}, error{0.0};
};

Mean mean_of_batches(const PointLobe& lobe, glm::dvec3 to_eye, PointLobe::Terms terms,
                     int samples) {
    const int size = std::max(samples / kBatches, 4);
    std::array<glm::dvec3, kBatches> means{};
    Mean mean;
    for (int b = 0; b < kBatches; ++b) {
        means[static_cast<std::size_t>(b)] =
            mean_weight(lobe, to_eye, terms, b * size, (b + 1) * size);
        mean.value += means[static_cast<std::size_t>(b)] / double{kBatches};
    }
    glm::dvec3 variance(0.0);
    for (const glm::dvec3& m : means) variance += (m - mean.value) * (m - mean.value);
    mean.error = glm::sqrt(variance / double{kBatches * (kBatches - 1)});
    return mean;
}

}  // namespace

LobeAlbedo lobe_albedo(const PointLobe& lobe, glm::dvec3 to_eye, int samples) {
    LobeAlbedo albedo;
    albedo.specular = mean_of_batches(lobe, to_eye, PointLobe::Terms::specular, samples).value;
    const Mean whole = mean_of_batches(lobe, to_eye, PointLobe::Terms::all, samples);
    albedo.whole = whole.value;
    albedo.error = std::max({whole.error.x, whole.error.y, whole.error.z});
    for (int c = 0; c < 3; ++c)
        albedo.gains_energy = albedo.gains_energy || whole.value[c] > 1 + 3 * albedo.error;
    return albedo;
}

}  // namespace burnish::viewer
