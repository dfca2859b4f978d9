// Reads the closed forms of shading/ with a SIMD register for Float, into the namespace at hand,
// which has defined Scalar. No include guard: once for each precision.
#include "models/batch/mdf_batch_words.hpp"

inline constexpr int kWardNodes = dialect::Precision<Scalar>::ward_nodes;

#include "shading/prelude_begin.hpp"
#undef FN
#undef CONSTANT
#define FN BURNISH_INLINE
#define CONSTANT(name, value) inline constexpr Scalar name = static_cast<Scalar>(value);
// clang-format off
#include "shading/closed_forms.hpp"
#include "shading/prelude_end.hpp"
// clang-format on

BURNISH_INLINE vec3 load(const Scalar* x, const Scalar* y, const Scalar* z, std::size_t row) {
    return {Float::load_unaligned(x + row), Float::load_unaligned(y + row),
            Float::load_unaligned(z + row)};
}

struct RowLobe {
    Lobe lobe;
    Bool grooves_along_x;
};

BURNISH_INLINE RowLobe row_lobe(int mdf, Float p0, Float p1) {
    return {lobe_make(mdf, p0, p1), lobe_grooves_along_x(mdf, p0, p1)};
}

// One register of rows, from `row` on.
template <int mdf, int method>
BURNISH_INLINE void evaluate(const RowLobe& lobe_of_row, bool conserve,
                             const MdfKernelColumns<Scalar>& at, std::size_t row) {
    const vec3 n = load(at.nx, at.ny, at.nz, row);
    const vec3 h = load(at.hx, at.hy, at.hz, row);
    Lobe lobe = lobe_of_row.lobe;
    lobe.mdf = mdf;  // a constant for the compiler
    const Perturbation p = perturb_make(method, n, lobe_of_row.grooves_along_x, Bool(false));
    const Float shape = lobe_shape(lobe, perturb_point(p, h));
    const Float projected = lobe.projected_norm * shape;
    Float conserving = projected;
    if (method == kMethodDeformSmooth && conserve) {
        conserving = projected * deform_smooth_conserving_factor(n);
    }
    conserving.store_unaligned(at.D_conserving + row);
    if (at.D == nullptr) return;
    (lobe.paper_norm * shape).store_unaligned(at.D + row);
    projected.store_unaligned(at.D_proj + row);
}

// The last rows, fewer than a register holds: `evaluate_all` is called for a copy of them, filled up
// with rows whose values are dropped. One function for all distributions and methods, so that their
// closed forms are compiled once less.
inline void evaluate_rest(const MdfKernelCall<Scalar>& call, std::size_t first,
                          void (*evaluate_all)(const MdfKernelCall<Scalar>&)) {
    constexpr std::size_t kLanes = Float::size;
    Scalar in[8][kLanes], out[3][kLanes];
    const MdfKernelColumns<Scalar>& at = call.columns;
    const Scalar* columns[8] = {at.nx, at.ny, at.nz, at.hx, at.hy, at.hz, at.p0, at.p1};
    const std::size_t rest = call.count - first;
    for (std::size_t c = 0; c < 8; ++c) {
        const bool single = c >= 6 && call.one_lobe;
        for (std::size_t i = 0; i < kLanes; ++i) {
            in[c][i] = columns[c][single ? 0 : first + (i < rest ? i : rest - 1)];
        }
    }
    MdfKernelCall<Scalar> copy = call;
    copy.count = kLanes;
    copy.columns = {in[6], in[7], in[0], in[1], in[2], in[3], in[4], in[5], out[0], out[1], out[2]};
    if (at.D == nullptr) copy.columns.D = copy.columns.D_proj = nullptr;
    evaluate_all(copy);
    for (std::size_t i = 0; i < rest; ++i) {
        at.D_conserving[first + i] = out[2][i];
        if (at.D == nullptr) continue;
        at.D[first + i] = out[0][i];
        at.D_proj[first + i] = out[1][i];
    }
}

template <int mdf, int method>
inline void evaluate_all(const MdfKernelCall<Scalar>& call) {
    constexpr std::size_t kLanes = Float::size;
    const MdfKernelColumns<Scalar> at = call.columns;
    const std::size_t whole = call.count - call.count % kLanes;
    if (call.one_lobe && whole > 0) {
        const RowLobe lobe = row_lobe(mdf, Float(*at.p0), Float(*at.p1));
        for (std::size_t row = 0; row < whole; row += kLanes) {
            evaluate<mdf, method>(lobe, call.conserving, at, row);
        }
    } else {
        for (std::size_t row = 0; row < whole; row += kLanes) {
            const RowLobe lobe = row_lobe(mdf, Float::load_unaligned(at.p0 + row),
                                          Float::load_unaligned(at.p1 + row));
            evaluate<mdf, method>(lobe, call.conserving, at, row);
        }
    }
    if (whole < call.count) evaluate_rest(call, whole, &evaluate_all<mdf, method>);
}

template <int mdf>
inline void run_method(const MdfKernelCall<Scalar>& call) {
    switch (call.method) {
        case kMethodNone:
            return evaluate_all<mdf, kMethodNone>(call);
        case kMethodNormalMap:
            return evaluate_all<mdf, kMethodNormalMap>(call);
        case kMethodGramSchmidt:
            return evaluate_all<mdf, kMethodGramSchmidt>(call);
        case kMethodRotateExact:
            return evaluate_all<mdf, kMethodRotateExact>(call);
        case kMethodRotateApprox:
            return evaluate_all<mdf, kMethodRotateApprox>(call);
        case kMethodRotateArc:
            return evaluate_all<mdf, kMethodRotateArc>(call);
        case kMethodFollowGrain:
            return evaluate_all<mdf, kMethodFollowGrain>(call);
        case kMethodDeformLinear:
            return evaluate_all<mdf, kMethodDeformLinear>(call);
        case kMethodSlopeShift:
            return evaluate_all<mdf, kMethodSlopeShift>(call);
        case kMethodStretch:
            return evaluate_all<mdf, kMethodStretch>(call);
        default:
            return evaluate_all<mdf, kMethodDeformSmooth>(call);
    }
}

inline void run(const MdfKernelCall<Scalar>& call) {
    switch (call.mdf) {
        case kMdfAshikhminShirley:
            return run_method<kMdfAshikhminShirley>(call);
        case kMdfWard:
            return run_method<kMdfWard>(call);
        case kMdfBeckmann:
            return run_method<kMdfBeckmann>(call);
        default:
            return run_method<kMdfGgx>(call);
    }
}
