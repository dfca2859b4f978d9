// The pictures of a capture, one for each light, converted to one flat file. A band of pixels is
// read from it for all lights at once, so that a stack may be larger than memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "burnish/capture_fit.hpp"
#include "burnish/image.hpp"
#include "burnish/progress.hpp"
#include "burnish/rig.hpp"

namespace burnish {

struct LightImage {
    Image rgb;  // linear, brackets merged, divided by the flat field; never negative
    // 1 where every exposure of an integer picture holds the largest code.
    std::vector<std::uint8_t> clipped;  // one for each sample; empty: none
    bool coded = false;                 // an exposure has integer samples: `clipped` is complete
};

// `white`: the flat field (read_flat_field), or empty. Throws Error for pictures that cannot be
// read or whose size is not width x height (0: any size).
LightImage read_light_image(const Rig& rig, const RigLight& light, const Image& white, int width,
                            int height);

// The rig's flat field scaled to a mean of 1, with values of at least 0.01; empty if the rig has
// none.
Image read_flat_field(const Rig& rig);

// The rig's mask, one value for each pixel: 1 where the sample is to be measured; all 1 if the rig
// has none.
std::vector<std::uint8_t> read_mask(const Rig& rig, int width, int height);

// Number of samples at a float picture's maximum from which they count as clipped. A file of floats
// does not state at which value its sensor clips. The maximum must also be that of the whole stack.
// Samples of an unclipped sensor hardly ever agree in all bits.
inline constexpr int kRepeatsOfClipping = 8;
// Share of a picture's samples, within the mask, up to which those at its largest value are taken as
// clipped. More of them show an even card rather than the end of a sensor.
inline constexpr double kMostOfClipping = 0.5;

struct StackCensus {
    double clipped_share = 0.0;  // of all samples within the mask
    double black_share = 0.0;    // of all samples within the mask: exactly 0
    double brightest = 0.0;
};

// Consecutive pixels of the row-major picture, all lights, as the file holds them.
struct StackBand {
    std::size_t first = 0, pixels = 0;
    std::vector<std::uint16_t> codes;  // lights x pixels x 3
};

// The source of a stack's pictures. The functions are called from one thread, once for each light
// in order.
struct StackSource {
    std::size_t lights = 0;
    // The picture of one light; width 0: any size, for the first picture.
    std::function<LightImage(std::size_t light, int width, int height)> picture;
    std::function<std::vector<std::uint8_t>(int width, int height)> mask;  // as read_mask
};
StackSource files_of(const Rig& rig);

// Pictures in memory, one for each light in the order of the rig: linear, RGB or gray, all of one
// size. `mask`: 1 channel of that size, to be measured where above 0.5; empty: everything. Keeps
// references to all three arguments. Throws Error for pictures that do not fit the rig or hold
// values that are not finite.
StackSource images_of(const Rig& rig, std::span<const Image> pictures, const Image& mask);

class ImageStack {
  public:
    // Reads every picture once and writes `cache`, unless the cache already holds them (same rig,
    // same files by size and time of change). `band_bytes`: size of a band of the cache, which
    // holds at least 16 pixels. Throws Error.
    ImageStack(const Rig& rig, const std::filesystem::path& cache, const Progress& progress,
               std::size_t band_bytes = kUsualBandBytes);
    // The same without a cache file: the samples are in memory, or in an unnamed temporary file if
    // the system has no files in memory.
    ImageStack(const StackSource& source, const Progress& progress,
               std::size_t band_bytes = kUsualBandBytes);
    ImageStack(const ImageStack&) = delete;
    ImageStack& operator=(const ImageStack&) = delete;
    ~ImageStack();

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t pixels() const {
        return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    }
    std::size_t lights() const { return scale_.size(); }
    std::uint64_t identity() const { return identity_; }  // of the rig and its files
    const StackCensus& census() const { return census_; }
    const std::vector<std::uint8_t>& mask() const { return mask_; }  // 1: to be fitted

    std::size_t bands() const { return (pixels() - 1) / band_pixels_ + 1; }
    std::size_t band_pixels() const { return band_pixels_; }
    StackBand load(std::size_t band) const;
    // Samples of `count` pixels of the band from its pixel `from` on: out[pixel][light][channel].
    // Clipped samples are +infinity.
    void decode(const StackBand& band, std::size_t from, std::size_t count, float* out) const;

  private:
    bool open(int file, std::uint64_t bytes);  // takes ownership of `file` if it returns true
    bool open_cache(const std::filesystem::path& cache);

    int width_ = 0, height_ = 0;
    std::size_t band_pixels_ = 0;
    std::uint64_t identity_ = 0;
    StackCensus census_;
    std::vector<float> scale_;         // of each light: a sample is scale (code / kMostCode)^2
    std::vector<std::uint8_t> clips_;  // of each light: 1 if its largest value is clipped
    std::vector<std::uint8_t> mask_;
    int file_ = -1;
    std::uint64_t data_start_ = 0;  // of the samples in the file, in bytes
    std::string name_;
};

}  // namespace burnish
