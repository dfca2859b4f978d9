// The container: the contents of a valid file, and one error line for each kind of broken file.
#include "formats/bsdf/tensor_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "support/bsdf_writer.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {
namespace {

TensorFile parse(const std::string& text) {
    const auto* bytes = reinterpret_cast<const std::byte*>(text.data());
    return {"made.bsdf", {bytes, bytes + text.size()}};
}

std::string refusal(const std::string& text) {
    return error_line([&] { parse(text); });
}

void expect_words(const std::string& line, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        EXPECT_NE(line.find(word), std::string::npos) << word << " in: " << line;
}

std::vector<TensorPart> two_parts() {
    const std::vector<float> values{1.5F, -2.0F, 3.0F, 4.0F, 5.0F, 6.0F};
    return {floats_part("table", {2, 3}, values), bytes_part("note", "hello")};
}

// Overwrites the bytes at `at` by a number.
template <typename Number>
std::string patched(std::string text, std::size_t at, Number value) {
    const char* bytes = reinterpret_cast<const char*>(&value);
    return text.replace(at, sizeof value, bytes, sizeof value);
}

// Offsets in the first entry of two_parts(), whose name has 5 letters.
constexpr std::size_t kCountAt = 14, kNameAt = 20, kRankAt = 25, kTypeAt = 27, kOffsetAt = 28,
                      kSizeAt = 36;

TEST(TensorFile, HoldsWhatWasWritten) {
    const TensorFile file = parse(tensor_text(two_parts()));
    ASSERT_EQ(file.fields().size(), 2U);
    const TensorField& table = file.require("table", TensorType::float32, 2);
    EXPECT_EQ(table.shape, (std::vector<std::size_t>{2, 3}));
    EXPECT_EQ(table.shape_text(), "2 x 3");
    EXPECT_EQ(file.floats(table), (std::vector<float>{1.5F, -2.0F, 3.0F, 4.0F, 5.0F, 6.0F}));
    EXPECT_EQ(file.data(*file.find("note")).size(), 5U);
    EXPECT_EQ(file.find("nothing"), nullptr);
}

TEST(TensorFile, EveryTruncationIsAnError) {
    const std::string text = tensor_text(two_parts());
    for (std::size_t length = 0; length < text.size(); ++length)
        expect_words(refusal(text.substr(0, length)), {"made.bsdf", "expected", "found"});
}

TEST(TensorFile, NamesWhatIsWrong) {
    const std::string sound = tensor_text(two_parts());
    expect_words(refusal("GIF89a and more of the same"), {"tensor_file"});
    expect_words(refusal(patched<std::uint8_t>(sound, 12, 2)), {"version", "1.0", "2.0"});
    expect_words(refusal(patched<std::uint32_t>(sound, kCountAt, 4000000000U)),
                 {"256 fields", "4000000000"});
    expect_words(refusal(patched<std::uint16_t>(sound, kRankAt, 9)), {"\"table\"", "rank", "9"});
    expect_words(refusal(patched<std::uint8_t>(sound, kTypeAt, 0)), {"\"table\"", "type", "0"});
    expect_words(refusal(patched<std::uint8_t>(sound, kTypeAt, 12)), {"\"table\"", "type", "12"});
    expect_words(refusal(patched<std::uint64_t>(sound, kSizeAt, 0)), {"\"table\"", "size 0"});
    const auto huge = std::numeric_limits<std::uint64_t>::max();
    expect_words(refusal(patched<std::uint64_t>(sound, kSizeAt, huge)), {"\"table\"", "size"});
    // 2^31 x 2^31 + ...: the product would overflow 64 bits.
    expect_words(refusal(patched<std::uint64_t>(patched<std::uint64_t>(sound, kSizeAt, 1ULL << 31),
                                                44, 1ULL << 33)),
                 {"\"table\"", "size"});
    expect_words(refusal(patched<std::uint64_t>(sound, kSizeAt, 200)),
                 {"\"table\"", "end of the file"});
    expect_words(refusal(patched<std::uint64_t>(sound, kOffsetAt, huge)), {"\"table\"", "offset"});
}

TEST(TensorFile, DataMayNotOverlap) {
    const std::string sound = tensor_text(two_parts());
    // Offsets into the table of contents, and onto the note after it.
    expect_words(refusal(patched<std::uint64_t>(sound, kOffsetAt, 14)),
                 {"\"table\"", "table of contents"});
    const std::uint64_t end = sound.size() - 5;
    expect_words(refusal(patched<std::uint64_t>(sound, kOffsetAt, end - 23)), {"behind"});
}

TEST(TensorFile, NamesAreUniqueAndNotEmpty) {
    auto parts = two_parts();
    parts[1].name = "table";
    expect_words(refusal(tensor_text(parts)), {"\"table\"", "two"});
    parts[1].name = "";
    expect_words(refusal(tensor_text(parts)), {"name", "0 bytes"});
    parts[1].name = "a\nb\rc";
    parts[1].shape = {0};
    EXPECT_EQ(refusal(tensor_text(parts)).find('\n'), std::string::npos);
}

TEST(TensorFile, NumbersAreFiniteAndOfTheTypeAsked) {
    const std::size_t first = tensor_text(two_parts()).size() - 5 - 24;
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 2e12F}) {
        const TensorFile file = parse(patched(tensor_text(two_parts()), first + 8, bad));
        expect_words(error_line([&] { file.floats(*file.find("table")); }),
                     {"\"table\"", "finite", "number 2"});
    }
    const TensorFile file = parse(tensor_text(two_parts()));
    expect_words(error_line([&] { file.require("table", TensorType::uint8, 2); }),
                 {"table", "uint8 of rank 2", "float32 of rank 2 (2 x 3)"});
    expect_words(error_line([&] { file.require("table", TensorType::float32, 1); }),
                 {"rank 1", "rank 2"});
    expect_words(error_line([&] { file.require("sigma", TensorType::float32, 1); }),
                 {"sigma", "none of that name"});
}

TEST(TensorFile, IsToldByItsFirstBytes) {
    const ScratchFolder folder;
    EXPECT_TRUE(is_tensor_file(folder.write("a", tensor_text(two_parts()))));
    EXPECT_FALSE(is_tensor_file(folder.write("b", "tensor")));
    EXPECT_FALSE(is_tensor_file(folder.write("c", "")));
    expect_words(error_line([&] { TensorFile::load(folder / "none.bsdf"); }),
                 {"none.bsdf", "no such file"});
}

}  // namespace
}  // namespace burnish::test
