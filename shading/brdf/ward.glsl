// Ward's model ("Measuring and Modeling Anisotropic Reflection", SIGGRAPH 1992) over the normal
// distribution of slopes with its exact exponent: exp(-tan^2 theta_h (...)) / (4 pi alpha_x alpha_y
// cosines), of which this is all but 1/(4 cosines) (brdf_of_factor). `lobe`: of Beckmann, whose norm is
// 1/(pi alpha_x alpha_y).
//
// cosines = sqrt(n.wi n.wo) as printed in 1992 loses energy towards grazing, and gains it back without
// bound in the last degree; their product (Duer, "An Improved Normalization for the Ward Reflectance
// Model", JGT 11(1), 2006) gains without bound from some 80 degrees on.
FN Float ward_factor(Lobe lobe, LobePoint q) {
    return lobe.projected_norm * lobe_point_unit(q).weight * slope_gaussian(lobe.p0, lobe.p1, q);
}
