// The specular term of a distribution given as a table (TABULATED), and its sampling. m.table and
// m.areas: where the exemplar's block begins; m.groove: from the lobe's x axis to the table's,
// in turns. src/gpu/tabulated_maps.hpp says what the textures hold.

uniform highp sampler2D u_tabulated_tables;
uniform highp sampler2D u_tabulated_areas;
uniform ivec2 u_tabulated_grid;     // azimuths, rings
uniform vec2 u_tabulated_fresnel;   // refractive index (0: no Fresnel), 1/F at normal incidence

const ivec2 kAreaGrid = ivec2(32, 16);  // of ndf_grid.hpp

// Between rows as `row` says, between columns as the azimuth does, all around; each texel has the four
// values that this asks for.
float block_at(highp sampler2D map, ivec2 block, ivec2 size, float row, float turns) {
    float column = (turns - floor(turns)) * float(size.x);
    int left = min(int(column), size.x - 1);
    int low = min(int(row), size.y - 2);
    vec4 four = texelFetch(map, block + ivec2(left, low), 0);
    vec2 rows = mix(four.xz, four.yw, column - float(left));
    return mix(rows.x, rows.y, row - float(low));
}

// Measured at normal incidence, and elsewhere what a smooth dielectric makes of it.
float tabulated_fresnel(float cos_h) {
    float eta = max(u_tabulated_fresnel.x, 1.0);
    float rise = fresnel_conductor(eta, 0.0, cos_h) * u_tabulated_fresnel.y;
    return u_tabulated_fresnel.x > 0.0 ? rise : 1.0;
}

vec3 specular_fresnel(Shading m, float cos_h) {
    return m.specular * tabulated_fresnel(cos_h);
}

float tabulated_D(Shading m, LobePoint q) {
    float rings = float(u_tabulated_grid.y);
    float row = clamp(tabulated_u(q) * rings - 0.5, 0.0, rings - 1.0);
    float turns = tabulated_turns(q.x, q.y) + m.groove;
    return q.weight * block_at(u_tabulated_tables, m.table, u_tabulated_grid, row, turns);
}

float tabulated_seen(Shading m, vec3 w) {
    float row = tabulated_s(w) * float(kAreaGrid.y - 1);
    float turns = tabulated_turns(w.x, w.y) + m.groove;
    return tabulated_area(block_at(u_tabulated_areas, m.areas, kAreaGrid, row, turns), w);
}

float specular_eval(Shading m, Perturbation p, vec3 wi, vec3 wo) {
    float D = tabulated_D(m, perturb_point(p, half_vector(wi + wo, p.n)));
    return tabulated_brdf(D, tabulated_seen(m, perturb_direction(p, wi)),
                          tabulated_seen(m, perturb_direction(p, wo)), dot(p.n, wi), dot(p.n, wo));
}

#if IMAGE_LIGHT == 1
// Of each table x: shares of a ring's cells so far, y: the density that draws have in the cell.
uniform highp sampler2D u_tabulated_draws;

// Rows of an exemplar's block of areas: the areas, and shares of the rings so far.
float rings_so_far(Shading m, int ring) {
    ivec2 at = ivec2(ring % kAreaGrid.x, kAreaGrid.y + ring / kAreaGrid.x);
    return texelFetch(u_tabulated_areas, m.areas + at, 0).r;
}

float cells_so_far(Shading m, int ring, int column) {
    return texelFetch(u_tabulated_draws, m.table + ivec2(column, ring), 0).r;
}

// The ring, and how far into it. 10 steps: 1,024 rings.
int ring_of(Shading m, float xi, out float part) {
    int low = 0;
    int high = u_tabulated_grid.y - 1;
    for (int i = 0; i < 10; ++i) {
        int middle = (low + high) / 2;
        bool below = rings_so_far(m, middle) <= xi;
        low = below && low < high ? middle + 1 : low;
        high = below ? high : middle;
    }
    float before = low > 0 ? rings_so_far(m, low - 1) : 0.0;
    part = clamp((xi - before) / max(rings_so_far(m, low) - before, kTiny), 0.0, 1.0);
    return low;
}

// 12 steps: 4,096 columns.
int column_of(Shading m, int ring, float xi, out float part) {
    int low = 0;
    int high = u_tabulated_grid.x - 1;
    for (int i = 0; i < 12; ++i) {
        int middle = (low + high) / 2;
        bool below = cells_so_far(m, ring, middle) <= xi;
        low = below && low < high ? middle + 1 : low;
        high = below ? high : middle;
    }
    float before = low > 0 ? cells_so_far(m, ring, low - 1) : 0.0;
    part = clamp((xi - before) / max(cells_so_far(m, ring, low) - before, kTiny), 0.0, 1.0);
    return low;
}

// 1 - cos theta at the inner edge of a ring, with all its digits near the pole.
float ring_edge(int ring) {
    float u = float(ring) / float(u_tabulated_grid.y);
    float s = sin(0.25 * kPi * u * u);
    return 2.0 * s * s;
}

vec3 tabulated_base_sample(Shading m, vec2 xi) {
    float along;
    float across;
    int ring = ring_of(m, xi.y, along);
    int column = column_of(m, ring, xi.x, across);
    float fall = mix(ring_edge(ring), ring_edge(ring + 1), along);
    float sine = sqrt(max(fall * (2.0 - fall), 0.0));
    float turns = (float(column) - 0.5 + across) / float(u_tabulated_grid.x);
    float phi = 2.0 * kPi * (turns - m.groove);
    return vec3(sine * cos(phi), sine * sin(phi), max(1.0 - fall, 1e-6));
}

float tabulated_base_pdf(Shading m, LobePoint q) {
    int ring = min(int(tabulated_u(q) * float(u_tabulated_grid.y)), u_tabulated_grid.y - 1);
    float turns = tabulated_turns(q.x, q.y) + m.groove;
    float place = (turns - floor(turns)) * float(u_tabulated_grid.x) + 0.5;
    int column = int(place) % u_tabulated_grid.x;
    return q.weight * texelFetch(u_tabulated_draws, m.table + ivec2(column, ring), 0).g;
}

// As lobe_sample and lobe_pdf of sample.glsl do with lobes; the round part of the normal-map mixture is
// the table about n~. rotate-approx reads a table where the exact rotation does.
vec3 tabulated_sample(Shading m, Perturbation p, vec2 xi, float select) {
    if (p.method != kMethodNormalMap) { return perturb_forward(p, tabulated_base_sample(m, xi)); }
    Frame f = frame_shortest_arc(p.n);
    if (select < kMixtureBase) { return tabulated_base_sample(m, xi); }
    if (select < kMixtureBase + kMixtureRound) {
        return frame_to_outer(f, tabulated_base_sample(m, xi));
    }
    float s = sqrt(xi.y);
    float psi = 2.0 * kPi * xi.x;
    return frame_to_outer(f, vec3(s * cos(psi), s * sin(psi), sqrt(max(1.0 - xi.y, 0.0))));
}

float tabulated_pdf(Shading m, Perturbation p, vec3 h) {
    if (p.method == kMethodNormalMap) {
        LobePoint about_n = lobe_point_of(frame_to_local(frame_shortest_arc(p.n), h));
        return kMixtureBase * tabulated_base_pdf(m, lobe_point_of(h)) +
               kMixtureRound * tabulated_base_pdf(m, about_n) + kMixtureCosine * about_n.z / kPi;
    }
    if (p.method == kMethodDeformLinear || p.method == kMethodDeformSmooth) {
        LobePoint q = perturb_point(p, h);
        q.weight = q.weight > 0.0 ? 1.0 : 0.0;  // a density, not an energy
        return tabulated_base_pdf(m, q) * deform_jacobian(p.method, p.n, h) * h.z / max(q.z, 1e-7);
    }
    return tabulated_base_pdf(m, lobe_point_of(frame_to_local(frame_for_sampling(p), h)));
}

vec3 specular_sample(Shading m, Perturbation p, vec3 wo, vec2 xi, float select, out float pdf) {
    vec3 h = tabulated_sample(m, p, xi, select);
    float density = tabulated_pdf(m, p, h);
    float wo_h = dot(wo, h);
    pdf = wo_h > 0.0 ? min(density / max(4.0 * wo_h, kTiny), kMostValue) : 0.0;
    return reflect_about(wo, h);
}
#endif
