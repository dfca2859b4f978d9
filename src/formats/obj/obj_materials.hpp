// MTL material libraries.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "burnish/scene.hpp"

namespace burnish {

// Materials of an OBJ file with what they need to be put into a scene.
struct ObjMaterials {
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::map<std::string, int> by_name;
    std::vector<std::string> warnings;
};

// Reads the libraries, which lie in `folder` or below. What cannot be found or read becomes a
// warning and is left out: an OBJ file is worth looking at without.
ObjMaterials read_obj_materials(const std::filesystem::path& folder,
                                const std::vector<std::string>& libraries);

// For faces without a material: grey plastic.
Material default_obj_material();

}  // namespace burnish
