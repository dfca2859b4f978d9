// Positions in the picture, and invariance under tiles, passes, mirroring and methods.
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "burnish/context.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "gpu_fixture.hpp"
#include "test_scene.hpp"

namespace burnish::test {
namespace {

class Picture : public GpuTest {
  protected:
    Image render(const Scene& scene, const RenderSettings& o,
                 const Camera& camera = camera_on_z(4.0f, 1.2f),
                 const Environment* environment = nullptr) {
        gpu::Renderer renderer(*context, scene, environment);
        return renderer.render(camera, o);
    }
};

Material bumpy_material() {
    Material m;
    m.lobe = AlphaLobe{{0.4f, 0.15f}};
    m.normal_texture.texture = 0;
    return m;
}

Scene bumpy_sphere() {
    Scene scene = one_object(uv_sphere(64, 32), bumpy_material());
    scene.textures.push_back(bump_texture(64, 5, 0.3f));
    scene.lights.push_back(directional({0.4f, 0.5f, 1.0f}));
    return scene;
}

TEST_F(Picture, RowZeroIsOnTopAndRedComesFromTheRight) {
    Material m;
    m.metallic = 0.0f;
    Scene scene = one_object(uv_sphere(32, 16), m);
    scene.lights.push_back(directional({1, 0, 0.2f}, {1, 0, 0}));
    scene.lights.push_back(directional({0, 1, 0.2f}, {0, 0, 1}));
    const Image image = render(scene, small_picture(33, 33));
    EXPECT_GT(image.at(27, 16)[0], 10 * image.at(5, 16)[0] + 1e-3f);
    EXPECT_GT(image.at(16, 5)[2], 10 * image.at(16, 27)[2] + 1e-3f);
}

TEST_F(Picture, FlatNormalMapMakesAllMethodsOne) {
    Scene scene = one_object(uv_sphere(32, 16), bumpy_material());
    scene.textures.push_back(constant_texture({0.5f, 0.5f, 1.0f}));
    scene.lights.push_back(directional({0.4f, 0.5f, 1.0f}));
    gpu::Renderer renderer(*context, scene, nullptr);
    const RenderSettings o = small_picture(24, 24);
    scene.materials[0].method = Method::none;
    renderer.set_materials(scene.materials);
    const Image first = renderer.render(camera_on_z(), o);
    for (int method = 1; method <= static_cast<int>(Method::stretch); ++method) {
        scene.materials[0].method = static_cast<Method>(method);
        renderer.set_materials(scene.materials);
        EXPECT_TRUE(close_pictures(renderer.render(camera_on_z(), o), first, 1e-2, 1e-3))
            << name_of(static_cast<Method>(method));
    }
}

// Engines are wrong for anisotropic lobes only, because isotropic lobes take a separate path there.
TEST_F(Picture, NormalMapOnAnIsotropicMaterialIsTheRotatedLobe) {
    Scene scene = bumpy_sphere();
    const Environment environment = constant_environment({0.5f, 0.7f, 1.0f});
    gpu::Renderer renderer(*context, scene, &environment);
    RenderSettings o = small_picture(48, 48, 2);
    o.image_light_samples = 8;
    const auto drawn = [&](Method method, glm::vec2 alpha) {
        scene.materials[0].method = method;
        scene.materials[0].lobe = AlphaLobe{alpha};
        renderer.set_materials(scene.materials);
        return renderer.render(camera_on_z(), o);
    };
    const glm::vec2 isotropic(0.25f), brushed(0.4f, 0.15f);
    // The software renderer repeats its own pictures within 1e-7: one rounding of the sum.
    EXPECT_TRUE(close_pictures(drawn(Method::normal_map, isotropic),
                               drawn(Method::gram_schmidt, isotropic), 1e-2, 1e-6));
    EXPECT_GT(largest_difference(drawn(Method::normal_map, brushed),
                                 drawn(Method::gram_schmidt, brushed), 1e-2),
              0.5);
}

TEST_F(Picture, TilesLeaveNoSeam) {
    Scene scene = bumpy_sphere();
    const Environment environment = constant_environment({0.5f, 0.7f, 1.0f});
    RenderSettings o = small_picture(150, 100, 2);
    o.background = BackgroundKind::environment;
    o.image_light_samples = 4;
    gpu::Renderer renderer(*context, scene, &environment);
    const Camera camera = camera_on_z(4.0f, 1.2f);
    for (const SurfacePass pass : {SurfacePass::forward, SurfacePass::deferred}) {
        o.surface_pass = pass;
        o.tile_size = 0;
        const Image whole = renderer.render(camera, o);
        o.tile_size = 37;
        const Image tiled = renderer.render(camera, o);
        double sum = 0, difference = 0;
        int different = 0;
        for (std::size_t i = 0; i < whole.pixels.size(); ++i) {
            const double d = std::abs(tiled.pixels[i] - whole.pixels[i]);
            sum += whole.pixels[i];
            difference += d;
            different += d > 1e-4 ? 1 : 0;
        }
        // At the limb, slender triangles are interpolated from another origin, and a sample of the
        // environment may change sides of the horizon: a few values differ, but seams do not show.
        EXPECT_LT(difference / sum, 1e-4);
        EXPECT_LT(different, 150 * 100 * 4 / 100);
    }
}

TEST_F(Picture, ForwardAndDeferredAreOnePicture) {
    const Scene scene = bumpy_sphere();
    RenderSettings o = small_picture(64, 64);
    o.surface_pass = SurfacePass::forward;
    const Image forward = render(scene, o);
    o.surface_pass = SurfacePass::deferred;
    const Image deferred = render(scene, o);
    double sum = 0, difference = 0;
    for (std::size_t i = 0; i < forward.pixels.size(); ++i) {
        sum += forward.pixels[i];
        difference += std::abs(forward.pixels[i] - deferred.pixels[i]);
    }
    // Mips differ by 1/16 of a level, the rounding of the packed footprint.
    EXPECT_LT(difference / sum, 5e-3);
}

TEST_F(Picture, ManyMaterialsAreShadedEachWhereItIsSeen) {
    Scene scene = bumpy_sphere();
    for (int i = 1; i < 4; ++i) {
        scene.materials.push_back(scene.materials[0]);
        scene.materials.back().emissive = glm::vec3(0, 0, static_cast<float>(i));
        Instance instance;
        instance.material = i;
        instance.transform = glm::translate(glm::mat4(1.0f), glm::vec3(i - 2, 0.4f * float(i), -i));
        scene.instances.push_back(instance);
    }
    RenderSettings o = small_picture(64, 64);
    o.surface_pass = SurfacePass::forward;
    const Image forward = render(scene, o);
    o.surface_pass = SurfacePass::deferred;
    const Image deferred = render(scene, o);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            EXPECT_NEAR(forward.at(x, y)[2], deferred.at(x, y)[2], 0.3f) << x << "," << y;
        }
    }
}

TEST_F(Picture, TransparentBackgroundHoldsCoverage) {
    Material m;
    m.emissive = glm::vec3(2.0f);
    const Scene scene = one_object(uv_sphere(128, 64), m);
    RenderSettings o = small_picture(64, 64, 16);
    o.background = BackgroundKind::transparent;
    Camera camera;
    camera.orthographic = true;
    camera.ymag = 1.25f;
    const Image image = render(scene, o, camera);
    double covered = 0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const float* p = image.at(x, y);
            covered += p[3];
            EXPECT_NEAR(p[0], p[3] > 0.0f ? 2.0f : 0.0f, 1e-3f);  // not premultiplied
        }
    }
    const double disc = 3.14159265 * (32 / 1.25) * (32 / 1.25);
    EXPECT_NEAR(covered / disc, 1.0, 0.01);
    EXPECT_EQ(image.at(0, 0)[3], 0.0f);
    EXPECT_EQ(image.at(32, 32)[3], 1.0f);
}

// A mesh mirrored by its transform, with a mirrored texture, gives the mirrored picture.
TEST_F(Picture, MirroredTransformGivesTheMirroredPicture) {
    Scene scene = bumpy_sphere();
    scene.materials[0].lobe = AlphaLobe{{0.5f, 0.12f}};
    scene.materials[0].anisotropy_rotation = 0.6f;
    const glm::mat4 place = glm::translate(glm::mat4(1.0f), glm::vec3(0.2f, 0.1f, 0.0f)) *
                            glm::rotate(glm::mat4(1.0f), 0.7f, glm::vec3(0.3f, 0.5f, 0.2f));
    const glm::mat4 mirror = glm::scale(glm::mat4(1.0f), glm::vec3(-1.0f, 1.0f, 1.0f));
    for (const SurfacePass pass : {SurfacePass::forward, SurfacePass::deferred}) {
        RenderSettings o = small_picture(48, 48);
        o.surface_pass = pass;
        scene.instances[0].transform = place;
        scene.lights[0] = directional({0.4f, 0.5f, 1.0f});
        const Image plain = render(scene, o);
        scene.instances[0].transform = mirror * place;
        scene.lights[0] = directional({-0.4f, 0.5f, 1.0f});
        const Image mirrored = render(scene, o);
        double sum = 0, difference = 0;
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 48; ++x) {
                sum += plain.at(x, y)[0];
                difference += std::abs(plain.at(x, y)[0] - mirrored.at(47 - x, y)[0]);
            }
        }
        EXPECT_GT(sum, 1.0);
        // Edges fall on the other side of pixel centers; tangents are packed to 7e-4 rad.
        EXPECT_LT(difference / sum, 0.01);
    }
}

// Mirrored UVs: u is reversed and w is -1; the bump pattern is reversed with it.
TEST_F(Picture, MirroredTextureCoordinatesMirrorTheBumps) {
    Scene scene = one_object(unit_plane(), bumpy_material());
    const glm::vec3 n = glm::normalize(glm::vec3(0.3f, 0.2f, 1.0f));
    scene.textures.push_back(constant_texture(0.5f * n + 0.5f));
    scene.lights.push_back(directional({-0.5f, 0.3f, 1.0f}));
    for (std::size_t i = 0; i < 4; ++i) {
        scene.meshes[0].texcoord0[i].x = 1 - scene.meshes[0].texcoord0[i].x;
        scene.meshes[0].tangents[i] = glm::vec4(-1, 0, 0, -1);  // bitangent stays +y
    }
    const Image mirrored = render(scene, small_picture(16, 16));
    Scene plain = one_object(unit_plane(), bumpy_material());
    const glm::vec3 other(-n.x, n.y, n.z);
    plain.textures.push_back(constant_texture(0.5f * other + 0.5f));
    plain.lights = scene.lights;
    EXPECT_TRUE(close_pictures(mirrored, render(plain, small_picture(16, 16)), 1e-2, 2e-3));
}

TEST_F(Picture, GreenDownMapsAreTheSameWithTheirGreenTurned) {
    Scene scene = one_object(unit_plane(), bumpy_material());
    const glm::vec3 n = glm::normalize(glm::vec3(0.3f, 0.25f, 1.0f));
    scene.textures.push_back(constant_texture(0.5f * n + 0.5f));
    scene.lights.push_back(directional({0.2f, 0.4f, 1.0f}));
    const Image up = render(scene, small_picture(8, 8));
    scene.textures[0] = constant_texture(0.5f * glm::vec3(n.x, -n.y, n.z) + 0.5f);
    scene.materials[0].flip_green = true;
    EXPECT_TRUE(close_pictures(render(scene, small_picture(8, 8)), up, 1e-2, 1e-4));
}

TEST_F(Picture, BackFacesShowWhenDoubleSided) {
    Material m;
    m.emissive = glm::vec3(1.0f);
    Scene scene = one_object(unit_plane(), m);
    Camera camera = camera_on_z();
    camera.position.z = -4.0f;
    EXPECT_EQ(render(scene, small_picture(8, 8), camera).at(4, 4)[0], 0.0f);
    scene.materials[0].double_sided = true;
    EXPECT_EQ(render(scene, small_picture(8, 8), camera).at(4, 4)[0], 1.0f);
}

TEST_F(Picture, MaskAndBlendFollowAlpha) {
    Material m;
    m.emissive = glm::vec3(1.0f);
    m.metallic = 1.0f;
    m.base_color.a = 0.4f;
    m.alpha_mode = AlphaMode::mask;
    Scene scene = one_object(unit_plane(), m);
    EXPECT_EQ(render(scene, small_picture(8, 8)).at(4, 4)[0], 0.0f);
    scene.materials[0].alpha_cutoff = 0.3f;
    EXPECT_EQ(render(scene, small_picture(8, 8)).at(4, 4)[0], 1.0f);
    scene.materials[0].alpha_mode = AlphaMode::blend;
    EXPECT_NEAR(render(scene, small_picture(8, 8)).at(4, 4)[0], 0.4f, 1e-5f);
    // A nearer blended plane, first in the list, is drawn last: 0.4 x 3 over 0.6 x 0.4.
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].emissive = glm::vec3(3.0f);
    Instance near_plane;
    near_plane.material = 1;
    near_plane.transform = glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, 0.5f));
    scene.instances.insert(scene.instances.begin(), near_plane);
    EXPECT_NEAR(render(scene, small_picture(8, 8)).at(4, 4)[0], 1.2f + 0.6f * 0.4f, 1e-4f);
}

TEST_F(Picture, BaseColorIsDecodedFromSrgb) {
    Material m;
    m.emissive = glm::vec3(1.0f);
    m.emissive_texture.texture = 0;
    Scene scene = one_object(unit_plane(), m);
    Texture t;
    t.name = "grey 188";
    t.width = t.height = 1;
    t.channels = 3;
    t.color_space = ColorSpace::srgb;
    t.texels.assign(3, std::byte{188});
    scene.textures.push_back(t);
    EXPECT_NEAR(render(scene, small_picture(8, 8)).at(4, 4)[0], 0.5029f, 1e-3f);
    scene.textures[0].color_space = ColorSpace::linear;
    EXPECT_NEAR(render(scene, small_picture(8, 8)).at(4, 4)[0], 188 / 255.0f, 1e-3f);
}

TEST_F(Picture, TextureTransformsAndSetsArePerUse) {
    // The left half of a texture is red, the right half green; emission reads it shifted by half.
    Scene scene = one_object(unit_plane(), Material{});
    scene.textures.push_back(float_texture(2, 1, {{1, 0, 0}, {0, 1, 0}}));
    Material& m = scene.materials[0];
    m.emissive = glm::vec3(1.0f);
    m.emissive_texture.texture = 0;
    m.emissive_texture.nearest = true;
    const Image plain = render(scene, small_picture(16, 16));
    EXPECT_EQ(plain.at(5, 8)[0], 1.0f);
    EXPECT_EQ(plain.at(10, 8)[1], 1.0f);
    m.emissive_texture.transform[2][0] = 0.5f;
    const Image moved = render(scene, small_picture(16, 16));
    EXPECT_EQ(moved.at(5, 8)[1], 1.0f);
    EXPECT_EQ(moved.at(10, 8)[0], 1.0f);
    m.occlusion_texture.texture = 0;  // another transform: each texture has coordinates of its own
    const Image separate = render(scene, small_picture(16, 16));
    EXPECT_TRUE(close_pictures(separate, moved, 1e-2, 1e-6));
}

TEST_F(Picture, EsDrawsThePictureOfTheDesktop) {
    const Scene scene = bumpy_sphere();
    const Environment environment = constant_environment({0.5f, 0.7f, 1.0f});
    RenderSettings o = small_picture(32, 32, 2);
    const Image desktop = render(scene, o, camera_on_z(), &environment);
    try {
        gpu::Context es(-1, gpu::GlApi::es);
        ASSERT_TRUE(es.is_es());
        gpu::Renderer renderer(es, scene, &environment);
        const Image image = renderer.render(camera_on_z(), o);
        // The normal map is half float there and float here.
        EXPECT_TRUE(close_pictures(image, desktop, 0.1, 0.1));
        double sum = 0, difference = 0;
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            sum += desktop.pixels[i];
            difference += std::abs(image.pixels[i] - desktop.pixels[i]);
        }
        EXPECT_LT(difference / sum, 2e-3);
    } catch (const Error& error) {
        GTEST_SKIP() << "SKIPPED, no ES context: " << error.what();
    }
}

}  // namespace
}  // namespace burnish::test
