// What the viewer computes and compiles off the frame.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "gpu/device/cloth_store.hpp"
#include "gpu/device/program.hpp"
#include "gpu/gpu_fixture.hpp"
#include "viewer/document/load_stage.hpp"
#include "viewer/generate/scratches.hpp"
#include "viewer/prepare/motion_data.hpp"
#include "viewer/prepare/warm_up.hpp"

namespace burnish::viewer {
namespace {

using test::GpuTest;

Stage stage_of(const std::string& input,
               const std::vector<std::pair<std::string, std::string>>& values = {}) {
    Document document{.input = input, .environment = "none"};
    for (const auto& [name, value] : values) document.values.set(name, value, "");
    return load_stage(document);
}

RenderSettings settings_of(SurfacePass pass, bool coarse = false) {
    RenderSettings o = test::small_picture(32, 32);
    o.surface_pass = pass;
    o.coarse = coarse;
    return o;
}

// Until it says true; false after 20 s, which is a hundred times what the work takes.
template <typename Done>
bool comes_true(Done done) {
    for (int i = 0; i < 2000; ++i) {
        if (done()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

double mean_difference(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        sum += std::abs(static_cast<double>(a.pixels[i] - b.pixels[i]));
    return sum / static_cast<double>(a.pixels.size());
}

class Prepared : public GpuTest {};

TEST_F(Prepared, AChangeAfterTheWarmUpCompilesNothing) {
    Stage stage = stage_of("builtin:plane", {{"alpha_x", "0.1"}, {"alpha_y", "0.3"}});
    stage.scene.lights = {parse_light("20,40,2")};
    stage.settings = settings_of(SurfacePass::forward);
    const RenderSettings motion = settings_of(SurfacePass::deferred, true);
    context->programs().set_limit(256);
    gpu::Renderer renderer(*context, stage.scene, nullptr);
    const auto draw = [&](const RenderSettings& settings) {
        renderer.begin(stage.camera, settings);
        renderer.add_sample();
    };
    // The scene as it is was drawn, at rest and in motion, before the window warms up.
    draw(stage.settings);
    draw(motion);
    WarmUp warm_up(*context);
    EXPECT_TRUE(warm_up.done());
    warm_up.follow(stage, SurfacePass::forward);
    EXPECT_EQ(warm_up.left(), 2 + method_names().size() + mdf_names().size() + brdf_names().size());
    const std::size_t before = context->programs().size();
    while (warm_up.step(motion)) {
    }
    EXPECT_TRUE(warm_up.done());
    const std::size_t warm = context->programs().size();
    EXPECT_GT(warm, before + mdf_names().size());

    const Material own = stage.scene.materials.at(0);
    for (std::size_t i = 0; i < mdf_names().size(); ++i) {
        Material changed = own;
        changed.mdf = static_cast<Mdf>(i);
        renderer.update_material(0, changed);
        draw(stage.settings);
        EXPECT_EQ(context->programs().size(), warm) << mdf_names()[i];
    }
    // Scratches that are dragged, and the full ones when they are let go.
    ScratchChoice choice = scratch_choice("brushed");
    choice.recipe.settings.size = 64;
    const ScratchTextures maps = coarse_scratches(scratch_recipe(choice));
    Material shown = scratch_previews(stage, 0, maps.tile_mm).at(0).shown;
    shown.normal_texture.texture = renderer.add_texture(maps.normal);
    renderer.update_material(0, shown);
    draw(motion);
    draw(stage.settings);
    EXPECT_EQ(context->programs().size(), warm);
}

TEST_F(Prepared, AnotherSceneWarmsUpAnewAndClothNotAtAll) {
    WarmUp warm_up(*context);
    const Stage stage = stage_of("builtin:plane");
    warm_up.follow(stage, SurfacePass::forward);
    const std::size_t all = warm_up.left();
    ASSERT_TRUE(warm_up.step(settings_of(SurfacePass::deferred, true)));
    EXPECT_EQ(warm_up.left(), all - 1);
    warm_up.follow(stage, SurfacePass::forward);
    EXPECT_EQ(warm_up.left(), all);
    // Their tables would be made again.
    warm_up.follow(stage_of("builtin:plane", {{"weave", "plain"}}), SurfacePass::forward);
    EXPECT_TRUE(warm_up.done());
    EXPECT_FALSE(warm_up.step(settings_of(SurfacePass::deferred, true)));
    // Four materials are the most.
    Stage many = stage;
    for (int i = 0; i < 4; ++i) {
        many.scene.materials.push_back(stage.scene.materials.at(0));
        many.scene.materials.back().metallic = 0.1f * static_cast<float>(i + 1);
    }
    warm_up.follow(many, SurfacePass::forward);
    EXPECT_TRUE(warm_up.done());
    many.scene.materials.pop_back();
    warm_up.follow(many, SurfacePass::forward);
    EXPECT_EQ(warm_up.left(), all);
}

// A torus of 20,000 triangles, and its pictures with all of them and with coarse ones.
class CoarseMeshes : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        if (IsSkipped()) return;
        stage = stage_of("builtin:torus", {{"triangles", "20000"}});
        stage.scene.lights = {parse_light("20,40,2")};
        renderer = std::make_unique<gpu::Renderer>(*context, stage.scene, nullptr);
    }
    Image picture(bool coarse) {
        return renderer->render(stage.camera, settings_of(SurfacePass::forward, coarse));
    }

    Stage stage;
    std::unique_ptr<gpu::Renderer> renderer;
};

TEST_F(CoarseMeshes, AreMadeInTheBackgroundAndGivenOnce) {
    const Image full = picture(false);
    EXPECT_EQ(picture(true).pixels, full.pixels);
    MotionMeshes meshes;
    EXPECT_FALSE(meshes.give(*renderer));
    meshes.follow(stage.scene, 500);
    EXPECT_TRUE(meshes.working());
    ASSERT_TRUE(comes_true([&] { return meshes.give(*renderer); }));
    EXPECT_FALSE(meshes.working());
    EXPECT_FALSE(meshes.give(*renderer));
    EXPECT_EQ(picture(false).pixels, full.pixels);
    // 500 triangles of a torus are seen, but its shape is the same: the pixels of its outline, a twentieth of
    // the picture, may differ wholly.
    const double difference = mean_difference(picture(true), full);
    EXPECT_GT(difference, 0.0);
    EXPECT_LT(difference, 0.05);
}

TEST_F(CoarseMeshes, AreNotMadeWhereTheyWouldSaveAFifthOrLess) {
    MotionMeshes meshes;
    meshes.follow(stage.scene, 17000);  // 0.85 of the triangles
    EXPECT_FALSE(meshes.working());
    meshes.follow(Scene{}, 500);
    EXPECT_FALSE(meshes.working());
    meshes.follow(stage.scene, 15000);
    EXPECT_TRUE(meshes.working());
}

TEST_F(CoarseMeshes, OfASceneThatWasLeftAreNotGiven) {
    const Image full = picture(false);
    MotionMeshes meshes;
    meshes.follow(stage.scene, 500);
    meshes.follow(stage.scene, 1000000);  // as it would be for one that needs none
    ASSERT_TRUE(comes_true([&] {
        EXPECT_FALSE(meshes.give(*renderer));
        return !meshes.working();
    }));
    EXPECT_EQ(picture(true).pixels, full.pixels);
    // What is asked for while another is in work comes after it.
    meshes.follow(stage.scene, 500);
    meshes.follow(stage.scene, 400);
    ASSERT_TRUE(comes_true([&] { return meshes.give(*renderer); }));
    EXPECT_NE(picture(true).pixels, full.pixels);
}

TEST_F(Prepared, AClothIsDrawnByCoarseMeansUntilTheFullOnesAreThere) {
    const Stage stage = stage_of(
        "builtin:plane",
        {{"weave", "satin-5"}, {"weave_yarns", "400"}, {"alpha_x", "0.1"}, {"alpha_y", "0.2"}});
    Scene scene = stage.scene;
    scene.lights = {parse_light("20,40,2")};
    const RenderSettings settings = settings_of(SurfacePass::forward);
    gpu::Renderer renderer(*context, scene, nullptr);
    const Image full = renderer.render(stage.camera, settings);
    MotionCloths cloths(*context);
    EXPECT_FALSE(cloths.any());

    // A change of the weave, as a drag makes it.
    context->cloths().prefer_coarse(true);
    std::get<Cloth>(scene.materials.at(0).lobe).bulge = 0.3f;
    renderer.update_material(0, scene.materials.at(0));
    EXPECT_TRUE(cloths.any());
    const Image coarse = renderer.render(stage.camera, settings);
    EXPECT_GT(mean_difference(coarse, full), 0.0);
    EXPECT_FALSE(cloths.give(renderer));
    cloths.begin();
    ASSERT_TRUE(comes_true([&] { return cloths.give(renderer); }));
    EXPECT_FALSE(cloths.any());
    EXPECT_FALSE(cloths.give(renderer));
    const Image refined = renderer.render(stage.camera, settings);

    // As a renderer draws it that has never seen coarse means.
    gpu::Context other;
    gpu::Renderer direct(other, scene, nullptr);
    const Image wanted = direct.render(stage.camera, settings);
    context->make_current();
    EXPECT_EQ(refined.pixels, wanted.pixels);
    // The coarse means are close: a step of the surface is one alpha, by whose variance the lobe is widened,
    // at most 1/12 of its alpha^2, and the table of 32 texels is interpolated linearly.
    double sum = 0;
    for (const float value : wanted.pixels) sum += static_cast<double>(value);
    const double mean = sum / static_cast<double>(wanted.pixels.size());
    EXPECT_LT(mean_difference(coarse, wanted), 0.05 * mean);

    // Another change, which is needed at once.
    std::get<Cloth>(scene.materials.at(0).lobe).crimp = 0.05f;
    renderer.update_material(0, scene.materials.at(0));
    EXPECT_TRUE(cloths.any());
    cloths.finish(renderer);
    EXPECT_FALSE(cloths.any());
}

}  // namespace
}  // namespace burnish::viewer
