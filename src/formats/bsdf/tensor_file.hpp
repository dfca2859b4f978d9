// Tensor files: named arrays of numbers behind one table of contents, as the RGL material database
// uses them. Layout, little-endian (after the reader of rgl-epfl/brdf-loader, BSD-3; no code of
// it):
//
//   "tensor_file\0"  12 bytes
//   version          u8 major, u8 minor: 1, 0
//   fields           u32, then for each: u16 length, name; u16 rank; u8 type; u64 offset from the
//                    start of the file; rank x u64 size along each dimension, the last one
//                    contiguous
//   data             at the offsets
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

// The enumerators have the values in the file.
enum class TensorType : std::uint8_t {
    uint8 = 1,
    int8,
    uint16,
    int16,
    uint32,
    int32,
    uint64,
    int64,
    float16,
    float32,
    float64
};
std::string_view name_of(TensorType type);
std::size_t bytes_of(TensorType type);

struct TensorField {
    std::string name;
    TensorType type = TensorType::uint8;
    std::vector<std::size_t> shape;  // every size at least 1; none: a single number
    std::size_t offset = 0;
    std::size_t count = 1;  // product of the shape

    std::size_t bytes() const { return count * bytes_of(type); }
    std::string shape_text() const;  // "1 x 8 x 32 x 32"
};

// The largest file of the database, spectral and anisotropic, has about 110 MB.
inline constexpr std::size_t kMostTensorBytes = std::size_t{512} << 20;
inline constexpr std::size_t kMostTensorFields = 256;
inline constexpr std::size_t kMostTensorRank = 8;
// Largest magnitude of a value: sums and products of a few such numbers stay far from the largest
// double.
inline constexpr float kMostTensorValue = 1e12F;

// A whole file in memory with a checked table: every field lies within the file, after the table,
// and overlaps no other; names are unique. Throws Error "<file>: <field>: expected ..., found ...".
class TensorFile {
  public:
    static TensorFile load(const std::filesystem::path& path);
    TensorFile(std::string name, std::vector<std::byte> bytes);

    const std::string& name() const { return name_; }  // for messages
    std::size_t size() const { return bytes_.size(); }
    std::span<const TensorField> fields() const { return fields_; }

    const TensorField* find(std::string_view field) const;  // nullptr when there is none
    const TensorField& require(std::string_view field, TensorType type, std::size_t rank) const;

    // Values of a float32 field; each is finite and within +-kMostTensorValue, else throws Error.
    std::vector<float> floats(const TensorField& field) const;
    std::span<const std::byte> data(const TensorField& field) const;

    [[noreturn]] void fail(std::string_view field, std::string_view expected,
                           std::string_view found) const;

  private:
    void read_table();
    void check_places(std::size_t table_end) const;

    std::string name_;
    std::vector<std::byte> bytes_;
    std::vector<TensorField> fields_;
};

// Recognizes the format by its first bytes. Throws Error when the file cannot be read.
bool is_tensor_file(const std::filesystem::path& path);

}  // namespace burnish
