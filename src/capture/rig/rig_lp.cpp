// .lp files: the number of lights, then a line "file x y z" for each.
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "burnish/error.hpp"
#include "capture/rig/rig_reading.hpp"

namespace burnish::rig_reading {

namespace {

constexpr std::string_view kBlanks = " \t\v\f\r";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// Returns the last word of `line` and removes it from `line`.
std::string_view take_last_word(std::string_view& line) {
    line = trimmed(line);
    const std::size_t blank = line.find_last_of(kBlanks);
    const std::string_view word = blank == line.npos ? line : line.substr(blank + 1);
    line.remove_suffix(word.size());
    return word;
}

// from_chars instead of strtod, whose decimal point depends on the locale.
std::optional<double> number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) return {};
    return value;
}

// "0,577", the notation of some locales
bool has_decimal_comma(std::string_view word) {
    const std::size_t comma = word.find(',');
    if (comma == word.npos || word.find(',', comma + 1) != word.npos) return false;
    return number(std::string(word.substr(0, comma)) + "." + std::string(word.substr(comma + 1)))
        .has_value();
}

class Reader {
  public:
    explicit Reader(const Request& request) : request_(request), file_(request.path.string()) {}

    Rig read() {
        std::string_view text = request_.text;
        if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
        std::optional<std::size_t> count;
        for (int line = 1; !text.empty(); ++line) {
            const std::size_t end = text.find('\n');
            const std::string_view content = trimmed(text.substr(0, end));
            text.remove_prefix(end == text.npos ? text.size() : end + 1);
            if (content.empty()) continue;
            where_ = fmt::format("line {}", line);
            if (!count) {
                count = read_count(content);
                counted_at_ = where_;
            } else if (rig_.lights.size() == kMostLights) {
                fail(fmt::format("at most {} lights", kMostLights), "more");
            } else {
                rig_.lights.push_back(read_light(content));
            }
        }
        if (!count) throw Error(file_, "line 1", "the number of lights", "an empty file");
        if (*count != rig_.lights.size())
            throw Error(file_, counted_at_, fmt::format("{} lines of lights", *count),
                        fmt::format("{}", rig_.lights.size()));
        warn_of_lengths();
        return std::move(rig_);
    }

  private:
    [[noreturn]] void fail(std::string_view expected, std::string_view found) const {
        throw Error(file_, where_, expected, found);
    }

    std::size_t read_count(std::string_view line) const {
        std::size_t count = 0;
        const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), count);
        if (error != std::errc() || end != line.data() + line.size())
            fail("the number of lights", shown(line));
        if (count == 0 || count > kMostLights)
            fail(fmt::format("from 1 to {} lights", kMostLights), shown(line));
        return count;
    }

    double read_number(std::string_view word) const {
        const auto value = number(word);
        if (!value && has_decimal_comma(word))
            fail("a decimal point in every number", shown(word) + " with a decimal comma");
        if (!value || !std::isfinite(*value)) fail("'file x y z'", shown(word) + " for a number");
        return *value;
    }

    RigLight read_light(std::string_view line) {
        std::array<std::string_view, 3> words;
        for (std::size_t i = 3; i-- > 0;) words[i] = take_last_word(line);
        const std::string name(trimmed(line));
        if (name.empty()) fail("'file x y z'", "fewer words");
        RigLight light;
        light.where = where_;
        for (std::size_t i = 0; i < 3; ++i) light.place.at[i] = read_number(words[i]);
        const double size = length(light.place.at);
        const double off = std::abs(size - 1.0);
        if (!(off <= kNearlyUnit))
            fail("a direction of length 1", fmt::format("one of length {:.4g}", size));
        if (off > worst_off_) {
            worst_off_ = off;
            worst_at_ = where_;
        }
        light.place.at = normalized(light.place.at);
        light.images.push_back({request_.picture(where_, name), 1.0});
        return light;
    }

    void warn_of_lengths() {
        // These files have about four digits: a smaller difference is rounding.
        if (worst_off_ > 1e-3)
            rig_.warnings.push_back(fmt::format(
                "{}: the direction's length is off by {:.2g} %: all directions are made unit",
                worst_at_, 100 * worst_off_));
    }

    const Request& request_;
    std::string file_;
    std::string where_, counted_at_, worst_at_;
    double worst_off_ = 0.0;
    Rig rig_;
};

}  // namespace

Reading read_lp(const Request& request) {
    return {Reader(request).read(), {}};
}

}  // namespace burnish::rig_reading
