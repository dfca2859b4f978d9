// Woven cloth: what lies at a point of a cell, the crossing of one warp and one weft yarn
// (docs/theory/cloth.md). K12 section IV.B names the parts (axes that alternate with the yarn, normals from
// the weave's pattern) and gives no formula; these are ours. Lengths are in yarn spacings: warp yarns
// run along +v and weft yarns along +u, a cell is a unit square with its middle at (0, 0).

// What the draft says of a cell: which yarn is above, and where yarns pass from one side of the cloth
// to the other: at the cell's edge towards smaller (start) or larger (end) coordinates along the yarn.
struct WeaveCell {
    Bool warp_up;
    Bool warp_start;
    Bool warp_end;
    Bool weft_start;
    Bool weft_end;
};

// From five bits: 1 warp_up, 2 warp_start, 4 warp_end, 8 weft_start, 16 weft_end.
FN WeaveCell weave_cell_of_bits(int bits) {
    WeaveCell cell;
    cell.warp_up = (bits & 1) != 0;
    cell.warp_start = (bits & 2) != 0;
    cell.warp_end = (bits & 4) != 0;
    cell.weft_start = (bits & 8) != 0;
    cell.weft_end = (bits & 16) != 0;
    return cell;
}

struct WeaveShape {
    Float crimp;      // how far a yarn's middle line rises and falls: its amplitude
    Float bulge;      // sine of the tilt of a yarn's surface at its edges, 0 (ribbons) to 0.95
    Float gap;        // between neighbouring yarns, 0 to below 1
    vec2 twist;       // (cos, sin) of the angle from a yarn's axis to its fibres
};

struct WeavePoint {
    Float warp;       // 1 on a warp yarn, 0 on a weft yarn
    Float cover;      // 0 in the hole between the yarns
    Float height;
    vec3 n;           // of the height's gradient: unit, against (u, v, out of the cloth)
    vec2 fiber;       // direction of the fibres in the plane of the cloth, unit
};

// Height and slope of one yarn.
struct YarnPoint {
    Float height;
    Float across;     // slope across the yarn
    Float along;
};

// `across`, `along`: from the cell's middle. `side`: 1 above, -1 below. `bends`: whether the yarn passes
// to the other side at the edge that is nearer along it.
//
// The middle line is side crimp cos(pi along) from the middle of the cell to that edge, where it passes
// through 0 into the next cell's, and side crimp elsewhere: continuous, as its slope is. Across lies
// an arc of a circle of curvature k = bulge / half width, 0 at the edges, so that the sine of the tilt
// grows evenly from the middle to the edge.
FN YarnPoint yarn_point(WeaveShape shape, Float across, Float along, Float side, Bool bends) {
    Float half_width = Float(0.5) * (Float(1) - shape.gap);
    Float k = shape.bulge / half_width;
    Float sine = clamp(k * across, -shape.bulge, shape.bulge);  // beyond its edge there is no yarn
    Float cosine = sqrt(Float(1) - sine * sine);
    Float edge = sqrt(Float(1) - shape.bulge * shape.bulge);
    Float turn = kPi * along;
    YarnPoint y;
    y.height = side * shape.crimp * choose(bends, cos(turn), Float(1)) +
               k * (half_width * half_width - across * across) / (cosine + edge);
    y.across = -sine / cosine;
    y.along = choose(bends, -side * shape.crimp * kPi * sin(turn), Float(0));
    return y;
}

// (x, y) from the middle of the cell, within +-1/2. Over a gap of the upper yarn the lower one shows.
FN WeavePoint weave_point(WeaveCell cell, WeaveShape shape, Float x, Float y) {
    Float half_width = Float(0.5) * (Float(1) - shape.gap);
    Bool on_warp = abs(x) < half_width;
    Bool on_weft = abs(y) < half_width;
    Bool warp = on_warp && (cell.warp_up || !on_weft);
    Float across = choose(warp, x, y);
    Float along = choose(warp, y, x);
    Float side = choose(warp == cell.warp_up, Float(1), Float(-1));
    Bool start = (warp && cell.warp_start) || (!warp && cell.weft_start);
    Bool end = (warp && cell.warp_end) || (!warp && cell.weft_end);
    Bool bends = (along < Float(0) && start) || (along >= Float(0) && end);
    YarnPoint yarn = yarn_point(shape, across, along, side, bends);
    WeavePoint p;
    p.warp = choose(warp, Float(1), Float(0));
    p.cover = choose(on_warp || on_weft, Float(1), Float(0));
    p.height = yarn.height;
    p.n = normal_of_slopes(-choose(warp, yarn.across, yarn.along), -choose(warp, yarn.along, yarn.across));
    p.fiber = vec2(choose(warp, -shape.twist.y, shape.twist.x), choose(warp, shape.twist.x, shape.twist.y));
    return p;
}

// Shares of a cell's area on which the upper yarn, and through its gaps the lower one, shows. What is
// left of 1 is the hole, gap^2.
FN Float weave_upper_share(Float gap) {
    return Float(1) - gap;
}

FN Float weave_lower_share(Float gap) {
    return gap * (Float(1) - gap);
}

// ---- from afar --------------------------------------------------------------------------------------

// How much of what a pixel sees is the mean over many cells (1) and how much the point at its middle
// (0), for a pixel 2^size cells wide: points from three pixels a cell on, means from one pixel a cell.
CONSTANT(kWeavePointSize, -1.5)
CONSTANT(kWeaveMeanSize, -0.25)

FN Float weave_mean_share(Float size) {
    Float t = clamp((size - kWeavePointSize) / (kWeaveMeanSize - kWeavePointSize), Float(0), Float(1));
    return t * t * (Float(3) - Float(2) * t);
}

// The coordinate of a slope in the tables of mean distributions (src/maps/weave/weave_mean.hpp), within +-1:
// `width` is the standard deviation of slopes, which the tables thereby resolve whatever it is.
FN Float weave_table_coordinate(Float slope, Float width) {
    return slope / (abs(slope) + width);
}

FN Float weave_table_slope(Float coordinate, Float width) {
    return coordinate * width / max(Float(1) - abs(coordinate), kTiny);
}
