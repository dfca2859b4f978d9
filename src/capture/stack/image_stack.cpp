#include "capture/stack/image_stack.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

#include "burnish/error.hpp"
#include "capture/stack/stage_file.hpp"
#include "core/files.hpp"
#include "image/image_io.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;

// Samples are stored as 16-bit codes of the square root of their ratio to the light's largest
// sample. A step is at most 0.3 % of a sample that is a ten thousandth of the largest.
constexpr float kMostCode = 65534.0f;
constexpr std::uint16_t kClippedCode = 65535;

constexpr char kMagic[16] = "burnish-stack 2";

struct Header {
    char magic[16];
    std::uint64_t identity;
    std::uint64_t width, height, lights, band_pixels;
    double clipped_share, black_share, brightest;
};
// The header is followed by the mask (width x height bytes), the scales (lights floats), the flags
// of clipping pictures (lights bytes) and the samples, band by band.

std::uint64_t data_start(const Header& h) {
    return sizeof(Header) + h.width * h.height + h.lights * (sizeof(float) + 1);
}

void add_file(Identity& identity, const fs::path& path) {
    const std::string name = path.string();
    identity.add_bytes(name.data(), name.size());
    std::error_code error;
    identity.add(fs::file_size(path, error));
    identity.add(fs::last_write_time(path, error).time_since_epoch().count());
}

void add_place(Identity& identity, const RigPlace& place) {
    identity.add(place.near);
    for (const double c : place.at) identity.add(c);
}

std::uint64_t identity_of(const Rig& rig) {
    Identity identity;
    identity.add(rig.response);
    identity.add(rig.width_mm);
    identity.add(rig.height_mm);
    add_place(identity, rig.camera);
    if (rig.mask) add_file(identity, *rig.mask);
    if (rig.white) add_file(identity, *rig.white);
    for (const RigLight& light : rig.lights) {
        for (const RigExposure& exposure : light.images) {
            add_file(identity, exposure.image);
            identity.add(exposure.exposure);
        }
        add_place(identity, light.place);
        for (const double c : light.intensity) identity.add(c);
        for (const double c : light.emission_axis) identity.add(c);
        identity.add(light.emission_exponent);
    }
    return identity.value();
}

void write_at(int file, const void* data, std::size_t bytes, std::uint64_t at,
              const fs::path& name) {
    const auto* from = static_cast<const char*>(data);
    while (bytes > 0) {
        const ssize_t done = ::pwrite(file, from, bytes, static_cast<off_t>(at));
        if (done < 0 && errno == EINTR) continue;
        if (done <= 0)
            throw Error(name.string(), "", "a file that can be written",
                        reason_of(done < 0 ? errno : ENOSPC));
        from += done;
        at += static_cast<std::uint64_t>(done);
        bytes -= static_cast<std::size_t>(done);
    }
}

void read_at(int file, void* data, std::size_t bytes, std::uint64_t at, const std::string& name) {
    auto* to = static_cast<char*>(data);
    while (bytes > 0) {
        const ssize_t done = ::pread(file, to, bytes, static_cast<off_t>(at));
        if (done < 0 && errno == EINTR) continue;
        if (done <= 0)
            throw Error(name, "", "the samples of a whole stack",
                        done < 0 ? reason_of(errno) : "the end of the file");
        to += done;
        at += static_cast<std::uint64_t>(done);
        bytes -= static_cast<std::size_t>(done);
    }
}

class OpenFile {
  public:
    OpenFile(const fs::path& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC)) {
        if (number_ < 0)
            throw Error(path.string(), "", "a file that can be opened", reason_of(errno));
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() { ::close(number_); }
    int number() const { return number_; }

  private:
    int number_;
};

struct Coded {
    std::vector<std::uint16_t> codes;
    float scale = 0.0f;
    int at_top = 0;  // samples of a float picture, within the mask, that equal the largest
};

Coded code_image(const LightImage& image, const std::vector<std::uint8_t>& mask) {
    Coded out;
    const auto& pixels = image.rgb.pixels;
    out.scale = *std::max_element(pixels.begin(), pixels.end());
    for (std::size_t i = 0; i < pixels.size(); ++i)
        out.at_top += !image.coded && mask[i / 3] && pixels[i] == out.scale;
    out.codes.resize(pixels.size());
    const float inverse = out.scale > 0.0f ? 1.0f / out.scale : 0.0f;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        out.codes[i] = static_cast<std::uint16_t>(
            std::lround(kMostCode * std::sqrt(std::max(pixels[i], 0.0f) * inverse)));
    for (std::size_t i = 0; i < image.clipped.size(); ++i)
        if (image.clipped[i]) out.codes[i] = kClippedCode;
    return out;
}

// Writes one light's codes into its place in every band.
void write_light(int file, const Header& header, std::size_t light,
                 std::span<const std::uint16_t> codes, const fs::path& name) {
    const std::size_t pixels = header.width * header.height;
    for (std::size_t first = 0; first < pixels; first += header.band_pixels) {
        const std::size_t count = std::min<std::size_t>(header.band_pixels, pixels - first);
        const std::uint64_t at = data_start(header) + 6 * (first * header.lights + light * count);
        write_at(file, codes.data() + 3 * first, 6 * count, at, name);
    }
}

}  // namespace

std::vector<std::uint8_t> read_mask(const Rig& rig, int width, int height) {
    std::vector<std::uint8_t> mask(
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 1);
    if (!rig.mask) return mask;
    const Image image = read_image(*rig.mask, {.as_data = true});
    if (image.width != width || image.height != height)
        throw Error(rig.mask->string(), "",
                    fmt::format("{} x {} pixels, as the pictures have", width, height),
                    fmt::format("{} x {}", image.width, image.height));
    for (std::size_t i = 0; i < mask.size(); ++i)
        mask[i] = image.pixels[i * static_cast<std::size_t>(image.channels)] > 0.5f;
    if (std::find(mask.begin(), mask.end(), 1) == mask.end())
        throw Error(rig.mask->string(), "", "something white: the part to be fitted", "all black");
    return mask;
}

ImageStack::ImageStack(const Rig& rig, const fs::path& cache, const Progress& progress,
                       std::size_t band_bytes)
    : identity_(identity_of(rig)), name_(cache.string()) {
    if (rig.lights.empty()) throw Error(rig.file.string(), "lights", "at least one light", "none");
    if (open_cache(cache)) return;
    make_cache(rig, cache, progress, band_bytes);
    if (!open_cache(cache))
        throw Error(name_, "", "the stack that was just written", "something else");
}

ImageStack::~ImageStack() {
    if (file_ >= 0) ::close(file_);
}

bool ImageStack::open_cache(const fs::path& cache) {
    const int file = ::open(cache.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return false;
    Header header{};
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(cache, error);
    const bool whole =
        !error && bytes >= sizeof header &&
        ::pread(file, &header, sizeof header, 0) == static_cast<ssize_t>(sizeof header) &&
        std::memcmp(header.magic, kMagic, sizeof kMagic) == 0 && header.identity == identity_ &&
        header.width <= 32768 && header.height <= 32768 && header.lights <= 1'000'000 &&
        header.width > 0 && header.height > 0 && header.lights > 0 && header.band_pixels > 0 &&
        bytes == data_start(header) + 6 * header.width * header.height * header.lights;
    if (!whole) {
        ::close(file);
        return false;
    }
    file_ = file;
    width_ = static_cast<int>(header.width);
    height_ = static_cast<int>(header.height);
    band_pixels_ = header.band_pixels;
    census_ = {header.clipped_share, header.black_share, header.brightest};
    mask_.resize(pixels());
    scale_.resize(header.lights);
    clips_.resize(header.lights);
    data_start_ = data_start(header);
    std::uint64_t at = sizeof header;
    const auto read_next = [&](void* to, std::size_t size) {
        read_at(file_, to, size, at, name_);
        at += size;
    };
    read_next(mask_.data(), mask_.size());
    read_next(scale_.data(), scale_.size() * sizeof(float));
    read_next(clips_.data(), clips_.size());
    return true;
}

void ImageStack::make_cache(const Rig& rig, const fs::path& cache, const Progress& progress,
                            std::size_t band_bytes) {
    const Image white = read_flat_field(rig);
    write_file_whole(cache, [&](const fs::path& temporary) {
        const OpenFile file(temporary, O_RDWR);
        Header header{};
        std::memcpy(header.magic, kMagic, sizeof kMagic);
        header.identity = identity_;
        header.lights = rig.lights.size();
        std::vector<std::uint8_t> mask;
        std::vector<float> scales;
        std::vector<int> at_top;
        double clipped = 0.0, black = 0.0, counted = 0.0;
        for (std::size_t k = 0; k < rig.lights.size(); ++k) {
            progress.step("reading pictures",
                          static_cast<double>(k) / static_cast<double>(rig.lights.size()));
            const LightImage image =
                read_light_image(rig, rig.lights[k], white, static_cast<int>(header.width),
                                 static_cast<int>(header.height));
            if (k == 0) {
                header.width = static_cast<std::uint64_t>(image.rgb.width);
                header.height = static_cast<std::uint64_t>(image.rgb.height);
                header.band_pixels = std::clamp<std::uint64_t>(band_bytes / (6 * header.lights), 16,
                                                               header.width * header.height);
                mask = read_mask(rig, image.rgb.width, image.rgb.height);
            }
            const Coded coded = code_image(image, mask);
            for (std::size_t i = 0; i < coded.codes.size(); ++i) {
                if (!mask[i / 3]) continue;
                counted += 1.0;
                black += coded.codes[i] == 0;
                clipped += coded.codes[i] == kClippedCode;
            }
            scales.push_back(coded.scale);
            at_top.push_back(coded.at_top);
            header.brightest = std::max(header.brightest, static_cast<double>(coded.scale));
            write_light(file.number(), header, k, coded.codes, cache);
        }
        std::vector<std::uint8_t> clips(scales.size(), 0);
        for (std::size_t k = 0; k < scales.size(); ++k)
            if (static_cast<double>(scales[k]) == header.brightest &&
                at_top[k] >= kRepeatsOfClipping && scales[k] > 0.0f) {
                clips[k] = 1;
                clipped += at_top[k];
            }
        header.clipped_share = clipped / counted;
        header.black_share = black / counted;
        std::uint64_t at = 0;
        const auto write_next = [&](const void* from, std::size_t size) {
            write_at(file.number(), from, size, at, cache);
            at += size;
        };
        write_next(&header, sizeof header);
        write_next(mask.data(), mask.size());
        write_next(scales.data(), scales.size() * sizeof(float));
        write_next(clips.data(), clips.size());
    });
}

StackBand ImageStack::load(std::size_t band) const {
    StackBand out;
    out.first = band * band_pixels_;
    out.pixels = std::min(band_pixels_, pixels() - out.first);
    out.codes.resize(3 * out.pixels * lights());
    read_at(file_, out.codes.data(), out.codes.size() * 2, data_start_ + 6 * out.first * lights(),
            name_);
    return out;
}

void ImageStack::decode(const StackBand& band, std::size_t from, std::size_t count,
                        float* out) const {
    const std::size_t lights_count = lights();
    for (std::size_t light = 0; light < lights_count; ++light) {
        const std::uint16_t* codes = band.codes.data() + 3 * (light * band.pixels + from);
        const bool clips = clips_[light] != 0;
        const float factor = scale_[light] / (kMostCode * kMostCode);
        for (std::size_t p = 0; p < count; ++p)
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint16_t code = codes[3 * p + c];
                const auto root = static_cast<float>(code);
                const bool clipped = code == kClippedCode || (clips && code == kClippedCode - 1);
                out[3 * (p * lights_count + light) + c] =
                    clipped ? std::numeric_limits<float>::infinity() : factor * root * root;
            }
    }
}

}  // namespace burnish
