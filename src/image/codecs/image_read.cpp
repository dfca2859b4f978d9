#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <iterator>
#include <limits>
#include <new>
#include <type_traits>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/files.hpp"
#include "image/codecs/exr_channels.hpp"
#include "image/codecs/exr_window.hpp"
#include "image/codecs/image_file.hpp"
#include "image/codecs/image_metadata.hpp"
#include "image/codecs/oiio_codecs.hpp"
#include "image/codecs/subsampled_exr.hpp"
#include "image/guard/container_checks.hpp"
#include "image/guard/format.hpp"

namespace burnish {
namespace {

// OpenImageIO and the standard library throw exceptions of their own; callers get Error.
template <typename Work>
auto with_errors_of(const std::string& name, Work&& work) {
    try {
        return work();
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw Error(name, "", "an image that fits into memory", "a larger one");
    } catch (const std::exception& error) {
        throw Error(name, "", "a readable image", one_line(error.what()));
    }
}

std::vector<std::byte> read_image_file(const std::filesystem::path& path) {
    // The first bytes tell the format, so that a video is refused before it is read into memory.
    require_image_format(read_file_head(path, kImageHeadBytes), path.string());
    return read_file(path);
}

TexelType texel_type_of(const OIIO::ImageSpec& spec) {
    const auto base = static_cast<OIIO::TypeDesc::BASETYPE>(spec.format.basetype);
    if (base == OIIO::TypeDesc::UINT8) return TexelType::u8;
    return base == OIIO::TypeDesc::UINT16 ? TexelType::u16 : TexelType::f32;
}

OIIO::TypeDesc oiio_type(TexelType type) {
    switch (type) {
        case TexelType::u8:
            return OIIO::TypeUInt8;
        case TexelType::u16:
            return OIIO::TypeUInt16;
        case TexelType::f32:
            return OIIO::TypeFloat;
    }
    return OIIO::TypeUnknown;
}

// Divides color by alpha, in place. Where alpha is 0 the color stays (it may be emission).
template <typename T>
void unpremultiply(std::span<std::byte> texels, int channels) {
    const std::size_t step = static_cast<std::size_t>(channels) * sizeof(T);
    for (std::size_t at = 0; at + step <= texels.size(); at += step) {
        T texel[4];
        std::memcpy(texel, texels.data() + at, step);
        const T alpha = texel[channels - 1];
        if (!(alpha > T{0})) continue;
        for (int c = 0; c + 1 < channels; ++c) {
            if constexpr (std::is_integral_v<T>) {
                constexpr unsigned kLargest = std::numeric_limits<T>::max();
                const unsigned scaled = (texel[c] * kLargest + alpha / 2U) / alpha;
                texel[c] = static_cast<T>(std::min(scaled, kLargest));
            } else {
                const float divided = texel[c] / alpha;
                // A subnormal alpha makes the quotient overflow; then the stored value is kept.
                if (std::isfinite(divided)) texel[c] = divided;
            }
        }
        std::memcpy(texels.data() + at, texel, step);
    }
}

void unpremultiply(Texture& texture) {
    switch (texture.type) {
        case TexelType::u8:
            return unpremultiply<std::uint8_t>(texture.texels, texture.channels);
        case TexelType::u16:
            return unpremultiply<std::uint16_t>(texture.texels, texture.channels);
        case TexelType::f32:
            return unpremultiply<float>(texture.texels, texture.channels);
    }
}

void require_finite(const Texture& texture) {
    const std::size_t count = texture.texels.size() / sizeof(float);
    for (std::size_t i = 0; i < count; ++i) {
        float value = 0.0f;
        std::memcpy(&value, texture.texels.data() + i * sizeof(float), sizeof(float));
        if (std::isfinite(value)) continue;
        const std::size_t pixel = i / static_cast<std::size_t>(texture.channels);
        const auto width = static_cast<std::size_t>(texture.width);
        throw Error(texture.name, fmt::format("pixel ({}, {})", pixel % width, pixel / width),
                    "finite values",
                    fmt::format("{} (`oiiotool IN --fixnan box3 -o OUT` replaces such pixels)",
                                std::isnan(value) ? "NaN" : "infinity"));
    }
}

// A 32-bit BMP or TGA whose alpha is 0 everywhere has none: many programs leave the fourth byte
// unset.
void fill_unused_alpha(Texture& texture) {
    if (texture.channels != 4 || texture.type != TexelType::u8) return;
    for (std::size_t i = 3; i < texture.texels.size(); i += 4)
        if (texture.texels[i] != std::byte{0}) return;
    for (std::size_t i = 3; i < texture.texels.size(); i += 4) texture.texels[i] = std::byte{255};
}

// OpenImageIO says so only of what it may be asked about: the alpha of a BMP is always straight.
bool is_premultiplied(const ImageFile& image, const CheckedFile& file) {
    return file.structure.premultiplied ||
           (image.format() != ImageFormat::bmp &&
            image.spec().get_int_attribute("oiio:UnassociatedAlpha") == 0);
}

// Colors that were multiplied by alpha on decoding, read again without it.
void restore_webp_color(const CheckedFile& file, Texture& texture) {
    const std::vector<std::byte> opaque = webp_without_alpha(file.bytes);
    const CheckedFile checked(opaque, file.name);
    ImageFile image(checked);
    const std::vector<std::byte> colors = image.read_pixels(0, 3, OIIO::TypeUInt8);
    const std::size_t pixels = texture.texels.size() / 4;
    if (colors.size() != pixels * 3) image.fail("another size than its frame");
    for (std::size_t i = 0; i < pixels; ++i)
        std::copy_n(colors.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                    texture.texels.begin() + static_cast<std::ptrdiff_t>(4 * i));
}

// What will look different from what the file means, one line each.
std::vector<std::string> warnings_of(const ImageFile& file, const ChannelChoice& choice) {
    std::vector<std::string> warnings;
    if (!choice.layer.empty() && !choice.others.empty())
        warnings.push_back(
            one_line(fmt::format("{}: layers {} and {}: {} is read", file.name(), choice.layer,
                                 fmt::join(choice.others, ", "), choice.layer)));
    if (const auto& parts = file.color_parts(); parts.size() > 1)
        warnings.push_back(fmt::format("{}: parts {} have R, G and B: {} is read", file.name(),
                                       fmt::join(parts, ", "), parts.front()));
    if (file.format() == ImageFormat::raw)
        warnings.push_back(fmt::format(
            "{}: a raw camera file: read as linear camera RGB without white balance and color "
            "matrix; a white target in the rig or developing to a linear 16-bit TIFF balances it",
            file.name()));
    return warnings;
}

void append_to(std::vector<std::string>* all, std::vector<std::string> lines) {
    if (all != nullptr) std::move(lines.begin(), lines.end(), std::back_inserter(*all));
}

Texture decode(ImageFile& image, const CheckedFile& file, ColorSpace color_space, bool finite_only,
               std::vector<std::string>* warnings) {
    const OIIO::ImageSpec& spec = image.spec();
    const ChannelChoice choice =
        choose_channels(spec, image.format() == ImageFormat::exr, image.name());
    Texture texture;
    texture.name = image.name();
    texture.width = spec.width;
    texture.height = spec.height;
    texture.channels = choice.count;
    texture.type = texel_type_of(spec);
    texture.color_space = texture.type == TexelType::f32 || image.format() == ImageFormat::raw
                              ? ColorSpace::linear
                              : color_space;
    texture.texels = image.read_pixels(choice.first, choice.count, oiio_type(texture.type));
    fit_to_display_window(texture, image.data_window(), image.display_window());
    if (finite_only && texture.type == TexelType::f32) require_finite(texture);

    if (image.format() == ImageFormat::bmp || image.format() == ImageFormat::tga)
        fill_unused_alpha(texture);
    if (choice.has_alpha && image.format() == ImageFormat::webp) {
        restore_webp_color(file, texture);
    } else if (choice.has_alpha && is_premultiplied(image, file)) {
        unpremultiply(texture);
    }
    append_to(warnings, warnings_of(image, choice));
    return texture;
}

Texture decode(const CheckedFile& file, ColorSpace color_space,
               std::vector<std::string>* warnings) {
    if (!file.structure.subsampled) {
        ImageFile image(file);
        return decode(image, file, color_space, true, warnings);
    }
    Texture texture = decode_subsampled_exr(file.bytes, file.name);
    require_finite(texture);
    return texture;
}

// The linear value of every code of an integer type.
template <typename T>
std::vector<float> value_table(bool srgb) {
    constexpr std::size_t kCodes = std::size_t{std::numeric_limits<T>::max()} + 1;
    std::vector<float> table(kCodes);
    for (std::size_t code = 0; code < kCodes; ++code) {
        const float value = static_cast<float>(code) / static_cast<float>(kCodes - 1);
        table[code] = srgb ? linear_from_srgb(value) : value;
    }
    return table;
}

// All channels of `texture` as floats. Alpha, the last of 2 or 4 channels, is linear in every file.
template <typename T>
void append_values(const Texture& texture, bool srgb, std::vector<float>& values) {
    const std::vector<float> color = value_table<T>(srgb), plain = value_table<T>(false);
    const auto channels = static_cast<std::size_t>(texture.channels);
    const std::size_t alpha = channels % 2 == 0 ? channels - 1 : channels;
    for (std::size_t i = 0; i < values.size(); ++i) {
        T code{};
        std::memcpy(&code, texture.texels.data() + i * sizeof(T), sizeof(T));
        values[i] = (i % channels == alpha ? plain : color)[code];
    }
}

std::vector<float> values_of(const Texture& texture, bool srgb) {
    std::vector<float> values(static_cast<std::size_t>(texture.width) *
                              static_cast<std::size_t>(texture.height) *
                              static_cast<std::size_t>(texture.channels));
    switch (texture.type) {
        case TexelType::u8:
            append_values<std::uint8_t>(texture, srgb, values);
            break;
        case TexelType::u16:
            append_values<std::uint16_t>(texture, srgb, values);
            break;
        case TexelType::f32:
            std::memcpy(values.data(), texture.texels.data(), texture.texels.size());
            break;
    }
    return values;
}

// RGBA from pairs of grey and alpha.
std::vector<float> with_gray_spread(const std::vector<float>& pairs) {
    std::vector<float> pixels;
    pixels.reserve(pairs.size() * 2);
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
        pixels.insert(pixels.end(), {pairs[i], pairs[i], pairs[i], pairs[i + 1]});
    }
    return pixels;
}

Image image_of_subsampled(const CheckedFile& file, const ReadOptions& options) {
    const Texture texture = decode_subsampled_exr(file.bytes, file.name);
    if (options.finite_only) require_finite(texture);
    Image image;
    image.width = texture.width;
    image.height = texture.height;
    image.channels = texture.channels;
    image.pixels = values_of(texture, false);
    return image;
}

// For a file whose channels no reader takes, what a reader would say: it is described all the same.
std::vector<std::string> warnings_if_readable(const ImageFile& image) {
    try {
        return warnings_of(
            image, choose_channels(image.spec(), image.format() == ImageFormat::exr, image.name()));
    } catch (const Error& error) {
        return {error.what()};
    }
}

// What `info` prints of a file beside its attributes: how it is read.
void describe_reading(const ImageFile& image, std::map<std::string, std::string>& metadata) {
    const OIIO::ImageSpec& spec = image.spec();
    if (spec.nchannels > 4) metadata["channels"] = listed_channels(spec);
    const PixelWindow data = image.data_window(), display = image.display_window();
    if (data == display) return;
    metadata["data window"] = fmt::format("{}x{} at ({}, {}) of the picture", data.width,
                                          data.height, data.x - display.x, data.y - display.y);
}

}  // namespace

namespace oiio {

Image read_image(const std::filesystem::path& path, const ReadOptions& options) {
    const std::string name = path.string();
    return with_errors_of(name, [&] {
        const std::vector<std::byte> bytes = read_image_file(path);
        const CheckedFile file(bytes, name);
        if (file.structure.subsampled) return image_of_subsampled(file, options);
        ImageFile source(file);
        if (source.spec().nchannels == 2 && source.spec().alpha_channel != 1) {
            throw Error(name, "channels", "1, 3 or 4, or grey with alpha",
                        listed_channels(source.spec()));
        }
        const Texture texture =
            decode(source, file, ColorSpace::linear, options.finite_only, options.warnings);
        const bool encoded = texture.type != TexelType::f32 && !source.is_linear();
        Image image;
        image.width = texture.width;
        image.height = texture.height;
        image.channels = texture.channels == 2 ? 4 : texture.channels;
        image.pixels = values_of(texture, encoded && !options.as_data);
        if (texture.channels == 2) image.pixels = with_gray_spread(image.pixels);
        return image;
    });
}

Texture read_texture(const std::filesystem::path& path, ColorSpace color_space,
                     std::vector<std::string>* warnings) {
    const std::string name = path.string();
    return with_errors_of(name, [&] {
        return oiio::decode_texture(read_image_file(path), name, color_space, warnings);
    });
}

Texture decode_texture(std::span<const std::byte> bytes, const std::string& name,
                       ColorSpace color_space, std::vector<std::string>* warnings) {
    return with_errors_of(name,
                          [&] { return decode(CheckedFile(bytes, name), color_space, warnings); });
}

ImageInfo read_image_info(const std::filesystem::path& path) {
    const std::string name = path.string();
    return with_errors_of(name, [&] {
        const std::vector<std::byte> bytes = read_image_file(path);
        const CheckedFile file(bytes, name);
        ImageInfo info;
        if (file.structure.subsampled) {
            const Texture texture = decode_subsampled_exr(bytes, name);
            return ImageInfo{std::string(format_name(file.format)),
                             texture.width,
                             texture.height,
                             texture.channels,
                             "half",
                             {},
                             {}};
        }
        const ImageFile image(file);
        info.format = format_name(image.format());
        info.width = image.display_window().width;
        info.height = image.display_window().height;
        info.channels = image.spec().nchannels;
        info.pixel_type = image.spec().format.c_str();
        info.metadata = metadata_of(image.spec());
        describe_reading(image, info.metadata);
        info.warnings = warnings_if_readable(image);
        return info;
    });
}

}  // namespace oiio

}  // namespace burnish
