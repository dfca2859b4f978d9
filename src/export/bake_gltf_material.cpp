// Points of a material into texels: means, and detail below a texel as width of the lobe.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string_view>

#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "burnish/f32.hpp"
#include "burnish/gltf_material.hpp"
#include "burnish/image_io.hpp"
#include "burnish/material_textures.hpp"
#include "burnish/shading_names.hpp"
#include "burnish/tabulated_material.hpp"
#include "core/parallel.hpp"
#include "export/material_points.hpp"
#include "image/texel_value.hpp"
#include "scene/material/material_values.hpp"
#include "scene/material/texture_uses.hpp"

namespace burnish {
namespace {

constexpr int kLeastSide = 16, kMostSide = 16384;
// Points along a side of a texel. Beyond, means change by less than a code of 8 bits.
constexpr int kMostPoints = 32;

// A symmetric 2x2 matrix.
struct Spread {
    float xx = 0.0f, yy = 0.0f, xy = 0.0f;

    void add(glm::vec2 v, float weight) {
        xx += weight * v.x * v.x;
        yy += weight * v.y * v.y;
        xy += weight * v.x * v.y;
    }
    float along(glm::vec2 d) const {
        return d.x * d.x * xx + d.y * d.y * yy + 2.0f * d.x * d.y * xy;
    }
};

// The unit eigenvector of the larger eigenvalue; +x where all directions are alike.
glm::vec2 widest(const Spread& s) {
    const float c = s.xx - s.yy, d = 2.0f * s.xy;
    // 1e-5: less than single precision resolves of a sum of squares of many points.
    if (std::hypot(c, d) <= 1e-5f * (s.xx + s.yy)) return {1.0f, 0.0f};
    const float angle = 0.5f * std::atan2(d, c);
    return {std::cos(angle), std::sin(angle)};
}

// Sums over the points of a texel.
struct TexelSums {
    glm::vec4 base{0.0f};
    float metallic = 0.0f, occlusion = 0.0f;
    glm::vec3 emissive{0.0f};
    Spread lobe;  // alpha^2 along the axes of the points' lobes
    glm::vec2 slope{0.0f};
    Spread slopes;
    int count = 0;

    void add(const MaterialPoint& p) {
        base += p.base_color;
        metallic += p.metallic;
        occlusion += p.occlusion;
        emissive += p.emissive;
        lobe.add(p.direction, p.alpha.x * p.alpha.x);
        lobe.add({-p.direction.y, p.direction.x}, p.alpha.y * p.alpha.y);
        slope += p.slope;
        slopes.add(p.slope, 1.0f);
        ++count;
    }
};

// What one texel of the maps says.
struct BakedTexel {
    glm::vec4 base{0.0f};
    float metallic = 0.0f, occlusion = 1.0f;
    glm::vec3 emissive{0.0f};
    glm::vec3 normal{0.0f, 0.0f, 1.0f};
    float roughness = 1.0f, strength = 0.0f;
    glm::vec2 stretch{1.0f, 0.0f};
};

// The covariance of the slopes as widening along the surface's axes (variance_about).
Spread widening_of(const TexelSums& sums, glm::vec2 mean, const glm::vec3& n) {
    const float scale = 1.0f / static_cast<float>(sums.count);
    const float z2 = n.z * n.z, fx = 1.0f - n.x * n.x, fy = 1.0f - n.y * n.y;
    Spread s;
    s.xx = std::max(sums.slopes.xx * scale - mean.x * mean.x, 0.0f) * z2 * fx;
    s.yy = std::max(sums.slopes.yy * scale - mean.y * mean.y, 0.0f) * z2 * fy;
    s.xy = (sums.slopes.xy * scale - mean.x * mean.y) * z2 * std::sqrt(fx * fy);
    return s;
}

// The roughness pair of glTF that is nearest to the mean lobe of the texel, widened.
void put_lobe(const TexelSums& sums, const Spread& detail, int mdf, BakedTexel& out) {
    const float scale = 1.0f / static_cast<float>(sums.count);
    // Variances of slopes are half of alpha^2.
    const Spread both{sums.lobe.xx * scale + 2.0f * detail.xx,
                      sums.lobe.yy * scale + 2.0f * detail.yy,
                      sums.lobe.xy * scale + 2.0f * detail.xy};
    const glm::vec2 wide = widest(both), narrow(-wide.y, wide.x);
    const auto alpha_along = [&](glm::vec2 d) { return std::sqrt(sums.lobe.along(d) * scale); };
    f32::Lobe lobe = f32::lobe_from_alpha(mdf, alpha_along(wide), alpha_along(narrow));
    if (detail.xx + detail.yy > 0.0f)
        lobe = f32::widen_lobe(lobe, std::max(detail.along(wide), 0.0f),
                               std::max(detail.along(narrow), 0.0f));
    const float a = std::clamp(f32::lobe_alpha_x(lobe), 0.0f, 1.0f);
    const float b = std::clamp(f32::lobe_alpha_y(lobe), 0.0f, 1.0f);
    const float small = std::min(a, b), large = std::max(a, b);
    out.stretch = a >= b ? wide : narrow;
    out.roughness = std::sqrt(small);
    // At roughness 1 the lobe cannot be stretched.
    out.strength = small < 1.0f ? std::sqrt((large - small) / (1.0f - small)) : 0.0f;
}

BakedTexel baked(const TexelSums& sums, int mdf) {
    const float scale = 1.0f / static_cast<float>(sums.count);
    BakedTexel out;
    out.base = sums.base * scale;
    out.metallic = sums.metallic * scale;
    out.occlusion = sums.occlusion * scale;
    out.emissive = sums.emissive * scale;
    const glm::vec2 mean = sums.slope * scale;
    const f32::vec3 n = f32::normal_of_slopes(mean.x, mean.y);
    out.normal = {n.x, n.y, n.z};
    const Spread detail = sums.count > 1 ? widening_of(sums, mean, out.normal) : Spread{};
    put_lobe(sums, detail, mdf, out);
    return out;
}

// Writes codes of a texture's depth, rounded.
class MapWriter {
  public:
    MapWriter(std::string name, int width, int height, int channels, int bits, ColorSpace space) {
        map.name = std::move(name);
        map.width = width;
        map.height = height;
        map.channels = channels;
        map.type = bits == 8 ? TexelType::u8 : TexelType::u16;
        map.color_space = space;
        map.texels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                          static_cast<std::size_t>(channels * bits / 8));
    }

    void put(std::size_t texel, int channel, float value) {
        const std::size_t at =
            texel * static_cast<std::size_t>(map.channels) + static_cast<std::size_t>(channel);
        set_texel_value(map, at, value);
    }

    void put_color(std::size_t texel, glm::vec3 linear) {
        for (int c = 0; c < 3; ++c) put(texel, c, srgb_from_linear(linear[c]));
    }

    Texture map;
};

class Baker {
  public:
    Baker(const Material& m, const MaterialPoints& points, const GltfBakeSettings& settings)
        : points_(points),
          width_(settings.width),
          height_(settings.height),
          mdf_(f32::brdf_mdf(static_cast<int>(m.brdf), static_cast<int>(m.mdf))),
          base_("base_color", width_, height_, points.has_alpha ? 4 : 3, 8, ColorSpace::srgb),
          orm_("orm", width_, height_, 3, settings.bits, ColorSpace::linear),
          normal_("normal", width_, height_, 3, settings.bits, ColorSpace::linear),
          anisotropy_("anisotropy", width_, height_, 3, settings.bits, ColorSpace::linear) {
        const auto side = [](float detail, int texels) {
            return std::clamp(static_cast<int>(std::ceil(detail / static_cast<float>(texels))), 1,
                              kMostPoints);
        };
        points_x_ = side(points.detail.x, width_);
        points_y_ = side(points.detail.y, height_);
        if (points.has_emission) {
            emissive_ = MapWriter("emissive", width_, height_, 3, 8, ColorSpace::srgb);
            brightest_ = std::max({m.emissive.x, m.emissive.y, m.emissive.z});
        }
        stretch_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    }

    void run(const Progress& progress) {
        constexpr int kStep = 256;
        for (int from = 0; from < height_; from += kStep) {
            progress.step("bake", static_cast<double>(from) / height_);
            const int rows = std::min(kStep, height_ - from);
            parallel_for(static_cast<std::size_t>(rows), 4,
                         [&](std::size_t begin, std::size_t end) {
                             for (std::size_t y = begin; y < end; ++y)
                                 bake_row(from + static_cast<int>(y));
                         });
        }
        put_directions();
        progress.step("bake", 1.0);
    }

    float brightest() const { return brightest_; }
    // Base color, ORM, normal, anisotropy, emission.
    std::vector<Texture> take() {
        std::vector<Texture> out;
        for (MapWriter* writer : {&base_, &orm_, &normal_, &anisotropy_})
            out.push_back(std::move(writer->map));
        if (points_.has_emission) out.push_back(std::move(emissive_.map));
        return out;
    }

  private:
    TexelSums sums_at(int x, int y) const {
        TexelSums sums;
        for (int j = 0; j < points_y_; ++j)
            for (int i = 0; i < points_x_; ++i) {
                const float u = (static_cast<float>(x) +
                                 (static_cast<float>(i) + 0.5f) / static_cast<float>(points_x_)) /
                                static_cast<float>(width_);
                const float v = (static_cast<float>(y) +
                                 (static_cast<float>(j) + 0.5f) / static_cast<float>(points_y_)) /
                                static_cast<float>(height_);
                sums.add(points_.at({u, v}));
            }
        return sums;
    }

    void bake_row(int y) {
        for (int x = 0; x < width_; ++x) {
            const std::size_t t = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                  static_cast<std::size_t>(x);
            const BakedTexel b = baked(sums_at(x, y), mdf_);
            base_.put_color(t, glm::vec3(b.base));
            if (points_.has_alpha) base_.put(t, 3, b.base.a);
            orm_.put(t, 0, b.occlusion);
            orm_.put(t, 1, b.roughness);
            orm_.put(t, 2, b.metallic);
            for (int c = 0; c < 3; ++c) normal_.put(t, c, 0.5f + 0.5f * b.normal[c]);
            anisotropy_.put(t, 2, b.strength);
            stretch_[t] = b.strength > 0.0f ? b.stretch : glm::vec2(0.0f);
            if (points_.has_emission) emissive_.put_color(t, b.emissive / brightest_);
        }
    }

    // Of the two arrows of a line the one that turns least from the texels to the left and above, so
    // that filtering finds few seams. A texel without a direction takes theirs.
    void put_directions() {
        std::size_t t = 0;
        for (int y = 0; y < height_; ++y) {
            glm::vec2 left =
                y > 0 ? stretch_[t - static_cast<std::size_t>(width_)] : glm::vec2(1.0f, 0.0f);
            for (int x = 0; x < width_; ++x, ++t) {
                const glm::vec2 up = y > 0 ? stretch_[t - static_cast<std::size_t>(width_)] : left;
                glm::vec2& d = stretch_[t];
                if (d == glm::vec2(0.0f)) d = left;
                if (glm::dot(d, left + up) < 0.0f) d = -d;
                left = d;
                anisotropy_.put(t, 0, 0.5f + 0.5f * d.x);
                anisotropy_.put(t, 1, 0.5f + 0.5f * d.y);
            }
        }
    }

    const MaterialPoints& points_;
    int width_, height_, mdf_;
    int points_x_ = 1, points_y_ = 1;
    float brightest_ = 1.0f;
    MapWriter base_, orm_, normal_, anisotropy_;
    MapWriter emissive_{"", 0, 0, 3, 8, ColorSpace::srgb};
    std::vector<glm::vec2> stretch_;
};

void check_settings(const GltfBakeSettings& s) {
    for (const auto& [key, side] : {std::pair("width", s.width), std::pair("height", s.height)})
        if (side < kLeastSide || side > kMostSide)
            throw UsageError("maps", key, fmt::format("{} to {} texels", kLeastSide, kMostSide),
                             fmt::format("{}", side));
    if (s.bits != 8 && s.bits != 16)
        throw UsageError("maps", "bits", "8 or 16", fmt::format("{}", s.bits));
}

void require_memory(const GltfBakeSettings& s, std::uint64_t limit) {
    // Colors of 4 and 3 bytes, three maps of 3 channels, the direction of each texel.
    const std::uint64_t texel = 7 + 9 * static_cast<std::uint64_t>(s.bits) / 8 + sizeof(glm::vec2);
    const std::uint64_t needed =
        texel * static_cast<std::uint64_t>(s.width) * static_cast<std::uint64_t>(s.height);
    if (needed <= limit) return;
    throw Error("maps", fmt::format("size {}x{}", s.width, s.height),
                fmt::format("{:.1f} MB of free memory", static_cast<double>(needed) / 1e6),
                fmt::format("{:.1f} MB", static_cast<double>(limit) / 1e6));
}

std::vector<std::string> losses_of(const Material& m) {
    std::vector<std::string> out;
    const auto say = [&](std::string line) { out.push_back(std::move(line)); };
    using enum MaterialTexture;
    for (const MaterialTexture which : {specular, specular_color, coat, coat_roughness, coat_normal,
                                        sheen_color, sheen_roughness})
        if (texture_use(m, which))
            say(fmt::format("{}: its factor alone is written",
                            kTextureNames[static_cast<std::size_t>(which)]));
    if (has_coat(m) && m.coat.tint != glm::vec3(1.0f))
        say("coat tint: glTF has clear coats alone; burnish reads it back");
    if (tabulated_of(m)) {
        say("lobe: the measured tables become the nearest GGX lobes");
        return out;
    }
    if (m.mdf != Mdf::ggx)
        say(fmt::format("mdf {}: glTF has GGX alone, of the same alphas", name_of(m.mdf)));
    if (m.brdf != Brdf::microfacet)
        say(fmt::format("brdf {}: glTF has the microfacet model alone", name_of(m.brdf)));
    if (m.conductor)
        say("metal: its Fresnel becomes Schlick's of the same color at normal incidence");
    if (m.conductor && m.conductor->oxide)
        say("oxide: the base color is that of the film at normal incidence; its colors at other "
            "angles are lost");
    if (const glm::vec2 alpha = alpha_of(m); std::max(alpha.x, alpha.y) > 1.0f)
        say("alpha above 1: glTF ends at 1");
    return out;
}

// Layers and the specular term by their factors, without their textures.
void put_factors_of_layers(const Material& from, Material& to) {
    to.specular = from.specular;
    to.specular_color = from.specular_color;
    to.coat = from.coat;
    to.coat.texture = to.coat.roughness_texture = to.coat.normal_texture = TextureUse{};
    to.sheen = from.sheen;
    to.sheen.color_texture = to.sheen.roughness_texture = TextureUse{};
}

}  // namespace

double gltf_tile_aspect(const Material& m) {
    if (const Tabulated* table = tabulated_of(m))
        return static_cast<double>(table->material->width) / table->material->height;
    const Cloth* cloth = cloth_of(m);
    if (cloth == nullptr || has_textures(m)) return 1.0;
    const glm::ivec2 repeats = cloth_repeats(*cloth->draft);
    return static_cast<double>(cloth->draft->ends * repeats.x) / (cloth->draft->picks * repeats.y);
}

GltfMaterial bake_gltf_material(const Material& material, std::span<const Texture> textures,
                                const GltfBakeSettings& settings, std::uint64_t memory_limit,
                                const Progress& progress) {
    check_settings(settings);
    require_memory(settings, memory_limit);
    // Of a copy made here, GCC 12 says wrongly that its lobe may be uninitialized.
    const std::vector<Material> drawn = drawn_materials({material});
    const Material& m = drawn.front();
    const MaterialPoints points = cloth_of(m)       ? points_of_cloth(m, textures)
                                  : tabulated_of(m) ? points_of_table(m, textures)
                                                    : points_of_textures(m, textures);
    Baker baker(m, points, settings);
    baker.run(progress);

    GltfMaterial out;
    out.tile = points.tile;
    out.losses = losses_of(m);
    Material& to = out.material;
    to.name = m.name;
    to.method = m.method;
    to.process = m.process;
    to.conserve = m.conserve;
    to.single_scattering = !is_compensated(m);
    to.normal_filter = m.normal_filter;
    to.alpha_mode = m.alpha_mode;
    if (points.has_alpha && tabulated_of(m)) to.alpha_mode = AlphaMode::mask;
    to.alpha_cutoff = m.alpha_cutoff;
    to.double_sided = m.double_sided;
    const Tabulated* const tabulated = tabulated_of(m);
    to.dielectric_f0 = tabulated ? dielectric_f0_of(*tabulated->material) : m.dielectric_f0;
    put_factors_of_layers(m, to);
    to.lobe = GltfLobe{1.0f, 1.0f};
    out.textures = baker.take();
    const auto use = [&](int texture) {
        TextureUse u;
        u.texture = texture;
        u.transform = points.tile;
        return u;
    };
    to.base_color_texture = use(0);
    to.metallic_roughness_texture = to.occlusion_texture = use(1);
    to.normal_texture = use(2);
    to.anisotropy_texture = use(3);
    if (points.has_emission) {
        to.emissive_texture = use(4);
        to.emissive = glm::vec3(baker.brightest());
    }
    return out;
}

}  // namespace burnish
