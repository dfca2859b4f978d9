#include "formats/wif/wif_colors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/text.hpp"

namespace burnish {

namespace {

constexpr int kMostColors = 65536;
constexpr int kNoNumber = -1;
const glm::vec3 kNoColor(0.2140411f);  // half of a display's white: linear_from_srgb(0.5)

}  // namespace

WifColors::WifColors(const WifText& text)
    : text_(text),
      table_(text.section("COLOR TABLE").rows(kMostColors)),
      known_(table_.by_number.size()) {
    const auto entries = text.section("COLOR PALETTE").first("Entries");
    if (entries) stated_ = first_number(*entries, kMostColors).value_or(0);
    for (const WifEntry* row : table_.by_number) rows_ += row != nullptr;
}

// Values of the palette are those of a display (sRGB), between the two numbers of Range.
void WifColors::read_range() {
    if (has_range_) return;
    has_range_ = true;
    const WifSection& palette = text_.section("COLOR PALETTE");
    if (const auto form = palette.find("Form")) {
        const std::string word = palette.word("Form").value_or("");
        if (!word.empty() && word != "RGB") palette.fail(*form, "RGB", shown(form->value));
    }
    const auto range = palette.find("Range");
    if (!range || without_comment(range->value).empty()) return guess_range();
    constexpr int kFarthestCode = 1 << 24;  // floats represent integers exactly up to here
    const std::vector<int> ends =
        palette.numbers(*range, -kFarthestCode, kFarthestCode, "black and white");
    if (ends.size() != 2 || ends[0] >= ends[1])
        palette.fail(*range, "the numbers of black and white, such as 0,255", shown(range->value));
    black_ = ends[0];
    white_ = ends[1];
}

// The least of the usual ranges that the values of the table fit into.
void WifColors::guess_range() {
    int highest = 0;
    for (const WifEntry* row : table_.by_number) {
        std::string_view rest = row ? without_comment(row->value) : std::string_view();
        while (!rest.empty()) {
            const std::size_t comma = std::min(rest.find(','), rest.size());
            const double value = real_number(rest.substr(0, comma)).value_or(0.0);
            highest = std::max(highest, static_cast<int>(std::min(value, 65535.0)));
            rest.remove_prefix(std::min(comma + 1, rest.size()));
        }
    }
    white_ = highest <= 255 ? 255 : highest <= 999 ? 999 : 65535;
    warnings_.push_back(
        fmt::format("[COLOR PALETTE] does not say Range: taken as 0,{0}, as the highest value of "
                    "[COLOR TABLE] is {1} (a line Range=0,{0} in the file states it)",
                    white_, highest));
}

std::vector<int> WifColors::numbers(std::string_view family, int threads) {
    const WifSection& all = text_.section(family);
    const WifSection& each = text_.section(std::string(family) + " COLORS");
    const auto common = all.find("Color");
    const int usual = common ? first_number(*common, kMostColors).value_or(kNoNumber) : 0;
    if (usual == 0 && each.empty()) return {};
    if (!text_.has("COLOR TABLE")) return {};
    const WifRows rows = each.rows(threads);
    if (rows.beyond > 0)
        rows_beyond_.push_back(fmt::format("{} of [{}]", plural(rows.beyond, "row"), each.name()));
    std::vector<int> numbers(static_cast<std::size_t>(threads), usual);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const WifEntry* row = rows.at(i + 1);
        const int number = row ? first_number(*row, kMostColors).value_or(kNoNumber) : 0;
        if (number != 0) numbers[i] = number;
    }
    return numbers;
}

std::vector<glm::vec3> WifColors::drawn(std::string_view family, const std::vector<int>& numbers,
                                        const WifYarns& yarns) {
    std::vector<glm::vec3> colors;
    if (numbers.empty()) return colors;
    const auto of = std::span<const int>(numbers).subspan(static_cast<std::size_t>(yarns.first),
                                                          static_cast<std::size_t>(yarns.drawn));
    const auto common = text_.section(family).first("Color");
    const int usual = common ? first_number(*common, kMostColors).value_or(0) : 0;
    const glm::vec3 otherwise = has(usual) ? color(usual) : kNoColor;
    std::size_t missing = 0;
    for (std::size_t i = 0; i < of.size(); ++i) {
        if (of[i] == kNoNumber)
            throw Error(text_.file(),
                        fmt::format("[{}] thread {}", family,
                                    static_cast<std::size_t>(yarns.first) + i + 1),
                        "the number of a color",
                        fmt::format("no number from 0 to {}", kMostColors));
        missing += !has(of[i]);
        colors.push_back(has(of[i]) ? color(of[i]) : otherwise);
    }
    if (missing > 0) warn_of_missing(family, of, has(usual));
    if (missing == of.size() && !has(usual)) colors.clear();
    return colors;
}

void WifColors::warn_of_missing(std::string_view family, std::span<const int> numbers,
                                bool has_usual) {
    const auto first = std::find_if(numbers.begin(), numbers.end(), [&](int n) { return !has(n); });
    const auto missing = std::count_if(first, numbers.end(), [&](int n) { return !has(n); });
    const bool all = missing == static_cast<std::ptrdiff_t>(numbers.size());
    warnings_.push_back(fmt::format(
        "[{}]: {} of the threads have {}: {}", family, missing,
        *first == 0 ? std::string("no color, and there is no Color= for all of them")
                    : fmt::format("a color that [COLOR TABLE] lacks, such as {}", *first),
        has_usual ? "they have the one of Color="
        : all     ? "they have the color of the material"
                  : "they are gray"));
}

bool WifColors::has(int number) const {
    return number > 0 && table_.at(static_cast<std::size_t>(number)) != nullptr;
}

glm::vec3 WifColors::color(int number) {
    std::optional<glm::vec3>& known = known_[static_cast<std::size_t>(number)];
    if (known) return *known;
    read_range();
    if (stated_ > 0 && number > stated_ && !has_warned_) {
        has_warned_ = true;
        warnings_.push_back(fmt::format(
            "[COLOR PALETTE] Entries={}, but color {} is used: it is drawn", stated_, number));
    }
    known = parse(*table_.at(static_cast<std::size_t>(number)));
    return *known;
}

std::vector<std::string> WifColors::passed_over() const {
    std::vector<std::string> sections = rows_beyond_;
    std::size_t rows = table_.beyond;
    if (stated_ > 0)
        for (std::size_t i = static_cast<std::size_t>(stated_) + 1; i < known_.size(); ++i)
            rows += table_.by_number[i] != nullptr && !known_[i];
    if (rows > 0) sections.push_back(fmt::format("{} of [COLOR TABLE]", plural(rows, "row")));
    return sections;
}

glm::vec3 WifColors::parse(const WifEntry& row) const {
    const WifSection& table = text_.section("COLOR TABLE");
    const std::vector<int> rgb = table.numbers(row, black_, white_, "Range of [COLOR PALETTE]");
    if (rgb.size() != 3) table.fail(row, "red,green,blue", fmt::format("{} numbers", rgb.size()));
    glm::vec3 color;
    for (int c = 0; c < 3; ++c) {
        const auto above = static_cast<float>(rgb[static_cast<std::size_t>(c)] - black_);
        color[c] = linear_from_srgb(above / static_cast<float>(white_ - black_));
    }
    return color;
}

}  // namespace burnish
