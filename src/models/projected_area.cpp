#include "models/projected_area.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/constants.hpp"

namespace burnish {
namespace {

// ---- Int from theta to pi/2 of cos^(e+2) --------------------------------------------------------

// Gamma(a) / Gamma(a + 1/2), a >= 3/2: Stirling's series where it holds to 1e-11, recurrence down.
double gamma_ratio(double a) {
    double factor = 1;
    for (; a < 16; a += 1) factor *= (a + 0.5) / a;
    const double r = 1 / a;
    const double series =
        1 + r * (1.0 / 8 +
                 r * (1.0 / 128 + r * (-5.0 / 1024 + r * (-21.0 / 32768 + r * (399.0 / 262144)))));
    return factor * series / std::sqrt(a);
}

// Sum of (a + 1/2)_n / (3/2)_n y^n, which has positive terms; a y <= 3 and y <= 1/2 here.
double beta_series(double a, double y) {
    double term = 1, sum = 1;
    for (int n = 0; term > 1e-12 * sum; ++n) {
        term *= (a + 0.5 + n) / (1.5 + n) * y;
        sum += term;
    }
    return sum;
}

// Continued fraction of the incomplete beta function B_x(a, 1/2) (Abramowitz & Stegun 26.5.8), by
// Lentz's recurrence. Where it is used, 60 steps are twice what 1e-11 takes.
double beta_fraction(double a, double x) {
    const double b = 0.5;
    double c = 1;
    double d = 1 / (1 - (a + b) * x / (a + 1));
    double value = d;
    for (int m = 1; m <= 60; ++m) {
        const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        d = 1 / (1 + even * d);
        c = 1 + even / c;
        value *= d * c;
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        d = 1 / (1 + odd * d);
        c = 1 + odd / c;
        value *= d * c;
        if (std::fabs(d * c - 1) < 1e-11) break;
    }
    return value;
}

// `t`: tan theta; `power`: cos^(e+2) theta.
double cosine_power_tail(double e, double t, double power) {
    const double x = 1 / (1 + t * t), y = t * t * x;
    const double a = 0.5 * (e + 3);
    const double xa = power * std::sqrt(x);
    if (a * y <= 3 && y <= 0.5) {
        const double complete = std::sqrt(kPi) * gamma_ratio(a);
        return 0.5 * complete - std::sqrt(y) * xa * beta_series(a, y);
    }
    return 0.5 * xa * std::sqrt(y) / a * beta_fraction(a, x);
}

// ---- the half turn of azimuths that face away ---------------------------------------------------

struct Azimuth {
    double cosine, sine, weight;  // weights sum to the length of the half turn, pi
};

// Tanh-sinh: at grazing the integrand has layers at both ends, far thinner than the half turn.
constexpr int kSteps = 24;
constexpr double kReach = 2.6;
using Azimuths = std::array<Azimuth, 2 * kSteps + 1>;

Azimuths make_azimuths() {
    Azimuths azimuths;
    const double step = kReach / kSteps;
    double sum = 0;
    for (int i = -kSteps; i <= kSteps; ++i) {
        const double t = step * i;
        const double u = kHalfPi * std::sinh(t);
        const double from_end = kPi / (1 + std::exp(2 * std::fabs(u)));  // pi/2 (1 - tanh |u|)
        Azimuth& azimuth = azimuths[static_cast<std::size_t>(i + kSteps)];
        azimuth.cosine = std::sin(from_end);
        azimuth.sine = std::copysign(std::cos(from_end), t);
        azimuth.weight = std::cosh(t) / (std::cosh(u) * std::cosh(u));
        sum += azimuth.weight;
    }
    for (Azimuth& azimuth : azimuths) azimuth.weight *= kPi / sum;
    return azimuths;
}

// ---- places of the table ------------------------------------------------------------------------

constexpr std::size_t kRows = 97;     // elevation of the stretched direction, 0 to 90 degrees
constexpr std::size_t kColumns = 25;  // its azimuth, 0 to 90 degrees
constexpr std::size_t kStencil = 4;   // cubic in each

// Weights of the cubic through four places, at `t` steps from the first.
std::array<double, kStencil> cubic_weights(double t) {
    const double a = t, b = t - 1, c = t - 2, d = t - 3;
    return {-b * c * d / 6, a * c * d / 2, -a * b * d / 2, a * b * c / 6};
}

// ---- the last tables ----------------------------------------------------------------------------

class TableCache {
  public:
    ProjectedAreaTable& of(double e_x, double e_y) {
        for (std::size_t i = 0; i < tables_.size(); ++i) {
            if (tables_[i].e_x() == e_x && tables_[i].e_y() == e_y) return tables_[i];
        }
        if (tables_.size() < kTables) return tables_.emplace_back(e_x, e_y);
        oldest_ = (oldest_ + 1) % kTables;
        return tables_[oldest_] = ProjectedAreaTable(e_x, e_y);
    }

  private:
    static constexpr std::size_t kTables = 8;
    std::vector<ProjectedAreaTable> tables_;
    std::size_t oldest_ = kTables - 1;
};

}  // namespace

// g(k) = k_z + Int over h.k < 0 of -(h.k) D: the whole is k_z, because D is centrally symmetric.
// The elevation's integral by parts is an incomplete beta function. Azimuths are those of the lobe
// drawn round, (cos psi, sin psi) ~ (x/alpha_x, y/alpha_y) with alpha^2 = 2/(e + 2): the exponent
// in their direction is 2/r^2 - 2, r^2 = (alpha_x cos psi)^2 + (alpha_y sin psi)^2, and D's norm
// cancels.
double projected_area(double e_x, double e_y, Direction<double> k) {
    static const Azimuths azimuths = make_azimuths();
    const double alpha_x = std::sqrt(2 / (e_x + 2)), alpha_y = std::sqrt(2 / (e_y + 2));
    const double x = alpha_x * k.x, y = alpha_y * k.y;
    const double across = std::hypot(x, y);
    if (!(across > 0)) return k.z;
    double away = 0;
    for (const Azimuth& azimuth : azimuths) {
        const double c = (x * azimuth.cosine - y * azimuth.sine) / across;
        const double s = (y * azimuth.cosine + x * azimuth.sine) / across;
        const double r2 = alpha_x * alpha_x * c * c + alpha_y * alpha_y * s * s;
        const double e = 2 / r2 - 2;
        const double b = across * azimuth.cosine / std::sqrt(r2);
        const double t = k.z / b;
        const double power = std::exp(-std::log1p(t * t) / r2);
        if (power == 0) continue;
        const double tail = cosine_power_tail(e, t, power);
        away += azimuth.weight * (2 / r2 * b * tail + k.z * power) / (e + 1);
    }
    return k.z + away / (2 * kPi);
}

ProjectedAreaTable::ProjectedAreaTable(double e_x, double e_y)
    : e_x_(e_x),
      e_y_(e_y),
      alpha_x_(std::sqrt(2 / (e_x + 2))),
      alpha_y_(std::sqrt(2 / (e_y + 2))),
      places_(kRows * kColumns, std::numeric_limits<double>::quiet_NaN()) {}

// (g - k_z) / |k'|, k' the direction stretched with the lobe: smooth, and 0 but near grazing.
double ProjectedAreaTable::place(std::size_t row, std::size_t column) {
    double& value = places_[row * kColumns + column];
    if (std::isnan(value)) {
        const double theta = kHalfPi * static_cast<double>(row) / (kRows - 1);
        const double psi = kHalfPi * static_cast<double>(column) / (kColumns - 1);
        const Direction<double> k{std::sin(theta) * std::cos(psi) / alpha_x_,
                                  std::sin(theta) * std::sin(psi) / alpha_y_, std::cos(theta)};
        value = projected_area(e_x_, e_y_, k) - k.z;  // homogeneous: k need not be unit
    }
    return value;
}

double ProjectedAreaTable::at(Direction<double> k) {
    const double x = std::fabs(alpha_x_ * k.x), y = std::fabs(alpha_y_ * k.y);
    const double across = std::hypot(x, y);
    const double row = std::atan2(across, k.z) / kHalfPi * (kRows - 1);
    const double column = std::atan2(y, x) / kHalfPi * (kColumns - 1);
    // One-sided at the rim; columns go on as in a mirror.
    const auto first_row =
        static_cast<std::size_t>(std::clamp(std::floor(row) - 1, 0.0, double{kRows - kStencil}));
    const double first_column = std::floor(column) - 1;
    const auto row_weights = cubic_weights(row - static_cast<double>(first_row));
    const auto column_weights = cubic_weights(column - first_column);
    double sum = 0;
    for (std::size_t j = 0; j < kStencil; ++j) {
        const double mirrored = std::fabs(first_column + static_cast<double>(j));
        const double inside = mirrored > kColumns - 1 ? 2 * (kColumns - 1) - mirrored : mirrored;
        for (std::size_t i = 0; i < kStencil; ++i) {
            sum += row_weights[i] * column_weights[j] *
                   place(first_row + i, static_cast<std::size_t>(inside));
        }
    }
    return k.z + std::max(sum, 0.0) * std::hypot(across, k.z);
}

double projected_area_cached(double e_x, double e_y, Direction<double> k) {
    thread_local TableCache cache;
    return cache.of(e_x, e_y).at(k);
}

}  // namespace burnish
