// Files that declare more than they hold: refused by what the header says, before memory is asked
// for.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstring>
#include <string>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "support/samples.hpp"

namespace burnish::test {
namespace {

long peak_megabytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

Bytes bytes_of(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

void put_u32(Bytes& bytes, std::size_t at, std::uint32_t value) {
    std::memcpy(bytes.data() + at, &value, sizeof(value));
}

// The error for `bytes`, which must not have cost much memory.
std::string refusal(const Bytes& bytes) {
    const long before = peak_megabytes();
    const std::string line =
        error_of([&] { decode_texture(bytes, "hostile.img", ColorSpace::linear); });
    EXPECT_LT(peak_megabytes() - before, 200) << line;
    return line;
}

std::size_t find(const Bytes& bytes, const std::string& text) {
    const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return all.find(text);
}

TEST(HugeImages, PngIsRefused) {
    const std::string row(10, '\0');
    EXPECT_EQ(refusal(png_of(0x7FFFFFFF, 0x7FFFFFFF, 8, 6, {}, row)),
              "hostile.img: expected an image of 1 to 32768 pixels a side, found 2147483647 x "
              "2147483647");
    EXPECT_EQ(refusal(png_of(30000, 30000, 16, 6, {}, row)),
              "hostile.img: expected a readable PNG image, found 21 bytes of data for 30000 x "
              "30000 pixels");
    EXPECT_NE(refusal(png_of(0, 4, 8, 0, {}, row)).find("0 x 4"), std::string::npos);
}

TEST(HugeImages, HdrIsRefused) {
    const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";
    EXPECT_NE(refusal(bytes_of(header + "-Y 999999999 +X 999999999\nxxxx")).find("999999999"),
              std::string::npos);
    refusal(bytes_of(header + "-Y 99999999999999999999999 +X 4\nxxxx"));
    refusal(bytes_of(header + "-Y 32768 +X 32768\nxxxx"));
    EXPECT_NE(refusal(bytes_of(header + "+X 4 -Y 4\nxxxx")).find("resolution line"),
              std::string::npos);
    refusal(bytes_of(header));
    refusal(bytes_of("#?RADIANCE\n" + std::string(100, 'x')));
}

TEST(HugeImages, JpegIsRefused) {
    Bytes bytes = encode({"", "jpeg", "uint8", 3, {}}, sample_picture(16, 16, 3));
    const std::size_t frame = find(bytes, "\xff\xc0");
    ASSERT_NE(frame, std::string::npos);
    for (std::size_t i = 5; i < 9; ++i) bytes[frame + i] = std::byte{0x7F};
    EXPECT_NE(refusal(bytes).find("32639 x 32639"), std::string::npos);
}

TEST(HugeImages, OpenExrIsRefused) {
    for (const char* compression : {"zip", "none", "piz"}) {
        Bytes bytes =
            encode({"", "openexr", "half", 3, {std::string("compression=") + compression}},
                   sample_picture(16, 16, 3));
        const std::size_t window = find(bytes, "dataWindow");
        ASSERT_NE(window, std::string::npos);
        const std::size_t corner = window + std::strlen("dataWindow") + 1 + 6 + 4 + 8;
        put_u32(bytes, corner, 0x7FFFFFFE);
        put_u32(bytes, corner + 4, 0x7FFFFFFE);
        EXPECT_NE(refusal(bytes).find("2147483647 x 2147483647"), std::string::npos);
        put_u32(bytes, corner, 32767);
        put_u32(bytes, corner + 4, 32767);
        refusal(bytes);
        put_u32(bytes, corner, static_cast<std::uint32_t>(-5));
        refusal(bytes);
    }
}

TEST(HugeImages, TiffIsRefused) {
    for (const char* compression : {"none", "zip", "packbits"}) {
        Bytes bytes = encode({"",
                              "tiff",
                              "uint8",
                              3,
                              {std::string("compression=") + compression, "tiff:write_exif=0"}},
                             sample_picture(16, 16, 3));
        std::uint32_t directory = 0;
        std::memcpy(&directory, bytes.data() + 4, 4);
        // Width and height are the first two tags that matter; both become LONG.
        for (std::size_t entry = directory + 2; entry + 12 <= bytes.size(); entry += 12) {
            std::uint16_t tag = 0;
            std::memcpy(&tag, bytes.data() + entry, 2);
            if (tag != 256 && tag != 257) continue;
            bytes[entry + 2] = std::byte{4};
            put_u32(bytes, entry + 8, 0x7FFFFFFF);
        }
        EXPECT_NE(refusal(bytes).find("2147483647"), std::string::npos);
        for (std::size_t entry = directory + 2; entry + 12 <= bytes.size(); entry += 12) {
            std::uint16_t tag = 0;
            std::memcpy(&tag, bytes.data() + entry, 2);
            if (tag == 256 || tag == 257) put_u32(bytes, entry + 8, 32768);
        }
        refusal(bytes);
    }
}

TEST(Png, DamagedDataIsNamed) {
    Bytes bytes = png_of(2, 1, 8, 0, {}, std::string("\0\1\2", 3));
    bytes[bytes.size() - 12 - 4 - 4 - 1] ^= std::byte{1};
    EXPECT_NE(refusal(bytes).find("checksum of IDAT"), std::string::npos);
}

TEST(Png, ChunksOfNoUseAreNotObeyed) {
    // A profile that is none and fails its checksum, a background and an unknown chunk.
    Bytes bytes = png_of(
        2, 1, 8, 0, {{"iCCP", "broken"}, {"bKGD", std::string("\0\xff", 2)}, {"abCd", "whatever"}},
        std::string("\0\1\2", 3));
    bytes[find(bytes, "iCCP") + 4] = std::byte{'k'};
    testing::internal::CaptureStderr();
    const Texture texture = decode_texture(bytes, "a.png", ColorSpace::linear);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(std::to_integer<int>(texture.texels.at(1)), 2);
}

}  // namespace
}  // namespace burnish::test
