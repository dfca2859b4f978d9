#include "capture/stack/image_stack.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <span>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "capture/stack/stack_layout.hpp"
#include "capture/stack/stage_file.hpp"
#include "core/files.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;

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
    std::uint64_t bytes() const {
        return static_cast<std::uint64_t>(::lseek(number_, 0, SEEK_END));
    }

    // An unnamed file: in memory if the system supports that, else temporary.
    static OpenFile unnamed() {
#ifdef __linux__
        const int memory = ::memfd_create("burnish-stack", MFD_CLOEXEC);
        if (memory >= 0) return OpenFile(memory);
#endif
        std::FILE* temporary = std::tmpfile();
        const int number = temporary != nullptr ? ::dup(::fileno(temporary)) : -1;
        if (temporary != nullptr) std::fclose(temporary);
        if (number < 0) throw Error("temporary file", "", "one that can be made", reason_of(errno));
        return OpenFile(number);
    }

  private:
    explicit OpenFile(int number) : number_(number) {}
    int number_;
};

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
    const StackSource source = files_of(rig);
    write_file_whole(cache, [&](const fs::path& temporary) {
        const OpenFile file(temporary, O_RDWR);
        write_stack(file.number(), name_, source, identity_, band_bytes, progress);
    });
    if (!open_cache(cache))
        throw Error(name_, "", "the stack that was just written", "something else");
}

ImageStack::ImageStack(const StackSource& source, const Progress& progress, std::size_t band_bytes)
    : name_("pictures in memory") {
    if (source.lights == 0) throw Error(name_, "lights", "at least one light", "none");
    const OpenFile file = OpenFile::unnamed();
    write_stack(file.number(), name_, source, identity_, band_bytes, progress);
    const int own = ::dup(file.number());
    if (own < 0 || !open(own, file.bytes()))
        throw Error(name_, "", "the stack that was just written", "something else");
}

ImageStack::~ImageStack() {
    if (file_ >= 0) ::close(file_);
}

bool ImageStack::open_cache(const fs::path& cache) {
    const int file = ::open(cache.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return false;
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(cache, error);
    if (!error && open(file, bytes)) return true;
    ::close(file);
    return false;
}

bool ImageStack::open(int file, std::uint64_t bytes) {
    StackHeader header{};
    const bool whole =
        bytes >= sizeof header &&
        ::pread(file, &header, sizeof header, 0) == static_cast<ssize_t>(sizeof header) &&
        std::memcmp(header.magic, kStackMagic, sizeof kStackMagic) == 0 &&
        header.identity == identity_ && header.width <= 32768 && header.height <= 32768 &&
        header.lights <= 1'000'000 && header.width > 0 && header.height > 0 && header.lights > 0 &&
        header.band_pixels > 0 &&
        bytes == data_start(header) + 6 * header.width * header.height * header.lights;
    if (!whole) return false;
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
