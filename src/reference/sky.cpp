#include "reference/sky.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>

#include "burnish/f32.hpp"
#include "core/constants.hpp"
#include "core/index_of.hpp"
#include "core/parallel.hpp"
#include "rays/vectors.hpp"
#include "scene/light/cube_map.hpp"

namespace burnish {
namespace {

// NaN, infinite and negative values count as 0, as in cube maps.
Image sound(const Image& map, float intensity) {
    Image out(map.width, map.height, 3);
    const std::size_t pixels = index_of(map.width) * index_of(map.height);
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t from = i * index_of(map.channels) + (map.channels >= 3 ? c : 0);
            const float v = map.pixels[from] * intensity;
            out.pixels[3 * i + c] = std::isfinite(v) && v > 0.0f ? v : 0.0f;
        }
    return out;
}

glm::vec3 between_texels(const Image& map, const glm::vec2& uv) {
    const float x = uv.x * static_cast<float>(map.width) - 0.5f;
    const float y = uv.y * static_cast<float>(map.height) - 0.5f;
    const float left = std::floor(x), top = std::floor(y);
    const auto texel = [&](int column, int row) {
        column = (column % map.width + map.width) % map.width;
        const float* p = map.at(column, std::clamp(row, 0, map.height - 1));
        return glm::vec3(p[0], p[1], p[2]);
    };
    const int c = static_cast<int>(left), r = static_cast<int>(top);
    return glm::mix(glm::mix(texel(c, r), texel(c + 1, r), x - left),
                    glm::mix(texel(c, r + 1), texel(c + 1, r + 1), x - left), y - top);
}

// The mean over a texel of what between_texels gives: the weights of a tent over three boxes.
constexpr std::array<float, 3> kTent = {0.125f, 0.75f, 0.125f};

float mean_luminance(const Image& map, int column, int row) {
    float sum = 0.0f;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            const float* p = map.at((column + i + map.width) % map.width,
                                    std::clamp(row + j, 0, map.height - 1));
            sum += kTent[index_of(i + 1)] * kTent[index_of(j + 1)] *
                   f32::luminance(f32::vec3(p[0], p[1], p[2]));
        }
    return sum;
}

// The part of cumulative shares that xi selects; xi becomes the place within it.
int selected(std::span<const float> shares, float& xi) {
    const auto found = std::upper_bound(shares.begin(), shares.end() - 1, xi);
    const auto i = static_cast<std::size_t>(found - shares.begin());
    const float before = i > 0 ? shares[i - 1] : 0.0f;
    const float share = shares[i] - before;
    xi = share > 0.0f ? std::clamp((xi - before) / share, 0.0f, 1.0f) : 0.5f;
    return static_cast<int>(i);
}

float share_at(std::span<const float> shares, int i) {
    return shares[index_of(i)] - (i > 0 ? shares[index_of(i - 1)] : 0.0f);
}

void make_cumulative(std::span<float> shares, double total) {
    double sum = 0.0;
    for (float& share : shares) {
        sum += static_cast<double>(share);
        share = static_cast<float>(sum / total);
    }
    shares.back() = 1.0f;
}

// Per steradian, of a density per unit of (u, v). 1e-6: the half row at a pole is drawn from, its point is not.
float per_steradian(float density, float v) {
    return density / (2.0f * f32::kPi * f32::kPi * std::max(std::sin(f32::kPi * v), 1e-6f));
}

}  // namespace

Sky::Sky(const Environment& environment, const RenderSettings& settings)
    : cos_(std::cos(settings.environment_rotation)),
      sin_(std::sin(settings.environment_rotation)),
      transparent_(settings.background == BackgroundKind::transparent),
      color_(settings.background_color) {
    if (environment.radiance.empty()) return;
    radiance_ = sound(environment.radiance, settings.environment_intensity);
    shows_environment_ = settings.background == BackgroundKind::environment;
    if (!environment.backdrop.empty())
        backdrop_ = sound(environment.backdrop, settings.environment_intensity);
    const float blur = std::clamp(settings.background_blur, 0.0f, 1.0f);
    const Image& seen = backdrop_.empty() ? radiance_ : backdrop_;
    // The renderer shows a coarser level of a cube map; a texel of it is the width of the blur.
    const auto face = static_cast<float>(cube_size_for(seen.width));
    if (blur > 0.0f)
        blur_ = 0.5f * f32::kPi / face * std::exp2(blur * std::max(std::log2(face) - 1.0f, 0.0f));
    if (settings.image_light != ImageLight::off) make_distribution();
}

// The density of directions follows the mean luminance of every texel.
void Sky::make_distribution() {
    const int width = radiance_.width, height = radiance_.height;
    std::vector<float> columns(index_of(width) * index_of(height));
    std::vector<float> rows(index_of(height));
    std::vector<glm::dvec3> ground(index_of(height), glm::dvec3(0.0));
    parallel_for(index_of(height), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) {
            const double top = std::cos(kPi * static_cast<double>(r) / height);
            const double bottom = std::cos(kPi * static_cast<double>(r + 1) / height);
            const double angle = kTwoPi / width * (top - bottom);  // of a texel
            const std::span<float> row(columns.data() + r * index_of(width), index_of(width));
            double sum = 0.0;
            for (int c = 0; c < width; ++c) {
                row[index_of(c)] = mean_luminance(radiance_, c, static_cast<int>(r));
                sum += static_cast<double>(row[index_of(c)]);
                const float* p = radiance_.at(c, static_cast<int>(r));
                ground[r] +=
                    glm::dvec3(p[0], p[1], p[2]) * (angle * std::max(0.5 * (top + bottom), 0.0));
            }
            rows[r] = static_cast<float>(sum * angle);
            if (sum > 0.0) make_cumulative(row, sum);
        }
    });
    double total = 0.0;
    for (const float row : rows) total += static_cast<double>(row);
    for (const glm::dvec3& row : ground) ground_ += glm::vec3(row);
    if (!(total > 0.0)) return;
    make_cumulative(rows, total);
    rows_ = std::move(rows);
    columns_ = std::move(columns);
}

glm::vec2 Sky::place_of(const glm::vec3& world) const {
    const glm::vec3 d(cos_ * world.x - sin_ * world.z, world.y, sin_ * world.x + cos_ * world.z);
    return {0.5f + std::atan2(d.x, -d.z) / (2.0f * f32::kPi),
            std::acos(std::clamp(d.y, -1.0f, 1.0f)) / f32::kPi};
}

glm::vec3 Sky::direction_of_place(const glm::vec2& uv) const {
    const float phi = 2.0f * f32::kPi * (uv.x - 0.5f), theta = f32::kPi * uv.y;
    const float sine = std::sin(theta);
    const glm::vec3 d(sine * std::sin(phi), std::cos(theta), -sine * std::cos(phi));
    // Back from the environment to the world.
    return {cos_ * d.x + sin_ * d.z, d.y, cos_ * d.z - sin_ * d.x};
}

glm::vec3 Sky::radiance(const glm::vec3& direction) const {
    return radiance_.empty() ? glm::vec3(0.0f) : between_texels(radiance_, place_of(direction));
}

float Sky::density_at(int row, int column) const {
    const std::span<const float> columns(columns_);
    const auto width = index_of(radiance_.width);
    return share_at(rows_, row) * share_at(columns.subspan(index_of(row) * width, width), column) *
           static_cast<float>(radiance_.width) * static_cast<float>(radiance_.height);
}

float Sky::pdf(const glm::vec3& direction) const {
    if (!lights()) return 0.0f;
    const glm::vec2 uv = place_of(direction);
    const int column = std::clamp(static_cast<int>(uv.x * static_cast<float>(radiance_.width)), 0,
                                  radiance_.width - 1);
    const int row = std::clamp(static_cast<int>(uv.y * static_cast<float>(radiance_.height)), 0,
                               radiance_.height - 1);
    return per_steradian(density_at(row, column), uv.y);
}

Sky::Sample Sky::sample(const glm::vec2& xi) const {
    Sample out;
    if (!lights()) return out;
    glm::vec2 within = xi;
    const int row = selected(rows_, within.y);
    const std::span<const float> columns(columns_);
    const auto width = index_of(radiance_.width);
    const int column = selected(columns.subspan(index_of(row) * width, width), within.x);
    const glm::vec2 uv(
        (static_cast<float>(column) + within.x) / static_cast<float>(radiance_.width),
        (static_cast<float>(row) + within.y) / static_cast<float>(radiance_.height));
    out.direction = direction_of_place(uv);
    out.radiance = between_texels(radiance_, uv);
    out.pdf = per_steradian(density_at(row, column), uv.y);
    return out;
}

glm::vec3 Sky::background(const glm::vec3& direction, const glm::vec2& xi) const {
    if (!shows_environment_) return color_;
    const Image& seen = backdrop_.empty() ? radiance_ : backdrop_;
    if (!(blur_ > 0.0f)) return between_texels(seen, place_of(direction));
    const auto tent = [](float u) {
        return u < 0.5f ? std::sqrt(2.0f * u) - 1.0f : 1.0f - std::sqrt(2.0f - 2.0f * u);
    };
    const f32::Frame f = f32::frame_about(to_f32(direction));
    const glm::vec3 turned = direction + std::tan(std::min(blur_, 1.2f)) *
                                             (tent(xi.x) * to_glm(f.t) + tent(xi.y) * to_glm(f.b));
    return between_texels(seen, place_of(glm::normalize(turned)));
}

}  // namespace burnish
