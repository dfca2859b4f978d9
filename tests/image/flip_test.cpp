#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "burnish/compare.hpp"
#include "burnish/error.hpp"

namespace burnish {
namespace {

using Real = long double;
constexpr Real kPiReal = std::numbers::pi_v<Real>;

// The paper word for word: filters are squares of weights, nothing is separated, shortened or
// moved out of a sum. The matrix of sRGB comes from the chromaticities of its primaries and white.
namespace literal {

using Color = std::array<Real, 3>;
using Rows = std::array<Color, 3>;
using Plane = std::vector<Real>;

Color times(const Rows& m, const Color& v) {
    Color result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result[i] += m[i][j] * v[j];
    return result;
}

// Cramer's rule: the v with m v = w.
Color solve(const Rows& m, const Color& w) {
    const auto determinant = [](const Rows& a) {
        return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
               a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
               a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    };
    Color v{};
    for (std::size_t j = 0; j < 3; ++j) {
        Rows replaced = m;
        for (std::size_t i = 0; i < 3; ++i) replaced[i][j] = w[i];
        v[j] = determinant(replaced) / determinant(m);
    }
    return v;
}

Color xyz_of_chromaticity(Real x, Real y) {
    return {x / y, 1.0L, (1.0L - x - y) / y};
}

// Primaries of Rec. 709. White: D65 with the five digits of CIE 15.
Rows xyz_of_rgb() {
    const Color red = xyz_of_chromaticity(0.64L, 0.33L);
    const Color green = xyz_of_chromaticity(0.30L, 0.60L);
    const Color blue = xyz_of_chromaticity(0.15L, 0.06L);
    Rows m;
    for (std::size_t i = 0; i < 3; ++i) m[i] = {red[i], green[i], blue[i]};
    const Color scale = solve(m, xyz_of_chromaticity(0.31271L, 0.32902L));
    for (Color& row : m)
        for (std::size_t j = 0; j < 3; ++j) row[j] *= scale[j];
    return m;
}

const Rows kMatrix = xyz_of_rgb();
const Color kWhite = times(kMatrix, {1.0L, 1.0L, 1.0L});

Real decode(Real v) {
    return v <= 0.04045L ? v / 12.92L : std::pow((v + 0.055L) / 1.055L, 2.4L);
}

Color ycxcz_of(const Color& rgb) {
    const Color xyz = times(kMatrix, rgb);
    const Real x = xyz[0] / kWhite[0], y = xyz[1] / kWhite[1], z = xyz[2] / kWhite[2];
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Color rgb_of_ycxcz(const Color& c) {
    const Real y = (c[0] + 16) / 116, x = y + c[1] / 500, z = y - c[2] / 200;
    return solve(kMatrix, {x * kWhite[0], y * kWhite[1], z * kWhite[2]});
}

Color lab_of(const Color& rgb) {
    const Color xyz = times(kMatrix, rgb);
    const auto f = [](Real t) {
        return t > 216.0L / 24389 ? std::cbrt(t) : (24389.0L / 27 * t + 16) / 116;
    };
    const Real x = f(xyz[0] / kWhite[0]), y = f(xyz[1] / kWhite[1]), z = f(xyz[2] / kWhite[2]);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Color hunt(const Color& lab) {
    return {lab[0], lab[1] * 0.01L * lab[0], lab[2] * 0.01L * lab[0]};
}

Real hyab(const Color& p, const Color& q) {
    return std::abs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]);
}

// A square of (2 radius + 1)^2 weights.
struct Square {
    int radius;
    Plane weights;
    Square(int r, const std::function<Real(Real, Real)>& weight) : radius(r) {
        for (int y = -r; y <= r; ++y)
            for (int x = -r; x <= r; ++x) weights.push_back(weight(x, y));
    }
    Real filtered(const Plane& plane, int width, int height, int x, int y) const {
        Real sum = 0;
        std::size_t k = 0;
        for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx) {
                const int px = std::clamp(x + dx, 0, width - 1);
                const int py = std::clamp(y + dy, 0, height - 1);
                sum += weights[k++] * plane[static_cast<std::size_t>(py * width + px)];
            }
        return sum;
    }
};

Square sensitivity(Real a1, Real b1, Real a2, Real b2, Real ppd) {
    const int radius =
        static_cast<int>(std::ceil(3 * std::sqrt(0.04L / (2 * kPiReal * kPiReal)) * ppd));
    Square square(radius, [&](Real x, Real y) {
        const Real d2 = (x * x + y * y) / (ppd * ppd);
        return a1 * std::sqrt(kPiReal / b1) * std::exp(-kPiReal * kPiReal * d2 / b1) +
               a2 * std::sqrt(kPiReal / b2) * std::exp(-kPiReal * kPiReal * d2 / b2);
    });
    Real sum = 0;
    for (const Real w : square.weights) sum += w;
    for (Real& w : square.weights) w /= sum;
    return square;
}

enum class Feature { edge, point };

Square detector(Feature feature, bool along_x, Real ppd) {
    const Real sd = 0.5L * 0.082L * ppd;
    Square square(static_cast<int>(std::ceil(3 * sd)), [&](Real x, Real y) {
        const Real gaussian = std::exp(-(x * x + y * y) / (2 * sd * sd));
        const Real t = along_x ? x : y;
        return (feature == Feature::edge ? -t : t * t / (sd * sd) - 1) * gaussian;
    });
    Real positive = 0, negative = 0;
    for (const Real w : square.weights) (w > 0 ? positive : negative) += w;
    for (Real& w : square.weights) w /= w > 0 ? positive : -negative;
    return square;
}

struct Picture {
    int width, height;
    std::array<Plane, 3> ycxcz;
    Plane luminance;
    explicit Picture(const Image& image) : width(image.width), height(image.height) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const float* p = image.at(x, y);
                const Color c = ycxcz_of({decode(p[0]), decode(p[1]), decode(p[2])});
                for (std::size_t k = 0; k < 3; ++k) ycxcz[k].push_back(c[k]);
                luminance.push_back((c[0] + 16) / 116);
            }
    }
};

Color filtered_lab(const Picture& p, const std::array<Square, 3>& filters, int x, int y) {
    Color c{};
    for (std::size_t k = 0; k < 3; ++k)
        c[k] = filters[k].filtered(p.ycxcz[k], p.width, p.height, x, y);
    Color rgb = rgb_of_ycxcz(c);
    for (Real& value : rgb) value = std::clamp(value, 0.0L, 1.0L);
    return hunt(lab_of(rgb));
}

Real redistributed(Real distance) {
    const Real largest = std::pow(hyab(hunt(lab_of({0, 1, 0})), hunt(lab_of({0, 0, 1}))), 0.7L);
    const Real powered = std::pow(distance, 0.7L), knee = 0.4L * largest;
    if (powered < knee) return 0.95L / knee * powered;
    return 0.95L + (powered - knee) / (largest - knee) * 0.05L;
}

Image flip(const Image& reference, const Image& test, double pixels_per_degree) {
    const Real ppd = pixels_per_degree;
    const std::array<Square, 3> filters = {sensitivity(1, 0.0047L, 0, 1e-5L, ppd),
                                           sensitivity(1, 0.0053L, 0, 1e-5L, ppd),
                                           sensitivity(34.1L, 0.04L, 13.5L, 0.025L, ppd)};
    const std::array<Square, 4> detectors = {
        detector(Feature::edge, true, ppd), detector(Feature::edge, false, ppd),
        detector(Feature::point, true, ppd), detector(Feature::point, false, ppd)};
    const Picture r(reference), t(test);
    Image result(r.width, r.height, 1);
    for (int y = 0; y < r.height; ++y)
        for (int x = 0; x < r.width; ++x) {
            const Real color =
                redistributed(hyab(filtered_lab(r, filters, x, y), filtered_lab(t, filters, x, y)));
            const auto magnitude = [&](const Picture& p, std::size_t first) {
                return std::hypot(
                    detectors[first].filtered(p.luminance, p.width, p.height, x, y),
                    detectors[first + 1].filtered(p.luminance, p.width, p.height, x, y));
            };
            const Real larger = std::max(std::abs(magnitude(r, 0) - magnitude(t, 0)),
                                         std::abs(magnitude(r, 2) - magnitude(t, 2)));
            const Real feature = std::pow(larger / std::sqrt(2.0L), 0.5L);
            *result.at(x, y) = static_cast<float>(std::pow(color, 1 - feature));
        }
    return result;
}

}  // namespace literal

Image random_picture(unsigned seed, int width = 24, int height = 20) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(0.0f, 1.0f);
    Image image(width, height, 3);
    for (float& v : image.pixels) v = value(random);
    return image;
}

Image flat(float r, float g, float b, int width = 24, int height = 20) {
    Image image(width, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) std::copy_n(std::array{r, g, b}.data(), 3, image.at(x, y));
    return image;
}

// A flat picture with a vertical bar over the columns of [from, to).
Image bar(int from, int to, std::array<float, 3> color, float ground) {
    Image image = flat(ground, ground, ground);
    for (int y = 0; y < image.height; ++y)
        for (int x = from; x < to; ++x) std::copy_n(color.data(), 3, image.at(x, y));
    return image;
}

double largest_difference(const Image& a, const Image& b) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    double most = 0.0;
    for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i)
        most = std::max(most, std::abs(static_cast<double>(a.pixels[i] - b.pixels[i])));
    return most;
}

// The program keeps planes and results in float: 6e-8 of values near 1. The power of 1 - dE_f
// magnifies that about ten times. The largest difference measured is 7e-7.
constexpr double kAgreement = 2e-6;

TEST(Flip, OfRandomPicturesAgreesWithTheLiteralFormulas) {
    for (const double ppd : {67.0, 30.0, 7.5}) {
        const Image a = random_picture(1), b = random_picture(2);
        EXPECT_LT(largest_difference(flip_error(a, b, ppd), literal::flip(a, b, ppd)), kAgreement)
            << ppd;
    }
}

// The filters of the three channels differ in width: beside an edge of pure colors, filtered values
// leave [0, 1] on both sides.
TEST(Flip, OfPureColorsAgreesWithTheLiteralFormulas) {
    for (const std::array<float, 3>& color :
         {std::array{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}})
        for (const float ground : {0.0f, 1.0f}) {
            const Image a = bar(0, 12, color, ground), b = bar(0, 14, color, ground);
            EXPECT_LT(largest_difference(flip_error(a, b), literal::flip(a, b, 67.0)), kAgreement);
        }
}

TEST(Flip, OfAShiftedEdgeAgreesWithTheLiteralFormulas) {
    const Image a = bar(0, 12, {0.9f, 0.7f, 0.2f}, 0.1f), b = bar(0, 13, {0.9f, 0.7f, 0.2f}, 0.1f);
    const Image error = flip_error(a, b);
    EXPECT_LT(largest_difference(error, literal::flip(a, b, 67.0)), kAgreement);
    EXPECT_GT(*error.at(12, 10), 0.3f);  // so that the agreement is not one of zeros
}

TEST(Flip, OfFaintNoiseAgreesWithTheLiteralFormulas) {
    const Image a = random_picture(3);
    Image b = a;
    const Image noise = random_picture(4);
    for (std::size_t i = 0; i < b.pixels.size(); ++i)
        b.pixels[i] = 0.98f * b.pixels[i] + 0.02f * noise.pixels[i];
    EXPECT_LT(largest_difference(flip_error(a, b), literal::flip(a, b, 67.0)), kAgreement);
}

// All filters reach over both borders.
TEST(Flip, OfPicturesSmallerThanTheFiltersAgreesWithTheLiteralFormulas) {
    for (const auto& [width, height] : {std::pair{1, 1}, {5, 1}, {1, 7}, {3, 2}}) {
        const Image a = random_picture(5, width, height), b = random_picture(6, width, height);
        EXPECT_LT(largest_difference(flip_error(a, b), literal::flip(a, b, 67.0)), kAgreement)
            << width << " x " << height;
    }
}

TEST(Flip, IsZeroForEqualPictures) {
    const Image a = random_picture(7);
    const Image error = flip_error(a, a);
    EXPECT_EQ(error.channels, 1);
    EXPECT_EQ(largest_difference(error, Image(24, 20, 1)), 0.0);
    EXPECT_EQ(mean_of(error), 0.0);
}

TEST(Flip, DoesNotDependOnTheOrderAndIsWithinZeroAndOne) {
    for (unsigned seed = 10; seed < 20; ++seed) {
        Image a = random_picture(seed), b = random_picture(seed + 100);
        for (Image* image : {&a, &b})  // black and white alone give the largest features
            if (seed % 2 == 0)
                for (float& v : image->pixels) v = std::round(v);
        const Image error = flip_error(a, b);
        EXPECT_EQ(largest_difference(error, flip_error(b, a)), 0.0);
        for (const float v : error.pixels) EXPECT_TRUE(v >= 0.0f && v <= 1.0f) << v;
    }
}

// Flat pictures have no features: dE is dE_c. 1e-6: float.
TEST(Flip, IsOneForGreenBesideBlueAndLessForAllOtherCornersOfTheCube) {
    const auto corner = [](unsigned bits) {
        return flat((bits & 1) != 0 ? 1.0f : 0.0f, (bits & 2) != 0 ? 1.0f : 0.0f,
                    (bits & 4) != 0 ? 1.0f : 0.0f, 2, 2);
    };
    EXPECT_NEAR(mean_of(flip_error(corner(2), corner(4))), 1.0, 1e-6);
    for (unsigned i = 0; i < 8; ++i)
        for (unsigned j = 0; j < i; ++j)
            if (!(i == 4 && j == 2)) {
                EXPECT_LT(mean_of(flip_error(corner(i), corner(j))), 0.9999);
            }
}

// The distance is 100 (L* alone), of 203.6 between green and blue.
TEST(Flip, OfBlackBesideWhiteFollowsFromTheirLightness) {
    const double largest = static_cast<double>(literal::hyab(
        literal::hunt(literal::lab_of({0, 1, 0})), literal::hunt(literal::lab_of({0, 0, 1}))));
    const double part = std::pow(100.0 / largest, 0.7);
    ASSERT_GT(part, 0.4);
    const double expected = 0.95 + 0.05 * (part - 0.4) / 0.6;
    const Image error = flip_error(flat(0, 0, 0), flat(1, 1, 1));
    for (const float v : error.pixels) EXPECT_NEAR(static_cast<double>(v), expected, 1e-6);
}

TEST(Flip, OfAShiftedLineIsLargerThanOfABlurredOne) {
    const std::array<float, 3> white = {1.0f, 1.0f, 1.0f};
    const Image line = bar(12, 13, white, 0.2f), shifted = bar(13, 14, white, 0.2f);
    Image blurred = line;
    for (int y = 0; y < line.height; ++y)
        for (int x = 1; x + 1 < line.width; ++x)
            for (int c = 0; c < 3; ++c)
                blurred.at(x, y)[c] =
                    0.25f * (line.at(x - 1, y)[c] + 2.0f * line.at(x, y)[c] + line.at(x + 1, y)[c]);
    EXPECT_GT(mean_of(flip_error(line, blurred)), 0.01);
    EXPECT_GT(mean_of(flip_error(line, shifted)), 1.2 * mean_of(flip_error(line, blurred)));
}

TEST(Flip, GrowsWithTheSizeOfADifference) {
    double before = 0.0;
    for (const float step : {0.02f, 0.05f, 0.1f, 0.2f, 0.4f}) {
        const double mean = mean_of(flip_error(
            flat(0.4f, 0.4f, 0.4f), bar(8, 16, {0.4f + step, 0.4f + step, 0.4f + step}, 0.4f)));
        EXPECT_GT(mean, 1.2 * before) << step;
        before = mean;
    }
}

// A checkerboard of single pixels melts into gray with more pixels in a degree. The gray has its
// mean luminance.
TEST(Flip, OfFineDetailIsSmallerFromFartherAway) {
    Image checkers = flat(0, 0, 0);
    for (int y = 0; y < checkers.height; ++y)
        for (int x = y % 2; x < checkers.width; x += 2) std::fill_n(checkers.at(x, y), 3, 1.0f);
    const float gray = 1.055f * std::pow(0.5f, 1.0f / 2.4f) - 0.055f;
    double before = 1.0;
    for (const double ppd : {10.0, 20.0, 40.0, 80.0, 160.0}) {
        const Image error = flip_error(checkers, flat(gray, gray, gray), ppd);
        const double middle = static_cast<double>(*error.at(12, 10));
        EXPECT_LT(middle, before) << ppd;
        before = middle;
    }
    EXPECT_LT(before, 0.01);
}

TEST(Flip, TakesValuesOutsideAsTheNearestAndDoesNotReadAlpha) {
    const Image a = random_picture(30);
    Image wild(a.width, a.height, 4), tame(a.width, a.height, 3);
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const float nan = std::numeric_limits<float>::quiet_NaN();
            std::copy_n(std::array{1.5f, -0.5f, nan, nan}.data(), 4, wild.at(x, y));
            *tame.at(x, y) = 1.0f;
        }
    EXPECT_EQ(largest_difference(flip_error(a, wild), flip_error(a, tame)), 0.0);
}

TEST(Flip, RefusesPicturesThatItCannotCompare) {
    const Image a = random_picture(1);
    EXPECT_THROW(flip_error(a, random_picture(1, 20, 24)), Error);
    EXPECT_THROW(flip_error(a, Image(24, 20, 1)), Error);
    EXPECT_THROW(flip_error(Image{}, Image{}), Error);
    for (const double ppd : {0.0, 0.5, -67.0, 1001.0, std::nan("")})
        EXPECT_THROW(flip_error(a, a, ppd), Error) << ppd;
    EXPECT_THROW(mean_of(a), Error);
    EXPECT_THROW(flip_colors(a), Error);
}

TEST(FlipMean, IsTheMeanOfTheValues) {
    Image image(2, 2, 1);
    image.pixels = {0.0f, 0.25f, 0.5f, 1.0f};
    EXPECT_EQ(mean_of(image), 0.4375);
    EXPECT_EQ(mean_of(Image{}), 0.0);
}

TEST(FlipColors, RiseInLightnessFromBlackToLightYellow) {
    Image ramp(1001, 1, 1);
    for (int x = 0; x < ramp.width; ++x) *ramp.at(x, 0) = static_cast<float>(x) / 1000.0f;
    const Image colors = flip_colors(ramp);
    ASSERT_EQ(colors.channels, 3);
    double before = -1.0;
    for (int x = 0; x < ramp.width; ++x) {
        literal::Color rgb{};
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_TRUE(colors.at(x, 0)[c] >= 0.0f && colors.at(x, 0)[c] <= 1.0f);
            rgb[c] = literal::decode(static_cast<Real>(colors.at(x, 0)[c]));
        }
        const auto lightness = static_cast<double>(literal::lab_of(rgb)[0]);
        EXPECT_GT(lightness, before) << x;
        // No jump: 1000 even steps from 0 to 98 are 0.1 each.
        EXPECT_LT(lightness, std::max(before, 0.0) + 0.3) << x;
        before = lightness;
    }
    EXPECT_LT(*std::max_element(colors.at(0, 0), colors.at(1, 0)), 0.02f);
    const float* last = colors.at(1000, 0);
    EXPECT_TRUE(last[0] > 0.95f && last[1] > 0.95f && last[2] < 0.8f);  // light yellow
    EXPECT_GT(before, 95.0);
}

TEST(FlipColors, ArePurpleThenOrangeAndTakeValuesOutsideAsTheNearest) {
    Image values(5, 1, 1);
    values.pixels = {0.35f, 0.75f, -1.0f, 2.0f, std::numeric_limits<float>::quiet_NaN()};
    const Image colors = flip_colors(values);
    const float *purple = colors.at(0, 0), *orange = colors.at(1, 0);
    EXPECT_TRUE(purple[2] > purple[0] && purple[0] > 2.0f * purple[1]);
    EXPECT_TRUE(orange[0] > 0.9f && orange[1] > orange[2] && orange[1] < 0.7f);
    Image ends(3, 1, 1);
    ends.pixels = {0.0f, 1.0f, 0.0f};
    const Image expected = flip_colors(ends);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(colors.pixels[6 + i], expected.pixels[i]);
}

}  // namespace
}  // namespace burnish
