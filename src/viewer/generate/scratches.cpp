#include "viewer/generate/scratches.hpp"

#include <algorithm>
#include <chrono>

#include "burnish/error.hpp"
#include "core/files.hpp"
#include "maps/scratch/scratch_coarse.hpp"
#include "scene/geometry/texture_scale.hpp"

namespace burnish::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDescription = "scratch.json";  // written last

bool is_there(const fs::path& folder) {
    std::error_code error;
    return fs::exists(folder / kDescription, error) && fs::exists(folder / "normal.png", error) &&
           fs::exists(folder / "anisotropy.png", error);
}

struct Cached {
    fs::path folder;
    fs::file_time_type used;
    std::uintmax_t bytes = 0;
};

std::vector<Cached> cached_folders(const fs::path& cache) {
    std::vector<Cached> all;
    std::error_code error;
    for (fs::directory_iterator entry(cache, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code unreadable;
        if (!entry->is_directory(unreadable)) continue;
        Cached one{entry->path(), entry->last_write_time(unreadable)};
        const auto described = fs::last_write_time(one.folder / kDescription, unreadable);
        if (!unreadable) one.used = described;
        for (fs::directory_iterator file(one.folder, unreadable); !unreadable && file != end;
             file.increment(unreadable)) {
            std::error_code unknown;
            const std::uintmax_t bytes = file->file_size(unknown);
            if (!unknown) one.bytes += bytes;
        }
        all.push_back(std::move(one));
    }
    std::ranges::sort(all, std::ranges::greater{}, &Cached::used);
    return all;
}

// How often a tile of this width repeats across the texture square of the material: as
// apply_physical_size finds it.
double repeats_of(const Stage& stage, int material, const ParameterValues& values, double tile_mm,
                  double otherwise) {
    const auto index = static_cast<std::size_t>(material);
    const LayeredMaterials& materials = stage.materials;
    // values() has no sizes put into repeats, so that a uv_scale in it was set by a person.
    if (values.is_set("uv_scale")) return values.real("uv_scale");
    if (!values.boolean("physical_size") || index >= materials.base().size()) return otherwise;
    const std::optional<TextureSquare> square = texture_square(stage.scene, material);
    if (!square) return otherwise;
    const Parameter& range = *find_parameter("uv_scale");
    return std::clamp(square->side * 1000.0 / tile_mm, range.low, range.high);
}

}  // namespace

ScratchChoice scratch_choice(const std::string& base) {
    ScratchChoice choice;
    choice.base = base;
    std::error_code error;
    if (fs::is_directory(base, error)) {
        choice.recipe = load_scratch_recipe(base);
    } else {
        choice.recipe.settings = scratch_preset(base, "scratches");
    }
    return choice;
}

ScratchRecipe scratch_recipe(const ScratchChoice& choice) {
    ScratchRecipe recipe = choice.recipe;
    recipe.settings = scaled_scratches(std::move(recipe.settings), choice.amount, choice.strength);
    return recipe;
}

void set_typical(Spread& spread, double value) {
    const double now = spread.typical();
    spread = now > 0.0 ? spread.times(value / now) : constant_spread(value);
}

ScratchTextures coarse_scratches(const ScratchRecipe& recipe) {
    const ScratchSettings& settings = recipe.settings;
    check_scratch_settings(settings, "scratches");
    const ScratchMaps maps =
        engrave_coarse(settings, read_scratch_inputs(recipe), coarse_scratch_size(settings));
    ScratchTextures textures = scratch_textures(maps, settings.layers.front());
    textures.normal.name = "scratches: normal";
    textures.anisotropy.name = "scratches: anisotropy";
    return textures;
}

fs::path scratch_folder(const fs::path& cache, const ScratchRecipe& recipe) {
    return cache / scratch_recipe_key(recipe);
}

fs::path make_cached_scratches(const fs::path& cache, const ScratchRecipe& recipe,
                               const Progress& progress) {
    const fs::path folder = scratch_folder(cache, recipe);
    std::error_code error;
    if (is_there(folder)) {
        fs::last_write_time(folder / kDescription, fs::file_time_type::clock::now(), error);
        return folder;
    }
    fs::create_directories(cache, error);
    if (error)
        throw Error(cache.string(), "", "a folder for scratch maps that can be written",
                    reason_of(error.value()));
    ScratchRequest request;
    request.recipe = recipe;
    request.drawn_only = true;
    request.output = folder;
    request.command = "burnish view";
    make_scratch_maps(request, progress);
    return folder;
}

void prune_scratch_cache(const fs::path& cache, std::uintmax_t most_bytes) {
    const auto now = fs::file_time_type::clock::now();
    std::uintmax_t bytes = 0;
    for (const Cached& one : cached_folders(cache)) {
        bytes += one.bytes;
        if (bytes <= most_bytes || now - one.used < std::chrono::hours(24)) continue;
        std::error_code error;
        fs::remove_all(one.folder, error);
    }
}

std::string scratches_of(const Stage& stage, int material) {
    const auto index = static_cast<std::size_t>(material);
    if (material < 0 || index >= stage.materials.values().size()) return "";
    const ParameterValues& values = stage.materials.values()[index];
    return names_one(values, "scratch") ? values.text("scratch") : "";
}

std::vector<ScratchPreview> scratch_previews(const Stage& stage, std::optional<int> material,
                                             double tile_mm) {
    std::vector<ScratchPreview> previews;
    const std::vector<Material>& materials = stage.scene.materials;
    for (int i = 0; i < static_cast<int>(materials.size()); ++i) {
        const auto index = static_cast<std::size_t>(i);
        if (material && *material != i) continue;
        if (cloth_of(materials[index]) || tabulated_of(materials[index])) continue;
        if (index >= stage.materials.values().size()) continue;
        const ParameterValues& values = stage.materials.values()[index];
        ScratchPreview preview{i, materials[index]};
        Material& shown = preview.shown;
        if (!values.is_set("scratch")) {
            shown.normal_texture = TextureUse{};
            shown.normal_scale = values.is_set("normal_scale")
                                     ? static_cast<float>(values.real("normal_scale"))
                                     : 1.0f;
            shown.flip_green = values.is_set("flip_green") && values.boolean("flip_green");
        }
        preview.follows = values.is_set("scratch") &&
                          static_cast<ScratchDirection>(values.choice("scratch_direction")) ==
                              ScratchDirection::follow;
        const auto s = static_cast<float>(repeats_of(
            stage, i, values, tile_mm, static_cast<double>(shown.normal_texture.transform[0][0])));
        shown.normal_texture.transform = glm::mat3(s, 0, 0, 0, s, 0, 0, 0, 1);
        if (preview.follows) shown.anisotropy_texture.transform = shown.normal_texture.transform;
        previews.push_back(std::move(preview));
    }
    return previews;
}

}  // namespace burnish::viewer
