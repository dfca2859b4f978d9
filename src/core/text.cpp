#include "core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "burnish/error.hpp"

namespace burnish {
namespace {

// Longer than any name of ours: what is longer was no slip of the finger, and comparing it would
// cost time that grows with it.
constexpr std::size_t kLongestGuess = 40;

// Case and the two word separators do not count as differences.
std::string folded(std::string_view name) {
    std::string out(name);
    for (char& c : out) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        if (c == '_' || c == ' ') c = '-';
    }
    return out;
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

char small_letter(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// Removes a number from the front of `text` and returns its digits without leading zeros.
std::string_view take_number(std::string_view& text) {
    std::size_t end = 0;
    while (end < text.size() && is_digit(text[end])) ++end;
    std::string_view digits = text.substr(0, end);
    text.remove_prefix(end);
    while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
    return digits;
}

// Edit distance with insertions, deletions, replacements and swaps of neighbours, each costing 1.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min(
                {last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before.swap(last);
        last.swap(row);
    }
    return last[b.size()];
}

bool is_plain_in_shell(char c) {
    constexpr std::string_view kPlain = "_@%+=:,./-";
    const bool alphanumeric =
        (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    return alphanumeric || kPlain.find(c) != std::string_view::npos;
}

}  // namespace

std::string shell_quoted(std::string_view word) {
    if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain_in_shell))
        return std::string(word);
    std::string quoted = "'";
    for (const char c : word) {
        if (c == '\'') {
            quoted += "'\\''";
        } else {
            quoted += c;
        }
    }
    return quoted + "'";
}

bool natural_less(std::string_view a, std::string_view b) {
    std::string_view left = a, right = b;
    while (!left.empty() && !right.empty()) {
        if (is_digit(left.front()) && is_digit(right.front())) {
            const std::string_view one = take_number(left), other = take_number(right);
            if (one.size() != other.size()) return one.size() < other.size();
            if (one != other) return one < other;
            continue;
        }
        const auto one = static_cast<unsigned char>(small_letter(left.front()));
        const auto other = static_cast<unsigned char>(small_letter(right.front()));
        if (one != other) return one < other;
        left.remove_prefix(1);
        right.remove_prefix(1);
    }
    if (left.empty() != right.empty()) return left.empty();
    return a < b;
}

std::string plural(std::size_t count, std::string_view word) {
    const bool es = word.ends_with("sh");
    return fmt::format("{} {}{}", count, word, count == 1 ? "" : es ? "es" : "s");
}

std::string_view nearest_name(std::span<const std::string_view> names, std::string_view name) {
    if (name.empty() || name.size() > kLongestGuess) return {};
    const std::string wanted = folded(name);
    std::string_view nearest, container;
    // A third of the letters may be wrong, and one always; more is another word.
    std::size_t best = std::max<std::size_t>(1, wanted.size() / 3) + 1;
    for (const std::string_view known : names) {
        const std::string candidate = folded(known);
        const std::size_t distance = edit_distance(wanted, candidate);
        if (distance < best && distance < candidate.size()) {
            best = distance;
            nearest = known;
        }
        // "neutral" for "khronos-neutral": a whole piece of a name is a fair guess as well.
        if (container.empty() && wanted.size() >= 4 && candidate.find(wanted) != std::string::npos)
            container = known;
    }
    return nearest.empty() ? container : nearest;
}

void append_once(std::vector<std::string>& lines, std::string line) {
    if (std::find(lines.begin(), lines.end(), line) == lines.end())
        lines.push_back(std::move(line));
}

int index_of_name(std::span<const std::string_view> names, std::string_view name,
                  std::string_view kind, std::string_view where) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<int>(found - names.begin());
    std::string line;
    if (!where.empty()) line.append(where).append(": ");
    line.append("unknown ").append(kind).append(" ").append(shown(name));
    const std::string_view nearest = nearest_name(names, name);
    if (!nearest.empty()) line.append("; did you mean '").append(nearest).append("'?");
    line.append(nearest.empty() ? "; known:" : " known:");
    for (const std::string_view known : names) line.append(" ").append(known);
    throw UsageError(line);
}

}  // namespace burnish
