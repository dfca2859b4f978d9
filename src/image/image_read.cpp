#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/files.hpp"
#include "image/guard/format.hpp"
#include "image/guard/png_chunks.hpp"
#include "image/image_metadata.hpp"
#include "image/memory_proxy.hpp"
#include "image/read_limits.hpp"
#include "image/subsampled_exr.hpp"

namespace burnish {
namespace {

// A file whose container has been walked.
struct CheckedFile {
    CheckedFile(std::span<const std::byte> bytes_, const std::string& name_)
        : bytes(bytes_),
          name(name_),
          format(require_image_format(bytes, name)),
          structure(check_image_structure(format, bytes, name)) {}

    std::span<const std::byte> bytes;
    const std::string& name;
    ImageFormat format;
    ImageStructure structure;
};

// An image file open in memory. The decoder reads through `source`, which must outlive it.
class Reader {
  public:
    explicit Reader(const CheckedFile& file)
        : name_(file.name),
          format_(file.format),
          filtered_(format_ == ImageFormat::png ? without_unused_chunks(file.bytes)
                                                : std::vector<std::byte>{}),
          source_(filtered_.empty() ? file.bytes : std::span<const std::byte>(filtered_)) {
        input_ = OIIO::ImageInput::create(oiio_format_name(format_));
        if (!input_ || !input_->supports("ioproxy")) {
            fail("no OpenImageIO support for the format");
        }
        input_->set_ioproxy(&source_);
        OIIO::ImageSpec config;
        config.attribute("oiio:UnassociatedAlpha", 1);
        if (!input_->open("", spec_, config)) fail(input_->geterror());
        check_spec(file.bytes.size());
    }

    [[noreturn]] void fail(std::string_view reason) const {
        const std::string found = one_line(reason);
        throw Error(name_, "", fmt::format("a readable {} image", format_name(format_)),
                    found.empty() ? "broken data" : found);
    }

    ImageFormat format() const { return format_; }
    const OIIO::ImageSpec& spec() const { return spec_; }
    const std::string& name() const { return name_; }

    // The leading `channels` channels as texels of `type`.
    std::vector<std::byte> read_pixels(int channels, const OIIO::TypeDesc& type) {
        const auto row_bytes = static_cast<std::uint64_t>(spec_.width) *
                               static_cast<std::uint64_t>(channels) * type.size();
        const int tile = spec_.tile_width > 0 ? std::max(spec_.tile_height, 1) : 1;
        const auto rows = static_cast<std::int64_t>(
            std::max<std::uint64_t>(kBandBytes / row_bytes / static_cast<std::uint64_t>(tile), 1));
        const std::int64_t band = rows * tile;

        std::vector<std::byte> pixels;
        pixels.reserve(static_cast<std::size_t>(row_bytes) *
                       static_cast<std::size_t>(spec_.height));
        for (std::int64_t y = 0; y < spec_.height; y += band) {
            const std::int64_t end = std::min<std::int64_t>(y + band, spec_.height);
            const std::size_t offset = pixels.size();
            pixels.resize(offset +
                          static_cast<std::size_t>(row_bytes) * static_cast<std::size_t>(end - y));
            const bool done =
                read_rows(static_cast<int>(y) + spec_.y, static_cast<int>(end) + spec_.y, channels,
                          type, pixels.data() + offset);
            // Some decoders report an error and return an empty picture.
            if (!done || input_->has_error()) fail(input_->geterror());
        }
        return pixels;
    }

  private:
    bool read_rows(int begin, int end, int channels, const OIIO::TypeDesc& type, std::byte* to) {
        if (spec_.tile_width > 0) {
            return input_->read_tiles(0, 0, spec_.x, spec_.x + spec_.width, begin, end, spec_.z,
                                      spec_.z + 1, 0, channels, type, to);
        }
        // Without a conversion, read_scanlines would still copy through a buffer of 64 MiB.
        if (type == spec_.format && spec_.channelformats.empty() && channels == spec_.nchannels) {
            return input_->read_native_scanlines(0, 0, begin, end, spec_.z, to);
        }
        return input_->read_scanlines(0, 0, begin, end, spec_.z, 0, channels, type, to);
    }

    void check_spec(std::uint64_t file_bytes) const {
        check_image_size(spec_.width, spec_.height, name_);
        if (spec_.deep) fail("a deep image");
        if (spec_.depth > 1) fail("a volume");
        if (spec_.nchannels < 1 || spec_.nchannels > kMaxChannels) {
            fail(fmt::format("{} channels", spec_.nchannels));
        }
        // f32 is the widest texel we decode to.
        const std::uint64_t texel = std::min<std::uint64_t>(spec_.format.size(), sizeof(float));
        const std::uint64_t decoded = static_cast<std::uint64_t>(spec_.width) *
                                      static_cast<std::uint64_t>(spec_.height) *
                                      static_cast<std::uint64_t>(spec_.nchannels) * texel;
        check_decoded_bytes(decoded, file_bytes, name_);
    }

    const std::string& name_;
    ImageFormat format_;
    std::vector<std::byte> filtered_;  // empty when the file is read as it is
    MemoryReader source_;
    OIIO::ImageSpec spec_;
    std::unique_ptr<OIIO::ImageInput> input_;  // after source_: closed before it goes
};

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

// The number of leading channels to read: all of them up to four, else those named R, G, B and A.
int channels_to_read(const Reader& reader) {
    const OIIO::ImageSpec& spec = reader.spec();
    if (spec.nchannels <= 4) return spec.nchannels;
    constexpr const char* kNames[] = {"R", "G", "B", "A"};
    int named = 0;
    while (named < 4 && spec.channelnames[static_cast<std::size_t>(named)] == kNames[named]) {
        ++named;
    }
    if (named < 3) {
        throw Error(reader.name(), "channels", "1 to 4, or leading R, G, B",
                    fmt::format("{} of other names", spec.nchannels));
    }
    return named;
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
                    "finite values", std::isnan(value) ? "NaN" : "infinity");
    }
}

Texture decode(Reader& reader, ColorSpace color_space, bool finite_only) {
    const OIIO::ImageSpec& spec = reader.spec();
    Texture texture;
    texture.name = reader.name();
    texture.width = spec.width;
    texture.height = spec.height;
    texture.channels = channels_to_read(reader);
    texture.type = texel_type_of(spec);
    texture.color_space = texture.type == TexelType::f32 ? ColorSpace::linear : color_space;
    texture.texels = reader.read_pixels(texture.channels, oiio_type(texture.type));
    if (finite_only && texture.type == TexelType::f32) require_finite(texture);

    const bool has_alpha = spec.alpha_channel > 0 && spec.alpha_channel == texture.channels - 1;
    if (has_alpha && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0) unpremultiply(texture);
    return texture;
}

Texture decode(const CheckedFile& file, ColorSpace color_space) {
    if (!file.structure.subsampled) {
        Reader reader(file);
        return decode(reader, color_space, true);
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

bool says_linear(const OIIO::ImageSpec& spec) {
    return OIIO::Strutil::iequals(spec.get_string_attribute("oiio:ColorSpace"), "linear");
}

}  // namespace

Image read_image(const std::filesystem::path& path, const ReadOptions& options) {
    const std::string name = path.string();
    return with_errors_of(name, [&] {
        const std::vector<std::byte> bytes = read_image_file(path);
        const CheckedFile file(bytes, name);
        if (file.structure.subsampled) return image_of_subsampled(file, options);
        Reader reader(file);
        if (reader.spec().nchannels == 2 && reader.spec().alpha_channel != 1) {
            throw Error(name, "channels", "1, 3 or 4, or grey with alpha", "2 of other names");
        }
        const Texture texture = decode(reader, ColorSpace::linear, options.finite_only);
        const bool encoded = texture.type != TexelType::f32 && !says_linear(reader.spec());
        Image image;
        image.width = texture.width;
        image.height = texture.height;
        image.channels = texture.channels == 2 ? 4 : texture.channels;
        image.pixels = values_of(texture, encoded && !options.as_data);
        if (texture.channels == 2) image.pixels = with_gray_spread(image.pixels);
        return image;
    });
}

Texture read_texture(const std::filesystem::path& path, ColorSpace color_space) {
    const std::string name = path.string();
    return with_errors_of(name,
                          [&] { return decode_texture(read_image_file(path), name, color_space); });
}

Texture decode_texture(std::span<const std::byte> bytes, const std::string& name,
                       ColorSpace color_space) {
    return with_errors_of(name, [&] { return decode(CheckedFile(bytes, name), color_space); });
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
                             {}};
        }
        const Reader reader(file);
        info.format = format_name(reader.format());
        info.width = reader.spec().width;
        info.height = reader.spec().height;
        info.channels = reader.spec().nchannels;
        info.pixel_type = reader.spec().format.c_str();
        info.metadata = metadata_of(reader.spec());
        return info;
    });
}

bool is_image_file(const std::filesystem::path& path) {
    try {
        return image_format_of(read_file_head(path, kImageHeadBytes)).has_value();
    } catch (const Error&) {
        return false;
    }
}

}  // namespace burnish
