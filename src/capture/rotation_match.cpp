#include "capture/rotation_match.hpp"

#include <cblas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numbers>

#include "core/parallel.hpp"

namespace burnish {

namespace {

// The three products of a table with its weights that the four sums are made of.
constexpr int kProducts = 3;
constexpr std::size_t kPointTile = 32, kExemplarTile = 32;

// C (m x n) = A (m x k) B (k x n), all row-major and packed. Called from many threads, each product
// on one. A build of OpenBLAS without threads has no locks either and mixes up callers' buffers
// (measured with 0.3.21): there one call at a time.
void multiply(std::size_t m, std::size_t n, std::size_t k, const float* a, const float* b,
              float* c) {
    static const bool unlocked = openblas_get_parallel() == OPENBLAS_SEQUENTIAL;
    static std::mutex one_at_a_time;
    std::unique_lock<std::mutex> lock(one_at_a_time, std::defer_lock);
    if (unlocked) lock.lock();
    cblas_sgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, static_cast<int>(m), static_cast<int>(n),
                static_cast<int>(k), 1.0f, a, static_cast<int>(k), b, static_cast<int>(n), 0.0f, c,
                static_cast<int>(n));
}

// Of a table's cell: point m T^2, m, m T; exemplar n, n C, n C^2. Masked cells may hold anything.
std::array<float, kProducts> products(float value, float weight, bool exemplar) {
    if (weight <= 0.0f) return {0.0f, 0.0f, 0.0f};
    const float first = weight * value, second = first * value;
    return exemplar ? std::array<float, kProducts>{weight, first, second}
                    : std::array<float, kProducts>{second, weight, first};
}

// The lowest point of the parabola through three equidistant values, in steps from the middle one.
float vertex(float before, float at, float after) {
    const float bend = before - 2.0f * at + after;
    if (!(bend > 0.0f)) return 0.0f;
    return std::clamp(0.5f * (before - after) / bend, -0.5f, 0.5f);
}

}  // namespace

RotationMatcher::RotationMatcher(const NdfGrid& grid, float least_overlap)
    : grid_(grid), least_overlap_(least_overlap), frequencies_(grid.azimuths / 2 + 1) {
    openblas_set_num_threads(1);  // tiles are what runs in parallel: results do not depend on it
    const auto azimuths = static_cast<std::size_t>(grid.azimuths);
    const auto f_count = static_cast<std::size_t>(frequencies_);
    for (int r = 0; r < grid.rings; ++r)
        ring_weight_.push_back(
            static_cast<float>(std::cos(static_cast<double>(grid.theta(r))) * grid.solid_angle(r)));
    forward_.resize(azimuths * 2 * f_count);
    even_.resize(f_count * f_count);
    odd_.resize(f_count * f_count);
    const double step = 2.0 * std::numbers::pi / grid.azimuths;
    const auto angle = [&](std::size_t a, std::size_t b) {
        return step * static_cast<double>((a * b) % azimuths);
    };
    for (std::size_t c = 0; c < azimuths; ++c)
        for (std::size_t f = 0; f < f_count; ++f) {
            forward_[c * 2 * f_count + f] = static_cast<float>(std::cos(angle(c, f)));
            forward_[c * 2 * f_count + f_count + f] = static_cast<float>(-std::sin(angle(c, f)));
        }
    for (std::size_t f = 0; f < f_count; ++f) {
        const bool single = f == 0 || 2 * f == azimuths;
        const double share = (single ? 1.0 : 2.0) / static_cast<double>(azimuths);
        for (std::size_t s = 0; s < f_count; ++s) {
            even_[s * f_count + f] = static_cast<float>(share * std::cos(angle(f, s)));
            odd_[s * f_count + f] = static_cast<float>(share * std::sin(angle(f, s)));
        }
    }
}

std::size_t RotationMatcher::block() const {
    return static_cast<std::size_t>(frequencies_) * 2 * static_cast<std::size_t>(grid_.rings);
}

// out[product][frequency][table][re of all rings, im of all rings], for one group of tables.
void RotationMatcher::spectra_of(const MaskedTables& tables, std::size_t first, std::size_t count,
                                 bool exemplar, std::vector<float>& out,
                                 std::vector<float>& sums) const {
    const auto rings = static_cast<std::size_t>(grid_.rings);
    const auto azimuths = static_cast<std::size_t>(grid_.azimuths);
    const auto f_count = static_cast<std::size_t>(frequencies_);
    const std::size_t cells = rings * azimuths;
    out.resize(kProducts * block() * count);
    sums.assign(count, 0.0f);
    std::array<std::vector<float>, kProducts> rows;
    for (auto& row : rows) row.resize(cells);
    std::vector<float> transformed(rings * 2 * f_count);
    for (std::size_t t = 0; t < count; ++t) {
        const float* value = tables.values.data() + (first + t) * cells;
        const float* weight = tables.weights.data() + (first + t) * cells;
        for (std::size_t i = 0; i < cells; ++i) {
            const auto p = products(value[i], weight[i], exemplar);
            // One side of every product carries the ring's weight.
            const float share = exemplar ? 1.0f : ring_weight_[i / azimuths];
            for (std::size_t k = 0; k < kProducts; ++k) rows[k][i] = share * p[k];
            sums[t] += ring_weight_[i / azimuths] * std::max(weight[i], 0.0f);
        }
        for (std::size_t k = 0; k < kProducts; ++k) {
            multiply(rings, 2 * f_count, azimuths, rows[k].data(), forward_.data(),
                     transformed.data());
            for (std::size_t f = 0; f < f_count; ++f) {
                // What the same exemplars' product meets lies side by side: points by frequency
                // first.
                const std::size_t kf = exemplar ? k * f_count + f : f * kProducts + k;
                float* to = out.data() + (kf * count + t) * 2 * rings;
                for (std::size_t r = 0; r < rings; ++r) {
                    to[r] = transformed[r * 2 * f_count + f];
                    to[rings + r] = transformed[r * 2 * f_count + f_count + f];
                }
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

// Points of one tile against exemplars of one tile.
class RotationMatcher::Tile {
  public:
    explicit Tile(const RotationMatcher& matcher)
        : m_(matcher),
          rings_(static_cast<std::size_t>(matcher.grid_.rings)),
          f_count_(static_cast<std::size_t>(matcher.frequencies_)) {}

    // `exemplar`: spectra of a tile of exemplars; its right operands are laid out for the products.
    void set_exemplars(const float* spectra, const float* sums, std::size_t count) {
        exemplars_ = count;
        exemplar_sums_ = sums;
        const std::size_t depth = 2 * rings_;
        right_.resize(kProducts * f_count_ * 2 * depth * count);
        for (std::size_t kf = 0; kf < kProducts * f_count_; ++kf) {
            const float* from = spectra + kf * count * depth;
            float* re = right_.data() + kf * 2 * depth * count;
            float* im = re + depth * count;
            // L conj(R) = (Lre Rre + Lim Rim) + i (Lim Rre - Lre Rim)
            for (std::size_t e = 0; e < count; ++e)
                for (std::size_t r = 0; r < rings_; ++r) {
                    re[r * count + e] = from[e * depth + r];
                    re[(rings_ + r) * count + e] = from[e * depth + rings_ + r];
                    im[r * count + e] = -from[e * depth + rings_ + r];
                    im[(rings_ + r) * count + e] = from[e * depth + r];
                }
        }
    }

    void match(const float* points, const float* sums, std::size_t count, RotationMatch* out,
               std::size_t stride) {
        const std::size_t pairs = count * exemplars_;
        // A and O in one: m T^2 and m, both with n. B: m with n C^2; X: m T with n C.
        correlate(points, count, 0, 2, 0, ao_);
        correlate(points, count, 1, 1, 2, b_);
        correlate(points, count, 2, 1, 1, x_);
        choose(pairs, count, sums, out, stride);
    }

  private:
    // to[shift][pair], pairs of the first of `lefts` products of the points first.
    void correlate(const float* points, std::size_t count, std::size_t left, std::size_t lefts,
                   std::size_t right, std::vector<float>& to) {
        const std::size_t depth = 2 * rings_, rows = lefts * count, pairs = rows * exemplars_;
        re_.resize(f_count_ * pairs);
        im_.resize(f_count_ * pairs);
        for (std::size_t f = 0; f < f_count_; ++f) {
            const float* l = points + (f * kProducts + left) * count * depth;
            const float* r = right_.data() + (right * f_count_ + f) * 2 * depth * exemplars_;
            multiply(rows, exemplars_, depth, l, r, re_.data() + f * pairs);
            multiply(rows, exemplars_, depth, l, r + depth * exemplars_, im_.data() + f * pairs);
        }
        even_.resize(f_count_ * pairs);
        odd_.resize(f_count_ * pairs);
        multiply(f_count_, pairs, f_count_, m_.even_.data(), re_.data(), even_.data());
        multiply(f_count_, pairs, f_count_, m_.odd_.data(), im_.data(), odd_.data());
        const auto azimuths = static_cast<std::size_t>(m_.grid_.azimuths);
        to.resize(azimuths * pairs);
        for (std::size_t s = 0; s < f_count_; ++s) {
            const float* e = even_.data() + s * pairs;
            const float* o = odd_.data() + s * pairs;
            float* forth = to.data() + s * pairs;
            float* back = to.data() + (s == 0 ? 0 : azimuths - s) * pairs;
            for (std::size_t i = 0; i < pairs; ++i) {
                const float sum = e[i] + o[i];
                forth[i] = e[i] - o[i];
                back[i] = sum;
            }
        }
    }

    void choose(std::size_t pairs, std::size_t count, const float* point_sums, RotationMatch* out,
                std::size_t stride) {
        const auto azimuths = static_cast<std::size_t>(m_.grid_.azimuths);
        residual_.resize(azimuths * pairs);
        least_.resize(pairs);
        for (std::size_t p = 0; p < count; ++p)
            for (std::size_t e = 0; e < exemplars_; ++e)
                least_[p * exemplars_ + e] = std::min(point_sums[p], exemplar_sums_[e]);
        best_.assign(pairs, 2.0f);
        best_shift_.assign(pairs, 0.0f);
        for (std::size_t s = 0; s < azimuths; ++s) {
            const float *a = ao_.data() + s * 2 * pairs, *b = b_.data() + s * pairs;
            const float *x = x_.data() + s * pairs, *o = ao_.data() + (2 * s + 1) * pairs;
            float* r = residual_.data() + s * pairs;
            for (std::size_t i = 0; i < pairs; ++i) {
                const float product = a[i] * b[i];
                // A positive correlation only: a negative scale would match the shape's opposite.
                const float cosine = std::max(x[i], 0.0f);
                const float left = 1.0f - cosine * cosine / std::max(product, 1e-30f);
                const bool enough = o[i] >= m_.least_overlap_ * least_[i];
                r[i] = enough ? std::max(left, 0.0f) : 1.0f;
            }
            for (std::size_t i = 0; i < pairs; ++i) {
                const bool better = r[i] < best_[i];
                best_[i] = better ? r[i] : best_[i];
                best_shift_[i] = better ? static_cast<float>(s) : best_shift_[i];
            }
        }
        for (std::size_t p = 0; p < count; ++p)
            for (std::size_t e = 0; e < exemplars_; ++e) {
                const std::size_t i = p * exemplars_ + e;
                const auto s = static_cast<std::size_t>(best_shift_[i]);
                const auto at = [&](std::size_t shift) { return residual_[shift * pairs + i]; };
                RotationMatch& match = out[p * stride + e];
                match.residual = best_[i];
                const std::size_t before = (s + azimuths - 1) % azimuths;
                const std::size_t after = (s + 1) % azimuths;
                const bool both_count = counts(before, i) && counts(after, i);
                match.shift =
                    best_shift_[i] + (both_count ? vertex(at(before), best_[i], at(after)) : 0.0f);
                match.scale = x_[s * pairs + i] / std::max(b_[s * pairs + i], 1e-30f);
                match.overlap = ao_[(2 * s + 1) * pairs + i] / std::max(least_[i], 1e-30f);
            }
    }

    // Is there overlap enough at a turn of `shift` columns?
    bool counts(std::size_t shift, std::size_t pair) const {
        const float overlap = ao_[(2 * shift + 1) * least_.size() + pair];
        return overlap >= m_.least_overlap_ * least_[pair];
    }

    const RotationMatcher& m_;
    std::size_t rings_, f_count_, exemplars_ = 0;
    const float* exemplar_sums_ = nullptr;
    std::vector<float> right_, re_, im_, even_, odd_, ao_, x_, b_, residual_;
    std::vector<float> least_, best_, best_shift_;
};

void RotationMatcher::match(const MaskedTables& points, const Take& take) const {
    match_range(points, 0, count_, take);
}

// Exemplars are laid out in tiles; `first` must begin one, as callers' ranges do.
void RotationMatcher::match_range(const MaskedTables& points, std::size_t first, std::size_t count,
                                  const Take& take) const {
    const std::size_t begin_tile = first / kExemplarTile;
    const std::size_t end = std::min(first + count, count_);
    // Groups of points share the exemplars' layout; 8 tiles of them keep spectra within 10 MB.
    constexpr std::size_t kGroup = 8 * kPointTile;
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

std::vector<RotationMatcher::Turn> RotationMatcher::turns_directly(
    const float* point, const float* point_weights, const float* exemplar,
    const float* exemplar_weights) const {
    const int azimuths = grid_.azimuths;
    double point_sum = 0.0, exemplar_sum = 0.0;
    for (int i = 0; i < grid_.cells(); ++i) {
        const double w = static_cast<double>(ring_weight_[static_cast<std::size_t>(i / azimuths)]);
        point_sum += w * static_cast<double>(point_weights[i]);
        exemplar_sum += w * static_cast<double>(exemplar_weights[i]);
    }
    const double smaller = std::min(point_sum, exemplar_sum);
    std::vector<Turn> out;
    for (int s = 0; s < azimuths; ++s) {
        double a = 0.0, b = 0.0, x = 0.0, o = 0.0;
        for (int r = 0; r < grid_.rings; ++r)
            for (int c = 0; c < azimuths; ++c) {
                const int at = r * azimuths + c,
                          from = r * azimuths + (c - s + azimuths) % azimuths;
                const double w = static_cast<double>(ring_weight_[static_cast<std::size_t>(r)]) *
                                 static_cast<double>(point_weights[at]) *
                                 static_cast<double>(exemplar_weights[from]);
                if (w <= 0.0) continue;
                const auto t = static_cast<double>(point[at]),
                           u = static_cast<double>(exemplar[from]);
                a += w * t * t;
                b += w * u * u;
                x += w * t * u;
                o += w;
            }
        Turn turn;
        if (o >= static_cast<double>(least_overlap_) * smaller)
            turn.residual =
                std::max(1.0 - std::pow(std::max(x, 0.0), 2) / std::max(a * b, 1e-30), 0.0);
        turn.scale = x / std::max(b, 1e-30);
        turn.overlap = o / std::max(smaller, 1e-30);
        out.push_back(turn);
    }
    return out;
}

std::vector<double> RotationMatcher::residuals_directly(const float* point,
                                                        const float* point_weights,
                                                        const float* exemplar,
                                                        const float* exemplar_weights) const {
    std::vector<double> out;
    for (const Turn& turn : turns_directly(point, point_weights, exemplar, exemplar_weights))
        out.push_back(turn.residual);
    return out;
}

RotationMatch RotationMatcher::match_directly(const float* point, const float* point_weights,
                                              const float* exemplar,
                                              const float* exemplar_weights) const {
    const std::vector<Turn> all = turns_directly(point, point_weights, exemplar, exemplar_weights);
    const auto best = std::min_element(all.begin(), all.end(), [](const Turn& a, const Turn& b) {
        return a.residual < b.residual;
    });
    RotationMatch match;
    match.residual = static_cast<float>(best->residual);
    match.shift = static_cast<float>(best - all.begin());
    match.scale = static_cast<float>(best->scale);
    match.overlap = static_cast<float>(best->overlap);
    return match;
}

}  // namespace burnish
