// The table of the model's albedos: shading/brdf/albedo.glsl says what it holds.

uniform sampler3D u_albedo;

float albedo_at(AlbedoPlace place) {
    vec3 nodes = vec3(textureSize(u_albedo, 0));
    return albedo_value(place, textureLod(u_albedo, (place.at * (nodes - 1.0) + 0.5) / nodes, 0.0).rgb);
}
