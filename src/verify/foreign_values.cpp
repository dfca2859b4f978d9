#include "verify/foreign_values.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>

#include "burnish/shading_names.hpp"

namespace burnish::verify {
namespace {

// Guesses are ranked on so many rows at most, evenly spaced.
constexpr std::size_t kMostRankedRows = 4000;

// RMS of theirs - scale ours over RMS of scale ours. 0 over 0: both say nothing, which agrees.
double relative_error(std::span<const double> theirs, std::span<const double> ours, double scale) {
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < theirs.size(); ++i) {
        difference += (theirs[i] - scale * ours[i]) * (theirs[i] - scale * ours[i]);
        size += scale * ours[i] * (scale * ours[i]);
    }
    if (difference == 0) return 0;
    return size > 0 ? std::sqrt(difference / size) : std::numeric_limits<double>::infinity();
}

// The factor of `ours` that comes nearest to theirs; 1 where there is none.
double best_scale(std::span<const double> theirs, std::span<const double> ours) {
    double product = 0, square = 0;
    for (std::size_t i = 0; i < theirs.size(); ++i) {
        product += theirs[i] * ours[i];
        square += ours[i] * ours[i];
    }
    return product > 0 && square > 0 ? product / square : 1;
}

// How many things are wrong: the fewest that explain the values are believed.
int slips_of(const Guess& guess, const Subject& asked) {
    return (guess.subject.method != asked.method) + (guess.subject.mdf != asked.mdf) +
           (guess.subject.brdf != asked.brdf) + (guess.alpha != AlphaSlip::none) +
           (guess.value != ValueSlip::none) + (guess.scale != 1);
}

std::vector<Subject> subjects_near(const Subject& asked) {
    std::vector<int> brdfs{asked.brdf};
    if (asked.brdf == f64::kBrdfMicrofacet) brdfs.push_back(f64::kBrdfMicrofacetSeparable);
    if (asked.brdf == f64::kBrdfMicrofacetSeparable) brdfs.push_back(f64::kBrdfMicrofacet);
    const f64::Lobe lobe = f64::lobe_make(asked.mdf, asked.p0, asked.p1);
    std::vector<Subject> subjects;
    for (const int brdf : brdfs) {
        for (int mdf = f64::kMdfAshikhminShirley; mdf <= f64::kMdfGgx; ++mdf) {
            if (f64::brdf_mdf(brdf, mdf) != mdf) continue;
            const f64::Lobe other =
                mdf == asked.mdf
                    ? lobe
                    : f64::lobe_from_alpha(mdf, f64::lobe_alpha_x(lobe), f64::lobe_alpha_y(lobe));
            for (int method = f64::kMethodNone; method <= f64::kMethodStretch; ++method) {
                if (f64::brdf_takes_method(brdf, method))
                    subjects.push_back({brdf, mdf, other.p0, other.p1, method});
            }
        }
    }
    return subjects;
}

std::vector<ValueSlip> value_slips(const Subject& s, double f0) {
    std::vector<ValueSlip> slips{ValueSlip::none, ValueSlip::cosine, ValueSlip::no_denominator};
    if (s.brdf == f64::kBrdfMicrofacet || s.brdf == f64::kBrdfMicrofacetSeparable) {
        slips.push_back(ValueSlip::clamped_visibility);
        slips.push_back(ValueSlip::no_masking);
    }
    if (f0 < 1) slips.push_back(ValueSlip::no_fresnel);
    return slips;
}

std::vector<Fit> all_fits(const Subject& asked, const Sightings& at,
                          std::span<const double> theirs) {
    std::vector<Fit> fits;
    for (const Subject& subject : subjects_near(asked)) {
        for (const AlphaSlip alpha :
             {AlphaSlip::none, AlphaSlip::swapped, AlphaSlip::squared, AlphaSlip::rooted}) {
            const GuessValues values = values_of(slipped(subject, alpha), at);
            for (const ValueSlip value : value_slips(subject, at.f0)) {
                const std::vector<double> ours = values.of(value, at);
                const double scale = best_scale(theirs, ours);
                for (const double factor : {1.0, scale})
                    fits.push_back(
                        {{subject, alpha, value, factor}, relative_error(theirs, ours, factor)});
            }
        }
    }
    return fits;
}

// What explains the values within the digits and the noise that they have.
double explained(double least_error) {
    // Twice the least: noise moves errors by less. 1e-5: values are written with six digits.
    return 2 * least_error + 1e-5;
}

Fit simplest(const std::vector<Fit>& fits, const Subject& asked) {
    double least = std::numeric_limits<double>::infinity();
    for (const Fit& fit : fits) least = std::min(least, fit.error);
    std::optional<Fit> best;
    for (const Fit& fit : fits) {
        if (fit.error > explained(least)) continue;
        const int slips = slips_of(fit.guess, asked);
        const int of_best = best ? slips_of(best->guess, asked) : std::numeric_limits<int>::max();
        if (slips < of_best || (slips == of_best && fit.error < best->error)) best = fit;
    }
    return best.value_or(Fit{{asked, {}, {}, 1}, least});
}

std::vector<int> methods_alike(const std::vector<Fit>& fits, const Fit& best) {
    std::vector<int> methods;
    for (const Fit& fit : fits) {
        const Guess &a = fit.guess, &b = best.guess;
        if (a.subject.method != b.subject.method && a.subject.mdf == b.subject.mdf &&
            a.subject.brdf == b.subject.brdf && a.alpha == b.alpha && a.value == b.value &&
            (a.scale == 1) == (b.scale == 1) && fit.error <= explained(best.error) &&
            std::find(methods.begin(), methods.end(), a.subject.method) == methods.end())
            methods.push_back(a.subject.method);
    }
    return methods;
}

// Every k-th row.
Sightings thinned(const Sightings& at, std::size_t step) {
    Sightings few{{}, {}, at.n, at.f0};
    for (std::size_t i = 0; i < at.wi.size(); i += step) {
        few.wi.push_back(at.wi[i]);
        few.wo.push_back(at.wo[i]);
    }
    return few;
}

void find_fit(const Subject& asked, const Sightings& at, std::span<const double> theirs,
              Comparison& comparison) {
    const std::size_t step = (theirs.size() + kMostRankedRows - 1) / kMostRankedRows;
    const Sightings few = thinned(at, step);
    std::vector<double> values;
    for (std::size_t i = 0; i < theirs.size(); i += step) values.push_back(theirs[i]);
    const std::vector<Fit> fits = all_fits(asked, few, values);
    comparison.fit = simplest(fits, asked);
    comparison.alike = methods_alike(fits, comparison.fit);
    const Guess& guess = comparison.fit.guess;
    const GuessValues whole = values_of(slipped(guess.subject, guess.alpha), at);
    comparison.fit.error = relative_error(theirs, whole.of(guess.value, at), guess.scale);
}

// Degrees between the mapped normal and the half vector of a row.
double highlight_from_normal(const Sightings& at, std::size_t row) {
    return angle_deg(f64::half_vector(at.wi[row] + at.wo[row], at.n), at.n);
}

std::string name_of_guess(const Guess& guess) {
    return fmt::format("{} ({}, {})", name_of(static_cast<Method>(guess.subject.method)),
                       name_of(static_cast<Brdf>(guess.subject.brdf)),
                       name_of(static_cast<Mdf>(guess.subject.mdf)));
}

std::string alike_text(const std::vector<int>& methods) {
    if (methods.empty()) return "";
    std::vector<std::string_view> names;
    for (const int method : methods) names.push_back(name_of(static_cast<Method>(method)));
    return fmt::format(". These rows do not tell it from {}", fmt::join(names, ", "));
}

std::vector<std::string> complaints(const Subject& asked, const Guess& guess) {
    std::vector<std::string> lines;
    if (guess.subject.method != asked.method)
        lines.push_back(words_of_method(guess.subject.method));
    if (guess.subject.mdf != asked.mdf)
        lines.push_back(fmt::format("the distribution is {}, not {}",
                                    name_of(static_cast<Mdf>(guess.subject.mdf)),
                                    name_of(static_cast<Mdf>(asked.mdf))));
    if (guess.subject.brdf != asked.brdf)
        lines.push_back(fmt::format("the model is {}, not {}",
                                    name_of(static_cast<Brdf>(guess.subject.brdf)),
                                    name_of(static_cast<Brdf>(asked.brdf))));
    if (guess.alpha != AlphaSlip::none) lines.push_back(words_of_slip(guess.alpha));
    if (guess.value != ValueSlip::none) lines.push_back(words_of_slip(guess.value));
    if (guess.scale != 1) lines.push_back(words_of_scale(guess.scale));
    return lines;
}

}  // namespace

Comparison compare(const Subject& asked, const Sightings& at, std::span<const double> theirs) {
    Comparison c;
    const std::vector<double> ours = values_of(asked, at).f;
    c.error = relative_error(theirs, ours, 1);
    double their_energy = 0, our_energy = 0, their_most = -1, our_most = -1, worst = -1;
    for (std::size_t i = 0; i < theirs.size(); ++i) {
        const double cos_i = std::max(f64::dot(at.n, at.wi[i]), 0.0);
        const double difference = std::abs(theirs[i] - ours[i]);
        their_energy += theirs[i] * cos_i;
        our_energy += ours[i] * cos_i;
        if (theirs[i] * cos_i > their_most) {
            their_most = theirs[i] * cos_i;
            c.brightest = i;
        }
        if (ours[i] * cos_i > our_most) {
            our_most = ours[i] * cos_i;
            c.our_brightest = i;
        }
        if (difference > worst) {
            worst = difference;
            c.worst = i;
        }
    }
    c.ours_at_worst = ours[c.worst];
    c.all_zero = std::all_of(theirs.begin(), theirs.end(), [](double f) { return f == 0; });
    c.energy_ratio =
        our_energy > 0 ? their_energy / our_energy : std::numeric_limits<double>::quiet_NaN();
    find_fit(asked, at, theirs, c);
    return c;
}

std::string verdict(const Subject& asked, const Sightings& at, const Comparison& c) {
    const Guess& guess = c.fit.guess;
    const int slips = slips_of(guess, asked);
    if (std::isnan(c.energy_ratio))
        return "our values are all 0: in every row light or eye is below the horizon of the mapped "
               "normal";
    if (c.all_zero) return "their values are all 0";
    if (!(c.fit.error <= kNear))
        return fmt::format(
            "nothing that is tried explains the values; the nearest is {}{}, {:.2g} off",
            name_of_guess(guess),
            slips == 0 ? "" : fmt::format(" where {}", fmt::join(complaints(asked, guess), "; ")),
            c.fit.error);
    std::string text =
        fmt::format("{} {} within {:.1g}", c.fit.error <= kMatch ? "matches" : "is near",
                    name_of_guess(guess), c.fit.error);
    if (slips == 0) {
        text += ", which was asked for";
    } else {
        text += fmt::format(": {}", fmt::join(complaints(asked, guess), "; "));
        text += fmt::format(
            ". At its brightest the half vector is {:.1f} degrees from the mapped normal, that of "
            "{} {:.1f}",
            highlight_from_normal(at, c.brightest), name_of(static_cast<Method>(asked.method)),
            highlight_from_normal(at, c.our_brightest));
    }
    return text + alike_text(c.alike);
}

}  // namespace burnish::verify
