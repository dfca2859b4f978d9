// The dialect's words for C++: Float, Bool, FN, OUT, choose and tiny vectors, so that the texts of
// this folder, which are GLSL, also compile as C++ in float and in double (include/burnish/f32.hpp,
// f64.hpp). prelude.glsl says the same words for GLSL. docs/develop/architecture.md, "One text".
#pragma once

#include <algorithm>
#include <cmath>

namespace burnish::dialect {

template <typename Float>
struct Vec2 {
    Float x{}, y{};
    constexpr Vec2() = default;
    constexpr Vec2(Float x_, Float y_) : x(x_), y(y_) {}
};

template <typename Float>
struct Vec3 {
    Float x{}, y{}, z{};
    constexpr Vec3() = default;
    constexpr Vec3(Float x_, Float y_, Float z_) : x(x_), y(y_), z(z_) {}
    // From a vector of another library or precision: anything with x, y and z.
    template <typename Other>
    requires requires(const Other& v) { v.x, v.y, v.z; }
    constexpr explicit Vec3(const Other& v)
        : x(static_cast<Float>(v.x)), y(static_cast<Float>(v.y)), z(static_cast<Float>(v.z)) {}
    friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    friend constexpr Vec3 operator*(Vec3 a, Float s) { return {a.x * s, a.y * s, a.z * s}; }
    friend constexpr Vec3 operator*(Float s, Vec3 a) { return a * s; }
    friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
};

using std::abs;
using std::cos;
using std::exp;
using std::floor;
using std::log;
using std::pow;
using std::sin;
using std::sqrt;

template <typename Float>
Float atan(Float y, Float x) {
    return std::atan2(y, x);
}
template <typename Float>
Float min(Float a, Float b) {
    return b < a ? b : a;
}
template <typename Float>
Float max(Float a, Float b) {
    return a < b ? b : a;
}
template <typename Float>
Float clamp(Float v, Float low, Float high) {
    return min(max(v, low), high);
}
template <typename Float>
Float mix(Float a, Float b, Float t) {
    return a * (Float(1) - t) + b * t;
}
template <typename Float>
Float dot(Vec3<Float> a, Vec3<Float> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <typename Float>
Vec3<Float> cross(Vec3<Float> a, Vec3<Float> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <typename Float>
Float length(Vec3<Float> a) {
    return sqrt(dot(a, a));
}
template <typename Float>
Vec3<Float> normalize(Vec3<Float> a) {
    return a * (Float(1) / length(a));
}

// The angle from 0 to pi of this sine (at least 0) and cosine, times any length.
template <typename Float>
Float angle_of(Float sine, Float cosine) {
    return std::atan2(sine, cosine);
}

// Selects, never branches: per lane in the batched build.
template <typename T>
T choose(bool condition, T a, T b) {
    return condition ? a : b;
}

// ln(1 - x) without the loss of 1 - x for small x; x <= 1.
template <typename Float>
Float log1m(Float x) {
    return std::log1p(-x);
}
// Where `near`, ln(1 - x), x <= 1/2; elsewhere ln(y), y > 0. The batched build takes one logarithm.
template <typename Float>
Float log1m_or_log(bool near, Float x, Float y) {
    return near ? log1m(x) : std::log(y);
}
template <typename Float>
Float erfc(Float x) {
    return std::erfc(x);
}

}  // namespace burnish::dialect
