#include "viewer/window/warm_up.hpp"

#include <algorithm>

#include "burnish/error.hpp"

namespace burnish::viewer {
namespace {

// More materials take longer to prepare than changes of all of them are worth.
constexpr std::size_t kMostMaterials = 4;

// A texture of the same layout of texels: programs depend on it. 2 x 2, so that it has a mip.
Texture small_texture(const Texture& texture) {
    Texture small;
    small.name = texture.name;
    if (texture.empty()) return small;
    small.width = small.height = 2;
    small.channels = texture.channels;
    small.type = texture.type;
    small.color_space = texture.color_space;
    const auto texels =
        static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height);
    small.texels.resize(texture.texels.size() / texels * 4);
    return small;
}

Mesh triangle(bool colors) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.tangents.assign(3, {1, 0, 0, 1});
    mesh.texcoord0 = {{0, 0}, {1, 0}, {0, 1}};
    mesh.texcoord1 = mesh.texcoord0;
    if (colors) mesh.colors.assign(3, glm::vec4(1.0f));
    mesh.indices = {0, 1, 2};
    return mesh;
}

bool plain(const Material& material) {
    return cloth_of(material) == nullptr && tabulated_of(material) == nullptr;
}

}  // namespace

void WarmUp::follow(const Stage& stage, SurfacePass pass) {
    renderer_.reset();
    changes_.clear();
    next_ = 0;
    scene_ = {};
    for (const Material& material : stage.scene.materials)
        if (plain(material) &&
            std::ranges::find(scene_.materials, material) == scene_.materials.end())
            scene_.materials.push_back(material);
    if (scene_.materials.empty() || scene_.materials.size() > kMostMaterials) return;
    for (const Texture& texture : stage.scene.textures)
        scene_.textures.push_back(small_texture(texture));
    scene_.meshes = {triangle(std::ranges::any_of(
        stage.scene.meshes, [](const Mesh& mesh) { return !mesh.colors.empty(); }))};
    for (int i = 0; i < static_cast<int>(scene_.materials.size()); ++i) {
        Instance instance;
        instance.mesh = 0;
        instance.material = i;
        scene_.instances.push_back(instance);
    }
    scene_.lights = stage.scene.lights;
    light_ = {};
    if (!stage.environment.radiance.empty()) {
        light_.name = stage.environment.name;
        light_.radiance = Image(16, 8, 3);
        for (int y = 0; y < 8; ++y) std::fill_n(light_.radiance.at(0, y), 16 * 3, 1.0f);
    }
    settings_ = stage.settings;
    settings_.width = settings_.height = 4;
    settings_.samples = 1;
    settings_.ground = false;
    settings_.surface_pass = pass;
    const auto add = [this](std::size_t count, auto set) {
        for (std::size_t i = 0; i < count; ++i)
            changes_.push_back([set, i](Material& material) { set(material, i); });
    };
    add(method_names().size(),
        [](Material& m, std::size_t i) { m.method = static_cast<Method>(i); });
    add(mdf_names().size(), [](Material& m, std::size_t i) { m.mdf = static_cast<Mdf>(i); });
    add(brdf_names().size(), [](Material& m, std::size_t i) { m.brdf = static_cast<Brdf>(i); });
}

bool WarmUp::step() {
    if (done()) return false;
    try {
        if (!renderer_) renderer_ = std::make_unique<gpu::Renderer>(context_, scene_, &light_);
        std::vector<Material> materials = scene_.materials;
        for (Material& material : materials) changes_[next_](material);
        renderer_->set_materials(materials);
        Camera camera;
        camera.position = {0, 0, 3};
        renderer_->begin(camera, settings_);
        renderer_->add_sample();
    } catch (const Error&) {
        // A change that cannot be drawn is not prepared; the window says why when it is made.
    }
    ++next_;
    if (done()) renderer_.reset();
    return true;
}

}  // namespace burnish::viewer
