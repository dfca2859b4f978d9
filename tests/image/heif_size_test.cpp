// An AVIF whose header states a larger picture than its frame: OpenImageIO 2.4 reads beyond the end of the
// decoded one. Found by tests/fuzz/fuzz_image.cpp.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"

namespace burnish {
namespace {

// 16392 x 8 in `ispe`, 8 x 8 in the frame.
constexpr std::string_view kHex =
    "0000001c667479706176696600000000617669666d6966316d6961660000012b6d657461000000000000"
    "002168646c72000000000000000070696374000000000000000000000000000000000e7069746d000000"
    "00000100000034696c6f630000000044400002000100000000014f0001000000000000001a0002000000"
    "000169000100000000000000180000003869696e6600000000000200000015696e666502000000000100"
    "00617630310000000015696e6665020000010002000045786966000000006a697072700000004b697063"
    "6f00000013636f6c726e636c78000200020006800000000c6176314381000c0000000014697370650000"
    "00000000400800000008000000107069786900000000030808080000001769706d610000000000000001"
    "000104818203840000001a69726566000000000000000e636473630002000100010000003a6d64617412"
    "000a081808bf6081010342320c134002082084000068d30878000000104578696600004d4d2a00000000"
    "08000000000000";

std::vector<std::byte> bytes_of_hex(std::string_view hex) {
    std::vector<std::byte> bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
        bytes.push_back(
            static_cast<std::byte>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16)));
    return bytes;
}

TEST(HeifSize, APictureSmallerThanItsHeaderSaysIsRefused) {
    const std::vector<std::byte> bytes = bytes_of_hex(kHex);
    try {
        decode_texture(bytes, "wide.avif", ColorSpace::srgb);
        FAIL() << "it was read";
    } catch (const Error& error) {
        const std::string line = error.what();
        for (const char* part : {"wide.avif", "16392 x 8", "8 x 8", "convert it to PNG"})
            EXPECT_NE(line.find(part), std::string::npos) << part << " is missing in " << line;
    }
}

}  // namespace
}  // namespace burnish
