// TGA, BMP, WebP, HEIF and AVIF beyond what every format is tested for: kinds that encoders do not
// write, and hostile containers.
#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "image/guard/format.hpp"
#include "support/paths.hpp"
#include "support/samples.hpp"

namespace burnish::test {
namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;

Bytes bytes_from(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

std::string little(std::uint32_t value, int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += static_cast<char>(std::uint64_t{value} >> 8 * i & 0xFFU);
    return text;
}

std::string big32(std::uint32_t value) {
    const std::string text = little(value, 4);
    return {text.rbegin(), text.rend()};
}

Texture picture_of(const std::string& file) {
    return decode_texture(bytes_from(file), "a.img", ColorSpace::srgb);
}

std::vector<int> codes_of(const Texture& texture) {
    std::vector<int> values;
    for (const std::byte value : texture.texels) values.push_back(std::to_integer<int>(value));
    return values;
}

void expect_refused(const std::string& file, const std::string& words) {
    const std::string line = error_of([&] { picture_of(file); });
    EXPECT_NE(line.find(words), std::string::npos) << line;
}

// ---- TGA --------------------------------------------------------------------------------------

std::string tga(unsigned type, unsigned width, unsigned height, unsigned bits, unsigned flags,
                const std::string& palette = "") {
    const auto length = static_cast<std::uint32_t>(palette.size() / 3);
    return little(0, 1) + little(length > 0 ? 1 : 0, 1) + little(type, 1) + little(0, 2) +
           little(length, 2) + little(length > 0 ? 24 : 0, 1) + little(0, 4) + little(width, 2) +
           little(height, 2) + little(bits, 1) + little(flags, 1) + palette;
}

constexpr unsigned kTopDown = 0x20;

TEST(Tga, RowsAreStoredUpwardsUnlessItSaysOtherwise) {
    const std::string two_rows = "\1\2\3\4\5\6"s;  // blue, green, red
    EXPECT_EQ(codes_of(picture_of(tga(2, 1, 2, 24, 0) + two_rows)),
              (std::vector<int>{6, 5, 4, 3, 2, 1}));
    EXPECT_EQ(codes_of(picture_of(tga(2, 1, 2, 24, kTopDown) + two_rows)),
              (std::vector<int>{3, 2, 1, 6, 5, 4}));
}

TEST(Tga, PalettesAndRunsAreExpanded) {
    const std::string palette = "\1\2\3\4\5\6"s;
    EXPECT_EQ(codes_of(picture_of(tga(1, 2, 1, 8, kTopDown, palette) + "\1\0"s)),
              (std::vector<int>{6, 5, 4, 3, 2, 1}));
    EXPECT_EQ(codes_of(picture_of(tga(11, 4, 1, 8, kTopDown) + "\x82\x07\x00\x09"s)),
              (std::vector<int>{7, 7, 7, 9}));
}

TEST(Tga, AlphaThatIsZeroEverywhereIsUnset) {
    EXPECT_EQ(codes_of(picture_of(tga(2, 2, 1, 32, kTopDown) + "\1\2\3\0\4\5\6\0"s)),
              (std::vector<int>{3, 2, 1, 255, 6, 5, 4, 255}));
    EXPECT_EQ(codes_of(picture_of(tga(2, 2, 1, 32, kTopDown | 8) + "\1\2\3\0\4\5\6\x80"s)),
              (std::vector<int>{3, 2, 1, 0, 6, 5, 4, 128}));
}

TEST(Tga, TheEndSaysThatColorIsPremultiplied) {
    std::string file = tga(2, 1, 1, 32, kTopDown | 8) + "\x20\x20\x40\x80"s;
    const auto area = static_cast<std::uint32_t>(file.size());
    file += little(495, 2) + std::string(492, '\0') + "\x04"s;  // 4: premultiplied
    file += little(area, 4) + little(0, 4) + "TRUEVISION-XFILE.\0"s;
    // 0x40 * 255 / 128 and 0x20 * 255 / 128, rounded.
    EXPECT_EQ(codes_of(picture_of(file)), (std::vector<int>{128, 64, 64, 128}));
}

TEST(Tga, HostileOnesAreRefused) {
    expect_refused(tga(2, 4, 4, 24, 0) + std::string(47, 'x'), "cut short");
    expect_refused(tga(2, 65535, 65535, 24, 0) + "xyz", "1 to 32768");
    expect_refused(tga(10, 2, 1, 24, 0) + "\x82\1\2\3"s, "a run beyond the picture");
    expect_refused(tga(1, 2, 1, 8, 0, "\1\2\3"s) + "\1\0"s, "outside the palette");
    expect_refused(tga(10, 30000, 30000, 24, 0) + "\xFF\1\2\3"s, "as large as its pixels");
    // An end whose offsets point anywhere.
    for (const std::uint32_t offset : {17U, 0x7FFFFFFFU, 0xFFFFFFFFU}) {
        const Texture texture =
            picture_of(tga(2, 1, 1, 24, kTopDown) + "\1\2\3"s + little(offset, 4) +
                       little(offset, 4) + "TRUEVISION-XFILE.\0"s);
        EXPECT_EQ(codes_of(texture), (std::vector<int>{3, 2, 1}));
    }
}

// No signature: what is no picture must not pass for one.
TEST(Tga, OtherFilesAreNotTakenForOne) {
    for (const std::string& text :
         {"{\"asset\": {\"version\": \"2.0\"}, \"scene\": 0}"s, "24\nball_00.jpg 0.1 0.2 0.9\n"s,
          "v 0 0 0\nv 1 0 0\nv 0 1 0\n"s, "[WIF]\r\nVersion=1.1\r\n"s, std::string(64, '\0'),
          "\xEF\xBB\xBF{ \"format\": 1 }      "s, std::string(64, '\xFF'), std::string(64, ' '),
          "{\0\n\0 \0 \0\"\0f\0o\0r\0m\0a\0t\0"s, "tensor_file\0\1\0\3\0\0\0\1\2\3\4\5"s}) {
        EXPECT_FALSE(image_format_of(bytes_from(text)).has_value()) << text;
    }
}

// ---- BMP --------------------------------------------------------------------------------------

std::string bmp(std::int32_t width, std::int32_t height, unsigned bits, unsigned compression,
                unsigned colors, const std::string& behind, std::uint32_t palette_bytes) {
    const std::uint32_t pixels = 14 + 40 + palette_bytes;
    return "BM"s + little(static_cast<std::uint32_t>(pixels + behind.size()), 4) + little(0, 4) +
           little(pixels, 4) + little(40, 4) + little(static_cast<std::uint32_t>(width), 4) +
           little(static_cast<std::uint32_t>(height), 4) + little(1, 2) + little(bits, 2) +
           little(compression, 4) + little(0, 4) + little(0, 8) + little(colors, 4) + little(0, 4) +
           behind;
}

const std::string kPalette = "\1\2\3\0\4\5\6\0"s;  // blue, green, red, nothing

TEST(Bmp, PalettesRunsAndDirectionsAreRead) {
    EXPECT_EQ(codes_of(picture_of(bmp(1, 2, 24, 0, 0, "\1\2\3\0\4\5\6\0"s, 0))),
              (std::vector<int>{6, 5, 4, 3, 2, 1}));
    EXPECT_EQ(codes_of(picture_of(bmp(1, -2, 24, 0, 0, "\1\2\3\0\4\5\6\0"s, 0))),
              (std::vector<int>{3, 2, 1, 6, 5, 4}));
    EXPECT_EQ(codes_of(picture_of(bmp(2, 1, 8, 0, 2, kPalette + "\1\0\0\0"s, 8))),
              (std::vector<int>{6, 5, 4, 3, 2, 1}));
    EXPECT_EQ(codes_of(picture_of(bmp(2, 1, 1, 0, 2, kPalette + "\x80\0\0\0"s, 8))),
              (std::vector<int>{6, 5, 4, 3, 2, 1}));
    EXPECT_EQ(codes_of(picture_of(bmp(3, 1, 8, 1, 2, kPalette + "\2\1\1\0\0\1"s, 8))),
              (std::vector<int>{6, 5, 4, 6, 5, 4, 3, 2, 1}));
}

TEST(Bmp, AlphaThatIsZeroEverywhereIsUnset) {
    EXPECT_EQ(codes_of(picture_of(bmp(2, 1, 32, 0, 0, "\1\2\3\0\4\5\6\0"s, 0))),
              (std::vector<int>{3, 2, 1, 255, 6, 5, 4, 255}));
}

TEST(Bmp, HostileOnesAreRefused) {
    expect_refused(bmp(4, 4, 24, 0, 0, std::string(47, 'x'), 0), "cut short");
    expect_refused(bmp(0x7FFFFFFF, 4, 24, 0, 0, "xxxx", 0), "1 to 32768");
    expect_refused(bmp(4, static_cast<std::int32_t>(0x80000000U), 24, 0, 0, "xxxx", 0),
                   "1 to 32768");
    expect_refused(bmp(2, 1, 8, 0, 2, kPalette + "\2\0\0\0"s, 8), "outside the palette");
    expect_refused(bmp(2, 1, 4, 0, 2, kPalette + "\x03\0\0\0"s, 8), "outside the palette");
    expect_refused(bmp(2, 1, 8, 0, 0x40000000, kPalette, 8), "a palette of");
    expect_refused(bmp(3, 1, 8, 1, 2, kPalette + "\4\1\0\1"s, 8), "a run beyond the picture");
    expect_refused(bmp(3, 1, 8, 1, 2, kPalette + "\0\2\0\7\1\1\0\1"s, 8),
                   "a run beyond the picture");
    expect_refused(bmp(3, 1, 8, 1, 2, kPalette + "\1\1"s, 8), "cut short");
    // The codec would write beyond the picture.
    expect_refused(bmp(3, 1, 8, 1, 2, "\1\1\1\0\7\7\7\0"s + "\2\1\1\0\0\1"s, 8), "a gray palette");
    expect_refused(bmp(2, 1, 24, 4, 0, "xxxxxxxx", 0), "of compression 4");
    expect_refused(
        bmp(2, 1, 32, 3, 0,
            little(0xFF, 4) + little(0xFF00, 4) + little(0xFF0000, 4) + std::string(8, 'x'), 12),
        "in another order");
}

// ---- WebP -------------------------------------------------------------------------------------

std::string riff(const std::string& chunks) {
    return "RIFF"s + little(static_cast<std::uint32_t>(chunks.size() + 4), 4) + "WEBP" + chunks;
}

std::string webp_chunk(const std::string& name, std::string data) {
    std::string chunk = name + little(static_cast<std::uint32_t>(data.size()), 4);
    if (data.size() % 2 != 0) data += '\0';
    return chunk + data;
}

TEST(Webp, HostileOnesAreRefused) {
    const std::string header_16383 = "\x2f"s + little(0x3FFE | 0x3FFE << 14, 4) + "xxxx";
    expect_refused(riff(webp_chunk("VP8L", header_16383)), "as large as its pixels");
    expect_refused(riff(webp_chunk("VP8 ", "xxx\x9d\x01\x2a\0\0\0\0xx"s)), "0 x 0");
    expect_refused(riff(webp_chunk("VP8X", little(2, 4) + little(3, 3) + little(3, 3))),
                   "an animation");
    expect_refused(riff(webp_chunk("VP8X", little(0, 4) + little(0xFFFFFF, 3) + little(3, 3))),
                   "1 to 32768");
    expect_refused(riff(webp_chunk("ABCD", "xx")), "a first chunk");
    expect_refused(riff(""), "no picture in it");
    expect_refused("RIFF"s + little(500, 4) + "WEBPVP8 ", "cut short");
    expect_refused("RIFF"s + little(500, 4) + "WAVEfmt      ", "no WebP");
}

// 16 pixels of color (200, 100, 50) and alpha 0, 17, 34 ... 255, written by libwebp without loss.
// Where alpha is 0 the encoder sets the color to 0.
const unsigned char kAlphaRamp[] = {
    0x52, 0x49, 0x46, 0x46, 0x36, 0x00, 0x00, 0x00, 0x57, 0x45, 0x42, 0x50, 0x56, 0x50, 0x38, 0x4c,
    0x29, 0x00, 0x00, 0x00, 0x2f, 0x0f, 0x00, 0x00, 0x10, 0x7f, 0x20, 0x10, 0x48, 0x82, 0xdd, 0x5f,
    0x63, 0x85, 0x41, 0x1e, 0x99, 0x89, 0x48, 0xe8, 0x38, 0x20, 0x08, 0x80, 0x58, 0xd0, 0xa2, 0x45,
    0x8b, 0x16, 0x2d, 0x5a, 0xb4, 0xe8, 0x88, 0xe8, 0x7f, 0x80, 0x72, 0xba, 0x03, 0x00};

TEST(Webp, ColorsUnderAlphaAreExact) {
    const auto bytes = std::as_bytes(std::span(kAlphaRamp));
    const Texture texture = decode_texture(bytes, "ramp.webp", ColorSpace::srgb);
    ASSERT_EQ(texture.channels, 4);
    const std::vector<int> codes = codes_of(texture);
    for (std::size_t i = 1; i < 16; ++i) {
        EXPECT_EQ(codes[4 * i], 200) << i;
        EXPECT_EQ(codes[4 * i + 1], 100) << i;
        EXPECT_EQ(codes[4 * i + 2], 50) << i;
        EXPECT_EQ(codes[4 * i + 3], static_cast<int>(17 * i)) << i;
    }
    EXPECT_EQ(codes[3], 0);
}

// ---- HEIF and AVIF ----------------------------------------------------------------------------

std::string box(const std::string& type, const std::string& content) {
    return big32(static_cast<std::uint32_t>(content.size() + 8)) + type + content;
}

std::string heif_of(std::uint32_t width, std::uint32_t height) {
    const std::string size = box("ispe", big32(0) + big32(width) + big32(height));
    return box("ftyp", "avif"s + big32(0) + "mif1") +
           box("meta", big32(0) + box("iprp", box("ipco", size))) + box("mdat", "xxxx");
}

TEST(Heif, HostileOnesAreRefused) {
    expect_refused(heif_of(100000, 4), "1 to 32768");
    expect_refused(heif_of(30000, 30000), "as large as its pixels");
    expect_refused(box("ftyp", "heic"s + big32(0)) + box("mdat", "xxxx"), "no picture in it");
    expect_refused(box("ftyp", "heic"s + big32(0)) + big32(500) + "mdat", "cut short");
    expect_refused(box("ftyp", "heic"s + big32(0)) + big32(4) + "mdat", "a box");
    const std::string line = error_of([&] { picture_of(heif_of(16, 16)); });
    EXPECT_NE(line.find("convert it to PNG"), std::string::npos) << line;
    expect_refused(box("ftyp", "isom"s + big32(0)) + box("mdat", "xxxx"), "MP4");
}

// ---- which is which -----------------------------------------------------------------------------

TEST(ImageFormats, AreNamedByInfo) {
    const TemporaryFolder folder;
    for (const Encoding& encoding : encodings()) {
        const fs::path path = folder / (encoding.label + ".img");  // the name says nothing
        save(path, encode(encoding, sample_picture(16, 12, encoding.channels)));
        EXPECT_TRUE(is_image_file(path)) << encoding.label;
        const ImageInfo info = read_image_info(path);
        EXPECT_EQ(info.width, 16) << encoding.label;
        const std::string wanted = encoding.format == "webp"                          ? "WebP"
                                   : encoding.format == "targa"                       ? "TGA"
                                   : encoding.format == "bmp"                         ? "BMP"
                                   : encoding.label.find("heic") != std::string::npos ? "HEIF"
                                   : encoding.label.find("avif") != std::string::npos ? "AVIF"
                                                                                      : "";
        if (!wanted.empty()) {
            EXPECT_EQ(info.format, wanted);
        }
    }
}

TEST(ImageFormats, TexturesForGpusAreRefusedWithAWayOut) {
    expect_refused("\xabKTX 20\xbb\r\n\x1a\n        "s, "ktx extract");
    expect_refused("DDS |                  ", "oiiotool");
}

TEST(ImageFormats, SampleTexturesAreRead) {
    const fs::path root = data_folder() / "field";
    if (!fs::exists(root)) GTEST_SKIP() << "no sample data at " << data_folder();
    const Texture png = read_texture(root / "11_obj_kd0_tga_paths/tex/col.png", ColorSpace::srgb);
    for (const char* name : {"col.tga", "col.bmp"}) {
        const Texture other =
            read_texture(root / "11_obj_kd0_tga_paths/tex" / name, ColorSpace::srgb);
        EXPECT_EQ(other.texels, png.texels) << name;
    }
    EXPECT_GT(read_texture(root / "13_webp_draco/c.webp", ColorSpace::srgb).width, 0);
}

}  // namespace
}  // namespace burnish::test
