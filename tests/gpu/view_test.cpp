// Views of what is behind the picture, and series of samples side by side.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <regex>
#include <string>
#include <utility>

#include "burnish/f64.hpp"
#include "edited_scenes.hpp"
#include "gpu/device/shader_source.hpp"
#include "gpu_fixture.hpp"

namespace burnish::test {
namespace {

using gpu::PixelRegion;
using gpu::Renderer;

class View : public GpuTest {
  protected:
    // A plane that faces the camera, its normal turned by `tilt` radians towards +x everywhere.
    static Scene tilted_plane(double tilt, Method method) {
        Material material;
        material.lobe = AlphaLobe{{0.3f, 0.1f}};
        material.method = method;
        material.normal_texture.texture = 0;
        material.normal_filter = NormalFilter::mips;
        Scene scene = one_object(unit_plane(), material);
        const glm::vec3 n(static_cast<float>(std::sin(tilt)), 0.0f,
                          static_cast<float>(std::cos(tilt)));
        scene.textures = {constant_texture(0.5f * n + 0.5f)};
        return scene;
    }

    glm::vec3 middle(const Scene& scene, SurfaceView view) {
        Renderer renderer(*context, scene, nullptr);
        RenderSettings settings = small_picture(16, 16);
        settings.view = view;
        return rgb(renderer.render(camera_on_z(), settings), 8, 8);
    }
};

// The picture and its sum have half floats: 2^-11 of a value near 1, twice.
constexpr float kNear = 2e-3f;

TEST_F(View, ShowsNormalsAndTangentsAsTheyAreInTheWorld) {
    const double tilt = 0.3;
    const Scene scene = tilted_plane(tilt, Method::follow_grain);
    const std::array<std::pair<SurfaceView, glm::vec3>, 3> cases{{
        {SurfaceView::normal, {0, 0, 1}},
        {SurfaceView::perturbed_normal, {std::sin(tilt), 0, std::cos(tilt)}},
        {SurfaceView::tangent, {1, 0, 0}},
    }};
    for (const auto& [view, vector] : cases) {
        const glm::vec3 linear = middle(scene, view);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(f64::srgb_from_linear(static_cast<double>(linear[c])),
                        0.5 + 0.5 * static_cast<double>(vector[c]), kNear)
                << surface_view_names()[static_cast<std::size_t>(view)] << " channel " << c;
    }
}

// Colors of numbers are compared: the same number has the same color in every view.
TEST_F(View, ShowsTiltAndRoughnessOnOneScale) {
    const Scene scene = tilted_plane(std::asin(0.3), Method::follow_grain);
    const glm::vec3 tilt = middle(scene, SurfaceView::tilt);
    const glm::vec3 alpha_x = middle(scene, SurfaceView::alpha_x);
    const glm::vec3 alpha_y = middle(scene, SurfaceView::alpha_y);
    EXPECT_LT(glm::distance(tilt, alpha_x), kNear);  // both 0.3
    EXPECT_GT(glm::distance(alpha_x, alpha_y), 0.01f);
}

TEST_F(View, ErrorOfTheHighlightIsTheTiltWhereTheLobeDoesNotFollow) {
    // 0.3 of 45 degrees, so that the color is that of the number 0.3.
    const double tilt = 0.3 * 3.14159265358979 / 4;
    const glm::vec3 as_number =
        middle(tilted_plane(std::asin(0.3), Method::follow_grain), SurfaceView::tilt);
    const glm::vec3 engine =
        middle(tilted_plane(tilt, Method::normal_map), SurfaceView::highlight_error);
    EXPECT_LT(glm::distance(engine, as_number), kNear);
    for (const Method method :
         {Method::gram_schmidt, Method::rotate_exact, Method::rotate_arc, Method::follow_grain}) {
        const glm::vec3 none = middle(tilted_plane(tilt, method), SurfaceView::highlight_error);
        const glm::vec3 zero = middle(tilted_plane(0.0, method), SurfaceView::tilt);
        EXPECT_LT(glm::distance(none, zero), kNear) << name_of(method);
    }
}

// "PerturbedNormal" as "perturbed-normal".
std::string with_dashes(const std::string& words) {
    std::string name;
    for (const char c : words) {
        if (std::isupper(static_cast<unsigned char>(c)) != 0 && !name.empty()) name += '-';
        name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return name;
}

// The shader has a number for every view but the radiance and the albedo, which are programs of their
// own.
TEST(ViewNumbers, AreThoseOfTheShader) {
    const auto texts = gpu::shader_texts();
    const auto found = std::ranges::find(texts, "shaders/lib/view.glsl", &gpu::ShaderText::name);
    ASSERT_NE(found, texts.end());
    const std::string text(found->text);
    const std::regex constant("const int kView(\\w+) = (\\d+);");
    std::map<std::string, std::size_t> in_shader;
    for (std::sregex_iterator it(text.begin(), text.end(), constant), end; it != end; ++it)
        in_shader[with_dashes((*it)[1])] = std::stoul((*it)[2]);
    std::map<std::string, std::size_t> wanted;
    for (std::size_t i = 0; i < surface_view_names().size(); ++i)
        wanted[std::string(surface_view_names()[i])] = i;
    EXPECT_EQ(wanted.at("radiance"), static_cast<std::size_t>(SurfaceView::radiance));
    EXPECT_EQ(wanted.at("albedo"), static_cast<std::size_t>(SurfaceView::albedo));
    EXPECT_EQ(wanted.at("highlight-error"), static_cast<std::size_t>(SurfaceView::highlight_error));
    wanted.erase("radiance");
    wanted.erase("albedo");
    EXPECT_EQ(in_shader, wanted);
}

// Slopes of a map of 64 texels a side that vary together, differently in every block of 4 x 4.
glm::dvec2 slope_at(int x, int y) {
    const double along = std::sin(1.3 * x + 0.8 * y + 0.05 * x * y);
    const double across = std::cos(0.7 * x - 1.9 * y);
    return {0.5 * along + 0.15 * across, 0.35 * along * std::cos(0.2 * x) - 0.2 * across};
}

// A picture of 16 pixels a side, so that each covers the texel of mip 2 that lies under it. Moments are
// computed over its 16 slopes as means of squares and products.
TEST_F(View, MomentsAreThoseOfTheSlopesUnderAPixel) {
    constexpr int kTexels = 64, kPixels = 16, kBlock = kTexels / kPixels;
    std::vector<glm::vec3> texels;
    for (int y = 0; y < kTexels; ++y)
        for (int x = 0; x < kTexels; ++x) {
            const glm::dvec2 s = slope_at(x, y);
            texels.emplace_back(0.5 + 0.5 * glm::normalize(glm::dvec3(s, 1.0)));
        }
    Material material;
    material.normal_texture.texture = 0;
    for (const bool flip : {false, true}) {
        material.normal_scale = flip ? 0.6f : 1.0f;
        material.flip_green = flip;
        Scene scene = one_object(unit_plane(), material);
        scene.textures = {float_texture(kTexels, kTexels, texels)};
        Renderer renderer(*context, scene, nullptr);
        RenderSettings settings = small_picture(kPixels, kPixels);
        settings.view = SurfaceView::moments;
        settings.surface_pass = SurfacePass::forward;
        const Image picture = renderer.render(camera_on_z(), settings);
        const glm::dvec2 scale(flip ? 0.6 : 1.0, flip ? -0.6 : 1.0);
        int below = 0, above = 0;
        for (int y = 0; y < kPixels; ++y)
            for (int x = 0; x < kPixels; ++x) {
                glm::dvec2 sum(0.0), squares(0.0);
                double products = 0;
                for (int j = 0; j < kBlock; ++j)
                    for (int i = 0; i < kBlock; ++i) {
                        const glm::dvec2 s = slope_at(kBlock * x + i, kBlock * y + j) * scale;
                        sum += s / 16.0;
                        squares += s * s / 16.0;
                        products += s.x * s.y / 16.0;
                    }
                const glm::dvec2 deviation = glm::sqrt(squares - sum * sum);
                const double c = products - sum.x * sum.y;
                below += c < -0.01 ? 1 : 0;
                above += c > 0.01 ? 1 : 0;
                const auto shown = [&](int k) {
                    return f64::srgb_from_linear(static_cast<double>(picture.at(x, y)[k]));
                };
                // Back from the scale, whose roots would make a rounding error at 0 a large one.
                // Measured on llvmpipe: 4e-5, by the fractions of its look-ups; half floats for
                // pictures would make it 1e-3 of a deviation of 1.
                const double root = 2 * shown(2) - 1;
                const double covariance = std::copysign(std::pow(root, 4.0), root);
                EXPECT_NEAR(shown(0) * shown(0), deviation.x, 1e-3) << x << ", " << y;
                EXPECT_NEAR(shown(1) * shown(1), deviation.y, 1e-3) << x << ", " << y;
                EXPECT_NEAR(covariance, c, 1e-3) << x << ", " << y;
            }
        EXPECT_GT(below, 20);
        EXPECT_GT(above, 20);
    }
}

// Without moments there is nothing to show: black, and the blue of a covariance of 0.
TEST_F(View, MomentsAreZeroWhereTheNormalMapHasNone) {
    const glm::vec3 none = middle(tilted_plane(0.3, Method::follow_grain), SurfaceView::moments);
    EXPECT_NEAR(none.r, 0.0f, kNear);
    EXPECT_NEAR(none.g, 0.0f, kNear);
    EXPECT_NEAR(f64::srgb_from_linear(static_cast<double>(none.b)), 0.5, kNear);
}

TEST_F(View, EverySurfaceKindHasEveryView) {
    Scene scene = busy_scene();
    const Environment sky = sky_environment();
    Renderer renderer(*context, scene, &sky);
    RenderSettings settings = small_picture(40, 30);
    settings.image_light_samples = 2;
    for (std::size_t i = 1; i < surface_view_names().size(); ++i) {
        settings.view = static_cast<SurfaceView>(i);
        for (const SurfacePass pass : {SurfacePass::forward, SurfacePass::deferred}) {
            settings.surface_pass = pass;
            const Image picture = renderer.render(camera_on_z(4.0f, 1.1f), settings);
            double sum = 0;
            for (const float value : picture.pixels) sum += static_cast<double>(value);
            EXPECT_GT(sum, static_cast<double>(picture.width * picture.height))  // alpha alone
                << surface_view_names()[i];
        }
    }
}

TEST_F(View, MethodOfThePictureStandsForThatOfTheMaterials) {
    const Environment sky = sky_environment();
    Scene scene = busy_scene();
    Renderer overridden(*context, scene, &sky);
    RenderSettings settings = small_picture(40, 30, 2);
    settings.image_light_samples = 4;
    for (const Method method : {Method::none, Method::normal_map, Method::deform_smooth}) {
        settings.method = method;
        const Image got = overridden.render(camera_on_z(4.0f, 1.1f), settings);
        for (Material& material : scene.materials) material.method = method;
        Renderer own(*context, scene, &sky);
        settings.method.reset();
        const Image wanted = own.render(camera_on_z(4.0f, 1.1f), settings);
        // Rounding: the compiler folds the constants of the two programs differently.
        EXPECT_TRUE(close_pictures(got, wanted, 1e-6, 3e-7)) << name_of(method);
    }
}

// Three regions drawn by turns make the picture that is drawn at once.
TEST_F(View, SeriesSideBySideAreIndependent) {
    const Environment sky = sky_environment();
    Renderer renderer(*context, busy_scene(), &sky);
    RenderSettings settings = small_picture(40, 30, 3);
    settings.image_light_samples = 4;
    const Camera camera = camera_on_z(4.0f, 1.1f);
    const std::array<PixelRegion, 3> regions{{{0, 0, 13, 30}, {13, 0, 20, 30}, {33, 0, 7, 30}}};
    for (int i = 0; i < 3; ++i) {
        renderer.select_series(i);
        renderer.begin(camera, settings, regions[static_cast<std::size_t>(i)]);
    }
    for (int sample = 0; sample < 3; ++sample)
        for (int i = 0; i < 3; ++i) {
            renderer.select_series(i);
            renderer.add_sample();
        }
    Image joined(40, 30, 4);
    for (int i = 0; i < 3; ++i) {
        renderer.select_series(i);
        EXPECT_EQ(renderer.samples_done(), 3);
        const Image part = renderer.picture();
        const PixelRegion& region = regions[static_cast<std::size_t>(i)];
        ASSERT_EQ(part.width, region.width);
        for (int y = 0; y < 30; ++y)
            std::copy(part.at(0, y), part.at(0, y) + 4 * region.width, joined.at(region.x, y));
    }
    renderer.select_series(15);
    renderer.begin(camera, settings);
    for (int sample = 0; sample < 3; ++sample) renderer.add_sample();
    // The projections of a part and of the whole round differently.
    EXPECT_TRUE(close_pictures(joined, renderer.picture(), 2e-2, 1e-3));

    renderer.update_material(1, Material{});
    renderer.select_series(0);
    EXPECT_EQ(renderer.samples_done(), 0);  // stale, as all are
    renderer.end_series();
    EXPECT_THROW(renderer.add_sample(), Error);
    EXPECT_THROW(renderer.select_series(16), Error);
    EXPECT_THROW(renderer.begin(camera, settings, PixelRegion{30, 0, 11, 30}), Error);
}

}  // namespace
}  // namespace burnish::test
