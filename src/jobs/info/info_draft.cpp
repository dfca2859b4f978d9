#include "jobs/info/info_draft.hpp"

#include <fmt/format.h>

#include "burnish/wif.hpp"
#include "core/text.hpp"
#include "jobs/info/info_scene.hpp"

namespace burnish {

namespace {

constexpr int kWidestDrawdown = 72;  // fits a terminal
constexpr int kTallestDrawdown = 32;

// As weavers draw it: the first pick at the bottom, cells filled where the warp is on top.
std::string drawdown(const Draft& draft) {
    if (draft.ends > kWidestDrawdown || draft.picks > kTallestDrawdown) return {};
    std::string text = "  the warp is on top where there is a #, the first pick is the lowest:\n";
    for (int pick = draft.picks - 1; pick >= 0; --pick) {
        text += "    ";
        for (int end = 0; end < draft.ends; ++end) text += draft.is_warp_up(end, pick) ? '#' : '.';
        text += '\n';
    }
    return text;
}

std::string count(int number, std::string_view word) {
    return plural(static_cast<std::size_t>(number), word);
}

// "repeats every 4 ends", "no repeat in the picks"
std::string repeat_of(const WifYarns& yarns, std::string_view noun) {
    return yarns.repeat < yarns.used ? fmt::format("repeats every {}", count(yarns.repeat, noun))
                                     : fmt::format("no repeat within its {}s", noun);
}

std::string drawn_part(const WifYarns& yarns, std::string_view noun) {
    if (yarns.drawn == yarns.threads) return fmt::format("all {}s", noun);
    return fmt::format("{}s {} to {}", noun, yarns.first + 1, yarns.first + yarns.drawn);
}

}  // namespace

std::string describe_draft(const std::string& path) {
    const WifFile file = read_wif(path);
    const Draft& draft = file.draft;
    const DraftFigures figures = draft_figures(draft);
    std::string text = fmt::format("{}: weaving draft \"{}\" (WIF)\n", path, draft.name);
    text += fmt::format("  {}, {}, {}, {}, {} shed, {}\n", count(file.warp.threads, "end"),
                        count(file.weft.threads, "pick"), count(file.shafts, "shaft"),
                        count(file.treadles, "treadle"), file.rising_shed ? "rising" : "sinking",
                        file.has_liftplan ? "lift plan" : "treadled");
    text += fmt::format("  {}, {}; drawn: {}, {}\n", repeat_of(file.warp, "end"),
                        repeat_of(file.weft, "pick"), drawn_part(file.warp, "end"),
                        drawn_part(file.weft, "pick"));
    text += fmt::format("  {}\n", file.colors == 0 ? std::string("no colors: those of the material")
                                                   : count(file.colors, "color"));
    text += fmt::format("  longest float of the warp over {}, of the weft over {}\n",
                        count(figures.longest_warp_float, "pick"),
                        count(figures.longest_weft_float, "end"));
    text += fmt::format("  warp on top at {:.1f} % of the crossings\n", 100 * figures.warp_share);
    for (const std::string& warning : file.warnings) text += "  warning: " + warning + "\n";
    return text + drawdown(draft);
}

}  // namespace burnish
