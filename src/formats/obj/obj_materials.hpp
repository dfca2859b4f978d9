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
    std::map<std::string, int> by_name;
    std::vector<std::string> warnings;
};

// Reads the libraries of a model, and their pictures, which lie in its folder or below; the names
// that files give them may be those of another machine (core/find_file.hpp). Missing or unreadable
// files are skipped with a warning, because the model is worth showing without them.
//
// map_Bump and bump are normal maps where the picture looks like one. map_Pr and map_Pm become one
// texture, map_Kd and map_d another. A key that is not read is named in a warning.
ObjMaterials read_obj_materials(const std::filesystem::path& model,
                                const std::vector<std::string>& libraries);

// For faces without a material: gray plastic.
Material default_obj_material();

}  // namespace burnish
