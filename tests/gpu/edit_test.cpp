// Edits of a scene on the device: each gives the picture of a new renderer of the edited scene, and
// uploads only new data.
#include <functional>
#include <vector>

#include "burnish/conductors.hpp"
#include "burnish/draft.hpp"
#include "edited_scenes.hpp"
#include "gpu/device/program.hpp"
#include "gpu_fixture.hpp"

namespace burnish::test {
namespace {

using gpu::Renderer;
using gpu::UploadCounts;

class Edit : public GpuTest {
  protected:
    static RenderSettings settings() {
        RenderSettings o = small_picture(64, 48, 2);
        o.image_light_samples = 4;
        o.shadows = true;
        return o;
    }
    static Camera camera() { return camera_on_z(4.0f, 1.1f); }

    // The picture after an edit equals that of a new renderer of the edited scene. Returns the
    // uploads of the edit and the picture that follows it.
    UploadCounts expect_as_new(const std::function<void(Renderer&, Scene&)>& change) {
        Scene scene = busy_scene();
        Renderer renderer(*context, scene, &sky_);
        const Image before = renderer.render(camera(), settings());
        const UploadCounts first = renderer.uploads();
        change(renderer, scene);
        const Image found = renderer.render(camera(), settings());
        UploadCounts after = renderer.uploads();
        Renderer fresh(*context, scene, &sky_);
        EXPECT_TRUE(equal_pictures(found, fresh.render(camera(), settings())));
        EXPECT_GT(largest_difference(found, before, 1e-2), 0.05) << "the edit shows nowhere";
        after.textures -= first.textures;
        after.meshes -= first.meshes;
        after.environments -= first.environments;
        after.cloths -= first.cloths;
        after.tables -= first.tables;
        return after;
    }

    Environment sky_ = sky_environment();
};

TEST_F(Edit, OfAColorUploadsNothing) {
    EXPECT_EQ(expect_as_new([](Renderer& renderer, Scene& scene) {
                  scene.materials[1].base_color = {0.9f, 0.3f, 0.1f, 1.0f};
                  renderer.update_material(1, scene.materials[1]);
              }),
              UploadCounts{});
}

TEST_F(Edit, OfAMethodAndALobeUploadsNothing) {
    EXPECT_EQ(expect_as_new([](Renderer& renderer, Scene& scene) {
                  scene.materials[0].method = Method::normal_map;
                  scene.materials[0].mdf = Mdf::beckmann;
                  renderer.update_material(0, scene.materials[0]);
              }),
              UploadCounts{});
}

// Blended surfaces cast no shadow: maps that were drawn for the scene before are drawn again.
TEST_F(Edit, OfCoverageUploadsNothingAndChangesTheShadows) {
    EXPECT_EQ(expect_as_new([](Renderer& renderer, Scene& scene) {
                  scene.materials[1].alpha_mode = AlphaMode::blend;
                  renderer.update_material(1, scene.materials[1]);
              }),
              UploadCounts{});
}

TEST_F(Edit, OfTheFilterOfANormalMapUploadsItsOtherForm) {
    EXPECT_EQ(expect_as_new([](Renderer& renderer, Scene& scene) {
                  scene.materials[0].normal_filter = NormalFilter::mips;
                  renderer.update_material(0, scene.materials[0]);
              }),
              UploadCounts{.textures = 1});
}

TEST_F(Edit, OfTheTexturesThatAMaterialUses) {
    EXPECT_EQ(expect_as_new([](Renderer& renderer, Scene& scene) {
                  scene.materials[1].base_color_texture.texture = 1;  // an existing texture
                  renderer.update_material(1, scene.materials[1]);
              }),
              UploadCounts{});
}

TEST_F(Edit, OfATextureUploadsItAlone) {
    EXPECT_EQ(expect_as_new([](Renderer& renderer, Scene& scene) {
                  scene.textures[1] = constant_texture({0.1f, 0.9f, 0.3f});
                  renderer.update_texture(1, scene.textures[1]);
              }),
              UploadCounts{.textures = 1});
}

TEST_F(Edit, AddsATextureAndAMaterialThatUsesIt) {
    EXPECT_EQ(expect_as_new([](Renderer& renderer, Scene& scene) {
                  scene.textures.push_back(bump_texture(16, 2, 0.5f));
                  EXPECT_EQ(renderer.add_texture(scene.textures.back()), 2);
                  Material m = scene.materials[0];
                  m.normal_texture.texture = 2;
                  scene.materials.push_back(m);
                  EXPECT_EQ(renderer.add_material(m), 3);
                  scene.instances[0].material = 3;
                  renderer.update_instance(0, scene.instances[0]);
              }),
              UploadCounts{.textures = 1});
}

TEST_F(Edit, OfAMeshUploadsItAlone) {
    EXPECT_EQ(expect_as_new([](Renderer& renderer, Scene& scene) {
                  scene.meshes[0] = uv_sphere(7, 5);
                  renderer.update_mesh(0, scene.meshes[0]);
              }),
              UploadCounts{.meshes = 1});
}

TEST_F(Edit, AddsAMeshAndAnInstance) {
    EXPECT_EQ(expect_as_new([](Renderer& renderer, Scene& scene) {
                  scene.meshes.push_back(uv_sphere(6, 4));
                  EXPECT_EQ(renderer.add_mesh(scene.meshes.back()), 2);
                  Instance instance = scene.instances[0];
                  instance.mesh = 2;
                  instance.transform[3].y = 0.6f;
                  scene.instances.push_back(instance);
                  EXPECT_EQ(renderer.add_instance(instance), 3);
              }),
              UploadCounts{.meshes = 1});
}

TEST_F(Edit, RemovesAnInstanceAndKeepsTheIdsOfOthers) {
    EXPECT_EQ(expect_as_new([](Renderer& renderer, Scene& scene) {
                  renderer.remove_instance(0);
                  scene.instances[2].transform[3].y = -0.3f;
                  renderer.update_instance(2, scene.instances[2]);
                  EXPECT_EQ(renderer.add_instance(scene.instances[2]), 3);  // not 0 again
                  renderer.remove_instance(3);
                  scene.instances.erase(scene.instances.begin());
              }),
              UploadCounts{});
}

TEST_F(Edit, OfLightsUploadsNothing) {
    EXPECT_EQ(expect_as_new([](Renderer& renderer, Scene& scene) {
                  Light lamp;
                  lamp.type = LightType::point;
                  lamp.position = {0.5f, 1.5f, 1.5f};
                  lamp.intensity = 4.0f;
                  scene.lights.push_back(lamp);
                  scene.lights[0].color = {0.2f, 1.0f, 0.2f};
                  renderer.set_lights(scene.lights);
              }),
              UploadCounts{});
}

TEST_F(Edit, OfTheEnvironmentUploadsItAlone) {
    EXPECT_EQ(expect_as_new([this](Renderer& renderer, Scene&) {
                  sky_ = constant_environment({0.5f, 0.2f, 0.1f});
                  renderer.set_environment(&sky_);
              }),
              UploadCounts{.environments = 1});
}

TEST_F(Edit, ToAPreparedEnvironmentDrawsWhatTheEnvironmentDraws) {
    EXPECT_EQ(expect_as_new([this](Renderer& renderer, Scene&) {
                  sky_ = constant_environment({0.1f, 0.6f, 0.2f});
                  std::shared_ptr<const PreparedEnvironment> prepared = prepare_environment(sky_);
                  renderer.set_environment(prepared);
                  renderer.set_environment(std::move(prepared));  // two renderers may share one
              }),
              UploadCounts{.environments = 2});
    Environment empty;
    EXPECT_THROW(prepare_environment(empty), Error);
}

TEST_F(Edit, TakesTheEnvironmentAway) {
    const Scene scene = busy_scene();
    Renderer renderer(*context, scene, &sky_);
    renderer.set_environment(nullptr);
    Renderer fresh(*context, scene, nullptr);
    EXPECT_TRUE(
        equal_pictures(renderer.render(camera(), settings()), fresh.render(camera(), settings())));
}

TEST_F(Edit, OfTheWholeSceneKeepsWhatIsEqual) {
    EXPECT_EQ(expect_as_new([](Renderer& renderer, Scene& scene) {
                  std::swap(scene.textures[0], scene.textures[1]);
                  std::swap(scene.meshes[0], scene.meshes[1]);
                  for (Instance& instance : scene.instances) instance.mesh = 1 - instance.mesh;
                  scene.materials[0].normal_texture.texture = 1;
                  scene.materials[2].base_color_texture.texture = 0;
                  scene.materials[1].base_color = {1, 1, 0, 1};
                  scene.lights.pop_back();
                  renderer.set_scene(scene);
              }),
              UploadCounts{});
}

TEST_F(Edit, OfAWeaveMakesItsMapsAndOfItsNumbersOfYarnsDoesNot) {
    const auto cloth = [](Scene& scene) {
        Material m;
        m.metallic = 0.0f;
        Cloth twill;
        twill.alpha = {0.5f, 0.2f};
        twill.draft = std::make_shared<Draft>(builtin_draft("twill-2-1"));
        twill.yarns = 20;
        m.lobe = twill;
        scene.materials[1] = m;
    };
    EXPECT_EQ(expect_as_new([&](Renderer& renderer, Scene& scene) {
                  cloth(scene);
                  renderer.update_material(1, scene.materials[1]);
                  std::get<Cloth>(scene.materials[1].lobe).yarns = 12;
                  renderer.update_material(1, scene.materials[1]);
              }),
              UploadCounts{.cloths = 1});
}

TEST_F(Edit, OfAMetalAndTheFilmOnItUploadsNothing) {
    const auto put = [](Renderer& renderer, Scene& scene, float nm) {
        Material& m = scene.materials[0];
        m.conductor = conductor_preset("titanium");
        if (nm > 0) m.conductor->oxide = oxide_film("titanium", nm);
        renderer.update_material(0, m);
    };
    for (const std::vector<float>& steps : {std::vector<float>{0, 50}, {50, 145}, {50, 0}})
        EXPECT_EQ(expect_as_new([&](Renderer& renderer, Scene& scene) {
                      for (const float nm : steps) put(renderer, scene, nm);
                  }),
                  UploadCounts{})
            << steps[0] << " " << steps[1];
}

TEST_F(Edit, OfTheGroundsCastersAndLightsMakesItsShadowAgain) {
    Scene scene = busy_scene();
    RenderSettings o = settings();
    o.ground = true;
    o.background = BackgroundKind::color;
    o.background_color = glm::vec3(0.8f);
    Renderer renderer(*context, scene, &sky_);
    Camera above = camera();
    above.position = {0.0f, 2.0f, 4.0f};
    const auto expect = [&](const char* what) {
        Renderer fresh(*context, scene, &sky_);
        EXPECT_TRUE(equal_pictures(renderer.render(above, o), fresh.render(above, o))) << what;
    };
    expect("at first");
    scene.instances[0].transform[3].y = 0.7f;
    renderer.update_instance(0, scene.instances[0]);
    expect("an instance");
    scene.lights[0] = directional({-0.5f, 1.0f, 0.3f});
    renderer.set_lights(scene.lights);
    expect("a light");
    scene.materials[2].alpha_mode = AlphaMode::blend;
    scene.materials[2].base_color.a = 0.5f;
    renderer.update_material(2, scene.materials[2]);
    expect("a blended material casts no shadow");
    sky_ = constant_environment({1, 1, 1});
    renderer.set_environment(&sky_);
    expect("the environment");
}

TEST_F(Edit, OfWhatIsNotThereIsRefusedInWordsAndChangesNothing) {
    Scene scene = busy_scene();
    Renderer renderer(*context, scene, &sky_);
    const Image before = renderer.render(camera(), settings());
    const auto refused = [&](const char* what, const std::function<void()>& edit) {
        EXPECT_THROW(edit(), Error) << what;
        EXPECT_TRUE(equal_pictures(renderer.render(camera(), settings()), before)) << what;
    };
    refused("a material", [&] { renderer.update_material(3, {}); });
    refused("a negative id", [&] { renderer.update_material(-1, {}); });
    refused("an instance", [&] { renderer.remove_instance(7); });
    refused("a mesh of an instance", [&] {
        Instance instance;
        instance.mesh = 2;
        renderer.add_instance(instance);
    });
    refused("a texture of a material", [&] {
        Material m = scene.materials[1];
        m.emissive_texture.texture = 2;
        renderer.update_material(1, m);
    });
    refused("lights", [&] { renderer.set_lights(std::vector<Light>(17)); });
    refused("a broken mesh", [&] {
        Mesh mesh = uv_sphere(5, 4);
        mesh.indices[2] = 1U << 30;
        renderer.update_mesh(0, mesh);
    });
    refused("a texture too large for the device", [&] {
        Texture wide = scene.textures[1];
        wide.width = context->max_texture_size() + 1;
        wide.height = 1;
        wide.texels.resize(static_cast<std::size_t>(wide.width) * 12);
        renderer.update_texture(1, wide);
    });
    refused("a scene with a broken part", [&] {
        Scene broken = busy_scene();
        broken.lights.clear();
        broken.materials[1].base_color = glm::vec4(0.0f);
        broken.textures[0].texels.pop_back();
        renderer.set_scene(broken);
    });
    refused("a scene with too many lights", [&] {
        Scene broken = busy_scene();
        broken.lights.resize(17);
        broken.meshes[0] = uv_sphere(5, 4);
        renderer.set_scene(broken);
    });
    refused("an environment", [&] {
        Environment broken;
        broken.radiance = Image(1, 1, 3, 1.0f);
        renderer.set_environment(&broken);
    });
}

// A normal map of x and y without z is read like one of three channels.
TEST_F(Edit, NormalMapsOfTwoChannelsAreReadAsThree) {
    Scene scene = busy_scene();
    scene.materials[0].normal_filter = NormalFilter::mips;
    const auto bytes = [](int channels) {
        Texture t;
        t.name = "bytes";
        t.width = t.height = 1;
        t.channels = channels;
        // n = (0.4, -0.2, z): 8-bit codes of (n + 1) / 2.
        const int codes[] = {179, 102, 241};
        for (int c = 0; c < channels; ++c) t.texels.push_back(static_cast<std::byte>(codes[c]));
        return t;
    };
    scene.textures[0] = bytes(3);
    Renderer three(*context, scene, &sky_);
    scene.textures[0] = bytes(2);
    Renderer two(*context, scene, &sky_);
    // The third channel is rounded to 1/127.
    EXPECT_TRUE(close_pictures(two.render(camera(), settings()), three.render(camera(), settings()),
                               0.1, 0.05));
}

TEST_F(Edit, RenderersOfOneContextShareTheirPrograms) {
    const Scene scene = busy_scene();
    Renderer first(*context, scene, &sky_);
    const Image wanted = first.render(camera(), settings());
    const std::size_t compiled = context->programs().size();
    Renderer second(*context, scene, &sky_);
    EXPECT_TRUE(equal_pictures(second.render(camera(), settings()), wanted));
    EXPECT_EQ(context->programs().size(), compiled);
    // Each renderer has its own uniforms and textures in the programs that they share.
    Scene other = scene;
    other.materials[0].lobe = AlphaLobe{{0.5f, 0.1f}};
    other.materials[1].base_color = {1, 0, 0, 1};
    other.lights[0].color = {0, 1, 0};
    second.set_scene(other);
    const Image changed = second.render(camera(), settings());
    EXPECT_GT(largest_difference(changed, wanted, 1e-2), 0.05);
    EXPECT_TRUE(equal_pictures(first.render(camera(), settings()), wanted));
    EXPECT_TRUE(equal_pictures(second.render(camera(), settings()), changed));
    EXPECT_EQ(context->programs().size(), compiled);
}

}  // namespace
}  // namespace burnish::test
