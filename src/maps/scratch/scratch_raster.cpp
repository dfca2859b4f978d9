#include "maps/scratch/scratch_raster.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/parallel.hpp"

namespace burnish {

namespace {

// Least half width of a stroke in texels. A narrower stroke would fall between texels. It is drawn
// this wide and proportionally shallower, which keeps its cross-section area: the average of a
// finer map.
constexpr double kLeastHalfWidth = 1.25;

// Texels. An arc with a smaller sagitta is drawn as a straight line.
constexpr double kFlat = 0.01;

// The burr: a groove of 3/5 of the half width with lips on both sides. A lip s (1-s)^2, s the
// fraction across it, starts with the slope of the groove's edge and ends flat; its height is 1/5
// of the depth.
constexpr float kGrooveShare = 0.6f;
constexpr float kLipScale = (2.0f / kGrooveShare) * (1.0f - kGrooveShare);

float larger(float a, float b) {
    return a > b ? a : b;
}

float smaller(float a, float b) {
    return a < b ? a : b;
}

// condition ? a : b by bits. GCC 12 vectorizes the loop of draw_span with three of these, but not
// with three conditional expressions.
float blend(bool condition, float a, float b) {
    const std::uint32_t mask = condition ? ~std::uint32_t{0} : std::uint32_t{0};
    return std::bit_cast<float>((std::bit_cast<std::uint32_t>(a) & mask) |
                                (std::bit_cast<std::uint32_t>(b) & ~mask));
}

// The stroke relative to a block, in float: positions within a block keep their precision.
struct Pen {
    float mx, my, tx, ty, nx, ny, k, inverse_k, inverse_width, inverse_taper, taper_begin, depth;
    float a, b, c;
};

// Depth at v >= 0 half widths from the middle, as a fraction of the depth; negative on a lip. The
// section is the profile at q = v / e, times e. Roots and quotients are those of the profile times
// e, so that the round profile needs a single division. e2 = e^2.
template <ScratchProfile profile>
float section_depth(float v, float e2, const Pen& p) {
    if constexpr (profile == ScratchProfile::round) {
        const float v2 = smaller(v * v, e2);
        // 1e-24, for e2 >= 1e-12: avoids 0 / 0 at the rim of a hemisphere, which is vertical.
        const float root = std::sqrt(larger(p.a * e2 - p.b * v2, 1e-24f));
        return p.b * (e2 - v2) / (root + p.c * std::sqrt(e2));
    } else if constexpr (profile == ScratchProfile::v) {
        const float e = std::sqrt(e2);
        return e - smaller(v, e);
    } else {
        const float e = std::sqrt(e2);
        const float q = smaller(v / e, 1.0f);
        const float u = q * (1.0f / kGrooveShare);
        const float s = (q - kGrooveShare) * (1.0f / (1.0f - kGrooveShare));
        const float floor = 1.0f - u * u, lip = -kLipScale * s * (1.0f - s) * (1.0f - s);
        return e * (q < kGrooveShare ? floor : lip);
    }
}

// The shape of a stroke, which is the same for all its texels and selects the loop.
enum class Run {
    straight,
    arc,  // within kArcTurn of its middle
    ring  // any part of a circle
};

// Tangent of the largest angle from the middle for which the series of atan ends at t^11: the next
// term is below 1e-7 of it.
constexpr float kArcTurn = 0.3f;

float series_atan(float t) {
    const float t2 = t * t;
    return t * (1.0f - t2 * (1.0f / 3.0f -
                             t2 * (1.0f / 5.0f -
                                   t2 * (1.0f / 7.0f - t2 * (1.0f / 9.0f - t2 * (1.0f / 11.0f))))));
}

struct Span {
    int begin, end;
};

// Uses only arithmetic, on whole registers of texels, so that compilers vectorize it. Beyond the
// span's end the height is 0, which leaves the next row unchanged.
template <ScratchProfile profile, Run run>
void draw_span(const Pen& pen, Span span, int y, BlockBuffers& block) {
    const Pen p = pen;
    const int count = span.end - span.begin;
    const int padded = count > 0 ? (count + kSpanPadding - 1) / kSpanPadding * kSpanPadding : 0;
    const float begin = static_cast<float>(span.begin) + 0.5f - p.mx;
    const float dy = static_cast<float>(y) + 0.5f - p.my;
    const std::size_t row = block.at(span.begin, y);
    float* __restrict groove = block.groove.data() + row;
    float* __restrict lip = block.lip.data() + row;
    float* __restrict score = block.score.data() + row;
    float* __restrict line_x = block.line_x.data() + row;
    float* __restrict line_y = block.line_y.data() + row;
    for (int i = 0; i < padded; ++i) {
        const float dx = static_cast<float>(i) + begin;
        const float dt = dx * p.tx + dy * p.ty, dn = dx * p.nx + dy * p.ny;
        float v = dn, s = dt, lx = p.nx, ly = p.ny;
        if constexpr (run != Run::straight) {
            // In the polar coordinates of the arc's center: v to the left of the arc, s along it.
            const float along = p.k * dt, ahead = 1.0f - p.k * dn;
            const float squared = ahead * ahead + along * along;
            v = (2.0f * dn - p.k * (dx * dx + dy * dy)) / (1.0f + std::sqrt(squared));
            lx = p.nx - p.k * dx;
            ly = p.ny - p.k * dy;
            if constexpr (run == Run::arc) {
                // Clamps texels at larger angles, also those behind the center, beyond the stroke's
                // end. 1e-30: avoids 0 / 0 at the center.
                const float least = std::abs(along) * (1.0f / kArcTurn) + 1e-30f;
                s = series_atan(along / larger(ahead, least)) * p.inverse_k;
            } else {
                s = std::atan2(along, ahead) * p.inverse_k;
            }
        }
        // Width and depth shrink together along the taper, as the section of an ellipsoid does.
        // 1e-12: avoids 0 / 0 at the tip, where v is far outside the section.
        const float over = larger(std::abs(s) - p.taper_begin, 0.0f) * p.inverse_taper;
        const float e2 = larger(1.0f - over * over, 1e-12f);
        const float drawn = -p.depth * section_depth<profile>(std::abs(v) * p.inverse_width, e2, p);
        const float h = i < count ? drawn : 0.0f;
        groove[i] = smaller(groove[i], h);
        if constexpr (profile == ScratchProfile::burr) lip[i] = larger(lip[i], h);
        const bool deeper = std::abs(h) > score[i];
        score[i] = blend(deeper, std::abs(h), score[i]);
        line_x[i] = blend(deeper, lx, line_x[i]);
        line_y[i] = blend(deeper, ly, line_y[i]);
    }
}

// The intersection of the row at dy from the middle with the band |v| <= half width, as up to two
// intervals of dx.
int band_intervals(const TexelStroke& stroke, double dy, double (&intervals)[2][2]) {
    const double w = stroke.half_width;
    if (stroke.k == 0.0) {
        // A stroke along the row gives an unbounded interval. A slope of 1e-9 is below 1e-4 texels
        // over a width of 16384.
        if (std::abs(stroke.nx) < 1e-9) {
            if (std::abs(dy * stroke.ny) > w) return 0;
            intervals[0][0] = -1e9;
            intervals[0][1] = 1e9;
            return 1;
        }
        const double middle = -dy * stroke.ny / stroke.nx, reach = w / std::abs(stroke.nx);
        intervals[0][0] = middle - reach;
        intervals[0][1] = middle + reach;
        return 1;
    }
    const double radius = 1.0 / std::abs(stroke.k);
    const double cx = stroke.nx / stroke.k, away = std::abs(dy - stroke.ny / stroke.k);
    const double outer = radius + w, inner = std::max(radius - w, 0.0);
    if (away >= outer) return 0;
    // Products of sum and difference instead of differences of squares, which cancel when radius
    // and distance are large and nearly equal.
    const double far = std::sqrt((outer - away) * (outer + away));
    const double near = away < inner ? std::sqrt((inner - away) * (inner + away)) : 0.0;
    intervals[0][0] = cx - far;
    intervals[0][1] = near > 0.0 ? cx - near : cx + far;
    if (near == 0.0) return 1;
    intervals[1][0] = cx + near;
    intervals[1][1] = cx + far;
    return 2;
}

template <ScratchProfile profile, Run run>
void draw_run(const TexelStroke& stroke, double x, double y, BlockBuffers& block) {
    const auto f = [](double value) { return static_cast<float>(value); };
    const double taper = stroke.half_length - stroke.taper_begin;
    const Pen pen{f(x),
                  f(y),
                  f(stroke.tx),
                  f(stroke.ty),
                  f(stroke.nx),
                  f(stroke.ny),
                  f(stroke.k),
                  f(stroke.k == 0.0 ? 0.0 : 1.0 / stroke.k),
                  f(1.0 / stroke.half_width),
                  f(1.0 / taper),
                  f(stroke.taper_begin),
                  f(stroke.depth),
                  f(stroke.cap_a),
                  f(stroke.cap_b),
                  f(stroke.cap_c)};
    const int low_y = std::max(0, static_cast<int>(std::floor(y + stroke.low_y)));
    const int high_y = std::min(block.height, static_cast<int>(std::ceil(y + stroke.high_y)) + 1);
    const double low_x = x + static_cast<double>(stroke.low_x);
    const double high_x = x + static_cast<double>(stroke.high_x);
    for (int row = low_y; row < high_y; ++row) {
        double intervals[2][2];
        const int count = band_intervals(stroke, row + 0.5 - y, intervals);
        for (int i = 0; i < count; ++i) {
            const double from = std::max({x + intervals[i][0], low_x, 0.0});
            const double to = std::min({x + intervals[i][1], high_x, block.width - 0.5});
            const Span span{std::max(0, static_cast<int>(std::ceil(from - 0.5))),
                            std::min(block.width, static_cast<int>(std::floor(to - 0.5)) + 1)};
            draw_span<profile, run>(pen, span, row, block);
        }
    }
}

template <ScratchProfile profile>
void draw(const TexelStroke& stroke, double x, double y, BlockBuffers& block) {
    if (stroke.k == 0.0) return draw_run<profile, Run::straight>(stroke, x, y, block);
    // 1.02: the series must be valid slightly beyond the end, where the taper reaches 0.
    const double turn = 1.02 * std::tan(std::min(stroke.half_length * std::abs(stroke.k), 1.5));
    if (turn < static_cast<double>(kArcTurn))
        return draw_run<profile, Run::arc>(stroke, x, y, block);
    draw_run<profile, Run::ring>(stroke, x, y, block);
}

// Number of steps along a stroke; each is short enough to lie within one block and its neighbors.
int step_count(const TexelStroke& stroke) {
    const double by_length = 2.0 * stroke.half_length / (0.5 * kBlock);
    const double by_turn = 2.0 * stroke.half_length * std::abs(stroke.k) / 0.4;
    return 1 + static_cast<int>(std::ceil(std::max(by_length, by_turn)));
}

StrokePoint offset_at(const TexelStroke& stroke, double s) {
    if (stroke.k == 0.0) return {s * stroke.tx, s * stroke.ty};
    const double angle = stroke.k * s;
    const double along = std::sin(angle) / stroke.k;
    const double half = std::sin(0.5 * angle);
    const double across = 2.0 * half * half / stroke.k;
    return {along * stroke.tx + across * stroke.nx, along * stroke.ty + across * stroke.ny};
}

// Calls visit(low_x, high_x, low_y, high_y) for boxes around the steps, relative to the middle.
template <typename Visit>
void for_each_box(const TexelStroke& stroke, const Visit& visit) {
    const int steps = step_count(stroke);
    const double length = 2.0 * stroke.half_length / steps;
    // The sagitta of an arc over its chord is k l^2 / 8; twice that is a safe margin.
    const double margin = stroke.half_width + 0.25 * std::abs(stroke.k) * length * length + 1.0;
    StrokePoint from = offset_at(stroke, -stroke.half_length);
    for (int i = 1; i <= steps; ++i) {
        const StrokePoint to = offset_at(stroke, -stroke.half_length + i * length);
        visit(std::min(from.x, to.x) - margin, std::max(from.x, to.x) + margin,
              std::min(from.y, to.y) - margin, std::max(from.y, to.y) + margin);
        from = to;
    }
}

// Finds every block that a stroke touches, each once, with its offset in tiles.
class BlockFinder {
  public:
    explicit BlockFinder(int size) : size_(size), blocks_((size + kBlock - 1) / kBlock) {}

    template <typename Found>
    void find(const TexelStroke& stroke, const Found& found) {
        touched_.clear();
        for_each_box(stroke, [&](double low_x, double high_x, double low_y, double high_y) {
            const std::int64_t x0 = block_of(stroke.mx + low_x), x1 = block_of(stroke.mx + high_x);
            const std::int64_t y0 = block_of(stroke.my + low_y), y1 = block_of(stroke.my + high_y);
            for (std::int64_t y = y0; y <= y1; ++y)
                for (std::int64_t x = x0; x <= x1; ++x) touched_.push_back({x, y});
        });
        std::sort(touched_.begin(), touched_.end());
        touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
        for (const auto& [x, y] : touched_) {
            const std::int64_t tile_x = floor_div(x), tile_y = floor_div(y);
            const std::int64_t block = (y - tile_y * blocks_) * blocks_ + x - tile_x * blocks_;
            found(static_cast<std::size_t>(block), static_cast<std::int16_t>(-tile_x),
                  static_cast<std::int16_t>(-tile_y));
        }
    }

  private:
    std::int64_t floor_div(std::int64_t block) const {
        return block >= 0 ? block / blocks_ : -((blocks_ - 1 - block) / blocks_);
    }
    // Blocks are numbered continuously over repeated tiles; the last block of a tile may be
    // narrower.
    std::int64_t block_of(double texel) const {
        const auto tile = static_cast<std::int64_t>(std::floor(texel / static_cast<double>(size_)));
        const auto inside = static_cast<std::int64_t>(texel - static_cast<double>(tile * size_));
        return tile * blocks_ + std::clamp<std::int64_t>(inside, 0, size_ - 1) / kBlock;
    }

    std::int64_t size_, blocks_;
    std::vector<std::pair<std::int64_t, std::int64_t>> touched_;
};

}  // namespace

TexelStroke texel_stroke(const Stroke& stroke, double taper, double texel_mm) {
    TexelStroke out{};
    out.mx = stroke.x / texel_mm;
    out.my = stroke.y / texel_mm;
    out.tx = std::cos(stroke.angle);
    out.ty = -std::sin(stroke.angle);
    out.nx = out.ty;
    out.ny = -out.tx;
    out.half_length = stroke.half_length / texel_mm;
    out.half_width = stroke.half_width / texel_mm;
    const double sagitta =
        0.5 * std::abs(stroke.curvature) * texel_mm * out.half_length * out.half_length;
    out.k = sagitta < kFlat ? 0.0 : stroke.curvature * texel_mm;
    // A spherical cap of half width w and depth d has radius (w^2 + d^2) / 2d; here in units of d.
    // 1e-3: a flatter cap equals a parabola in float, and its radius would lose precision.
    const double flatness = std::max(stroke.depth / stroke.half_width, 1e-3);
    const double w2 = 1.0 / (flatness * flatness);
    const double radius = 0.5 * (w2 + 1.0);
    out.cap_a = radius * radius;
    out.cap_b = w2;
    out.cap_c = radius - 1.0;
    out.depth = stroke.depth;
    if (out.half_width < kLeastHalfWidth) {
        out.depth *= out.half_width / kLeastHalfWidth;
        out.half_width = kLeastHalfWidth;
    }
    out.half_length = std::max(out.half_length, out.half_width);
    out.taper_begin = out.half_length * (1.0 - taper);
    double low_x = 0, high_x = 0, low_y = 0, high_y = 0;
    for_each_box(out, [&](double x0, double x1, double y0, double y1) {
        low_x = std::min(low_x, x0);
        high_x = std::max(high_x, x1);
        low_y = std::min(low_y, y0);
        high_y = std::max(high_y, y1);
    });
    out.low_x = static_cast<float>(low_x);
    out.high_x = static_cast<float>(high_x);
    out.low_y = static_cast<float>(low_y);
    out.high_y = static_cast<float>(high_y);
    return out;
}

std::vector<TexelStroke> texel_strokes(const std::vector<Stroke>& strokes, double taper,
                                       double texel_mm) {
    std::vector<TexelStroke> drawn(strokes.size());
    parallel_for(strokes.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            drawn[i] = texel_stroke(strokes[i], taper, texel_mm);
    });
    return drawn;
}

StrokeBins::StrokeBins(const std::vector<TexelStroke>& strokes, int size) {
    const auto side = static_cast<std::size_t>((size + kBlock - 1) / kBlock);
    first_.assign(side * side + 1, 0);
    BlockFinder finder(size);
    for (const TexelStroke& stroke : strokes)
        finder.find(stroke,
                    [&](std::size_t block, std::int16_t, std::int16_t) { ++first_[block + 1]; });
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    uses_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < strokes.size(); ++i)
        finder.find(strokes[i], [&](std::size_t block, std::int16_t x, std::int16_t y) {
            uses_[next[block]++] = {static_cast<std::uint32_t>(i), x, y};
        });
}

void BlockBuffers::move_to(int x0_, int y0_, int width_, int height_) {
    x0 = x0_;
    y0 = y0_;
    width = width_;
    height = height_;
    const std::size_t texels = at(0, height_) + kSpanPadding;
    for (std::vector<float>* buffer : {&groove, &lip, &score, &line_x, &line_y})
        buffer->assign(texels, 0.0f);
}

void BlockBuffers::clear_layer() {
    std::fill(groove.begin(), groove.end(), 0.0f);
    std::fill(lip.begin(), lip.end(), 0.0f);
}

void draw_stroke(const TexelStroke& stroke, ScratchProfile profile, double move_x, double move_y,
                 BlockBuffers& block) {
    const double x = stroke.mx + move_x - block.x0, y = stroke.my + move_y - block.y0;
    switch (profile) {
        case ScratchProfile::round:
            return draw<ScratchProfile::round>(stroke, x, y, block);
        case ScratchProfile::v:
            return draw<ScratchProfile::v>(stroke, x, y, block);
        case ScratchProfile::burr:
            return draw<ScratchProfile::burr>(stroke, x, y, block);
    }
}

}  // namespace burnish
