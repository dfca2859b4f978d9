#include "capture/point_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burnish {

namespace {

// By how much a turn that is a column off may be worse than it will be.
constexpr float kHopeless = 4.0f;

struct Strengths {
    double diffuse = 0.0, specular = 0.0;
    double error = 0.0;  // weighted sum of squares
};

// min over d, s >= 0 of |y - d u - s v|^2 from its sums.
Strengths solve_strengths(double uu, double uv, double vv, double uy, double vy, double yy) {
    const double determinant = uu * vv - uv * uv;
    double d = 0.0, s = 0.0;
    // Below this the two are one to rounding: all is diffuse.
    if (determinant > 1e-9 * uu * vv) {
        d = (uy * vv - vy * uv) / determinant;
        s = (vy * uu - uy * uv) / determinant;
    } else {
        s = -1.0;
    }
    if (s < 0.0) {
        s = 0.0;
        d = uu > 0.0 ? std::max(uy / uu, 0.0) : 0.0;
    } else if (d < 0.0) {
        d = 0.0;
        s = vv > 0.0 ? std::max(vy / vv, 0.0) : 0.0;
    }
    const double error = yy - 2.0 * (d * uy + s * vy) + d * d * uu + 2.0 * d * s * uv + s * s * vv;
    return {d, s, std::max(error, 0.0)};
}

}  // namespace

PointFitter::PointFitter(const PointSamples& samples, float eta) : samples_(&samples) {
    double mean = 0.0;
    for (const float v : samples.value) mean += static_cast<double>(v);
    mean /= std::max<double>(1.0, static_cast<double>(samples.size()));
    const auto floor = static_cast<float>(mean);
    RelativeFresnel(eta).of(samples.cosine_ih, fresnel_);
    for (auto* sums : {&weights_, &uv_, &vv_, &vy_}) sums->resize(samples.size());
    for (std::size_t q = 0; q < samples.size(); ++q) {
        // A point that is black under every light says nothing.
        const float scale = floor > 1e-18f ? 1.0f / (samples.value[q] + floor) : 0.0f;
        weights_[q] = scale * scale;
        // With u = received / pi and v = received b, the sums' terms but for b.
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
    const float turn = area_shift(tables.grid, shift);
    const float area_out = area_at(tables.areas, samples_->out, samples_->to_eye[2], turn);
    double uv = 0.0, vv = 0.0, vy = 0.0;
    for (std::size_t q = 0; q < samples_->size(); ++q) {
        const float area_in =
            area_at(tables.areas, samples_->in[q], samples_->to_light[q][2], turn);
        // b without 1 / (4 g(o)), which all samples share.
        const float b =
            fresnel_[q] * lookup(tables.grid, tables.D, samples_->half[q], shift) / area_in;
        uv += static_cast<double>(uv_[q] * b);
        vv += static_cast<double>(vv_[q] * b * b);
        vy += static_cast<double>(vy_[q] * b);
    }
    const double shared = 0.25 / static_cast<double>(area_out);
    const Strengths best =
        solve_strengths(uu_, shared * uv, shared * shared * vv, uy_, shared * vy, value_square_);
    PointFit fit;
    fit.shift = shift;
    fit.diffuse = static_cast<float>(best.diffuse);
    fit.specular = static_cast<float>(best.specular);
    fit.error = value_square_ > 0.0 ? static_cast<float>(best.error / value_square_) : 0.0f;
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

void PointFitter::colours(const ExemplarTables& tables, float shift, std::array<float, 3>& diffuse,
                          std::array<float, 3>& specular) const {
    const float area_out =
        area_at(tables.areas, samples_->out, samples_->to_eye[2], area_shift(tables.grid, shift));
    std::vector<float> shape(samples_->size());
    for (std::size_t q = 0; q < shape.size(); ++q)
        shape[q] = specular_shape(tables, *samples_, q, shift, fresnel_[q], area_out);
    for (std::size_t c = 0; c < 3; ++c) {
        double uu = 0.0, uv = 0.0, vv = 0.0, uy = 0.0, vy = 0.0, yy = 0.0;
        for (std::size_t q = 0; q < shape.size(); ++q) {
            const float w = weights_[q], y = samples_->value_rgb[c][q];
            const float u = samples_->weight_rgb[c][q] * std::numbers::inv_pi_v<float>;
            const float v = samples_->weight_rgb[c][q] * shape[q];
            uu += static_cast<double>(w * u * u);
            uv += static_cast<double>(w * u * v);
            vv += static_cast<double>(w * v * v);
            uy += static_cast<double>(w * u * y);
            vy += static_cast<double>(w * v * y);
            yy += static_cast<double>(w * y * y);
        }
        const Strengths best = solve_strengths(uu, uv, vv, uy, vy, yy);
        diffuse[c] = static_cast<float>(best.diffuse);
        specular[c] = static_cast<float>(best.specular);
    }
}

}  // namespace burnish
