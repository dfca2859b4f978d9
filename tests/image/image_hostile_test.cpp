// Broken and hostile image files: an error of one line, never a crash, a hang or half a picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <span>
#include <string_view>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "support/samples.hpp"

namespace burnish::test {
namespace {

// A decoder that loops is caught by the time limit; this one finds the merely absurd.
constexpr auto kLongest = std::chrono::seconds(5);

bool is_one_line(const std::string& text) {
    return !text.empty() && text.find_first_of("\n\r\t") == std::string::npos;
}

// The texels, or nothing when the file was refused (in one line that names it).
std::vector<std::byte> texels_or_refusal(std::span<const std::byte> bytes) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::byte> texels;
    try {
        const Texture texture = decode_texture(bytes, "hostile.img", ColorSpace::linear);
        const std::size_t texel = texture.type == TexelType::u8    ? 1
                                  : texture.type == TexelType::u16 ? 2
                                                                   : 4;
        EXPECT_EQ(texture.texels.size(), static_cast<std::size_t>(texture.width) *
                                             static_cast<std::size_t>(texture.height) *
                                             static_cast<std::size_t>(texture.channels) * texel);
        if (texture.type == TexelType::f32) {
            for (std::size_t at = 0; at < texture.texels.size(); at += sizeof(float)) {
                float value = 0.0f;
                std::memcpy(&value, texture.texels.data() + at, sizeof(float));
                if (!std::isfinite(value)) {
                    ADD_FAILURE() << "a value that is not finite got through";
                    break;
                }
            }
        }
        texels = texture.texels;
    } catch (const Error& error) {
        const std::string line = error.what();
        EXPECT_TRUE(is_one_line(line)) << line;
        EXPECT_EQ(line.rfind("hostile.img: ", 0), 0U) << line;
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, kLongest);
    return texels;
}

class Hostile : public testing::TestWithParam<Encoding> {
  protected:
    Bytes sample() const { return encode(GetParam(), sample_picture(24, 18, GetParam().channels)); }
};

TEST_P(Hostile, TruncatedFilesAreRefused) {
    const Bytes bytes = sample();
    const std::vector<std::byte> whole = texels_or_refusal(bytes);
    ASSERT_FALSE(whole.empty());
    const std::size_t step = std::max<std::size_t>(bytes.size() / 150, 1);
    for (std::size_t length = 0; length < bytes.size(); length += step) {
        const auto texels = texels_or_refusal(std::span(bytes).first(length));
        // A tail that holds no pixels (the end of a TIFF directory) may be missing.
        EXPECT_TRUE(texels.empty() || texels == whole) << length << " of " << bytes.size();
    }
    for (std::size_t cut = 1; cut < 16; ++cut) {
        const auto texels = texels_or_refusal(std::span(bytes).first(bytes.size() - cut));
        EXPECT_TRUE(texels.empty() || texels == whole) << "last " << cut;
    }
}

TEST_P(Hostile, FlippedBytesAreSurvived) {
    constexpr unsigned kSeeds = 200;
    const Bytes good = sample();
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
        std::mt19937 random(seed);
        Bytes bytes = good;
        const unsigned flips = 1 + random() % 8;
        for (unsigned i = 0; i < flips; ++i) {
            // Half of them in the header, where they hurt most.
            const std::size_t range = random() % 2 == 0 ? bytes.size() : bytes.size() / 4 + 1;
            const std::byte values[] = {std::byte{0}, std::byte{0xFF}, std::byte{0x7F},
                                        std::byte{static_cast<unsigned char>(random())}};
            bytes[random() % range] = values[random() % 4];
        }
        SCOPED_TRACE(seed);
        texels_or_refusal(bytes);
    }
}

// Found by the fuzzer: decoders read what the type of an attribute says. One of another length made
// them take four bytes of something else for the length of the next, and ask for gigabytes.
TEST(HostileOpenExr, AttributesAreAsLongAsTheirTypes) {
    const auto exr = std::find_if(encodings().begin(), encodings().end(),
                                  [](const Encoding& e) { return e.format == "openexr"; });
    ASSERT_NE(exr, encodings().end());
    const Bytes good = encode(*exr, sample_picture(24, 18, exr->channels));
    struct Lie {
        std::string_view type;  // as the file has it: its end, and the length behind it
        std::size_t more;
    };
    using namespace std::string_view_literals;
    for (const Lie& lie : {Lie{"compression\0\x01\0\0\0"sv, 1}, Lie{"box2i\0\x10\0\0\0"sv, 3},
                           Lie{"float\0\x04\0\0\0"sv, 200}, Lie{"chlist\0"sv, 1}}) {
        const auto type = std::as_bytes(std::span(lie.type));
        const auto found = std::search(good.begin(), good.end(), type.begin(), type.end());
        ASSERT_NE(found, good.end()) << lie.type;
        const std::size_t length =
            static_cast<std::size_t>(found - good.begin()) + lie.type.find('\0') + 1;
        Bytes bytes = good;
        bytes[length] =
            static_cast<std::byte>(std::to_integer<std::size_t>(bytes[length]) + lie.more);
        bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(length) + 4, lie.more,
                     std::byte{0});
        try {
            decode_texture(bytes, "hostile.img", ColorSpace::linear);
            ADD_FAILURE() << lie.type;
        } catch (const Error& error) {
            EXPECT_NE(std::string_view(error.what()).find("for an attribute of type"),
                      std::string_view::npos)
                << error.what();
        }
    }
}

// Found by the fuzzer: in a part of a type that it does not know, OpenEXR lets pixel types pass
// that OpenImageIO aborts at.
TEST(HostileOpenExr, ChannelsAndPartsAreOfTypesThatThereAre) {
    const auto exr = std::find_if(encodings().begin(), encodings().end(),
                                  [](const Encoding& e) { return e.format == "openexr"; });
    ASSERT_NE(exr, encodings().end());
    const Bytes good = encode(*exr, sample_picture(24, 18, exr->channels));
    using namespace std::string_view_literals;
    const auto expect_refusal = [](const Bytes& bytes, std::string_view part) {
        try {
            decode_texture(bytes, "hostile.img", ColorSpace::linear);
            ADD_FAILURE() << part;
        } catch (const Error& error) {
            EXPECT_NE(std::string_view(error.what()).find(part), std::string_view::npos)
                << error.what();
        }
    };
    const auto type = std::as_bytes(std::span("chlist\0"sv));
    const auto found = std::search(good.begin(), good.end(), type.begin(), type.end());
    ASSERT_NE(found, good.end());
    // Behind the type and the length: a name of one letter, the pixel type, four bytes, sampling.
    const auto channel = static_cast<std::size_t>(found - good.begin()) + type.size() + 4 + 2;
    for (const unsigned kind : {3U, 255U}) {
        Bytes bytes = good;
        bytes[channel] = static_cast<std::byte>(kind);
        expect_refusal(bytes, "a channel of pixel type " + std::to_string(kind));
    }
    for (const std::size_t sampling : {std::size_t{8}, std::size_t{12}}) {
        Bytes bytes = good;
        bytes[channel + sampling] = std::byte{0};
        expect_refusal(bytes, "a channel with a sample every 0 pixels");
        // Another channel than those of luminance and chroma, and data that are too short for it.
        bytes[channel + sampling] = std::byte{2};
        expect_refusal(bytes, "luminance and chroma");
    }
    Bytes bytes = good;
    const auto part = std::as_bytes(std::span("type\0string\0\x05\0\0\0scanl"sv));
    bytes.insert(bytes.begin() + 8, part.begin(), part.end());
    expect_refusal(bytes, "a part of type \"scanl\"");
}

INSTANTIATE_TEST_SUITE_P(Formats, Hostile, testing::ValuesIn(encodings()),
                         [](const auto& encoding) { return encoding.param.label; });

}  // namespace
}  // namespace burnish::test
