#include "viewer/prepare/warm_up.hpp"

#include <algorithm>

#include "burnish/error.hpp"
#include "viewer/generate/scratches.hpp"

namespace burnish::viewer {
namespace {

// More materials take longer to prepare than changes of all of them are worth.
constexpr std::size_t kMostMaterials = 4;
constexpr int kSide = 4;  // pixels of the picture

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

// Maps of the layout that coarse scratches have, without a scratch.
const ScratchTextures& no_scratches() {
    static const ScratchTextures maps = [] {
        ScratchChoice none = scratch_choice("brushed");
        none.amount = 0;
        none.recipe.settings.size = 16;
        return coarse_scratches(scratch_recipe(none));
    }();
    return maps;
}

// The material as coarse scratches draw it; their maps are the last two textures.
Material scratched(const Stage& stage, int material) {
    // The width of the tile says how often it repeats, which is no part of a program.
    constexpr double kTile_mm = 100;
    const std::vector<ScratchPreview> previews = scratch_previews(stage, material, kTile_mm);
    if (previews.empty()) return stage.scene.materials[static_cast<std::size_t>(material)];
    Material shown = previews.front().shown;
    const auto first = static_cast<int>(stage.scene.textures.size());
    shown.normal_texture.texture = first;
    if (previews.front().follows) shown.anisotropy_texture.texture = first + 1;
    return shown;
}

}  // namespace

void WarmUp::follow(const Stage& stage, SurfacePass pass) {
    renderer_.reset();
    looks_.clear();
    scratched_.clear();
    next_ = 0;
    scene_ = {};
    const auto materials = static_cast<int>(stage.scene.materials.size());
    for (int i = 0; i < materials; ++i) {
        const Material& material = stage.scene.materials[static_cast<std::size_t>(i)];
        if (!plain(material) ||
            std::ranges::find(scene_.materials, material) != scene_.materials.end())
            continue;
        scene_.materials.push_back(material);
        scratched_.push_back(scratched(stage, i));
        if (scene_.materials.size() > kMostMaterials) break;
    }
    if (scene_.materials.empty() || scene_.materials.size() > kMostMaterials) return;
    for (const Texture& texture : stage.scene.textures)
        scene_.textures.push_back(small_texture(texture));
    const ScratchTextures& scratches = no_scratches();
    scene_.textures.push_back(scratches.normal);
    scene_.textures.push_back(scratches.anisotropy);
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
    settings_.surface_pass = pass;
    looks_.push_back({{}, true, true});
    looks_.push_back({{}, true, false});
    const auto add = [this](std::size_t count, auto set) {
        for (std::size_t i = 0; i < count; ++i)
            looks_.push_back({[set, i](Material& material) { set(material, i); }});
    };
    add(method_names().size(),
        [](Material& m, std::size_t i) { m.method = static_cast<Method>(i); });
    add(mdf_names().size(), [](Material& m, std::size_t i) { m.mdf = static_cast<Mdf>(i); });
    add(brdf_names().size(), [](Material& m, std::size_t i) { m.brdf = static_cast<Brdf>(i); });
}

bool WarmUp::step(const RenderSettings& motion) {
    if (done()) return false;
    const Look& look = looks_[next_];
    try {
        if (!renderer_) {
            renderer_ = std::make_unique<gpu::Renderer>(context_, scene_, &light_);
            // Programs are those of vertices that know what they see.
            auto visibility = std::make_shared<Visibility>();
            visibility->instances.resize(scene_.instances.size());
            renderer_->set_visibility(visibility);
        }
        std::vector<Material> materials = look.scratched ? scratched_ : scene_.materials;
        if (look.change)
            for (Material& material : materials) look.change(material);
        renderer_->set_materials(materials);
        RenderSettings settings = look.moving ? motion : settings_;
        settings.width = settings.height = kSide;
        settings.samples = 1;
        settings.ground = false;
        Camera camera;
        camera.position = {0, 0, 3};
        renderer_->begin(camera, settings);
        renderer_->add_sample();
    } catch (const Error&) {
        // A change that cannot be drawn is not prepared; the window says why when it is made.
    }
    ++next_;
    if (done()) renderer_.reset();
    return true;
}

}  // namespace burnish::viewer
