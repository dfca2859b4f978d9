#include "image/codecs/image_file.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>

#include "burnish/error.hpp"
#include "core/files.hpp"
#include "image/codecs/exr_channels.hpp"
#include "image/codecs/heif_size.hpp"
#include "image/codecs/read_limits.hpp"
#include "image/guard/container_checks.hpp"
#include "image/guard/png_chunks.hpp"

namespace burnish {
namespace {

// What a decoder is given in place of the whole file; empty: the whole file.
std::vector<std::byte> without_unused_parts(const CheckedFile& file) {
    if (file.format == ImageFormat::png) return without_unused_chunks(file.bytes);
    if (file.format != ImageFormat::tga) return {};
    const auto kept = without_tga_end(file.bytes);
    if (kept.size() == file.bytes.size()) return {};
    return {kept.begin(), kept.end()};
}

// Sensor values as linear numbers, white at 1: black level subtracted, demosaiced by a linear
// operator, so that sums of lights stay sums, in the sensor's own orientation and color. All
// multipliers are 1: a white balance would clip channels and may differ from picture to picture.
void configure_raw(OIIO::ImageSpec& config) {
    constexpr float kNoBalance[4] = {1.0f, 1.0f, 1.0f, 1.0f};
    config.attribute("raw:use_camera_wb", 0);
    config.attribute("raw:user_mul", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 4), kNoBalance);
    config.attribute("raw:use_camera_matrix", 0);
    config.attribute("raw:ColorSpace", "raw");
    config.attribute("raw:auto_bright", 0);
    config.attribute("raw:adjust_maximum_thr", 0.0f);
    config.attribute("raw:HighlightMode", 0);
    config.attribute("raw:Demosaic", "linear");
    config.attribute("raw:user_flip", 0);
}

// A file without a name: in memory where the system has that, else temporary.
int open_unnamed() {
#ifdef __linux__
    return ::memfd_create("burnish-image", MFD_CLOEXEC);
#else
    std::FILE* temporary = std::tmpfile();
    const int number = temporary != nullptr ? ::dup(::fileno(temporary)) : -1;
    if (temporary != nullptr) std::fclose(temporary);
    return number;
#endif
}

std::string with_replaced(std::string text, const std::string& part, const std::string& by) {
    for (std::size_t at = text.find(part); !part.empty() && at != std::string::npos;
         at = text.find(part, at + by.size()))
        text.replace(at, part.size(), by);
    return text;
}

}  // namespace

// ---- FileInMemory -------------------------------------------------------------------------------

FileInMemory::FileInMemory(std::span<const std::byte> bytes, const std::string& name)
    : number_(open_unnamed()) {
    const auto fail = [&] {
        throw Error(name, "", "memory for a copy of the file", reason_of(errno));
    };
    if (number_ < 0) fail();
    path_ = fmt::format("/dev/fd/{}", number_);
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t count = ::write(number_, bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) {
            ::close(number_);
            fail();
        }
        done += static_cast<std::size_t>(count);
    }
    ::lseek(number_, 0, SEEK_SET);
}

FileInMemory::~FileInMemory() {
    ::close(number_);
}

// ---- ImageFile ----------------------------------------------------------------------------------

ImageFile::ImageFile(const CheckedFile& file)
    : name_(file.name),
      format_(file.format),
      filtered_(without_unused_parts(file)),
      source_(filtered_.empty() ? file.bytes : std::span<const std::byte>(filtered_)),
      input_(OIIO::ImageInput::create(oiio_format_name(format_))) {
    if (!input_) fail("no OpenImageIO support for the format");
    if (!input_->supports("ioproxy")) on_disk_ = std::make_unique<FileInMemory>(file.bytes, name_);
    open();
    if (format_ == ImageFormat::exr) choose_part();
    check_spec(file.bytes.size());
    if (format_ != ImageFormat::heif && format_ != ImageFormat::avif) return;
    const std::string fault = heif_size_fault(file.bytes, spec_.width, spec_.height);
    if (!fault.empty()) fail(fault);
}

void ImageFile::open() {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    if (format_ == ImageFormat::raw) configure_raw(config);
    if (!on_disk_) input_->set_ioproxy(&source_);
    if (!input_->open(on_disk_ ? on_disk_->path() : std::string(), spec_, config))
        fail(input_->geterror());
}

// The first part with R, G and B, as depth or normals may come before it; else the first.
void ImageFile::choose_part() {
    constexpr int kMostParts = 64;  // as many as the walk lets pass
    for (int part = 0; part < kMostParts; ++part) {
        const OIIO::ImageSpec spec = input_->spec(part);
        if (spec.undefined()) break;
        if (!has_color(spec)) continue;
        if (color_parts_.empty()) {
            part_ = part;
            spec_ = spec;
        }
        color_parts_.push_back(one_line(spec.get_string_attribute("oiio:subimagename")));
    }
    if (input_->has_error()) fail(input_->geterror());
    // Looking at the parts has moved on to the last one, whose channels would be read.
    if (!input_->seek_subimage(part_, 0)) fail(input_->geterror());
}

void ImageFile::fail(std::string_view reason) const {
    std::string found = one_line(reason);
    if (on_disk_) found = with_replaced(found, on_disk_->path(), "it");
    if (found.empty()) found = "broken data";
    if (format_ == ImageFormat::raw)
        throw Error(name_, "",
                    "a raw camera file that LibRaw reads, without a preview in its place",
                    found + ": develop it to a linear 16-bit TIFF");
    if (format_ == ImageFormat::heif || format_ == ImageFormat::avif)
        found += ": convert it to PNG, if other programs show it";
    throw Error(name_, "", fmt::format("a readable {} image", format_name(format_)), found);
}

PixelWindow ImageFile::data_window() const {
    return {spec_.x, spec_.y, spec_.width, spec_.height};
}

PixelWindow ImageFile::display_window() const {
    if (format_ != ImageFormat::exr) return data_window();
    return {spec_.full_x, spec_.full_y, spec_.full_width, spec_.full_height};
}

bool ImageFile::is_linear() const {
    return format_ == ImageFormat::raw ||
           OIIO::Strutil::iequals(spec_.get_string_attribute("oiio:ColorSpace"), "linear");
}

std::vector<std::byte> ImageFile::read_pixels(int first, int count, const OIIO::TypeDesc& type) {
    const auto row_bytes =
        static_cast<std::uint64_t>(spec_.width) * static_cast<std::uint64_t>(count) * type.size();
    const int tile = spec_.tile_width > 0 ? std::max(spec_.tile_height, 1) : 1;
    const auto rows = static_cast<std::int64_t>(
        std::max<std::uint64_t>(kBandBytes / row_bytes / static_cast<std::uint64_t>(tile), 1));
    const std::int64_t band = rows * tile;

    std::vector<std::byte> pixels;
    pixels.reserve(static_cast<std::size_t>(row_bytes) * static_cast<std::size_t>(spec_.height));
    for (std::int64_t y = 0; y < spec_.height; y += band) {
        const std::int64_t end = std::min<std::int64_t>(y + band, spec_.height);
        const std::size_t offset = pixels.size();
        pixels.resize(offset +
                      static_cast<std::size_t>(row_bytes) * static_cast<std::size_t>(end - y));
        const bool done = read_rows(static_cast<int>(y) + spec_.y, static_cast<int>(end) + spec_.y,
                                    first, count, type, pixels.data() + offset);
        // Some decoders report an error and return an empty picture.
        if (!done || input_->has_error()) fail(input_->geterror());
    }
    return pixels;
}

bool ImageFile::read_rows(int begin, int end, int first, int count, const OIIO::TypeDesc& type,
                          std::byte* to) {
    if (spec_.tile_width > 0) {
        return input_->read_tiles(part_, 0, spec_.x, spec_.x + spec_.width, begin, end, spec_.z,
                                  spec_.z + 1, first, first + count, type, to);
    }
    // Without a conversion, read_scanlines would still copy through a buffer of 64 MiB.
    if (type == spec_.format && spec_.channelformats.empty() && count == spec_.nchannels) {
        return input_->read_native_scanlines(part_, 0, begin, end, spec_.z, to);
    }
    return input_->read_scanlines(part_, 0, begin, end, spec_.z, first, first + count, type, to);
}

void ImageFile::check_spec(std::uint64_t file_bytes) const {
    check_image_size(spec_.width, spec_.height, name_);
    if (spec_.deep) fail("a deep image");
    if (spec_.depth > 1) fail("a volume");
    if (spec_.nchannels < 1 || spec_.nchannels > kMaxChannels) {
        fail(fmt::format("{} channels", spec_.nchannels));
    }
    // f32 is the widest texel we decode to.
    const std::uint64_t texel = std::min<std::uint64_t>(spec_.format.size(), sizeof(float));
    for (const PixelWindow& window : {data_window(), display_window()}) {
        const std::uint64_t decoded = static_cast<std::uint64_t>(window.width) *
                                      static_cast<std::uint64_t>(window.height) *
                                      static_cast<std::uint64_t>(spec_.nchannels) * texel;
        check_decoded_bytes(decoded, file_bytes, name_);
    }
    // The lossless codes of cameras spend at least a bit on a sample.
    const std::uint64_t pixels =
        static_cast<std::uint64_t>(spec_.width) * static_cast<std::uint64_t>(spec_.height);
    if (format_ == ImageFormat::raw && pixels / 8 > file_bytes)
        fail(fmt::format("{} bytes for {} x {} pixels", file_bytes, spec_.width, spec_.height));
}

}  // namespace burnish
