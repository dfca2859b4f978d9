#include "capture/solve/rotation_match.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "capture/product/small_product.hpp"
#include "core/parallel.hpp"

namespace burnish {

namespace {

// Number of products of a table with its weights (products()); the four sums are made from them.
constexpr int kProducts = 3;
// Points and exemplars of one tile: the operands of a product at one frequency, 64 x 2 rings each,
// and its result fit the second-level cache.
constexpr std::size_t kPointTile = 64, kExemplarTile = 64;

// The products of one cell: m T^2, m, m T of a point; n, n C, n C^2 of an exemplar. The value of a
// masked cell may be anything, even NaN.
std::array<float, kProducts> products(float value, float weight, bool exemplar) {
    if (weight <= 0.0f) return {0.0f, 0.0f, 0.0f};
    const float first = weight * value, second = first * value;
    return exemplar ? std::array<float, kProducts>{weight, first, second}
                    : std::array<float, kProducts>{second, weight, first};
}

// Number of rotations from 0 to a quarter circle, for a grid with this many frequencies (azimuths /
// 2 + 1).
std::size_t quarter(std::size_t frequencies) {
    return (frequencies - 1) / 2 + 1;
}

// The minimum of the parabola through three equidistant values, in steps from the middle one;
// limited to half a step.
float vertex(float before, float at, float after) {
    const float bend = before - 2.0f * at + after;
    if (!(bend > 0.0f)) return 0.0f;
    return std::clamp(0.5f * (before - after) / bend, -0.5f, 0.5f);
}

}  // namespace

RotationMatcher::RotationMatcher(const NdfGrid& grid, float least_overlap)
    : grid_(grid), least_overlap_(least_overlap), frequencies_(grid.azimuths / 2 + 1) {
    const auto azimuths = static_cast<std::size_t>(grid.azimuths);
    const auto f_count = static_cast<std::size_t>(frequencies_);
    for (int r = 0; r < grid.rings; ++r)
        ring_weight_.push_back(
            static_cast<float>(std::cos(static_cast<double>(grid.theta(r))) * grid.solid_angle(r)));
    forward_.resize(azimuths * 2 * f_count);
    const double step = 2.0 * std::numbers::pi / grid.azimuths;
    const auto angle = [&](std::size_t a, std::size_t b) {
        return step * static_cast<double>((a * b) % azimuths);
    };
    for (std::size_t c = 0; c < azimuths; ++c)
        for (std::size_t f = 0; f < f_count; ++f) {
            forward_[c * 2 * f_count + f] = static_cast<float>(std::cos(angle(c, f)));
            forward_[c * 2 * f_count + f_count + f] = static_cast<float>(-std::sin(angle(c, f)));
        }
    for (std::size_t f = 0; f < f_count; ++f)
        for (std::size_t s = 0; s < quarter(f_count); ++s) {
            const bool single = f == 0 || 2 * f == azimuths;
            const double share = (single ? 1.0 : 2.0) / static_cast<double>(azimuths);
            cosines_[f % 2].push_back(static_cast<float>(share * std::cos(angle(f, s))));
            sines_[f % 2].push_back(static_cast<float>(share * std::sin(angle(f, s))));
        }
}

std::size_t RotationMatcher::block() const {
    return static_cast<std::size_t>(frequencies_) * 2 * static_cast<std::size_t>(grid_.rings);
}

// Computes the spectra of one tile of tables in the layout of the operands of L conj(R), a product
// over rings with L of a point and R of an exemplar. Of points: out[product][frequency][2
// rings][for the real part, for the imaginary part][table]; of exemplars: out[product][frequency][2
// rings][table]. The 2 rings hold the real and the imaginary parts of a table's rings.
void RotationMatcher::spectra_of(const MaskedTables& tables, std::size_t first, std::size_t count,
                                 bool exemplar, std::vector<float>& out,
                                 std::vector<float>& sums) const {
    const auto rings = static_cast<std::size_t>(grid_.rings);
    const auto azimuths = static_cast<std::size_t>(grid_.azimuths);
    const auto f_count = static_cast<std::size_t>(frequencies_);
    const std::size_t cells = rings * azimuths, width = exemplar ? count : 2 * count;
    out.resize(kProducts * block() * width);
    sums.assign(count, 0.0f);
    std::array<std::vector<float>, kProducts> columns;
    for (auto& column : columns) column.resize(cells);
    std::vector<float> transformed(rings * 2 * f_count);
    for (std::size_t t = 0; t < count; ++t) {
        const float* value = tables.values.data() + (first + t) * cells;
        const float* weight = tables.weights.data() + (first + t) * cells;
        for (std::size_t i = 0; i < cells; ++i) {
            const auto p = products(value[i], weight[i], exemplar);
            // The weight of a ring, cos(theta) dw, is applied once in each product: to the point.
            const float share = exemplar ? 1.0f : ring_weight_[i / azimuths];
            for (std::size_t k = 0; k < kProducts; ++k)
                columns[k][i % azimuths * rings + i / azimuths] = share * p[k];
            sums[t] += ring_weight_[i / azimuths] * std::max(weight[i], 0.0f);
        }
        for (std::size_t k = 0; k < kProducts; ++k) {
            small_product(rings, 2 * f_count, azimuths, columns[k].data(), forward_.data(),
                          2 * f_count, transformed.data());
            for (std::size_t f = 0; f < f_count; ++f)
                for (std::size_t r = 0; r < rings; ++r) {
                    const float* from = transformed.data() + r * 2 * f_count + f;
                    const float re = from[0], im = from[f_count];
                    float* row = out.data() + ((k * f_count + f) * 2 * rings + r) * width + t;
                    float* row_im = row + rings * width;
                    row[0] = re;
                    row_im[0] = im;
                    if (exemplar) continue;
                    // L conj(R) = (Lre Rre + Lim Rim) + i (Lim Rre - Lre Rim)
                    row[count] = im;
                    row_im[count] = -re;
                }
        }
    }
}

void RotationMatcher::set_exemplars(const MaskedTables& exemplars) {
    count_ = exemplars.count;
    spectra_.clear();
    sums_.clear();
    const std::size_t tiles = (count_ + kExemplarTile - 1) / kExemplarTile;
    spectra_.resize(kProducts * block() * count_);
    sums_.resize(count_);
    parallel_for(tiles, 1, [&](std::size_t begin, std::size_t) {
        const std::size_t first = begin * kExemplarTile;
        const std::size_t count = std::min(kExemplarTile, count_ - first);
        std::vector<float> tile, tile_sums;
        spectra_of(exemplars, first, count, true, tile, tile_sums);
        std::copy(tile.begin(), tile.end(),
                  spectra_.begin() + static_cast<std::ptrdiff_t>(kProducts * block() * first));
        std::copy(tile_sums.begin(), tile_sums.end(),
                  sums_.begin() + static_cast<std::ptrdiff_t>(first));
    });
}

// Matches the points of one tile against the exemplars of one tile.
class RotationMatcher::Tile {
  public:
    explicit Tile(const RotationMatcher& matcher)
        : m_(matcher),
          rings_(static_cast<std::size_t>(matcher.grid_.rings)),
          f_count_(static_cast<std::size_t>(matcher.frequencies_)) {}

    // Spectra and sums in the layout of spectra_of.
    void set_exemplars(const float* spectra, const float* sums, std::size_t count) {
        exemplars_ = count;
        exemplar_spectra_ = spectra;
        exemplar_sums_ = sums;
    }

    void match(const float* points, const float* sums, std::size_t count, RotationMatch* out,
               std::size_t stride) {
        correlate(points, count);
        for (std::size_t first = 0; first < count; first += kChunk) {
            const std::size_t some = std::min(kChunk, count - first);
            for (std::size_t k = 0; k < kSums; ++k)
                over_rotations(k, first * exemplars_, some * exemplars_, count * exemplars_);
            choose(some, sums + first, out + first * stride, stride);
        }
    }

  private:
    // The four sums of the header, as indices of sums_.
    static constexpr std::size_t kA = 0, kO = 1, kB = 2, kX = 3, kSums = 4;
    // Points whose sums are computed at all rotations, then compared. The sums of 4 points and 64
    // exemplars take 0.4 MB and stay in the cache until they are compared.
    static constexpr std::size_t kChunk = 4;

    // Multiplies spectra: products_[sum][parity of the frequency][frequency / 2][re, im][pair].
    void correlate(const float* points, std::size_t count) {
        // A: m T^2 with n; O: m with n; B: m with n C^2; X: m T with n C.
        static constexpr std::size_t kOfPoint[] = {0, 1, 1, 2}, kOfExemplar[] = {0, 0, 2, 1};
        const std::size_t depth = 2 * rings_, pairs = count * exemplars_;
        for (std::size_t k = 0; k < kSums; ++k) {
            for (std::size_t odd = 0; odd < 2; ++odd)
                products_[k][odd].resize(of_parity(odd) * 2 * pairs);
            for (std::size_t f = 0; f < f_count_; ++f)
                small_product(
                    2 * count, exemplars_, depth,
                    points + (kOfPoint[k] * f_count_ + f) * 2 * count * depth,
                    exemplar_spectra_ + (kOfExemplar[k] * f_count_ + f) * depth * exemplars_,
                    exemplars_, products_[k][f % 2].data() + (f / 2) * 2 * pairs);
        }
    }

    // Number of even (odd = 0) or odd (odd = 1) frequencies.
    std::size_t of_parity(std::size_t odd) const { return (f_count_ + 1 - odd) / 2; }

    // Transforms products_[k] of the pairs [first, first + count) of `all` to rotations:
    // sums_[k][rotation][pair].
    void over_rotations(std::size_t k, std::size_t first, std::size_t count, std::size_t all) {
        const std::size_t quarters = quarter(f_count_);
        for (std::size_t odd = 0; odd < 2; ++odd) {
            const float* re = products_[k][odd].data() + first;
            cosine_sums_[odd].resize(quarters * count);
            sine_sums_[odd].resize(quarters * count);
            small_product(quarters, count, of_parity(odd), m_.cosines_[odd].data(), re, 2 * all,
                          cosine_sums_[odd].data());
            small_product(quarters, count, of_parity(odd), m_.sines_[odd].data(), re + all, 2 * all,
                          sine_sums_[odd].data());
        }
        sums_[k].resize(static_cast<std::size_t>(m_.grid_.azimuths) * count);
        for (std::size_t s = 0; s < quarters; ++s) spread(s, count, sums_[k].data());
    }

    // Combines the sums over even and odd frequencies at s columns to the rotations s, -s, half - s
    // and half + s, where half is half a circle. At half - s the cosine of frequency f is (-1)^f
    // times the cosine at s, and the sine is -(-1)^f times the sine at s
    // (docs/theory/rotation-match.md).
    void spread(std::size_t s, std::size_t pairs, float* to) const {
        const auto azimuths = static_cast<std::size_t>(m_.grid_.azimuths);
        const float *ce = cosine_sums_[0].data() + s * pairs,
                    *co = cosine_sums_[1].data() + s * pairs;
        const float *se = sine_sums_[0].data() + s * pairs, *so = sine_sums_[1].data() + s * pairs;
        const auto at_rotation = [&](std::size_t columns) {
            return to + columns % azimuths * pairs;
        };
        float *forth = at_rotation(s), *back = at_rotation(azimuths - s);
        float *near_half = at_rotation(azimuths / 2 - s),
              *past_half = at_rotation(azimuths / 2 + s);
        const auto each = [&](float* row, auto value) {
            for (std::size_t i = 0; i < pairs; ++i) row[i] = value(i);
        };
        each(forth, [&](std::size_t i) { return (ce[i] + co[i]) - (se[i] + so[i]); });
        each(back, [&](std::size_t i) { return (ce[i] + co[i]) + (se[i] + so[i]); });
        each(near_half, [&](std::size_t i) { return (ce[i] - co[i]) + (se[i] - so[i]); });
        each(past_half, [&](std::size_t i) { return (ce[i] - co[i]) - (se[i] - so[i]); });
    }

    void choose(std::size_t count, const float* point_sums, RotationMatch* out,
                std::size_t stride) {
        const auto azimuths = static_cast<std::size_t>(m_.grid_.azimuths);
        const std::size_t pairs = count * exemplars_;
        least_.resize(pairs);
        for (std::size_t p = 0; p < count; ++p)
            for (std::size_t e = 0; e < exemplars_; ++e)
                least_[p * exemplars_ + e] = std::min(point_sums[p], exemplar_sums_[e]);
        best_.assign(pairs, 2.0f);
        best_shift_.assign(pairs, 0.0f);
        residual_.resize(pairs);
        for (std::size_t s = 0; s < azimuths; ++s) {
            const float *a = at(kA, s), *o = at(kO, s), *b = at(kB, s), *x = at(kX, s);
            float *r = residual_.data(), *best = best_.data(), *best_shift = best_shift_.data();
            const float* least = least_.data();
            for (std::size_t i = 0; i < pairs; ++i)
                r[i] = residual(a[i], o[i], b[i], x[i], least[i]);
            for (std::size_t i = 0; i < pairs; ++i) {
                const float kept = best_shift[i];
                best_shift[i] = r[i] < best[i] ? static_cast<float>(s) : kept;
            }
            for (std::size_t i = 0; i < pairs; ++i) best[i] = std::min(best[i], r[i]);
        }
        for (std::size_t p = 0; p < count; ++p)
            for (std::size_t e = 0; e < exemplars_; ++e)
                out[p * stride + e] = match_at(
                    static_cast<std::size_t>(best_shift_[p * exemplars_ + e]), p * exemplars_ + e);
    }

    const float* at(std::size_t k, std::size_t shift) const {
        return sums_[k].data() + shift * least_.size();
    }

    // Is the overlap large enough for the rotation to be valid?
    bool counts(float o, float least) const { return o >= m_.least_overlap_ * least; }

    // The residual of one rotation of a pair; `least` is the smaller of the pair's sums of weights.
    float residual(float a, float o, float b, float x, float least) const {
        // Only positive correlations: a negative scale would match the inverse of the shape.
        const float cosine = std::max(x, 0.0f);
        const float left = 1.0f - cosine * cosine / std::max(a * b, 1e-30f);
        return counts(o, least) ? std::max(left, 0.0f) : 1.0f;
    }

    RotationMatch match_at(std::size_t shift, std::size_t i) const {
        const auto azimuths = static_cast<std::size_t>(m_.grid_.azimuths);
        const std::size_t before = (shift + azimuths - 1) % azimuths,
                          after = (shift + 1) % azimuths;
        const auto residual_at = [&](std::size_t s) {
            return residual(at(kA, s)[i], at(kO, s)[i], at(kB, s)[i], at(kX, s)[i], least_[i]);
        };
        RotationMatch match;
        match.residual = best_[i];
        match.shift = best_shift_[i];
        if (counts(at(kO, before)[i], least_[i]) && counts(at(kO, after)[i], least_[i]))
            match.shift += vertex(residual_at(before), best_[i], residual_at(after));
        match.scale = at(kX, shift)[i] / std::max(at(kB, shift)[i], 1e-30f);
        match.overlap = at(kO, shift)[i] / std::max(least_[i], 1e-30f);
        return match;
    }

    const RotationMatcher& m_;
    std::size_t rings_, f_count_, exemplars_ = 0;
    const float *exemplar_spectra_ = nullptr, *exemplar_sums_ = nullptr;
    std::array<std::array<std::vector<float>, 2>, kSums> products_;
    std::array<std::vector<float>, 2> cosine_sums_, sine_sums_;
    std::array<std::vector<float>, kSums> sums_;
    std::vector<float> least_, best_, best_shift_, residual_;
};

void RotationMatcher::match(const MaskedTables& points, const Take& take) const {
    match_range(points, 0, count_, take);
}

// Exemplars are laid out and matched in whole tiles: results before `first` are computed and
// discarded.
void RotationMatcher::match_range(const MaskedTables& points, std::size_t first, std::size_t count,
                                  const Take& take) const {
    const std::size_t begin_tile = first / kExemplarTile;
    const std::size_t end = std::min(first + count, count_);
    // A group of points is matched against a tile of exemplars while the tile is in the cache. With
    // two tiles of points the spectra of a worker stay below 10 MB.
    constexpr std::size_t kGroup = 2 * kPointTile;
    parallel_for(points.count, kGroup, [&](std::size_t group_begin, std::size_t group_end) {
        const std::size_t group = group_end - group_begin;
        const std::size_t width = end - begin_tile * kExemplarTile;
        std::vector<RotationMatch> matches(group * width);
        std::vector<std::vector<float>> spectra((group + kPointTile - 1) / kPointTile);
        std::vector<std::vector<float>> sums(spectra.size());
        for (std::size_t t = 0; t < spectra.size(); ++t) {
            const std::size_t from = group_begin + t * kPointTile;
            spectra_of(points, from, std::min(kPointTile, group_end - from), false, spectra[t],
                       sums[t]);
        }
        Tile tile(*this);
        for (std::size_t e = begin_tile * kExemplarTile; e < end; e += kExemplarTile) {
            const std::size_t exemplars = std::min(kExemplarTile, count_ - e);
            tile.set_exemplars(spectra_.data() + kProducts * block() * e, sums_.data() + e,
                               exemplars);
            const std::size_t wanted = std::min(exemplars, end - e);
            std::vector<RotationMatch> some(kPointTile * exemplars);
            for (std::size_t t = 0; t < spectra.size(); ++t) {
                const std::size_t n = sums[t].size();
                tile.match(spectra[t].data(), sums[t].data(), n, some.data(), exemplars);
                for (std::size_t p = 0; p < n; ++p)
                    std::copy_n(some.data() + p * exemplars, wanted,
                                matches.data() + (t * kPointTile + p) * width +
                                    (e - begin_tile * kExemplarTile));
            }
        }
        const std::size_t skip = first - begin_tile * kExemplarTile;
        for (std::size_t p = 0; p < group; ++p)
            take(group_begin + p, std::span(matches).subspan(p * width + skip, width - skip));
    });
}

}  // namespace burnish
