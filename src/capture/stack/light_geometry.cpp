#include "capture/stack/light_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

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

NormalFrame::NormalFrame(const Vec3f& normal) {
    const f32::Frame frame = f32::frame_shortest_arc(f32::vec3(normal[0], normal[1], normal[2]));
    t_ = {frame.t.x, frame.t.y, frame.t.z};
    b_ = {frame.b.x, frame.b.y, frame.b.z};
    n_ = {frame.n.x, frame.n.y, frame.n.z};
}

namespace {

// Splits `at`, in rings, into a ring and a fraction; clamped to the grid's rings.
inline GridPlace place_at(const NdfGrid& grid, float at, float x, float y) {
    at = std::clamp(at, 0.0f, static_cast<float>(grid.rings - 1));
    const int ring = static_cast<int>(at);
    return {ring, at - static_cast<float>(ring),
            f32::tabulated_turns(x, y) * static_cast<float>(grid.azimuths)};
}

// The angle to the normal in quarter turns, 0 to 1; (x, y, z) may have any length.
inline float slant(float x, float y, float z) {
    return f32::quarter_turns(std::max(z, 0.0f), std::sqrt(x * x + y * y));
}

}  // namespace

void PointSamples::resize(std::size_t count) {
    light.resize(count);
    half.resize(count);
    in.resize(count);
    to_light.resize(count);
    for (auto* numbers : {&cosine_ih, &received, &value}) numbers->resize(count);
    for (std::size_t c = 0; c < 3; ++c) {
        weight_rgb[c].resize(count);
        value_rgb[c].resize(count);
    }
}

GridPlace grid_place(const NdfGrid& grid, float x, float y, float z) {
    const float u = std::sqrt(slant(x, y, z));
    return place_at(grid, u * static_cast<float>(grid.rings) - 0.5f, x, y);
}

GridPlace area_place(float x, float y, float z) {
    const float s = std::sqrt(1.0f - slant(x, y, z));
    return place_at(kAreaGrid, s * static_cast<float>(kAreaGrid.rings - 1), x, y);
}

namespace {

// Directions in one block: a multiple of the lanes of a vector register, small enough for the
// first-level cache.
constexpr std::size_t kBlock = 64;
struct Block {
    std::array<float, kBlock> x, y, z;
};

// grid_place or area_place of each direction of a block.
template <bool kAreas>
void places(const NdfGrid& grid, const Block& d, std::size_t count, GridPlace* out) {
    std::array<float, kBlock> at, column;
    const auto most = static_cast<float>(grid.rings - 1);
    const auto columns = static_cast<float>(grid.azimuths);
    for (std::size_t k = 0; k < kBlock; ++k) {
        const float s = slant(d.x[k], d.y[k], d.z[k]);
        const float ring = kAreas ? std::sqrt(1.0f - s) * most
                                  : std::sqrt(s) * static_cast<float>(grid.rings) - 0.5f;
        at[k] = std::clamp(ring, 0.0f, most);
        column[k] = f32::tabulated_turns(d.x[k], d.y[k]) * columns;
    }
    for (std::size_t k = 0; k < count; ++k) {
        const int ring = static_cast<int>(at[k]);
        out[k] = {ring, at[k] - static_cast<float>(ring), column[k]};
    }
}

}  // namespace

void gather_samples(const PointLights& lights, const Vec3f& normal, std::span<const float> values,
                    std::span<const std::uint8_t> keep, const NdfGrid& grid, PointSamples& out) {
    const NormalFrame local(normal);
    const Vec3f o = local(lights.to_eye[0], lights.to_eye[1], lights.to_eye[2]);
    out.to_eye = o;
    out.out = area_place(o[0], o[1], o[2]);
    out.light.clear();
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const float* v = values.data() + 3 * k;
        const float cosine = local(lights.x[k], lights.y[k], lights.z[k])[2];
        const bool clipped = std::isinf(v[0]) || std::isinf(v[1]) || std::isinf(v[2]);
        if ((keep.empty() || keep[k]) && !clipped && cosine >= kLeastLightCosine)
            out.light.push_back(static_cast<int>(k));
    }
    out.resize(out.light.size());
    Block in{}, half{};
    for (std::size_t first = 0; first < out.size(); first += kBlock) {
        const std::size_t count = std::min(kBlock, out.size() - first);
        for (std::size_t j = 0; j < count; ++j) {
            const std::size_t q = first + j, k = static_cast<std::size_t>(out.light[q]);
            const Vec3f i = local(lights.x[k], lights.y[k], lights.z[k]);
            const Vec3f sum = {i[0] + o[0], i[1] + o[1], i[2] + o[2]};
            in.x[j] = i[0], in.y[j] = i[1], in.z[j] = i[2];
            half.x[j] = sum[0], half.y[j] = sum[1], half.z[j] = sum[2];
            out.to_light[q] = i;
            out.cosine_ih[q] =
                0.5f * std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
            for (std::size_t c = 0; c < 3; ++c) {
                out.weight_rgb[c][q] = i[2] * lights.received[c][k];
                out.value_rgb[c][q] = values[3 * k + c];
            }
            out.received[q] = f32::luminance(
                f32::vec3(out.weight_rgb[0][q], out.weight_rgb[1][q], out.weight_rgb[2][q]));
            out.value[q] =
                f32::luminance(f32::vec3(values[3 * k], values[3 * k + 1], values[3 * k + 2]));
        }
        places<false>(grid, half, count, out.half.data() + first);
        places<true>(kAreaGrid, in, count, out.in.data() + first);
    }
}

namespace {

// Chooses the indices of `values` that thin_samples keeps, in increasing order.
void choose_samples(const std::vector<float>& values, std::size_t most,
                    std::vector<std::size_t>& chosen) {
    const std::size_t bright = std::max<std::size_t>(most / 2, 1), rest = values.size() - bright,
                      wanted = most - bright;
    std::vector<float> ordered = values;
    const auto last = ordered.begin() + static_cast<std::ptrdiff_t>(bright - 1);
    std::nth_element(ordered.begin(), last, ordered.end(), std::greater<>());
    const float least = bright > 0 ? *last : std::numeric_limits<float>::infinity();
    auto ties = static_cast<std::size_t>(std::count(ordered.begin(), last + 1, least));
    std::size_t passed = 0;
    for (std::size_t q = 0; q < values.size(); ++q) {
        bool taken = values[q] > least;
        if (values[q] == least && ties > 0) {
            taken = true;
            --ties;
        }
        if (!taken) {
            taken = passed * wanted / rest != (passed + 1) * wanted / rest;
            ++passed;
        }
        if (taken) chosen.push_back(q);
    }
}

}  // namespace

void thin_samples(const PointSamples& samples, std::size_t most, PointSamples& out) {
    std::vector<std::size_t> order;
    order.reserve(std::min(most, samples.size()));
    if (samples.size() > most) {
        choose_samples(samples.value, most, order);
    } else {
        order.resize(samples.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
    }
    out.resize(order.size());
    const auto pick = [&](const auto& from, auto& to) {
        for (std::size_t k = 0; k < order.size(); ++k) to[k] = from[order[k]];
    };
    pick(samples.light, out.light);
    pick(samples.half, out.half);
    pick(samples.in, out.in);
    pick(samples.cosine_ih, out.cosine_ih);
    pick(samples.received, out.received);
    pick(samples.value, out.value);
    pick(samples.to_light, out.to_light);
    for (std::size_t c = 0; c < 3; ++c) {
        pick(samples.weight_rgb[c], out.weight_rgb[c]);
        pick(samples.value_rgb[c], out.value_rgb[c]);
    }
    out.out = samples.out;
    out.to_eye = samples.to_eye;
}

RelativeFresnel::RelativeFresnel(float eta)
    : eta_(eta), by_(eta > 0.0f ? 1.0f / f32::fresnel_conductor(eta, 0.0f, 1.0f) : 1.0f) {}

void RelativeFresnel::of(const std::vector<float>& cosines, std::vector<float>& out) const {
    out.resize(cosines.size());
    for (std::size_t q = 0; q < cosines.size(); ++q)
        out[q] = f32::fresnel_conductor(eta_, 0.0f, cosines[q]) * by_;
    if (eta_ <= 0.0f) std::fill(out.begin(), out.end(), 1.0f);
}

float RelativeFresnel::operator()(float cosine) const {
    return eta_ > 0.0f ? f32::fresnel_conductor(eta_, 0.0f, cosine) * by_ : 1.0f;
}

}  // namespace burnish
