#include "formats/json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "burnish/error.hpp"
#include "burnish/shading_names.hpp"
#include "core/text.hpp"

namespace burnish {

namespace {

using nlohmann::json;

// A scene file nests four levels deep; 32 is ample and far below the limit of any stack.
constexpr std::size_t kDeepest = 32;

// Input iterator over the text that records the position of the parser.
class CountingIterator {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* at, std::size_t* read) : at_(at), read_(read) {}
    reference operator*() const { return *at_; }
    CountingIterator& operator++() {
        ++at_;
        ++*read_;
        return *this;
    }
    CountingIterator operator++(int) {
        CountingIterator old = *this;
        ++*this;
        return old;
    }
    bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
    bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

  private:
    const char* at_;
    std::size_t* read_;
};

// "line 3, column 7" of the byte at `offset`; columns count bytes.
std::string line_and_column(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t start = before.rfind('\n');
    const std::size_t column = before.size() - (start == std::string_view::npos ? 0 : start + 1);
    return fmt::format("line {}, column {}", line, column + 1);
}

std::string shown_at(std::string_view text, std::size_t offset) {
    if (offset >= text.size()) return "the end of the file";
    const std::size_t end = text.find_first_of("\r\n", offset);
    const std::string_view rest = text.substr(offset, end == offset ? 1 : end - offset);
    return shown(rest.substr(0, 20));
}

// Rejects duplicate keys and deep nesting, which the parser would accept, during parsing.
class Guard {
  public:
    Guard(const std::string& file, std::string_view text, const std::size_t& read)
        : file_(file), text_(text), read_(read) {}

    bool operator()(int /*depth*/, json::parse_event_t event, json& parsed) {
        using Event = json::parse_event_t;
        if (event == Event::object_start || event == Event::array_start) {
            keys_.emplace_back();
            if (keys_.size() > kDeepest)
                fail(fmt::format("at most {} nested values", kDeepest), "more");
        } else if (event == Event::object_end || event == Event::array_end) {
            keys_.pop_back();
        } else if (event == Event::key) {
            const std::string& key = parsed.get_ref<const std::string&>();
            if (!keys_.back().insert(key).second) fail("each key once", shown(key) + " again");
        }
        return true;
    }

  private:
    [[noreturn]] void fail(std::string_view expected, std::string_view found) const {
        throw Error(file_, line_and_column(text_, read_ > 0 ? read_ - 1 : 0), expected, found);
    }

    const std::string& file_;
    std::string_view text_;
    const std::size_t& read_;
    std::vector<std::set<std::string>> keys_;  // of each value that contains the current position
};

// A list such as "[0, 0, 0]"; long or nested items are shortened.
std::string described_list(const json& list) {
    constexpr std::size_t kShown = 4, kLongest = 24;
    std::string text = "[";
    for (std::size_t i = 0; i < std::min(list.size(), kShown); ++i) {
        const json& entry = list[i];
        std::string shown = entry.is_structured() ? (entry.is_array() ? "[...]" : "{...}")
                            : entry.is_string()   ? "\"...\""
                                                  : entry.dump();
        if (shown.size() > kLongest) shown = shown.substr(0, kLongest) + "...";
        text += (i > 0 ? ", " : "") + shown;
    }
    return text + (list.size() > kShown ? fmt::format(", ...] ({} entries)", list.size()) : "]");
}

std::string described(const json& value) {
    switch (value.type()) {
        case json::value_t::object:
            return "an object";
        case json::value_t::array:
            return described_list(value);
        case json::value_t::string:
            return shown(value.get_ref<const std::string&>());
        default:
            return value.dump();
    }
}

}  // namespace

nlohmann::json parse_json(const std::string& file, std::string_view text) {
    std::size_t read = 0, unused = 0;
    try {
        return json::parse(CountingIterator(text.data(), &read),
                           CountingIterator(text.data() + text.size(), &unused),
                           Guard(file, text, read));
    } catch (const json::parse_error& error) {
        // `byte` counts from 1; at the end of the text it is one past the last byte.
        const std::size_t offset = error.byte > 0 ? error.byte - 1 : 0;
        throw Error(file, line_and_column(text, offset), "JSON", shown_at(text, offset));
    } catch (const json::exception&) {  // a number beyond the range of double
        throw Error(file, line_and_column(text, read > 0 ? read - 1 : 0), "a number in range",
                    "one too large");
    }
}

void JsonPlace::fail(std::string_view expected) const {
    throw Error(*file_, path_, expected, described(*value_));
}

void JsonPlace::require_object() const {
    if (!value_->is_object()) fail("an object {...}");
}

void JsonPlace::require_object(std::span<const std::string_view> keys) const {
    require_object();
    for (const auto& member : value_->items()) {
        if (std::find(keys.begin(), keys.end(), member.key()) != keys.end()) continue;
        const std::string_view nearest = nearest_name(keys, member.key());
        const std::string where = path_.empty() ? *file_ : *file_ + ": " + path_;
        throw Error(nearest.empty() ? fmt::format("{}: unknown key {}; known: {}", where,
                                                  shown(member.key()), fmt::join(keys, " "))
                                    : fmt::format("{}: unknown key {}; did you mean '{}'?", where,
                                                  shown(member.key()), nearest));
    }
}

void JsonPlace::require_array(std::size_t most) const {
    if (!value_->is_array()) fail("a list [...]");
    if (value_->size() > most) fail(fmt::format("at most {} entries", most));
}

bool JsonPlace::has(std::string_view key) const {
    return value_->contains(key);
}

JsonPlace JsonPlace::at(std::string_view key) const {
    std::string path = path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
    const auto found = value_->find(key);
    if (found == value_->end()) throw Error(*file_, path, "a value", "none");
    return JsonPlace(*this, *found, std::move(path));
}

JsonPlace JsonPlace::at(std::size_t index) const {
    return JsonPlace(*this, value_->at(index), fmt::format("{}[{}]", path_, index));
}

std::size_t JsonPlace::size() const {
    return value_->size();
}

bool JsonPlace::is_text() const {
    return value_->is_string();
}

std::string JsonPlace::text() const {
    if (!value_->is_string() || value_->get_ref<const std::string&>().empty())
        fail("a text that is not empty");
    return value_->get<std::string>();
}

double JsonPlace::number(double low, double high) const {
    // The parser accepts neither NaN nor infinity, so NAN marks another type.
    const double value = value_->is_number() ? value_->get<double>() : NAN;
    if (!(value >= low && value <= high))
        fail(fmt::format("a number from {:g} to {:g}", low, high));
    return value;
}

std::array<double, 3> JsonPlace::double_triple(double low, double high) const {
    if (!value_->is_array() || value_->size() != 3) fail("three numbers [x, y, z]");
    return {at(0).number(low, high), at(1).number(low, high), at(2).number(low, high)};
}

glm::vec3 JsonPlace::triple(double low, double high) const {
    const std::array<double, 3> v = double_triple(low, high);
    return glm::vec3(v[0], v[1], v[2]);
}

std::vector<std::string> JsonPlace::keys() const {
    std::vector<std::string> keys;
    for (const auto& member : value_->items()) keys.push_back(member.key());
    return keys;
}

}  // namespace burnish
