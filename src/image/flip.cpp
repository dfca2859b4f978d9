// FLIP for pictures of low dynamic range (compare.hpp names the paper). Two pipelines run side by
// side and meet in one number per pixel:
//
//   color    sRGB -> linear RGB -> YCxCz, each channel filtered by the contrast sensitivity of the
//            eye -> linear RGB, clamped to [0, 1] -> CIELab, Hunt-adjusted -> HyAB distance ->
//            redistributed over [0, 1]: dE_c
//   feature  the luminance, filtered by detectors of edges and points -> the larger difference of
//            the two magnitudes, to the power of q_f: dE_f
//   both     dE = dE_c^(1 - dE_f)
//
// Pixels outside a picture have the value of the nearest pixel inside.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "burnish/compare.hpp"
#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/constants.hpp"
#include "core/parallel.hpp"

namespace burnish {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

constexpr Triple product(const Matrix& m, const Triple& v) {
    Triple result{};
    for (std::size_t row = 0; row < 3; ++row)
        result[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
    return result;
}

// By cofactors.
constexpr Matrix inverse(const Matrix& m) {
    Matrix result{};
    double determinant = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            result[j][i] = m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
        }
        determinant += m[0][i] * result[i][0];
    }
    for (Triple& row : result)
        for (double& value : row) value /= determinant;
    return result;
}

// X, Y, Z of linear sRGB, each relative to that of white (R = G = B = 1), so that every row sums to
// 1. The authors of FLIP use these ratios: those of the primaries of Rec. 709 and of D65 at
// x = 0.31271, y = 0.32902.
constexpr Matrix kXyzOfRgb = [] {
    Matrix m = {{{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                 {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                 {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};
    for (Triple& row : m) {
        const double white = row[0] + row[1] + row[2];
        for (double& value : row) value /= white;
    }
    return m;
}();
constexpr Matrix kRgbOfXyz = inverse(kXyzOfRgb);

// The opponent space YCxCz is Y = 116 y - 16, Cx = 500 (x - y), Cz = 200 (y - z), with x, y, z as
// above. Its scales and its offset cancel out in filters whose weights sum to 1. They are left out
// here, so that the channel y is the luminance that the feature pipeline takes.
struct OpponentImage {
    int width = 0, height = 0;
    std::vector<float> y, cx, cz;
};

// NaN becomes 0.
float in_unit_range(float value) {
    return value > 0.0f ? std::min(value, 1.0f) : 0.0f;
}

OpponentImage opponent_of(const Image& image) {
    const auto width = static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    const auto channels = static_cast<std::size_t>(image.channels);
    OpponentImage result{image.width, image.height, {}, {}, {}};
    for (std::vector<float>* plane : {&result.y, &result.cx, &result.cz})
        plane->resize(width * height);
    parallel_for(width * height, 8 * width, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const float* pixel = image.pixels.data() + i * channels;
            Triple rgb{};
            for (std::size_t c = 0; c < 3; ++c) rgb[c] = linear_from_srgb(in_unit_range(pixel[c]));
            const auto [x, y, z] = product(kXyzOfRgb, rgb);
            result.y[i] = static_cast<float>(y);
            result.cx[i] = static_cast<float>(x - y);
            result.cz[i] = static_cast<float>(y - z);
        }
    });
    return result;
}

// A filter along one axis. half[k] is the weight of the pixel at +k, and sign * half[k] that of the
// pixel at -k. An odd filter (sign -1) has half[0] = 0.
struct FlipKernel {
    std::vector<double> half;
    double sign = 1.0;
    int radius() const { return static_cast<int>(half.size()) - 1; }
};

double sum_of(const FlipKernel& kernel) {
    double sum = kernel.half[0];
    for (std::size_t k = 1; k < kernel.half.size(); ++k) sum += 2.0 * kernel.half[k];
    return sum;
}

// exp(-x^2 / (2 sd^2)) for x of 0 to `radius` pixels.
FlipKernel gaussian_of(double sd, int radius) {
    FlipKernel kernel;
    for (int k = 0; k <= radius; ++k) kernel.half.push_back(std::exp(-k * k / (2.0 * sd * sd)));
    return kernel;
}

FlipKernel unit_sum(FlipKernel kernel) {
    const double sum = sum_of(kernel);
    for (double& weight : kernel.half) weight /= sum;
    return kernel;
}

// Without the outer weights below 1e-9 of the middle one: together they are below the precision of
// the float values that they weight.
FlipKernel without_tail(FlipKernel kernel) {
    while (kernel.half.size() > 1 && kernel.half.back() < 1e-9 * kernel.half[0])
        kernel.half.pop_back();
    return kernel;
}

// A filter of contrast sensitivity: a sum of Gaussians, each of unit sum and with its share.
struct SharedGaussian {
    double share;
    FlipKernel kernel;
};
using SensitivityFilter = std::vector<SharedGaussian>;

// The filter of one channel at a distance of d degrees is a sum of terms
// a sqrt(pi / b) exp(-pi^2 d^2 / b), scaled to unit sum over the square of pixels within
// ceil(3 sqrt(b_max / (2 pi^2)) pixels_per_degree). b_max = 0.04 is the largest b of all channels.
struct SensitivityTerm {
    double a, b;
};
constexpr double kLargestB = 0.04;

SensitivityFilter sensitivity_filter(const std::vector<SensitivityTerm>& terms,
                                     double pixels_per_degree) {
    const int radius = static_cast<int>(
        std::ceil(3.0 * std::sqrt(kLargestB / (2.0 * kPi * kPi)) * pixels_per_degree));
    SensitivityFilter filter;
    double whole = 0.0;
    for (const auto& [a, b] : terms) {
        const FlipKernel kernel =
            gaussian_of(std::sqrt(b / (2.0 * kPi * kPi)) * pixels_per_degree, radius);
        // The sum over the square is that along one axis, squared.
        const double share = a * std::sqrt(kPi / b) * sum_of(kernel) * sum_of(kernel);
        filter.push_back({share, without_tail(unit_sum(kernel))});
        whole += share;
    }
    for (SharedGaussian& part : filter) part.share /= whole;
    return filter;
}

// The detectors of features: first (edge) and second (point) derivatives of a Gaussian along one
// axis, and the Gaussian along the other. Positive weights sum to 1, negative ones to -1.
struct FeatureFilter {
    FlipKernel gaussian, edge, point;
};

// Width of the edge detector of the human eye, peak to trough, in degrees; it is two standard
// deviations of the Gaussian.
constexpr double kFeatureWidth = 0.082;

FeatureFilter feature_filter(double pixels_per_degree) {
    const double sd = 0.5 * kFeatureWidth * pixels_per_degree;
    const FlipKernel gaussian = gaussian_of(sd, static_cast<int>(std::ceil(3.0 * sd)));
    FlipKernel edge = gaussian, point = gaussian;
    edge.sign = -1.0;
    double edge_sum = 0.0, positive = 0.0, negative = 0.0;
    for (std::size_t k = 0; k < gaussian.half.size(); ++k) {
        const auto x = static_cast<double>(k);
        edge_sum += edge.half[k] *= x;
        point.half[k] *= x * x / (sd * sd) - 1.0;
        (point.half[k] > 0.0 ? positive : negative) += (k == 0 ? 1.0 : 2.0) * point.half[k];
    }
    for (double& weight : edge.half) weight /= edge_sum;
    for (double& weight : point.half) weight /= weight > 0.0 ? positive : -negative;
    return {unit_sum(gaussian), edge, point};
}

struct FlipFilters {
    SensitivityFilter achromatic, red_green, blue_yellow;
    FeatureFilter feature;
    int padding = 0;  // the largest radius, in pixels
};

FlipFilters flip_filters(double pixels_per_degree) {
    FlipFilters filters{sensitivity_filter({{1.0, 0.0047}}, pixels_per_degree),
                        sensitivity_filter({{1.0, 0.0053}}, pixels_per_degree),
                        sensitivity_filter({{34.1, 0.04}, {13.5, 0.025}}, pixels_per_degree),
                        feature_filter(pixels_per_degree)};
    filters.padding = filters.feature.gaussian.radius();
    for (const auto* filter : {&filters.achromatic, &filters.red_green, &filters.blue_yellow})
        for (const auto& part : *filter)
            filters.padding = std::max(filters.padding, part.kernel.radius());
    return filters;
}

// sums[i] += weight (after[i] + sign before[i])
template <typename Value>
void add_weighted(const Value* before, const Value* after, double weight, double sign,
                  std::size_t count, double* sums) {
    const double weight_before = weight * sign;
    for (std::size_t i = 0; i < count; ++i)
        sums[i] +=
            weight * static_cast<double>(after[i]) + weight_before * static_cast<double>(before[i]);
}

// Filters single rows of planes, first down the columns and then along the row. Sums are in double:
// the derivatives of a constant are then 0 to within 1e-16, not 1e-7, which the power of q_f = 0.5
// would make 3e-4.
class RowFilter {
  public:
    RowFilter(int width, int height, int padding)
        : width_(static_cast<std::size_t>(width)),
          height_(height),
          padding_(static_cast<std::size_t>(padding)),
          row_(width_ + 2 * padding_) {}

    // sums += share * (row y of the filtered plane)
    void add(const std::vector<float>& plane, int y, const FlipKernel& down,
             const FlipKernel& along, double share, std::vector<double>& sums) {
        filter_columns(plane, y, down);
        const double* middle = row_.data() + padding_;
        add_weighted(middle, middle, 0.5 * share * along.half[0], 1.0, width_, sums.data());
        for (std::size_t k = 1; k < along.half.size(); ++k)
            add_weighted(middle - k, middle + k, share * along.half[k], along.sign, width_,
                         sums.data());
    }

  private:
    const float* plane_row(const std::vector<float>& plane, int y) const {
        return plane.data() + static_cast<std::size_t>(std::clamp(y, 0, height_ - 1)) * width_;
    }

    void filter_columns(const std::vector<float>& plane, int y, const FlipKernel& down) {
        double* middle = row_.data() + padding_;
        const float* here = plane_row(plane, y);
        for (std::size_t x = 0; x < width_; ++x)
            middle[x] = down.half[0] * static_cast<double>(here[x]);
        for (int k = 1; k <= down.radius(); ++k)
            add_weighted(plane_row(plane, y - k), plane_row(plane, y + k),
                         down.half[static_cast<std::size_t>(k)], down.sign, width_, middle);
        std::fill_n(row_.begin(), padding_, middle[0]);
        std::fill_n(middle + width_, padding_, middle[width_ - 1]);
    }

    std::size_t width_;
    int height_;
    std::size_t padding_;
    std::vector<double> row_;  // width_ values with padding_ copies of the outer ones on each side
};

// CIE 15, CIELab: the cube root, and a straight line below (6 / 29)^3.
double lab_curve(double relative) {
    constexpr double kDelta = 6.0 / 29.0;
    return relative > kDelta * kDelta * kDelta ? std::cbrt(relative)
                                               : relative / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
}

// L*, a* and b* of linear RGB in [0, 1]. The Hunt effect, that colors look less colorful in the
// dark, scales a* and b* by 0.01 L*.
Triple hunt_lab(const Triple& rgb) {
    const Triple xyz = product(kXyzOfRgb, rgb);
    const double x = lab_curve(xyz[0]), y = lab_curve(xyz[1]), z = lab_curve(xyz[2]);
    const double lightness = 116.0 * y - 16.0;
    const double hunt = 0.01 * lightness;
    return {lightness, hunt * 500.0 * (x - y), hunt * 200.0 * (y - z)};
}

// HyAB: the city-block distance of lightness and the Euclidean one of a* and b*.
double hyab(const Triple& p, const Triple& q) {
    const double da = p[1] - q[1], db = p[2] - q[2];
    return std::abs(p[0] - q[0]) + std::sqrt(da * da + db * db);
}

// dE_c: the distance to the power of q_c, relative to the largest one (of pure green and pure blue).
// Its part below p_c is spread over [0, p_t], and the rest, where larger distances look hardly
// larger, over [p_t, 1].
double color_error(double distance) {
    constexpr double kQc = 0.7, kPc = 0.4, kPt = 0.95;
    static const double largest = hyab(hunt_lab({0.0, 1.0, 0.0}), hunt_lab({0.0, 0.0, 1.0}));
    if (distance <= 0.0) return 0.0;
    const double part = std::pow(distance / largest, kQc);
    const double error =
        part < kPc ? part * (kPt / kPc) : kPt + (part - kPc) / (1.0 - kPc) * (1.0 - kPt);
    return std::min(error, 1.0);
}

// dE_f of the magnitudes of the features, each in [0, sqrt(2)].
double feature_error(double edge, double other_edge, double point, double other_point) {
    const double larger = std::max(std::abs(edge - other_edge), std::abs(point - other_point));
    return std::min(std::sqrt(larger / std::numbers::sqrt2), 1.0);  // the root: q_f = 0.5
}

// What the two pipelines know of one row of one picture before the pictures are compared.
class FlipRow {
  public:
    FlipRow(const OpponentImage& image, const FlipFilters& filters)
        : image_(image),
          filters_(filters),
          rows_(image.width, image.height, filters.padding),
          colors_(static_cast<std::size_t>(image.width)) {}

    void compute(int y) {
        filter_colors(y);
        filter_features(y);
    }
    const Triple& color(std::size_t x) const { return colors_[x]; }
    double edge(std::size_t x) const { return std::sqrt(squared(edge_x_[x], edge_y_[x])); }
    double point(std::size_t x) const { return std::sqrt(squared(point_x_[x], point_y_[x])); }

  private:
    static double squared(double a, double b) { return a * a + b * b; }

    void apply(const std::vector<float>& plane, int y, const SensitivityFilter& filter,
               std::vector<double>& sums) {
        sums.assign(colors_.size(), 0.0);
        for (const auto& [share, kernel] : filter) rows_.add(plane, y, kernel, kernel, share, sums);
    }

    void filter_colors(int y) {
        apply(image_.y, y, filters_.achromatic, y_);
        apply(image_.cx, y, filters_.red_green, cx_);
        apply(image_.cz, y, filters_.blue_yellow, cz_);
        for (std::size_t x = 0; x < colors_.size(); ++x) {
            Triple rgb = product(kRgbOfXyz, {y_[x] + cx_[x], y_[x], y_[x] - cz_[x]});
            for (double& value : rgb) value = std::clamp(value, 0.0, 1.0);
            colors_[x] = hunt_lab(rgb);
        }
    }

    void filter_features(int y) {
        const auto& [gaussian, edge, point] = filters_.feature;
        for (auto* sums : {&edge_x_, &edge_y_, &point_x_, &point_y_})
            sums->assign(colors_.size(), 0.0);
        rows_.add(image_.y, y, gaussian, edge, 1.0, edge_x_);
        rows_.add(image_.y, y, edge, gaussian, 1.0, edge_y_);
        rows_.add(image_.y, y, gaussian, point, 1.0, point_x_);
        rows_.add(image_.y, y, point, gaussian, 1.0, point_y_);
    }

    const OpponentImage& image_;
    const FlipFilters& filters_;
    RowFilter rows_;
    std::vector<double> y_, cx_, cz_, edge_x_, edge_y_, point_x_, point_y_;
    std::vector<Triple> colors_;  // Hunt-adjusted CIELab
};

void check_flip_input(const Image& reference, const Image& test, double pixels_per_degree) {
    const auto shape = [](const Image& image) {
        return fmt::format("{} x {} pixels of {} channels", image.width, image.height,
                           image.channels);
    };
    for (const Image* image : {&reference, &test})
        if (image->empty() || image->channels < 3)
            throw Error("FLIP", image == &test ? "test picture" : "reference picture",
                        "RGB or RGBA pixels", shape(*image));
    if (reference.width != test.width || reference.height != test.height)
        throw Error("FLIP", "test picture",
                    fmt::format("{} x {} pixels as in the reference picture", reference.width,
                                reference.height),
                    fmt::format("{} x {}", test.width, test.height));
    if (!(pixels_per_degree >= 1.0 && pixels_per_degree <= 1000.0))
        throw Error("FLIP", "pixels per degree", "1 to 1000", fmt::format("{}", pixels_per_degree));
}

void check_one_channel(const Image& image) {
    if (!image.empty() && image.channels != 1)
        throw Error("FLIP", "picture of errors", "1 channel", fmt::format("{}", image.channels));
}

// Every 15th color of the 256 of "magma" of matplotlib (S. van der Walt and N. Smith, CC0),
// display-encoded. Straight lines between them stay within 0.011 of the whole map.
constexpr std::array<std::array<float, 3>, 18> kMagma = {{{0.001462f, 0.000466f, 0.013866f},
                                                          {0.035520f, 0.028397f, 0.125209f},
                                                          {0.102815f, 0.063010f, 0.257854f},
                                                          {0.191460f, 0.064818f, 0.396152f},
                                                          {0.291366f, 0.064553f, 0.475462f},
                                                          {0.384299f, 0.097855f, 0.501002f},
                                                          {0.475780f, 0.134577f, 0.507921f},
                                                          {0.569172f, 0.167454f, 0.504105f},
                                                          {0.664915f, 0.198075f, 0.488836f},
                                                          {0.761077f, 0.231214f, 0.460162f},
                                                          {0.852126f, 0.276106f, 0.418573f},
                                                          {0.925937f, 0.346844f, 0.374959f},
                                                          {0.969680f, 0.446936f, 0.360311f},
                                                          {0.989363f, 0.557873f, 0.391671f},
                                                          {0.996580f, 0.668256f, 0.456192f},
                                                          {0.996727f, 0.776795f, 0.541039f},
                                                          {0.992440f, 0.884330f, 0.640099f},
                                                          {0.987053f, 0.991438f, 0.749504f}}};

}  // namespace

Image flip_error(const Image& reference, const Image& test, double pixels_per_degree) {
    check_flip_input(reference, test, pixels_per_degree);
    const FlipFilters filters = flip_filters(pixels_per_degree);
    const OpponentImage reference_planes = opponent_of(reference), test_planes = opponent_of(test);
    Image error(reference.width, reference.height, 1);
    const auto width = static_cast<std::size_t>(error.width);
    // 8: the buffers of a range are made once for several rows, and a small picture still has a
    // range for every core.
    parallel_for(
        static_cast<std::size_t>(error.height), 8, [&](std::size_t begin, std::size_t end) {
            FlipRow one(reference_planes, filters), other(test_planes, filters);
            for (std::size_t y = begin; y < end; ++y) {
                one.compute(static_cast<int>(y));
                other.compute(static_cast<int>(y));
                float* values = error.at(0, static_cast<int>(y));
                for (std::size_t x = 0; x < width; ++x) {
                    const double color = color_error(hyab(one.color(x), other.color(x)));
                    if (color == 0.0) continue;
                    const double feature =
                        feature_error(one.edge(x), other.edge(x), one.point(x), other.point(x));
                    values[x] = static_cast<float>(std::pow(color, 1.0 - feature));
                }
            }
        });
    return error;
}

double mean_of(const Image& one_channel) {
    check_one_channel(one_channel);
    if (one_channel.empty()) return 0.0;
    double sum = 0.0;
    for (const float value : one_channel.pixels) sum += static_cast<double>(value);
    return sum / static_cast<double>(one_channel.pixels.size());
}

Image flip_colors(const Image& error) {
    check_one_channel(error);
    Image colors(error.width, error.height, 3);
    for (std::size_t i = 0; i < error.pixels.size(); ++i) {
        const float place = in_unit_range(error.pixels[i]) * static_cast<float>(kMagma.size() - 1);
        const std::size_t stop = std::min(static_cast<std::size_t>(place), kMagma.size() - 2);
        const float share = place - static_cast<float>(stop);
        for (std::size_t c = 0; c < 3; ++c)
            colors.pixels[3 * i + c] =
                (1.0f - share) * kMagma[stop][c] + share * kMagma[stop + 1][c];
    }
    return colors;
}

}  // namespace burnish
