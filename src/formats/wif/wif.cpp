// WIF: text -> sets of shafts -> the drawn part -> the yarn on top at each crossing.
#include "burnish/wif.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "burnish/error.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "formats/wif/wif_colors.hpp"
#include "formats/wif/wif_cut.hpp"
#include "formats/wif/wif_shafts.hpp"
#include "formats/wif/wif_text.hpp"

namespace burnish {

namespace {

constexpr std::uintmax_t kMostDraftBytes = std::uintmax_t{16} << 20;
constexpr std::size_t kHeadBytes = 4096;
// Programs write up to some thousand. A yarn takes a few numbers before it is known to be drawn.
constexpr int kMostThreads = 65536;

constexpr std::string_view kMayBeCut = "the file may be cut short";

// Programs end every line, the last one too.
bool ends_within_line(std::string_view text) {
    text = text.substr(0, text.find('\x1A'));  // old systems end files with Ctrl-Z
    return !text.empty() && text.back() != '\n' && text.back() != '\r';
}

bool is_true(const std::optional<std::string>& word) {
    return word == "YES" || word == "TRUE" || word == "ON" || word == "1";
}

// Whether [CONTENTS] announces a section that is not there.
bool announces_more(const WifText& text) {
    const WifSection& contents = text.section("CONTENTS");
    constexpr const char* kNames[] = {"WEAVING",     "WARP",       "WEFT",     "THREADING",
                                      "TIEUP",       "TREADLING",  "LIFTPLAN", "COLOR TABLE",
                                      "WARP COLORS", "WEFT COLORS"};
    return std::any_of(std::begin(kNames), std::end(kNames), [&](const char* name) {
        return text.section(name).line() == 0 && is_true(contents.word(name));
    });
}

class Reader {
  public:
    // `may_be_cut`: losses are those of a file that was cut short.
    Reader(const std::filesystem::path& path, WifText text, bool may_be_cut)
        : text_(std::move(text)), may_be_cut_(may_be_cut) {
        name(path);
        const int ends = threads("WARP"), picks = threads("WEFT");
        const bool rising = rising_shed();
        WifShafts shafts = read_wif_shafts(text_, ends, picks);
        out_.shafts = shafts.shafts;
        out_.treadles = shafts.treadles;
        out_.has_liftplan = shafts.has_liftplan;
        append(out_.warnings, shafts.warnings);
        WifColors colors(text_);
        cut(shafts, colors);
        weave(shafts, rising);
        append(shafts.passed_over, colors.passed_over());
        append(out_.warnings, colors.warnings());
        if (!shafts.passed_over.empty())
            warn(fmt::format("passed over, because nothing uses them: {}",
                             fmt::join(shafts.passed_over, ", ")));
        warn_of_losses();
        check_draft(out_.draft, text_.file());
    }

    WifFile result() { return std::move(out_); }

  private:
    static void append(std::vector<std::string>& to, const std::vector<std::string>& from) {
        to.insert(to.end(), from.begin(), from.end());
    }
    void warn(std::string text) { out_.warnings.push_back(std::move(text)); }

    int threads(std::string_view family) const {
        const WifSection& section = text_.section(family);
        const auto value = section.whole("Threads", 1, kMostThreads);
        if (!value)
            section.fail("Threads", fmt::format("a whole number from 1 to {}", kMostThreads),
                         section.line() == 0                    ? "no such section"
                         : section.first("Threads").has_value() ? "no value"
                                                                : "no such key");
        return static_cast<int>(*value);
    }

    bool rising_shed() {
        const auto rising = text_.section("WEAVING").truth("Rising Shed");
        if (!rising) warn("[WEAVING] does not say Rising Shed: taken as yes");
        out_.rising_shed = rising.value_or(true);
        return out_.rising_shed;
    }

    void name(const std::filesystem::path& path) {
        const auto title = text_.section("TEXT").first("Title");
        out_.draft.name = title ? one_line(title->value.substr(0, 200)) : "";
        if (out_.draft.name.empty()) out_.draft.name = one_line(path.stem().string());
    }

    // --- the drawn part --------------------------------------------------------------------------

    void cut(const WifShafts& shafts, WifColors& colors) {
        out_.warp = used_yarns(shafts.ends);
        out_.weft = used_yarns(shafts.picks);
        const std::vector<int> warp = colors.numbers("WARP", out_.warp.threads);
        const std::vector<int> weft = colors.numbers("WEFT", out_.weft.threads);
        YarnClasses alike = yarn_classes(shafts.ends, shafts.picks);
        alike.ends = with_colors(alike.ends, warp);
        alike.picks = with_colors(alike.picks, weft);
        choose_drawn(out_.warp, out_.weft, alike);
        Draft& draft = out_.draft;
        draft.ends = out_.warp.drawn;
        draft.picks = out_.weft.drawn;
        draft.warp_colors = colors.drawn("WARP", warp, out_.warp);
        draft.weft_colors = colors.drawn("WEFT", weft, out_.weft);
        if (text_.has("COLOR TABLE")) out_.colors = colors.count();
        if (out_.colors == 0 && (text_.has("WARP COLORS") || text_.has("WEFT COLORS")))
            lose("there is no [COLOR TABLE]: the yarns have the colors of the material");
        say_cut();
    }

    // One number for each different pair of a class and a color.
    static std::vector<int> with_colors(std::vector<int> classes, const std::vector<int>& colors) {
        std::map<std::pair<int, int>, int> numbers;
        for (std::size_t i = 0; i < colors.size(); ++i) {
            const int next = static_cast<int>(numbers.size());
            classes[i] = numbers.try_emplace({classes[i], colors[i]}, next).first->second;
        }
        return classes;
    }

    void say_cut() {
        const auto idle = [](const WifYarns& yarns) { return yarns.threads - yarns.used; };
        if (idle(out_.warp) > 0)
            lose(fmt::format("{} at the sides are on no shaft and not drawn",
                             plural(static_cast<std::size_t>(idle(out_.warp)), "end")));
        if (idle(out_.weft) > 0)
            lose(fmt::format("{} at the start or the end move no shaft and are not drawn",
                             plural(static_cast<std::size_t>(idle(out_.weft)), "pick")));
        std::vector<std::string> parts;
        for (const auto& [yarns, noun] :
             {std::pair(out_.warp, "ends"), std::pair(out_.weft, "picks")}) {
            const int rest = yarns.used % yarns.repeat;
            if (yarns.drawn == yarns.used || (yarns.drawn == yarns.repeat && rest == 0)) continue;
            parts.push_back(
                yarns.drawn == yarns.repeat
                    ? fmt::format(
                          "of {} {} the repeat of {} is drawn, without the {} after the last "
                          "whole one",
                          yarns.used, noun, yarns.repeat, rest)
                    : fmt::format("of {} {} the first {} are drawn, with a seam where they start "
                                  "again",
                                  yarns.used, noun, yarns.drawn));
        }
        if (!parts.empty())
            warn(fmt::format("too large to draw whole: {}", fmt::join(parts, "; ")));
    }

    void weave(const WifShafts& shafts, bool rising) {
        Draft& draft = out_.draft;
        const std::vector<Shafts>& warp = shafts.ends.different();
        const auto ends = static_cast<std::size_t>(draft.ends);
        std::vector<std::uint8_t> up(warp.size());  // by set of an end, for one pick
        std::map<int, std::size_t> woven;           // where the row of a set of a pick begins
        draft.warp_up.resize(ends * static_cast<std::size_t>(draft.picks));
        for (std::size_t p = 0; p < static_cast<std::size_t>(draft.picks); ++p) {
            const std::size_t pick = static_cast<std::size_t>(out_.weft.first) + p;
            std::uint8_t* row = draft.warp_up.data() + p * ends;
            const auto [same, fresh] = woven.try_emplace(shafts.picks.number(pick), p * ends);
            if (!fresh) {
                std::copy_n(draft.warp_up.data() + same->second, ends, row);
                continue;
            }
            // An end on several shafts moves with any of them.
            for (std::size_t i = 0; i < warp.size(); ++i)
                up[i] = (warp[i] & shafts.picks.at(pick)).any() == rising ? 1 : 0;
            for (std::size_t e = 0; e < ends; ++e) {
                const int set = shafts.ends.number(static_cast<std::size_t>(out_.warp.first) + e);
                row[e] = up[static_cast<std::size_t>(set)];
            }
        }
    }

    // --- ignored information ---------------------------------------------------------------------

    // What a file that was cut off loses: one warning for all of it.
    void lose(std::string text) { losses_.push_back(std::move(text)); }

    void warn_of_losses() {
        if (is_true(text_.section("WEAVING").word("Profile")))
            warn("a profile draft: each thread stands for a block, and is drawn as one yarn");
        warn_of_spacing();
        const std::string version = text_.section("WIF").word("Version").value_or("1.1");
        if (version != "1.1" && version != "1.0")
            warn(fmt::format("version {} of WIF is read as 1.1", shown(version)));
        lose_missing_colors();
        const DraftFigures figures = draft_figures(out_.draft);
        if (figures.loose_ends + figures.loose_picks > 0)
            lose(
                fmt::format("nothing holds {} of the ends and {} of the picks: they never change "
                            "sides",
                            figures.loose_ends, figures.loose_picks));
        if (may_be_cut_ && !losses_.empty()) lose(std::string(kMayBeCut));
        if (!losses_.empty()) warn(fmt::format("{}", fmt::join(losses_, "; ")));
    }

    void lose_missing_colors() {
        std::vector<std::string> missing;
        for (const char* name : {"COLOR TABLE", "WARP COLORS", "WEFT COLORS"})
            if (!text_.has(name) && is_true(text_.section("CONTENTS").word(name)))
                missing.push_back(fmt::format("[{}]", name));
        if (missing.empty()) return;
        losses_.insert(losses_.begin(),
                       fmt::format("[CONTENTS] announces {}, which {} not there",
                                   fmt::join(missing, ", "), missing.size() == 1 ? "is" : "are"));
    }

    // Length in centimeters; the plain number when the file has no unit.
    static std::optional<double> length(const WifSection& family, std::string_view key) {
        const auto entry = family.first(key);
        const auto value = entry ? real_number(entry->value) : std::nullopt;
        if (!value) return std::nullopt;
        const std::string units = family.word("Units").value_or("");
        if (units == "DECIPOINTS") return *value * 2.54 / 720.0;
        return units == "INCHES" ? *value * 2.54 : *value;
    }

    // True when a section such as [WARP SPACING] has a value other than the common one. Empty values
    // and those that are no numbers are skipped: they are not drawn.
    bool varies(const std::string& family, std::string_view what, int yarns) const {
        const auto common = text_.section(family).first(what);
        std::optional<double> same = common ? real_number(common->value) : std::nullopt;
        const WifSection& each =
            text_.section(family + (what == "Spacing" ? " SPACING" : " THICKNESS"));
        bool varies = false;
        for (const WifEntry& entry : each.entries()) {
            const auto value = first_number(WifEntry{{}, entry.key, 0}, yarns).value_or(0) > 0
                                   ? real_number(entry.value)
                                   : std::nullopt;
            if (!value) continue;
            varies = varies || (same && *value != *same);
            same = value;
        }
        return varies;
    }

    void warn_of_spacing() {
        std::vector<std::string_view> uneven;
        const WifSection &warp = text_.section("WARP"), &weft = text_.section("WEFT");
        for (const std::string_view what : {"Spacing", "Thickness"}) {
            const auto a = length(warp, what), b = length(weft, what);
            const bool differ = a && b && std::abs(*a - *b) > 0.01 * std::max(*a, *b) && *a > 0.0;
            if (differ || varies("WARP", what, out_.warp.threads) ||
                varies("WEFT", what, out_.weft.threads))
                uneven.push_back(what);
        }
        if (!uneven.empty())
            warn(fmt::format("{} {} from yarn to yarn: all are drawn alike",
                             fmt::join(uneven, " and "),
                             uneven.size() == 1 ? "differs" : "differ"));
    }

    WifText text_;
    bool may_be_cut_;
    WifFile out_;
    std::vector<std::string> losses_;
};

}  // namespace

WifFile read_wif(const std::filesystem::path& path) {
    const std::string text = read_text_file(path, kMostDraftBytes);
    bool cut = ends_within_line(text);
    try {
        WifText parsed(text, path.string());
        cut = cut || announces_more(parsed);
        return Reader(path, std::move(parsed), cut).result();
    } catch (const Interrupted&) {
        throw;
    } catch (const Error& error) {
        if (!cut) throw;
        throw Error(fmt::format("{} ({})", error.what(), kMayBeCut));
    }
}

Draft load_wif(const std::filesystem::path& path, std::vector<std::string>& warnings) {
    WifFile file = read_wif(path);
    for (const std::string& line : file.warnings)
        warnings.push_back(fmt::format("{}: {}", one_line(path.string()), line));
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
