// Wavefront OBJ: lines -> tinyobjloader -> one mesh a material.
#include "formats/obj/obj.hpp"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <sstream>

#include "burnish/error.hpp"
#include "burnish/fit_tangents.hpp"
#include "core/files.hpp"
#include "core/utf8.hpp"
#include "formats/far_model.hpp"
#include "formats/model_limits.hpp"
#include "formats/model_textures.hpp"
#include "formats/obj/obj_materials.hpp"
#include "formats/obj/obj_text.hpp"
#include "scene/geometry/polygon.hpp"
#include "scene/geometry/tangents.hpp"
#include "scene/geometry/weld.hpp"

namespace burnish {
namespace {

using tinyobj::index_t;

// A corner of the triangles of one material; three consecutive corners form a triangle.
struct Corner {
    index_t index;
    std::uint32_t smoothing;  // corners at one position and of equal smoothing share a normal
};
using Corners = std::vector<Corner>;

struct ParsedObj {
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
};

// Tells the parser that the material named "7" has index 7.
class NumberedMaterials : public tinyobj::MaterialReader {
  public:
    explicit NumberedMaterials(std::size_t count) : count_(count) {}
    bool operator()(const std::string&, std::vector<tinyobj::material_t>*,
                    std::map<std::string, int>* numbers, std::string*, std::string*) override {
        for (std::size_t i = 0; i < count_; ++i)
            numbers->emplace(std::to_string(i), static_cast<int>(i));
        return true;
    }

  private:
    std::size_t count_;
};

ParsedObj parse(const ObjText& text, const std::string& file) {
    ParsedObj parsed;
    NumberedMaterials numbered(text.materials.size());
    std::vector<tinyobj::material_t> no_materials;
    std::string warnings;  // repeats checks made below
    std::string errors;
    std::istringstream stream("mtllib numbers\n" + text.geometry);
    const bool good = tinyobj::LoadObj(&parsed.attributes, &parsed.shapes, &no_materials, &warnings,
                                       &errors, &stream, &numbered,
                                       /*triangulate=*/false, /*default_vcols_fallback=*/false);
    if (!good || !errors.empty())
        throw Error(file, "", "an OBJ model", shown(errors.substr(0, errors.find('\n'))));
    return parsed;
}

// Normals and texture coordinates that the file does not have become -1. Positions have been checked
// (ObjNumbers).
void check_index(index_t& index, const tinyobj::attrib_t& attributes) {
    const auto inside = [](int i, std::size_t count) {
        return i >= 0 && static_cast<std::size_t>(i) < count;
    };
    if (!inside(index.normal_index, attributes.normals.size() / 3)) index.normal_index = -1;
    if (!inside(index.texcoord_index, attributes.texcoords.size() / 2)) index.texcoord_index = -1;
}

glm::vec3 position_of(const tinyobj::attrib_t& attributes, index_t index) {
    const auto at = 3 * static_cast<std::size_t>(index.vertex_index);
    const std::vector<double>& x = attributes.vertices;
    return glm::vec3(glm::dvec3(x[at], x[at + 1], x[at + 2]));
}

// Subtracts the center of the vertices that faces use from a model far from the origin.
void center_far_positions(tinyobj::attrib_t& attributes,
                          const std::vector<tinyobj::shape_t>& shapes,
                          std::vector<std::string>& warnings) {
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    std::vector<double>& x = attributes.vertices;
    for (const tinyobj::shape_t& shape : shapes)
        for (const index_t& index : shape.mesh.indices) {
            if (index.vertex_index < 0) continue;
            const auto at = 3 * static_cast<std::size_t>(index.vertex_index);
            if (at + 2 >= x.size()) continue;
            const glm::dvec3 p(x[at], x[at + 1], x[at + 2]);
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    const std::optional<glm::dvec3> center = center_of_far_model(low, high);
    if (!center) return;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] -= (*center)[static_cast<int>(i % 3)];
    warnings.push_back(far_model_warning(*center, "its positions"));
}

// Collects the triangles of each material.
class Triangulator {
  public:
    Triangulator(ParsedObj& parsed, const ObjText& text)
        : attributes_(parsed.attributes), text_(text), by_material_(text.materials.size() + 1) {
        for (tinyobj::shape_t& shape : parsed.shapes) take_shape(shape.mesh);
    }

    // The last entry holds the triangles without a material.
    std::vector<Corners>& by_material() { return by_material_; }

  private:
    void take_shape(tinyobj::mesh_t& mesh) {
        std::size_t begin = 0;
        for (std::size_t f = 0; f < mesh.num_face_vertices.size(); ++f) {
            const std::size_t count = mesh.num_face_vertices[f];
            const auto material = static_cast<std::size_t>(mesh.material_ids[f]);
            Corners& corners = by_material_[std::min(material, by_material_.size() - 1)];
            take_face(&mesh.indices[begin], count, smoothing(mesh.smoothing_group_ids[f]), corners);
            begin += count;
        }
    }

    // The lowest bit separates faces without a group (flat) from groups. A file without any group
    // is smooth everywhere.
    std::uint32_t smoothing(std::uint32_t group) {
        if (!text_.has_smoothing) return 1;
        return group == 0 ? (flat_faces_ += 2) : (group << 1) | 1u;
    }

    void take_face(index_t* indices, std::size_t count, std::uint32_t smoothing, Corners& out) {
        outline_.clear();
        triangles_.clear();
        for (std::size_t i = 0; i < count; ++i) {
            check_index(indices[i], attributes_);
            outline_.push_back(position_of(attributes_, indices[i]));
        }
        triangulate(outline_, triangles_);
        for (const auto& triangle : triangles_) {
            const int a = indices[triangle[0]].vertex_index;
            const int b = indices[triangle[1]].vertex_index;
            const int c = indices[triangle[2]].vertex_index;
            if (a == b || b == c || c == a) continue;
            for (const std::uint32_t corner : triangle) out.push_back({indices[corner], smoothing});
        }
    }

    const tinyobj::attrib_t& attributes_;
    const ObjText& text_;
    std::vector<Corners> by_material_;
    std::uint32_t flat_faces_ = 0;
    std::vector<glm::vec3> outline_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
};

glm::vec3 normal_of(const tinyobj::attrib_t& attributes, index_t index) {
    if (index.normal_index < 0) return glm::vec3(0.0f);  // computed later
    const auto at = 3 * static_cast<std::size_t>(index.normal_index);
    const std::vector<double>& x = attributes.normals;
    return glm::vec3(glm::dvec3(x[at], x[at + 1], x[at + 2]));
}

// v runs upwards in OBJ, downwards in Mesh.
glm::vec2 texcoord_of(const tinyobj::attrib_t& attributes, index_t index) {
    if (index.texcoord_index < 0) return glm::vec2(0.0f);
    const auto at = 2 * static_cast<std::size_t>(index.texcoord_index);
    const auto sound = [](double x) {
        return std::abs(x) <= static_cast<double>(kLargestTexcoord) ? static_cast<float>(x) : 0.0f;
    };
    return {sound(attributes.texcoords[at]), 1.0f - sound(attributes.texcoords[at + 1])};
}

// Computes the normals missing in the file: corners at one position and of one smoothing group
// share one.
void make_missing_normals(const Corners& corners, const std::vector<std::uint32_t>& vertex_of,
                          Mesh& mesh) {
    const bool missing = std::any_of(corners.begin(), corners.end(), [](const Corner& corner) {
        return corner.index.normal_index < 0;
    });
    if (!missing) return;
    const Welding groups = weld<2>(corners.size(), [&](std::size_t i, std::uint32_t* words) {
        words[0] = static_cast<std::uint32_t>(corners[i].index.vertex_index);
        words[1] = corners[i].smoothing;
    });
    std::vector<glm::dvec3> sums(groups.classes, glm::dvec3(0.0));
    for (std::size_t c = 0; c < corners.size(); ++c) sums[groups.ids[c]] += corner_normal(mesh, c);
    for (std::size_t c = 0; c < corners.size(); ++c) {
        if (corners[c].index.normal_index >= 0) continue;
        const glm::dvec3 sum = sums[groups.ids[c]];
        const double length = glm::length(sum);
        if (length > 0.0) mesh.normals[vertex_of[c]] = glm::vec3(sum / length);
    }
}

Mesh build_mesh(const Corners& corners, const tinyobj::attrib_t& attributes) {
    // Corners with equal indices and smoothing are one vertex.
    const Welding vertices = weld<4>(corners.size(), [&](std::size_t i, std::uint32_t* words) {
        const Corner& corner = corners[i];
        words[0] = static_cast<std::uint32_t>(corner.index.vertex_index);
        words[1] = static_cast<std::uint32_t>(corner.index.texcoord_index);
        words[2] = static_cast<std::uint32_t>(corner.index.normal_index);
        words[3] = corner.index.normal_index < 0 ? corner.smoothing : 0;
    });
    const bool has_texcoords = std::any_of(corners.begin(), corners.end(), [](const Corner& c) {
        return c.index.texcoord_index >= 0;
    });
    Mesh mesh;
    mesh.indices = vertices.ids;
    mesh.positions.resize(vertices.classes);
    mesh.normals.resize(vertices.classes);
    if (has_texcoords) mesh.texcoord0.resize(vertices.classes);
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const std::uint32_t vertex = vertices.ids[c];
        mesh.positions[vertex] = position_of(attributes, corners[c].index);
        mesh.normals[vertex] = normal_of(attributes, corners[c].index);
        if (has_texcoords) mesh.texcoord0[vertex] = texcoord_of(attributes, corners[c].index);
    }
    make_missing_normals(corners, vertices.ids, mesh);
    return mesh;
}

void drop_textures(Material& material) {
    material.base_color_texture = TextureUse();
    material.emissive_texture = TextureUse();
    material.normal_texture = TextureUse();
    material.metallic_roughness_texture = TextureUse();
}

bool has_textures(const Material& material) {
    return material.base_color_texture || material.emissive_texture || material.normal_texture ||
           material.metallic_roughness_texture;
}

// Adds one mesh with its material.
void add_part(Mesh mesh, const Material& material, Scene& scene) {
    mesh.name = material.name;
    const std::string name = one_line(mesh.name);  // a line of OBJ may contain carriage returns
    const std::size_t mended = repair_frames(mesh);
    if (mended > 0)
        scene.warnings.push_back(
            fmt::format("{}: {} vertices had broken normals; replaced", name, mended));
    scene.materials.push_back(material);
    if (mesh.texcoord0.empty() && has_textures(material)) {
        drop_textures(scene.materials.back());
        scene.warnings.push_back(
            fmt::format("{}: no texture coordinates: its textures are not used", name));
    }
    mesh.tangent_source.emplace();
    scene.meshes.push_back(std::move(mesh));
    const auto last = static_cast<int>(scene.meshes.size()) - 1;
    scene.instances.push_back({last, last, glm::mat4(1.0f)});
}

}  // namespace

Scene load_obj(const std::filesystem::path& path) {
    const std::string file = path.string();
    const ObjText text = sort_obj_lines(as_utf8(read_text_file(path)), file);
    ParsedObj parsed = parse(text, file);
    Scene scene;
    scene.warnings = text.warnings;
    center_far_positions(parsed.attributes, parsed.shapes, scene.warnings);
    Triangulator triangulator(parsed, text);

    ObjMaterials library = read_obj_materials(path, text.libraries);
    scene.name = path.stem().string();
    scene.warnings.insert(scene.warnings.end(), library.warnings.begin(), library.warnings.end());
    scene.textures = std::move(library.textures);
    const auto& by_material = triangulator.by_material();
    for (std::size_t i = 0; i < by_material.size(); ++i) {
        if (by_material[i].empty()) continue;
        Material material = default_obj_material();
        if (i < text.materials.size()) {
            const auto found = library.by_name.find(text.materials[i]);
            material.name = text.materials[i];
            if (found != library.by_name.end())
                material = library.materials[static_cast<std::size_t>(found->second)];
            else
                scene.warnings.push_back(fmt::format(
                    "usemtl {}: no such material: default material", shown(text.materials[i])));
        }
        add_part(build_mesh(by_material[i], parsed.attributes), material, scene);
    }
    for (const auto& lines : {complete_normal_maps(scene), fit_tangents(scene)})
        scene.warnings.insert(scene.warnings.end(), lines.begin(), lines.end());
    if (scene.meshes.empty()) scene.warnings.emplace_back("nothing to draw: there are no faces");
    return scene;
}

}  // namespace burnish
