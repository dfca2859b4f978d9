// MTL material libraries.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "burnish/scene.hpp"

namespace burnish {

// Materials of an OBJ file with their textures and indices by name.
struct ObjMaterials {
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<std::string> failures;  // one a texture: why it could not be read; empty: it was
    std::map<std::string, int> by_name;
    std::vector<std::string> warnings;
};

// Reads the libraries, which lie in `folder` or below. Missing or unreadable libraries and missing
// textures are skipped with a warning, because the model is worth showing without them; for
// unreadable textures see leave_out_textures.
ObjMaterials read_obj_materials(const std::filesystem::path& folder,
                                const std::vector<std::string>& libraries);

// For faces without a material: gray plastic.
Material default_obj_material();

}  // namespace burnish
