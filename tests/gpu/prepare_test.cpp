// Long preparations: completed before a frame, cancelled at any step, or failed. The renderer then
// draws the same picture as before.
#include <functional>
#include <set>
#include <string>

#include "burnish/draft.hpp"
#include "edited_scenes.hpp"
#include "gpu/device/albedo_tables.hpp"
#include "gpu/device/program.hpp"
#include "gpu_fixture.hpp"

namespace burnish::test {
namespace {

using gpu::Renderer;

class Prepare : public GpuTest {
  protected:
    // Settings that need every kind of preparation: blurred environment, albedo tables, ground
    // shadow.
    static RenderSettings costly() {
        RenderSettings o = small_picture(40, 30, 1);
        o.image_light = ImageLight::prefiltered;
        o.ground = true;
        o.shadows = true;
        return o;
    }
    static Camera camera() {
        Camera above = camera_on_z(4.0f, 1.1f);
        above.position = {0.0f, 2.0f, 4.0f};
        return above;
    }
    static Image sample(Renderer& renderer) {
        renderer.add_sample();
        return renderer.picture();
    }

    // Calls `work` with a progress that is cancelled at its first step, then at its second, and so
    // on until `work` completes; calls `check` after each. Returns the stages.
    static std::set<std::string> cancel_everywhere(const std::function<void(const Progress&)>& work,
                                                   const std::function<void()>& check) {
        std::set<std::string> stages;
        for (int at = 1;; ++at) {
            const CancelToken token;
            int steps = 0;
            const Progress progress(
                [&](std::string_view stage, double) {
                    stages.emplace(stage);
                    if (++steps == at) token.cancel();
                },
                token);
            try {
                work(progress);
                return stages;  // it completed, whether cancelled at its last step or not
            } catch (const Interrupted&) {
            }
            check();
        }
    }

    Environment sky_ = sky_environment();
};

TEST_F(Prepare, CancelledAnywhereLeavesTheSeriesInProgress) {
    Scene scene = busy_scene();
    Renderer renderer(*context, scene, &sky_);
    RenderSettings plain = small_picture(40, 30, 64);
    plain.image_light_samples = 4;
    renderer.begin(camera(), plain);
    Renderer beside(*context, scene, &sky_);
    beside.begin(camera(), plain);
    const auto stages =
        cancel_everywhere([&](const Progress& p) { renderer.prepare(costly(), p); },
                          [&] { EXPECT_TRUE(equal_pictures(sample(renderer), sample(beside))); });
    EXPECT_TRUE(stages.contains("shaders"));
    EXPECT_TRUE(stages.contains("blurred environment"));
    EXPECT_TRUE(stages.contains("shadow on the ground"));
    // After preparation no frame compiles or makes anything.
    const std::size_t compiled = context->programs().size();
    renderer.begin(camera(), costly());
    const Image found = sample(renderer);
    EXPECT_EQ(context->programs().size(), compiled);
    Renderer fresh(*context, scene, &sky_);
    fresh.begin(camera(), costly());
    EXPECT_TRUE(equal_pictures(found, sample(fresh)));
}

TEST_F(Prepare, CancelledKeepsTheShadowOfTheSkyThatWasThere) {
    const Scene scene = busy_scene();
    Renderer renderer(*context, scene, &sky_);
    renderer.begin(camera(), costly());
    Renderer beside(*context, scene, &sky_);
    beside.begin(camera(), costly());
    RenderSettings rotated = costly();
    rotated.environment_rotation = 1.0f;
    cancel_everywhere([&](const Progress& p) { renderer.prepare(rotated, p); },
                      [&] { EXPECT_TRUE(equal_pictures(sample(renderer), sample(beside))); });
}

TEST_F(Prepare, EditsCancelledAnywhereChangeNothing) {
    Scene scene = busy_scene();
    Renderer renderer(*context, scene, &sky_);
    RenderSettings o = small_picture(40, 30, 2);
    o.image_light_samples = 4;
    const Image before = renderer.render(camera(), o);
    const auto unchanged = [&] {
        EXPECT_TRUE(equal_pictures(renderer.render(camera(), o), before));
    };
    Scene other = busy_scene();
    other.textures[0] = bump_texture(64, 3, 0.4f);
    other.textures[1] = constant_texture({1, 0, 1});
    other.materials[0].normal_filter = NormalFilter::mips;
    Cloth plain;
    plain.alpha = {0.5f, 0.2f};
    plain.draft = std::make_shared<Draft>(builtin_draft("plain"));
    other.materials[1].lobe = plain;
    const Environment dim = constant_environment({0.2f, 0.1f, 0.3f});

    const auto environment = cancel_everywhere(
        [&](const Progress& p) { renderer.set_environment(&dim, p); }, [&] { unchanged(); });
    EXPECT_TRUE(environment.contains("environment"));
    renderer.set_environment(&sky_);
    unchanged();
    const auto material = cancel_everywhere(
        [&](const Progress& p) { renderer.update_material(1, other.materials[1], p); },
        [&] { unchanged(); });
    EXPECT_TRUE(material.contains("weaves"));
    renderer.update_material(1, scene.materials[1]);
    unchanged();
    const auto whole = cancel_everywhere([&](const Progress& p) { renderer.set_scene(other, p); },
                                         [&] { unchanged(); });
    EXPECT_TRUE(whole.contains("textures") && whole.contains("meshes"));
    Renderer fresh(*context, other, &sky_);
    EXPECT_TRUE(equal_pictures(renderer.render(camera(), o), fresh.render(camera(), o)));
}

TEST_F(Prepare, FailedLeavesTheRendererDrawing) {
    Scene scene = busy_scene();
    Renderer renderer(*context, scene, &sky_);
    RenderSettings o = small_picture(40, 30, 1);
    renderer.begin(camera(), o);
    const Image before = sample(renderer);
    const Progress failing([](std::string_view, double) { throw Error("the device has gone"); });
    EXPECT_THROW(renderer.prepare(costly(), failing), Error);
    EXPECT_THROW(renderer.set_environment(&sky_, failing), Error);
    EXPECT_THROW(renderer.set_scene(scene, failing), Error);
    renderer.begin(camera(), o);
    EXPECT_TRUE(equal_pictures(sample(renderer), before));
}

TEST_F(Prepare, OneRenderCanBeCancelledAndAnotherNot) {
    const Scene scene = busy_scene();
    Renderer renderer(*context, scene, nullptr);
    const CancelToken first, second;
    first.cancel();
    const RenderSettings o = small_picture(16, 16, 2);
    EXPECT_THROW(renderer.render(camera(), o, Progress(first)), Interrupted);
    EXPECT_NO_THROW(renderer.render(camera(), o, Progress(second)));
}

TEST_F(Prepare, AlbedoTablesAreOfTheContext) {
    const Scene scene = busy_scene();
    RenderSettings o = small_picture(16, 16, 1);
    o.image_light = ImageLight::prefiltered;
    {
        Renderer first(*context, scene, &sky_);
        first.prepare(o);
    }
    EXPECT_TRUE(context->albedos().has(Brdf::microfacet, Mdf::ggx));
    EXPECT_FALSE(context->albedos().has(Brdf::microfacet, Mdf::beckmann));
    std::set<std::string> stages;
    Renderer second(*context, scene, &sky_);
    second.prepare(o, Progress([&](std::string_view stage, double) { stages.emplace(stage); }));
    EXPECT_EQ(stages, (std::set<std::string>{"blurred environment"}));
}

// A program of a software renderer holds 4 MB. A long session changes models hundreds of times.
TEST_F(Prepare, ProgramsThatWereNotUsedForLongestAreDeleted) {
    Scene scene = one_object(uv_sphere(12, 6), Material{});
    Renderer renderer(*context, scene, &sky_);
    RenderSettings o = small_picture(16, 12, 1);
    const auto picture_of = [&](Brdf brdf, Mdf mdf) {
        scene.materials[0].brdf = brdf;
        scene.materials[0].mdf = mdf;
        renderer.set_materials(scene.materials);
        return renderer.render(camera(), o);
    };
    const Image first = picture_of(Brdf::microfacet, Mdf::ggx);
    const std::size_t most = context->programs().size() + 2;
    context->programs().set_limit(most);
    for (const Mdf mdf : {Mdf::ward, Mdf::beckmann, Mdf::ashikhmin_shirley, Mdf::ggx})
        for (const Brdf brdf : {Brdf::microfacet_separable, Brdf::microfacet})
            picture_of(brdf, mdf);
    // Those of the last picture come on top.
    EXPECT_LE(context->programs().size(), most + 1);
    EXPECT_TRUE(equal_pictures(picture_of(Brdf::microfacet, Mdf::ggx), first));
}

}  // namespace
}  // namespace burnish::test
