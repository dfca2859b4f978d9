#include "plot/curves_together.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace burnish::plot {
namespace {

// A set of curves, a bit each.
using Curves = std::uint64_t;
constexpr std::size_t kMostCurves = 64;

// Distance between points along a curve, px: under half a stroke, so that none is stepped over.
constexpr double kStep = 0.75;
// Curves closer than this, px, cover each other: strokes are 1.5 to 2.4 px wide.
constexpr double kNear = 1.0;
constexpr double kDash = 7;
// A shorter common stretch, px, is a crossing: both colors are seen before and behind it.
constexpr double kCrossing = 28;

std::vector<Point> with_points_between(std::span<const Point> piece) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < piece.size(); ++i) {
        if (i > 0) {
            const Point a = piece[i - 1], b = piece[i];
            const double length = std::hypot(b.x - a.x, b.y - a.y);
            // 4096: points outside the plot may be thousands of px away.
            const int parts = static_cast<int>(std::min(std::ceil(length / kStep), 4096.0));
            for (int k = 1; k < parts; ++k)
                points.push_back({a.x + (b.x - a.x) * k / parts, a.y + (b.y - a.y) * k / parts});
        }
        points.push_back(piece[i]);
    }
    return points;
}

// Points of all curves in cells as wide as kNear.
class Places {
  public:
    void add(std::size_t curve, Point p) {
        auto& cell = cells_[key(column(p.x), column(p.y))];
        const auto same = [&](const Entry& e) {
            // A quarter of kNear: denser points tell nothing more.
            return e.curve == curve && std::hypot(e.at.x - p.x, e.at.y - p.y) < kNear / 4;
        };
        if (std::none_of(cell.begin(), cell.end(), same)) cell.push_back({curve, p});
    }
    Curves near(Point p) const {
        Curves found = 0;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const auto cell = cells_.find(key(column(p.x) + dx, column(p.y) + dy));
                if (cell == cells_.end()) continue;
                for (const Entry& e : cell->second)
                    if (std::hypot(e.at.x - p.x, e.at.y - p.y) <= kNear)
                        found |= Curves{1} << e.curve;
            }
        return found;
    }

  private:
    struct Entry {
        std::size_t curve;
        Point at;
    };
    static int column(double v) { return static_cast<int>(std::floor(v / kNear)); }
    static std::uint64_t key(int x, int y) {
        return static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32 |
               static_cast<std::uint32_t>(y);
    }
    std::unordered_map<std::uint64_t, std::vector<Entry>> cells_;
};

// A stretch of a piece along which the same curves lie together: points first to last.
struct Stretch {
    std::size_t first, last;
    Curves together;
};

double length_of(std::span<const Point> points, const Stretch& s) {
    double length = 0;
    for (std::size_t i = s.first + 1; i <= s.last; ++i)
        length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    return length;
}

// Crossings go to the stretch before them.
std::vector<Stretch> stretches_of(std::span<const Point> points, std::span<const Curves> sets,
                                  Curves alone) {
    std::vector<Stretch> all;
    for (std::size_t begin = 0; begin + 1 < points.size();) {
        std::size_t end = begin + 1;
        while (end + 1 < points.size() && sets[end] == sets[begin]) ++end;
        Stretch next{begin, end, sets[begin]};
        if (next.together != alone && length_of(points, next) < kCrossing)
            next.together = all.empty() ? alone : all.back().together;
        if (!all.empty() && all.back().together == next.together) {
            all.back().last = next.last;
        } else {
            all.push_back(next);
        }
        begin = end;
    }
    return all;
}

// The first of the curves is drawn whole and the others over it, each in its own share of the
// dashes.
Stroke stroke_within(Stroke stroke, Curves together, std::size_t curve) {
    const int count = std::popcount(together);
    const int before = std::popcount(together & ((Curves{1} << curve) - 1));
    if (count < 2 || before == 0) return stroke;
    stroke.dash = {kDash, kDash * (count - 1)};
    stroke.dash_start = kDash * (count - before);
    return stroke;
}

}  // namespace

void draw_curves(Canvas& canvas, std::span<const DrawnCurve> curves,
                 const std::function<bool(Point)>& counts) {
    Places places;
    const std::size_t compared = std::min(curves.size(), kMostCurves);
    for (std::size_t c = 0; c < compared; ++c)
        for (const auto& piece : curves[c].pieces)
            for (const Point& p : with_points_between(piece))
                if (counts(p)) places.add(c, p);
    for (std::size_t c = 0; c < curves.size(); ++c) {
        for (const auto& piece : curves[c].pieces) {
            if (c >= compared) {
                canvas.polyline(piece, curves[c].stroke);
                continue;
            }
            const Curves alone = Curves{1} << c;
            const std::vector<Point> points = with_points_between(piece);
            std::vector<Curves> sets;
            for (const Point& p : points)
                sets.push_back(counts(p) ? places.near(p) | alone : alone);
            const std::vector<Stretch> stretches = stretches_of(points, sets, alone);
            // A curve that lies alone keeps the points that it has.
            if (stretches.size() < 2 && (stretches.empty() || stretches[0].together == alone)) {
                canvas.polyline(piece, curves[c].stroke);
                continue;
            }
            for (const Stretch& s : stretches)
                canvas.polyline(std::span(points).subspan(s.first, s.last - s.first + 1),
                                stroke_within(curves[c].stroke, s.together, c));
        }
    }
}

}  // namespace burnish::plot
