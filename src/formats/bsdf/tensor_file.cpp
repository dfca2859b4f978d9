#include "formats/bsdf/tensor_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "burnish/error.hpp"
#include "core/files.hpp"

namespace burnish {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie");

constexpr std::string_view kMagic{"tensor_file\0", 12};
constexpr std::size_t kLongestName = 256;

constexpr std::array<std::string_view, 12> kTypeNames = {"",      "uint8",   "int8",    "uint16",
                                                         "int16", "uint32",  "int32",   "uint64",
                                                         "int64", "float16", "float32", "float64"};
constexpr std::array<std::size_t, 12> kTypeBytes = {0, 1, 1, 2, 2, 4, 4, 8, 8, 2, 4, 8};

// Reads the table of contents in order; throws Error when it ends beyond the file.
class TableCursor {
  public:
    TableCursor(const TensorFile& file, std::span<const std::byte> bytes)
        : file_(file), bytes_(bytes) {}

    template <typename Number>
    Number number(std::string_view what) {
        Number value{};
        std::memcpy(&value, take(sizeof value, what).data(), sizeof value);
        return value;
    }
    std::string text(std::size_t length, std::string_view what) {
        const auto span = take(length, what);
        return {reinterpret_cast<const char*>(span.data()), span.size()};
    }
    std::size_t place() const { return at_; }

  private:
    std::span<const std::byte> take(std::size_t length, std::string_view what) {
        if (length > bytes_.size() - at_) {
            file_.fail("", fmt::format("{} at byte {}", what, at_),
                       fmt::format("the end of the file ({} bytes)", bytes_.size()));
        }
        const auto span = bytes_.subspan(at_, length);
        at_ += length;
        return span;
    }

    const TensorFile& file_;
    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
};

void check_head(const TensorFile& file, TableCursor& cursor) {
    if (cursor.text(kMagic.size(), "the mark \"tensor_file\"") != kMagic)
        file.fail("", "a tensor file, which starts with \"tensor_file\"", "something else");
    const unsigned major = cursor.number<std::uint8_t>("the version");
    const unsigned minor = cursor.number<std::uint8_t>("the version");
    if (major != 1 || minor != 0) file.fail("version", "1.0", fmt::format("{}.{}", major, minor));
}

// Reads sizes whose product fits a file of kMostTensorBytes, so that no multiplication overflows.
void read_shape(const TensorFile& file, TableCursor& cursor, std::size_t rank, TensorField& field) {
    const std::size_t most = kMostTensorBytes / bytes_of(field.type);
    for (std::size_t i = 0; i < rank; ++i) {
        const auto size = cursor.number<std::uint64_t>("a size");
        if (size < 1 || size > most / field.count) {
            file.fail(shown(field.name),
                      fmt::format("sizes of at least 1 and at most {} numbers", most),
                      fmt::format("size {} along dimension {}", size, i));
        }
        field.shape.push_back(static_cast<std::size_t>(size));
        field.count *= static_cast<std::size_t>(size);
    }
}

TensorField read_field(const TensorFile& file, TableCursor& cursor, std::size_t index) {
    TensorField field;
    const std::size_t length = cursor.number<std::uint16_t>("the length of a name");
    if (length < 1 || length > kLongestName) {
        file.fail(fmt::format("field {}", index),
                  fmt::format("a name of 1 to {} bytes", kLongestName),
                  fmt::format("{} bytes", length));
    }
    field.name = cursor.text(length, "a name");
    const std::size_t rank = cursor.number<std::uint16_t>("a rank");
    if (rank > kMostTensorRank) {
        file.fail(shown(field.name), fmt::format("a rank of at most {}", kMostTensorRank),
                  std::to_string(rank));
    }
    const unsigned type = cursor.number<std::uint8_t>("a type");
    if (type < 1 || type >= kTypeBytes.size())
        file.fail(shown(field.name), "a type from 1 to 11", std::to_string(type));
    field.type = static_cast<TensorType>(type);
    const auto offset = cursor.number<std::uint64_t>("an offset");
    if (offset > file.size()) {
        file.fail(shown(field.name), fmt::format("an offset within {} bytes", file.size()),
                  std::to_string(offset));
    }
    field.offset = static_cast<std::size_t>(offset);
    read_shape(file, cursor, rank, field);
    if (field.bytes() > file.size() - field.offset) {
        file.fail(shown(field.name),
                  fmt::format("{} bytes from byte {} on", field.bytes(), field.offset),
                  fmt::format("the end of the file ({} bytes)", file.size()));
    }
    return field;
}

}  // namespace

std::string_view name_of(TensorType type) {
    return kTypeNames[static_cast<std::size_t>(type)];
}

std::size_t bytes_of(TensorType type) {
    return kTypeBytes[static_cast<std::size_t>(type)];
}

std::string TensorField::shape_text() const {
    return shape.empty() ? "a number" : fmt::format("{}", fmt::join(shape, " x "));
}

TensorFile TensorFile::load(const std::filesystem::path& path) {
    return {path.string(), read_file(path, kMostTensorBytes)};
}

TensorFile::TensorFile(std::string name, std::vector<std::byte> bytes)
    : name_(std::move(name)), bytes_(std::move(bytes)) {
    read_table();
}

void TensorFile::read_table() {
    TableCursor cursor(*this, bytes_);
    check_head(*this, cursor);
    const auto count = cursor.number<std::uint32_t>("the number of fields");
    if (count > kMostTensorFields) {
        fail("", fmt::format("at most {} fields", kMostTensorFields), std::to_string(count));
    }
    for (std::size_t i = 0; i < count; ++i) {
        TensorField field = read_field(*this, cursor, i);
        if (find(field.name)) fail(shown(field.name), "one field of that name", "two");
        fields_.push_back(std::move(field));
    }
    check_places(cursor.place());
}

void TensorFile::check_places(std::size_t table_end) const {
    std::vector<const TensorField*> in_order;
    for (const TensorField& field : fields_) in_order.push_back(&field);
    std::stable_sort(
        in_order.begin(), in_order.end(),
        [](const TensorField* a, const TensorField* b) { return a->offset < b->offset; });
    std::size_t end = table_end;
    std::string before = "the table of contents";
    for (const TensorField* field : in_order) {
        if (field->offset < end) {
            fail(shown(field->name), fmt::format("data behind {}, from byte {} on", before, end),
                 fmt::format("an offset of {}", field->offset));
        }
        end = field->offset + field->bytes();
        before = shown(field->name);
    }
}

const TensorField* TensorFile::find(std::string_view field) const {
    for (const TensorField& candidate : fields_)
        if (candidate.name == field) return &candidate;
    return nullptr;
}

const TensorField& TensorFile::require(std::string_view field, TensorType type,
                                       std::size_t rank) const {
    const TensorField* found = find(field);
    if (!found) fail(field, "this field", "none of that name");
    if (found->type != type || found->shape.size() != rank) {
        fail(field, fmt::format("{} of rank {}", name_of(type), rank),
             fmt::format("{} of rank {} ({})", name_of(found->type), found->shape.size(),
                         found->shape_text()));
    }
    return *found;
}

std::vector<float> TensorFile::floats(const TensorField& field) const {
    std::vector<float> values(field.count);
    std::memcpy(values.data(), bytes_.data() + field.offset, field.bytes());
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isfinite(values[i]) && std::fabs(values[i]) <= kMostTensorValue) continue;
        fail(shown(field.name),
             fmt::format("finite numbers within {:g}", static_cast<double>(kMostTensorValue)),
             fmt::format("{} as number {}", values[i], i));
    }
    return values;
}

std::span<const std::byte> TensorFile::data(const TensorField& field) const {
    return std::span(bytes_).subspan(field.offset, field.bytes());
}

void TensorFile::fail(std::string_view field, std::string_view expected,
                      std::string_view found) const {
    throw Error(name_, field, expected, found);
}

bool is_tensor_file(const std::filesystem::path& path) {
    const auto head = read_file_head(path, kMagic.size());
    return head.size() == kMagic.size() &&
           std::memcmp(head.data(), kMagic.data(), kMagic.size()) == 0;
}

}  // namespace burnish
