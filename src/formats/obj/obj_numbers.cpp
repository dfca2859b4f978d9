#include "formats/obj/obj_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "burnish/error.hpp"
#include "core/text.hpp"
#include "formats/model_limits.hpp"

namespace burnish {
namespace {

constexpr std::string_view kBetweenWords = " \t\r\v\f";
constexpr std::size_t kMostCorners = 255;  // the parser counts them in a byte
constexpr std::array<std::string_view, 3> kWords = {"v", "vt", "vn"};
constexpr std::array<std::string_view, 3> kThings = {"vertex", "texture coordinate", "normal"};

// Numbers of a line that must be there: a texture may have one coordinate alone.
constexpr std::array<std::size_t, 3> kLeast = {3, 1, 3};

// The first word that is no number in reach; empty: all are.
std::string_view first_odd(std::string_view rest, std::size_t least, std::size_t most,
                           double reach) {
    const std::string_view whole = rest;
    for (std::size_t i = 0; i < most; ++i) {
        const std::string_view word = take_word(rest);
        if (word.empty() && i >= least) return {};
        if (word.empty()) return whole;
        const std::optional<double> number = finite_number(word);
        if (!number || std::abs(*number) > reach) return word;
    }
    return {};
}

// Many programs write numbers as the language of the system does.
std::string_view comma_hint(std::string_view word) {
    return word.find(',') == word.npos ? "" : " (OBJ has decimal points, no commas)";
}

// The number of one part of a corner; 0 for an empty one, nothing for what is none.
std::optional<std::int64_t> index_of(std::string_view text) {
    if (text.empty()) return 0;
    if (text.front() == '+') text.remove_prefix(1);
    std::int64_t value = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::string with_count(const std::string& first, std::size_t lines) {
    return lines == 1 ? first
                      : fmt::format("{} (and {})", first, plural(lines - 1, "more such line"));
}

}  // namespace

std::optional<double> finite_number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0.0;
    const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (status == std::errc::invalid_argument || end != word.data() + word.size())
        return std::nullopt;
    // Too large, or too small: from_chars does not say which.
    if (status == std::errc::result_out_of_range)
        value = std::strtod(std::string(word).c_str(), nullptr);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string_view take_word(std::string_view& rest) {
    rest.remove_prefix(std::min(rest.find_first_not_of(kBetweenWords), rest.size()));
    const std::size_t end = std::min(rest.find_first_of(kBetweenWords), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(std::min(rest.find_first_not_of(kBetweenWords, end), rest.size()));
    return word;
}

void ObjNumbers::fail(std::size_t number, std::string_view key, std::string_view expected,
                      std::string_view found) const {
    throw Error(file_, fmt::format("line {}: {}", number, key), expected, found);
}

void ObjNumbers::take(std::string_view word, std::string_view rest, std::size_t number) {
    if (word == "f") return take_face(rest, number);
    if (word == "v") return take_position(rest, number);
    take_floats(word == "vt" ? texcoord : normal, rest, number);
}

void ObjNumbers::take_position(std::string_view rest, std::size_t number) {
    const std::string_view odd = first_odd(rest, kLeast[vertex], 3, kFarthest);
    if (!odd.empty())
        fail(number, "v", fmt::format("three finite numbers up to {:g}", kFarthest),
             fmt::format("{}{}", shown(odd), comma_hint(odd)));
    ++counts_[vertex];
    geometry_.append("v ").append(rest).push_back('\n');
}

void ObjNumbers::take_floats(Kind kind, std::string_view rest, std::size_t number) {
    ++counts_[kind];
    const std::size_t most = kind == texcoord ? 2 : 3;
    // A normal is scaled to length 1, whose square must be a float.
    const double reach = static_cast<double>(kLargestTexcoord);
    const std::string_view odd = first_odd(rest, kLeast[kind], most, reach);
    geometry_.append(kWords[kind]).push_back(' ');
    geometry_.append(odd.empty() ? rest : "0 0 0").push_back('\n');
    if (odd.empty()) return;
    odd_values_[kind].add(
        fmt::format("line {}: {}: expected {} finite numbers up to 2^24, found {}{}: {}", number,
                    kWords[kind], most, shown(odd), comma_hint(odd),
                    kind == texcoord ? "0 is read" : "the normal is made from the faces"));
}

void ObjNumbers::take_corner(std::string_view word, std::size_t number) {
    Corner corner = {};
    std::string_view rest = word;
    bool good = true, whole = true;
    for (std::size_t kind = 0; kind < kKinds && good; ++kind) {
        const std::size_t slash = std::min(rest.find('/'), rest.size());
        const auto index = index_of(rest.substr(0, slash));
        good = index.has_value() && (kind < 2 || slash == rest.size());
        const bool said = slash > 0;
        rest.remove_prefix(std::min(slash + 1, rest.size()));
        if (!good) break;
        const std::int64_t from_start = *index < 0 ? counts_[kind] + *index + 1 : *index;
        corner[kind] = std::max<std::int64_t>(from_start, 0);
        if (said && corner[kind] == 0) {
            whole = false;
            if (kind == vertex)
                fail(number, "f",
                     fmt::format("vertex numbers from 1, or back from -1 to -{}", counts_[vertex]),
                     fmt::format("{}", *index));
            odd_indices_[kind].add(
                fmt::format("line {}: f: no {} {}: none is read", number, kThings[kind], *index));
        }
        if (corner[kind] > largest_[kind].index) largest_[kind] = {corner[kind], number};
    }
    if (!good || corner[vertex] == 0)
        fail(number, "f", "corners such as 7, 7/1, 7//3 or 7/1/3", shown(word));
    // The parser takes no zeros, and no slash at the end.
    if (whole && !word.ends_with('/')) {
        geometry_.append(" ").append(word);
        return;
    }
    geometry_ += fmt::format(" {}", corner[vertex]);
    if (corner[texcoord] > 0) geometry_ += fmt::format("/{}", corner[texcoord]);
    if (corner[normal] > 0)
        geometry_ += fmt::format("{}{}", corner[texcoord] > 0 ? "/" : "//", corner[normal]);
}

void ObjNumbers::take_face(std::string_view rest, std::size_t number) {
    rest = rest.substr(0, rest.find('#'));
    std::size_t corners = 0;
    for (std::string_view words = rest; !take_word(words).empty();) ++corners;
    if (corners > kMostCorners)
        fail(number, "f", fmt::format("a face of at most {} corners", kMostCorners),
             fmt::format("{}", corners));
    if (corners < 3)
        return small_faces_.add(
            fmt::format("line {}: f: expected three corners or more, found {}: the "
                        "face is not drawn",
                        number, corners));
    geometry_.push_back('f');
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest))
        take_corner(word, number);
    geometry_.push_back('\n');
}

void ObjNumbers::finish(std::vector<std::string>& warnings) const {
    const Largest& last = largest_[vertex];
    if (last.index > counts_[vertex])
        fail(last.line, "f", fmt::format("vertex numbers from 1 to {}", counts_[vertex]),
             fmt::format("{}", last.index));
    const auto add = [&](const Odd& odd) {
        if (odd.lines > 0)
            warnings.push_back(fmt::format("{}: {}", file_, with_count(odd.first, odd.lines)));
    };
    for (const std::size_t kind : {texcoord, normal}) {
        add(odd_values_[kind]);
        Odd odd = odd_indices_[kind];
        if (odd.lines == 0 && largest_[kind].index > counts_[kind])
            odd.add(fmt::format("line {}: f: no {} {}, the file has {}: none is read",
                                largest_[kind].line, kThings[kind], largest_[kind].index,
                                counts_[kind]));
        add(odd);
    }
    add(small_faces_);
}

}  // namespace burnish
