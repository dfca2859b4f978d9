#include "samples.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <random>

#include "burnish/error.hpp"

namespace burnish::test {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    std::random_device random;
    path_ = fs::temp_directory_path() /
            ("burnish_test_" + std::to_string(random()) + std::to_string(random()));
    fs::create_directory(path_);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code error;
    fs::remove_all(path_, error);
}

std::size_t TemporaryFolder::entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
}

void save(const fs::path& path, std::span<const std::byte> bytes) {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    ASSERT_TRUE(file.flush().good());
}

Bytes load(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

Image sample_picture(int width, int height, int channels) {
    Image image(width, height, channels);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> noise(-0.05f, 0.05f);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < channels; ++c) {
                const float wave = std::sin(0.3f * static_cast<float>(x * (c + 1) + y));
                image.at(x, y)[c] = 0.5f + 0.4f * wave + noise(random);
            }
        }
    }
    return image;
}

const std::vector<Encoding>& encodings() {
    static const std::vector<Encoding> all = {
        {"png8", "png", "uint8", 3, {}},
        {"png8_alpha", "png", "uint8", 4, {}},
        {"png8_grey_alpha", "png", "uint8", 2, {}},
        {"png16_grey", "png", "uint16", 1, {}},
        {"jpeg", "jpeg", "uint8", 3, {}},
        {"jpeg_progressive", "jpeg", "uint8", 3, {"jpeg:progressive=1"}},
        {"jpeg_grey", "jpeg", "uint8", 1, {}},
        {"tiff_plain", "tiff", "uint8", 3, {"compression=none", "tiff:write_exif=0"}},
        {"tiff_zip16", "tiff", "uint16", 3, {"compression=zip", "tiff:write_exif=0"}},
        {"tiff_lzw_alpha", "tiff", "uint8", 4, {"compression=lzw", "tiff:write_exif=0"}},
        {"tiff_packbits", "tiff", "uint8", 1, {"compression=packbits", "tiff:write_exif=0"}},
        {"tiff_jpeg", "tiff", "uint8", 3, {"compression=jpeg", "tiff:write_exif=0"}},
        {"tiff_float_tiled",
         "tiff",
         "float",
         3,
         {"compression=zip", "tile=16", "tiff:write_exif=0"}},
        {"tiff_planar", "tiff", "uint8", 3, {"planarconfig=separate", "tiff:write_exif=0"}},
        {"exr_half_zip", "openexr", "half", 3, {"compression=zip"}},
        {"exr_float_piz", "openexr", "float", 4, {"compression=piz"}},
        {"exr_half_tiled", "openexr", "half", 3, {"compression=zips", "tile=16"}},
        {"exr_plain", "openexr", "float", 1, {"compression=none"}},
        {"exr_half_dwaa", "openexr", "half", 3, {"compression=dwaa"}},
        {"exr_half_b44", "openexr", "half", 3, {"compression=b44"}},
        {"exr_float_pxr24", "openexr", "float", 3, {"compression=pxr24"}},
        {"exr_rle", "openexr", "half", 3, {"compression=rle"}},
        {"hdr", "hdr", "float", 3, {}},
        {"webp_lossy", "webp", "uint8", 3, {"CompressionQuality=95"}},
        {"webp_alpha", "webp", "uint8", 4, {"CompressionQuality=95"}},
        {"tga", "targa", "uint8", 3, {"compression=none"}},
        {"tga_alpha", "targa", "uint8", 4, {"compression=none"}},
        {"tga_grey_runs", "targa", "uint8", 1, {"compression=rle"}},
        {"tga_runs", "targa", "uint8", 3, {"compression=rle"}},
        {"bmp", "bmp", "uint8", 3, {}},
        {"bmp_alpha", "bmp", "uint8", 4, {}},
        {"heic", "heif", "uint8", 3, {"CompressionQuality=95"}},
        {"avif", "heif", "uint8", 3, {"compression=avif:95"}},
    };
    return all;
}

Bytes encode(const Encoding& encoding, const Image& picture) {
    OIIO::ImageSpec spec(picture.width, picture.height, encoding.channels,
                         OIIO::TypeDesc(encoding.pixel_type));
    // Every encoder keeps the values unchanged, so that reading must return what was written.
    spec.attribute("oiio:UnassociatedAlpha", 1);
    for (const std::string& attribute : encoding.attributes) {
        const std::size_t equals = attribute.find('=');
        const std::string name = attribute.substr(0, equals), value = attribute.substr(equals + 1);
        if (name == "tile") {
            spec.tile_width = spec.tile_height = std::atoi(value.c_str());
        } else if (value.find_first_not_of("0123456789") == std::string::npos) {
            spec.attribute(name, std::atoi(value.c_str()));
        } else {
            spec.attribute(name, value);
        }
    }
    const auto output = OIIO::ImageOutput::create(encoding.format);
    if (output && !output->supports("ioproxy")) {
        // The ending tells the encoder which of its formats is wanted.
        const TemporaryFolder folder;
        const fs::path path = folder / ("sample." + encoding.label);
        // The encoder of HEIF reads whole strides, beyond the end of the last row: it gets bytes
        // that need no conversion, and some more.
        constexpr std::size_t kSlack = 1024;
        std::vector<unsigned char> codes(picture.pixels.size() + kSlack);
        for (std::size_t i = 0; i < picture.pixels.size(); ++i)
            codes[i] = static_cast<unsigned char>(
                std::lround(255.0f * std::clamp(picture.pixels[i], 0.0f, 1.0f)));
        const bool done = output->open(path.string(), spec) &&
                          output->write_image(OIIO::TypeUInt8, codes.data()) && output->close();
        EXPECT_TRUE(done) << encoding.label << ": " << output->geterror();
        return load(path);
    }
    OIIO::Filesystem::IOVecOutput target;
    const bool done =
        output && output->set_ioproxy(&target) && output->open("sample." + encoding.format, spec) &&
        output->write_image(OIIO::TypeFloat, picture.pixels.data()) && output->close();
    EXPECT_TRUE(done) << encoding.label << ": " << (output ? output->geterror() : "no encoder");
    const auto bytes = std::as_bytes(std::span(target.buffer()));
    return {bytes.begin(), bytes.end()};
}

namespace {

void append_u32(std::string& text, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(value >> shift & 0xFFU);
}

std::uint32_t crc32_of(const std::string& text) {
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const char c : text) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    return ~crc;
}

void append_chunk(std::string& png, const std::string& type, const std::string& data) {
    append_u32(png, static_cast<std::uint32_t>(data.size()));
    png += type + data;
    append_u32(png, crc32_of(type + data));
}

// A zlib stream of one stored block (RFC 1950, 1951); at most 65,535 bytes.
std::string stored_zlib(const std::string& data) {
    const auto length = static_cast<std::uint32_t>(data.size());
    std::string stream = "\x78\x01\x01";
    for (const std::uint32_t half : {length, ~length}) {
        stream += static_cast<char>(half & 0xFFU);
        stream += static_cast<char>(half >> 8 & 0xFFU);
    }
    stream += data;
    std::uint32_t a = 1, b = 0;
    for (const char c : data) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    append_u32(stream, b << 16 | a);
    return stream;
}

}  // namespace

Bytes png_of(std::uint32_t width, std::uint32_t height, int depth, int color_type,
             const std::vector<PngChunk>& between, const std::string& rows) {
    std::string png = "\x89PNG\r\n\x1a\n";
    std::string header;
    append_u32(header, width);
    append_u32(header, height);
    header += static_cast<char>(depth);
    header += static_cast<char>(color_type);
    header += std::string(3, '\0');  // deflate, adaptive filters, not interlaced
    append_chunk(png, "IHDR", header);
    for (const PngChunk& chunk : between) append_chunk(png, chunk.type, chunk.data);
    append_chunk(png, "IDAT", stored_zlib(rows));
    append_chunk(png, "IEND", "");
    const auto bytes = std::as_bytes(std::span(png));
    return {bytes.begin(), bytes.end()};
}

std::string error_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.what();
    }
    ADD_FAILURE() << "no error was thrown";
    return {};
}

}  // namespace burnish::test
