// Lights with an area: their outlines as seen from a point, and the edges that irradiance is summed over.
// docs/theory/area-lights.md.

// Light from a polygon seen from the origin is a sum over its edges (Lambert 1760): the cosine's share of the
// polygon is the sum's z over 2 pi.

// The angle between a and b times the unit vector along a x b.
FN vec3 edge_light(vec3 a, vec3 b) {
    vec3 normal = cross(a, b);
    Float sine = sqrt(dot(normal, normal));
    // Without a sine the edge is a point, or the light contains the origin: nothing is added.
    return normal * (angle_of(sine, dot(a, b)) / max(sine, kTiny));
}

// Where the edge has height 0.
FN vec3 edge_crossing(vec3 a, vec3 b, Float height_a, Float height_b) {
    Float fall = height_a - height_b;
    return a + (b - a) * (height_a / choose(abs(fall) > kTiny, fall, kTiny));
}

// ---- shapes -----------------------------------------------------------------------------------------

// Kinds of lights with an area.
const int kAreaRectangle = 0;
const int kAreaDisc = 1;
const int kAreaTube = 2;

// A light as seen from a point: the middle and half the sides of the rectangle, or of the rectangle around the
// ellipse, that emits towards it.
struct AreaLight {
    vec3 middle;  // from the point
    vec3 x;
    vec3 y;
    Float lit;  // 1 where the emitting side faces the point, else 0
};

// Corners of the polygon that stands for an ellipse, and how far outside the ellipse they lie: the area is the
// same. Its irradiance is within 1 % from a fifth of the radius on (tests/shading/area_light_test.cpp).
const int kDiscCorners = 8;
CONSTANT(kDiscReach, 1.0539073652554058)
CONSTANT(kDiscTurn, 0.70710678118654752)  // cosine and sine of an eighth of a turn

FN int area_corners(int shape) { return shape == kAreaDisc ? kDiscCorners : 4; }

// Where corner 0 lies, in half sides, and from corner to corner the turn (cosine, sine).
FN vec2 area_first_corner(int shape) {
    Float reach = choose(shape == kAreaDisc, kDiscReach, Float(1));
    return vec2(reach, choose(shape == kAreaDisc, Float(0), reach));
}

FN vec2 area_corner_turn(int shape) {
    return vec2(choose(shape == kAreaDisc, kDiscTurn, Float(0)), choose(shape == kAreaDisc, kDiscTurn, Float(1)));
}

FN vec2 area_next_corner(vec2 place, vec2 turn) {
    return vec2(place.x * turn.x - place.y * turn.y, place.x * turn.y + place.y * turn.x);
}

// A place in the square of half sides as one in the disc: squares about the middle become circles, and equal areas
// stay equal (Shirley & Chiu 1997).
FN vec2 disc_place(vec2 square) {
    Bool wide = abs(square.x) > abs(square.y);
    Float r = choose(wide, square.x, square.y);
    Float ratio = choose(wide, square.y, square.x) / choose(abs(r) > kTiny, r, kTiny);
    Float turn = ratio * (kPi / Float(4));
    return vec2(r * choose(wide, cos(turn), sin(turn)), r * choose(wide, sin(turn), cos(turn)));
}

FN vec3 area_corner(AreaLight light, vec2 place) {
    return light.middle + light.x * place.x + light.y * place.y;
}

// How far before the axis the side that a point sees lies in the mean, in radii: pi/4.
CONSTANT(kTubeFront, 0.78539816339744831)

// A tube shows a point the same outline as a rectangle along its axis, wider than the tube the nearer the point
// is: exact but for its ends, which are straight instead of round. `axis`: half the length; `middle`: from the point.
FN AreaLight tube_seen(vec3 middle, vec3 axis, Float radius) {
    Float axis2 = max(dot(axis, axis), kTiny);
    vec3 away = middle - axis * (dot(middle, axis) / axis2);
    Float d2 = dot(away, away);
    // Within the tube there is no light. 1e-6 r^2: the outline for a point on it is a plane.
    Float outside2 = d2 - radius * radius;
    Float half_width = radius * sqrt(d2 / max(outside2, Float(1e-6) * radius * radius + kTiny));
    vec3 across = cross(away, axis);
    Float front = kTubeFront * radius / sqrt(max(d2, kTiny));
    AreaLight light;
    light.middle = middle - away * front;
    light.x = axis;
    light.y = across * (half_width * (Float(1) - front) / sqrt(max(dot(across, across), kTiny)));
    light.lit = choose(outside2 > Float(0), Float(1), Float(0));
    return light;
}

// `middle`: from the point; `x`, `y`: half the sides; of a tube half its axis, and `y` as long as its radius.
FN AreaLight area_light_seen(int shape, vec3 middle, vec3 x, vec3 y, Bool two_sided) {
    AreaLight light;
    if (shape == kAreaTube) {
        light = tube_seen(middle, x, sqrt(dot(y, y)));
    } else {
        // x cross y points to the side that emits.
        Float front = -dot(cross(x, y), middle);
        light.middle = middle;
        light.x = x;
        light.y = y;
        light.lit = choose(front > Float(0) || (two_sided && front < Float(0)), Float(1), Float(0));
    }
    return light;
}

// Irradiance of a surface with the normal n over pi and the radiance: 0 to 1.
FN Float area_cosine(AreaLight light, int shape, vec3 n) {
    vec2 place = area_first_corner(shape);
    vec2 turn = area_corner_turn(shape);
    vec3 none = vec3(Float(0), Float(0), Float(0));
    vec3 leaves = none;
    vec3 enters = none;
    vec3 sum = none;
    vec3 a = area_corner(light, place);
    Float height_a = dot(n, a);
    int corners = area_corners(shape);
    for (int i = 0; i < corners; ++i) {
        place = area_next_corner(place, turn);
        vec3 b = area_corner(light, place);
        Float height_b = dot(n, b);
        Bool above_a = height_a > Float(0);
        Bool above_b = height_b > Float(0);
        vec3 crossing = edge_crossing(a, b, height_a, height_b);
        leaves = choose(above_a && !above_b, crossing, leaves);
        enters = choose(!above_a && above_b, crossing, enters);
        vec3 light_of_edge = edge_light(choose(above_a, a, crossing), choose(above_b, b, crossing));
        sum = sum + light_of_edge * choose(above_a || above_b, Float(1), Float(0));
        a = b;
        height_a = height_b;
    }
    sum = sum + edge_light(leaves, enters);
    return abs(dot(n, sum)) * light.lit / (Float(2) * kPi);
}
