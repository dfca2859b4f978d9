// Pictures of the simulated camera: the rig's geometry in closed form, noise by its statistics.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <string>

#include "burnish/virtual_sample.hpp"
#include "table_support.hpp"

namespace burnish {
namespace {

// A uniform sample; `albedo` in all channels.
VirtualSample uniform(int side, double albedo, double specular) {
    VirtualSample out;
    out.name = "uniform";
    out.width = out.height = side;
    out.width_mm = out.height_mm = 60;
    out.eta = 0;
    out.ndfs = {{"one", {{1.0, Mdf::beckmann, 0.2, 0.4, 0.0, 0.0, 0.0}}}};
    const Vec3d d{albedo, albedo, albedo}, s{specular, specular, specular};
    out.texels.assign(static_cast<std::size_t>(side * side), {0, 0.3, d, s, {0, 0, 1}});
    return out;
}

Rig rig_of(const VirtualSample& sample, const std::vector<RigLight>& lights) {
    Rig rig;
    rig.width_mm = sample.width_mm;
    rig.height_mm = sample.height_mm;
    rig.camera = {true, {0, -300, 400}};
    rig.lights = lights;
    return rig;
}

RigLight near_light(const Vec3d& at, double exponent, const Vec3d& intensity) {
    RigLight light;
    light.place = {true, at};
    light.emission_exponent = exponent;
    light.intensity = intensity;
    return light;
}

// Pixel centers, row 0 at the top, +y up, the origin in the middle.
Vec3d center(const VirtualSample& sample, int column, int row) {
    return {sample.width_mm * ((column + 0.5) / sample.width - 0.5),
            sample.height_mm * (0.5 - (row + 0.5) / sample.height), 0};
}

struct Seen {
    Vec3d direction;
    double distance;
};
Seen seen_from(const Vec3d& point, const Vec3d& at) {
    Vec3d v = {at[0] - point[0], at[1] - point[1], at[2] - point[2]};
    const double r = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (double& c : v) c /= r;
    return {v, r};
}

// Lambert under an LED that shines straight down: albedo/pi cos L cos^m / r^2, both cosines z / r.
TEST(VirtualPicture, DistanceAndEmissionAreThoseOfTheRig) {
    const VirtualSample sample = uniform(16, 0.5, 0);
    for (const double m : {0.0, 1.0, 2.5}) {
        const Vec3d at{20, -15, 40}, intensity{1000, 2000, 500};
        const Rig rig = rig_of(sample, {near_light(at, m, intensity)});
        const Image picture = virtual_picture(sample, rig, 0, {});
        ASSERT_EQ(picture.width, 16);
        ASSERT_EQ(picture.channels, 3);
        for (int row = 0; row < 16; ++row) {
            for (int column = 0; column < 16; ++column) {
                const Seen light = seen_from(center(sample, column, row), at);
                const double cosine = 40 / light.distance;
                for (std::size_t c = 0; c < 3; ++c) {
                    const double expected = 0.5 / kPi * cosine * intensity[c] *
                                            std::pow(cosine, m) / (light.distance * light.distance);
                    EXPECT_NEAR(static_cast<double>(picture.at(column, row)[c]), expected,
                                1e-6 * expected)
                        << m << " at " << column << " " << row;
                }
            }
        }
    }
}

// An LED with a tilted axis, a light at infinity, and a specular lobe.
TEST(VirtualPicture, AxesFarLightsAndGlossAreFollowed) {
    const VirtualSample sample = uniform(8, 0.2, 0.3);
    RigLight tilted = near_light({-50, 10, 60}, 2, {3000, 3000, 3000});
    tilted.emission_axis = {0.6, 0, -0.8};
    RigLight far;
    far.place = {false, {0, 0.6, 0.8}};
    far.intensity = {2, 3, 4};
    const Rig rig = rig_of(sample, {tilted, far});
    const Image under_led = virtual_picture(sample, rig, 0, {});
    const Image under_far = virtual_picture(sample, rig, 1, {});
    for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 8; ++column) {
            const Vec3d point = center(sample, column, row);
            const Vec3d eye = seen_from(point, {0, -300, 400}).direction;
            const Seen led = seen_from(point, {-50, 10, 60});
            const double axis = -(0.6 * led.direction[0] - 0.8 * led.direction[2]);
            const VirtualTexel& texel = sample.at(column, row);
            const double near_value = virtual_brdf(sample, texel, led.direction, eye)[1] *
                                      led.direction[2] * 3000 * axis * axis /
                                      (led.distance * led.distance);
            const double far_value = virtual_brdf(sample, texel, far.place.at, eye)[2] * 0.8 * 4;
            EXPECT_NEAR(static_cast<double>(under_led.at(column, row)[1]), near_value,
                        1e-6 * near_value);
            EXPECT_NEAR(static_cast<double>(under_far.at(column, row)[2]), far_value,
                        1e-6 * far_value);
        }
    }
}

TEST(VirtualPicture, WhiteLevelIsTheBrightestOfADiffuser) {
    const VirtualSample sample = uniform(16, 1, 0);
    for (const Rig& rig : {make_dome_rig(sample, 24, {}), make_bar_rig(sample, 4, 3, {}),
                           rig_of(sample, {near_light({5, 5, 50}, 1, {100, 400, 900})})}) {
        float most = 0;
        for (std::size_t l = 0; l < rig.lights.size(); ++l) {
            const Image picture = virtual_picture(sample, rig, l, {});
            for (const float v : picture.pixels) most = std::max(most, v);
        }
        // The white level is that of the brightest pixel, or of the brightest point between pixels
        // 3.75 mm apart under a bar 40 mm above.
        EXPECT_GE(white_level(sample, rig), 0.95 * static_cast<double>(most));
        EXPECT_LE(white_level(sample, rig), 1.05 * static_cast<double>(most));
    }
}

struct Statistics {
    double mean = 0, deviation = 0, neighbors = 0;  // correlation of each value with the next
};
Statistics statistics_of(const Image& picture, std::size_t channel) {
    std::vector<double> v;
    for (std::size_t i = channel; i < picture.pixels.size(); i += 3)
        v.push_back(static_cast<double>(picture.pixels[i]));
    Statistics out;
    for (const double x : v) out.mean += x / static_cast<double>(v.size());
    double products = 0;
    for (std::size_t i = 0; i < v.size(); ++i) {
        out.deviation += (v[i] - out.mean) * (v[i] - out.mean);
        if (i + 1 < v.size()) products += (v[i] - out.mean) * (v[i + 1] - out.mean);
    }
    out.neighbors = products / out.deviation;
    out.deviation = std::sqrt(out.deviation / static_cast<double>(v.size()));
    return out;
}

Rig far_rig(const VirtualSample& sample) {
    RigLight bright, dim;
    bright.place = dim.place = {false, {0, 0, 1}};
    dim.intensity = {0.1, 0.1, 0.1};
    Rig rig = rig_of(sample, {bright, dim});
    rig.camera = {false, {0.6, 0, 0.8}};
    return rig;
}

// The deviation is relative to (value + 0.02 of a white diffuser in its place). With 16384 pixels
// the standard error of the mean is 1/128 of the deviation and that of the deviation 1/181 of
// itself; the tolerance is four of each.
TEST(VirtualPicture, NoiseHasTheStatedMeanAndDeviation) {
    const VirtualSample sample = uniform(128, 0.5, 0);
    const Rig rig = far_rig(sample);
    for (const double noise : {0.01, 0.05}) {
        for (std::size_t light = 0; light < 2; ++light) {
            VirtualCamera camera;
            camera.noise = noise;
            const double value = 0.5 / kPi * (light == 0 ? 1 : 0.1);
            const double deviation = noise * (value + 0.02 * value / 0.5);
            const Image picture = virtual_picture(sample, rig, light, camera);
            for (std::size_t c = 0; c < 3; ++c) {
                const Statistics found = statistics_of(picture, c);
                EXPECT_NEAR(found.mean, value, 4 * deviation / 128);
                EXPECT_NEAR(found.deviation, deviation, 4 * deviation / 181);
                EXPECT_NEAR(found.neighbors, 0, 4.0 / 128);
            }
        }
    }
}

double correlation(const Image& a, const Image& b, float middle) {
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const auto x = static_cast<double>(a.pixels[i] - middle);
        const auto y = static_cast<double>(b.pixels[i] - middle);
        ab += x * y, aa += x * x, bb += y * y;
    }
    return ab / std::sqrt(aa * bb);
}

// Another picture or another seed gives other noise; the same seed gives the same noise.
TEST(VirtualPicture, NoiseIsOfItsSeedAndLight) {
    const VirtualSample sample = uniform(64, 0.5, 0);
    Rig rig = far_rig(sample);
    rig.lights[1] = rig.lights[0];
    VirtualCamera camera;
    camera.noise = 0.02;
    const Image first = virtual_picture(sample, rig, 0, camera);
    EXPECT_EQ(first.pixels, virtual_picture(sample, rig, 0, camera).pixels);
    const auto middle = static_cast<float>(0.5 / kPi);
    // 4 / sqrt(12288 samples)
    EXPECT_NEAR(correlation(first, virtual_picture(sample, rig, 1, camera), middle), 0, 0.036);
    camera.seed = 2;
    EXPECT_NEAR(correlation(first, virtual_picture(sample, rig, 0, camera), middle), 0, 0.036);
    Image green = first;  // channels have independent noise
    for (std::size_t i = 0; i + 2 < green.pixels.size(); i += 3)
        std::rotate(green.pixels.begin() + static_cast<std::ptrdiff_t>(i),
                    green.pixels.begin() + static_cast<std::ptrdiff_t>(i + 1),
                    green.pixels.begin() + static_cast<std::ptrdiff_t>(i + 3));
    EXPECT_NEAR(correlation(first, green, middle), 0, 0.036);
}

TEST(VirtualPicture, IsTheSameOnAnyNumberOfThreads) {
    VirtualSettings settings;
    settings.width = settings.height = 48;
    const VirtualSample sample = make_virtual_sample("classes", settings);
    const Rig rig = make_bar_rig(sample, 3, 3, {});
    VirtualCamera camera;
    camera.noise = 0.02;
    using Control = oneapi::tbb::global_control;
    const auto pictures = [&](std::size_t threads) {
        const Control limit(Control::max_allowed_parallelism, threads);
        std::vector<float> all;
        for (std::size_t l = 0; l < rig.lights.size(); ++l) {
            const Image picture = virtual_picture(sample, rig, l, camera);
            all.insert(all.end(), picture.pixels.begin(), picture.pixels.end());
        }
        return all;
    };
    EXPECT_EQ(pictures(1), pictures(2));
}

TEST(VirtualPicture, ClippedPixelsEndAtTheStatedShareOfWhite) {
    const VirtualSample sample = uniform(32, 0.1, 0.5);
    Rig rig = make_dome_rig(sample, 30, {});
    const double white = white_level(sample, rig);
    VirtualCamera open, clipping;
    clipping.clip = 1.5;
    const auto level = static_cast<float>(1.5 * white);
    int clipped = 0, kept = 0;
    for (std::size_t l = 0; l < rig.lights.size(); ++l) {
        const Image a = virtual_picture(sample, rig, l, open);
        const Image b = virtual_picture(sample, rig, l, clipping);
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            EXPECT_NEAR(b.pixels[i], std::min(a.pixels[i], level), 1e-6f * level);
            (a.pixels[i] > level ? clipped : kept) += 1;
        }
    }
    EXPECT_GT(clipped, 100) << "nothing shines";
    EXPECT_GT(kept, 100);
}

// Lights of the bar: 40 mm above, facing down, cos^1; the camera at the requested distance and
// tilt.
TEST(VirtualRig, BarsAndDomesAreAsDescribed) {
    const VirtualSample sample = uniform(8, 0.5, 0);
    VirtualRigSettings settings;
    settings.camera_tilt_deg = 30;
    settings.camera_distance_mm = 500;
    const Rig bar = make_bar_rig(sample, 5, 4, settings);
    ASSERT_EQ(bar.lights.size(), 20u);
    for (const RigLight& light : bar.lights) {
        EXPECT_TRUE(light.place.near);
        EXPECT_NEAR(light.place.at[2], 40, 1e-12);
        EXPECT_EQ(light.emission_axis, (Vec3d{0, 0, -1}));
        EXPECT_EQ(light.emission_exponent, 1);
    }
    const Rig dome = make_dome_rig(sample, 50, settings);
    ASSERT_EQ(dome.lights.size(), 50u);
    for (const Rig& rig : {bar, dome}) {
        EXPECT_EQ(rig.width_mm, 60);
        EXPECT_EQ(rig.height_mm, 60);
        ASSERT_TRUE(rig.camera.near);
        const Seen camera = seen_from({0, 0, 0}, rig.camera.at);
        EXPECT_NEAR(camera.distance, 500, 1e-9);
        EXPECT_NEAR(camera.direction[2], std::cos(kPi / 6), 1e-12);
        for (std::size_t i = 0; i < rig.lights.size(); ++i) {
            EXPECT_GT(rig.lights[i].place.at[2], 0);
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_NE(rig.lights[i].place.at, rig.lights[k].place.at);
        }
    }
    settings.camera_distance_mm = 0;
    const RigPlace far = make_dome_rig(sample, 5, settings).camera;
    EXPECT_FALSE(far.near);
    EXPECT_NEAR(far.at[2], std::cos(kPi / 6), 1e-12);
}

}  // namespace
}  // namespace burnish
