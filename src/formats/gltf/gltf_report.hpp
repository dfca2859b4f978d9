// The state that the readers of one glTF file share: its name for messages, its warnings, and the
// amount of memory that it may still expand to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

class GltfReport {
  public:
    explicit GltfReport(std::string file) : file_(std::move(file)) {}

    const std::string& file() const { return file_; }

    // Throws Error "<file>: <key>: expected <expected>, found <found>".
    [[noreturn]] void fail(std::string_view key, std::string_view expected,
                           std::string_view found) const;

    // Keeps each warning once; beyond a screenful, one line summarizes the rest.
    void warn(std::string line);
    std::vector<std::string> take_warnings();

    // Small files can expand to any amount of memory: through accessors that share bytes or have
    // none, and through compressed views. Code that expands data first calls pay(); the file's own
    // bytes earn credit. Throws Error when the credit is used up.
    void earn(std::uint64_t file_bytes);
    void pay(std::uint64_t bytes, std::string_view key);
    bool affords(std::uint64_t bytes) const { return bytes <= credit_; }

  private:
    std::string file_;
    std::vector<std::string> warnings_;
    std::size_t more_warnings_ = 0;
    std::uint64_t credit_ = kFirstCredit;

    // 256 MiB plus 64 times the file's size. Quantized and compressed files expand about
    // twentyfold, files whose meshes share one vertex buffer more.
    static constexpr std::uint64_t kFirstCredit = std::uint64_t{256} << 20;
    static constexpr std::uint64_t kCreditPerByte = 64;
    static constexpr std::size_t kMostWarnings = 60;
};

// `items[index]`; throws Error naming `key` when the index is out of range.
template <class Item>
const Item& item_at(const std::vector<Item>& items, int index, const GltfReport& report,
                    std::string_view key) {
    if (index < 0 || static_cast<std::size_t>(index) >= items.size())
        report.fail(key, "an index below " + std::to_string(items.size()), std::to_string(index));
    return items[static_cast<std::size_t>(index)];
}

}  // namespace burnish
