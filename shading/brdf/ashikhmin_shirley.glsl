// Ashikhmin & Shirley, "An Anisotropic Phong BRDF Model", JGT 5(2), 2000: the diffuse term, whose
// strength is what the specular one leaves. The specular term is in half_vector.glsl.

// 1 - (1 - cos/2)^5, multiplied out: no cancellation at grazing.
FN Float ashikhmin_shirley_through(Float cosine) {
    Float u = Float(0.5) * cosine;
    return u * (Float(5) + u * (-Float(10) + u * (Float(10) + u * (-Float(5) + u))));
}

// diffuse and specular: reflectances at normal incidence, in [0, 1]. 0 below the horizon. Under
// constant light it reflects diffuse (1 - specular) (1 - (1 - (n.wo)/2)^5), exactly.
FN Float ashikhmin_shirley_diffuse(Float diffuse, Float specular, Float cos_i, Float cos_o) {
    Float scale = Float(28) / (Float(23) * kPi) * diffuse * (Float(1) - specular);
    Float f = scale * ashikhmin_shirley_through(cos_i) * ashikhmin_shirley_through(cos_o);
    return choose(cos_i > Float(0) && cos_o > Float(0), f, Float(0));
}
