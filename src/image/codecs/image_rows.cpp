#include "image/image_rows.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>

#include "burnish/error.hpp"
#include "image/codecs/image_metadata.hpp"

namespace burnish {
namespace {

constexpr int kStrip = 64;  // rows at a time, and the tiles of mip maps

// Not every encoder notices a short write; this file records it.
class CheckedOutput final : public OIIO::Filesystem::IOFile {
  public:
    explicit CheckedOutput(const std::string& path) : IOFile(path, Mode::Write) {}
    std::size_t write(const void* from, std::size_t size) override {
        const std::size_t written = IOFile::write(from, size);
        short_ = short_ || written != size;
        return written;
    }
    std::size_t pwrite(const void* from, std::size_t size, std::int64_t offset) override {
        const std::size_t written = IOFile::pwrite(from, size, offset);
        short_ = short_ || written != size;
        return written;
    }
    void flush() const override {
        IOFile::flush();
        short_ = short_ || (m_file != nullptr && std::ferror(m_file) != 0);
    }
    bool failed() const {
        flush();
        return short_;
    }

  private:
    mutable bool short_ = false;
};

OIIO::TypeDesc type_of(DataFormat format) {
    switch (format) {
        case DataFormat::png16:
            return OIIO::TypeUInt16;
        case DataFormat::png8:
        case DataFormat::png8_srgb:
            return OIIO::TypeUInt8;
        case DataFormat::exr:
            break;
    }
    return OIIO::TypeFloat;
}

OIIO::ImageSpec spec_of(const DataPicture& picture, const DataLevel& level) {
    OIIO::ImageSpec spec(level.width, level.height, static_cast<int>(picture.channels.size()),
                         type_of(picture.format));
    spec.channelnames = picture.channels;
    if (picture.channels.size() == 4) {
        spec.alpha_channel = 3;
        spec.attribute("oiio:UnassociatedAlpha", 1);
    }
    spec.attribute("oiio:ColorSpace", picture.format == DataFormat::png8_srgb ? "sRGB" : "Linear");
    if (picture.format != DataFormat::exr) {
        // Noise hardly compresses: the fastest level takes a fifth of the time of level 6.
        spec.attribute("png:compressionLevel", 2);
    } else {
        // The fastest level: level 6, the default, takes three times as long and saves a tenth.
        spec.attribute("Compression", "zip:1");
    }
    if (picture.levels.size() > 1) {
        spec.tile_width = spec.tile_height = kStrip;
        spec.tile_depth = 1;
        spec.attribute("textureformat", "Plain Texture");  // else only one level is allowed
        spec.attribute("openexr:levelmode", 1);            // mip map
        spec.attribute("openexr:roundingmode", 0);         // down
    }
    put_metadata(spec, picture.metadata, true);
    return spec;
}

struct Encoder {
    OIIO::ImageOutput& output;
    const DataPicture& picture;
    std::function<void()> fail;

    void write_level(const DataLevel& level, const std::function<void(double)>& step) const {
        const std::size_t row = static_cast<std::size_t>(level.width) * picture.channels.size();
        std::vector<float> values(row * static_cast<std::size_t>(std::min(kStrip, level.height)));
        for (int y = 0; y < level.height; y += kStrip) {
            const int end = std::min(y + kStrip, level.height);
            level.rows(y, end, values.data());
            if (!write_rows(level.width, y, end, values)) fail();
            step(static_cast<double>(end) / level.height);
        }
    }

    bool write_rows(int width, int y, int end, const std::vector<float>& values) const {
        if (picture.levels.size() > 1)
            return output.write_tiles(0, width, y, end, 0, 1, OIIO::TypeFloat, values.data());
        if (picture.format == DataFormat::exr)
            return output.write_scanlines(y, end, 0, OIIO::TypeFloat, values.data());
        return picture.format == DataFormat::png16 ? write_codes<std::uint16_t>(y, end, values)
                                                   : write_codes<std::uint8_t>(y, end, values);
    }

    template <typename Code>
    bool write_codes(int y, int end, const std::vector<float>& values) const {
        constexpr auto kMost = static_cast<float>(std::numeric_limits<Code>::max());
        std::vector<Code> codes(values.size());
        std::transform(values.begin(), values.end(), codes.begin(), [](float value) {
            const float clamped = value > 0.0f ? (value < 1.0f ? value : 1.0f) : 0.0f;
            return static_cast<Code>(clamped * kMost + 0.5f);
        });
        return output.write_scanlines(y, end, 0, type_of(picture.format), codes.data());
    }
};

}  // namespace

namespace oiio {

void write_data_picture(const std::filesystem::path& path, const DataPicture& picture,
                        const std::string& name, const std::function<void(double)>& step) {
    const char* format = picture.format == DataFormat::exr ? "openexr" : "png";
    CheckedOutput file(path.string());
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
    const auto fail = [&] {
        const std::string reason = one_line(output ? output->geterror() : OIIO::geterror());
        throw Error(name, "", "a file that can be written",
                    file.failed() ? "no space, or a write error" : reason);
    };
    if (file.mode() != OIIO::Filesystem::IOProxy::Mode::Write || !output ||
        !output->supports("ioproxy"))
        fail();
    const Encoder encoder{*output, picture, fail};
    for (std::size_t i = 0; i < picture.levels.size(); ++i) {
        OIIO::ImageSpec spec = spec_of(picture, picture.levels[i]);
        if (i == 0) output->set_ioproxy(&file);
        const auto mode = i == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendMIPLevel;
        if (!output->open(path.string(), spec, mode)) fail();
        // The first level holds three quarters of the work.
        encoder.write_level(picture.levels[i], [&](double done) { step(i == 0 ? done : 1.0); });
    }
    if (!output->close() || output->has_error() || file.failed()) fail();
    file.close();
}

}  // namespace oiio

}  // namespace burnish
