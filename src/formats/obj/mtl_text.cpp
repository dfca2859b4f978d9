#include "formats/obj/mtl_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>

#include "burnish/error.hpp"
#include "formats/obj/obj_numbers.hpp"
#include "formats/obj/obj_text.hpp"

namespace burnish {
namespace {

// Keys that are read or have a value that says none, in the parser's letters.
constexpr std::array<std::string_view, 24> kRead = {
    "newmtl", "Kd",     "Ks",     "Ke",     "Ns",     "d",        "Tr",       "Pr",
    "Pm",     "aniso",  "anisor", "map_Kd", "map_Ke", "map_Bump", "map_bump", "bump",
    "norm",   "map_Pr", "map_Pm", "map_d",  "Ka",     "Tf",       "Pc",       "Pcr"};
// Without a meaning for the reflection that is drawn, and written by every exporter.
constexpr std::array<std::string_view, 4> kSilent = {"Ka", "Ni", "illum", "sharpness"};

struct Alias {
    std::string_view other, key;
};
constexpr std::array<Alias, 5> kAliases = {{{"map_Kn", "norm"},
                                            {"map_norm", "norm"},
                                            {"map_normal", "norm"},
                                            {"map_opacity", "map_d"},
                                            {"map_emissive", "map_Ke"}}};

bool same_letters(std::string_view a, std::string_view b) {
    const auto small = [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char x, char y) { return small(x) == small(y); });
}

std::string_view spelled(std::string_view key) {
    if (std::find(kRead.begin(), kRead.end(), key) != kRead.end()) return key;
    for (const std::string_view known : kRead)
        if (same_letters(known, key)) return known;
    for (const Alias& alias : kAliases)
        if (same_letters(alias.other, key)) return alias.key;
    return key;
}

bool is_number(std::string_view word) {
    return !word.empty() && word.find_first_not_of("0123456789+-.eE") == word.npos;
}

struct MapOption {
    std::string_view name;
    int words;               // after the name, at most
    std::string_view usual;  // for numbers that are left out; empty: any word, not left out
};
constexpr std::array<MapOption, 14> kMapOptions = {{{"-o", 3, "0"},
                                                    {"-s", 3, "1"},
                                                    {"-t", 3, "0"},
                                                    {"-mm", 2, "0"},
                                                    {"-bm", 1, "1"},
                                                    {"-boost", 1, "1"},
                                                    {"-texres", 1, "1"},
                                                    {"-blendu", 1, ""},
                                                    {"-blendv", 1, ""},
                                                    {"-cc", 1, ""},
                                                    {"-clamp", 1, ""},
                                                    {"-imfchan", 1, ""},
                                                    {"-type", 1, ""},
                                                    {"-colorspace", 1, ""}}};

const MapOption* option_at(std::string_view text) {
    const std::string_view word = take_word(text);
    const auto at = std::find_if(kMapOptions.begin(), kMapOptions.end(),
                                 [&](const MapOption& option) { return option.name == word; });
    return at == kMapOptions.end() ? nullptr : &*at;
}

// Removes the options at the start and appends them to `to`, each with all of its numbers.
void take_options(std::string_view& rest, std::string& to) {
    while (const MapOption* option = option_at(rest)) {
        take_word(rest);
        const bool unread =
            option->name == "-cc";  // the parser would take it for the picture's name
        if (!unread) to.append(option->name).append(" ");
        for (int i = 0; i < option->words; ++i) {
            std::string_view after = rest;
            const std::string_view word = take_word(after);
            const bool fits = option->usual.empty() || is_number(word);
            if (fits) rest = after;
            if (!unread) to.append(fits ? word : option->usual).append(" ");
        }
    }
}

// A map's value with its options before the name and with all of their numbers, which the parser
// needs; the standard lets the last ones be left out, and some programs write options last.
std::string map_value(std::string_view rest) {
    std::string options;
    take_options(rest, options);
    std::string_view name = rest;
    for (std::size_t at = rest.find(" -"); at != rest.npos; at = rest.find(" -", at + 1)) {
        if (!option_at(rest.substr(at))) continue;
        name = trimmed(rest.substr(0, at));
        rest.remove_prefix(at);
        take_options(rest, options);
        break;
    }
    return options.append(name);
}

bool is_map(std::string_view key) {
    return key.starts_with("map_") || key == "bump" || key == "norm" || key == "disp";
}

// --- numbers -------------------------------------------------------------------------------------

struct NumberKey {
    std::string_view name;
    std::size_t count;
    double low, high;
};
// Renderers sum light in half floats, which end at 65504.
constexpr std::array<NumberKey, 12> kNumberKeys = {{{"Kd", 3, 0.0, 1.0},
                                                    {"Ks", 3, 0.0, 1.0},
                                                    {"Ke", 3, 0.0, 65504.0},
                                                    {"Ns", 1, 0.0, 1e6},
                                                    {"d", 1, 0.0, 1.0},
                                                    {"Tr", 1, 0.0, 1.0},
                                                    {"Pr", 1, 0.0, 1.0},
                                                    {"Pm", 1, 0.0, 1.0},
                                                    {"Pc", 1, 0.0, 1.0},
                                                    {"Pcr", 1, 0.0, 1.0},
                                                    {"aniso", 1, 0.0, 1.0},
                                                    {"anisor", 1, 0.0, 1.0}}};

const NumberKey* number_key(std::string_view key) {
    const auto at = std::find_if(kNumberKeys.begin(), kNumberKeys.end(),
                                 [&](const NumberKey& row) { return row.name == key; });
    return at == kNumberKeys.end() ? nullptr : &*at;
}

struct CheckedNumbers {
    std::string text;    // within the range; empty: the key is not read
    std::string remark;  // what the file says in place of it; empty: nothing else
};

// One number stands for three equal ones. What follows the numbers is passed over.
CheckedNumbers checked_numbers(const NumberKey& key, std::string_view rest) {
    CheckedNumbers checked;
    std::vector<double> numbers;
    for (std::size_t i = 0; i < key.count; ++i) {
        const std::string_view word = take_word(rest);
        if (i == 1 && (word.empty() || word.starts_with('#'))) break;
        const std::optional<double> number = finite_number(word);
        if (!number)
            return {"", fmt::format("{}: expected {}, found {}: the key is not read", key.name,
                                    key.count == 1 ? "a number" : "three numbers",
                                    word.empty() ? "two" : shown(word))};
        numbers.push_back(std::clamp(*number, key.low, key.high));
        if (numbers.back() != *number && checked.remark.empty())
            checked.remark = fmt::format("{}: {} is not from {} to {}: {} is used", key.name,
                                         *number, key.low, key.high, numbers.back());
    }
    numbers.resize(key.count, numbers.front());
    checked.text = fmt::format("{}", fmt::join(numbers, " "));
    return checked;
}

bool says_none(const std::string& key, const std::string& value) {
    const std::string_view none = key == "Tf" ? "1" : "0";
    for (std::string_view rest = value; !rest.empty();) {
        std::string_view number = take_word(rest);
        if (number.find('.') != number.npos) {
            while (number.ends_with('0')) number.remove_suffix(1);
            if (number.ends_with('.')) number.remove_suffix(1);
        }
        if (number != none) return false;
    }
    return true;
}

}  // namespace

MtlText read_mtl_text(std::string_view text) {
    MtlText out;
    text = without_utf8_mark(text);
    out.text.reserve(text.size());
    MtlKeys* material = nullptr;  // keys before the first newmtl belong to none
    std::string name;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t blank = line.find_first_of(" \t");
        if (blank == std::string_view::npos || line.front() == '#') continue;
        const std::string_view key = spelled(line.substr(0, blank));
        const std::string_view rest = trimmed(line.substr(blank));
        std::string value = is_map(key) ? map_value(rest) : std::string(rest);
        if (const NumberKey* numbers = number_key(key)) {
            const CheckedNumbers checked = checked_numbers(*numbers, rest);
            if (material && !checked.remark.empty()) out.remarks.emplace_back(name, checked.remark);
            if (checked.text.empty()) continue;
            value = checked.text;
        }
        if (key == "newmtl") {
            name = value;
            material = &out.materials[value];
        } else if (material) {
            material->insert_or_assign(std::string(key), value);
        }
        out.text.append(key).append(" ").append(value).push_back('\n');
    }
    return out;
}

bool is_lost_mtl_key(const std::string& key, const std::string& value) {
    if (std::find(kSilent.begin(), kSilent.end(), key) != kSilent.end()) return false;
    if (key == "Tf" || key == "Ps") return !says_none(key, value);
    return std::find(kRead.begin(), kRead.end(), key) == kRead.end();
}

}  // namespace burnish
