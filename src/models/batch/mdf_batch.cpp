#include "models/batch/mdf_batch.hpp"

#include <array>
#include <stdexcept>

#include "burnish/f64.hpp"
#include "models/batch/mdf_batch_kernels.hpp"

namespace burnish {
namespace {

const MdfKernels& kernels() {
#ifdef BURNISH_HAS_AVX2
    static const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (avx2) return kMdfKernelsAvx2;
#endif
    return kMdfKernelsBaseline;
}

void run(const MdfKernelCall<float>& call) {
    kernels().f32(call);
}
void run(const MdfKernelCall<double>& call) {
    kernels().f64(call);
}

template <typename Float>
void require_equal(std::size_t count, const DirectionColumns<Float>& n,
                   const DirectionColumns<Float>& h) {
    for (const auto& column : {n.x, n.y, n.z, h.x, h.y, h.z}) {
        if (column.size() != count) {
            throw std::invalid_argument("columns of directions differ in length");
        }
    }
}

template <typename Float>
MdfKernelColumns<Float> directions(const DirectionColumns<Float>& n,
                                   const DirectionColumns<Float>& h) {
    MdfKernelColumns<Float> columns{};
    columns.nx = n.x.data();
    columns.ny = n.y.data();
    columns.nz = n.z.data();
    columns.hx = h.x.data();
    columns.hy = h.y.data();
    columns.hz = h.z.data();
    return columns;
}

template <typename Float>
void values(Mdf mdf, Method method, const MdfRows<Float>& rows, const MdfResults<Float>& results) {
    const std::size_t count = results.D.size();
    require_equal(count, rows.n, rows.h);
    const bool equal = rows.p0.size() == count && rows.p1.size() == count &&
                       results.D_proj.size() == count && results.D_conserving.size() == count;
    if (!equal) throw std::invalid_argument("columns of parameters or values differ in length");
    if (count == 0) return;
    MdfKernelColumns<Float> columns = directions(rows.n, rows.h);
    columns.p0 = rows.p0.data();
    columns.p1 = rows.p1.data();
    columns.D = results.D.data();
    columns.D_proj = results.D_proj.data();
    columns.D_conserving = results.D_conserving.data();
    run({static_cast<int>(mdf), static_cast<int>(method), false, true, count, columns});
}

// follow-grain is one of two rotations; which one, a lobe that all rows share decides once.
Method method_of(Method method, bool grooves_along_x) {
    if (method != Method::follow_grain) return method;
    return grooves_along_x ? Method::rotate_exact : Method::gram_schmidt;
}

template <typename Float>
void table(Mdf mdf, Float p0, Float p1, Method method, bool conserving,
           const DirectionColumns<Float>& n, const DirectionColumns<Float>& h, std::span<Float> D) {
    require_equal(D.size(), n, h);
    if (D.empty()) return;
    MdfKernelColumns<Float> columns = directions(n, h);
    columns.p0 = &p0;
    columns.p1 = &p1;
    columns.D_conserving = D.data();
    const int id = static_cast<int>(mdf);
    const bool along_x =
        f64::lobe_grooves_along_x(id, static_cast<double>(p0), static_cast<double>(p1));
    run({id, static_cast<int>(method_of(method, along_x)), true, conserving, D.size(), columns});
}

}  // namespace

void mdf_values(Mdf mdf, Method method, const MdfRows<float>& rows,
                const MdfResults<float>& results) {
    values(mdf, method, rows, results);
}

void mdf_values(Mdf mdf, Method method, const MdfRows<double>& rows,
                const MdfResults<double>& results) {
    values(mdf, method, rows, results);
}

void mdf_table(Mdf mdf, float p0, float p1, Method method, bool conserving,
               const DirectionColumns<float>& n, const DirectionColumns<float>& h,
               std::span<float> D) {
    table(mdf, p0, p1, method, conserving, n, h, D);
}

void mdf_table(Mdf mdf, double p0, double p1, Method method, bool conserving,
               const DirectionColumns<double>& n, const DirectionColumns<double>& h,
               std::span<double> D) {
    table(mdf, p0, p1, method, conserving, n, h, D);
}

std::string_view mdf_batch_instructions() {
    return kernels().instructions;
}

}  // namespace burnish
