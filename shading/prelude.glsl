// The dialect's words for GLSL 3.30 and ES 3.00; prelude.hpp says the same words for C++.
// The #version line and `precision highp float;` come from the program that assembles a stage.
#define Float float
#define Bool bool
#define FN
#define OUT(T) out T
#define CONSTANT(name, value) const float name = float(value);

float choose(bool condition, float a, float b) { return condition ? a : b; }
vec3 choose(bool condition, vec3 a, vec3 b) { return condition ? a : b; }

// ln(1 - x), x <= 1/2: -2 atanh(x / (2 - x)) by its series; 7 terms are good to 3e-8 relative.
float log1m(float x) {
    float y = x / (2.0 - x);
    float w = y * y;
    float series =
        1.0 +
        w * (1.0 / 3.0 +
             w * (1.0 / 5.0 + w * (1.0 / 7.0 + w * (1.0 / 9.0 + w * (1.0 / 11.0 + w / 13.0)))));
    return -2.0 * y * series;
}

// Where `near`, ln(1 - x), x <= 1/2; elsewhere ln(y), y > 0. The batched build takes one logarithm.
float log1m_or_log(bool near, float x, float y) { return near ? log1m(x) : log(y); }

// The angle from 0 to pi of this sine (at least 0) and cosine, times any length: within 1e-7, where atan() may be
// wrong by 1e-4 on some devices. The polynomial interpolates atan(sqrt z)/sqrt z at the Chebyshev points of [0, 1].
float angle_of(float sine, float cosine) {
    float c = abs(cosine);
    float t = min(sine, c) / max(max(sine, c), 1e-30);
    float z = t * t;
    float p = 0.999999882 + z * (-0.333318127 + z * (0.199669618 + z * (-0.140032902 +
              z * (0.0986886546 + z * (-0.0588297531 + z * (0.0237805186 - z * 0.00455979199))))));
    float angle = t * p;
    angle = sine > c ? 1.57079633 - angle : angle;
    return cosine < 0.0 ? 3.14159265 - angle : angle;
}

// Abramowitz & Stegun 7.1.26, absolute error 1.5e-7 for x >= 0 (only used there).
float erfc(float x) {
    float t = 1.0 / (1.0 + 0.3275911 * x);
    return t *
           (0.254829592 +
            t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429)))) *
           exp(-x * x);
}

// Nodes of the Ward normaliser: 2e-5 relative to alpha = 1 (mdf/ward.glsl).
const int kWardNodes = 4;
// Steps of deform_smooth_forward: within 1e-5 of the root for all but one in 1e5 (worst 5e-4).
const int kDeformRootSteps = 10;

// Cosines that BRDFs divide by are held above the one, values and densities below the other: nothing
// becomes infinite at the horizon. 1e-12 is below any cosine that is not rounding.
const float kLeastCosine = 1e-12;
const float kMostValue = 1e30;
