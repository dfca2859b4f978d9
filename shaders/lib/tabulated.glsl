// Tabulated distributions (TABULATED): fetches the values that shading/mdf/tabulated.glsl needs.
// src/gpu/upload/tabulated_maps.hpp describes the textures.

uniform highp sampler2D u_tabulated_tables;
uniform highp sampler2D u_tabulated_areas;
uniform ivec2 u_tabulated_grid;     // azimuths, rings
uniform vec2 u_tabulated_fresnel;   // refractive index (0: no Fresnel), 1/F at normal incidence

const ivec2 kAreaGrid = ivec2(32, 16);  // of ndf_grid.hpp

// One exemplar: the origins of its blocks in the textures.
struct TableBlock {
    ivec2 table;
    ivec2 areas;
    float groove;  // angle from the lobe's x axis to the table's, in turns
};

// Interpolated value at `place`; each texel holds the four values for an interpolation.
float block_at(highp sampler2D map, ivec2 block, TablePlace place) {
    vec4 four = texelFetch(map, block + ivec2(place.column, place.row), 0);
    return table_value(place, four.x, four.y, four.z, four.w);
}

float tabulated_D(TableBlock b, LobePoint q) {
    q = lobe_point_unit(q);
    TablePlace place = table_place(u_tabulated_grid.x, u_tabulated_grid.y,
                                   tabulated_row(q, u_tabulated_grid.y),
                                   tabulated_turns(q.x, q.y) + b.groove);
    return q.weight * block_at(u_tabulated_tables, b.table, place);
}

float tabulated_seen(TableBlock b, vec3 w) {
    TablePlace place = table_place(kAreaGrid.x, kAreaGrid.y, tabulated_area_row(w, kAreaGrid.y),
                                   tabulated_turns(w.x, w.y) + b.groove);
    return tabulated_area(block_at(u_tabulated_areas, b.areas, place), w);
}

// All lobe values except the densities.
LobeValues tabulated_values(TableBlock b, Perturbation p, vec3 wi, vec3 wo) {
    LobeValues v = no_lobe_values();
    v.D = tabulated_D(b, perturb_point(p, half_vector(wi + wo, p.n)));
    v.area_i = tabulated_seen(b, perturb_direction(p, wi));
    v.area_o = tabulated_seen(b, perturb_direction(p, wo));
    return v;
}

#if IMAGE_LIGHT == 1
// x: cumulative share of a ring's cells; y: density of draws in the cell.
uniform highp sampler2D u_tabulated_draws;

// Cumulative share of the rings. A block holds the areas first, then these shares.
float rings_so_far(TableBlock b, int ring) {
    ivec2 at = ivec2(ring % kAreaGrid.x, kAreaGrid.y + ring / kAreaGrid.x);
    return texelFetch(u_tabulated_areas, b.areas + at, 0).r;
}

float cells_so_far(TableBlock b, int ring, int column) {
    return texelFetch(u_tabulated_draws, b.table + ivec2(column, ring), 0).r;
}

// The ring that xi selects, and the position in it. 10 steps suffice for 1,024 rings.
int ring_of(TableBlock b, float xi, out float part) {
    int low = 0;
    int high = u_tabulated_grid.y - 1;
    for (int i = 0; i < 10; ++i) {
        int middle = (low + high) / 2;
        bool below = rings_so_far(b, middle) <= xi;
        low = below && low < high ? middle + 1 : low;
        high = below ? high : middle;
    }
    part = table_draw_part(xi, low > 0 ? rings_so_far(b, low - 1) : 0.0, rings_so_far(b, low));
    return low;
}

// The column that xi selects, and the position in it. 12 steps suffice for 4,096 columns.
int column_of(TableBlock b, int ring, float xi, out float part) {
    int low = 0;
    int high = u_tabulated_grid.x - 1;
    for (int i = 0; i < 12; ++i) {
        int middle = (low + high) / 2;
        bool below = cells_so_far(b, ring, middle) <= xi;
        low = below && low < high ? middle + 1 : low;
        high = below ? high : middle;
    }
    part = table_draw_part(xi, low > 0 ? cells_so_far(b, ring, low - 1) : 0.0,
                           cells_so_far(b, ring, low));
    return low;
}

vec3 tabulated_base_sample(TableBlock b, vec2 xi) {
    TableDraw draw;
    draw.ring = ring_of(b, xi.y, draw.along);
    draw.column = column_of(b, draw.ring, xi.x, draw.across);
    return tabulated_half_vector(draw, u_tabulated_grid.x, u_tabulated_grid.y, b.groove);
}

float tabulated_base_pdf(TableBlock b, LobePoint q) {
    TableDraw cell = tabulated_cell(q, u_tabulated_grid.x, u_tabulated_grid.y, b.groove);
    return q.weight * texelFetch(u_tabulated_draws, b.table + ivec2(cell.column, cell.ring), 0).g;
}

// For normal-map, the round part of the mixture is the table about n~. rotate-approx reads a table
// where the exact rotation does.
vec3 tabulated_sample(TableBlock b, Perturbation p, vec2 xi, float select) {
    vec3 base = tabulated_base_sample(b, xi);
    return perturbed_sample(p, base, base, xi, select);
}

float tabulated_pdf(TableBlock b, Perturbation p, vec3 h) {
    BasePoints q = base_points(p, h);
    float round = 0.0;
    if (p.method == kMethodNormalMap) { round = tabulated_base_pdf(b, q.round); }
    return perturbed_density(p, h, q, tabulated_base_pdf(b, q.at), round);
}
#endif
