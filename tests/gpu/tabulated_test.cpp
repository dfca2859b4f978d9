// Tabulated materials on the device: look-ups and draws against the tables; pictures against a
// separate evaluation, against the analytic lobe of a table, and at a distance against pictures
// drawn much larger.
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <random>

#include "burnish/shading_names.hpp"
#include "flicker.hpp"
#include "gpu/device/gl.hpp"
#include "gpu/device/handles.hpp"
#include "gpu/device/program.hpp"
#include "gpu/upload/tabulated_maps.hpp"
#include "gpu_fixture.hpp"
#include "tabulated_scenes.hpp"
#include "test_scene.hpp"

namespace burnish::test {
namespace {

Material surface_of(TabulatedMaterial m, Method method = Method::none) {
    Material material;
    material.metallic = 0.0f;
    material.brdf = Brdf::microfacet_separable;
    material.method = method;
    material.lobe = Tabulated{std::make_shared<const TabulatedMaterial>(std::move(m)), {}};
    return material;
}

// --- look-ups ----------------------------------------------------------------------------------

constexpr int kSide = 64;

constexpr char kStage[] = R"(
#include "shading"
#include "shaders/lib/tabulated.glsl"
uniform sampler2D u_inputs;  // of look-ups: direction; of draws: xi
uniform int u_tabulated_columns;
uniform int u_tabulated_area_rows;
layout(location = 0) out vec4 o_values;

void main() {
    vec4 v = texelFetch(u_inputs, ivec2(gl_FragCoord.xy), 0);
    ivec2 block = ivec2(3 % u_tabulated_columns, 3 / u_tabulated_columns);
    TableBlock b = TableBlock(block * u_tabulated_grid,
                              block * ivec2(kAreaGrid.x, u_tabulated_area_rows), 0.0);
#ifdef DRAWS
    // tilted by 20 degrees
    vec3 n = vec3(0.2564, -0.2267, 0.9396);
    Perturbation p = perturb_make(METHOD, n, true, false);
    vec3 h = tabulated_sample(b, p, v.xy, v.z);
    o_values = vec4(h.z > 0.0 ? tabulated_D(b, perturb_point(p, h)) : 0.0, tabulated_pdf(b, p, h), h.z, 1.0);
#else
    vec3 w = v.xyz;
    o_values = vec4(tabulated_D(b, lobe_point_of(w)), tabulated_seen(b, w),
                    tabulated_seen(b, w * 3.0), tabulated_base_pdf(b, lobe_point_of(w)));
#endif
}
)";

class TabulatedLookUp : public GpuTest {
  protected:
    // Five exemplars, whose blocks lie in two columns; the tests read number 3.
    TabulatedMaterial five() const {
        TabulatedMaterial m = blank_material({24, 80}, 2, 1);
        for (int i = 0; i < 3; ++i) add_exemplar(m, ggx_table(m.grid, 0.5, 0.5), 0);
        add_exemplar(m, ggx_table(m.grid, 0.15, 0.5, 0.7), 0.7F);
        add_exemplar(m, ggx_table(m.grid, 0.1, 0.5), 0);
        return m;
    }

    std::vector<std::array<float, 4>> on_device(const TabulatedMaterial& m, const char* define,
                                                const std::vector<std::array<float, 4>>& inputs) {
        const gpu::ShaderDialect dialect =
            context->is_es() ? gpu::ShaderDialect::es300 : gpu::ShaderDialect::gl330;
        const std::string defines = std::string("#define IMAGE_LIGHT 1\n#define ") + define + "\n";
        gpu::Program program(gpu::assemble_stage(dialect, "", "shaders/fullscreen.vert"),
                             gpu::assemble_text(dialect, defines, "tabulated.frag", kStage));
        const gpu::GlTexture input, output;
        const gpu::Framebuffer target;
        const gpu::VertexArray empty;
        for (const gpu::GlTexture* texture : {&input, &output}) {
            glActiveTexture(GL_TEXTURE0);
            glBindTexture(GL_TEXTURE_2D, texture->get());
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kSide, kSide, 0, GL_RGBA, GL_FLOAT,
                         texture == &input ? inputs.data() : nullptr);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        }
        glBindFramebuffer(GL_FRAMEBUFFER, target.get());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, output.get(),
                               0);
        glViewport(0, 0, kSide, kSide);
        program.use();
        gpu::TabulatedMaps maps(tabulated_of(surface_of(m))->material);
        maps.require_draws();
        maps.bind(program);
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, input.get());
        program.set("u_inputs", 0);
        program.set("u_depth", 0.0f);
        glBindVertexArray(empty.get());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        std::vector<std::array<float, 4>> values(kSide * kSide);
        glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_FLOAT, values.data());
        gpu::check_gl("looking up");
        return values;
    }
};

TEST_F(TabulatedLookUp, IsThatOfTheTables) {
    const TabulatedMaterial m = five();
    const std::vector<float> areas = ndf_areas(m.grid, m.table(3));
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<std::array<float, 4>> inputs;
    for (int i = 0; i < kSide * kSide; ++i) {
        const double u = uniform(random);
        const f64::vec3 w = direction_of(kPiD / 2 * u * u, 20 * uniform(random) - 10);
        inputs.push_back(
            {static_cast<float>(w.x), static_cast<float>(w.y), static_cast<float>(w.z), 0.0f});
    }
    const auto values = on_device(m, "LOOK_UPS", inputs);
    const float peak = m.table(3)[0];
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const auto [x, y, z, none] = inputs[i];
        const float theta = std::atan2(std::hypot(x, y), z);
        const float u = std::sqrt(theta * 2 / kPiF);
        // 2e-5: rounding of the position in the table, times the steepest slope.
        EXPECT_NEAR(values[i][0], ndf_lookup(m.grid, m.table(3), u, std::atan2(y, x)),
                    2e-5F * peak);
        EXPECT_NEAR(values[i][1], ndf_area_lookup(areas.data(), x, y, z), 1e-5F);
        EXPECT_NEAR(values[i][2], 3 * values[i][1], 1e-5F);  // homogeneous of degree one
    }
}

// E[f(h) / p(h)] is the integral of f over the hemisphere, here for D cos and for a broader
// function. Draws from stratified points; the integrals by a separate quadrature.
TEST_F(TabulatedLookUp, DrawsHaveTheDensityThatTheySay) {
    const TabulatedMaterial m = five();
    const ReferenceTable table(m.grid, m.table(3));
    std::vector<std::array<float, 4>> inputs;
    for (int i = 0; i < kSide * kSide; ++i) {
        // The third number selects the part of a mixture, uniformly and independently of the
        // others.
        inputs.push_back({(static_cast<float>(i % kSide) + 0.5f) / kSide,
                          (static_cast<float>(i / kSide) + 0.5f) / kSide,
                          static_cast<float>(i * 2654435769.0 / 4294967296.0 -
                                             std::floor(i * 2654435769.0 / 4294967296.0)),
                          0.0f});
    }
    for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
        const f64::Perturbation p = f64::perturb_make(
            method, f64::normalize(f64::vec3(0.2564, -0.2267, 0.9396)), true, false);
        double exact[2] = {0, 0};
        const int steps = 400;
        for (int i = 0; i < steps; ++i) {
            for (int j = 0; j < 2 * steps; ++j) {
                const double z = (i + 0.5) / steps;
                const f64::vec3 h = direction_of(std::acos(z), kPiD * (j + 0.5) / steps);
                const f64::LobePoint q = f64::lobe_point_unit(f64::perturb_point(p, h));
                const double u = std::sqrt(2 / kPiD * std::atan2(std::sqrt(q.s2), q.z));
                const double D = q.weight * table.at(u, std::atan2(q.y, q.x));
                exact[0] += D * z * kPiD / steps / steps;
                exact[1] += std::sqrt(D) * z * kPiD / steps / steps;
            }
        }
        const auto values =
            on_device(m, ("DRAWS\n#define METHOD " + std::to_string(method)).c_str(), inputs);
        double found[2] = {0, 0};
        for (const auto& [D, pdf, z, one] : values) {
            if (!(z > 0) || !(pdf > 0)) continue;
            const double weight = static_cast<double>(z / pdf) / static_cast<double>(values.size());
            found[0] += static_cast<double>(D) * weight;
            found[1] += static_cast<double>(std::sqrt(D)) * weight;
        }
        // A mixture is sampled randomly, other lobes by stratified points.
        const double bound = method == f64::kMethodNormalMap ? 0.05 : 0.015;
        EXPECT_NEAR(found[0] / exact[0], 1, bound) << method;
        EXPECT_NEAR(found[1] / exact[1], 1, 2 * bound) << method;
    }
}

// --- pictures against our own evaluation ---------------------------------------------------------

// 4 x 3 texels of three exemplars, with angles, colors and tilts; one texel is not measured.
TabulatedMaterial patchwork() {
    TabulatedMaterial m = blank_material({32, 96}, 4, 3);
    add_exemplar(m, ggx_table(m.grid, 0.4, 0.4), 0);
    add_exemplar(m, ggx_table(m.grid, 0.2, 0.6), 0);
    add_exemplar(m, ggx_table(m.grid, 0.25, 0.7, 1.1), 1.1F);
    m.eta = 1.5;
    for (std::size_t i = 0; i < m.texels(); ++i) {
        m.exemplar[i] = static_cast<std::uint16_t>(i % 3);
        m.angle[i] = 0.8F * static_cast<float>(i) - 2.0F;
        m.diffuse.pixels[3 * i + 1] = 0.02F * static_cast<float>(i);
        m.specular.pixels[3 * i + 1] = 0.3F + 0.05F * static_cast<float>(i);
        const double tilt = 0.03 * static_cast<double>(i);
        const f64::vec3 n = direction_of(tilt, 1.3 * static_cast<double>(i));
        for (int c = 0; c < 3; ++c)
            m.normal.pixels[3 * i + static_cast<std::size_t>(c)] =
                static_cast<float>(c == 0   ? n.x
                                   : c == 1 ? n.y
                                            : n.z);
    }
    m.exemplar[5] = TabulatedMaterial::kNoExemplar;
    return m;
}

// Radiance of a pixel of the plane: that of the four texels about its middle.
double expected_at(const TabulatedMaterial& m, const std::vector<ReferenceTable>& tables,
                   int method, f64::vec3 at, f64::vec3 wi, f64::vec3 wo) {
    // The first row is at the top.
    const double x = (at.x + 1) / 2 * m.width - 0.5, y = (1 - at.y) / 2 * m.height - 0.5;
    double sum = 0, weights = 0;
    for (int corner = 0; corner < 4; ++corner) {
        const int i = corner % 2, j = corner / 2;
        const double s = x - std::floor(x), t = y - std::floor(y);
        const double weight = (i == 1 ? s : 1 - s) * (j == 1 ? t : 1 - t);
        const int column = (static_cast<int>(std::floor(x)) + i + m.width) % m.width;
        const int row = (static_cast<int>(std::floor(y)) + j + m.height) % m.height;
        const auto texel = static_cast<std::size_t>(row * m.width + column);
        if (m.exemplar[texel] == TabulatedMaterial::kNoExemplar) continue;
        weights += weight;
        sum += weight * reflected_by_texel(m, tables[m.exemplar[texel]], texel, method, wi, wo);
    }
    return weights > 0 ? sum / weights : 0;
}

class TabulatedPicture : public GpuTest, public testing::WithParamInterface<int> {
  protected:
    void SetUp() override { GpuTest::SetUp(); }
};

TEST_P(TabulatedPicture, IsThatOfOurOwnEvaluation) {
    const TabulatedMaterial m = patchwork();
    std::vector<ReferenceTable> tables;
    for (int e = 0; e < m.exemplars; ++e) tables.emplace_back(m.grid, m.table(e));
    Scene scene = one_object(unit_plane(), surface_of(m, static_cast<Method>(GetParam())));
    const glm::vec3 lights[] = {{0.4f, 0.2f, 1.0f}, {-0.9f, 0.3f, 0.5f}};
    for (const glm::vec3 light : lights) scene.lights.push_back(directional(light));
    const Camera camera = camera_on_z(3.0f, 0.9f);
    const int side = 24;
    gpu::Renderer renderer(*context, scene, nullptr);
    const Image image = renderer.render(camera, small_picture(side, side));
    double worst = 0, mean_error = 0, mean = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const f64::vec3 at(0.9 * ((x + 0.5) * 2 / side - 1), 0.9 * (1 - (y + 0.5) * 2 / side),
                               0);
            const f64::vec3 wo = f64::normalize(f64::vec3(0, 0, 3) - at);
            double wanted = 0;
            for (const glm::vec3 light : lights) {
                const glm::vec3 w = glm::normalize(light);
                wanted += expected_at(m, tables, GetParam(), at, {w.x, w.y, w.z}, wo);
            }
            const double found = static_cast<double>(image.at(x, y)[1]);
            worst = std::max(worst, std::fabs(found - wanted) / std::max(wanted, 0.02));
            mean_error += std::fabs(found - wanted);
            mean += wanted;
        }
    }
    std::printf("%s: mean error %.2g of the mean, worst %.2g\n",
                std::string(name_of(static_cast<Method>(GetParam()))).c_str(), mean_error / mean,
                worst);
    // Twice the error of the interpolated areas, at angles up to 70 degrees.
    EXPECT_LT(worst, 0.02);
    EXPECT_LT(mean_error / mean, 0.004);
}

INSTANTIATE_TEST_SUITE_P(Methods, TabulatedPicture, testing::Range(0, 9));

// Magnified and minified, where the shape of the pixel selects its texels. The view is oblique, so
// that the shape is not square. A lamp with a position, beside the directional light, needs
// positions too.
class TabulatedDeferred : public GpuTest {
  protected:
    // Ratio of the mean difference to the mean.
    double difference(float repeats, bool placed) {
        Scene scene = one_object(unit_plane(), surface_of(patchwork(), Method::follow_grain));
        scene.materials[0].normal_texture.transform =
            glm::mat3(repeats, 0, 0, 0, repeats, 0, 0, 0, 1);
        scene.lights.push_back(directional({0.4f, 0.2f, 1.0f}));
        if (placed) {
            Light lamp;
            lamp.type = LightType::point;
            lamp.position = {0.5f, 0.5f, 2.0f};
            lamp.intensity = 4.0f;
            scene.lights.push_back(lamp);
        }
        Camera camera = camera_on_z(3.0f);
        camera.position = {1.2f, -1.5f, 2.4f};
        RenderSettings o = small_picture(48, 48);
        gpu::Renderer renderer(*context, scene, nullptr);
        o.surface_pass = SurfacePass::forward;
        const Image forward = renderer.render(camera, o);
        o.surface_pass = SurfacePass::deferred;
        const Image deferred = renderer.render(camera, o);
        double sum = 0, level = 0;
        for (std::size_t i = 1; i < forward.pixels.size(); i += 4) {
            const auto a = static_cast<double>(forward.pixels[i]);
            sum += std::fabs(a - static_cast<double>(deferred.pixels[i]));
            level += a;
        }
        return sum / level;
    }
};

TEST_F(TabulatedDeferred, IsThePictureThatForwardShadingDraws) {
    for (const float repeats : {1.0f, 40.0f}) {
        for (const bool placed : {false, true}) {
            const double d = difference(repeats, placed);
            std::printf("%g repeats, %s: %.2g\n", static_cast<double>(repeats),
                        placed ? "a lamp with a place" : "directional", d);
            // The tangent is packed to 7e-4 rad, and no lobe here is narrower than 0.2.
            EXPECT_LT(d, 3e-3) << repeats;
        }
    }
}

// --- against the analytic lobe -------------------------------------------------------------------

class TabulatedGgx : public GpuTest {
  protected:
    // A sphere with the lobe, as a metal with reflectance 1, and one with the table of the lobe.
    Scene sphere(bool tabulated, Method method, bool bumps) const {
        Material material;
        material.metallic = 1.0f;
        material.single_scattering = true;  // as a table is
        material.lobe = AlphaLobe{{0.2f, 0.5f}};
        material.brdf = Brdf::microfacet_separable;
        if (tabulated) {
            TabulatedMaterial m = blank_material({128, 256}, 1, 1);
            add_exemplar(m, ggx_table(m.grid, 0.2, 0.5), 0);
            material = surface_of(m);
        }
        material.method = method;
        Scene scene = one_object(uv_sphere(96, 48), material);
        if (bumps) {
            scene.textures.push_back(bump_texture(64, 2, 0.4f));
            scene.materials[0].normal_texture.texture = 0;
            scene.materials[0].normal_filter = NormalFilter::mips;
        }
        return scene;
    }

    Image drawn(Scene scene, const Environment* environment, int samples) {
        if (!environment)
            for (const glm::vec3 light : {glm::vec3(1, 1, 1), glm::vec3(-1, 0.2f, 0.4f)})
                scene.lights.push_back(directional(light));
        gpu::Renderer renderer(*context, scene, environment);
        RenderSettings o = small_picture(64, 64, samples);
        o.image_light_samples = 16;
        return renderer.render(camera_on_z(4.0f, 1.1f), o);
    }

    // Ratio of the mean difference to the mean.
    static double difference(const Image& a, const Image& b) {
        double sum = 0, level = 0;
        for (std::size_t i = 1; i < a.pixels.size(); i += 4) {
            sum += std::fabs(static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]));
            level += static_cast<double>(a.pixels[i]);
        }
        return sum / level;
    }
};

TEST_F(TabulatedGgx, UnderLampsIsTheLobe) {
    // normal-map takes the elevation about n~, but x and y in the frame of the surface, in the
    // shape of GGX; no table can represent that.
    for (const Method method :
         {Method::none, Method::gram_schmidt, Method::rotate_exact, Method::rotate_arc,
          Method::follow_grain, Method::deform_linear, Method::deform_smooth}) {
        const bool bumps = method != Method::none;
        const double d = difference(drawn(sphere(false, method, bumps), nullptr, 4),
                                    drawn(sphere(true, method, bumps), nullptr, 4));
        std::printf("%s: %.2g\n", std::string(name_of(method)).c_str(), d);
        EXPECT_LT(d, 0.01) << name_of(method);
    }
}

TEST_F(TabulatedGgx, UnderAnEnvironmentIsTheLobe) {
    Environment sky = constant_environment(glm::vec3(0.3f), 64);
    for (int y = 4; y < 10; ++y)
        for (int x = 20; x < 34; ++x)
            for (int c = 0; c < 3; ++c) sky.radiance.at(x, y)[c] = 8.0f;
    for (const Method method :
         {Method::none, Method::follow_grain, Method::rotate_exact, Method::deform_linear}) {
        const bool bumps = method != Method::none;
        // Both pictures have the noise of 64 samples of 16 look-ups.
        const double d = difference(drawn(sphere(false, method, bumps), &sky, 64),
                                    drawn(sphere(true, method, bumps), &sky, 64));
        std::printf("%s: %.2g\n", std::string(name_of(method)).c_str(), d);
        EXPECT_LT(d, 0.02) << name_of(method);
    }
}

TEST_F(TabulatedGgx, ShortcutsAreRefused) {
    const Environment sky = constant_environment(glm::vec3(1.0f));
    const Scene scene = sphere(true, Method::none, false);
    gpu::Renderer renderer(*context, scene, &sky);
    RenderSettings o = small_picture();
    for (const ImageLight light : {ImageLight::prefiltered, ImageLight::bent_normal}) {
        o.image_light = light;
        EXPECT_THROW(renderer.render(camera_on_z(), o), Error);
    }
    o.image_light = ImageLight::off;
    EXPECT_NO_THROW(renderer.render(camera_on_z(), o));
}

// --- from afar -----------------------------------------------------------------------------------

// Texels a side, and the scale of the reference: 2 to 4 of its pixels per texel.
struct Checker {
    int texels, factor;
};

void PrintTo(const Checker& c, std::ostream* out) {
    *out << c.texels;
}

class TabulatedFromAfar : public GpuTest, public testing::WithParamInterface<Checker> {};

// Green channel of a picture `factor` times as large, filtered by the renderer's pixel filter.
Image through_triangle(const Image& large, int factor) {
    Image small(large.width / factor, large.height / factor, 1);
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            double sum = 0, weights = 0;
            for (int j = -factor; j < factor; ++j) {
                for (int i = -factor; i < factor; ++i) {
                    const int a = x * factor + factor / 2 + i, b = y * factor + factor / 2 + j;
                    if (a < 0 || b < 0 || a >= large.width || b >= large.height) continue;
                    const double weight =
                        (1 - std::fabs(i + 0.5) / factor) * (1 - std::fabs(j + 0.5) / factor);
                    sum += weight * static_cast<double>(large.at(a, b)[1]);
                    weights += weight;
                }
            }
            *small.at(x, y) = static_cast<float>(sum / weights);
        }
    }
    return small;
}

// A checkerboard of two exemplars, 90 degrees apart, with 4 to 8 and 16 to 32 texels per pixel.
TEST_P(TabulatedFromAfar, IsTheMeanOverTexels) {
    const auto [texels, factor] = GetParam();
    TabulatedMaterial m = blank_material({32, 96}, texels, texels);
    add_exemplar(m, ggx_table(m.grid, 0.15, 0.5), 0);
    add_exemplar(m, ggx_table(m.grid, 0.5, 0.3), 0);
    for (int y = 0; y < texels; ++y) {
        for (int x = 0; x < texels; ++x) {
            const auto i = static_cast<std::size_t>(y * texels + x);
            m.exemplar[i] = static_cast<std::uint16_t>((x + y) % 2);
            m.angle[i] = (x + y) % 2 == 0 ? 0.0F : 1.5708F;
            m.specular.pixels[3 * i + 1] = x % 3 == 0 ? 1.0F : 0.4F;
        }
    }
    Scene scene = one_object(unit_plane(), surface_of(m, Method::follow_grain));
    scene.lights.push_back(directional({0.5f, 0.2f, 1.0f}));
    Camera camera = camera_on_z(3.0f);
    camera.position = {1.2f, -1.5f, 2.4f};
    gpu::Renderer renderer(*context, scene, nullptr);
    const int side = 32;
    const Image truth = through_triangle(
        renderer.render(camera, small_picture(side * factor, side * factor, 1)), factor);
    for (const auto& [samples, rms_bound, bias_bound] :
         {std::tuple{1, 0.3, 0.04}, {4, 0.2, 0.04}, {16, 0.15, 0.02}, {64, 0.05, 0.01}}) {
        const Image image = reduced(renderer.render(camera, small_picture(side, side, samples)), 1);
        double squares = 0, sum = 0, level = 0;
        int count = 0;
        // Inside the plane: at its edges a pixel of the large picture is either covered or not.
        for (int y = 8; y < 24; ++y) {
            for (int x = 8; x < 24; ++x, ++count) {
                const double found = static_cast<double>(*image.at(x, y));
                const double wanted = static_cast<double>(*truth.at(x, y));
                squares += std::pow(found - wanted, 2);
                sum += found - wanted;
                level += wanted;
            }
        }
        const double rms = std::sqrt(squares * count) / level;
        std::printf("%d texels, %d samples: rms %.2g, mean off by %.2g\n", texels, samples, rms,
                    sum / level);
        EXPECT_LT(rms, rms_bound) << samples;
        EXPECT_NEAR(sum / level, 0, bias_bound) << samples;
    }
}

INSTANTIATE_TEST_SUITE_P(Checkers, TabulatedFromAfar,
                         testing::Values(Checker{128, 16}, Checker{512, 64}));

}  // namespace
}  // namespace burnish::test
