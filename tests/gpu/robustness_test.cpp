// Any input gives finite pictures or error messages.
#include <cmath>
#include <limits>

#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "gpu_fixture.hpp"
#include "test_scene.hpp"

namespace burnish::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class Robustness : public GpuTest {
  protected:
    void expect_finite(const Scene& scene, const char* what) {
        const Environment environment = constant_environment({1, 2, 4});
        gpu::Renderer renderer(*context, scene, &environment);
        for (const SurfacePass pass : {SurfacePass::forward, SurfacePass::deferred}) {
            RenderSettings o = small_picture(24, 24, 2);
            o.image_light_samples = 4;
            o.surface_pass = pass;
            const Image image = renderer.render(camera_on_z(4.0f, 1.1f), o);
            double sum = 0;
            for (const float v : image.pixels) {
                ASSERT_TRUE(std::isfinite(v) && v >= 0.0f && v <= 65504.0f) << what << ": " << v;
                sum += v;
            }
            EXPECT_GT(sum, 24 * 24) << what << ": all black";  // alpha alone is 576
        }
    }

    Scene lit_sphere() {
        Material m;
        m.lobe = AlphaLobe{{0.4f, 0.1f}};
        m.normal_texture.texture = 0;
        Scene scene = one_object(uv_sphere(24, 12), m);
        scene.textures.push_back(bump_texture(16, 2, 0.3f));
        scene.lights.push_back(directional({0.4f, 0.5f, 1.0f}));
        return scene;
    }
};

TEST_F(Robustness, TexelsThatAreNoNormalsLeaveTheSurfaceUnperturbed) {
    Scene scene = lit_sphere();
    scene.textures[0] = constant_texture({0.5f, 0.5f, 1.0f});
    gpu::Renderer flat(*context, scene, nullptr);
    const Image wanted = flat.render(camera_on_z(), small_picture(16, 16));
    const glm::vec3 bad[] = {{kNan, kNan, kNan},
                             {0.5f, 0.5f, 0.5f},
                             {0, 0, 0},
                             {0.7f, 0.5f, 0.2f},
                             {HUGE_VALF, 0.5f, 1.0f}};
    for (const glm::vec3& texel : bad) {
        scene.textures[0] = constant_texture(texel);
        gpu::Renderer renderer(*context, scene, nullptr);
        EXPECT_TRUE(close_pictures(renderer.render(camera_on_z(), small_picture(16, 16)), wanted,
                                   1e-2, 1e-3))
            << texel.x;
    }
}

TEST_F(Robustness, ExtremeTiltsInEveryMethodStayFinite) {
    Scene scene = lit_sphere();
    scene.materials[0].normal_scale = 1000.0f;
    for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
        scene.materials[0].method = static_cast<Method>(method);
        expect_finite(scene, name_of(static_cast<Method>(method)).data());
    }
}

TEST_F(Robustness, ExtremeLobesStayFinite) {
    for (int mdf = 0; mdf < static_cast<int>(mdf_names().size()); ++mdf) {
        for (const glm::vec2 alpha : {glm::vec2(0.0f), glm::vec2(1.0f), glm::vec2(0.001f, 1.0f)}) {
            Scene scene = lit_sphere();
            scene.materials[0].mdf = static_cast<Mdf>(mdf);
            scene.materials[0].lobe = AlphaLobe{alpha};
            expect_finite(scene, name_of(static_cast<Mdf>(mdf)).data());
        }
    }
}

TEST_F(Robustness, MeshesWithoutDirectionsStayFinite) {
    Scene scene = lit_sphere();
    Mesh& mesh = scene.meshes[0];
    mesh.normals.assign(mesh.normals.size(), glm::vec3(0.0f));
    expect_finite(scene, "zero normals");
    scene = lit_sphere();
    scene.meshes[0].tangents.assign(scene.meshes[0].tangents.size(), glm::vec4(0, 0, 0, 1));
    expect_finite(scene, "zero tangents");
    scene.meshes[0].tangents.clear();
    scene.meshes[0].texcoord0.clear();
    expect_finite(scene, "no tangents, no texture coordinates");
    scene = lit_sphere();
    for (std::size_t i = 0; i < scene.meshes[0].tangents.size(); ++i) {
        scene.meshes[0].tangents[i] = glm::vec4(scene.meshes[0].normals[i], -1.0f);
    }
    expect_finite(scene, "tangents along the normal");
    scene = lit_sphere();
    scene.meshes[0].positions[5] = glm::vec3(kNan);
    expect_finite(scene, "a vertex nowhere");
}

// Huge coverage values, whose filtered differences would be NaN, are limited.
TEST_F(Robustness, CoverageStaysAShareOfThePixel) {
    Scene scene = lit_sphere();
    scene.materials[0].alpha_mode = AlphaMode::blend;
    scene.materials[0].base_color_texture.texture = 1;
    Texture& texture = scene.textures.emplace_back(constant_texture(glm::vec3(0.5f)));
    constexpr float kHuge = std::numeric_limits<float>::max();
    const std::vector<glm::vec4> texels = {glm::vec4(1, 1, 1, kHuge), glm::vec4(1, 1, 1, -kHuge),
                                           glm::vec4(kHuge, 1, 1, 1), glm::vec4(1, 1, 1, 2)};
    const auto bytes = std::as_bytes(std::span(texels));
    texture.texels.assign(bytes.begin(), bytes.end());
    texture.width = texture.height = 2;
    texture.channels = 4;
    gpu::Renderer renderer(*context, scene, nullptr);
    RenderSettings o = small_picture(24, 24, 2);
    o.background = BackgroundKind::transparent;
    const Image image = renderer.render(camera_on_z(4.0f, 1.1f), o);
    double covered = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        ASSERT_TRUE(std::isfinite(image.pixels[i])) << i;
        if (i % 4 != 3) continue;
        ASSERT_GE(image.pixels[i], 0.0f);
        ASSERT_LE(image.pixels[i], 1.0f);
        covered += static_cast<double>(image.pixels[i]);
    }
    EXPECT_GT(covered, 24.0);
}

TEST_F(Robustness, LightsInTheSurfaceStayFinite) {
    Scene scene = lit_sphere();
    scene.lights[0].type = LightType::point;
    scene.lights[0].position = glm::vec3(0, 0, 1);
    scene.lights[0].intensity = 1e30f;
    expect_finite(scene, "a light in the surface");
}

template <typename Action>
void expect_error(Action action, const char* word) {
    try {
        action();
        FAIL() << "no error about " << word;
    } catch (const Error& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find(word), std::string::npos) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    }
}

TEST_F(Robustness, BrokenScenesAreRefusedInWords) {
    const auto build = [&](const Scene& scene) { gpu::Renderer(*context, scene, nullptr); };
    Scene scene = lit_sphere();
    scene.meshes[0].indices[7] = 1u << 30;
    expect_error([&] { build(scene); }, "indices");
    scene = lit_sphere();
    scene.meshes[0].normals.pop_back();
    expect_error([&] { build(scene); }, "attributes");
    scene = lit_sphere();
    scene.instances[0].mesh = 9;
    expect_error([&] { build(scene); }, "instance");
    scene = lit_sphere();
    scene.instances[0].transform[3][0] = kNan;
    expect_error([&] { build(scene); }, "transform");
    scene = lit_sphere();
    scene.materials[0].emissive_texture.texture = 12;
    expect_error([&] { build(scene); }, "texture");
    scene = lit_sphere();
    scene.textures[0].texels.pop_back();
    expect_error([&] { build(scene); }, "texels");
    scene = lit_sphere();
    scene.textures[0].width = context->max_texture_size() + 1;
    scene.textures[0].height = 1;
    scene.textures[0].texels.resize(static_cast<std::size_t>(scene.textures[0].width) * 12);
    expect_error([&] { build(scene); }, "pixels a side");
}

TEST_F(Robustness, OptionsAndCamerasOutOfRangeAreRefusedInWords) {
    gpu::Renderer renderer(*context, lit_sphere(), nullptr);
    expect_error([&] { renderer.render(camera_on_z(), small_picture(0, 8)); }, "width");
    expect_error([&] { renderer.render(camera_on_z(), small_picture(8, 100000)); }, "height");
    expect_error([&] { renderer.render(camera_on_z(), small_picture(8, 8, 0)); }, "samples");
    Camera nowhere;
    nowhere.target = nowhere.position;
    expect_error([&] { renderer.render(nowhere, small_picture(8, 8)); }, "target");
    Camera narrow;
    narrow.yfov = 0.0f;
    expect_error([&] { renderer.render(narrow, small_picture(8, 8)); }, "yfov");
    expect_error([&] { renderer.set_materials({}); }, "materials");
}

TEST_F(Robustness, AnEmptySceneIsItsBackground) {
    RenderSettings o = small_picture(4, 4);
    o.background_color = glm::vec3(0.25f, 0.5f, 1.0f);
    gpu::Renderer renderer(*context, Scene{}, nullptr);
    const Image image = renderer.render(Camera{}, o);
    EXPECT_EQ(rgb(image, 2, 2), o.background_color);
    EXPECT_EQ(image.at(2, 2)[3], 1.0f);
}

TEST_F(Robustness, InterruptsStopARender) {
    gpu::Renderer renderer(*context, lit_sphere(), nullptr);
    int steps = 0;
    const Progress progress([&](std::string_view stage, double done) {
        if (stage != "render") return;  // shaders are compiled first
        EXPECT_GE(done, 0.0);
        if (++steps == 3) throw Interrupted();
    });
    EXPECT_THROW(renderer.render(camera_on_z(), small_picture(8, 8, 64), progress), Interrupted);
    EXPECT_EQ(steps, 3);
    // The renderer still works.
    EXPECT_EQ(renderer.render(camera_on_z(), small_picture(8, 8)).width, 8);
}

}  // namespace
}  // namespace burnish::test
