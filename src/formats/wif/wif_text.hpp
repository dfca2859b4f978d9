// The text of a WIF file: sections of "key=value" lines, checked during parsing.
// Private to the reader of drafts (burnish/wif.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

struct WifEntry {
    std::string_view key, value;  // without blanks at both ends; the key with its original case
    std::size_t line = 0;         // counted from 1
};

// One section; `line` is 0 when the file lacks it. Errors name the file, the section, the key and
// the line.
class WifSection {
  public:
    WifSection(std::shared_ptr<const std::string> file, std::string_view name)
        : file_(std::move(file)), name_(name) {}

    std::string_view name() const { return name_; }  // in capital letters
    std::size_t line() const { return line_; }       // of its head; 0: missing
    void start(std::size_t line) { line_ = line; }
    bool empty() const { return entries_.empty(); }  // missing or without entries
    void add(const WifEntry& entry) { entries_.push_back(entry); }

    // The entry of a named key, in any case. Throws when the key occurs twice.
    std::optional<WifEntry> find(std::string_view key) const;

    // Values of named keys. They throw unless the value is of that type and within [low, high].
    std::optional<std::int64_t> whole(std::string_view key, std::int64_t low,
                                      std::int64_t high) const;
    std::optional<double> real(std::string_view key) const;  // finite, not negative
    std::optional<bool> truth(std::string_view key) const;
    std::optional<std::string> word(std::string_view key) const;  // capital letters, no comment

    // Calls `use(number, entry)` for every entry. Throws when a key is not a number from 1 to
    // `count` or occurs twice. `of` names the source of `count` in messages ("Threads of [WARP]").
    void each(std::int64_t count, std::string_view of,
              const std::function<void(int, const WifEntry&)>& use) const;

    // The numbers of a comma-separated value, each within [low, high]; empty for an empty value.
    // `of` names the source of the range in messages.
    std::vector<int> list(const WifEntry& entry, std::int64_t low, std::int64_t high,
                          std::string_view of) const;
    // The first number of the list: in "3,255,0,0" of older files it is the number of a color.
    std::optional<int> first(const WifEntry& entry, std::int64_t low, std::int64_t high,
                             std::string_view of) const;
    double real(const WifEntry& entry) const;  // finite, not negative

    [[noreturn]] void fail(const WifEntry& entry, std::string_view expected,
                           std::string_view found) const;
    [[noreturn]] void fail(std::string_view key, std::string_view expected,
                           std::string_view found) const;  // for a missing key

  private:
    std::shared_ptr<const std::string> file_;
    std::string_view name_;
    std::size_t line_ = 0;
    std::vector<WifEntry> entries_;
};

class WifText {
  public:
    // Parses the text. Keeps the sections of WIF 1.1 that describe drafts and drops the others.
    // Throws Error naming the line for bytes that are not text, a line of more than 64 KiB, a line
    // that is neither [SECTION] nor key=value, and a section that occurs twice; throws Error
    // without a [WIF] section.
    WifText(std::string text, std::string file);

    // A section by its name in capital letters; empty when the file lacks it.
    const WifSection& section(std::string_view name) const;
    bool has(std::string_view name) const { return !section(name).empty(); }

    const std::string& file() const { return *file_; }

  private:
    void take_line(std::string_view line, std::size_t number);
    void open_section(std::string_view line, std::size_t number);

    std::shared_ptr<const std::string> file_, text_;
    std::vector<WifSection> sections_;
    WifSection* open_ = nullptr;  // the section that receives lines; null: lines are dropped
    bool any_section_ = false;
};

// True when `text`, the start of a file, begins like a WIF file: with [WIF], after comments.
bool looks_like_wif(std::string_view text);

}  // namespace burnish
