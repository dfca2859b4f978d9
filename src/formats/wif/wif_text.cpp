#include "formats/wif/wif_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "burnish/error.hpp"
#include "formats/obj/obj_text.hpp"

namespace burnish {

namespace {

// 4096 numbers of five digits with their commas, twice.
constexpr std::size_t kLongestLine = 65536;
constexpr std::size_t kMostInList = 4096;

// Sections that are read or cause a warning. The other sections of WIF 1.1 and private ones do not
// change the appearance of the cloth.
constexpr std::array<std::string_view, 18> kSections = {
    "WIF",          "CONTENTS",       "COLOR PALETTE", "COLOR TABLE", "TEXT",
    "WEAVING",      "WARP",           "WEFT",          "THREADING",   "TIEUP",
    "TREADLING",    "LIFTPLAN",       "WARP COLORS",   "WEFT COLORS", "WARP SPACING",
    "WEFT SPACING", "WARP THICKNESS", "WEFT THICKNESS"};

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

// Removes a comment after a value. Only free text, such as titles, may contain semicolons.
std::string_view without_comment(std::string_view value) {
    return trimmed(value.substr(0, value.find(';')));
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
        // Old systems end files with Ctrl-Z.
        constexpr std::string_view kFine = "\t\n\v\f\r\x1A";
        return static_cast<unsigned char>(c) < 0x20 && kFine.find(c) == kFine.npos;
    });
    if (bad == text.end()) return;
    const std::string_view before(text.data(), static_cast<std::size_t>(bad - text.begin()));
    throw Error(file, fmt::format("byte {}", before.size() + 1), kExpected,
                *bad == '\0' ? std::string("a NUL byte")
                             : fmt::format("a byte {:#04x}", static_cast<unsigned char>(*bad)));
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
        if (!same_word(entry.key, key)) continue;
        if (found) fail(entry, "it once", fmt::format("it on line {} as well", found->line));
        found = entry;
    }
    return found;
}

std::optional<std::int64_t> WifSection::whole(std::string_view key, std::int64_t low,
                                              std::int64_t high) const {
    const auto entry = find(key);
    if (!entry) return std::nullopt;
    const std::string_view text = without_comment(entry->value);
    const auto value = parse_whole(text);
    if (!value || *value < low || *value > high)
        fail(*entry, fmt::format("a whole number from {} to {}", low, high), shown(text));
    return value;
}

double WifSection::real(const WifEntry& entry) const {
    const std::string_view text = without_comment(entry.value);
    double value = 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc{} || end != text.data() + text.size() || !std::isfinite(value) ||
        value < 0.0)
        fail(entry, "a number that is not negative", shown(text));
    return value;
}

std::optional<double> WifSection::real(std::string_view key) const {
    const auto entry = find(key);
    if (!entry) return std::nullopt;
    return real(*entry);
}

std::optional<bool> WifSection::truth(std::string_view key) const {
    const auto entry = find(key);
    if (!entry) return std::nullopt;
    const std::string_view text = without_comment(entry->value);
    for (const std::string_view word : {"true", "on", "yes", "1"})
        if (same_word(text, word)) return true;
    for (const std::string_view word : {"false", "off", "no", "0"})
        if (same_word(text, word)) return false;
    fail(*entry, "true, on, yes, 1, false, off, no or 0", shown(text));
}

std::optional<std::string> WifSection::word(std::string_view key) const {
    const auto entry = find(key);
    if (!entry) return std::nullopt;
    return capitals(without_comment(entry->value));
}

void WifSection::each(std::int64_t count, std::string_view of,
                      const std::function<void(int, const WifEntry&)>& use) const {
    std::vector<bool> seen(static_cast<std::size_t>(count) + 1);
    for (const WifEntry& entry : entries_) {
        const auto number = parse_whole(entry.key);
        if (!number || *number < 1 || *number > count)
            fail(entry, fmt::format("numbers from 1 to {}, {}", count, of), shown(entry.key));
        if (seen[static_cast<std::size_t>(*number)]) fail(entry, "each number once", "it again");
        seen[static_cast<std::size_t>(*number)] = true;
        use(static_cast<int>(*number), entry);
    }
}

std::vector<int> WifSection::list(const WifEntry& entry, std::int64_t low, std::int64_t high,
                                  std::string_view of) const {
    std::vector<int> values;
    std::string_view rest = without_comment(entry.value);
    while (!rest.empty()) {
        const std::size_t comma = rest.find(',');
        const std::string_view text = trimmed(rest.substr(0, comma));
        const auto value = parse_whole(text);
        if (!value || *value < low || *value > high)
            fail(entry, fmt::format("whole numbers from {} to {}, {}", low, high, of), shown(text));
        if (values.size() == kMostInList)
            fail(entry, fmt::format("at most {} numbers", kMostInList), "more");
        values.push_back(static_cast<int>(*value));
        rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
    }
    return values;
}

std::optional<int> WifSection::first(const WifEntry& entry, std::int64_t low, std::int64_t high,
                                     std::string_view of) const {
    WifEntry cut = entry;
    cut.value = without_comment(entry.value);
    cut.value = cut.value.substr(0, cut.value.find(','));
    const std::vector<int> values = list(cut, low, high, of);
    if (values.empty()) return std::nullopt;
    return values.front();
}

// --- the whole file -----------------------------------------------------------------------------

WifText::WifText(std::string text, std::string file)
    : file_(std::make_shared<const std::string>(std::move(file))),
      text_(std::make_shared<const std::string>(std::move(text))) {
    require_text(*text_, *file_);
    for (const std::string_view name : kSections) sections_.emplace_back(file_, name);
    std::string_view rest = *text_;
    if (rest.starts_with(kUtf8Mark)) rest.remove_prefix(kUtf8Mark.size());
    for (std::size_t number = 1; !rest.empty(); ++number) {
        const std::string_view line = take_line_of(rest);
        if (line.size() > kLongestLine)
            throw Error(*file_, fmt::format("line {}", number),
                        fmt::format("at most {} bytes", kLongestLine),
                        fmt::format("{}", line.size()));
        take_line(trimmed(line), number);
    }
    open_ = nullptr;
    if (section("WIF").line() == 0)
        throw Error(*file_, "", "a WIF file with a section [WIF]", "none");
}

void WifText::take_line(std::string_view line, std::size_t number) {
    if (line.empty() || line.front() == ';' || line == "\x1A") return;
    if (line.front() == '[') return open_section(line, number);
    if (any_section_ && !open_) return;  // belongs to a section that is not read
    const std::size_t equals = line.find('=');
    if (!any_section_ || equals == std::string_view::npos)
        throw Error(*file_, fmt::format("line {}", number),
                    any_section_ ? "[SECTION] or key=value" : "[WIF] before anything else",
                    shown(line));
    open_->add({trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)), number});
}

void WifText::open_section(std::string_view line, std::size_t number) {
    const std::size_t end = line.find(']');
    if (end == std::string_view::npos)
        throw Error(*file_, fmt::format("line {}", number), "[SECTION]", shown(line));
    const std::string name = capitals(trimmed(line.substr(1, end - 1)));
    any_section_ = true;
    const auto known = std::find_if(sections_.begin(), sections_.end(),
                                    [&](const WifSection& s) { return s.name() == name; });
    open_ = known == sections_.end() ? nullptr : &*known;
    if (!open_) return;
    if (open_->line() != 0)
        throw Error(*file_, fmt::format("line {}", number), fmt::format("[{}] once", name),
                    fmt::format("it on line {} as well", open_->line()));
    open_->start(number);
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
