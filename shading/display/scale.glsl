// Numbers as colors: linear colors that a display encodes to the sRGB values that are named here.

// Linear color that a display encodes to `encoded`.
FN vec3 shown_as(vec3 encoded) {
    return vec3(linear_from_srgb(clamp(encoded.x, Float(0), Float(1))),
                linear_from_srgb(clamp(encoded.y, Float(0), Float(1))),
                linear_from_srgb(clamp(encoded.z, Float(0), Float(1))));
}

FN vec3 color_between(vec3 a, vec3 b, Float share) { return a * (Float(1) - share) + b * share; }

// From dark blue (0) by blue-green to light yellow (1): lightness rises all the way, so that the
// scale reads in gray and to color-blind eyes.
FN vec3 color_of_number(Float number) {
    Float x = clamp(number, Float(0), Float(1)) * Float(3);
    vec3 low = color_between(vec3(Float(0.10), Float(0.07), Float(0.28)),
                             vec3(Float(0.13), Float(0.36), Float(0.55)),
                             clamp(x, Float(0), Float(1)));
    vec3 high = color_between(vec3(Float(0.24), Float(0.66), Float(0.53)),
                              vec3(Float(0.98), Float(0.95), Float(0.60)),
                              clamp(x - Float(2), Float(0), Float(1)));
    return shown_as(color_between(low, high, clamp(x - Float(1), Float(0), Float(1))));
}

// An estimate of an albedo of 1 may be above it by noise: six standard errors of 1,024 draws, of a method that
// keeps energy (tests/viewer/albedo_view_test.cpp).
CONSTANT(kAlbedoNoise, 0.01)

// By the channel that reflects most. Up to 1 the gray whose encoded value is the albedo. Above it light
// red, which is darker and purer the more energy is gained, up to an albedo of 2. The square root tells
// small gains apart.
FN vec3 color_of_albedo(vec3 albedo) {
    Float most = max(max(albedo.x, albedo.y), albedo.z);
    Float gain = sqrt(clamp(most - Float(1), Float(0), Float(1)));
    vec3 red = color_between(vec3(Float(1), Float(0.62), Float(0.55)),
                             vec3(Float(0.65), Float(0), Float(0)), gain);
    return shown_as(choose(most > Float(1) + kAlbedoNoise, red, vec3(most, most, most)));
}
