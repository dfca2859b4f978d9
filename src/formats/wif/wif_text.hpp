// The text of a WIF file: sections of "key=value" lines, and values that are parsed where they are
// needed. Private to the reader of drafts (burnish/wif.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
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

// The entries of a numbered section by their number.
struct WifRows {
    std::vector<const WifEntry*> by_number;  // up to the last one; null where there is none
    std::size_t beyond = 0;                  // entries of other numbers

    const WifEntry* at(std::size_t number) const {  // counted from 1
        return number < by_number.size() ? by_number[number] : nullptr;
    }
};

// One section; `line` is 0 when the file lacks it. Errors name the file, the section, the key and
// the line.
class WifSection {
  public:
    WifSection(std::shared_ptr<const std::string> file, std::string_view name, bool is_drawn)
        : file_(std::move(file)), name_(name), is_drawn_(is_drawn) {}

    std::string_view name() const { return name_; }  // in capital letters
    bool is_drawn() const { return is_drawn_; }      // what it says changes the drawn cloth
    std::size_t line() const { return line_; }       // of its head; 0: missing
    void start(std::size_t line) { line_ = line; }
    bool empty() const { return entries_.empty(); }  // missing or without entries
    void add(const WifEntry& entry) { entries_.push_back(entry); }
    const std::vector<WifEntry>& entries() const { return entries_; }

    // The entry of a named key, in any case, with any blanks or none between its words. `find`
    // throws when the key occurs again with another value, `first` takes the first one.
    std::optional<WifEntry> find(std::string_view key) const;
    std::optional<WifEntry> first(std::string_view key) const;

    // Values of named keys that are drawn; nothing for a missing key or an empty value. They throw
    // for a value of another type and for one outside [low, high].
    std::optional<std::int64_t> whole(std::string_view key, std::int64_t low,
                                      std::int64_t high) const;
    std::optional<bool> truth(std::string_view key) const;

    // In capital letters, without a comment; the first one when the key occurs again.
    std::optional<std::string> word(std::string_view key) const;

    // The entries with the numbers 1 to `most`. Throws for a key that is no number, and for a number
    // that occurs again with another value.
    WifRows rows(int most) const;

    // The numbers of a comma-separated value. 0 and nothing stand for none and are left out. Throws
    // for what is no whole number up to `high`; `of` names the source of the range.
    std::vector<int> list(const WifEntry& entry, std::int64_t high, std::string_view of) const;
    // All numbers, each within [low, high]; throws likewise and for an item without a number.
    std::vector<int> numbers(const WifEntry& entry, std::int64_t low, std::int64_t high,
                             std::string_view of) const;

    [[noreturn]] void fail(const WifEntry& entry, std::string_view expected,
                           std::string_view found) const;
    [[noreturn]] void fail(std::string_view key, std::string_view expected,
                           std::string_view found) const;  // for a missing key

  private:
    std::vector<int> parse(const WifEntry& entry, std::int64_t low, std::int64_t high,
                           std::string_view of, bool none_is_empty) const;

    std::shared_ptr<const std::string> file_;
    std::string_view name_;
    bool is_drawn_;
    std::size_t line_ = 0;
    std::vector<WifEntry> entries_;
};

// The value without a comment. Only free text, such as titles, may contain semicolons.
std::string_view without_comment(std::string_view value);

// The first number of a list: in "3,255,0,0" of older files it is the number of a color. 0 for none,
// nothing for what is no number from 0 to `most`.
std::optional<int> first_number(const WifEntry& entry, int most);

// A number with a decimal point or a decimal comma that is finite and not negative.
std::optional<double> real_number(std::string_view value);

class WifText {
  public:
    // Parses the text up to a Ctrl-Z. Keeps the sections of WIF 1.1 that describe drafts and drops
    // the others. A section that occurs again continues the first one. Throws Error naming the line
    // for bytes that are not text, a section head without its bracket, text before the first
    // section, and in sections that are drawn for a line of more than 64 KiB and one that is not
    // key=value; throws Error without a [WIF] section.
    WifText(std::string_view text, std::string file);

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
