// What the readers of one glTF file share: its name for messages, its warnings, and how much memory
// it may still unfold into.
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

    // Keeps a warning once; a file that earns more than a screenful gets one line for the rest.
    void warn(std::string line);
    std::vector<std::string> take_warnings();

    // Small files can be made to unfold into any amount of memory: accessors that share bytes, or
    // have none, and compressed views. Whoever is about to unfold something pays first; the file's
    // own bytes earn credit. Throws Error when the account is empty.
    void earn(std::uint64_t file_bytes);
    void pay(std::uint64_t bytes, std::string_view key);

  private:
    std::string file_;
    std::vector<std::string> warnings_;
    std::size_t more_warnings_ = 0;
    std::uint64_t credit_ = kFirstCredit;

    // 256 MiB for any file and 64 times its size: quantised and compressed files unfold about
    // twentyfold, files that share one vertex buffer among all their meshes some more.
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
