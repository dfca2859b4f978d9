#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/files.hpp"
#include "image/codecs/image_metadata.hpp"
#include "image/guard/format.hpp"
#include "image/written_format.hpp"

namespace burnish {
namespace {

void check_image(const Image& image, const std::string& name) {
    check_image_size(image.width, image.height, name);
    const bool channels_fit = image.channels == 1 || image.channels == 3 || image.channels == 4;
    const std::size_t values = static_cast<std::size_t>(image.width) *
                               static_cast<std::size_t>(image.height) *
                               static_cast<std::size_t>(std::max(image.channels, 0));
    if (channels_fit && image.pixels.size() == values) return;
    throw Error(name, "", "an image of 1, 3 or 4 full channels",
                fmt::format("{} channels, {} values", image.channels, image.pixels.size()));
}

// Noise of a pixel, evenly distributed in (-0.5, 0.5): multiples of 1/g and 1/g^2, g^3 = g + 1 (Roberts
// 2018), folded so that neighbors differ much. It stops short of half a step, so that a value which a
// code holds exactly, but for the rounding of floats, keeps its code.
float dither_noise(std::size_t x, std::size_t y) {
    const auto turns = static_cast<std::uint32_t>(x * 3242174889u + y * 2447445414u);
    const std::uint32_t folded = turns < 0x80000000u ? 2 * turns : ~(2 * turns);
    constexpr float kReach = 1.0f - 1.0f / 512;
    return kReach * (static_cast<float>(folded >> 8) * (1.0f / 16777216.0f) - 0.5f);
}

// Codes of display values. Alpha is left out when `channels` is 3 and the image has 4; it is never
// dithered.
template <typename Code>
std::vector<Code> codes_of(const Image& image, int channels, bool dither) {
    const auto from = static_cast<std::size_t>(image.channels);
    const auto to = static_cast<std::size_t>(channels);
    const auto width = static_cast<std::size_t>(image.width);
    const std::size_t colors = to == 4 ? 3 : to;
    const std::size_t count = image.pixels.size() / from;
    constexpr auto kMost = static_cast<float>(std::numeric_limits<Code>::max());
    std::vector<Code> codes(count * to);
    for (std::size_t pixel = 0; pixel < count; ++pixel) {
        const float noise = dither ? dither_noise(pixel % width, pixel / width) : 0.0f;
        for (std::size_t c = 0; c < to; ++c) {
            const float value = image.pixels[pixel * from + c];
            // The comparison is written so that NaN becomes 0.
            const float clamped = value > 0.0f ? (value < 1.0f ? value : 1.0f) : 0.0f;
            const float shift = c < colors ? 0.5f + noise : 0.5f;
            codes[pixel * to + c] = static_cast<Code>(clamped * kMost + shift);
        }
    }
    return codes;
}

std::vector<float> premultiplied(const Image& image) {
    std::vector<float> pixels = image.pixels;
    if (image.channels != 4) return pixels;
    for (std::size_t i = 0; i + 3 < pixels.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c) pixels[i + c] *= pixels[i + 3];
    }
    return pixels;
}

bool has_16_bits(ImageFormat format, const WriteOptions& options) {
    return options.bits == 16 && (format == ImageFormat::png || format == ImageFormat::tiff);
}

OIIO::ImageSpec spec_for(ImageFormat format, const Image& image, const Metadata& metadata,
                         const WriteOptions& options) {
    const int channels = format == ImageFormat::jpeg ? std::min(image.channels, 3) : image.channels;
    const bool linear = format == ImageFormat::exr;
    OIIO::ImageSpec spec(image.width, image.height, channels,
                         linear                         ? OIIO::TypeFloat
                         : has_16_bits(format, options) ? OIIO::TypeUInt16
                                                        : OIIO::TypeUInt8);
    spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
    if (!linear) spec.attribute("oiio:UnassociatedAlpha", 1);
    if (format == ImageFormat::jpeg) {
        spec.attribute("Compression", "jpeg:95");
        // Scratches are one pixel wide, so color is stored at full resolution.
        spec.attribute("jpeg:subsampling", "4:4:4");
    } else if (format == ImageFormat::png) {
        // A third of the time of level 6, the default; files of textures are 8 % larger.
        spec.attribute("png:compressionLevel", 4);
    } else {
        spec.attribute("Compression", "zip");
    }
    // OpenImageIO before 2.5.13 breaks a TIFF that has an Exif directory and is written to memory.
    if (format == ImageFormat::tiff) spec.attribute("tiff:write_exif", 0);
    put_metadata(spec, metadata, format == ImageFormat::png || format == ImageFormat::exr);
    return spec;
}

// The bytes of the file, encoded in memory, because not every encoder notices a full disk.
void encode(ImageFormat format, const Image& image, const Metadata& metadata,
            const WriteOptions& options, OIIO::Filesystem::IOVecOutput& target,
            const std::string& name) {
    const std::unique_ptr<OIIO::ImageOutput> output =
        OIIO::ImageOutput::create(oiio_format_name(format));
    const auto fail = [&] {
        throw Error(name, "", fmt::format("to encode a {} image", format_name(format)),
                    one_line(output ? output->geterror() : OIIO::geterror()));
    };
    if (!output || !output->supports("ioproxy")) fail();
    const OIIO::ImageSpec spec = spec_for(format, image, metadata, options);
    output->set_ioproxy(&target);
    if (!output->open(name, spec)) fail();
    bool written = false;
    if (format == ImageFormat::exr) {
        written = output->write_image(OIIO::TypeFloat, premultiplied(image).data());
    } else if (has_16_bits(format, options)) {
        const auto codes = codes_of<std::uint16_t>(image, spec.nchannels, false);
        written = output->write_image(OIIO::TypeUInt16, codes.data());
    } else {
        const auto codes = codes_of<std::uint8_t>(image, spec.nchannels, options.dither);
        written = output->write_image(OIIO::TypeUInt8, codes.data());
    }
    if (!written || !output->close() || output->has_error()) fail();
}

}  // namespace

namespace oiio {

void write_image(const std::filesystem::path& path, const Image& image,
                 const std::map<std::string, std::string>& metadata, const WriteOptions& options) {
    const ImageFormat format = require_written_format(path);
    check_image(image, path.string());
    if (options.bits != 8 && options.bits != 16)
        throw Error(path.string(), "bits", "8 or 16", std::to_string(options.bits));
    OIIO::Filesystem::IOVecOutput target;
    encode(format, image, metadata, options, target, path.string());
    write_bytes(path, std::as_bytes(std::span(target.buffer())));
}

}  // namespace oiio

}  // namespace burnish
