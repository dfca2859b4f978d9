// burnish export material: a material as maps and glTF (docs/guide/export.md).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "burnish/stage.hpp"

namespace burnish {

struct ExportMaterialRequest {
    // What `burnish render` would draw: a model or a scene, with parameters over its materials.
    StageRequest stage;
    std::string material;              // its name or index; "": all of them
    std::optional<int> width, height;  // texels; one alone makes texels square
    int bits = 16;
    std::optional<double> tile_mm;  // width of the tile, where nothing states it
    bool preview = true;
    bool extras = true;  // what glTF does not say, for burnish (gltf_material_text)
    int gl_device = -1;  // of the preview
    std::filesystem::path output;
    std::string command;
};

struct ExportMaterialReport {
    std::vector<std::string> warnings;
    std::vector<std::string> notes;
    std::vector<std::filesystem::path> written;
};

// Writes into `output`, or with several materials into a folder for each in it: material.json (what
// each map means), material.gltf and .bin (a quad), the maps, preview.png; each folder whole or not at
// all. Throws UsageError for a material that is not there, Error for what cannot be read or written.
ExportMaterialReport export_material(const ExportMaterialRequest& request,
                                     const Progress& progress);

}  // namespace burnish
