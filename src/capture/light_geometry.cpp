#include "capture/light_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "burnish/f32.hpp"

namespace burnish {

LightGeometry::LightGeometry(const Rig& rig, int width, int height)
    : rig_(rig), width_(width), height_(height) {
    all_far_ = !rig.camera.near && std::none_of(rig.lights.begin(), rig.lights.end(),
                                                [](const RigLight& l) { return l.place.near; });
    if (!all_far_) return;
    all_far_ = false;
    at(0, far_);
    all_far_ = true;
}

void LightGeometry::at(std::size_t pixel, PointLights& out) const {
    if (all_far_) {
        out = far_;
        return;
    }
    const int row = static_cast<int>(pixel / static_cast<std::size_t>(width_));
    const int column = static_cast<int>(pixel % static_cast<std::size_t>(width_));
    const Vec3d point = sample_point(rig_, width_, height_, column, row);
    const std::size_t count = rig_.lights.size();
    out.x.resize(count);
    out.y.resize(count);
    out.z.resize(count);
    for (auto& channel : out.received) channel.resize(count);
    const Vec3d eye = direction_to(rig_.camera, point);
    out.to_eye = {static_cast<float>(eye[0]), static_cast<float>(eye[1]),
                  static_cast<float>(eye[2])};
    for (std::size_t k = 0; k < count; ++k) {
        const Arrival in = arrival(rig_.lights[k], point);
        out.x[k] = static_cast<float>(in.to_light[0]);
        out.y[k] = static_cast<float>(in.to_light[1]);
        out.z[k] = static_cast<float>(in.to_light[2]);
        for (std::size_t c = 0; c < 3; ++c)
            out.received[c][k] = static_cast<float>(in.irradiance_per_cosine[c]);
    }
}

GridPlace grid_place(const NdfGrid& grid, float x, float y, float z) {
    const float at = std::clamp(ndf_u(z) * static_cast<float>(grid.rings) - 0.5f, 0.0f,
                                static_cast<float>(grid.rings - 1));
    GridPlace place;
    place.ring = std::min(static_cast<int>(at), grid.rings - 1);
    place.fraction = at - static_cast<float>(place.ring);
    place.column = std::atan2(y, x) * static_cast<float>(grid.azimuths) *
                   (0.5f * std::numbers::inv_pi_v<float>);
    return place;
}

GridPlace area_place(float x, float y, float z) {
    const float theta = std::acos(std::clamp(z, 0.0f, 1.0f));
    const float s =
        std::sqrt(std::max(1.0f - theta * (2.0f * std::numbers::inv_pi_v<float>), 0.0f));
    const float at = s * static_cast<float>(kAreaGrid.rings - 1);
    GridPlace place;
    place.ring = std::min(static_cast<int>(at), kAreaGrid.rings - 1);
    place.fraction = at - static_cast<float>(place.ring);
    place.column = std::atan2(y, x) * static_cast<float>(kAreaGrid.azimuths) *
                   (0.5f * std::numbers::inv_pi_v<float>);
    return place;
}

void gather_samples(const PointLights& lights, const Vec3f& normal, std::span<const float> values,
                    std::span<const std::uint8_t> keep, const NdfGrid& grid, PointSamples& out) {
    out.light.clear();
    out.half.clear();
    out.in.clear();
    out.cosine_ih.clear();
    out.received.clear();
    out.value.clear();
    out.to_light.clear();
    for (std::size_t c = 0; c < 3; ++c) {
        out.weight_rgb[c].clear();
        out.value_rgb[c].clear();
    }
    const f32::Frame frame = f32::frame_shortest_arc(f32::vec3(normal[0], normal[1], normal[2]));
    const auto local = [&](float x, float y, float z) {
        const f32::vec3 v(x, y, z);
        return Vec3f{f32::dot(frame.t, v), f32::dot(frame.b, v), f32::dot(frame.n, v)};
    };
    const Vec3f o = local(lights.to_eye[0], lights.to_eye[1], lights.to_eye[2]);
    out.to_eye = o;
    out.out = area_place(o[0], o[1], o[2]);
    for (std::size_t k = 0; k < lights.size(); ++k) {
        if (!keep.empty() && !keep[k]) continue;
        const float* v = values.data() + 3 * k;
        if (std::isinf(v[0]) || std::isinf(v[1]) || std::isinf(v[2])) continue;
        const Vec3f i = local(lights.x[k], lights.y[k], lights.z[k]);
        if (i[2] < kLeastLightCosine) continue;
        const Vec3f sum = {i[0] + o[0], i[1] + o[1], i[2] + o[2]};
        const float length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
        out.light.push_back(static_cast<int>(k));
        out.half.push_back(grid_place(grid, sum[0], sum[1], sum[2] / length));
        out.in.push_back(area_place(i[0], i[1], i[2]));
        out.to_light.push_back(i);
        out.cosine_ih.push_back(0.5f * length);
        float received = 0.0f, value = 0.0f;
        for (std::size_t c = 0; c < 3; ++c) {
            const float w = i[2] * lights.received[c][k];
            out.weight_rgb[c].push_back(w);
            out.value_rgb[c].push_back(v[c]);
            received += kLuminance[c] * w;
            value += kLuminance[c] * v[c];
        }
        out.received.push_back(received);
        out.value.push_back(value);
    }
}

float relative_fresnel(float eta, float cosine) {
    if (eta <= 0.0f) return 1.0f;
    return f32::fresnel_conductor(eta, 0.0f, cosine) / f32::fresnel_conductor(eta, 0.0f, 1.0f);
}

}  // namespace burnish
