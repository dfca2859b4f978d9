#include "maps/scratch/scratch_strokes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/constants.hpp"
#include "core/parallel.hpp"
#include "maps/scratch/scratch_field.hpp"

namespace burnish {

namespace {

constexpr std::size_t kGrain = 512;

// Random numbers of one scratch, from a counter with a key per scratch, so that any thread may make
// any scratch. The mixing function is SplitMix64's (Steele, Lea, Flood 2014).
class StrokeRandom {
  public:
    StrokeRandom(std::uint32_t seed, std::size_t layer, std::size_t index)
        : state_(mixed((std::uint64_t{seed} << 32) ^ mixed(layer + 1)) ^ mixed(index)) {}

    double unit() {  // [0, 1)
        state_ += 0x9e3779b97f4a7c15u;
        return static_cast<double>(mixed(state_) >> 11) * 0x1p-53;
    }

  private:
    static std::uint64_t mixed(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    std::uint64_t state_;
};

class LayerStrokes {
  public:
    LayerStrokes(const ScratchSettings& settings, std::size_t layer, const ScratchInputs& inputs)
        : settings_(settings),
          layer_(settings.layers[layer]),
          number_(layer),
          mask_(inputs.wear_mask),
          field_(layer_, inputs),
          count_(static_cast<std::size_t>(scratch_count(settings, layer_))) {}

    std::size_t count() const { return count_; }

    // One stroke of the layer; nothing where the mask shows no wear.
    std::optional<Stroke> stroke(std::size_t index) const {
        StrokeRandom random(settings_.seed, number_, index);
        const TilePoint at = place(random, index);
        const double level = random.unit();
        Stroke stroke = shape(random, at);
        if (!mask_.empty() || field_.full_face()) {
            if (!stays(at, level)) return std::nullopt;
            if (!mask_.empty() || !is_within_tile(stroke)) trim(stroke, level);
        }
        return stroke;
    }

  private:
    TilePoint place(StrokeRandom& random, std::size_t index) const {
        TilePoint at{random.unit(), random.unit()};
        if (layer_.placement != ScratchPlacement::even) return at;
        const double angle = layer_.angle_deg * kDegree;
        const bool upright = std::abs(std::sin(angle)) > std::abs(std::cos(angle));
        double& across = upright ? at.x : at.y;
        double& along = upright ? at.y : at.x;
        // Jitter of an even feed: a third of the spacing across, and 1/50 of a pass along.
        constexpr double kLoose = 1.0 / 3.0, kLooseEnds = 1.0 / 50.0;
        const auto passes = static_cast<std::size_t>(std::max(layer_.passes, 1.0));
        const std::size_t pass = index % passes, row = index / passes;
        // The rows of this pass only, so that its feed repeats at the edge of the tile.
        const std::size_t rows = (count_ + passes - 1 - pass) / passes;
        across =
            (static_cast<double>(row) + 0.5 + kLoose * (across - 0.5)) / static_cast<double>(rows);
        if (layer_.passes > 0.0)
            along = (static_cast<double>(pass) + 0.5 + kLooseEnds * (along - 0.5)) /
                    static_cast<double>(passes);
        return at;
    }

    Stroke shape(StrokeRandom& random, TilePoint at) const {
        const auto draw = [&](const Spread& spread) {
            const double u1 = random.unit(), u2 = random.unit();
            return spread.sample(u1, u2);
        };
        Stroke stroke;
        stroke.x = at.x * settings_.tile_mm;
        stroke.y = at.y * settings_.tile_mm;
        stroke.half_length = 0.5 * draw(layer_.length_mm);
        stroke.half_width = 0.5 * draw(layer_.width_mm);
        // The distributions of depth and width may overlap even if their typical values do not. The
        // depth is at most that of a hemisphere.
        stroke.depth = std::min(draw(layer_.depth_mm), stroke.half_width);
        const double side = random.unit() < 0.5 ? 1.0 : -1.0;
        const bool alike = layer_.curvature_per_mm.shape == Spread::Shape::constant;
        stroke.curvature = (alike ? 1.0 : side) * draw(layer_.curvature_per_mm);
        const double turn = 2.0 * random.unit() - 1.0;
        if (const DoubleAngle line = field_.at(at)) {
            stroke.angle = line.angle() + turn * layer_.range_deg * kDegree;
            stroke.curvature += field_.curvature_at(at) / settings_.tile_mm;
        } else {
            stroke.angle = 0.5 * kPi * turn;
        }
        limit_turn(stroke);
        return stroke;
    }

    // Limits an arc to one turn, and its curvature to a positive radius of the inner edge.
    void limit_turn(Stroke& stroke) const {
        const double sharpest = 1.0 / stroke.half_width;
        stroke.curvature = std::clamp(stroke.curvature, -sharpest, sharpest);
        // 0.98: the ends stay apart, so that every point of the arc has a unique arc length.
        if (stroke.curvature != 0.0)
            stroke.half_length =
                std::min(stroke.half_length, 0.98 * kPi / std::abs(stroke.curvature));
    }

    bool stays(TilePoint p, double level) const {
        if (field_.full_face() && (p.x < 0.0 || p.x > 1.0 || p.y < 0.0 || p.y > 1.0)) return false;
        return mask_.empty() || sample_tile(mask_, 0, p) > level;
    }

    // No point of the stroke is further from its middle than half its length: trim() would leave it.
    bool is_within_tile(const Stroke& stroke) const {
        const double low = stroke.half_length, high = settings_.tile_mm - stroke.half_length;
        return std::min(stroke.x, stroke.y) > low && std::max(stroke.x, stroke.y) < high;
    }

    // Length of the stroke from its middle in the direction `sign`, up to the edge of the mask.
    double reach(const Stroke& stroke, double sign, double level) const {
        // The step is at most the half width of the scratch at the edge of a mask, except for very
        // long scratches.
        const int steps =
            static_cast<int>(std::clamp(stroke.half_length / stroke.half_width, 8.0, 256.0));
        for (int i = 1; i <= steps; ++i) {
            const StrokePoint p = point_on(stroke, sign * stroke.half_length * i / steps);
            if (!stays({p.x / settings_.tile_mm, p.y / settings_.tile_mm}, level))
                return stroke.half_length * (i - 1) / steps;
        }
        return stroke.half_length;
    }

    void trim(Stroke& stroke, double level) const {
        const double ahead = reach(stroke, 1.0, level), behind = reach(stroke, -1.0, level);
        const double shift = 0.5 * (ahead - behind);
        const StrokePoint middle = point_on(stroke, shift);
        stroke.x = middle.x;
        stroke.y = middle.y;
        stroke.angle += shift * stroke.curvature;
        stroke.half_length = 0.5 * (ahead + behind);
    }

    const ScratchSettings& settings_;
    const ScratchLayer& layer_;
    std::size_t number_;
    const Image& mask_;
    GrainField field_;
    std::size_t count_;
};

}  // namespace

StrokePoint point_on(const Stroke& stroke, double s) {
    // The chord from the middle to s has the length 2 sin(ks/2)/k. Its direction bisects the
    // tangents at its ends.
    const double half_turn = 0.5 * stroke.curvature * s;
    // The series of sin(x)/x below 1e-4, where the next term is below 1e-17.
    const double ratio = std::abs(half_turn) < 1e-4 ? 1.0 - half_turn * half_turn / 6.0
                                                    : std::sin(half_turn) / half_turn;
    const double angle = stroke.angle + half_turn;
    return {stroke.x + s * ratio * std::cos(angle), stroke.y - s * ratio * std::sin(angle)};
}

std::vector<Stroke> make_strokes(const ScratchSettings& settings, std::size_t layer,
                                 const ScratchInputs& inputs) {
    const LayerStrokes source(settings, layer, inputs);
    std::vector<std::vector<Stroke>> parts((source.count() + kGrain - 1) / kGrain);
    parallel_for(source.count(), kGrain, [&](std::size_t begin, std::size_t end) {
        std::vector<Stroke>& part = parts[begin / kGrain];
        for (std::size_t i = begin; i < end; ++i) {
            const std::optional<Stroke> stroke = source.stroke(i);
            if (stroke && stroke->half_length > 0.0) part.push_back(*stroke);
        }
    });
    std::vector<Stroke> all;
    all.reserve(source.count());
    for (const std::vector<Stroke>& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

std::vector<std::vector<Stroke>> strokes_of_layers(const ScratchSettings& settings,
                                                   const ScratchInputs& inputs) {
    std::vector<std::vector<Stroke>> layers;
    for (std::size_t i = 0; i < settings.layers.size(); ++i)
        layers.push_back(make_strokes(settings, i, inputs));
    return layers;
}

}  // namespace burnish
