// What material parameters name: normal maps, scratch maps, weave drafts, measured materials.
//
// Threads: one at a time for each object. Lifetime: what it has loaded lives as long as it is
// used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"

namespace BURNISH_API burnish {

// The textures of a set of maps (the parameters maps, base_color_map and their like); -1: none.
struct MapTextures {
    int base_color = -1, metallic_roughness = -1, normal = -1, occlusion = -1, anisotropy = -1,
        emissive = -1;  // indices into the textures of the scene
    bool has_roughness = false, has_metallic = false, has_opacity = false;
    bool directx = false;  // the normal map has +y down
    bool whole = false;    // of a folder: metal that it does not show is not there
    double tile_mm = 0.0;  // width of the tile that a folder states; 0: it states none
    // Of a folder: each map, such as "base color", and its file.
    std::vector<std::pair<std::string, std::string>> files;
    std::vector<std::string> notes;     // of a folder: what was passed over for another map
    std::vector<std::string> warnings;  // what the picture will lack
};

// A scratch map as textures.
struct ScratchTextures {
    Texture normal;
    Texture anisotropy;    // direction of stretch, across the grooves, and strength; may be empty
    double tile_mm = 0.0;  // side of the tile; 0: unknown
};

// Loads each thing once, and keeps it, so that parameters can be applied any number of times. A
// thing is known by the text that names it.
class MaterialAssets {
  public:
    // Indices into the textures of the scene; -1: none.
    struct ScratchMaps {
        int normal = -1;
        int anisotropy = -1;
        double tile_mm = 0.0;  // side of the tile on the surface; 0: the folder does not say
    };

    // Loads what `values` name and is not here yet. Textures are appended to `textures`: the same
    // vector in every call, to which others may append, but from which nobody erases. Warnings of
    // all that `values` name, loaded now or before, are appended to `warnings`, each line once. Throws
    // UsageError for names that are neither built in nor
    // files, Error for files that cannot be read; what was loaded before stays.
    void load(const ParameterValues& values, std::vector<Texture>& textures,
              std::vector<std::string>& warnings);

    // The maps of a folder that another thread, say, has read: the next load() that would read this folder
    // takes them. Those of one folder are kept.
    void put_scratch(const std::string& name, ScratchTextures textures) {
        ready_ = {name, std::move(textures)};
    }

    // For a session of many edits. Things that no load() has named since begin_uses() are unused;
    // free_unused drops them, the one longest unused first, until kMostUnused are left whose textures
    // take kMostUnusedBytes together: a step back does not read a file again. Their textures become
    // empty, and load() assigns those places anew.
    static constexpr std::size_t kMostUnused = 16;
    static constexpr std::size_t kMostUnusedBytes = std::size_t{512} << 20;
    void begin_uses() { ++clock_; }
    void free_unused(std::vector<Texture>& textures);
    // How often the place of a texture was emptied or assigned anew, by its index; 0 where it is not
    // listed.
    const std::map<int, std::uint64_t>& texture_changes() const { return texture_changes_; }

    // What load() was given before. "none" names nothing: index -1 and null pointers.
    int normal_map(const std::string& name) const;
    ScratchMaps scratch(const std::string& name) const;
    std::shared_ptr<const Draft> draft(const std::string& name) const;
    MapTextures maps(const ParameterValues& values) const;
    std::shared_ptr<const TabulatedMaterial> tabulated(const std::string& name) const;

  private:
    // Something that a parameter names, as "normal_map bumps.png".
    struct Thing {
        std::vector<int> textures;
        std::vector<std::string> warnings;  // of its reader
        std::uint64_t used = 0;             // clock of the last load() that named it
    };

    Thing& use(const std::string& parameter, const std::string& name);
    int place(Thing& thing, std::vector<Texture>& textures, Texture texture);
    void forget(const std::string& parameter, const std::string& name);
    void load_scratch_maps(const std::string& name, bool follow, std::vector<Texture>& textures);

    std::map<std::string, int> normal_maps_;
    std::map<std::string, ScratchMaps> scratch_;
    std::pair<std::string, ScratchTextures> ready_;  // "": none
    std::map<std::string, MapTextures> maps_;        // by the texts that name them
    std::map<std::string, std::shared_ptr<const Draft>> drafts_;
    std::map<std::string, std::shared_ptr<const TabulatedMaterial>> tabulated_;
    std::map<std::pair<std::string, std::string>, Thing> things_;  // by parameter and name
    std::vector<int> free_places_;
    std::map<int, std::uint64_t> texture_changes_;
    std::uint64_t clock_ = 0;
};

// Whether `values` set `name` to something other than "none".
bool names_one(const ParameterValues& values, std::string_view name);

}  // namespace burnish
