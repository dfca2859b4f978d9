// Materials of a scene in three layers: as the models have them, what the scene file lays over
// them, what flags lay over both.
//
// Threads: one at a time for each object. Lifetime: an object knows the textures that it has
// appended to its scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/material_assets.hpp"
#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"
#include "burnish/scene_file.hpp"

namespace BURNISH_API burnish {

// What is to be said of parameters, one line each.
struct Remarks {
    std::vector<std::string> warnings;  // what will look different from what was asked for
    std::vector<std::string> notes;     // what was chosen, where the program had a choice
};

class LayeredMaterials {
  public:
    LayeredMaterials() = default;
    // `base`: the models' materials, one for each material of the scene that apply() is given.
    // `layers`: the scene file's, one a material, or none at all.
    explicit LayeredMaterials(std::vector<Material> base,
                              std::vector<SceneFile::Layer> layers = {});

    // Sets scene.materials to the base materials under the file's values and, over them, `flags`.
    // The result depends on nothing else: applying twice is applying once, and applying no flags
    // takes earlier ones back. Maps that values name are read once and appended to scene.textures,
    // from which nobody may erase. Tangents that are not a file's follow the coordinates that the
    // materials read normals with (fit_tangents). Throws UsageError for flags, Error for values of the
    // file that cannot be applied; scene.materials are then what they were.
    Remarks apply(Scene& scene, const ParameterValues& flags);
    // The same with one more layer: `upper` lies over `flags`, for single materials by index. Textures
    // and maps that failed to apply are not kept. Throws UsageError too for an index without a material.
    Remarks apply(Scene& scene, const ParameterValues& flags,
                  const std::map<int, ParameterValues>& upper);

    // From now on material number `index` has the base and the file's layer of number `other`. Throws
    // std::out_of_range.
    void put_in_place(std::size_t index, std::size_t other);

    // As MaterialAssets::put_scratch.
    void put_scratch(const std::string& name, ScratchTextures textures) {
        assets_.put_scratch(name, std::move(textures));
    }

    // After many edits: frees maps that no material has used for long (MaterialAssets::free_unused).
    // Their textures in the scene become empty, and later maps are assigned to their places.
    void free_unused(Scene& scene) { assets_.free_unused(scene.textures); }
    const std::map<int, std::uint64_t>& texture_changes() const {
        return assets_.texture_changes();
    }

    const std::vector<Material>& base() const { return base_; }
    // The scene file's layers, one a material.
    const std::vector<SceneFile::Layer>& layers() const { return layers_; }
    // All layers of each material in one, as the last apply() made them: as the only layer over the
    // base it gives the same material. Sizes in meters are not yet put into numbers of repeats.
    const std::vector<ParameterValues>& values() const { return values_; }

  private:
    ParameterValues values_of(std::size_t index, Scene& scene, const ParameterValues& flags,
                              const ParameterValues* upper);
    Remarks apply_layers(Scene& scene, const ParameterValues& flags,
                         const std::map<int, ParameterValues>& upper);
    std::vector<std::string> notes_of(const std::vector<ParameterValues>& values) const;

    std::vector<Material> base_;
    std::vector<SceneFile::Layer> layers_;
    std::vector<ParameterValues> values_;
    MaterialAssets assets_;
    std::vector<std::string> file_warnings_;  // of drafts and maps
};

// The values of a lower layer under those of an upper one, which wins. A normal map that the upper
// layer names is not scaled by the lower layer's uv_scale; a metal that it names is metallic; a
// weave that it names is not of the lower layer's metal. When the upper layer states half of a
// roughness pair, the other half is that of `lower_alpha`, the pair of the lower layer, unless the
// lower layer states the same half alone.
ParameterValues values_over(const ParameterValues& lower, const ParameterValues& upper,
                            const std::optional<glm::vec2>& lower_alpha);

// Appends lines to the scene's warnings and notes that it does not have yet.
void append_remarks(Remarks remarks, Scene& scene);

// Applies `values` to every material that the scene has now, once, and appends what is to be said to
// the scene's warnings and notes. To change them later, keep a LayeredMaterials.
void apply_material_parameters(Scene& scene, const ParameterValues& values);

}  // namespace burnish
