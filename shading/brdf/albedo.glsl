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

// `v`: the view in the lobe's own space, not necessarily unit. Below the horizon: the place at the horizon.
FN AlbedoPlace albedo_place(Lobe lobe, vec3 v) {
    Float ax2 = lobe_alpha_x(lobe) * lobe_alpha_x(lobe);
    Float ay2 = lobe_alpha_y(lobe) * lobe_alpha_y(lobe);
    Float scale = Float(1) / albedo_most_alpha(lobe.mdf);
    Float x2 = v.x * v.x + kTiny;  // seen along the normal, the x axis stands for every azimuth
    Float y2 = v.y * v.y;
    Float flat2 = x2 + y2;
    Float along2 = (ax2 * x2 + ay2 * y2) / flat2;
    Float across2 = (ax2 * y2 + ay2 * x2) / flat2;
    Float mixed = (ax2 - ay2) * v.x * v.y / flat2;
    Float cosine = max(v.z, Float(0)) / sqrt(flat2 + v.z * v.z);
    AlbedoPlace place;
    place.mixed = min(mixed * mixed / max(along2 * across2, kTiny), Float(1));
    place.at = vec3(min(sqrt(sqrt(along2) * scale), Float(1)), min(sqrt(sqrt(across2) * scale), Float(1)),
                    sqrt(min(cosine, Float(1))));
    return place;
}

// E from the three numbers that the table has at the place.
FN Float albedo_value(AlbedoPlace place, vec3 c) {
    return c.x + place.mixed * (c.y + place.mixed * c.z);
}

// The place for a perturbed lobe. A rotation moves the lobe and keeps its albedo. The deformations and
// normal-map change it a little; theirs is taken to be that of the unperturbed lobe.
FN AlbedoPlace albedo_place_of(Lobe lobe, Perturbation p, vec3 wo) {
    vec3 v = perturb_direction(p, wo);
    if (p.method == kMethodRotateApprox) { v = frame_to_local(frame_for_sampling(p), wo); }
    return albedo_place(lobe_for_sampling(lobe, p), v);
}
