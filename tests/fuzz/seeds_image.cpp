// Pictures in every format that is read.
#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <span>
#include <stdexcept>

#include "burnish/image_io.hpp"
#include "core/files.hpp"
#include "harness.hpp"
#include "seeds.hpp"
#include "support/dng_writer.hpp"

// The encoder of HEIC does not free all it allocates; only seeds are made with it.
extern "C" const char* __asan_default_options() {
    return "detect_leaks=0";
}

namespace burnish::fuzz {
namespace {

using namespace std::string_literals;

std::string content_of(const std::filesystem::path& path) {
    const std::vector<std::byte> bytes = read_file(path);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string written_by_us(const char* extension, int channels) {
    const auto path = folder() / ("seed"s + extension);
    write_image(path, Image(3, 2, channels, 0.25f), {});
    return content_of(path);
}

// By OpenImageIO: formats that we read only.
std::string written(const char* format, const char* extension, const OIIO::ImageSpec& spec) {
    const auto path = folder() / ("seed"s + extension);
    const auto output = OIIO::ImageOutput::create(format);
    // The encoder of HEIF reads whole strides, beyond the end of the last row.
    constexpr std::size_t kSlack = 1024;
    const std::vector<unsigned char> pixels(
        static_cast<std::size_t>(spec.image_pixels()) * 4 + kSlack, 90);
    if (!output || !output->open(path.string(), spec) ||
        !output->write_image(OIIO::TypeUInt8, pixels.data()) || !output->close())
        throw std::runtime_error("no seed of "s + format);
    return content_of(path);
}

OIIO::ImageSpec small_spec(int channels, const char* compression = "") {
    OIIO::ImageSpec spec(8, 8, channels, OIIO::TypeUInt8);
    if (*compression != '\0') spec.attribute("compression", compression);
    return spec;
}

OIIO::ImageSpec layered_spec() {
    OIIO::ImageSpec spec(4, 4, 4, OIIO::TypeHalf);
    spec.channelnames = {"a.R", "a.G", "a.B", "d.Z"};
    spec.x = 2;
    spec.full_x = -1;
    spec.full_width = 9;
    spec.full_height = 3;
    return spec;
}

std::string dng(bool has_preview) {
    test::DngSettings settings;
    settings.has_preview = has_preview;
    const std::vector<std::byte> bytes = test::dng_of(Image(22, 22, 3, 0.25f), settings);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// The smallest headers of formats whose encoders write only a few kinds.
void add_by_hand(Words& seeds) {
    const std::string tga_runs = "\0\1\x09\0\0\2\0\x18\0\0\0\0\3\0\1\0\x08\x20"s;
    seeds.push_back(tga_runs + "\1\2\3\4\5\6\x81\1\0\0"s);
    const std::string bmp = "BM\x48\0\0\0\0\0\0\0\x3e\0\0\0\x28\0\0\0\3\0\0\0\1\0\0\0\1\0"s;
    const std::string palette = "\2\0\0\0\0\0\0\0\1\2\3\0\4\5\6\0"s;
    seeds.push_back(bmp + "\x08\0\1\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"s + palette + "\2\1\1\0\0\1"s);
    seeds.push_back(bmp + "\4\0\2\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"s + palette + "\3\x10\0\1"s);
    seeds.push_back(bmp + "\1\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"s + palette + "\xA0\0\0\0"s);
    seeds.push_back("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n" + std::string(16, '\x40'));
    seeds.push_back("FUJIFILMCCD-RAW 0201"s + std::string(200, '\0'));
}

}  // namespace

Words image_seeds() {
    Words seeds;
    for (const char* extension : {".png", ".tif", ".jpg", ".exr"})
        for (const int channels : {1, 3, 4}) seeds.push_back(written_by_us(extension, channels));
    for (const int channels : {1, 3, 4}) {
        seeds.push_back(written("targa", ".tga", small_spec(channels, "none")));
        seeds.push_back(written("targa", ".tga", small_spec(channels, "rle")));
    }
    for (const int channels : {3, 4}) {
        seeds.push_back(written("webp", ".webp", small_spec(channels)));
        seeds.push_back(written("bmp", ".bmp", small_spec(channels)));
        seeds.push_back(written("heif", ".heic", small_spec(channels)));
        seeds.push_back(written("heif", ".avif", small_spec(channels, "avif:80")));
    }
    seeds.push_back(written("openexr", ".exr", layered_spec()));
    for (const bool has_preview : {false, true}) seeds.push_back(dng(has_preview));
    add_by_hand(seeds);
    return seeds;
}

Words image_words() {
    return {"\x89PNG\r\n\x1a\n",
            "IHDR",
            "IDAT",
            "IEND",
            "PLTE",
            "tRNS",
            "iCCP",
            "gAMA",
            "zTXt",
            "\xFF\xD8\xFF",
            "II*\0"s,
            "MM\0*"s,
            "\x76\x2f\x31\x01",
            "#?RADIANCE",
            "channels",
            "chlist",
            "compression",
            "dataWindow",
            "displayWindow",
            "box2i",
            "a.R",
            "FORMAT=32-bit_rle_rgbe",
            "-Y 2 +X 2",
            "RIFF",
            "WEBP",
            "VP8 ",
            "VP8L",
            "VP8X",
            "ALPH",
            "ANIM",
            "\x9d\x01\x2a",
            "BM",
            "TRUEVISION-XFILE.\0"s,
            "ftyp",
            "heic",
            "avif",
            "mif1",
            "meta",
            "iprp",
            "ipco",
            "ispe",
            "iloc",
            "grid",
            "auxC",
            "irot",
            "mdat",
            "FUJIFILMCCD-RAW",
            "IIRO",
            "IIU\0"s,
            "\xfe\0\4\0"s,  // tags of TIFF, little-endian, with their types
            "\x4a\1\4\0"s,
            "\x12\xc6\1\0"s,
            "\6\1\3\0"s,
            "\x23\x80"s};
}

}  // namespace burnish::fuzz
