// The inspector at the pixels of a picture against what the renderer drew there: picking, frames, textures
// and the maths together. One directional light, one sample in the middle of each pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <memory>
#include <random>
#include <string>

#include "burnish/draft.hpp"
#include "gpu/gpu_fixture.hpp"
#include "gpu/tabulated_scenes.hpp"
#include "viewer/inspect/inspector.hpp"
#include "viewer/motion/light_sphere.hpp"
#include "viewer/viewer_scenes.hpp"

namespace burnish::viewer {
namespace {

// Relative errors plus 0.01 absolute. Measured on llvmpipe: at most 9e-6 for cloth, 5.7e-5 for the others,
// whose table of albedos the renderer holds in half floats; 1.3e-4 for tables, whose texels the renderer holds in 16 bits. The bounds are three to five times that,
// for processors that round in another way.
constexpr double kPixelError = 2e-4, kTablePixelError = 4e-4;

constexpr int kPicturePixels = 64;

// Texels between `low` and `high`, by a seed.
Texture random_texture(int size, glm::vec3 low, glm::vec3 high, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::vector<glm::vec3> texels;
    for (int i = 0; i < size * size; ++i)
        texels.push_back(glm::mix(low, high, glm::vec3(unit(random), unit(random), unit(random))));
    return test::float_texture(size, size, texels);
}

TextureUse use_of(int texture) {
    TextureUse use;
    use.texture = texture;
    return use;
}

// A sphere that fills more than the picture, mirrored and turned.
Scene sphere_scene(Material material) {
    Mesh mesh = test::uv_sphere(64, 32);
    for (const glm::vec3& p : mesh.positions) mesh.colors.emplace_back(0.6f + 0.4f * p, 1.0f);
    Scene scene = test::one_object(mesh, std::move(material));
    scene.instances[0].transform =
        glm::rotate(glm::mat4(1.0f), 0.5f, glm::normalize(glm::vec3(1, 2, 0.5f)));
    scene.instances[0].transform[0] *= -1.1f;
    scene.lights.push_back(test::directional({0.6f, 0.5f, 1.0f}, {2.0f, 1.5f, 1.0f}));
    return scene;
}

class InspectorPixels : public test::GpuTest {
  protected:
    void compare(const Scene& scene, const Camera& camera, const std::string& what, double bound) {
        RenderSettings settings = test::small_picture(kPicturePixels, kPicturePixels);
        settings.filter_cloth = false;
        gpu::Renderer renderer(*context, scene, nullptr);
        const Image image = renderer.render(camera, settings);
        const Picker picker(scene);
        const Light& light = scene.lights[0];
        double worst = 0, brightest = 0;
        int compared = 0;
        for (int y = 2; y < kPicturePixels; y += 5) {
            for (int x = 2; x < kPicturePixels; x += 5) {
                const auto hit = pick(scene, picker, camera, {x + 0.5, y + 0.5},
                                      {kPicturePixels, kPicturePixels});
                if (!hit) continue;
                const glm::dvec3 eye = towards_eye(camera, hit->position);
                const Method methods[] = {
                    scene.materials[static_cast<std::size_t>(hit->material)].method};
                const LobeReport report = inspect(
                    scene, *hit, eye, towards_light(light, hit->position), methods, Shapes::none);
                const glm::dvec3 wanted = report.methods[0].f_cos * glm::dvec3(light.color) *
                                          static_cast<double>(light.intensity);
                ++compared;
                for (int c = 0; c < 3; ++c) {
                    const auto drawn = static_cast<double>(image.at(x, y)[c]);
                    brightest = std::max(brightest, drawn);
                    worst =
                        std::max(worst, std::abs(drawn - wanted[c]) / (std::abs(wanted[c]) + 0.01));
                }
            }
        }
        if (std::getenv("BURNISH_PRINT_PARITY") != nullptr)
            std::printf("inspected %-40s %.1e of %.2f\n", what.c_str(), worst, brightest);
        EXPECT_GT(compared, 100) << what;
        EXPECT_GT(brightest, 0.1) << what;
        EXPECT_LT(worst, bound) << what;
    }
};

constexpr Method kSomeMethods[] = {Method::none, Method::normal_map, Method::follow_grain,
                                   Method::gram_schmidt, Method::deform_smooth};

Material textured_material(Method method) {
    Material m;
    m.lobe = GltfLobe{0.9f, 0.8f};
    m.method = method;
    m.base_color = {0.9f, 0.8f, 0.7f, 1.0f};
    m.metallic = 0.8f;
    m.anisotropy_rotation = 0.4f;
    m.anisotropy_texture_turn = 0.2f;
    m.normal_scale = 0.8f;
    m.base_color_texture = use_of(0);
    m.metallic_roughness_texture = use_of(1);
    m.normal_texture = use_of(2);
    m.anisotropy_texture = use_of(3);
    return m;
}

void add_textures(Scene& scene) {
    scene.textures.push_back(random_texture(4, glm::vec3(0.2f), glm::vec3(1.0f), 1));
    scene.textures.push_back(random_texture(4, glm::vec3(0.5f), glm::vec3(1.0f), 2));
    scene.textures.push_back(random_texture(6, {0.3f, 0.3f, 0.8f}, {0.7f, 0.7f, 1.0f}, 3));
    scene.textures.push_back(random_texture(3, {0.6f, 0.3f, 0.4f}, {1.0f, 0.7f, 1.0f}, 4));
}

TEST_F(InspectorPixels, TexturesOfEveryKind) {
    const Camera camera = test::camera_on_z(4.0f, 0.6f);
    for (const Method method : kSomeMethods) {
        for (const NormalFilter filter : {NormalFilter::moments, NormalFilter::mips}) {
            Material m = textured_material(method);
            m.normal_filter = filter;
            Scene scene = sphere_scene(m);
            add_textures(scene);
            compare(scene, camera, "shared " + std::string(name_of(method)), kPixelError);
        }
    }
}

TEST_F(InspectorPixels, TexturesOfTheirOwnTransforms) {
    Camera camera = test::camera_on_z(4.0f, 0.6f);
    camera.orthographic = true;
    camera.ymag = 0.6f;
    Material m = textured_material(Method::follow_grain);
    m.flip_green = true;
    m.base_color_texture.transform = glm::mat3(0.7f, 0.3f, 0, -0.3f, 0.7f, 0, 0.2f, 0.9f, 1);
    m.metallic_roughness_texture.texcoord = 1;
    m.metallic_roughness_texture.wrap_s = Wrap::mirror;
    m.normal_texture.transform = glm::mat3(1.5f, 0, 0, 0, 1.5f, 0, 0.3f, 0.1f, 1);
    m.anisotropy_texture.nearest = true;
    Scene scene = sphere_scene(m);
    Mesh& mesh = scene.meshes[0];
    for (const glm::vec2& uv : mesh.texcoord0) mesh.texcoord1.push_back(0.5f * uv + 0.3f);
    add_textures(scene);
    // 8 bits, read without interpolation.
    scene.materials[0].base_color_texture.nearest = true;
    Texture& color = scene.textures[0];
    color.type = TexelType::u8;
    color.texels.resize(48);
    for (std::size_t i = 0; i < 48; ++i) color.texels[i] = static_cast<std::byte>(80 + 3 * i);
    compare(scene, camera, "own transforms", kPixelError);
    // llvmpipe decodes sRGB by a polynomial: 4e-3 of these values.
    color.color_space = ColorSpace::srgb;
    compare(scene, camera, "own transforms, sRGB", 8e-3);
}

TEST_F(InspectorPixels, BacksOfSheets) {
    Material m = textured_material(Method::follow_grain);
    m.double_sided = true;
    Scene scene = test::one_object(test::unit_plane(), m);
    add_textures(scene);
    scene.instances[0].transform = glm::rotate(glm::mat4(1.0f), 2.8f, {0.1f, 1.0f, 0.0f});
    scene.lights.push_back(test::directional({0.3f, 0.2f, 1.0f}));
    compare(scene, test::camera_on_z(4.0f, 0.8f), "backs", kPixelError);
}

TEST_F(InspectorPixels, YarnsOfCloth) {
    for (const Method method : kSomeMethods) {
        Material m;
        m.method = method;
        m.metallic = 0.2f;
        Cloth cloth;
        cloth.draft = std::make_shared<Draft>(builtin_draft("twill-2-2"));
        cloth.yarns = 12.0f;
        cloth.warp_color = glm::vec3(0.6f, 0.5f, 0.3f);
        cloth.weft_color = glm::vec3(0.05f, 0.1f, 0.3f);
        m.lobe = cloth;
        m.anisotropy_rotation = 0.2f;
        compare(sphere_scene(m), test::camera_on_z(4.0f, 0.6f),
                "cloth " + std::string(name_of(method)), kPixelError);
    }
}

TEST_F(InspectorPixels, MeasuredTexels) {
    TabulatedMaterial t = test::blank_material({24, 80}, 1, 1);
    test::add_exemplar(t, test::ggx_table(t.grid, 0.2, 0.5, 0.7), 0.7f);
    t.eta = 1.5;
    t.angle[0] = 0.3f;
    t.diffuse.pixels = {0.25f, 0.125f, 0.5f};
    t.specular.pixels = {0.5f, 0.25f, 0.75f};
    const glm::vec3 n = glm::normalize(glm::vec3(0.1f, -0.2f, 1.0f));
    t.normal.pixels = {n.x, n.y, n.z};
    for (const Method method : kSomeMethods) {
        Material m;
        m.method = method;
        m.lobe = Tabulated{std::make_shared<const TabulatedMaterial>(t), {}};
        m.anisotropy_rotation = 0.3f;
        m.normal_texture = use_of(0);
        Scene scene = sphere_scene(m);
        scene.textures.push_back(random_texture(6, {0.35f, 0.35f, 0.8f}, {0.65f, 0.65f, 1.0f}, 3));
        compare(scene, test::camera_on_z(4.0f, 0.6f), "table " + std::string(name_of(method)),
                kTablePixelError);
    }
}

// The light that light_for_highlight finds makes the picked pixel the brightest of a smooth surface.
TEST_F(InspectorPixels, TheHighlightIsAtThePickedPoint) {
    Material m;
    m.metallic = 1.0f;
    m.lobe = AlphaLobe{{0.05f, 0.12f}};
    Scene scene = test::one_object(test::uv_sphere(256, 128), m);
    scene.lights.push_back(test::directional({0, 0, 1}));
    const Camera camera = test::camera_on_z(4.0f, 1.1f);
    for (const glm::ivec2 wanted : {glm::ivec2(40, 25), glm::ivec2(22, 38), glm::ivec2(32, 32)}) {
        const glm::dvec2 pixel(wanted.x + 0.5, wanted.y + 0.5);
        const auto hit =
            pick(scene, Picker(scene), camera, pixel, {kPicturePixels, kPicturePixels});
        ASSERT_TRUE(hit.has_value());
        const auto light =
            light_for_highlight(scene, *hit, towards_eye(camera, hit->position), scene.lights[0]);
        ASSERT_TRUE(light.has_value());
        scene.lights[0] = *light;
        gpu::Renderer renderer(*context, scene, nullptr);
        const Image image =
            renderer.render(camera, test::small_picture(kPicturePixels, kPicturePixels));
        float most = 0;
        glm::ivec2 brightest(0);
        for (int y = 0; y < kPicturePixels; ++y) {
            for (int x = 0; x < kPicturePixels; ++x) {
                if (image.at(x, y)[1] > most) {
                    most = image.at(x, y)[1];
                    brightest = {x, y};
                }
            }
        }
        // Off-specular shift is a small part of the lobe's width of several pixels.
        EXPECT_LE(std::abs(brightest.x - wanted.x), 1);
        EXPECT_LE(std::abs(brightest.y - wanted.y), 1);
    }
}

}  // namespace
}  // namespace burnish::viewer
