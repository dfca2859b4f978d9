// Cook & Torrance ("A Reflectance Model for Computer Graphics", TOG 1(1), 1982): Beckmann's
// distribution with the shadowing of V-shaped cavities. Modern scale: D with 1/pi, denominator
// 4 (n.wi) (n.wo).

// min(1, 2 (n.h) (n.wo)/(wo.h), 2 (n.h) (n.wi)/(wi.h)); wo.h = wi.h.
FN Float v_cavity_G(Float cos_h, Float cos_i, Float cos_o, Float wi_h) {
    return clamp(Float(2) * cos_h * min(cos_i, cos_o) / wi_h, Float(0), Float(1));
}
