#include "capture/solve/exemplar_solve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace burnish {

namespace {

// Weight of the smoothness term relative to the mean diagonal of the equations: enough to bridge
// cells without samples, too little to change cells with samples (tests/capture).
constexpr double kSmoothness = 2e-3;
// Ratio of a cell's diagonal to the mean diagonal below which samples do not determine the cell:
// that of the smoothness term.
constexpr double kLeastShare = 2e-3;
// Upper bound of conjugate gradient steps; usual tables need a few dozen.
constexpr int kMostSteps = 200;
// Ratio of the squared norms of the residual and the right side at which the steps end: tables are
// single precision.
constexpr double kLeastStep = 1e-8;
// Damping of SlideAlong: share of the light of `mimic` that no diffuse light imitates. Stacks of 100
// and more lights have shares of 0.03 to 0.1. In 25 lights a table imitates diffuse light to a share
// of 1e-8, and the step without damping is that of the noise, many times the table.
constexpr double kSlideDamping = 1e-3;

std::size_t at(const NdfGrid& grid, int ring, int column) {
    const int c = (column % grid.azimuths + grid.azimuths) % grid.azimuths;
    return static_cast<std::size_t>(ring * grid.azimuths + c);
}

// The next cell inwards; for the innermost ring, the one across the pole.
std::size_t inwards(const NdfGrid& grid, int ring, int column) {
    return ring > 0 ? at(grid, ring - 1, column) : at(grid, 0, column + grid.azimuths / 2);
}

}  // namespace

TableEquations::TableEquations(const NdfGrid& grid)
    : grid_(grid),
      diagonal_(static_cast<std::size_t>(grid.cells()), 0.0),
      right_(diagonal_),
      next_ring_(diagonal_),
      next_ring_right_(diagonal_),
      next_ring_left_(diagonal_),
      target_(diagonal_),
      diffuse_target_(diagonal_) {}

void TableEquations::add(const PointSamples& samples, const PointFitter& fitter,
                         const ExemplarTables& tables, const PointFit& fit) {
    if (fit.specular <= 0.0f) return;
    const float rotation = area_shift(grid_, fit.shift);
    const float area_out = area_at(tables.areas, samples.out, samples.to_eye[2], rotation);
    const auto columns = static_cast<float>(grid_.azimuths);
    for (std::size_t q = 0; q < samples.size(); ++q) {
        const float area_in =
            area_at(tables.areas, samples.in[q], samples.to_light[q][2], rotation);
        // The derivative of the sample by D at this half vector.
        const double a = static_cast<double>(f32::area_brdf(
            samples.received[q] * fit.specular * fitter.fresnel()[q], area_in, area_out));
        const double y = static_cast<double>(samples.value[q] - samples.received[q] * fit.diffuse *
                                                                    std::numbers::inv_pi_v<float>);
        // Diffuse light with a strength equal to the specular one.
        const double z =
            static_cast<double>(samples.received[q] * fit.specular * std::numbers::inv_pi_v<float>);
        const double w = static_cast<double>(fitter.weights()[q]);
        const GridPlace& place = samples.half[q];
        float c = std::fmod(place.column - fit.shift, columns);
        if (c < 0.0f) c += columns;
        const int c0 = static_cast<int>(c) % grid_.azimuths;
        const double t = static_cast<double>(c - std::floor(c)),
                     f = static_cast<double>(place.fraction);
        const bool last = place.ring + 1 >= grid_.rings;
        const std::size_t n00 = at(grid_, place.ring, c0), n01 = at(grid_, place.ring, c0 + 1);
        const double g = last ? 0.0 : f;
        const double b00 = a * (1 - g) * (1 - t), b01 = a * (1 - g) * t, b10 = a * g * (1 - t),
                     b11 = a * g * t;
        diagonal_[n00] += w * b00 * b00;
        diagonal_[n01] += w * b01 * b01;
        right_[n00] += w * b00 * b01;
        target_[n00] += w * b00 * y;
        diffuse_target_[n00] += w * b00 * z;
        target_[n01] += w * b01 * y;
        diffuse_target_[n01] += w * b01 * z;
        if (last) continue;
        const std::size_t n10 = at(grid_, place.ring + 1, c0),
                          n11 = at(grid_, place.ring + 1, c0 + 1);
        diagonal_[n10] += w * b10 * b10;
        diagonal_[n11] += w * b11 * b11;
        right_[n10] += w * b10 * b11;
        next_ring_[n00] += w * b00 * b10;
        next_ring_[n01] += w * b01 * b11;
        next_ring_right_[n00] += w * b00 * b11;
        next_ring_left_[n01] += w * b01 * b10;
        target_[n10] += w * b10 * y;
        diffuse_target_[n10] += w * b10 * z;
        target_[n11] += w * b11 * y;
        diffuse_target_[n11] += w * b11 * z;
    }
}

void TableEquations::merge(const TableEquations& other) {
    const auto add = [](std::vector<double>& to, const std::vector<double>& from) {
        std::transform(to.begin(), to.end(), from.begin(), to.begin(), std::plus<>());
    };
    add(diagonal_, other.diagonal_);
    add(right_, other.right_);
    add(next_ring_, other.next_ring_);
    add(next_ring_right_, other.next_ring_right_);
    add(next_ring_left_, other.next_ring_left_);
    add(target_, other.target_);
    add(diffuse_target_, other.diffuse_target_);
}

// out = (normal equations + smoothness x (second differences along rings and columns)^T (same)) x
void TableEquations::apply(const std::vector<double>& x, double smoothness,
                           std::vector<double>& out) const {
    for (std::size_t i = 0; i < x.size(); ++i) out[i] = diagonal_[i] * x[i];
    for (int r = 0; r < grid_.rings; ++r)
        for (int c = 0; c < grid_.azimuths; ++c) {
            const std::size_t i = at(grid_, r, c), right = at(grid_, r, c + 1);
            out[i] += right_[i] * x[right];
            out[right] += right_[i] * x[i];
            if (r + 1 < grid_.rings) {
                const std::size_t down = at(grid_, r + 1, c), down_right = at(grid_, r + 1, c + 1);
                const std::size_t down_left = at(grid_, r + 1, c - 1);
                out[i] += next_ring_[i] * x[down] + next_ring_right_[i] * x[down_right] +
                          next_ring_left_[i] * x[down_left];
                out[down] += next_ring_[i] * x[i];
                out[down_right] += next_ring_right_[i] * x[i];
                out[down_left] += next_ring_left_[i] * x[i];
            }
            const std::size_t left = at(grid_, r, c - 1);
            const double along = smoothness * (x[left] - 2.0 * x[i] + x[right]);
            out[left] += along;
            out[i] -= 2.0 * along;
            out[right] += along;
            const std::size_t in = inwards(grid_, r, c);
            const std::size_t outer = r + 1 < grid_.rings ? at(grid_, r + 1, c) : i;
            const double across = smoothness * (x[in] - 2.0 * x[i] + x[outer]);
            out[in] += across;
            out[i] -= 2.0 * across;
            out[outer] += across;
        }
}

// Conjugate gradients, scaled by the diagonal.
std::vector<double> TableEquations::minimizer(const std::vector<double>& target,
                                              std::vector<double> x) const {
    const std::size_t n = diagonal_.size();
    const double mean =
        std::accumulate(diagonal_.begin(), diagonal_.end(), 0.0) / static_cast<double>(n);
    const double smoothness = kSmoothness * mean;
    std::vector<double> residual(n), direction(n), scaled(n), image(n);
    apply(x, smoothness, image);
    double rz = 0.0, square = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        residual[i] = target[i] - image[i];
        scaled[i] = residual[i] / (diagonal_[i] + 12.0 * smoothness);
        rz += residual[i] * scaled[i];
        square += target[i] * target[i] / (diagonal_[i] + 12.0 * smoothness);
    }
    direction = scaled;
    for (int step = 0; step < kMostSteps && rz > kLeastStep * square; ++step) {
        apply(direction, smoothness, image);
        const double bend =
            std::inner_product(direction.begin(), direction.end(), image.begin(), 0.0);
        if (!(bend > 0.0)) break;
        const double length = rz / bend;
        double next = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            x[i] += length * direction[i];
            residual[i] -= length * image[i];
            scaled[i] = residual[i] / (diagonal_[i] + 12.0 * smoothness);
            next += residual[i] * scaled[i];
        }
        for (std::size_t i = 0; i < n; ++i) direction[i] = scaled[i] + next / rz * direction[i];
        rz = next;
    }
    return x;
}

std::vector<float> TableEquations::diffuse_mimic() const {
    std::vector<float> out(diagonal_.size(), 0.0f);
    if (std::all_of(diagonal_.begin(), diagonal_.end(), [](double d) { return d <= 0.0; }))
        return out;
    const std::vector<double> x =
        minimizer(diffuse_target_, std::vector<double>(diagonal_.size(), 0.0));
    std::transform(x.begin(), x.end(), out.begin(), [](double v) { return static_cast<float>(v); });
    return out;
}

void TableEquations::solve(float* table, float* weights) const {
    const std::size_t n = diagonal_.size();
    const double mean =
        std::accumulate(diagonal_.begin(), diagonal_.end(), 0.0) / static_cast<double>(n);
    if (!(mean > 0.0)) {
        std::fill_n(weights, n, 0.0f);
        return;
    }
    const std::vector<double> x = minimizer(target_, std::vector<double>(table, table + n));
    for (std::size_t i = 0; i < n; ++i) {
        table[i] = static_cast<float>(std::max(x[i], 0.0));
        weights[i] = diagonal_[i] > kLeastShare * mean ? 1.0f : 0.0f;
    }
    // Radius about the pole in radians within which cells count as determined if a cell farther out
    // on their azimuth, still within the radius, is. The cells are so small that smoothness
    // determines them well.
    constexpr float kInner = 0.12f;
    for (int c = 0; c < grid_.azimuths; ++c) {
        int outer = 0;  // the outermost determined ring within the radius
        for (int r = 0; r < grid_.rings && grid_.theta(r) <= kInner; ++r)
            if (weights[at(grid_, r, c)] > 0.0f) outer = r;
        for (int r = 0; r < outer; ++r) weights[at(grid_, r, c)] = 1.0f;
    }
}

// Eliminates each point's diffuse strength d: y = received (d / pi + c s F Q / (4 g g)).
void SlideAlong::add(const PointSamples& samples, const PointFitter& fitter,
                     const ExemplarTables& tables, const float* mimic, const PointFit& fit) {
    if (fit.specular <= 0.0f) return;
    const float rotation = area_shift(tables.grid, fit.shift);
    const float area_out = area_at(tables.areas, samples.out, samples.to_eye[2], rotation);
    double uu = 0.0, uv = 0.0, vv = 0.0, uy = 0.0, vy = 0.0;
    for (std::size_t q = 0; q < samples.size(); ++q) {
        const float area_in =
            area_at(tables.areas, samples.in[q], samples.to_light[q][2], rotation);
        const float a = f32::area_brdf(samples.received[q] * fit.specular * fitter.fresnel()[q],
                                       area_in, area_out);
        const auto u = static_cast<double>(samples.received[q] * std::numbers::inv_pi_v<float>);
        const auto v =
            static_cast<double>(a * lookup(tables.grid, mimic, samples.half[q], fit.shift));
        const auto y =
            static_cast<double>(samples.value[q] -
                                a * lookup(tables.grid, tables.D, samples.half[q], fit.shift)) -
            static_cast<double>(fit.diffuse) * u;
        const auto w = static_cast<double>(fitter.weights()[q]);
        uu += w * u * u;
        uv += w * u * v;
        vv += w * v * v;
        uy += w * u * y;
        vy += w * v * y;
    }
    if (uu <= 0.0) return;
    bend_ += vv - uv * uv / uu;
    slope_ += vy - uv * uy / uu;
    light_ += vv;
}

float SlideAlong::distance() const {
    const double damped = bend_ + kSlideDamping * light_;
    return damped > 0.0 ? static_cast<float>(slope_ / damped) : 0.0f;
}

}  // namespace burnish
