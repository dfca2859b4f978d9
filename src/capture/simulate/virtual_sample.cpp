#include "burnish/virtual_sample.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "burnish/f64.hpp"
#include "core/constants.hpp"
#include "core/parallel.hpp"

namespace burnish {

namespace {

double inner_product(const Vec3d& a, const Vec3d& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Components of `v` in the frame that the shortest rotation takes from z to `n`.
Vec3d in_frame_of(const Vec3d& n, const Vec3d& v) {
    const f64::Frame frame = f64::frame_shortest_arc(f64::vec3(n[0], n[1], n[2]));
    const f64::vec3 d(v[0], v[1], v[2]);
    return {f64::dot(frame.t, d), f64::dot(frame.b, d), f64::dot(frame.n, d)};
}

double fresnel_over_normal(double eta, double cosine) {
    if (eta <= 0.0) return 1.0;
    return f64::fresnel_conductor(eta, 0.0, cosine) / f64::fresnel_conductor(eta, 0.0, 1.0);
}

// A counter-based generator (the finaliser of SplitMix64): the same noise in any order of work.
double uniform_at(std::uint64_t counter) {
    std::uint64_t z = counter * 0x9e3779b97f4a7c15ULL + 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    z ^= z >> 31;
    return (static_cast<double>(z >> 11) + 0.5) * 0x1p-53;
}

double normal_at(std::uint64_t counter) {  // Box & Muller 1958
    const double radius = std::sqrt(-2.0 * std::log(uniform_at(2 * counter)));
    return radius * std::cos(2.0 * std::numbers::pi * uniform_at(2 * counter + 1));
}

RigPlace tilted_camera(const VirtualRigSettings& settings) {
    const double tilt = settings.camera_tilt_deg * kDegree;
    RigPlace place;
    place.at = {0.0, -std::sin(tilt), std::cos(tilt)};
    if (settings.camera_distance_mm > 0.0) {
        place.near = true;
        for (double& c : place.at) c *= settings.camera_distance_mm;
    }
    return place;
}

Rig empty_rig(const VirtualSample& sample, const VirtualRigSettings& settings) {
    Rig rig;
    rig.width_mm = sample.width_mm;
    rig.height_mm = sample.height_mm;
    rig.camera = tilted_camera(settings);
    rig.intensity_stated = true;
    return rig;
}

}  // namespace

Vec3d virtual_brdf(const VirtualSample& sample, const VirtualTexel& texel, const Vec3d& to_light,
                   const Vec3d& to_eye) {
    const Vec3d i = in_frame_of(texel.normal, to_light), o = in_frame_of(texel.normal, to_eye);
    if (i[2] <= 0.0 || o[2] <= 0.0) return {};
    const Vec3d sum = {i[0] + o[0], i[1] + o[1], i[2] + o[2]};
    const double length = std::sqrt(inner_product(sum, sum));
    const Vec3d h = {sum[0] / length, sum[1] / length, sum[2] / length};
    const VirtualNdf& ndf = sample.ndfs[static_cast<std::size_t>(texel.ndf)];
    const auto own = [&](const Vec3d& v) { return rotated_about_z(v, -texel.grain); };
    const double shape = ndf.D(own(h)) * fresnel_over_normal(sample.eta, 0.5 * length) /
                         (4.0 * ndf.area(own(i)) * ndf.area(own(o)));
    Vec3d rho;
    for (std::size_t c = 0; c < 3; ++c)
        rho[c] = texel.diffuse[c] / std::numbers::pi + texel.specular[c] * shape;
    return rho;
}

Image virtual_picture(const VirtualSample& sample, const Rig& rig, std::size_t light,
                      const VirtualCamera& camera) {
    const RigLight& lamp = rig.lights[light];
    const RigPlace& eye = lamp.camera ? *lamp.camera : rig.camera;
    const double most =
        camera.clip > 0.0 ? camera.clip * white_level(sample, rig) : f64::kMostValue;
    Image image(sample.width, sample.height, 3);
    parallel_for(
        static_cast<std::size_t>(sample.height), 4, [&](std::size_t begin, std::size_t end) {
            for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
                for (int column = 0; column < sample.width; ++column) {
                    const VirtualTexel& texel = sample.at(column, row);
                    const Vec3d x = sample_point(rig, sample.width, sample.height, column, row);
                    const Arrival in = arrival(lamp, x);
                    const double cosine = std::max(inner_product(texel.normal, in.to_light), 0.0);
                    const Vec3d rho =
                        virtual_brdf(sample, texel, in.to_light, direction_to(eye, x));
                    for (std::size_t c = 0; c < 3; ++c) {
                        const double received = cosine * in.irradiance_per_cosine[c];
                        const std::uint64_t counter =
                            ((camera.seed * 4096 + light) << 32) +
                            (static_cast<std::uint64_t>(row) *
                                 static_cast<std::uint64_t>(sample.width) +
                             static_cast<std::uint64_t>(column)) *
                                3 +
                            c;
                        double value = rho[c] * received;
                        if (camera.noise > 0.0)
                            value += camera.noise * normal_at(counter) *
                                     (value + kNoiseFloor * received / std::numbers::pi);
                        image.at(column, row)[c] = static_cast<float>(std::clamp(value, 0.0, most));
                    }
                }
        });
    return image;
}

double white_level(const VirtualSample& sample, const Rig& rig) {
    double most = 0.0;
    const std::array<int, 3> columns = {0, sample.width / 2, sample.width - 1};
    const std::array<int, 3> rows = {0, sample.height / 2, sample.height - 1};
    for (const RigLight& light : rig.lights)
        for (const int row : rows)
            for (const int column : columns) {
                const Arrival in =
                    arrival(light, sample_point(rig, sample.width, sample.height, column, row));
                for (const double irradiance : in.irradiance_per_cosine)
                    most = std::max(most, irradiance * std::max(in.to_light[2], 0.0));
            }
    return most / std::numbers::pi;
}

Rig make_bar_rig(const VirtualSample& sample, int leds, int steps,
                 const VirtualRigSettings& settings) {
    constexpr double kHeight = 40.0;  // W08: about 4 cm above the sample
    // Lights extend to 75 degrees from the normal at the middle of the sample.
    const double reach = kHeight * std::tan(75.0 * kDegree);
    Rig rig = empty_rig(sample, settings);
    const auto place = [](int k, int count, double half) {
        return count > 1 ? half * (2.0 * k / (count - 1) - 1.0) : 0.0;
    };
    for (int step = 0; step < steps; ++step)
        for (int led = 0; led < leds; ++led) {
            RigLight light;
            light.place = {true, {place(led, leds, reach), place(step, steps, reach), kHeight}};
            // This intensity gives a white diffuser a radiance of 1 directly below the lamp.
            light.intensity = {kHeight * kHeight, kHeight * kHeight, kHeight * kHeight};
            light.emission_exponent = 1.0;
            rig.lights.push_back(light);
        }
    return rig;
}

Rig make_dome_rig(const VirtualSample& sample, int lights, const VirtualRigSettings& settings) {
    Rig rig = empty_rig(sample, settings);
    const double lowest = std::cos(75.0 * kDegree);
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    for (int k = 0; k < lights; ++k) {
        const double z = 1.0 - (1.0 - lowest) * (k + 0.5) / lights;
        const double r = std::sqrt(1.0 - z * z);
        RigLight light;
        light.place.at = {r * std::cos(golden * k), r * std::sin(golden * k), z};
        light.intensity = {1.0, 1.0, 1.0};
        rig.lights.push_back(light);
    }
    return rig;
}

}  // namespace burnish
