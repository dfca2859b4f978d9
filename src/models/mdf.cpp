#include "burnish/mdf.hpp"

#include <array>
#include <cmath>

#include "burnish/f32.hpp"
#include "burnish/f64.hpp"

namespace burnish {
namespace {

constexpr std::array<ShapeParameter, 2> kExponents = {
    {{"e_x", 0.0, kMostExponent}, {"e_y", 0.0, kMostExponent}}};
constexpr std::array<ShapeParameter, 2> kAlphas = {
    {{"alpha_x", kLeastAlpha, kMostAlpha}, {"alpha_y", kLeastAlpha, kMostAlpha}}};

// `lobe` and `point` are of one precision's namespace, whose functions are found through them.
template <typename Lobe, typename Perturbation, typename Float>
MdfValues<Float> values_of(const Lobe& lobe, const Perturbation& as_published, Float conserving,
                           Direction<Float> h) {
    const Float shape = lobe_shape(lobe, perturb_point(as_published, h));
    const Float projected = lobe.projected_norm * shape;
    return {lobe.paper_norm * shape, projected, projected * conserving};
}

template <typename Float>
bool make_unit_in(Direction<Float>& v) {
    const Float largest = std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
    if (!(largest > Float(0))) return false;
    // A power of two: squares neither overflow nor vanish, and no digit of a component changes.
    const int exponent = std::ilogb(largest);
    if (exponent != 0) {
        v = {std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)};
    }
    const Float length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    v = {v.x / length, v.y / length, v.z / length};
    return true;
}

}  // namespace

std::span<const ShapeParameter> mdf_parameters(Mdf mdf) {
    return mdf == Mdf::ashikhmin_shirley ? kExponents : kAlphas;
}

MdfValues<float> mdf_values(Mdf mdf, float p0, float p1, Method method, Direction<float> n,
                            Direction<float> h) {
    const int id = static_cast<int>(mdf);
    const bool along_x = f32::lobe_grooves_along_x(id, p0, p1);
    const float conserving =
        method == Method::deform_smooth ? f32::deform_smooth_conserving_factor(n) : 1.0f;
    return values_of(f32::lobe_make(id, p0, p1),
                     f32::perturb_make(static_cast<int>(method), n, along_x, false), conserving, h);
}

MdfValues<double> mdf_values(Mdf mdf, double p0, double p1, Method method, Direction<double> n,
                             Direction<double> h) {
    const int id = static_cast<int>(mdf);
    const bool along_x = f64::lobe_grooves_along_x(id, p0, p1);
    const double conserving =
        method == Method::deform_smooth ? f64::deform_smooth_conserving_factor(n) : 1.0;
    return values_of(f64::lobe_make(id, p0, p1),
                     f64::perturb_make(static_cast<int>(method), n, along_x, false), conserving, h);
}

bool make_unit(Direction<float>& v) {
    return make_unit_in(v);
}

bool make_unit(Direction<double>& v) {
    return make_unit_in(v);
}

}  // namespace burnish
