#include "formats/wif/wif_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "burnish/error.hpp"
#include "core/utf8.hpp"
#include "formats/obj/obj_text.hpp"

namespace burnish {

namespace {

// 4096 numbers of five digits with their commas, twice.
constexpr std::size_t kLongestLine = 65536;
constexpr std::size_t kMostInList = 4096;

struct KnownSection {
    std::string_view name;
    bool is_drawn;
};

// Sections that are read or cause a warning. The other sections of WIF 1.1 and private ones do not
// change the appearance of the cloth.
constexpr std::array<KnownSection, 18> kSections = {{{"WIF", false},
                                                     {"CONTENTS", false},
                                                     {"COLOR PALETTE", true},
                                                     {"COLOR TABLE", true},
                                                     {"TEXT", false},
                                                     {"WEAVING", true},
                                                     {"WARP", true},
                                                     {"WEFT", true},
                                                     {"THREADING", true},
                                                     {"TIEUP", true},
                                                     {"TREADLING", true},
                                                     {"LIFTPLAN", true},
                                                     {"WARP COLORS", true},
                                                     {"WEFT COLORS", true},
                                                     {"WARP SPACING", false},
                                                     {"WEFT SPACING", false},
                                                     {"WARP THICKNESS", false},
                                                     {"WEFT THICKNESS", false}}};

char capital(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

std::string capitals(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(), capital);
    return out;
}

bool same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return capital(x) == capital(y); });
}

// "Rising Shed", "rising  shed" and "RisingShed" are one key.
bool same_key(std::string_view a, std::string_view b) {
    const auto letters = [](std::string_view text) {
        std::string out = capitals(text);
        std::erase_if(out, [](char c) { return c == ' ' || c == '\t'; });
        return out;
    };
    return same_word(a, b) || letters(a) == letters(b);
}

// In capital letters, with one blank between words.
std::string section_name(std::string_view text) {
    std::string out;
    for (const char c : capitals(text)) {
        const bool blank = c == ' ' || c == '\t';
        if (!blank)
            out += c;
        else if (!out.ends_with(' '))
            out += ' ';
    }
    return out;
}

bool is_digits(std::string_view text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::optional<std::int64_t> parse_whole(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::string where_of(std::string_view section, std::string_view key, std::size_t line) {
    return fmt::format("[{}] {}, line {}", section, one_line(key.substr(0, 40)), line);
}

// Removes and returns one line, ended by CR, LF or both.
std::string_view take_line_of(std::string_view& rest) {
    const std::size_t end = rest.find_first_of("\r\n");
    const std::string_view line = rest.substr(0, end);
    if (end == std::string_view::npos) {
        rest = {};
    } else {
        rest.remove_prefix(rest.substr(end).starts_with("\r\n") ? end + 2 : end + 1);
    }
    return line;
}

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

void require_text(std::string_view text, const std::string& file) {
    constexpr std::string_view kExpected = "a WIF file: lines of text";
    if (text.empty()) throw Error(file, "", kExpected, "an empty file");
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw Error(file, "", kExpected, "UTF-16; save it as UTF-8");
    const auto bad = std::find_if(text.begin(), text.end(), [](char c) {
        constexpr std::string_view kFine = "\t\n\v\f\r";
        return static_cast<unsigned char>(c) < 0x20 && kFine.find(c) == kFine.npos;
    });
    if (bad == text.end()) return;
    const std::string_view before(text.data(), static_cast<std::size_t>(bad - text.begin()));
    throw Error(file, fmt::format("byte {}", before.size() + 1), kExpected,
                *bad == '\0' ? std::string("a NUL byte")
                             : fmt::format("a byte {:#04x}", static_cast<unsigned char>(*bad)));
}

// The text in UTF-8, without what follows the Ctrl-Z that old systems end files with.
std::string checked_text(std::string_view text, const std::string& file) {
    text = text.substr(0, text.find('\x1A'));
    require_text(text, file);
    return as_utf8(std::string(text));
}

}  // namespace

// --- sections -----------------------------------------------------------------------------------

void WifSection::fail(const WifEntry& entry, std::string_view expected,
                      std::string_view found) const {
    throw Error(*file_, where_of(name_, entry.key, entry.line), expected, found);
}

void WifSection::fail(std::string_view key, std::string_view expected,
                      std::string_view found) const {
    throw Error(*file_, fmt::format("[{}] {}", name_, key), expected, found);
}

std::optional<WifEntry> WifSection::find(std::string_view key) const {
    std::optional<WifEntry> found;
    for (const WifEntry& entry : entries_) {
        if (!same_key(entry.key, key)) continue;
        if (!found) {
            found = entry;
        } else if (!same_word(without_comment(entry.value), without_comment(found->value))) {
            fail(entry, fmt::format("the value of line {} again", found->line), shown(entry.value));
        }
    }
    return found;
}

std::optional<WifEntry> WifSection::first(std::string_view key) const {
    for (const WifEntry& entry : entries_)
        if (same_key(entry.key, key)) return entry;
    return std::nullopt;
}

std::optional<std::int64_t> WifSection::whole(std::string_view key, std::int64_t low,
                                              std::int64_t high) const {
    const auto entry = find(key);
    if (!entry) return std::nullopt;
    const std::string_view text = without_comment(entry->value);
    if (text.empty()) return std::nullopt;
    const auto value = parse_whole(text);
    if (!value || *value < low || *value > high)
        fail(*entry, fmt::format("a whole number from {} to {}", low, high), shown(text));
    return value;
}

std::optional<bool> WifSection::truth(std::string_view key) const {
    const auto entry = find(key);
    if (!entry) return std::nullopt;
    const std::string_view text = without_comment(entry->value);
    if (text.empty()) return std::nullopt;
    for (const std::string_view word : {"true", "on", "yes", "1"})
        if (same_word(text, word)) return true;
    for (const std::string_view word : {"false", "off", "no", "0"})
        if (same_word(text, word)) return false;
    fail(*entry, "true, on, yes, 1, false, off, no or 0", shown(text));
}

std::optional<std::string> WifSection::word(std::string_view key) const {
    const auto entry = first(key);
    if (!entry) return std::nullopt;
    return capitals(without_comment(entry->value));
}

WifRows WifSection::rows(int most) const {
    WifRows rows;
    for (const WifEntry& entry : entries_) {
        const auto number = parse_whole(entry.key);
        if (!number && !is_digits(entry.key)) fail(entry, "the number of a row", shown(entry.key));
        if (!number || *number < 1 || *number > most) {
            ++rows.beyond;
            continue;
        }
        const auto place = static_cast<std::size_t>(*number);
        if (place >= rows.by_number.size()) rows.by_number.resize(place + 1);
        const WifEntry*& row = rows.by_number[place];
        if (row && without_comment(row->value) != without_comment(entry.value))
            fail(entry, fmt::format("the value of line {} again", row->line), shown(entry.value));
        row = &entry;
    }
    return rows;
}

std::vector<int> WifSection::parse(const WifEntry& entry, std::int64_t low, std::int64_t high,
                                   std::string_view of, bool none_is_empty) const {
    std::vector<int> values;
    std::string_view rest = without_comment(entry.value);
    while (!rest.empty()) {
        const std::size_t comma = rest.find(',');
        const std::string_view text = trimmed(rest.substr(0, comma));
        rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
        if (text.empty() && none_is_empty) continue;
        const auto value = parse_whole(text);
        if (!value || *value < low || *value > high)
            fail(entry, fmt::format("whole numbers from {} to {}, {}", low, high, of), shown(text));
        if (values.size() == kMostInList)
            fail(entry, fmt::format("at most {} numbers", kMostInList), "more");
        if (*value != 0 || !none_is_empty) values.push_back(static_cast<int>(*value));
    }
    return values;
}

std::vector<int> WifSection::list(const WifEntry& entry, std::int64_t high,
                                  std::string_view of) const {
    return parse(entry, 0, high, of, true);
}

std::vector<int> WifSection::numbers(const WifEntry& entry, std::int64_t low, std::int64_t high,
                                     std::string_view of) const {
    return parse(entry, low, high, of, false);
}

// --- values of entries --------------------------------------------------------------------------

std::string_view without_comment(std::string_view value) {
    return trimmed(value.substr(0, value.find(';')));
}

std::optional<int> first_number(const WifEntry& entry, int most) {
    const std::string_view value = without_comment(entry.value);
    const std::string_view text = trimmed(value.substr(0, value.find(',')));
    if (text.empty()) return 0;
    const auto number = parse_whole(text);
    if (!number || *number < 0 || *number > most) return std::nullopt;
    return static_cast<int>(*number);
}

std::optional<double> real_number(std::string_view value) {
    std::string text(without_comment(value));
    std::replace(text.begin(), text.end(), ',', '.');
    double number = 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (status != std::errc{} || end != text.data() + text.size() || !std::isfinite(number) ||
        number < 0.0)
        return std::nullopt;
    return number;
}

// --- the whole file -----------------------------------------------------------------------------

WifText::WifText(std::string_view text, std::string file)
    : file_(std::make_shared<const std::string>(std::move(file))),
      text_(std::make_shared<const std::string>(checked_text(text, *file_))) {
    std::string_view rest = *text_;
    for (const KnownSection& section : kSections)
        sections_.emplace_back(file_, section.name, section.is_drawn);
    if (rest.starts_with(kUtf8Mark)) rest.remove_prefix(kUtf8Mark.size());
    for (std::size_t number = 1; !rest.empty(); ++number)
        take_line(trimmed(take_line_of(rest)), number);
    open_ = nullptr;
    if (section("WIF").line() == 0)
        throw Error(*file_, "", "a WIF file with a section [WIF]", "none");
}

void WifText::take_line(std::string_view line, std::size_t number) {
    if (line.empty() || line.front() == ';') return;
    if (line.front() == '[') return open_section(line, number);
    if (!any_section_)
        throw Error(*file_, fmt::format("line {}", number), "[WIF] before anything else",
                    shown(line));
    if (!open_) return;  // belongs to a section that is not read
    const std::size_t equals = line.find('=');
    if (open_->is_drawn() && line.size() > kLongestLine)
        throw Error(*file_, fmt::format("line {}", number),
                    fmt::format("at most {} bytes", kLongestLine), fmt::format("{}", line.size()));
    if (equals != std::string_view::npos)
        open_->add({trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)), number});
    else if (open_->is_drawn())
        throw Error(*file_, fmt::format("line {}", number), "[SECTION] or key=value", shown(line));
}

void WifText::open_section(std::string_view line, std::size_t number) {
    const std::size_t end = line.find(']');
    if (end == std::string_view::npos)
        throw Error(*file_, fmt::format("line {}", number), "[SECTION]", shown(line));
    const std::string name = section_name(trimmed(line.substr(1, end - 1)));
    any_section_ = true;
    const auto known = std::find_if(sections_.begin(), sections_.end(),
                                    [&](const WifSection& s) { return s.name() == name; });
    open_ = known == sections_.end() ? nullptr : &*known;
    if (open_ && open_->line() == 0) open_->start(number);
}

const WifSection& WifText::section(std::string_view name) const {
    return *std::find_if(sections_.begin(), sections_.end(),
                         [&](const WifSection& s) { return s.name() == name; });
}

bool looks_like_wif(std::string_view text) {
    if (text.starts_with(kUtf8Mark)) text.remove_prefix(kUtf8Mark.size());
    while (!text.empty()) {
        const std::string_view line = trimmed(take_line_of(text));
        if (line.empty() || line.front() == ';') continue;
        const std::size_t end = line.find(']');
        return line.front() == '[' && end != line.npos &&
               same_word(trimmed(line.substr(1, end - 1)), "WIF");
    }
    return false;
}

}  // namespace burnish
