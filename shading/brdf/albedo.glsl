// Where the table of a model's albedos is read, and what it holds. The albedo E(wo) is Int f cos dwi of the
// unperturbed model with F = 1: the share of the light that leaves after a single reflection by a facet.
// src/models/albedo_table.hpp computes the table; the caller interpolates it.
//
// The plane through the normal and the view cuts the lobe. The covariance of the lobe's slopes has along^2 in
// that plane, across^2 perpendicular to it, and a mixed term, which is 0 where the view lies on an axis of the
// lobe. E is even in the mixed term, so that a polynomial in its square serves: within 1 % for alphas from 0.05 to 1.

// The largest alpha of the table: that of the parameters alpha_x and alpha_y, or of exponents of 0.
FN Float albedo_most_alpha(int mdf) { return mdf == kMdfAshikhminShirley ? Float(1) : Float(1.5); }

struct AlbedoPlace {
    vec3 at;      // in the table, from 0 to 1: roots of the alphas along and across, and of the cosine
    Float mixed;  // the square of the mixed term over along^2 across^2, from 0 to 1
};

FN AlbedoPlace albedo_place_of_slopes(int mdf, Float along2, Float across2, Float mixed_share, Float cosine) {
    Float scale = Float(1) / albedo_most_alpha(mdf);
    AlbedoPlace place;
    place.mixed = clamp(mixed_share, Float(0), Float(1));
    place.at = vec3(min(sqrt(sqrt(along2) * scale), Float(1)), min(sqrt(sqrt(across2) * scale), Float(1)),
                    sqrt(min(cosine, Float(1))));
    return place;
}

// `v`: the view in the lobe's own space, not necessarily unit. Below the horizon: the place at the horizon.
FN AlbedoPlace albedo_place(Lobe lobe, vec3 v) {
    Float ax2 = lobe_alpha_x(lobe) * lobe_alpha_x(lobe);
    Float ay2 = lobe_alpha_y(lobe) * lobe_alpha_y(lobe);
    Float x2 = v.x * v.x + kTiny;  // seen along the normal, the x axis stands for every azimuth
    Float y2 = v.y * v.y;
    Float flat2 = x2 + y2;
    Float along2 = (ax2 * x2 + ay2 * y2) / flat2;
    Float across2 = (ax2 * y2 + ay2 * x2) / flat2;
    Float mixed = (ax2 - ay2) * v.x * v.y / flat2;
    Float cosine = max(v.z, Float(0)) / sqrt(flat2 + v.z * v.z);
    return albedo_place_of_slopes(lobe.mdf, along2, across2, mixed * mixed / max(along2 * across2, kTiny), cosine);
}

// The factor of the slopes that slope-shift makes of those of the base lobe, about n~ and near the mean facet that wo
// sees: n~z/k^2, k = n~.(L m)/m.z. k itself leaves an error that its square halves (docs/theory/processes.md).
FN Float slope_shift_narrowing(Lobe lobe, Perturbation p, vec3 wo) {
    vec3 v = facet_view(p.method, p.n, wo);
    Float x = lobe_alpha_x(lobe) * v.x;
    Float y = lobe_alpha_y(lobe) * v.y;
    Float z = max(v.z, Float(0));
    // In the space where GGX is a hemisphere the mean facet is half way between the view and the pole.
    Float scale = Float(1) / max(sqrt(x * x + y * y + z * z) + z, kTiny);
    Float k = Float(1) + p.n.z * (p.n.x * lobe_alpha_x(lobe) * x + p.n.y * lobe_alpha_y(lobe) * y) * scale;
    k = clamp(k, Float(0.5), Float(2));  // lobes of alpha 1 at tilts of 60 degrees
    return p.n.z / (k * k);
}

// The same of slope-shift and stretch: the facets about n~ have slopes P (a_x x, a_y y), P the part of L beside n~.
// stretch keeps the lobe's kind, so that it is exact; of slope-shift it is the lobe near the facets that wo sees. With v
// = L^T wo the variance along the view is that of v, the sum of both is the trace of their covariance, and the
// determinant of that is (a_x a_y det P)^2.
FN AlbedoPlace albedo_place_of_moved(Lobe lobe, Perturbation p, vec3 wo) {
    Float ax2 = lobe_alpha_x(lobe) * lobe_alpha_x(lobe);
    Float ay2 = lobe_alpha_y(lobe) * lobe_alpha_y(lobe);
    vec3 v = facet_view(kMethodStretch, p.n, wo);
    Float shrink = Float(1);
    if (p.method == kMethodSlopeShift) {
        shrink = slope_shift_narrowing(lobe, p, wo);
        shrink = shrink * shrink;
    }
    // 1e-9: seen along n~, the part of x beside n~ stands for every azimuth.
    Float down = wo.z - p.n.z * v.z;
    Float flat2 = v.x * v.x + v.y * v.y + down * down;
    Float x2 = Float(1) - p.n.x * p.n.x;
    Float y2 = Float(1) - p.n.y * p.n.y;
    Float trace = ax2 * x2 + ay2 * y2;
    Float part_y = p.n.x * p.n.x * p.n.y * p.n.y / max(x2, kTiny);
    Float along2 = choose(flat2 > Float(1e-9), (ax2 * v.x * v.x + ay2 * v.y * v.y) / max(flat2, Float(1e-9)),
                          ax2 * x2 + ay2 * part_y);
    along2 = max(along2, kTiny);
    Float across2 = max(trace - along2, kTiny);
    Float mixed_share = Float(1) - ax2 * ay2 * (p.n.z * p.n.z) / (along2 * across2);
    return albedo_place_of_slopes(lobe.mdf, along2 * shrink, across2 * shrink, mixed_share, max(v.z, Float(0)));
}

// E from the three numbers that the table has at the place.
FN Float albedo_value(AlbedoPlace place, vec3 c) {
    return c.x + place.mixed * (c.y + place.mixed * c.z);
}

// The place for a perturbed lobe. slope-shift and stretch: as above. A rotation moves the lobe and keeps its albedo. The
// deformations and normal-map change it a little; theirs is taken to be that of the unperturbed lobe.
FN AlbedoPlace albedo_place_of(Lobe lobe, Perturbation p, vec3 wo) {
    if (method_moves_facets(p.method)) { return albedo_place_of_moved(lobe, p, wo); }
    vec3 v = perturb_direction(p, wo);
    if (p.method == kMethodRotateApprox) { v = frame_to_local(frame_for_sampling(p), wo); }
    return albedo_place(lobe_for_sampling(lobe, p), v);
}
