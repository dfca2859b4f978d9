#include "burnish/draft.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "burnish/error.hpp"
#include "burnish/shading_names.hpp"
#include "core/text.hpp"

namespace burnish {

namespace {

using IsUp = bool (*)(int end, int pick);

// `over`/`under` twill: each end passes over `over` picks and under `under` picks; the diagonal
// climbs to the right.
template <int over, int under>
bool twill(int end, int pick) {
    constexpr int kRepeat = over + under;
    return (end - pick + kRepeat * kMostDraftYarns) % kRepeat < over;
}

// Warp-faced satin: each end is below one pick per repeat, and the next pick is over the end `move`
// ends further.
template <int repeat, int move>
bool satin(int end, int pick) {
    return end != pick * move % repeat;
}

// 2/2 twill that reverses after eight ends. The first end after a reversal is the opposite of the
// last end before it (weavers' clean cut), so that no float is longer than two.
bool herringbone(int end, int pick) {
    return end < 8 ? twill<2, 2>(end, pick) : twill<2, 2>(17 - end, pick);
}

struct Builtin {
    std::string_view name;
    int ends, picks;
    IsUp is_up;
};

constexpr std::array<Builtin, 8> kBuiltins = {
    {{"plain", 2, 2, [](int end, int pick) { return (end + pick) % 2 == 0; }},
     {"twill-2-1", 3, 3, twill<2, 1>},
     {"twill-2-2", 4, 4, twill<2, 2>},
     {"twill-3-1", 4, 4, twill<3, 1>},
     {"herringbone", 16, 4, herringbone},
     {"satin-5", 5, 5, satin<5, 2>},
     {"satin-8", 8, 8, satin<8, 3>},
     {"basket", 4, 4, [](int end, int pick) { return (end / 2 + pick / 2) % 2 == 0; }}}};

constexpr auto kNames = [] {
    std::array<std::string_view, kBuiltins.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = kBuiltins[i].name;
    return names;
}();

void check_colors(const std::vector<glm::vec3>& colors, int yarns, std::string_view key,
                  std::string_view what) {
    if (colors.empty()) return;
    if (colors.size() != static_cast<std::size_t>(yarns))
        throw Error(what, key, fmt::format("{} or none", yarns), fmt::format("{}", colors.size()));
    for (const glm::vec3& c : colors)
        for (const float value : {c.x, c.y, c.z})
            if (!std::isfinite(value) || value < 0.0f)
                throw Error(what, key, "finite numbers that are not negative",
                            fmt::format("{}", value));
}

struct Run {
    int longest = 0;    // cells, of the longest float on the face
    bool loose = true;  // the yarn never changes sides
};

// The longest run of one yarn of `count` cells; runs continue across the ends of the repeat.
template <typename OnFace>
Run longest_run(int count, const OnFace& on_face) {
    Run run;
    int length = 0;
    for (int i = 0; i < 2 * count; ++i) {
        length = on_face(i % count) ? length + 1 : 0;
        run.longest = std::max(run.longest, std::min(length, count));
        run.loose = run.loose && on_face(i % count) == on_face(0);
    }
    return run;
}

}  // namespace

std::span<const std::string_view> draft_names() {
    return kNames;
}

Draft builtin_draft(std::string_view name, std::string_view where) {
    const int index = index_of_name(draft_names(), name, "weave", where);
    const Builtin& builtin = kBuiltins[static_cast<std::size_t>(index)];
    Draft draft;
    draft.name = builtin.name;
    draft.ends = builtin.ends;
    draft.picks = builtin.picks;
    for (int pick = 0; pick < draft.picks; ++pick)
        for (int end = 0; end < draft.ends; ++end)
            draft.warp_up.push_back(builtin.is_up(end, pick) ? 1 : 0);
    return draft;
}

void check_draft_size(std::int64_t ends, std::int64_t picks, std::string_view what) {
    const auto check_side = [&](std::int64_t count, std::string_view key) {
        if (count < 1 || count > kMostDraftYarns)
            throw Error(what, key, fmt::format("1 to {}", kMostDraftYarns),
                        fmt::format("{}", count));
    };
    check_side(ends, "ends");
    check_side(picks, "picks");
    if (ends * picks > kMostDraftCells)
        throw Error(what, "size", fmt::format("at most {} crossings", kMostDraftCells),
                    fmt::format("{} ends x {} picks", ends, picks));
}

void check_draft(const Draft& draft, std::string_view what) {
    check_draft_size(draft.ends, draft.picks, what);
    const auto cells = static_cast<std::size_t>(draft.ends) * static_cast<std::size_t>(draft.picks);
    if (draft.warp_up.size() != cells)
        throw Error(what, "warp_up", fmt::format("{} cells", cells),
                    fmt::format("{}", draft.warp_up.size()));
    for (const std::uint8_t cell : draft.warp_up)
        if (cell > 1) throw Error(what, "warp_up", "0 or 1", fmt::format("{}", cell));
    check_colors(draft.warp_colors, draft.ends, "warp_colors", what);
    check_colors(draft.weft_colors, draft.picks, "weft_colors", what);
}

DraftFigures draft_figures(const Draft& draft) {
    DraftFigures figures;
    const auto up = std::count(draft.warp_up.begin(), draft.warp_up.end(), std::uint8_t{1});
    figures.warp_share = static_cast<double>(up) / static_cast<double>(draft.warp_up.size());
    for (int end = 0; end < draft.ends; ++end) {
        const Run run =
            longest_run(draft.picks, [&](int pick) { return draft.is_warp_up(end, pick); });
        figures.longest_warp_float = std::max(figures.longest_warp_float, run.longest);
        figures.loose_ends += run.loose;
    }
    for (int pick = 0; pick < draft.picks; ++pick) {
        const Run run =
            longest_run(draft.ends, [&](int end) { return !draft.is_warp_up(end, pick); });
        figures.longest_weft_float = std::max(figures.longest_weft_float, run.longest);
        figures.loose_picks += run.loose;
    }
    return figures;
}

}  // namespace burnish
