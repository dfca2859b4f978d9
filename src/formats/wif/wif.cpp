// WIF: text -> tables of shafts -> the yarn on top at each crossing.
#include "burnish/wif.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bitset>
#include <cmath>
#include <optional>
#include <utility>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/files.hpp"
#include "formats/wif/wif_text.hpp"

namespace burnish {

namespace {

constexpr std::uintmax_t kMostDraftBytes = std::uintmax_t{8} << 20;
constexpr std::size_t kHeadBytes = 4096;
constexpr int kMostShafts = 4096;  // a Jacquard loom has one per end
constexpr int kMostTreadles = 4096;
constexpr int kMostColors = 65536;

using Shafts = std::bitset<kMostShafts + 1>;  // bit 0 is unused: shafts count from 1

class Reader {
  public:
    explicit Reader(const std::filesystem::path& path)
        : text_(read_text_file(path, kMostDraftBytes), path.string()) {
        read_sizes();
        name(path);
        weave();
        colors();
        warn_of_losses();
        check_draft(out_.draft, text_.file());
    }

    WifFile result() { return std::move(out_); }

  private:
    void read_sizes() {
        const WifSection& weaving = text_.section("WEAVING");
        out_.shafts = required(weaving, "Shafts", 1, kMostShafts);
        out_.treadles = static_cast<int>(weaving.whole("Treadles", 0, kMostTreadles).value_or(0));
        const auto rising = weaving.truth("Rising Shed");
        out_.rising_shed = rising.value_or(true);
        if (!rising) warn("[WEAVING] does not say Rising Shed: taken as yes");
        if (weaving.truth("Profile").value_or(false))
            warn("a profile draft: each thread stands for a block, and is drawn as one yarn");
        out_.draft.ends = required(text_.section("WARP"), "Threads", 1, kMostDraftYarns);
        out_.draft.picks = required(text_.section("WEFT"), "Threads", 1, kMostDraftYarns);
        check_draft_size(out_.draft.ends, out_.draft.picks, text_.file());
    }

    int required(const WifSection& section, std::string_view key, int low, int high) const {
        const auto value = section.whole(key, low, high);
        if (!value)
            section.fail(key, fmt::format("a whole number from {} to {}", low, high),
                         section.line() == 0 ? "no such section" : "no such key");
        return static_cast<int>(*value);
    }

    void name(const std::filesystem::path& path) {
        const auto title = text_.section("TEXT").find("Title");
        out_.draft.name = title ? one_line(title->value.substr(0, 200)) : "";
        if (out_.draft.name.empty()) out_.draft.name = one_line(path.stem().string());
    }

    // --- which yarn is on top -------------------------------------------------------------------

    // The set of shafts of each end, treadle or pick, by number.
    std::vector<Shafts> shafts_of(std::string_view section, int count,
                                  std::string_view count_is) const {
        std::vector<Shafts> sets(static_cast<std::size_t>(count) + 1);
        const WifSection& lines = text_.section(section);
        lines.each(count, count_is, [&](int number, const WifEntry& entry) {
            for (const int shaft : lines.list(entry, 0, out_.shafts, "Shafts of [WEAVING]"))
                sets[static_cast<std::size_t>(number)].set(static_cast<std::size_t>(shaft));
        });
        for (Shafts& set : sets) set.reset(0);  // 0 means no shaft
        return sets;
    }

    std::vector<Shafts> shafts_by_treadling() const {
        constexpr std::string_view kTreadles = "Treadles of [WEAVING]";
        required(text_.section("WEAVING"), "Treadles", 1, kMostTreadles);
        const std::vector<Shafts> tied = shafts_of("TIEUP", out_.treadles, kTreadles);
        std::vector<Shafts> picks(static_cast<std::size_t>(out_.draft.picks) + 1);
        const WifSection& treadling = text_.section("TREADLING");
        treadling.each(out_.draft.picks, "Threads of [WEFT]", [&](int pick, const WifEntry& entry) {
            for (const int treadle : treadling.list(entry, 0, out_.treadles, kTreadles))
                picks[static_cast<std::size_t>(pick)] |= tied[static_cast<std::size_t>(treadle)];
        });
        return picks;
    }

    // Shafts that the loom moves at each pick. A file may have both a lift plan and a treadling;
    // they must agree.
    std::vector<Shafts> moved_shafts() {
        const bool treadled = text_.has("TIEUP") && text_.has("TREADLING");
        out_.has_liftplan = text_.has("LIFTPLAN");
        if (!treadled && !out_.has_liftplan)
            throw Error(text_.file(), "", "[LIFTPLAN], or [TIEUP] and [TREADLING]",
                        text_.has("TIEUP")       ? "[TIEUP] alone"
                        : text_.has("TREADLING") ? "[TREADLING] alone"
                                                 : "none of them");
        if (!out_.has_liftplan) return shafts_by_treadling();
        std::vector<Shafts> lifted = shafts_of("LIFTPLAN", out_.draft.picks, "Threads of [WEFT]");
        if (treadled) {
            const std::vector<Shafts> trodden = shafts_by_treadling();
            const auto differ = std::mismatch(lifted.begin(), lifted.end(), trodden.begin()).first;
            if (differ != lifted.end())
                throw Error(text_.file(), fmt::format("pick {}", differ - lifted.begin()),
                            "[LIFTPLAN] and [TREADLING] to move the same shafts", "others");
        }
        return lifted;
    }

    void weave() {
        Draft& draft = out_.draft;
        if (!text_.has("THREADING")) throw Error(text_.file(), "", "a section [THREADING]", "none");
        const std::vector<Shafts> ends = shafts_of("THREADING", draft.ends, "Threads of [WARP]");
        const std::vector<Shafts> picks = moved_shafts();
        draft.warp_up.reserve(static_cast<std::size_t>(draft.ends) *
                              static_cast<std::size_t>(draft.picks));
        // An end on several shafts moves with any of them.
        for (std::size_t p = 1; p < picks.size(); ++p)
            for (std::size_t e = 1; e < ends.size(); ++e)
                draft.warp_up.push_back((ends[e] & picks[p]).any() == out_.rising_shed ? 1 : 0);
        warn_of_idle(ends, "warp threads are on no shaft");
        warn_of_idle(picks, "picks move no shaft");
    }

    void warn_of_idle(const std::vector<Shafts>& sets, const char* what) {
        const auto idle =
            std::count_if(sets.begin() + 1, sets.end(), [](const Shafts& s) { return s.none(); });
        if (idle > 0) warn(fmt::format("{} {}", idle, what));
    }

    // --- colors --------------------------------------------------------------------------------

    // Values of the palette are those of a display (sRGB), between the two numbers of Range.
    std::vector<std::optional<glm::vec3>> table() {
        const WifSection& palette = text_.section("COLOR PALETTE");
        const WifSection& rows = text_.section("COLOR TABLE");
        if (palette.word("Form").value_or("RGB") != "RGB") {
            const WifEntry form = *palette.find("Form");
            palette.fail(form, "RGB", shown(form.value));
        }
        out_.colors = required(palette, "Entries", 1, kMostColors);
        constexpr int kFarthest = 1 << 24;  // floats represent integers exactly up to here
        const auto range = palette.find("Range");
        const std::vector<int> ends =
            range ? palette.list(*range, -kFarthest, kFarthest, "black and white")
                  : std::vector<int>{};
        if (ends.size() != 2 || ends[0] >= ends[1])
            palette.fail("Range", "the numbers of black and white, such as 0,255",
                         range ? shown(range->value) : "no such key");
        std::vector<std::optional<glm::vec3>> colors(static_cast<std::size_t>(out_.colors) + 1);
        rows.each(out_.colors, "Entries of [COLOR PALETTE]", [&](int i, const WifEntry& entry) {
            const std::vector<int> rgb =
                rows.list(entry, ends[0], ends[1], "Range of [COLOR PALETTE]");
            if (rgb.size() != 3)
                rows.fail(entry, "red,green,blue", fmt::format("{} numbers", rgb.size()));
            glm::vec3 color;
            for (int c = 0; c < 3; ++c) {
                const auto above = static_cast<float>(rgb[static_cast<std::size_t>(c)] - ends[0]);
                color[c] = linear_from_srgb(above / static_cast<float>(ends[1] - ends[0]));
            }
            colors[static_cast<std::size_t>(i)] = color;
        });
        return colors;
    }

    // Colors of one family of yarns; empty when the file has none.
    std::vector<glm::vec3> yarn_colors(std::string_view family, int yarns,
                                       const std::vector<std::optional<glm::vec3>>& colors) const {
        const WifSection& all = text_.section(family);
        const WifSection& each = text_.section(std::string(family) + " COLORS");
        constexpr std::string_view kEntries = "Entries of [COLOR PALETTE]";
        const int most = static_cast<int>(colors.size()) - 1;
        const auto common = all.find("Color");
        const int usual = common ? all.first(*common, 0, most, kEntries).value_or(0) : 0;
        std::vector<int> numbers(static_cast<std::size_t>(yarns), usual);
        each.each(yarns, fmt::format("Threads of [{}]", family), [&](int i, const WifEntry& entry) {
            if (const auto number = each.first(entry, 0, most, kEntries); number && *number > 0)
                numbers[static_cast<std::size_t>(i) - 1] = *number;
        });
        if (usual == 0 && each.empty()) return {};
        std::vector<glm::vec3> out;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const auto& color = colors[static_cast<std::size_t>(numbers[i])];
            if (!color)
                throw Error(text_.file(), fmt::format("[{}] thread {}", family, i + 1),
                            "a colour of [COLOR TABLE]",
                            numbers[i] == 0 ? std::string("none, and no Color= for all of them")
                                            : fmt::format("{}, which it lacks", numbers[i]));
            out.push_back(*color);
        }
        return out;
    }

    void colors() {
        if (!text_.has("COLOR TABLE")) {
            if (text_.has("WARP COLORS") || text_.has("WEFT COLORS"))
                warn("there is no [COLOR TABLE]: the yarns have the colours of the material");
            return;
        }
        const auto colors = table();
        out_.draft.warp_colors = yarn_colors("WARP", out_.draft.ends, colors);
        out_.draft.weft_colors = yarn_colors("WEFT", out_.draft.picks, colors);
    }

    // --- ignored information ---------------------------------------------------------------------

    void warn(std::string text) { out_.warnings.push_back(std::move(text)); }

    // Length in centimeters; the plain number when the file has no unit.
    double length(const WifSection& family, std::string_view key, double otherwise) const {
        const auto value = family.real(key);
        if (!value) return otherwise;
        const std::string units = family.word("Units").value_or("");
        if (units == "DECIPOINTS") return *value * 2.54 / 720.0;
        return units == "INCHES" ? *value * 2.54 : *value;
    }

    // True when a section such as [WARP SPACING] has a value other than the common one.
    bool varies(const std::string& family, const std::string& what, int yarns) const {
        const WifSection& each =
            text_.section(family + (what == "Spacing" ? " SPACING" : " THICKNESS"));
        std::optional<double> same = text_.section(family).real(what);
        bool varies = false;
        each.each(yarns, fmt::format("Threads of [{}]", family), [&](int, const WifEntry& entry) {
            const double value = each.real(entry);
            varies = varies || (same && value != *same);
            same = value;
        });
        return varies;
    }

    // A truncated file may still give a valid cloth in other colors, so missing colors get a
    // warning.
    void warn_of_missing_colors() {
        for (const char* name : {"COLOR TABLE", "WARP COLORS", "WEFT COLORS"}) {
            const std::string said = text_.section("CONTENTS").word(name).value_or("");
            if (text_.has(name)) continue;
            if (said == "YES" || said == "TRUE" || said == "ON" || said == "1")
                warn(fmt::format("[CONTENTS] announces [{}], which is not there", name));
        }
    }

    void warn_of_losses() {
        warn_of_missing_colors();
        const WifSection &warp = text_.section("WARP"), &weft = text_.section("WEFT");
        for (const char* what : {"Spacing", "Thickness"}) {
            const bool warp_varies = varies("WARP", what, out_.draft.ends);
            const bool weft_varies = varies("WEFT", what, out_.draft.picks);
            const double a = length(warp, what, 0.0), b = length(weft, what, a);
            const bool uneven = std::abs(a - b) > 0.01 * std::max(a, b) && a > 0.0;
            if (warp_varies || weft_varies || uneven)
                warn(fmt::format("{} differs from yarn to yarn: all are drawn alike", what));
        }
        const std::string version = text_.section("WIF").word("Version").value_or("1.1");
        if (version != "1.1" && version != "1.0")
            warn(fmt::format("version {} of WIF is read as 1.1", shown(version)));
        const DraftFigures figures = draft_figures(out_.draft);
        if (figures.loose_ends + figures.loose_picks > 0)
            warn(
                fmt::format("nothing holds {} of the ends and {} of the picks: they never change "
                            "sides",
                            figures.loose_ends, figures.loose_picks));
    }

    WifText text_;
    WifFile out_;
};

}  // namespace

WifFile read_wif(const std::filesystem::path& path) {
    return Reader(path).result();
}

Draft load_wif(const std::filesystem::path& path, std::vector<std::string>& warnings) {
    WifFile file = read_wif(path);
    warnings.insert(warnings.end(), file.warnings.begin(), file.warnings.end());
    return std::move(file.draft);
}

bool is_wif_file(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (extension == ".wif") return true;
    const std::vector<std::byte> head = read_file_head(path, kHeadBytes);
    return looks_like_wif({reinterpret_cast<const char*>(head.data()), head.size()});
}

}  // namespace burnish
