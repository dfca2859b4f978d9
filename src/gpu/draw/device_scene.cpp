#include "gpu/draw/device_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "burnish/error.hpp"
#include "burnish/f32.hpp"
#include "burnish/shading_names.hpp"
#include "gpu/device/cloth_store.hpp"
#include "gpu/draw/material_state.hpp"

namespace burnish::gpu {

// Values derived from instances, meshes and lights.
struct DeviceScene::Placement {
    std::vector<DrawItem> items;
    Bounds bounds;
    ShadowMaps shadows;
    Ground ground;
};

DeviceScene::DeviceScene(const Context& context)
    : context_(context),
      textures_(context),
      bounds_(gpu::bounds_of(items_)),
      lights_(light_list_),
      area_lights_(light_list_),
      shadows_(light_list_, bounds_),
      ground_(bounds_, 0, nullptr) {}

std::size_t DeviceScene::checked(int id, std::size_t count, const char* what) const {
    if (id >= 0 && static_cast<std::size_t>(id) < count) return static_cast<std::size_t>(id);
    throw Error(name_, what, "a number below " + std::to_string(count), std::to_string(id));
}

MaterialSlot DeviceScene::make_slot(const Material& any, TextureStore::Slots& textures,
                                    const Progress& progress) {
    MaterialSlot slot;
    slot.material = drawn_material(any);
    const Material& material = slot.material;
    textures_.require(textures, material, progress);
    slot.version = new_uniform_version();
    slot.full = variant_of(material, textures, true);
    slot.flat = variant_of(material, textures, false);
    if (cloth_of(material) != nullptr) {
        progress.step("weaves", 0.0);
        const ClothStore::Means means = context_.cloths().require(cloth_lobe_of(material));
        for (const MaterialSlot& other : materials_)
            if (other.cloth && other.cloth->serves(material, means)) slot.cloth = other.cloth;
        if (!slot.cloth) {
            slot.cloth = std::make_shared<const ClothMaps>(material, means);
            ++uploads_.cloths;
        }
    }
    if (const Tabulated* tabulated = tabulated_of(material)) {
        for (const MaterialSlot& other : materials_)
            if (other.tabulated && other.tabulated->material() == tabulated->material)
                slot.tabulated = other.tabulated;
        if (!slot.tabulated) {
            progress.step("tables", 0.0);
            slot.tabulated = std::make_shared<TabulatedMaps>(tabulated->material);
            ++uploads_.tables;
        }
    }
    return slot;
}

MeshSlot DeviceScene::make_mesh(const Mesh& mesh) {
    MeshSlot slot;
    slot.bounds = burnish::bounds_of(mesh);
    const std::uint64_t content = content_of(mesh);
    for (const MeshSlot& other : meshes_)
        if (other.buffers->content() == content) slot.buffers = other.buffers;
    if (!slot.buffers) {
        slot.buffers = std::make_shared<MeshBuffers>(mesh);
        ++uploads_.meshes;
    }
    return slot;
}

std::size_t DeviceScene::triangles(bool coarse) const {
    std::size_t sum = 0;
    for (const DrawItem& item : items_) sum += mesh(item.mesh).triangles(coarse);
    return sum;
}

DeviceScene::Placement DeviceScene::placement(const Instances& instances,
                                              const std::vector<MeshSlot>& meshes,
                                              std::size_t materials) const {
    std::vector<Bounds> boxes;
    boxes.reserve(meshes.size());
    for (const MeshSlot& mesh : meshes) boxes.push_back(mesh.bounds);
    std::vector<DrawItem> items = draw_items(instances, boxes, materials, name_);
    const Bounds bounds = gpu::bounds_of(items);
    std::size_t triangles = 0;
    for (const DrawItem& item : items)
        triangles += meshes[static_cast<std::size_t>(item.mesh)].buffers->triangles(false);
    return {std::move(items), bounds, ShadowMaps(light_list_, bounds),
            Ground(bounds, triangles, environment_source_)};
}

void DeviceScene::place(Placement placement) noexcept {
    items_ = std::move(placement.items);
    bounds_ = placement.bounds;
    placement.shadows.take_device(shadows_);
    shadows_ = std::move(placement.shadows);
    ground_ = std::move(placement.ground);
}

void DeviceScene::set_instances(Instances instances) {
    place(placement(instances, meshes_, materials_.size()));
    // An instance with another mesh sees everything until it is told.
    for (std::size_t i = 0; i < visible_.size(); ++i)
        if (i >= instances.size() || !instances[i] || !instances_[i] ||
            instances[i]->mesh != instances_[i]->mesh)
            visible_[i] = nullptr;
    instances_ = std::move(instances);
}

void DeviceScene::set_scene(const Scene& scene, const Progress& progress) {
    TextureStore::Slots textures;
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        const Texture& texture = scene.textures[i];
        const TextureStore::Slots& before = textures_.slots();
        const auto same = [&](const TextureStore::Slot& s) {
            return same_texels(*s.source, texture);
        };
        auto found = i < before.size() && same(before[i])
                         ? before.begin() + static_cast<std::ptrdiff_t>(i)
                         : std::ranges::find_if(before, same);
        textures.push_back(found != before.end()
                               ? *found
                               : TextureStore::Slot{std::make_shared<const Texture>(texture), {}});
    }
    std::vector<MeshSlot> meshes;
    for (const Mesh& mesh : scene.meshes) {
        progress.step("meshes", static_cast<double>(meshes.size()) /
                                    static_cast<double>(scene.meshes.size()));
        meshes.push_back(make_mesh(mesh));
    }
    LightUniforms lights(scene.lights);
    AreaLightUniforms area_lights(scene.lights);
    std::vector<Light> light_list = scene.lights;
    Instances instances(scene.instances.begin(), scene.instances.end());
    std::string name = scene.name;
    std::swap(name, name_);
    std::swap(light_list, light_list_);
    try {
        Placement placed = placement(instances, meshes, scene.materials.size());
        std::vector<MaterialSlot> materials;
        for (const Material& m : scene.materials)
            materials.push_back(make_slot(m, textures, progress));
        place(std::move(placed));
        materials_ = std::move(materials);
        under_methods_.clear();
    } catch (...) {
        std::swap(name, name_);
        std::swap(light_list, light_list_);
        throw;
    }
    textures_.set_slots(std::move(textures));
    meshes_ = std::move(meshes);
    instances_ = std::move(instances);
    visible_.clear();
    lights_ = std::move(lights);
    area_lights_ = std::move(area_lights);
}

void DeviceScene::set_visibility(const Visibility* visibility) {
    std::vector<std::shared_ptr<const VisibleMesh>> fresh;
    if (visibility != nullptr) {
        if (visibility->instances.size() != instances_.size())
            throw Error(name_, "visibility",
                        "of " + std::to_string(instances_.size()) + " instances",
                        "of " + std::to_string(visibility->instances.size()));
        fresh.resize(instances_.size());
        for (std::size_t i = 0; i < fresh.size(); ++i) {
            const InstanceVisibility& own = visibility->instances[i];
            if (own.vertices.empty() || !instances_[i] || instances_[i]->mesh < 0) continue;
            const VisibleMesh* before = i < visible_.size() ? visible_[i].get() : nullptr;
            fresh[i] = std::make_shared<const VisibleMesh>(
                meshes_[static_cast<std::size_t>(instances_[i]->mesh)].buffers, own, before);
        }
    }
    visible_ = std::move(fresh);
}

void DeviceScene::draw(const DrawItem& item, bool coarse, bool visibility) const {
    const auto index = static_cast<std::size_t>(item.instance);
    if (visibility && index < visible_.size() && visible_[index])
        visible_[index]->draw(coarse);
    else
        mesh(item.mesh).draw(coarse);
}

void DeviceScene::set_environment(const std::shared_ptr<const PreparedEnvironment>& prepared) {
    std::unique_ptr<EnvironmentMaps> maps;
    std::shared_ptr<const Environment> source;
    if (prepared) {
        maps = std::make_unique<EnvironmentMaps>(context_, *prepared);
        source = {prepared, &prepared->environment};
        ++uploads_.environments;
    }
    ground_ = Ground(bounds_, triangles(), source);
    environment_source_ = std::move(source);
    environment_ = std::move(maps);
}

void DeviceScene::set_lights(std::span<const Light> lights) {
    LightUniforms uniforms(lights);
    AreaLightUniforms area_lights(lights);
    ShadowMaps shadows(lights, bounds_);
    light_list_.assign(lights.begin(), lights.end());
    shadows.take_device(shadows_);
    shadows_ = std::move(shadows);
    lights_ = std::move(uniforms);
    area_lights_ = std::move(area_lights);
    ground_.invalidate();
}

void DeviceScene::update_materials(std::span<const Material> materials, const Progress& progress) {
    if (materials.size() != materials_.size()) {
        throw Error("materials", "", std::to_string(materials_.size()),
                    std::to_string(materials.size()));
    }
    TextureStore::Slots textures = textures_.slots();
    std::vector<MaterialSlot> fresh;
    for (const Material& m : materials) fresh.push_back(make_slot(m, textures, progress));
    for (std::size_t i = 0; i < fresh.size(); ++i)
        if (fresh[i].blended() != materials_[i].blended()) ground_.invalidate();
    textures_.set_slots(std::move(textures));
    materials_ = std::move(fresh);
    under_methods_.clear();
}

void DeviceScene::update_material(int id, const Material& material, const Progress& progress) {
    MaterialSlot& slot = materials_[checked(id, materials_.size(), "material")];
    TextureStore::Slots textures = textures_.slots();
    MaterialSlot fresh = make_slot(material, textures, progress);
    if (fresh.blended() != slot.blended()) ground_.invalidate();
    textures_.set_slots(std::move(textures));
    slot = std::move(fresh);
    std::erase_if(under_methods_, [id](const auto& entry) { return entry.first.first == id; });
}

void DeviceScene::refine_cloths() {
    const auto coarse = [](const MaterialSlot& slot) {
        return slot.cloth && slot.cloth->is_coarse();
    };
    std::erase_if(under_methods_, [&](const auto& entry) { return coarse(entry.second); });
    TextureStore::Slots textures = textures_.slots();
    for (MaterialSlot& slot : materials_)
        if (coarse(slot)) slot = make_slot(slot.material, textures, {});
}

MaterialSlot& DeviceScene::material(int id, std::optional<Method> method) {
    MaterialSlot& own = material(id);
    if (!method || own.material.method == *method) return own;
    const std::pair key{id, *method};
    const auto found = under_methods_.find(key);
    if (found != under_methods_.end()) return found->second;
    Material material = own.material;
    material.method = *method;
    const Brdf brdf = drawn_material(material).brdf;
    if (!f32::brdf_takes_method(static_cast<int>(brdf), static_cast<int>(*method)))
        throw Error(name_, "method",
                    fmt::format("one that brdf {} takes, such as follow-grain", name_of(brdf)),
                    std::string(name_of(*method)));
    TextureStore::Slots textures = textures_.slots();
    MaterialSlot slot = make_slot(material, textures, {});
    textures_.set_slots(std::move(textures));
    return under_methods_.emplace(key, std::move(slot)).first->second;
}

int DeviceScene::add_material(const Material& material, const Progress& progress) {
    TextureStore::Slots textures = textures_.slots();
    materials_.push_back(make_slot(material, textures, progress));
    textures_.set_slots(std::move(textures));
    return static_cast<int>(materials_.size()) - 1;
}

int DeviceScene::add_texture(Texture texture) {
    TextureStore::Slots textures = textures_.slots();
    textures.push_back({std::make_shared<const Texture>(std::move(texture)), {}});
    textures_.set_slots(std::move(textures));
    return static_cast<int>(textures_.slots().size()) - 1;
}

void DeviceScene::update_texture(int id, Texture texture, const Progress& progress) {
    TextureStore::Slots textures = textures_.slots();
    textures[checked(id, textures.size(), "texture")] = {
        std::make_shared<const Texture>(std::move(texture)), {}};
    std::vector<std::pair<MaterialSlot*, MaterialSlot>> changed;
    for (MaterialSlot& slot : materials_)
        if (textures_.uses(slot.material, id))
            changed.emplace_back(&slot, make_slot(slot.material, textures, progress));
    textures_.set_slots(std::move(textures));
    for (auto& [slot, fresh] : changed) *slot = std::move(fresh);
    under_methods_.clear();
}

int DeviceScene::add_mesh(const Mesh& mesh) {
    meshes_.push_back(make_mesh(mesh));
    return static_cast<int>(meshes_.size()) - 1;
}

void DeviceScene::update_mesh(int id, const Mesh& mesh) {
    std::vector<MeshSlot> meshes = meshes_;
    meshes[checked(id, meshes.size(), "mesh")] = make_mesh(mesh);
    place(placement(instances_, meshes, materials_.size()));
    meshes_ = std::move(meshes);
    for (std::size_t i = 0; i < visible_.size(); ++i)
        if (instances_[i] && instances_[i]->mesh == id) visible_[i] = nullptr;
}

void DeviceScene::set_coarse_mesh(int id, std::span<const std::uint32_t> indices) {
    meshes_[checked(id, meshes_.size(), "mesh")].buffers->set_coarse(indices);
    shadows_.invalidate();
}

int DeviceScene::add_instance(const Instance& instance) {
    Instances instances = instances_;
    instances.emplace_back(instance);
    set_instances(std::move(instances));
    return static_cast<int>(instances_.size()) - 1;
}

void DeviceScene::update_instance(int id, const Instance& instance) {
    Instances instances = instances_;
    instances[checked(id, instances.size(), "instance")] = instance;
    set_instances(std::move(instances));
}

void DeviceScene::remove_instance(int id) {
    Instances instances = instances_;
    instances[checked(id, instances.size(), "instance")].reset();
    set_instances(std::move(instances));
}

bool DeviceScene::any_tabulated() const {
    return std::ranges::any_of(materials_,
                               [](const MaterialSlot& slot) { return slot.tabulated != nullptr; });
}

UploadCounts DeviceScene::uploads() const {
    UploadCounts counts = uploads_;
    counts.textures = textures_.uploads();
    return counts;
}

}  // namespace burnish::gpu
