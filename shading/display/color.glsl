// Linear Rec. 709 color and its sRGB encoding (IEC 61966-2-1). Channels are in [0, 1] where the encoding
// is applied; luminance takes any.

FN Float luminance(vec3 rgb) {
    return Float(0.2126) * rgb.x + Float(0.7152) * rgb.y + Float(0.0722) * rgb.z;
}

FN Float srgb_from_linear(Float linear) {
    Float power = pow(max(linear, Float(0)), Float(1) / Float(2.4));
    return choose(linear <= Float(0.0031308), Float(12.92) * linear,
                  Float(1.055) * power - Float(0.055));
}

FN Float linear_from_srgb(Float encoded) {
    Float base = (max(encoded, Float(0)) + Float(0.055)) / Float(1.055);
    return choose(encoded <= Float(0.04045), encoded / Float(12.92), pow(base, Float(2.4)));
}
