// Ward's model ("Measuring and Modeling Anisotropic Reflection", SIGGRAPH 1992) over the normal
// distribution of slopes with its exact exponent: exp(-tan^2 theta_h (...)) / (4 pi alpha_x alpha_y
// cosines). `lobe`: of Beckmann, whose norm is 1/(pi alpha_x alpha_y).
//
// cosines = sqrt(n.wi n.wo) as printed in 1992 loses energy towards grazing; their product (Duer, "An
// Improved Normalization for the Ward Reflectance Model", JGT 11(1), 2006) gains without bound there.
FN Float ward_value(Lobe lobe, LobePoint q, Float cosines) {
    Float shape = q.weight * slope_gaussian(lobe.p0, lobe.p1, q);
    return lobe.projected_norm * shape / (Float(4) * cosines);
}
