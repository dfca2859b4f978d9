// Numbers at offsets of an untrusted file. Private to the walks of this folder, and superfluous
// with them. Offsets are 64-bit and files at most 4 GiB, so sums of an offset and a 32-bit length
// from the file cannot overflow.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "burnish/error.hpp"
#include "image/guard/format.hpp"

namespace burnish {

inline constexpr bool kBigEndian = true, kLittleEndian = false;

// Reading past the end is an error of the file.
class ByteCursor {
  public:
    ByteCursor(std::span<const std::byte> bytes, const std::string& name, ImageFormat format)
        : bytes_(bytes), name_(name), format_(format) {}

    std::uint64_t size() const { return bytes_.size(); }
    const std::string& name() const { return name_; }
    const std::byte* data() const { return bytes_.data(); }

    [[noreturn]] void fail(std::string_view found) const {
        throw Error(name_, "", fmt::format("a readable {} image", format_name(format_)), found);
    }
    [[noreturn]] void truncated() const {
        fail(fmt::format("a file cut short ({} bytes)", size()));
    }
    void require(std::uint64_t offset, std::uint64_t length) const {
        if (offset > size() || length > size() - offset) truncated();
    }

    unsigned u8(std::uint64_t offset) const {
        require(offset, 1);
        return std::to_integer<unsigned>(bytes_[static_cast<std::size_t>(offset)]);
    }
    unsigned u16(std::uint64_t offset, bool big) const {
        const unsigned a = u8(offset), b = u8(offset + 1);
        return big ? a << 8 | b : b << 8 | a;
    }
    std::uint32_t u32(std::uint64_t offset, bool big) const {
        const std::uint32_t a = u16(offset, big), b = u16(offset + 2, big);
        return big ? a << 16 | b : b << 16 | a;
    }
    std::string_view text(std::uint64_t offset, std::uint64_t length) const {
        require(offset, length);
        return {reinterpret_cast<const char*>(bytes_.data()) + offset,
                static_cast<std::size_t>(length)};
    }
    // The text up to the next `end`, at most `limit` characters of it.
    std::string_view text_until(std::uint64_t offset, char end, std::uint64_t limit) const {
        require(offset, 1);
        const std::uint64_t window = std::min(limit + 1, size() - offset);
        const std::string_view all = text(offset, window);
        const std::size_t length = all.find(end);
        if (length == std::string_view::npos) {
            if (window <= limit) truncated();
            fail("a broken header");
        }
        return all.substr(0, length);
    }

  private:
    std::span<const std::byte> bytes_;
    const std::string& name_;
    ImageFormat format_;
};

}  // namespace burnish
