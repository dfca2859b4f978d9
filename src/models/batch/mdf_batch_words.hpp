// The dialect's words for registers of numbers, into the namespace at hand, which has defined
// Scalar. No include guard: once for each precision. They stand beside the templates of
// prelude.hpp so that a scalar constant next to a register is broadcast, and xsimd has the rest.
//
// Stated errors, relative, u = 2^-24 in float and 2^-53 in double (tests/shading/mdf_batch_oracle_test.cpp
// holds the values made of them against the oracle): log1m_or_log 4 u; exp in float
// (2 + |x|/2) u for x >= -86.9, below which values of less than 2^-125 may be 0, and infinity from
// 88.3 on. exp in double is xsimd's.
using Float = xsimd::batch<Scalar>;
using Bool = xsimd::batch_bool<Scalar>;
using vec2 = dialect::Vec2<Float>;
using vec3 = dialect::Vec3<Float>;
using dialect::cross;
using dialect::dot;
using dialect::normalize;

BURNISH_INLINE Float min(Float a, Float b) {
    return xsimd::min(a, b);
}
BURNISH_INLINE Float max(Float a, Float b) {
    return xsimd::max(a, b);
}
BURNISH_INLINE Float choose(Bool condition, Float a, Float b) {
    return xsimd::select(condition, a, b);
}
BURNISH_INLINE vec3 choose(Bool condition, vec3 a, vec3 b) {
    return {choose(condition, a.x, b.x), choose(condition, a.y, b.y), choose(condition, a.z, b.z)};
}

// IEEE numbers as integers.
struct Layout {
    static constexpr bool kIsDouble = sizeof(Scalar) == sizeof(double);
    using Integer = std::conditional_t<kIsDouble, std::uint64_t, std::uint32_t>;
    static constexpr int kFractionBits = kIsDouble ? 52 : 23;
    static constexpr Integer kFraction = (Integer{1} << kFractionBits) - 1;
    static constexpr Integer kOne = static_cast<Integer>(kIsDouble ? 1023 : 127) << kFractionBits;
    // sqrt(1/2): where the series of the logarithm reaches equally far from 1, to both sides.
    static constexpr Integer kRootHalf =
        static_cast<Integer>(kIsDouble ? 0x3fe6a09e667f3bcd : 0x3f3504f3);
    // 2^kFractionBits: an integer in its last bits is the number above it.
    static constexpr Integer kAboveIntegers = static_cast<Integer>(kIsDouble ? 1023 + 52 : 127 + 23)
                                              << kFractionBits;
};
using Integers = xsimd::batch<Layout::Integer>;

BURNISH_INLINE Integers bits_of(Float x) {
    return xsimd::bitwise_cast<Integers>(x);
}
BURNISH_INLINE Float float_of(Integers bits) {
    return xsimd::bitwise_cast<Float>(bits);
}

// (2 atanh(s)/s - 2) / s^2 in w = s^2 <= 1/9, least maximum error: 3e-7 in float, 9e-17 in double,
// of which a logarithm sees w/2.
BURNISH_INLINE Float atanh_series(Float w) {
    if constexpr (Layout::kIsDouble) {
        Float q = Float(0.16164938169471337);
        q = xsimd::fma(q, w, Float(0.08800317650868774));
        q = xsimd::fma(q, w, Float(0.12001155182857778));
        q = xsimd::fma(q, w, Float(0.13314135550881163));
        q = xsimd::fma(q, w, Float(0.15385570592912244));
        q = xsimd::fma(q, w, Float(0.18181789417326448));
        q = xsimd::fma(q, w, Float(0.22222222717801782));
        q = xsimd::fma(q, w, Float(0.28571428567105061));
        q = xsimd::fma(q, w, Float(0.40000000000014597));
        return xsimd::fma(q, w, Float(0.66666666666666659));
    } else {
        Float q = Float(0.26852027f);
        q = xsimd::fma(q, w, Float(0.28236547f));
        q = xsimd::fma(q, w, Float(0.40007563f));
        return xsimd::fma(q, w, Float(0.66666640f));
    }
}

// One logarithm for both: ln(2^k (1 + f)) = k ln 2 + 2 atanh(f / (2 + f)), where y = 2^k (1 + f)
// with f from sqrt(1/2) - 1 to sqrt(2) - 1, and 1 - x is taken as it is, without a rounding of it.
// y is normal and positive.
BURNISH_INLINE Float log1m_or_log(Bool near, Float x, Float y) {
    const Integers above = bits_of(y) + Integers(Layout::kOne - Layout::kRootHalf);
    const Float mantissa =
        float_of((above & Integers(Layout::kFraction)) + Integers(Layout::kRootHalf));
    const Float exponent =
        float_of((above >> Layout::kFractionBits) | Integers(Layout::kAboveIntegers)) -
        float_of(Integers(Layout::kAboveIntegers | (Layout::kOne >> Layout::kFractionBits)));
    const Float k = choose(near, Float(0), exponent);
    const Float f = choose(near, -x, mantissa - Float(1));
    const Float s = f / (Float(2) + f);
    const Float w = s * s;
    const Float log_mantissa = xsimd::fma(s * w, atanh_series(w), s + s);
    return xsimd::fma(k, Float(static_cast<Scalar>(0.69314718055994531)), log_mantissa);
}

// e^x = 2^n 2^r, |r| <= 1/2. n is read off the last bits of 1.5 2^23 + n, and 2^n made from them:
// its exponent is 0, and so is the value, for n = -127, and that of infinity for n = 128.
BURNISH_INLINE Float exp(Float x) {
    if constexpr (Layout::kIsDouble) {
        return xsimd::exp(x);
    } else {
        const Float log2_e = Float(1.44269504f), shift = Float(12582912.0f);
        // In this order NaN stays NaN.
        x = xsimd::min(Float(88.8f), xsimd::max(Float(-88.0f), x));
        const Float shifted = xsimd::fma(x, log2_e, shift);
        const Float r = xsimd::fms(x, log2_e, shifted - shift);
        Float p = Float(1.5453362e-4f);  // least maximum error of 2^r on |r| <= 1/2: 4e-9
        p = xsimd::fma(p, r, Float(1.3391093e-3f));
        p = xsimd::fma(p, r, Float(9.6180822e-3f));
        p = xsimd::fma(p, r, Float(5.5503567e-2f));
        p = xsimd::fma(p, r, Float(0.24022651f));
        p = xsimd::fma(p, r, Float(0.69314719f));
        p = xsimd::fma(p, r, Float(1));
        return p * float_of((bits_of(shifted) << Layout::kFractionBits) + Integers(Layout::kOne));
    }
}
