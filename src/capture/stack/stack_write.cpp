#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <span>
#include <vector>

#include "burnish/error.hpp"
#include "capture/stack/stack_layout.hpp"
#include "core/files.hpp"

namespace burnish {
namespace {

void write_at(int file, const void* data, std::size_t bytes, std::uint64_t at,
              const std::string& name) {
    const auto* from = static_cast<const char*>(data);
    while (bytes > 0) {
        const ssize_t done = ::pwrite(file, from, bytes, static_cast<off_t>(at));
        if (done < 0 && errno == EINTR) continue;
        if (done <= 0)
            throw Error(name, "", "a file that can be written",
                        reason_of(done < 0 ? errno : ENOSPC));
        from += done;
        at += static_cast<std::uint64_t>(done);
        bytes -= static_cast<std::size_t>(done);
    }
}

struct Coded {
    std::vector<std::uint16_t> codes;
    float scale = 0.0f;
    int at_top = 0;  // samples of a float picture within the mask that equal its largest
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

// Writes the codes of one light into every band of the file.
void write_light(int file, const StackHeader& header, std::size_t light,
                 std::span<const std::uint16_t> codes, const std::string& name) {
    const std::size_t pixels = header.width * header.height;
    for (std::size_t first = 0; first < pixels; first += header.band_pixels) {
        const std::size_t count = std::min<std::size_t>(header.band_pixels, pixels - first);
        const std::uint64_t at = data_start(header) + 6 * (first * header.lights + light * count);
        write_at(file, codes.data() + 3 * first, 6 * count, at, name);
    }
}

}  // namespace

void write_stack(int file, const std::string& name, const StackSource& source,
                 std::uint64_t identity, std::size_t band_bytes, const Progress& progress) {
    StackHeader header{};
    std::memcpy(header.magic, kStackMagic, sizeof kStackMagic);
    header.identity = identity;
    header.lights = source.lights;
    std::vector<std::uint8_t> mask;
    std::vector<float> scales;
    std::vector<int> at_top;
    double clipped = 0.0, black = 0.0, counted = 0.0;
    for (std::size_t k = 0; k < source.lights; ++k) {
        progress.step("reading pictures",
                      static_cast<double>(k) / static_cast<double>(source.lights));
        const LightImage image =
            source.picture(k, static_cast<int>(header.width), static_cast<int>(header.height));
        if (k == 0) {
            header.width = static_cast<std::uint64_t>(image.rgb.width);
            header.height = static_cast<std::uint64_t>(image.rgb.height);
            header.band_pixels = std::clamp<std::uint64_t>(band_bytes / (6 * header.lights), 16,
                                                           header.width * header.height);
            mask = source.mask(image.rgb.width, image.rgb.height);
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
        write_light(file, header, k, coded.codes, name);
    }
    std::vector<std::uint8_t> clips(scales.size(), 0);
    const double per_picture =
        counted / static_cast<double>(std::max<std::size_t>(scales.size(), 1));
    for (std::size_t k = 0; k < scales.size(); ++k)
        if (static_cast<double>(scales[k]) == header.brightest && at_top[k] >= kRepeatsOfClipping &&
            at_top[k] <= kMostOfClipping * per_picture && scales[k] > 0.0f) {
            clips[k] = 1;
            clipped += at_top[k];
        }
    header.clipped_share = clipped / counted;
    header.black_share = black / counted;
    std::uint64_t at = 0;
    const auto write_next = [&](const void* from, std::size_t size) {
        write_at(file, from, size, at, name);
        at += size;
    };
    write_next(&header, sizeof header);
    write_next(mask.data(), mask.size());
    write_next(scales.data(), scales.size() * sizeof(float));
    write_next(clips.data(), clips.size());
}

}  // namespace burnish
