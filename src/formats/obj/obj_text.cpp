#include "formats/obj/obj_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "formats/obj/obj_numbers.hpp"

namespace burnish {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";
constexpr std::array<std::string_view, 4> kNumbers = {"v", "vn", "vt", "f"};

// Returns one line without its end and advances `rest` past it.
std::string_view take_line(std::string_view& rest, char line_end) {
    const std::size_t end = rest.find(line_end);
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    return line;
}

class LineSorter {
  public:
    LineSorter(ObjText& out, const std::string& file) : out_(out), geometry_(out.geometry, file) {}

    void take(std::string_view line, std::size_t number) {
        line = trimmed(line);
        const std::size_t end = line.find_first_of(kBlanks);
        if (line.empty() || line.front() == '#' || end == std::string_view::npos) return;
        const std::string_view word = line.substr(0, end);
        const std::string_view rest = trimmed(line.substr(end));
        if (word == "mtllib") {
            out_.libraries.emplace_back(rest);
        } else if (word == "usemtl") {
            use_material(std::string(rest));
        } else if (std::find(kNumbers.begin(), kNumbers.end(), word) != kNumbers.end()) {
            geometry_.take(word, rest, number);
        } else if (word == "s") {
            out_.has_smoothing = true;
            out_.geometry.append(line).push_back('\n');
        } else if (word == "l" || word == "p") {
            warn("lines and points are not drawn");
        } else if (word == "curv" || word == "curv2" || word == "surf") {
            warn("curves and free-form surfaces are not drawn");
        }
    }

    void finish() { geometry_.finish(out_.warnings); }

  private:
    // Replaces the name by a number, because the parser would cut names at blanks.
    void use_material(std::string name) {
        const auto [known, fresh] = numbers_.try_emplace(name, out_.materials.size());
        if (fresh) out_.materials.push_back(std::move(name));
        out_.geometry.append(fmt::format("usemtl {}\n", known->second));
    }

    void warn(const char* text) {
        if (std::find(out_.warnings.begin(), out_.warnings.end(), text) == out_.warnings.end())
            out_.warnings.emplace_back(text);
    }

    ObjText& out_;
    ObjNumbers geometry_;
    std::map<std::string, std::size_t> numbers_;  // by material name
};

}  // namespace

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string_view without_utf8_mark(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    return text;
}

ObjText sort_obj_lines(std::string_view text, const std::string& file) {
    ObjText out;
    text = without_utf8_mark(text);
    // Carriage returns alone end lines on old systems; elsewhere one may be part of a name.
    const char line_end = text.find('\n') == text.npos ? '\r' : '\n';
    LineSorter sorter(out, file);
    std::string joined;
    for (std::size_t number = 1; !text.empty(); ++number) {
        std::string_view line = trimmed(take_line(text, line_end));
        // A backslash at the end continues the line.
        if (line.ends_with('\\') && !text.empty()) {
            line.remove_suffix(1);
            joined.append(line).push_back(' ');
            continue;
        }
        if (joined.empty()) {
            sorter.take(line, number);
        } else {
            sorter.take(joined.append(line), number);
            joined.clear();
        }
    }
    sorter.finish();
    return out;
}

}  // namespace burnish
