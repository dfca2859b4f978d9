// Converts mesh primitives of a glTF file to meshes of the scene.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "burnish/scene.hpp"
#include "formats/gltf/gltf_accessors.hpp"
#include "formats/gltf/gltf_draco.hpp"

namespace tinygltf {
class Model;
struct Primitive;
}  // namespace tinygltf

namespace burnish {

// Indices of a mesh and a material of the scene.
struct GltfPart {
    int mesh = 0;
    int material = 0;
};

class GltfMeshes {
  public:
    // `scene` already holds the file's materials, which read the texture coordinates of `sets`.
    // Meshes are added to it, and copies of materials for meshes that lack a set of texture
    // coordinates.
    GltfMeshes(const GltfDocument& document, GltfBuffers& buffers, GltfAccessors& accessors,
               std::vector<std::array<int, 2>> sets, GltfReport& report, Scene& scene);

    // The triangles of one mesh of the file, read at the first use. Primitives with the same data
    // and the same frame of tangents share a mesh. Points, lines and primitives without positions are skipped with a warning.
    // Throws Error for broken geometry.
    const std::vector<GltfPart>& parts(int mesh, std::string_view user);

    // Gives every mesh valid normals and tangents; call once, when all instances are placed.
    void finish();

  private:
    // A primitive of the file, and what belongs to it.
    struct Source {
        const tinygltf::Primitive& primitive;
        const GltfDraco* draco;   // null: not compressed
        std::array<int, 2> sets;  // TEXCOORD_n of texcoord0 and texcoord1
        std::string name;         // of the mesh
        std::string key;
    };

    void read_part(Source source, std::vector<GltfPart>& parts);
    int read_mesh(const Source& source);
    std::optional<DracoMesh> decompress(const Source& source, std::size_t vertices);
    bool can_draw(const tinygltf::Primitive& primitive, const std::string& key);
    int resolve_material(int material, const Mesh& mesh, const Source& source);
    int default_material();

    const tinygltf::Model& model_;
    const GltfDocument& document_;
    GltfBuffers& buffers_;
    GltfAccessors& accessors_;
    std::vector<std::array<int, 2>> sets_;  // one a material of the file
    GltfReport& report_;
    Scene& scene_;
    std::set<int> paid_for_;  // buffer views of Draco data that have earned credit
    std::vector<std::vector<GltfPart>> parts_;
    std::vector<char> has_parts_;
    std::map<std::string, int> known_meshes_;               // by fingerprint
    std::map<std::pair<int, int>, int> reduced_materials_;  // (material, missing sets) -> copy
    int default_material_ = -1;
};

}  // namespace burnish
