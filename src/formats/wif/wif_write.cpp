// Draft -> WIF 1.1.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/wif.hpp"

namespace burnish {

namespace {

using Code = std::array<int, 3>;  // red, green, blue, 0..255

Code code_of(const glm::vec3& color) {
    const auto code = [](float linear) {
        return static_cast<int>(
            std::lround(255.0f * std::clamp(srgb_from_linear(linear), 0.0f, 1.0f)));
    };
    return {code(color.x), code(color.y), code(color.z)};
}

// Assigns numbers from 1 in order of first occurrence.
template <typename Thing>
class Numbering {
  public:
    int operator()(const Thing& thing) {
        const auto [at, fresh] = numbers_.try_emplace(thing, static_cast<int>(numbers_.size()) + 1);
        if (fresh) things_.push_back(thing);
        return at->second;
    }
    const std::vector<Thing>& things() const { return things_; }

  private:
    std::map<Thing, int> numbers_;
    std::vector<Thing> things_;
};

std::vector<int> numbers_of(const std::vector<glm::vec3>& colors, Numbering<Code>& table) {
    std::vector<int> numbers;
    numbers.reserve(colors.size());
    for (const glm::vec3& color : colors) numbers.push_back(table(code_of(color)));
    return numbers;
}

std::string section_of(std::string_view name, const std::vector<int>& numbers) {
    if (numbers.empty()) return {};
    std::string text = fmt::format("\n[{}]\n", name);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        text += fmt::format("{}={}\n", i + 1, numbers[i]);
    return text;
}

std::string palette_text(const std::vector<Code>& codes) {
    if (codes.empty()) return {};
    std::string text = fmt::format(
        "\n[COLOR PALETTE]\nEntries={}\nForm=RGB\nRange=0,255\n\n[COLOR TABLE]\n", codes.size());
    for (std::size_t i = 0; i < codes.size(); ++i)
        text += fmt::format("{}={},{},{}\n", i + 1, codes[i][0], codes[i][1], codes[i][2]);
    return text;
}

std::vector<bool> column(const Draft& draft, int end) {
    std::vector<bool> ups;
    ups.reserve(static_cast<std::size_t>(draft.picks));
    for (int pick = 0; pick < draft.picks; ++pick) ups.push_back(draft.is_warp_up(end, pick));
    return ups;
}

bool lifts_all(const Draft& draft) {
    for (auto row = draft.warp_up.begin(); row != draft.warp_up.end(); row += draft.ends)
        if (std::count(row, row + draft.ends, std::uint8_t{1}) == 0) return false;
    return true;
}

// Picks that lift no end lift a shaft more, which no end is on.
std::string liftplan_text(const Draft& draft, const std::vector<std::vector<bool>>& shafts) {
    std::string text = "\n[LIFTPLAN]\n";
    const std::size_t empty_shaft = shafts.size() + 1;
    for (std::size_t pick = 0; pick < static_cast<std::size_t>(draft.picks); ++pick) {
        std::vector<std::size_t> lifted;
        for (std::size_t shaft = 0; shaft < shafts.size(); ++shaft)
            if (shafts[shaft][pick]) lifted.push_back(shaft + 1);
        // A pick of no shaft at the start or the end would be no part of the cloth.
        if (lifted.empty()) lifted.push_back(empty_shaft);
        text += fmt::format("{}={}\n", pick + 1, fmt::join(lifted, ","));
    }
    return text;
}

}  // namespace

std::string wif_text(const Draft& draft) {
    Numbering<std::vector<bool>> shafts;
    std::vector<int> threading;
    threading.reserve(static_cast<std::size_t>(draft.ends));
    for (int end = 0; end < draft.ends; ++end) threading.push_back(shafts(column(draft, end)));
    Numbering<Code> table;
    const std::vector<int> warp = numbers_of(draft.warp_colors, table);
    const std::vector<int> weft = numbers_of(draft.weft_colors, table);
    std::string contents = "WEAVING=yes\nWARP=yes\nWEFT=yes\nTHREADING=yes\nLIFTPLAN=yes\n";
    if (!table.things().empty()) contents += "COLOR PALETTE=yes\nCOLOR TABLE=yes\n";
    if (!warp.empty()) contents += "WARP COLORS=yes\n";
    if (!weft.empty()) contents += "WEFT COLORS=yes\n";
    const std::size_t count = shafts.things().size() + (lifts_all(draft) ? 0 : 1);
    std::string text = fmt::format(
        "[WIF]\nVersion=1.1\nDate=April 20, 1997\nDevelopers=\nSource Program=burnish\n\n"
        "[CONTENTS]\n{}\n[TEXT]\nTitle={}\n\n"
        "[WEAVING]\nShafts={}\nTreadles={}\nRising Shed=yes\n\n"
        "[WARP]\nThreads={}\n\n[WEFT]\nThreads={}\n",
        contents, one_line(draft.name), count, count, draft.ends, draft.picks);
    text += palette_text(table.things());
    text += section_of("WARP COLORS", warp);
    text += section_of("WEFT COLORS", weft);
    text += section_of("THREADING", threading);
    text += liftplan_text(draft, shafts.things());
    return text;
}

}  // namespace burnish
