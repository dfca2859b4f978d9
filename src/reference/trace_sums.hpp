// What samples add up to, pixel by pixel. All sums are whole numbers: in whatever order, on however many threads and
// machines samples are added, the sums are the same to the last bit.
//
// Threads: tiles may be added to at the same time, each by one thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "burnish/image.hpp"
#include "image/image_parts.hpp"
#include "reference/path_tracer.hpp"

namespace burnish {

// Samples that one pixel can hold: the sums of 2^20 of them fit 64 bits.
inline constexpr std::uint32_t kMostTraceSamples = 1U << 20;
inline constexpr int kTraceTile = 16;  // pixels a side

// Words of a picture in a file of sums.
struct ColorSums {
    std::array<std::int64_t, 3> color{};  // times the coverage, in units of 2^-27
    std::int64_t coverage = 0;            // in units of 2^-27
    std::array<std::uint64_t, 2>
        square{};  // of the luminance, low and high word, in units of 2^-54
};

struct LayerSums {
    std::array<std::int64_t, 3> albedo{}, normal{};
    std::array<std::int64_t, 6>
        grain{};  // xx yy zz xy yz zx of the products of the direction with itself
    std::int64_t depth = 0;
    std::int64_t met = 0;  // samples that meet a surface
};

class TraceSums {
  public:
    TraceSums(int width, int height, bool layers);

    int width() const { return width_; }
    int height() const { return height_; }
    bool has_layers() const { return !layers_.empty(); }
    int tile_count() const { return static_cast<int>(counts_.size()); }
    // Pixels [x0, x1) x [y0, y1).
    struct Tile {
        int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    };
    Tile tile(int index) const;

    void add(int x, int y, const PathSample& sample);
    // One sample was added to every pixel of the tile.
    void count_sample(int tile) { ++counts_[static_cast<std::size_t>(tile)]; }
    std::uint32_t samples(int tile) const { return counts_[static_cast<std::size_t>(tile)]; }
    std::uint32_t fewest_samples() const;

    // Adds the sums of other samples of the same picture. Throws Error for more than kMostTraceSamples.
    void merge(const TraceSums& other);

    // The mean: RGBA, alpha not premultiplied. Pixels without a sample are 0.
    Image picture() const;
    // The picture and its layers as parts of one OpenEXR file, color premultiplied as the format wants it.
    std::vector<ImagePart> parts() const;
    // The estimated standard deviation of the picture's noise, root mean square over pixels, over its mean luminance.
    // Infinite below two samples, 0 for a black picture.
    double relative_error() const;

    // For files of sums.
    std::vector<std::uint32_t>& counts() { return counts_; }
    std::vector<ColorSums>& colors() { return colors_; }
    std::vector<LayerSums>& layers() { return layers_; }
    const std::vector<std::uint32_t>& counts() const { return counts_; }
    const std::vector<ColorSums>& colors() const { return colors_; }
    const std::vector<LayerSums>& layers() const { return layers_; }
    bool operator==(const TraceSums& other) const;

    // Bytes that the sums of a picture take.
    static std::uint64_t bytes_of(int width, int height, bool layers);

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    std::uint32_t samples_at(int x, int y) const;
    double variance_of_mean(int x, int y) const;  // of the luminance
    using PixelValues = std::function<glm::dvec4(int x, int y)>;
    ImagePart part_of(const std::string& name, const std::vector<std::string>& channels,
                      const PixelValues& values) const;
    void add_layers(std::vector<ImagePart>& parts) const;

    int width_, height_, tiles_across_;
    std::vector<std::uint32_t> counts_;  // by tile
    std::vector<ColorSums> colors_;
    std::vector<LayerSums> layers_;
};

}  // namespace burnish
