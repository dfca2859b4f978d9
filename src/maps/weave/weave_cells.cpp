#include "maps/weave/weave_cells.hpp"

namespace burnish {
namespace {

int wrapped(int i, int count) {
    const int r = i % count;
    return r < 0 ? r + count : r;
}

bool up(const Draft& draft, int end, int pick) {
    return draft.is_warp_up(wrapped(end, draft.ends), wrapped(pick, draft.picks));
}

// Mirrored pieces of a yarn seen from above: within +-half_width across, [low, high] and [-high,
// -low] along, from the middle of the cell.
struct Piece {
    double weight;
    float side;
    bool bends;
    float low, high;
};

void add_slopes(const Piece& piece, const f32::WeaveShape& shape, int steps_across, int steps_along,
                std::vector<WeaveSlope>& slopes) {
    if (!(piece.weight > 0)) return;
    const float half_width = 0.5f * (1.0f - shape.gap);
    // Without bends the slope is constant along the yarn.
    const int along_steps = piece.bends ? steps_along : 1;
    const auto weight =
        static_cast<float>(piece.weight / (2.0 * static_cast<double>(steps_across * along_steps)));
    const auto middle = [](int i, int count) {
        return (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    };
    for (int i = 0; i < steps_across; ++i) {
        const float across = half_width * (2.0f * middle(i, steps_across) - 1.0f);
        for (int j = 0; j < along_steps; ++j) {
            const float along = piece.low + (piece.high - piece.low) * middle(j, along_steps);
            for (const float s : {along, -along}) {
                const f32::YarnPoint y = f32::yarn_point(shape, across, s, piece.side, piece.bends);
                slopes.push_back({y.along, y.across, weight});
            }
        }
    }
}

}  // namespace

f32::WeaveCell weave_cell(const Draft& draft, int end, int pick) {
    const bool here = up(draft, end, pick);
    f32::WeaveCell cell;
    cell.warp_up = here;
    cell.warp_start = up(draft, end, wrapped(pick, draft.picks) - 1) != here;
    cell.warp_end = up(draft, end, wrapped(pick, draft.picks) + 1) != here;
    cell.weft_start = up(draft, wrapped(end, draft.ends) - 1, pick) != here;
    cell.weft_end = up(draft, wrapped(end, draft.ends) + 1, pick) != here;
    return cell;
}

std::uint8_t weave_cell_bits(const f32::WeaveCell& cell) {
    return static_cast<std::uint8_t>((cell.warp_up ? 1 : 0) | (cell.warp_start ? 2 : 0) |
                                     (cell.warp_end ? 4 : 0) | (cell.weft_start ? 8 : 0) |
                                     (cell.weft_end ? 16 : 0));
}

std::vector<std::uint8_t> weave_bits(const Draft& draft) {
    std::vector<std::uint8_t> bits;
    bits.reserve(draft.warp_up.size());
    for (int pick = 0; pick < draft.picks; ++pick) {
        for (int end = 0; end < draft.ends; ++end) {
            bits.push_back(weave_cell_bits(weave_cell(draft, end, pick)));
        }
    }
    return bits;
}

WeaveFamilies weave_families(const Draft& draft) {
    WeaveFamilies f;
    for (int pick = 0; pick < draft.picks; ++pick) {
        for (int end = 0; end < draft.ends; ++end) {
            const f32::WeaveCell cell = weave_cell(draft, end, pick);
            (cell.warp_up ? f.warp : f.weft).upper += 1;
            if (cell.warp_start) f.warp.bends += 1;
            if (cell.weft_start) f.weft.bends += 1;
        }
    }
    const double cells = static_cast<double>(draft.ends) * static_cast<double>(draft.picks);
    for (WeaveFamily* family : {&f.warp, &f.weft}) {
        family->upper /= cells;
        family->bends /= cells;
    }
    return f;
}

double weave_coverage(const WeaveFamily& family, float gap) {
    return family.upper * static_cast<double>(f32::weave_upper_share(gap)) +
           (1 - family.upper) * static_cast<double>(f32::weave_lower_share(gap));
}

std::vector<WeaveSlope> weave_slopes(const WeaveFamily& family, const f32::WeaveShape& shape,
                                     int steps_across, int steps_along) {
    std::vector<WeaveSlope> slopes;
    const double coverage = weave_coverage(family, shape.gap);
    if (!(coverage > 0)) return slopes;
    const float half_width = 0.5f * (1.0f - shape.gap);
    const double upper = family.upper * static_cast<double>(f32::weave_upper_share(shape.gap));
    const double lower =
        (1 - family.upper) * static_cast<double>(f32::weave_lower_share(shape.gap));
    // Fractions of half cells along the yarn that bend: a passage bends one half cell above and one
    // below.
    const double bent_above = family.upper > 0 ? family.bends / (2 * family.upper) : 0;
    const double bent_below = family.upper < 1 ? family.bends / (2 * (1 - family.upper)) : 0;
    const Piece pieces[] = {{upper / coverage * bent_above, 1.0f, true, 0.0f, 0.5f},
                            {upper / coverage * (1 - bent_above), 1.0f, false, 0.0f, 0.5f},
                            {lower / coverage * bent_below, -1.0f, true, half_width, 0.5f},
                            {lower / coverage * (1 - bent_below), -1.0f, false, half_width, 0.5f}};
    for (const Piece& piece : pieces) add_slopes(piece, shape, steps_across, steps_along, slopes);
    return slopes;
}

}  // namespace burnish
