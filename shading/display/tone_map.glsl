// Tone maps: from linear radiance, exposure applied, to what a display shows. Channels >= 0 go in; the
// results of tone_map may exceed 1 (linear) and are clamped by display_color. `kind`: kToneMap... of
// names.glsl.

// Reinhard et al. 2002, on luminance: c / (1 + Y).
FN vec3 tone_map_reinhard(vec3 c) {
    return c * (Float(1) / (Float(1) + luminance(c)));
}

// K. Narkowicz, "ACES Filmic Tone Mapping Curve", 2015, one channel.
FN Float tone_map_aces(Float c) {
    return (c * (Float(2.51) * c + Float(0.03))) / (c * (Float(2.43) * c + Float(0.59)) + Float(0.14));
}

// Khronos PBR Neutral Tone Mapper, specification 1.0 (2024): the offset undoes the 4 % Fresnel floor,
// values beyond the start of compression roll off and lose saturation.
FN vec3 tone_map_khronos_neutral(vec3 c) {
    Float fresnel = Float(0.04);
    Float start = Float(0.8) - fresnel;
    Float low = min(min(c.x, c.y), c.z);
    Float offset = choose(low < Float(2) * fresnel, low - low * low / (Float(4) * fresnel), fresnel);
    vec3 kept = c - vec3(offset, offset, offset);
    // Held at the start: below it the compression is not selected and must not divide by 0.
    Float peak = max(max(max(kept.x, kept.y), kept.z), start);
    Float d = Float(1) - start;
    Float new_peak = Float(1) - d * d / (peak + d - start);
    Float gray = Float(1) - Float(1) / (Float(0.15) * (peak - new_peak) + Float(1));
    vec3 compressed = kept * ((new_peak / peak) * (Float(1) - gray)) +
                      vec3(new_peak, new_peak, new_peak) * gray;
    return choose(peak > start, compressed, kept);
}

FN vec3 tone_map(int kind, vec3 c) {
    vec3 mapped = c;
    if (kind == kToneMapReinhard) {
        mapped = tone_map_reinhard(c);
    } else if (kind == kToneMapAces) {
        mapped = vec3(tone_map_aces(c.x), tone_map_aces(c.y), tone_map_aces(c.z));
    } else if (kind == kToneMapKhronosNeutral) {
        mapped = tone_map_khronos_neutral(c);
    }
    return mapped;
}

// sRGB-encoded, each channel in [0, 1].
FN vec3 display_color(int kind, vec3 radiance) {
    vec3 c = tone_map(kind, radiance);
    return vec3(srgb_from_linear(clamp(c.x, Float(0), Float(1))),
                srgb_from_linear(clamp(c.y, Float(0), Float(1))),
                srgb_from_linear(clamp(c.z, Float(0), Float(1))));
}
