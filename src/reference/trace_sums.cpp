#include "reference/trace_sums.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "burnish/error.hpp"
#include "burnish/f32.hpp"
#include "burnish/f64.hpp"
#include "core/index_of.hpp"
#include "rays/vectors.hpp"

namespace burnish {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr double kUnit = 0x1p-27;
// Depths are held to this: 2^20 samples of it fit.
constexpr float kMostDepth = 65504.0f;

std::int64_t in_units(float value) {
    return std::llround(static_cast<double>(value) / kUnit);
}

double value_of(std::int64_t units) {
    return static_cast<double>(units) * kUnit;
}

double value_of_square(const std::array<std::uint64_t, 2>& words) {
    return (static_cast<double>(words[1]) * 0x1p64 + static_cast<double>(words[0])) * kUnit * kUnit;
}

void add_square(std::array<std::uint64_t, 2>& words, Wide square) {
    const Wide sum = ((static_cast<Wide>(words[1]) << 64) | words[0]) + square;
    words = {static_cast<std::uint64_t>(sum), static_cast<std::uint64_t>(sum >> 64)};
}

template <std::size_t N>
void add_to(std::array<std::int64_t, N>& sums, const std::array<std::int64_t, N>& other) {
    for (std::size_t i = 0; i < N; ++i) sums[i] += other[i];
}

void add_vector(std::array<std::int64_t, 3>& sums, const glm::vec3& v) {
    for (int c = 0; c < 3; ++c) sums[index_of(c)] += in_units(v[c]);
}

glm::dvec3 vector_of(const std::array<std::int64_t, 3>& sums) {
    return {value_of(sums[0]), value_of(sums[1]), value_of(sums[2])};
}

double luminance_of(const ColorSums& sums) {
    return f64::luminance(f64::vec3(vector_of(sums.color)));
}

// The axis along which a mean of products of a direction with itself is largest, by powers of the matrix; 0 of none.
glm::dvec3 main_axis(const std::array<std::int64_t, 6>& sums) {
    glm::dmat3 m(0.0);
    for (int c = 0; c < 3; ++c) m[c][c] = value_of(sums[index_of(c)]);
    m[0][1] = m[1][0] = value_of(sums[3]);
    m[1][2] = m[2][1] = value_of(sums[4]);
    m[2][0] = m[0][2] = value_of(sums[5]);
    const double trace = m[0][0] + m[1][1] + m[2][2];
    if (!(trace > 0.0)) return glm::dvec3(0.0);
    m *= 1.0 / trace;
    // Six squarings: the 64th power leaves of an axis that has 0.9 of another one a thousandth.
    for (int i = 0; i < 6; ++i) {
        m = m * m;
        m *= 1.0 / (m[0][0] + m[1][1] + m[2][2]);
    }
    const int largest = m[0][0] >= m[1][1] && m[0][0] >= m[2][2] ? 0 : m[1][1] >= m[2][2] ? 1 : 2;
    const glm::dvec3 axis = glm::normalize(m[largest]);
    // A line has two directions: that with the first of its larger components above 0.
    const double sign = axis[largest] < 0.0 ? -1.0 : 1.0;
    return sign * axis;
}

template <typename T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

}  // namespace

TraceSums::TraceSums(int width, int height, bool layers)
    : width_(width),
      height_(height),
      tiles_across_((width + kTraceTile - 1) / kTraceTile),
      counts_(index_of(tiles_across_) * index_of((height + kTraceTile - 1) / kTraceTile), 0),
      colors_(index_of(width) * index_of(height)),
      layers_(layers ? colors_.size() : 0) {}

std::uint64_t TraceSums::bytes_of(int width, int height, bool layers) {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
           (sizeof(ColorSums) + (layers ? sizeof(LayerSums) : 0));
}

TraceSums::Tile TraceSums::tile(int number) const {
    const int x = number % tiles_across_ * kTraceTile, y = number / tiles_across_ * kTraceTile;
    return {x, y, std::min(x + kTraceTile, width_), std::min(y + kTraceTile, height_)};
}

void TraceSums::add(int x, int y, const PathSample& sample) {
    ColorSums& sums = colors_[index(x, y)];
    add_vector(sums.color, sample.radiance);
    sums.coverage += in_units(sample.coverage);
    const std::int64_t luminance = in_units(f32::luminance(to_f32(sample.radiance)));
    const auto size = static_cast<Wide>(luminance < 0 ? -luminance : luminance);
    add_square(sums.square, size * size);
    if (layers_.empty() || !sample.meets_surface) return;
    LayerSums& layer = layers_[index(x, y)];
    const glm::vec3 g = sample.grain;
    // Single draws weigh more than the mean of 1 by far where a lobe is hard to draw from.
    add_vector(layer.albedo, glm::min(sample.albedo, glm::vec3(kMostDepth)));
    add_vector(layer.normal, sample.normal);
    const std::array<float, 6> products = {g.x * g.x, g.y * g.y, g.z * g.z,
                                           g.x * g.y, g.y * g.z, g.z * g.x};
    for (std::size_t i = 0; i < products.size(); ++i) layer.grain[i] += in_units(products[i]);
    layer.depth += in_units(std::clamp(sample.depth, -kMostDepth, kMostDepth));
    ++layer.met;
}

std::uint32_t TraceSums::fewest_samples() const {
    return *std::min_element(counts_.begin(), counts_.end());
}

std::uint32_t TraceSums::samples_at(int x, int y) const {
    return counts_[index_of(y / kTraceTile * tiles_across_ + x / kTraceTile)];
}

void TraceSums::merge(const TraceSums& other) {
    for (std::size_t i = 0; i < counts_.size(); ++i) {
        counts_[i] += other.counts_[i];
        if (counts_[i] > kMostTraceSamples)
            throw Error("trace", "samples",
                        "at most " + std::to_string(kMostTraceSamples) + " a pixel",
                        std::to_string(counts_[i]));
    }
    for (std::size_t i = 0; i < colors_.size(); ++i) {
        const ColorSums& from = other.colors_[i];
        add_to(colors_[i].color, from.color);
        colors_[i].coverage += from.coverage;
        add_square(colors_[i].square, (static_cast<Wide>(from.square[1]) << 64) | from.square[0]);
    }
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        const LayerSums& from = other.layers_[i];
        add_to(layers_[i].albedo, from.albedo);
        add_to(layers_[i].normal, from.normal);
        add_to(layers_[i].grain, from.grain);
        layers_[i].depth += from.depth;
        layers_[i].met += from.met;
    }
}

bool TraceSums::operator==(const TraceSums& other) const {
    return width_ == other.width_ && height_ == other.height_ && counts_ == other.counts_ &&
           same_bytes(colors_, other.colors_) && same_bytes(layers_, other.layers_);
}

Image TraceSums::picture() const {
    Image out(width_, height_, 4);
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            const std::uint32_t count = samples_at(x, y);
            if (count == 0) continue;
            const ColorSums& sums = colors_[index(x, y)];
            const double coverage = std::clamp(value_of(sums.coverage) / count, 0.0, 1.0);
            float* to = out.at(x, y);
            for (std::size_t c = 0; c < 3; ++c) {
                const double mean = std::max(value_of(sums.color[c]) / count, 0.0);
                to[c] = static_cast<float>(coverage > 0.0 ? mean / coverage : 0.0);
            }
            to[3] = static_cast<float>(coverage);
        }
    return out;
}

double TraceSums::variance_of_mean(int x, int y) const {
    const double count = samples_at(x, y);
    if (count < 2.0) return std::numeric_limits<double>::infinity();
    const ColorSums& sums = colors_[index(x, y)];
    const double mean = luminance_of(sums) / count;
    return std::max(value_of_square(sums.square) / count - mean * mean, 0.0) / (count - 1.0);
}

double TraceSums::relative_error() const {
    double variance = 0.0, mean = 0.0;
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            variance += variance_of_mean(x, y);
            mean += luminance_of(colors_[index(x, y)]) / std::max(samples_at(x, y), 1U);
        }
    if (std::isinf(variance)) return variance;
    const auto pixels = static_cast<double>(colors_.size());
    return mean > 0.0 ? std::sqrt(variance / pixels) / (mean / pixels) : 0.0;
}

ImagePart TraceSums::part_of(const std::string& name, const std::vector<std::string>& channels,
                             const PixelValues& values) const {
    ImagePart part{name, width_, height_, {}, {}, {}, {}};
    for (const std::string& channel : channels)
        part.channels.push_back({channel, false, std::vector<float>(colors_.size())});
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            const glm::dvec4 at = values(x, y);
            for (std::size_t c = 0; c < channels.size(); ++c)
                part.channels[c].values[index(x, y)] = static_cast<float>(at[static_cast<int>(c)]);
        }
    return part;
}

void TraceSums::add_layers(std::vector<ImagePart>& parts) const {
    const auto layer = [&](int x, int y) -> const LayerSums& { return layers_[index(x, y)]; };
    const auto met = [&](int x, int y) {
        return static_cast<double>(std::max<std::int64_t>(layer(x, y).met, 1));
    };
    parts.push_back(part_of("albedo", {"albedo.R", "albedo.G", "albedo.B"}, [&](int x, int y) {
        return glm::dvec4(vector_of(layer(x, y).albedo) / met(x, y), 0.0);
    }));
    parts.push_back(part_of("normal", {"normal.X", "normal.Y", "normal.Z"}, [&](int x, int y) {
        const glm::dvec3 sum = vector_of(layer(x, y).normal);
        const double length = glm::length(sum);
        return glm::dvec4(length > 0.0 ? sum / length : sum, 0.0);
    }));
    parts.push_back(part_of("grain", {"grain.X", "grain.Y", "grain.Z"}, [&](int x, int y) {
        return glm::dvec4(main_axis(layer(x, y).grain), 0.0);
    }));
    parts.push_back(part_of("depth", {"depth.Z"}, [&](int x, int y) {
        return glm::dvec4(value_of(layer(x, y).depth) / met(x, y));
    }));
}

std::vector<ImagePart> TraceSums::parts() const {
    const Image picture = this->picture();
    std::vector<ImagePart> parts;
    parts.push_back(part_of("color", {"R", "G", "B", "A"}, [&](int x, int y) {
        const float* p = picture.at(x, y);
        return glm::dvec4(p[0] * p[3], p[1] * p[3], p[2] * p[3], p[3]);
    }));
    parts.push_back(part_of("variance", {"variance.Y"}, [&](int x, int y) {
        const double v = variance_of_mean(x, y);
        return glm::dvec4(std::isinf(v) ? 0.0 : v);
    }));
    if (!layers_.empty()) add_layers(parts);
    return parts;
}

}  // namespace burnish
