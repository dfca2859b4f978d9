#include "capture/solve/point_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "burnish/f64.hpp"
#include "capture/model/strengths.hpp"

namespace burnish {

namespace {

// Largest ratio of the errors before and after a search for the best rotation. A start one column
// off has a smaller ratio; starts with a larger ratio are skipped.
constexpr float kHopeless = 4.0f;

}  // namespace

PointFitter::PointFitter(const PointSamples& samples, float eta) : samples_(&samples) {
    double mean = 0.0;
    for (const float v : samples.value) mean += static_cast<double>(v);
    mean /= std::max<double>(1.0, static_cast<double>(samples.size()));
    const auto floor = static_cast<float>(mean);
    RelativeFresnel(eta).of(samples.cosine_ih, fresnel_);
    for (auto* sums : {&weights_, &uv_, &vv_, &vy_}) sums->resize(samples.size());
    for (std::size_t q = 0; q < samples.size(); ++q) {
        // A point that is black under every light has weight 0: nothing can be fitted to it.
        const float scale = floor > 1e-18f ? 1.0f / (samples.value[q] + floor) : 0.0f;
        weights_[q] = scale * scale;
        // The terms of the normal equations without b, for u = received / pi and v = received b.
        const float u = samples.received[q] * std::numbers::inv_pi_v<float>;
        uv_[q] = weights_[q] * u * samples.received[q];
        vv_[q] = weights_[q] * samples.received[q] * samples.received[q];
        vy_[q] = weights_[q] * samples.received[q] * samples.value[q];
        uu_ += static_cast<double>(weights_[q] * u * u);
        uy_ += static_cast<double>(weights_[q] * u * samples.value[q]);
        value_square_ += static_cast<double>(weights_[q] * samples.value[q] * samples.value[q]);
    }
}

PointFit PointFitter::at(const ExemplarTables& tables, float shift) const {
    const float rotation = area_shift(tables.grid, shift);
    const float area_out = area_at(tables.areas, samples_->out, samples_->to_eye[2], rotation);
    double uv = 0.0, vv = 0.0, vy = 0.0;
    for (std::size_t q = 0; q < samples_->size(); ++q) {
        const float area_in =
            area_at(tables.areas, samples_->in[q], samples_->to_light[q][2], rotation);
        // All samples share g(o). Passing 1/4 as g(o) gives b = F D / g(i); the sums are multiplied
        // by 1 / (4 g(o)) once.
        const float b = f32::area_brdf(
            fresnel_[q] * lookup(tables.grid, tables.D, samples_->half[q], shift), area_in, 0.25f);
        uv += static_cast<double>(uv_[q] * b);
        vv += static_cast<double>(vv_[q] * b * b);
        vy += static_cast<double>(vy_[q] * b);
    }
    const double shared = f64::area_brdf(1.0, 1.0, static_cast<double>(area_out));
    uv *= shared;
    vv *= shared * shared;
    vy *= shared;
    const auto [d, s] = solve_strengths(uu_, uv, vv, uy_, vy);
    const double error =
        value_square_ - 2.0 * (d * uy_ + s * vy) + d * d * uu_ + 2.0 * d * s * uv + s * s * vv;
    PointFit fit;
    fit.shift = shift;
    fit.diffuse = static_cast<float>(d);
    fit.specular = static_cast<float>(s);
    if (value_square_ > 0.0) fit.error = static_cast<float>(std::max(error, 0.0) / value_square_);
    return fit;
}

PointFit PointFitter::refined(const ExemplarTables& tables, float shift, float width,
                              float give_up) const {
    PointFit best = at(tables, shift);
    const PointFit opposite = at(tables, shift + 0.5f * static_cast<float>(tables.grid.azimuths));
    if (opposite.error < best.error) best = opposite;
    if (best.error > kHopeless * give_up) return best;
    return descend(tables, best, width, give_up);
}

PointFit PointFitter::nearby(const ExemplarTables& tables, float shift, float width) const {
    return descend(tables, at(tables, shift), width, 1e30f);
}

PointFit PointFitter::descend(const ExemplarTables& tables, PointFit best, float width,
                              float give_up) const {
    for (float step = width; step > 0.02f; step *= 0.25f) {
        const PointFit before = at(tables, best.shift - step),
                       after = at(tables, best.shift + step);
        const float bend = before.error - 2.0f * best.error + after.error;
        float to = best.shift;
        if (bend > 0.0f)
            to += step * std::clamp(0.5f * (before.error - after.error) / bend, -1.0f, 1.0f);
        for (const PointFit& trial : {before, after})
            if (trial.error < best.error) best = trial;
        if (std::abs(to - best.shift) > 0.01f * step) {
            const PointFit trial = at(tables, to);
            if (trial.error < best.error) best = trial;
        }
        if (best.error > give_up) break;
    }
    return best;
}

void PointFitter::colors(const ExemplarTables& tables, float shift, std::array<float, 3>& diffuse,
                         std::array<float, 3>& specular) const {
    const float area_out =
        area_at(tables.areas, samples_->out, samples_->to_eye[2], area_shift(tables.grid, shift));
    std::vector<float> shape(samples_->size());
    for (std::size_t q = 0; q < shape.size(); ++q)
        shape[q] = specular_shape(tables, *samples_, q, shift, fresnel_[q], area_out);
    for (std::size_t c = 0; c < 3; ++c) {
        double uu = 0.0, uv = 0.0, vv = 0.0, uy = 0.0, vy = 0.0;
        for (std::size_t q = 0; q < shape.size(); ++q) {
            const float w = weights_[q], y = samples_->value_rgb[c][q];
            const float u = samples_->weight_rgb[c][q] * std::numbers::inv_pi_v<float>;
            const float v = samples_->weight_rgb[c][q] * shape[q];
            uu += static_cast<double>(w * u * u);
            uv += static_cast<double>(w * u * v);
            vv += static_cast<double>(w * v * v);
            uy += static_cast<double>(w * u * y);
            vy += static_cast<double>(w * v * y);
        }
        const Strengths best = solve_strengths(uu, uv, vv, uy, vy);
        diffuse[c] = static_cast<float>(best.diffuse);
        specular[c] = static_cast<float>(best.specular);
    }
}

}  // namespace burnish
