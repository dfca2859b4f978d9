// Pictures by coarse meshes: nearly those of the whole meshes, with shadows of their own, and no trace
// of them in pictures that are not coarse.
#include <cmath>

#include "edited_scenes.hpp"
#include "gpu_fixture.hpp"

namespace burnish::test {
namespace {

using gpu::Renderer;

double mean_difference(const Image& a, const Image& b) {
    double sum = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 3; ++c)
                sum += std::abs(static_cast<double>(a.at(x, y)[c]) - b.at(x, y)[c]);
    return sum / (3.0 * a.width * a.height);
}

// Two spheres of 20 000 triangles over a plane, lit from the side.
Scene spheres() {
    Scene scene = busy_scene();
    scene.meshes[0] = uv_sphere(142, 71);
    scene.materials[0].normal_texture.texture = -1;
    return scene;
}

class Coarse : public GpuTest {
  protected:
    static RenderSettings settings(bool coarse) {
        RenderSettings o = small_picture(160, 120, 2);
        o.shadows = true;
        o.coarse = coarse;
        return o;
    }
    static Camera camera() { return camera_on_z(4.0f, 1.1f); }
};

TEST_F(Coarse, IsNearlyThePictureOfTheWholeMesh) {
    const Scene scene = spheres();
    Renderer renderer(*context, scene, nullptr);
    const Image whole = renderer.render(camera(), settings(false));
    EXPECT_TRUE(equal_pictures(whole, renderer.render(camera(), settings(true))))
        << "no coarse mesh was given";
    renderer.set_coarse_mesh(0, coarse_indices(scene.meshes[0], 1000));
    const Image coarse = renderer.render(camera(), settings(true));
    EXPECT_FALSE(equal_pictures(whole, coarse));
    // The outline of 1 000 triangles lies 0.5 % of the radius inside (0.1 pixel), and normals are
    // interpolated over 4 degrees. Surfaces that shadowed themselves, because the maps were those of
    // the whole mesh, would darken half of the lit side: 0.1.
    double mean = 0;
    for (int y = 0; y < whole.height; ++y)
        for (int x = 0; x < whole.width; ++x) mean += whole.at(x, y)[1];
    mean /= whole.width * whole.height;
    EXPECT_LT(mean_difference(whole, coarse), 0.02 * mean);
    EXPECT_TRUE(equal_pictures(whole, renderer.render(camera(), settings(false))))
        << "shadow maps of the coarse mesh stayed";
}

TEST_F(Coarse, StaysWithAnEqualMeshAndEndsWithEmptyIndices) {
    const Scene scene = spheres();
    Renderer renderer(*context, scene, nullptr);
    const Image whole = renderer.render(camera(), settings(true));
    renderer.set_coarse_mesh(0, coarse_indices(scene.meshes[0], 1000));
    const Image coarse = renderer.render(camera(), settings(true));
    renderer.set_scene(scene);
    EXPECT_TRUE(equal_pictures(coarse, renderer.render(camera(), settings(true))));
    renderer.set_coarse_mesh(0, {});
    EXPECT_TRUE(equal_pictures(whole, renderer.render(camera(), settings(true))));
}

TEST_F(Coarse, LeavesASeriesThatIsNotCoarseAlone) {
    const Scene scene = spheres();
    Renderer renderer(*context, scene, nullptr);
    renderer.begin(camera(), settings(false));
    renderer.add_sample();
    renderer.select_series(1);
    renderer.begin(camera(), settings(true));
    renderer.add_sample();
    renderer.set_coarse_mesh(0, coarse_indices(scene.meshes[0], 1000));
    EXPECT_EQ(renderer.samples_done(), 0) << "the coarse series has to begin anew";
    renderer.select_series(0);
    EXPECT_EQ(renderer.samples_done(), 1);
}

TEST_F(Coarse, RefusesWhatIsNoTriangleOfTheMesh) {
    Renderer renderer(*context, spheres(), nullptr);
    const std::vector<std::uint32_t> two = {0, 1}, outside = {0, 1, 1'000'000}, good = {0, 1, 2};
    EXPECT_THROW(renderer.set_coarse_mesh(0, two), Error);
    EXPECT_THROW(renderer.set_coarse_mesh(0, outside), Error);
    EXPECT_THROW(renderer.set_coarse_mesh(7, good), Error);
    EXPECT_THROW(renderer.set_coarse_mesh(-1, good), Error);
}

// A shadow on the ground that was made for a picture in motion is made again for one at rest, and one
// at rest serves both.
TEST_F(Coarse, ShadowsOnTheGroundAreMadeAgainAtRest) {
    const Scene scene = spheres();
    const Environment sky = sky_environment();
    Camera above = camera();
    above.position = {0.0f, 3.0f, 4.0f};
    const auto with_ground = [](bool coarse) {
        RenderSettings o = settings(coarse);
        o.ground = true;
        o.background = BackgroundKind::environment;
        return o;
    };
    Renderer fresh(*context, scene, &sky);
    const Image wanted = fresh.render(above, with_ground(false));
    Renderer renderer(*context, scene, &sky);
    const Image quick = renderer.render(above, with_ground(true));
    EXPECT_FALSE(equal_pictures(wanted, quick));
    EXPECT_TRUE(equal_pictures(wanted, renderer.render(above, with_ground(false))));
    EXPECT_TRUE(equal_pictures(wanted, renderer.render(above, with_ground(true))))
        << "no mesh is coarse, and the shadow of the picture at rest serves";
}

}  // namespace
}  // namespace burnish::test
