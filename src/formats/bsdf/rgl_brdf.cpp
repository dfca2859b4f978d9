#include "formats/bsdf/rgl_brdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "burnish/error.hpp"
#include "core/constants.hpp"
#include "formats/bsdf/spectral_rgb.hpp"

namespace burnish {
namespace {

// The largest material of the database has some 80,000 table values; this allows 200 times as many.
constexpr std::size_t kMostTableValues = std::size_t{16} << 20;
constexpr std::size_t kLongestDescription = 4096;
// Radians. Angles in files are single-precision numbers that some program converted from degrees.
constexpr double kAngleTolerance = 1e-3;
// The least cosine that eval divides by.
constexpr double kLeastTableCosine = 1e-6;

double u_of_theta(double theta) {
    return std::sqrt(theta * (2 / kPi));
}

double theta_of_u(double u) {
    return u * u * (kPi / 2);
}

// (phi + pi) / (2 pi), wrapped into [0, 1).
double v_of_phi(double phi) {
    const double v = (phi + kPi) / (2 * kPi);
    return v - std::floor(v);
}

// From components, which keeps precision near the normal.
double theta_of(Direction<double> w) {
    return std::atan2(std::hypot(w.x, w.y), w.z);
}

Direction<double> direction_at(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// The unit half vector of sum = wi + wo, which may vanish by rounding at the horizon.
Direction<double> half_vector(Direction<double> sum) {
    if (!make_unit(sum)) sum = {0, 0, 1};
    return sum;
}

// Least cosine between a direction and the half vector of a draw. Draws below it are rejected:
// their density, which divides by the cosine, would overflow. No table resolves such angles.
constexpr double kLeastFacing = 1e-12;

// Solid angle per area of the (u, v) square: theta = pi u^2 / 2, phi = pi (2 v - 1). At least
// 1e-18, so that the density at the normal itself is finite; the next normal in single precision
// has 1e-14.
double solid_angle_of_square(double u, double theta) {
    return std::max(2 * kPi * kPi * u * std::sin(theta), 1e-18);
}

}  // namespace

// ---- evaluation ---------------------------------------------------------------------------------

struct RglBrdf::Given {
    Direction<double> w;  // flipped into the azimuths of the file
    double flip_x = 1, flip_y = 1;
    double theta = 0, phi = 0;
    SliceMix mix;

    Direction<double> flipped(Direction<double> v) const {
        return {v.x * flip_x, v.y * flip_y, v.z};
    }
    // Azimuth of the frame of the tables, which rotates with the incident direction when isotropic.
    double offset(bool isotropic) const { return isotropic ? phi : 0.0; }
};

// Files with symmetry store the azimuths from -pi. Four-fold symmetry needs both components
// negative, two-fold y only.
RglBrdf::Given RglBrdf::given(Direction<double> wo) const {
    Given at;
    if (symmetry_ == 4) {
        at.flip_x = wo.x > 0 ? -1 : 1;
        at.flip_y = wo.y > 0 ? -1 : 1;
    } else if (symmetry_ == 2) {
        at.flip_x = at.flip_y = wo.y > 0 ? -1 : 1;
    }
    at.w = at.flipped(wo);
    at.theta = theta_of(at.w);
    // At the normal any azimuth serves; the negative zero of y selects the side that the file
    // stores.
    at.phi = std::atan2(at.w.y, at.w.x);
    if (symmetry_ != 1 && at.phi > 0) at.phi = -at.phi;
    at.mix = grid_.at(at.phi, at.theta);
    return at;
}

RglBrdf::Rgb RglBrdf::reflected(const Given& at, const Warped& start, double u, double v) const {
    const double scale =
        jacobian_
            ? ndf_.value(0, u, v) / (4 * sigma_.value(0, u_of_theta(at.theta), v_of_phi(at.phi)))
            : 1.0;
    Rgb rgb{};
    for (std::size_t c = 0; c < 3; ++c)
        rgb[c] = std::max(rgb_[c].value(at.mix, start.x, start.y), 0.0) * scale;
    return rgb;
}

RglBrdf::Rgb RglBrdf::eval(Direction<double> wi, Direction<double> wo) const {
    if (!(wi.z > 0 && wo.z > 0)) return {};
    const Given at = given(wo);
    const Direction<double> h = half_vector(at.flipped(wi) + at.w);
    const double u = u_of_theta(theta_of(h));
    const double v = v_of_phi(std::atan2(h.y, h.x) - at.offset(isotropic_));
    Rgb rgb = reflected(at, vndf_.invert(at.mix, u, v), u, v);
    for (double& value : rgb) value /= std::max(wi.z, kLeastTableCosine);
    return rgb;
}

Direction<double> RglBrdf::normal_at(Direction<double> wo, std::array<double, 2> square,
                                     double& density) const {
    const Given at = given(wo);
    const Warped end = vndf_.sample(at.mix, square[0], square[1]);
    const double theta = theta_of_u(end.x);
    const double phi = kPi * (2 * end.y - 1) + at.offset(isotropic_);
    density = end.density / solid_angle_of_square(end.x, theta);
    return at.flipped(direction_at(theta, phi));
}

std::array<double, 2> RglBrdf::square_of(Direction<double> h, Direction<double> wo) const {
    const Given at = given(wo);
    const Direction<double> m = at.flipped(h);
    const double u = u_of_theta(theta_of(m));
    const double v = v_of_phi(std::atan2(m.y, m.x) - at.offset(isotropic_));
    const Warped start = vndf_.invert(at.mix, u, v);
    return {start.x, start.y};
}

Direction<double> RglBrdf::sample(Direction<double> wo, std::array<double, 2> xi,
                                  double& density) const {
    density = 0;
    if (!(wo.z > 0)) return {};
    const SliceMix mix = given(wo).mix;
    const Warped start = luminance_.sample(mix, xi[0], xi[1]);
    double normals = 0;
    const Direction<double> h = normal_at(wo, {start.x, start.y}, normals);
    const double wo_h = dot(wo, h);
    if (!(wo_h > kLeastFacing)) return {};
    density = start.density * normals / (4 * wo_h);
    return normalize(h * (2 * wo_h) - wo);
}

double RglBrdf::pdf(Direction<double> wi, Direction<double> wo) const {
    const Direction<double> sum = wi + wo;
    if (!(wo.z > 0 && sum.z > 0)) return 0;
    const Given at = given(wo);
    const Direction<double> h = half_vector(at.flipped(sum));
    const double wo_h = dot(at.w, h), theta = theta_of(h);
    if (!(wo_h > kLeastFacing)) return 0;
    const double u = u_of_theta(theta);
    const double v = v_of_phi(std::atan2(h.y, h.x) - at.offset(isotropic_));
    const Warped start = vndf_.invert(at.mix, u, v);
    return luminance_.density(at.mix, start.x, start.y) * start.density /
           (solid_angle_of_square(u, theta) * 4 * wo_h);
}

double RglBrdf::ndf(double theta, double phi) const {
    return ndf_.value(0, u_of_theta(theta), v_of_phi(phi));
}

double RglBrdf::sigma(double theta, double phi) const {
    return sigma_.value(0, u_of_theta(theta), v_of_phi(phi));
}

// ---- reading ------------------------------------------------------------------------------------

namespace {

std::vector<double> read_angles(const TensorFile& file, std::string_view name, double low,
                                double high) {
    const std::vector<float> values = file.floats(file.require(name, TensorType::float32, 1));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = values[i];
        const bool rises = i == 0 || value > values[i - 1];
        if (rises && value >= low - kAngleTolerance && value <= high + kAngleTolerance) continue;
        file.fail(name, fmt::format("radians that rise from {:.4g} to {:.4g} at most", low, high),
                  fmt::format("{} as number {}", value, i));
    }
    return {values.begin(), values.end()};
}

// Checks that the axes after the first `outer` ones form a grid of at least 2 x 2 and that the
// field is within bounds.
void check_grid(const TensorFile& file, const TensorField& field) {
    const std::size_t rank = field.shape.size();
    if (field.shape[rank - 1] < 2 || field.shape[rank - 2] < 2)
        file.fail(field.name, "a grid of at least 2 x 2 numbers", field.shape_text());
    if (field.count > kMostTableValues) {
        file.fail(field.name, fmt::format("at most {} numbers", kMostTableValues),
                  field.shape_text());
    }
}

void expect_shape(const TensorFile& file, const TensorField& field,
                  const std::vector<std::size_t>& shape) {
    if (field.shape == shape) return;
    file.fail(field.name, fmt::format("{}", fmt::join(shape, " x ")), field.shape_text());
}

void check_not_below_zero(const TensorFile& file, const TensorField& field,
                          std::span<const float> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] >= 0) continue;
        file.fail(field.name, "numbers of at least 0",
                  fmt::format("{} as number {}", values[i], i));
    }
}

BilinearTable read_table(const TensorFile& file, std::string_view name, bool positive) {
    const TensorField& field = file.require(name, TensorType::float32, 2);
    check_grid(file, field);
    std::vector<float> values = file.floats(field);
    check_not_below_zero(file, field, values);
    for (std::size_t i = 0; positive && i < values.size(); ++i)
        if (!(values[i] > 0)) file.fail(name, "numbers above 0", fmt::format("0 as number {}", i));
    return {std::move(values), field.shape[1], field.shape[0]};
}

BilinearWarp read_warp(const TensorFile& file, std::string_view name, std::size_t phis,
                       std::size_t thetas) {
    const TensorField& field = file.require(name, TensorType::float32, 4);
    expect_shape(file, field, {phis, thetas, field.shape[2], field.shape[3]});
    check_grid(file, field);
    const std::vector<float> values = file.floats(field);
    check_not_below_zero(file, field, values);
    const std::size_t slice = field.shape[2] * field.shape[3];
    for (std::size_t i = 0; i < phis * thetas; ++i) {
        const std::span part(values.data() + i * slice, slice);
        if (std::any_of(part.begin(), part.end(), [](float value) { return value > 0; })) continue;
        file.fail(name, "a density for every incident direction",
                  fmt::format("only zeros for number {}", i));
    }
    return {values, field.shape[3], field.shape[2]};
}

bool read_flag(const TensorFile& file, std::string_view name) {
    const TensorField& field = file.require(name, TensorType::uint8, 1);
    expect_shape(file, field, {1});
    return file.data(field)[0] != std::byte{0};
}

std::string read_description(const TensorFile& file) {
    const TensorField* field = file.find("description");
    if (!field) return {};
    file.require("description", TensorType::uint8, 1);
    const auto bytes = file.data(*field).first(std::min(field->count, kLongestDescription));
    return one_line({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace

RglBrdf RglBrdf::load(const std::filesystem::path& path) {
    return RglBrdf(TensorFile::load(path));
}

RglBrdf::RglBrdf(const TensorFile& file) : description_(read_description(file)) {
    read_directions(file);
    read_distribution(file);
    read_reflectance(file);
}

void RglBrdf::read_directions(const TensorFile& file) {
    std::vector<double> theta = read_angles(file, "theta_i", 0, kPi / 2);
    std::vector<double> phi = read_angles(file, "phi_i", -kPi, kPi);
    isotropic_ = phi.size() <= 2;
    if (!isotropic_) {
        const double span = phi.back() - phi.front();
        symmetry_ = static_cast<int>(std::lround(2 * kPi / span));
        const bool known = symmetry_ == 1 || symmetry_ == 2 || symmetry_ == 4;
        if (!known || std::fabs(span * symmetry_ - 2 * kPi) > kAngleTolerance * symmetry_ ||
            std::fabs(phi.front() + kPi) > kAngleTolerance) {
            file.fail("phi_i", "azimuths from -pi over the whole, half or quarter of the circle",
                      fmt::format("{:.4g} to {:.4g}", phi.front(), phi.back()));
        }
    }
    grid_ = SliceGrid(std::move(phi), std::move(theta));
}

void RglBrdf::read_distribution(const TensorFile& file) {
    const std::size_t phis = grid_.phi().size(), thetas = grid_.theta().size();
    ndf_ = read_table(file, "ndf", false);
    sigma_ = read_table(file, "sigma", true);
    vndf_ = read_warp(file, "vndf", phis, thetas);
    luminance_ = read_warp(file, "luminance", phis, thetas);
    jacobian_ = read_flag(file, "jacobian");
}

void RglBrdf::read_reflectance(const TensorFile& file) {
    if (file.find("rgb")) {
        static constexpr std::array<std::array<double, 3>, 3> kAsTheyAre = {
            {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
        read_color(file, file.require("rgb", TensorType::float32, 5), kAsTheyAre, 3);
        return;
    }
    if (!file.find("spectra")) file.fail("rgb", "this field, or spectra", "neither");
    const TensorField& spectra = file.require("spectra", TensorType::float32, 5);
    const std::vector<float> waves =
        file.floats(file.require("wavelengths", TensorType::float32, 1));
    const bool rising =
        std::adjacent_find(waves.begin(), waves.end(), std::greater_equal<>()) == waves.end();
    if (waves.size() < 2 || !rising || waves.front() > 400.5F || waves.back() < 699.5F) {
        file.fail("wavelengths", "nanometres that rise, from 400 or less to 700 or more",
                  fmt::format("{} from {} to {}", waves.size(), waves.front(), waves.back()));
    }
    wavelengths_ = waves.size();
    wavelength_range_ = {waves.front(), waves.back()};
    read_color(file, spectra, reflectance_to_rgb(waves), waves.size());
}

// From slice, channel, row, column to three tables of slice, row, column.
void RglBrdf::read_color(const TensorFile& file, const TensorField& field,
                         std::span<const std::array<double, 3>> weights, std::size_t channels) {
    const std::size_t rows = field.shape[3], columns = field.shape[4];
    expect_shape(file, field, {grid_.phi().size(), grid_.theta().size(), channels, rows, columns});
    if (rows < 2 || columns < 2)
        file.fail(field.name, "a grid of at least 2 x 2 numbers", field.shape_text());
    const std::size_t grid = rows * columns;
    if (grid_.size() > kMostTableValues / grid) {
        file.fail(field.name, fmt::format("at most {} numbers a channel", kMostTableValues),
                  field.shape_text());
    }
    const std::vector<float> values = file.floats(field);
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<float> table(grid_.size() * grid);
        for (std::size_t slice = 0; slice < grid_.size(); ++slice)
            for (std::size_t i = 0; i < grid; ++i) {
                double sum = 0;
                for (std::size_t k = 0; k < channels; ++k)
                    sum += weights[k][c] *
                           static_cast<double>(values[(slice * channels + k) * grid + i]);
                table[slice * grid + i] = static_cast<float>(sum);
            }
        rgb_[c] = BilinearTable(std::move(table), columns, rows);
    }
}

}  // namespace burnish
