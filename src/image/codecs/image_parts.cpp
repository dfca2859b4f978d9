#include "image/image_parts.hpp"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <span>

#include "burnish/error.hpp"
#include "core/files.hpp"
#include "image/codecs/image_metadata.hpp"
#include "image/codecs/memory_proxy.hpp"
#include "image/codecs/read_limits.hpp"
#include "image/guard/format.hpp"

namespace burnish {
namespace {

constexpr int kMaxParts = 64;
constexpr const char* kPartName = "oiio:subimagename";

// Attributes that OpenImageIO and OpenEXR add.
bool is_of_the_format(std::string_view name) {
    constexpr std::string_view kOwn[] = {"compression", "PixelAspectRatio", "screenWindowCenter",
                                         "screenWindowWidth", "Software"};
    return name.starts_with("oiio:") || name.starts_with("openexr:") ||
           std::find(std::begin(kOwn), std::end(kOwn), name) != std::end(kOwn);
}

[[noreturn]] void fail(const std::string& name, std::string_view reason) {
    const std::string found = one_line(reason);
    throw Error(name, "", "a readable OpenEXR image of several parts",
                found.empty() ? "broken data" : found);
}

// The bytes of all parts so far, decoded. They are checked before memory of that size is allocated.
class Budget {
  public:
    Budget(std::uint64_t file_bytes, const std::string& name)
        : file_bytes_(file_bytes), name_(name) {}

    void spend(const OIIO::ImageSpec& spec) {
        check_image_size(spec.width, spec.height, name_);
        if (spec.deep) fail(name_, "a deep image");
        if (spec.depth > 1) fail(name_, "a volume");
        if (spec.nchannels < 1 || spec.nchannels > kMaxChannels)
            fail(name_, fmt::format("{} channels", spec.nchannels));
        spent_ += static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height) *
                  static_cast<std::uint64_t>(spec.nchannels) * sizeof(float);
        check_decoded_bytes(spent_, file_bytes_, name_);
    }

  private:
    std::uint64_t file_bytes_, spent_ = 0;
    const std::string& name_;
};

void read_attributes(const OIIO::ImageSpec& spec, ImagePart& part) {
    for (const OIIO::ParamValue& value : spec.extra_attribs) {
        const std::string name = one_line(value.name().string());
        if (is_of_the_format(name)) continue;
        if (value.type() == OIIO::TypeInt) {
            part.integers.emplace(name, value.get_int());
        } else if (value.type() == OIIO::TypeFloat) {
            part.reals.emplace(name, static_cast<double>(value.get_float()));
        } else if (value.type() == OIIO::TypeDesc::DOUBLE) {
            double number = 0;
            std::memcpy(&number, value.data(), sizeof number);
            part.reals.emplace(name, number);
        } else if (value.type() == OIIO::TypeString) {
            part.texts.emplace(name, one_line(value.get_string()));
        }
    }
}

bool read_rows(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, int part, int begin, int end,
               float* to) {
    if (spec.tile_width > 0) {
        return input.read_tiles(part, 0, spec.x, spec.x + spec.width, spec.y + begin, spec.y + end,
                                spec.z, spec.z + 1, 0, spec.nchannels, OIIO::TypeFloat, to);
    }
    return input.read_scanlines(part, 0, spec.y + begin, spec.y + end, spec.z, 0, spec.nchannels,
                                OIIO::TypeFloat, to);
}

ImagePart read_part(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, int index,
                    const std::string& name) {
    ImagePart part;
    part.name = one_line(spec.get_string_attribute(kPartName));
    part.width = spec.width;
    part.height = spec.height;
    read_attributes(spec, part);
    const auto width = static_cast<std::size_t>(spec.width);
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    for (std::size_t c = 0; c < channels; ++c) {
        ImageChannel channel;
        channel.name = spec.channelnames[c];
        channel.half = spec.channelformat(static_cast<int>(c)) == OIIO::TypeHalf;
        part.channels.push_back(std::move(channel));
    }
    const int tile = spec.tile_width > 0 ? std::max(spec.tile_height, 1) : 1;
    const std::uint64_t row_bytes = width * channels * sizeof(float);
    const int rows = static_cast<int>(std::max<std::uint64_t>(kBandBytes / row_bytes, 1));
    const int band = std::min((rows + tile - 1) / tile * tile, 1 << 20);
    std::vector<float> mixed;
    for (int y = 0; y < spec.height; y += band) {
        const int end = std::min(y + band, spec.height);
        mixed.resize(width * channels * static_cast<std::size_t>(end - y));
        const bool done = read_rows(input, spec, index, y, end, mixed.data());
        if (!done || input.has_error()) fail(name, input.geterror());
        for (std::size_t c = 0; c < channels; ++c) {
            std::vector<float>& values = part.channels[c].values;
            for (std::size_t i = c; i < mixed.size(); i += channels) values.push_back(mixed[i]);
        }
    }
    return part;
}

std::vector<ImagePart> read_parts(std::span<const std::byte> bytes, const std::string& name) {
    if (check_image_structure(ImageFormat::exr, bytes, name).subsampled)
        fail(name, "a subsampled channel");
    MemoryReader source(bytes);
    const auto input = OIIO::ImageInput::create(oiio_format_name(ImageFormat::exr));
    if (!input || !input->supports("ioproxy")) fail(name, "no support for the format");
    input->set_ioproxy(&source);
    OIIO::ImageSpec first;
    if (!input->open("", first, OIIO::ImageSpec())) fail(name, input->geterror());
    Budget budget(bytes.size(), name);
    std::vector<OIIO::ImageSpec> specs;
    for (int i = 0; i < kMaxParts && input->seek_subimage(i, 0); ++i) {
        specs.push_back(input->spec(i));
        budget.spend(specs.back());
    }
    static_cast<void>(input->geterror());  // "no further part", which is no error here
    std::vector<ImagePart> parts;
    for (std::size_t i = 0; i < specs.size(); ++i)
        parts.push_back(read_part(*input, specs[i], static_cast<int>(i), name));
    return parts;
}

void require_sound(const ImagePart& part, const std::string& name) {
    check_image_size(part.width, part.height, name);
    const std::size_t values =
        static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height);
    const bool full = std::all_of(part.channels.begin(), part.channels.end(),
                                  [&](const ImageChannel& c) { return c.values.size() == values; });
    if (!full || part.channels.empty() || part.channels.size() > kMaxChannels) {
        throw Error(name, part.name, fmt::format("1 to {} full channels", kMaxChannels),
                    fmt::format("{} channels", part.channels.size()));
    }
}

OIIO::ImageSpec spec_of(const ImagePart& part, int full_width, int full_height) {
    OIIO::ImageSpec spec(part.width, part.height, static_cast<int>(part.channels.size()),
                         OIIO::TypeFloat);
    // All parts of a file have one display window.
    spec.full_width = full_width;
    spec.full_height = full_height;
    spec.channelnames.clear();
    for (const ImageChannel& channel : part.channels) {
        spec.channelnames.push_back(channel.name);
        spec.channelformats.push_back(channel.half ? OIIO::TypeHalf : OIIO::TypeFloat);
    }
    spec.attribute(kPartName, part.name);
    spec.attribute("compression", "zip");
    for (const auto& [key, value] : part.integers) spec.attribute(key, value);
    for (const auto& [key, value] : part.reals) spec.attribute(key, OIIO::TypeDesc::DOUBLE, &value);
    for (const auto& [key, value] : part.texts) spec.attribute(key, one_line(value));
    return spec;
}

std::vector<float> interleaved(const ImagePart& part) {
    const std::size_t channels = part.channels.size();
    std::vector<float> mixed(part.channels[0].values.size() * channels);
    for (std::size_t c = 0; c < channels; ++c)
        for (std::size_t i = 0; i < part.channels[c].values.size(); ++i)
            mixed[i * channels + c] = part.channels[c].values[i];
    return mixed;
}

// Writes to a file, because OpenImageIO 2.4 does not write several parts to memory. OpenEXR checks
// every write.
void encode(const std::vector<ImagePart>& parts, const std::string& target,
            const std::string& name) {
    const auto output = OIIO::ImageOutput::create(oiio_format_name(ImageFormat::exr));
    const auto wrong = [&] {
        throw Error(name, "", "to encode an OpenEXR image of several parts",
                    one_line(output ? output->geterror() : OIIO::geterror()));
    };
    // OpenEXR wraps the message of the system in many words.
    const auto unwritable = [&] {
        const int reason = errno;
        if (reason != ENOSPC && reason != EFBIG && reason != EDQUOT) wrong();
        throw Error(name, "", "a file that can be written", reason_of(reason));
    };
    if (!output || !output->supports("multiimage")) wrong();
    int full_width = 0, full_height = 0;
    for (const ImagePart& part : parts) {
        full_width = std::max(full_width, part.width);
        full_height = std::max(full_height, part.height);
    }
    std::vector<OIIO::ImageSpec> specs;
    specs.reserve(parts.size());
    for (const ImagePart& part : parts) specs.push_back(spec_of(part, full_width, full_height));
    errno = 0;
    if (!output->open(target, static_cast<int>(specs.size()), specs.data())) unwritable();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i > 0 && !output->open(target, specs[i], OIIO::ImageOutput::AppendSubimage))
            unwritable();
        if (!output->write_image(OIIO::TypeFloat, interleaved(parts[i]).data())) unwritable();
    }
    if (!output->close() || output->has_error()) unwritable();
}

}  // namespace

namespace oiio {

std::vector<ImagePart> read_image_parts(const std::filesystem::path& path) {
    const std::string name = path.string();
    try {
        const auto format = image_format_of(read_file_head(path, kImageHeadBytes));
        if (format != ImageFormat::exr) throw Error(name, "", "an OpenEXR image", "another file");
        return read_parts(read_file(path), name);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw Error(name, "", "an image that fits into memory", "a larger one");
    } catch (const std::exception& error) {
        fail(name, error.what());
    }
}

void write_image_parts(const std::filesystem::path& path, const std::vector<ImagePart>& parts) {
    const std::string name = path.string();
    if (parts.empty() || parts.size() > kMaxParts)
        throw Error(name, "", fmt::format("1 to {} parts", kMaxParts),
                    std::to_string(parts.size()));
    for (const ImagePart& part : parts) require_sound(part, name);
    write_file_whole(path, [&](const std::filesystem::path& target) {
        try {
            encode(parts, target.string(), name);
        } catch (const Error&) {
            throw;
        } catch (const std::exception& error) {
            throw Error(name, "", "to encode an OpenEXR image of several parts",
                        one_line(error.what()));
        }
    });
}

bool has_image_part_attribute(const std::filesystem::path& path, std::string_view name) {
    // The first header of a file of write_image_parts is far shorter.
    constexpr std::size_t kHead = std::size_t{64} << 10;
    std::vector<std::byte> head;
    try {
        head = read_file_head(path, kHead);
    } catch (const Error&) {
        return false;
    }
    if (image_format_of(head) != ImageFormat::exr) return false;
    using namespace std::string_view_literals;
    const std::string wanted = std::string(name) + std::string("\0int\0"sv);
    const auto bytes = std::as_bytes(std::span(wanted));
    return std::search(head.begin(), head.end(), bytes.begin(), bytes.end()) != head.end();
}

}  // namespace oiio

}  // namespace burnish
