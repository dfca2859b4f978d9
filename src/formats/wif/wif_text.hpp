// The text of a WIF file: sections of "key=value" lines, checked while they are taken apart.
// Private to the reader of drafts (scene/wif.hpp).
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
    std::string_view key, value;  // without blanks at their ends; the key as it is written
    std::size_t line = 0;         // counted from 1
};

// One section, found or not. Its errors name the file, the section, the key and the line.
class WifSection {
  public:
    WifSection(std::shared_ptr<const std::string> file, std::string_view name)
        : file_(std::move(file)), name_(name) {}

    std::string_view name() const { return name_; }  // capital letters
    std::size_t line() const { return line_; }       // of its head; 0: it is not there
    void start(std::size_t line) { line_ = line; }
    bool empty() const { return entries_.empty(); }  // as good as not there
    void add(const WifEntry& entry) { entries_.push_back(entry); }

    // The entry of a named key, in any case. Throws when it is there twice.
    std::optional<WifEntry> find(std::string_view key) const;

    // Values of named keys. Throw unless the value is of that kind and within [low, high].
    std::optional<std::int64_t> whole(std::string_view key, std::int64_t low,
                                      std::int64_t high) const;
    std::optional<double> real(std::string_view key) const;  // finite, not negative
    std::optional<bool> truth(std::string_view key) const;
    std::optional<std::string> word(std::string_view key) const;  // capital letters, no comment

    // Calls `use(number, entry)` for every entry. Throws when a key is no number from 1 to `count`,
    // which `of` explains ("Threads of [WARP]"), or is there twice.
    void each(std::int64_t count, std::string_view of,
              const std::function<void(int, const WifEntry&)>& use) const;

    // The numbers of a comma-separated value, each within [low, high], which `of` explains; none
    // for an empty value.
    std::vector<int> list(const WifEntry& entry, std::int64_t low, std::int64_t high,
                          std::string_view of) const;
    // The first of them: in "3,255,0,0" of older files the number of a colour.
    std::optional<int> first(const WifEntry& entry, std::int64_t low, std::int64_t high,
                             std::string_view of) const;
    double real(const WifEntry& entry) const;  // finite, not negative

    [[noreturn]] void fail(const WifEntry& entry, std::string_view expected,
                           std::string_view found) const;
    [[noreturn]] void fail(std::string_view key, std::string_view expected,
                           std::string_view found) const;  // of a key that is not there

  private:
    std::shared_ptr<const std::string> file_;
    std::string_view name_;
    std::size_t line_ = 0;
    std::vector<WifEntry> entries_;
};

class WifText {
  public:
    // Takes the text apart; keeps the sections of WIF 1.1 that drafts are made of and drops the
    // others. Throws Error naming the line for what is no text, a line of more than 64 KiB, a line
    // that is neither [SECTION] nor key=value, a section that is there twice, and when there is no
    // [WIF] section.
    WifText(std::string text, std::string file);

    // One of the sections that are kept, in capital letters; empty when the file has none.
    const WifSection& section(std::string_view name) const;
    bool has(std::string_view name) const { return !section(name).empty(); }

    const std::string& file() const { return *file_; }

  private:
    void take_line(std::string_view line, std::size_t number);
    void open_section(std::string_view line, std::size_t number);

    std::shared_ptr<const std::string> file_, text_;
    std::vector<WifSection> sections_;
    WifSection* open_ = nullptr;  // the section that lines go to; null: they are dropped
    bool any_section_ = false;
};

// True when `text`, the head of a file, starts as WIF files do: with [WIF], after comments.
bool looks_like_wif(std::string_view text);

}  // namespace burnish
