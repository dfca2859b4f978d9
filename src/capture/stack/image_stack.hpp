// The pictures of a capture, one light each, read into one flat file from which a band of pixels is
// read for all lights at once, however large the stack is.
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
    // Codes of integer pictures end somewhere: samples that every exposure shows at its last code.
    std::vector<std::uint8_t> clipped;  // one a sample; empty: none
    bool coded = false;                 // some exposure is of integers: `clipped` is complete
};

// `white`: empty, or the flat field (as read_flat_field gives it). Throws Error for pictures that
// cannot be read or are of another size than width x height (0: any size).
LightImage read_light_image(const Rig& rig, const RigLight& light, const Image& white, int width,
                            int height);

// The rig's flat field scaled to a mean of 1, its dark places held at 1 % of that; empty: none
// given.
Image read_flat_field(const Rig& rig);

// The rig's mask, 1 where the sample is to be measured, a pixel each; 1 everywhere without one.
std::vector<std::uint8_t> read_mask(const Rig& rig, int width, int height);

// A file of floats does not say at which value its sensor clips. A picture is taken as clipped at
// its largest value when that value is the largest of the whole stack and at least this many of the
// picture's samples have it: samples of an unclipped sensor hardly ever agree in all bits.
inline constexpr int kRepeatsOfClipping = 8;
// The same for the largest share of a picture's samples: a picture of one value shows an even card
// rather than the end of its sensor.
inline constexpr double kMostOfClipping = 0.5;

struct StackCensus {
    double clipped_share = 0.0;  // of all samples within the mask
    double black_share = 0.0;    // exactly 0
    double brightest = 0.0;
};

// Consecutive pixels of the row-major picture, all lights, as the file holds them.
struct StackBand {
    std::size_t first = 0, pixels = 0;
    std::vector<std::uint16_t> codes;  // lights x pixels x 3
};

// The pictures of a stack, wherever they are. Functions are called from one thread, once a light
// and in order.
struct StackSource {
    std::size_t lights = 0;
    // The picture of one light; width 0: the first one, of any size.
    std::function<LightImage(std::size_t light, int width, int height)> picture;
    std::function<std::vector<std::uint8_t>(int width, int height)> mask;  // as read_mask
};
StackSource files_of(const Rig& rig);

// Pictures in memory, one a light in the order of the rig: linear, RGB or grey, all of one size.
// `mask`: 1 channel of that size, above 0.5 is measured; empty: everything. Refers to all three.
// Throws Error, in words, for pictures that do not fit the rig or hold values that are not finite.
StackSource images_of(const Rig& rig, std::span<const Image> pictures, const Image& mask);

class ImageStack {
  public:
    // Reads every picture once and writes `cache`, unless it holds them already (same rig, same
    // files by size and time of change). `band_bytes`: size of a band of a cache that is written,
    // one of at least 16 pixels. Throws Error.
    ImageStack(const Rig& rig, const std::filesystem::path& cache, const Progress& progress,
               std::size_t band_bytes = kUsualBandBytes);
    // The same without a file that anyone sees: the samples are in memory, or in an unnamed
    // temporary file where the system has no such files in memory.
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
    bool open(int file, std::uint64_t bytes);  // takes the file over when it answers true
    bool open_cache(const std::filesystem::path& cache);

    int width_ = 0, height_ = 0;
    std::size_t band_pixels_ = 0;
    std::uint64_t identity_ = 0;
    StackCensus census_;
    std::vector<float> scale_;         // of each light: a sample is scale (code / kMostCode)^2
    std::vector<std::uint8_t> clips_;  // of each light: 1 where its largest value means "clipped"
    std::vector<std::uint8_t> mask_;
    int file_ = -1;
    std::uint64_t data_start_ = 0;  // of the samples in the file, in bytes
    std::string name_;
};

}  // namespace burnish
