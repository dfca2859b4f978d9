// Distributions given as tables: src/scene/material/ndf_grid.hpp has their layout. Whoever has the tables looks
// values up; here is where, and what the BRDF k_s F D / (4 g(i) g(o)) makes of them. The perturbation
// is that of every lobe: D is read at perturb_point, g at perturb_direction.

// atan(y / x) in quarter turns, 0 to 1, of x and y that are not negative; 0 of two zeros. A minimax
// polynomial of our own, 7e-7 relative: every texel of every pixel takes six of these, and an atan of all
// quadrants is dearer.
FN Float quarter_turns(Float x, Float y) {
    Float t = min(x, y) / max(max(x, y), kTiny);
    Float w = t * t;
    Float high = -Float(0.0858621275) +
                 w * (Float(0.0533940592) + w * (-Float(0.023563209) + w * Float(0.00500598128)));
    Float low = Float(0.636619357) + w * (-Float(0.212163183) + w * (Float(0.126569448) + w * high));
    Float near = t * low;
    return choose(y > x, Float(1) - near, near);
}

// u = sqrt(2 theta / pi). From sine and cosine: near the pole a cosine alone knows nothing. Under
// normal-map the elevation is about n~ and the azimuth about n, as K11 Eq 2 has it.
FN Float tabulated_u(LobePoint q) {
    return sqrt(quarter_turns(max(q.z, Float(0)), sqrt(max(q.s2, Float(0)))));
}

// The azimuth in turns, 0 to 1; 0 at the pole.
FN Float tabulated_turns(Float x, Float y) {
    Float a = quarter_turns(abs(x), abs(y));
    a = choose(x < Float(0), Float(2) - a, a);
    return Float(0.25) * choose(y < Float(0), Float(4) - a, a);
}

// Where areas are stored: s = sqrt(1 - 2 theta / pi), 0 at the horizon and below.
FN Float tabulated_s(vec3 w) {
    Float rise = quarter_turns(sqrt(w.x * w.x + w.y * w.y), max(w.z, Float(0)));
    return sqrt(rise);
}

// |w| g(w/|w|) from what is stored, `more` = g - z. Frames that are not of unit rows (normal-map,
// rotate-approx) give longer or shorter w, and a Smith G1 asks for their ratios only: with
// G1 = z/g and z = n~.w, G1(i) G1(o) / (n~.i n~.o) = 1 / (|i| g |o| g).
FN Float tabulated_area(Float more, vec3 w) {
    Float l = length(w);
    // 1e-6: as ndf_area_lookup.
    return max(w.z + more * l, Float(1e-6) * l);
}

// D / (4 g(wi) g(wo)): the specular term of Ashikhmin, Premoze & Shirley 2000, without Fresnel, for
// any distribution whose areas the caller has looked up.
FN Float area_brdf(Float D, Float area_i, Float area_o) {
    return min(D / (Float(4) * max(area_i, kLeastCosine) * max(area_o, kLeastCosine)), kMostValue);
}

// The same for areas of tabulated_area under a perturbed normal: 0 where wi or wo is below its horizon.
FN Float tabulated_brdf(Float D, Float area_i, Float area_o, Float cos_i, Float cos_o) {
    return choose(cos_i > Float(0) && cos_o > Float(0), area_brdf(D, area_i, area_o), Float(0));
}

// ---- reading a table ----------------------------------------------------------------------------

// The four cells between which a value lies, and how far it is from the first towards the others:
// columns (azimuths) go around, `column` + 1 beyond the last is 0; row + 1 is a row of the table.
struct TablePlace {
    int column;
    int row;
    Float across;  // 0 at column, 1 at the next
    Float along;   // 0 at row, 1 at the next
};

// `row`: in rows, 0 to rows - 1; `turns`: the azimuth in turns, any number. rows >= 2.
FN TablePlace table_place(int columns, int rows, Float row, Float turns) {
    Float column = (turns - floor(turns)) * Float(columns);
    TablePlace p;
    p.column = min(int(column), columns - 1);
    p.row = min(int(row), rows - 2);
    p.across = column - Float(p.column);
    p.along = row - Float(p.row);
    return p;
}

// The value from those of the four cells: here, the next around, the next row's, and of both.
FN Float table_value(TablePlace p, Float here, Float next, Float here_above, Float next_above) {
    return mix(mix(here, next, p.across), mix(here_above, next_above, p.across), p.along);
}

// Rows of D at q and of areas seen from w.
FN Float tabulated_row(LobePoint q, int rings) {
    return clamp(tabulated_u(q) * Float(rings) - Float(0.5), Float(0), Float(rings - 1));
}

FN Float tabulated_area_row(vec3 w, int rows) {
    return tabulated_s(w) * Float(rows - 1);
}

// From the lobe's x axis to the table's, in turns: follow-grain takes the groove of the table as the lobe's x
// axis, every other method the table as it is. `groove`: the groove's azimuth in the table, in turns.
FN Float tabulated_rotation(int method, Float groove) {
    if (method == kMethodFollowGrain) { return groove; }
    return Float(0);
}

// ---- drawing from a table -----------------------------------------------------------------------

// Draws are even within the cells of rings (u) and columns, of which column 0 lies about azimuth 0. The
// caller finds by `xi` the ring and then the column whose share of draws so far exceeds xi first.
struct TableDraw {
    int ring;
    int column;
    Float along;   // how far into the ring, 0 to 1
    Float across;  // how far into the column
};

// How far xi lies into a cell, from the shares so far without the cell and with it.
FN Float table_draw_part(Float xi, Float before, Float with_it) {
    return clamp((xi - before) / max(with_it - before, kTiny), Float(0), Float(1));
}

// 1 - cos theta at the inner edge of a ring, with all its digits near the pole.
FN Float tabulated_ring_edge(int ring, int rings) {
    Float u = Float(ring) / Float(rings);
    Float s = sin(Float(0.25) * kPi * u * u);
    return Float(2) * s * s;
}

// The half vector of a draw; `groove`: from the lobe's x axis to the table's, in turns.
FN vec3 tabulated_half_vector(TableDraw draw, int columns, int rings, Float groove) {
    Float fall = mix(tabulated_ring_edge(draw.ring, rings),
                     tabulated_ring_edge(draw.ring + 1, rings), draw.along);
    Float sine = sqrt(max(fall * (Float(2) - fall), Float(0)));
    Float turns = (Float(draw.column) - Float(0.5) + draw.across) / Float(columns);
    Float phi = Float(2) * kPi * (turns - groove);
    return vec3(sine * cos(phi), sine * sin(phi), max(Float(1) - fall, Float(1e-6)));
}

// The cell whose density of draws is that at q (along and across are 0).
FN TableDraw tabulated_cell(LobePoint q, int columns, int rings, Float groove) {
    Float turns = tabulated_turns(q.x, q.y) + groove;
    Float place = (turns - floor(turns)) * Float(columns) + Float(0.5);
    TableDraw cell;
    cell.ring = min(int(tabulated_u(q) * Float(rings)), rings - 1);
    cell.column = int(place) % columns;
    cell.along = Float(0);
    cell.across = Float(0);
    return cell;
}
