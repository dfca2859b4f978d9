// Files of intermediate results that a later run continues from: arrays of plain numbers, with an
// identity hashed from all inputs. A file is written completely or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <type_traits>
#include <vector>

#include "core/files.hpp"

namespace burnish {

class Identity {  // FNV-1a, 64 bits
  public:
    void add_bytes(const void* bytes, std::size_t count) {
        const auto* b = static_cast<const unsigned char*>(bytes);
        for (std::size_t i = 0; i < count; ++i) value_ = (value_ ^ b[i]) * 0x100000001b3ULL;
    }
    template <typename T>
    void add(const T& value) {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>, "no padding");
        add_bytes(&value, sizeof value);
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

class StageWriter {
  public:
    explicit StageWriter(std::uint64_t identity) { put(kMagic), put(identity); }
    template <typename T>
    void put(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        append(&value, sizeof value);
    }
    template <typename T>
    void put(const std::vector<T>& values) {
        static_assert(std::is_trivially_copyable_v<T>);
        put(static_cast<std::uint64_t>(values.size()));
        append(values.data(), values.size() * sizeof(T));
    }
    void write(const std::filesystem::path& path) const { write_bytes(path, bytes_); }

    static constexpr std::uint64_t kMagic = 0x31676174736e7262ULL;  // "brnstag1"

  private:
    void append(const void* from, std::size_t count) {
        if (count == 0) return;
        const std::size_t at = bytes_.size();
        bytes_.resize(at + count);
        std::memcpy(bytes_.data() + at, from, count);
    }
    std::vector<std::byte> bytes_;
};

// `good()` is false if the file is missing, incomplete or of another identity; discard everything
// that was read then.
class StageReader {
  public:
    StageReader(const std::filesystem::path& path, std::uint64_t identity) {
        std::error_code error;
        if (!std::filesystem::is_regular_file(path, error)) return;
        bytes_ = read_file(path, std::uintmax_t{16} << 30);
        good_ = true;
        std::uint64_t magic = 0, found = 0;
        get(magic);
        get(found);
        good_ = good_ && magic == StageWriter::kMagic && found == identity;
    }
    bool good() const { return good_; }
    template <typename T>
    void get(T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        take(&value, sizeof value);
    }
    template <typename T>
    void get(std::vector<T>& values) {
        std::uint64_t count = 0;
        get(count);
        if (!good_ || count > (bytes_.size() - at_) / sizeof(T)) {
            good_ = false;
            return;
        }
        values.resize(count);
        take(values.data(), count * sizeof(T));
    }

  private:
    void take(void* to, std::size_t count) {
        if (!good_ || count > bytes_.size() - at_) {
            good_ = false;
            return;
        }
        if (count > 0) std::memcpy(to, bytes_.data() + at_, count);
        at_ += count;
    }
    std::vector<std::byte> bytes_;
    std::size_t at_ = 0;
    bool good_ = false;
};

}  // namespace burnish
