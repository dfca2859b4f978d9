// Fresnel reflectance for unpolarised light; cos_i = wi.h in [0, 1].

// Schlick 1994: f0 + (1 - f0) (1 - cos)^5.
FN Float fresnel_schlick(Float f0, Float cos_i) {
    Float m = clamp(Float(1) - cos_i, Float(0), Float(1));
    Float m2 = m * m;
    return f0 + (Float(1) - f0) * (m2 * m2 * m);
}

FN vec3 fresnel_schlick(vec3 f0, Float cos_i) {
    return vec3(fresnel_schlick(f0.x, cos_i), fresnel_schlick(f0.y, cos_i),
                fresnel_schlick(f0.z, cos_i));
}

// With another reflectance than 1 at grazing incidence.
FN Float fresnel_schlick(Float f0, Float f90, Float cos_i) {
    Float m = clamp(Float(1) - cos_i, Float(0), Float(1));
    Float m2 = m * m;
    return f0 + (f90 - f0) * (m2 * m2 * m);
}

FN vec3 fresnel_schlick(vec3 f0, Float f90, Float cos_i) {
    return vec3(fresnel_schlick(f0.x, f90, cos_i), fresnel_schlick(f0.y, f90, cos_i),
                fresnel_schlick(f0.z, f90, cos_i));
}

// Exact, for a conductor with index eta + i k against air.
FN Float fresnel_conductor(Float eta, Float k, Float cos_i) {
    Float c = clamp(cos_i, Float(0), Float(1));
    Float c2 = c * c;
    Float s2 = Float(1) - c2;
    Float d = eta * eta - k * k - s2;
    Float a2b2 = sqrt(d * d + Float(4) * eta * eta * k * k);
    Float a = sqrt(max(Float(0.5) * (a2b2 + d), Float(0)));
    Float rs = (a2b2 + c2 - Float(2) * a * c) / (a2b2 + c2 + Float(2) * a * c);
    Float g = c2 * a2b2 + s2 * s2;
    Float q = Float(2) * a * c * s2;
    Float rp = rs * (g - q) / (g + q);
    return Float(0.5) * (rs + rp);
}

FN vec3 fresnel_conductor(vec3 eta, vec3 k, Float cos_i) {
    return vec3(fresnel_conductor(eta.x, k.x, cos_i), fresnel_conductor(eta.y, k.y, cos_i),
                fresnel_conductor(eta.z, k.z, cos_i));
}

// 1/F at normal incidence of a dielectric; 1e-6: of no interface (eta 1).
FN Float fresnel_inverse_at_normal(Float eta) {
    return Float(1) / max(fresnel_conductor(max(eta, Float(1)), Float(0), Float(1)), Float(1e-6));
}

// A smooth dielectric's reflectance relative to normal incidence, for reflectances that were measured
// there. `inverse_at_normal`: of fresnel_inverse_at_normal. eta <= 0: 1, without Fresnel.
FN Float fresnel_rise(Float eta, Float inverse_at_normal, Float cos_i) {
    Float rise = fresnel_conductor(max(eta, Float(1)), Float(0), cos_i) * inverse_at_normal;
    return choose(eta > Float(0), rise, Float(1));
}

// A reflectance over the angle that has no closed form, such as that of a metal under a film: terms of
// fresnel_curve at R, G, B.
struct FresnelCurve {
    vec3 normal;  // reflectance at normal incidence
    vec3 pole;
    vec3 pole2;
    vec3 c0;
    vec3 c1;
    vec3 c2;
};

// Near grazing incidence the reflectance of a metal bends as c/(c + q) does, q of the size of 1/|index|.
// Fits of films on twelve metals had the smallest largest error here.
CONSTANT(kFresnelCurvePole, 0.05)

FN FresnelCurve fresnel_curve_of_mirror() {
    FresnelCurve f;
    f.normal = vec3(Float(1), Float(1), Float(1));
    f.pole = vec3(Float(0), Float(0), Float(0));
    f.pole2 = vec3(Float(0), Float(0), Float(0));
    f.c0 = vec3(Float(0), Float(0), Float(0));
    f.c1 = vec3(Float(0), Float(0), Float(0));
    f.c2 = vec3(Float(0), Float(0), Float(0));
    return f;
}

// `normal` at normal incidence, 1 at grazing incidence, and between them
//   mix(1, normal, c) + c (1 - c) (pole/(c + q) + pole2/(c + q)^2 + c0 + c1 (1 - c) + c2 (1 - c)^2),
// within [0, 1]. q: kFresnelCurvePole.
FN Float fresnel_curve(Float normal, Float pole, Float pole2, Float c0, Float c1, Float c2, Float cos_i) {
    Float c = clamp(cos_i, Float(0), Float(1));
    Float t = Float(1) - c;
    Float u = Float(1) / (c + kFresnelCurvePole);
    Float between = u * (pole + u * pole2) + c0 + t * (c1 + t * c2);
    return clamp(t + c * (normal + t * between), Float(0), Float(1));
}

FN vec3 fresnel_curve(FresnelCurve f, Float cos_i) {
    return vec3(fresnel_curve(f.normal.x, f.pole.x, f.pole2.x, f.c0.x, f.c1.x, f.c2.x, cos_i),
                fresnel_curve(f.normal.y, f.pole.y, f.pole2.y, f.c0.y, f.c1.y, f.c2.y, cos_i),
                fresnel_curve(f.normal.z, f.pole.z, f.pole2.z, f.c0.z, f.c1.z, f.c2.z, cos_i));
}
