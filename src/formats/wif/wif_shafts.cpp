#include "formats/wif/wif_shafts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "burnish/error.hpp"
#include "core/text.hpp"

namespace burnish {

namespace {

constexpr std::string_view kShaftsSource = "Shafts of [WEAVING]";
constexpr std::string_view kTreadlesSource = "Treadles of [WEAVING]";

int largest(const Shafts& shafts) {
    for (int i = kMostShafts; i > 0; --i)
        if (shafts[static_cast<std::size_t>(i)]) return i;
    return 0;
}

class ShaftReader {
  public:
    ShaftReader(const WifText& text, int ends, int picks)
        : text_(text), out_{ShaftSets(ends), ShaftSets(picks), 0, 0, false, {}, {}} {}

    WifShafts read() {
        shafts_ = stated("Shafts", 1, kMostShafts);
        treadles_ = stated("Treadles", 0, kMostTreadles);
        const WifSection& threading = text_.section("THREADING");
        if (threading.empty()) throw Error(text_.file(), "", "a section [THREADING]", "none");
        const WifRows rows = rows_of(threading, out_.ends.yarns());
        read_sets(threading, rows, out_.ends);
        on_ends_ = out_.ends.all();
        read_moved();
        require_moved(threading, rows);
        count_shafts();
        return std::move(out_);
    }

  private:
    // A count of [WEAVING]. The drawn cloth does not depend on it, so a broken one is passed over.
    std::optional<int> stated(std::string_view key, int low, int high) {
        const WifSection& weaving = text_.section("WEAVING");
        const auto entry = weaving.first(key);
        if (!entry || without_comment(entry->value).empty()) return std::nullopt;
        const auto value = first_number(*entry, high);
        if (value && *value >= low) return value;
        out_.warnings.push_back(fmt::format(
            "[WEAVING] {}: expected a whole number from {} to {}, found {}: the numbers "
            "that are used count",
            key, low, high, shown(without_comment(entry->value))));
        return std::nullopt;
    }

    WifRows rows_of(const WifSection& section, std::size_t most) {
        WifRows rows = section.rows(static_cast<int>(most));
        pass_over(rows.beyond, section);
        return rows;
    }

    void pass_over(std::size_t rows, const WifSection& section) {
        if (rows > 0)
            out_.passed_over.push_back(
                fmt::format("{} of [{}]", plural(rows, "row"), section.name()));
    }

    static Shafts set_of(const WifSection& section, const WifEntry& row) {
        Shafts set;
        for (const int shaft : section.list(row, kMostShafts, "shafts"))
            set.set(static_cast<std::size_t>(shaft));
        return set;
    }

    static void read_sets(const WifSection& section, const WifRows& rows, ShaftSets& sets) {
        for (std::size_t i = 1; i < rows.by_number.size(); ++i)
            if (const WifEntry* row = rows.by_number[i]) sets.set(i - 1, set_of(section, *row));
    }

    // The shafts of each treadle that a pick uses. A treadle beyond the count of [WEAVING] must be
    // tied up.
    void tread(ShaftSets& picks) {
        const WifSection &treadling = text_.section("TREADLING"), &tieup = text_.section("TIEUP");
        const WifRows steps = rows_of(treadling, picks.yarns()), ties = tieup.rows(kMostTreadles);
        std::map<int, Shafts> tied;  // the treadles that are used
        for (std::size_t pick = 1; pick < steps.by_number.size(); ++pick) {
            const WifEntry* row = steps.by_number[pick];
            if (!row) continue;
            Shafts moved;
            for (const int treadle : treadling.list(*row, kMostTreadles, "treadles")) {
                const WifEntry* tie = ties.at(static_cast<std::size_t>(treadle));
                if (!tie && treadles_ && treadle > *treadles_)
                    treadling.fail(
                        *row,
                        fmt::format("whole numbers from 0 to {}, {}", *treadles_, kTreadlesSource),
                        fmt::format("\"{}\", which [TIEUP] does not tie", treadle));
                const auto [known, fresh] = tied.try_emplace(treadle);
                if (fresh && tie) known->second = set_of(tieup, *tie);
                moved |= known->second;
                out_.treadles = std::max(out_.treadles, treadle);
            }
            picks.set(pick - 1, moved);
        }
        std::size_t unused = ties.beyond;
        const int most = treadles_.value_or(kMostTreadles);
        for (int t = most + 1; t <= kMostTreadles; ++t)
            unused += ties.at(static_cast<std::size_t>(t)) != nullptr && !tied.contains(t);
        pass_over(unused, tieup);
    }

    // A file may have both a lift plan and a treadling; they must agree where an end is.
    void read_moved() {
        const bool treadled = text_.has("TIEUP") && text_.has("TREADLING");
        out_.has_liftplan = text_.has("LIFTPLAN");
        if (!treadled && !out_.has_liftplan)
            throw Error(text_.file(), "", "[LIFTPLAN], or [TIEUP] and [TREADLING]",
                        text_.has("TIEUP")       ? "[TIEUP] alone"
                        : text_.has("TREADLING") ? "[TREADLING] alone"
                                                 : "none of them");
        if (!out_.has_liftplan) return tread(out_.picks);
        const WifSection& plan = text_.section("LIFTPLAN");
        read_sets(plan, rows_of(plan, out_.picks.yarns()), out_.picks);
        if (!treadled) return;
        ShaftSets trodden(static_cast<int>(out_.picks.yarns()));
        try {
            tread(trodden);
        } catch (const Error& error) {
            const std::string_view line = error.what();
            out_.warnings.push_back(
                fmt::format("{}: [LIFTPLAN] is drawn in place of [TREADLING]",
                            line.substr(std::min(line.size(), text_.file().size() + 2))));
            return;
        }
        reconcile(trodden);
    }

    // Programs write the one that is not in use without any shaft.
    void reconcile(ShaftSets& trodden) {
        if ((trodden.all() & on_ends_).none()) return;
        if ((out_.picks.all() & on_ends_).none()) {
            out_.picks = std::move(trodden);
            out_.has_liftplan = false;
            return;
        }
        for (std::size_t pick = 0; pick < trodden.yarns(); ++pick)
            if (((trodden.at(pick) ^ out_.picks.at(pick)) & on_ends_).any())
                throw Error(text_.file(), fmt::format("pick {}", pick + 1),
                            "[LIFTPLAN] and [TREADLING] to move the same shafts", "others");
    }

    // A shaft beyond the count of [WEAVING] is drawn where a pick moves it. An end on one that no pick
    // moves is taken for a mistake.
    void require_moved(const WifSection& threading, const WifRows& rows) const {
        if (!shafts_) return;
        const Shafts moved = out_.picks.all();
        for (const WifEntry* row : rows.by_number) {
            if (!row) continue;
            for (const int shaft : threading.list(*row, kMostShafts, kShaftsSource))
                if (shaft > *shafts_ && !moved[static_cast<std::size_t>(shaft)])
                    threading.fail(
                        *row,
                        fmt::format("whole numbers from 0 to {}, {}", *shafts_, kShaftsSource),
                        fmt::format("\"{}\", which no pick moves", shaft));
        }
    }

    void count_shafts() {
        const int used = largest(on_ends_);
        const auto beyond = [&](std::string_view key, int stated, int most) {
            if (most > stated)
                out_.warnings.push_back(fmt::format(
                    "[WEAVING] {}={}, but {} are used: they are drawn", key, stated, most));
        };
        if (shafts_) beyond("Shafts", *shafts_, used);
        if (treadles_ && !out_.has_liftplan) beyond("Treadles", *treadles_, out_.treadles);
        out_.shafts = std::max(shafts_.value_or(0), used);
        out_.treadles = std::max(treadles_.value_or(0), out_.treadles);
    }

    const WifText& text_;
    std::optional<int> shafts_, treadles_;  // of [WEAVING]
    Shafts on_ends_;
    WifShafts out_;
};

}  // namespace

Shafts ShaftSets::all() const {
    std::vector<bool> used(sets_.size());
    for (const int number : of_) used[static_cast<std::size_t>(number)] = true;
    Shafts all;
    for (std::size_t i = 0; i < sets_.size(); ++i)
        if (used[i]) all |= sets_[i];
    return all;
}

int ShaftSets::number_of(const Shafts& shafts) {
    const auto [at, fresh] = numbers_.try_emplace(shafts, static_cast<int>(sets_.size()));
    if (fresh) sets_.push_back(shafts);
    return at->second;
}

WifShafts read_wif_shafts(const WifText& text, int ends, int picks) {
    return ShaftReader(text, ends, picks).read();
}

}  // namespace burnish
