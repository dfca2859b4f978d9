#include "formats/gltf/gltf_meshes.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "burnish/error.hpp"
#include "burnish/fit_tangents.hpp"
#include "core/parallel.hpp"
#include "formats/gltf/gltf_materials.hpp"
#include "formats/gltf/gltf_triangles.hpp"
#include "formats/model_limits.hpp"
#include "formats/model_textures.hpp"
#include "scene/geometry/tangents.hpp"
#include "scene/material/texture_uses.hpp"

namespace burnish {
namespace {

int attribute(const tinygltf::Primitive& primitive, const std::string& name) {
    const auto it = primitive.attributes.find(name);
    return it == primitive.attributes.end() ? -1 : it->second;
}

// Tangents mean nothing without the normals that they are perpendicular to.
bool has_tangents(const tinygltf::Primitive& primitive) {
    return attribute(primitive, "TANGENT") >= 0 && attribute(primitive, "NORMAL") >= 0;
}

// A text that is equal for primitives with the same mesh data. `source` counts only where tangents
// are made.
std::string fingerprint(const tinygltf::Primitive& primitive, const GltfDraco* draco,
                        std::array<int, 2> sets, const TangentSource& source) {
    std::string text = fmt::format("{} {} {} {} {}", primitive.mode,
                                   draco == nullptr ? primitive.indices : draco->indices, sets[0],
                                   sets[1], draco == nullptr ? -1 : draco->buffer_view);
    if (!has_tangents(primitive))
        text += fmt::format(" {} {} {} {}", source.texcoord, source.along.x, source.along.y,
                            source.mirrored);
    for (const auto& [name, accessor] : primitive.attributes)
        text += fmt::format(" {} {}", name, accessor);
    return text;
}

void check_positions(const std::vector<glm::vec3>& positions, const std::string& key,
                     const GltfReport& report) {
    const auto in_reach = [](float x) {
        return std::abs(x) <= static_cast<float>(kFarthest);  // false for NaN
    };
    for (const glm::vec3& p : positions) {
        if (in_reach(p.x) && in_reach(p.y) && in_reach(p.z)) continue;
        report.fail(key + ".attributes.POSITION",
                    fmt::format("finite numbers up to {:g}", kFarthest),
                    fmt::format("({}, {}, {})", p.x, p.y, p.z));
    }
}

// Replaces coordinates and colors that are not finite or out of range by 0; returns whether there
// were any.
template <class Vec>
bool clean(std::vector<Vec>& items, float low, float high) {
    bool found = false;
    for (Vec& item : items) {
        for (int c = 0; c < Vec::length(); ++c) {
            if (item[c] >= low && item[c] <= high) continue;
            item[c] = 0.0f;
            found = true;
        }
    }
    return found;
}

// Reads the vertices first .. first + count of one primitive into a mesh.
class VertexReader {
  public:
    VertexReader(const tinygltf::Primitive& primitive, std::array<int, 2> sets,
                 GltfAccessors& accessors, GltfReport& report, const std::string& key,
                 std::size_t first, std::size_t count)
        : primitive_(primitive),
          sets_(sets),
          accessors_(accessors),
          report_(report),
          key_(key),
          first_(first),
          count_(count) {}

    void read(Mesh& mesh) {
        mesh.positions = accessors_.vec3s(checked("POSITION"), first_, count_, user("POSITION"));
        check_positions(mesh.positions, key_, report_);
        if (has("NORMAL"))
            mesh.normals = accessors_.vec3s(checked("NORMAL"), first_, count_, user("NORMAL"));
        if (has_tangents(primitive_))
            mesh.tangents = accessors_.vec4s(checked("TANGENT"), first_, count_, user("TANGENT"));
        read_texcoords(fmt::format("TEXCOORD_{}", sets_[0]), mesh.texcoord0);
        read_texcoords(fmt::format("TEXCOORD_{}", sets_[1]), mesh.texcoord1);
        if (!has("COLOR_0")) return;
        mesh.colors = accessors_.colors(checked("COLOR_0"), first_, count_, user("COLOR_0"));
        // Half floats end at 65504; a vertex color scales a reflectance.
        if (clean(mesh.colors, 0.0f, 65504.0f))
            report_.warn(user("COLOR_0") + ": values that are no colors are read as 0");
    }

  private:
    bool has(const std::string& name) const { return attribute(primitive_, name) >= 0; }
    std::string user(const std::string& name) const {
        return fmt::format("{}.attributes.{}", key_, name);
    }

    // The accessor of an attribute; throws Error unless it has as many elements as POSITION.
    int checked(const std::string& name) const {
        const int accessor = attribute(primitive_, name);
        const std::size_t expected =
            accessors_.element_count(attribute(primitive_, "POSITION"), user("POSITION"));
        const std::size_t found = accessors_.element_count(accessor, user(name));
        if (found != expected)
            report_.fail(user(name), fmt::format("{} elements, as POSITION has", expected),
                         fmt::format("{}", found));
        return accessor;
    }

    void read_texcoords(const std::string& name, std::vector<glm::vec2>& texcoords) {
        if (!has(name)) return;
        texcoords = accessors_.vec2s(checked(name), first_, count_, user(name));
        if (clean(texcoords, -kLargestTexcoord, kLargestTexcoord))
            report_.warn(user(name) + ": values that are no coordinates are read as 0");
    }

    const tinygltf::Primitive& primitive_;
    std::array<int, 2> sets_;
    GltfAccessors& accessors_;
    GltfReport& report_;
    const std::string& key_;
    std::size_t first_;
    std::size_t count_;
};

// Completes normals in place; returns the number of stored normals and tangents that were replaced.
std::size_t finish_normals(Mesh& mesh) {
    if (mesh.normals.empty()) make_normals(mesh, true);  // required by glTF 3.7.2.1
    return repair_frames(mesh);
}

}  // namespace

GltfMeshes::GltfMeshes(const GltfDocument& document, GltfBuffers& buffers, GltfAccessors& accessors,
                       std::vector<std::array<int, 2>> sets, GltfReport& report, Scene& scene)
    : model_(*document.model),
      document_(document),
      buffers_(buffers),
      accessors_(accessors),
      sets_(std::move(sets)),
      report_(report),
      scene_(scene),
      parts_(model_.meshes.size()),
      has_parts_(model_.meshes.size(), 0) {}

const std::vector<GltfPart>& GltfMeshes::parts(int index, std::string_view user) {
    const tinygltf::Mesh& mesh = item_at(model_.meshes, index, report_, user);
    const auto slot = static_cast<std::size_t>(index);
    if (has_parts_[slot]) return parts_[slot];
    has_parts_[slot] = 1;
    const std::string mesh_key = fmt::format("meshes[{}]", index);
    const std::string name = mesh.name.empty() ? mesh_key : mesh.name;
    for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
        const auto draco = document_.draco.find({slot, i});
        read_part({mesh.primitives[i],
                   draco == document_.draco.end() ? nullptr : &draco->second,
                   {0, 1},
                   name,
                   fmt::format("{}.primitives[{}]", mesh_key, i)},
                  parts_[slot]);
    }
    return parts_[slot];
}

bool GltfMeshes::can_draw(const tinygltf::Primitive& primitive, const std::string& key) {
    if (primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
        report_.fail(key + ".mode", "0 to 6", fmt::format("{}", primitive.mode));
    if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
        report_.warn(key + ": points and lines are not drawn");
        return false;
    }
    if (attribute(primitive, "POSITION") < 0) {
        report_.warn(key + ": has no POSITION: it is not drawn");
        return false;
    }
    return true;
}

void GltfMeshes::read_part(Source source, std::vector<GltfPart>& parts) {
    const tinygltf::Primitive& primitive = source.primitive;
    if (!can_draw(primitive, source.key)) return;
    int material = primitive.material;
    if (material >= 0)
        item_at(model_.materials, material, report_, source.key + ".material");
    else
        material = default_material();
    const auto index = static_cast<std::size_t>(material);
    if (index < sets_.size()) source.sets = sets_[index];
    if (emits_only(scene_.materials[index]) && attribute(primitive, "COLOR_0") >= 0)
        report_.warn(source.key + ": vertex colors of an unlit material are not drawn");
    const TangentSource frame = tangent_source_of(scene_.materials[index]);
    const auto [known, fresh] =
        known_meshes_.try_emplace(fingerprint(primitive, source.draco, source.sets, frame), -1);
    if (fresh) known->second = read_mesh(source);
    if (known->second < 0) return;
    const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(known->second)];
    parts.push_back({known->second, resolve_material(material, mesh, source)});
}

// Nothing for a primitive that is not compressed, and for a broken one that has uncompressed data
// as well.
std::optional<DracoMesh> GltfMeshes::decompress(const Source& source, std::size_t vertices) {
    if (source.draco == nullptr) return std::nullopt;
    const tinygltf::Primitive& primitive = source.primitive;
    const std::string key = source.key + ".extensions.KHR_draco_mesh_compression";
    DracoExpected expected;
    expected.vertices = vertices;
    // The triangles of a strip are fewer or more than its indices.
    if (source.draco->indices >= 0 && primitive.mode == TINYGLTF_MODE_TRIANGLES)
        expected.corners = accessors_.element_count(source.draco->indices, source.key + ".indices");
    bool has_others = true;
    for (const auto& [name, accessor] : primitive.attributes) {
        const auto& item = item_at(model_.accessors, accessor, report_,
                                   fmt::format("{}.attributes.{}", source.key, name));
        has_others = has_others && item.bufferView >= 0;
        if (const auto id = source.draco->attributes.find(name);
            id != source.draco->attributes.end())
            expected.ids[id->second] = item.normalized;
    }
    try {
        const auto bytes = buffers_.view(source.draco->buffer_view, key + ".bufferView");
        // Half a byte a triangle is what smooth scans take. Decoded and indexed, a triangle takes
        // some 110 bytes: credit for four times the bytes of other files, once for each view.
        if (paid_for_.insert(source.draco->buffer_view).second) report_.earn(4 * bytes.size());
        return decode_draco_mesh(bytes, expected, key, report_);
    } catch (const Error& error) {
        if (!has_others) throw;
        report_.warn(fmt::format("{}: the uncompressed data are used", error.what()));
        return std::nullopt;
    }
}

int GltfMeshes::read_mesh(const Source& source) {
    const tinygltf::Primitive& primitive = source.primitive;
    const std::string& key = source.key;
    const std::string position_key = key + ".attributes.POSITION";
    const std::size_t vertices =
        accessors_.element_count(attribute(primitive, "POSITION"), position_key);
    if (vertices >= std::numeric_limits<std::uint32_t>::max())
        report_.fail(position_key, "fewer than 2^32 - 1 elements", fmt::format("{}", vertices));
    std::optional<DracoMesh> draco = decompress(source, vertices);
    if (draco) {
        for (const auto& [name, accessor] : primitive.attributes) {
            const auto id = source.draco->attributes.find(name);
            if (id == source.draco->attributes.end()) continue;
            const DracoAttribute& values = draco->attributes.at(id->second);
            accessors_.set_values(accessor, values.components, values.values);
        }
    }

    // Of a large vertex buffer that several meshes share, only the range in use is read.
    std::vector<std::uint32_t> indices;
    std::size_t first = 0;
    std::size_t count = vertices;
    const int accessor = source.draco == nullptr ? primitive.indices : source.draco->indices;
    const bool indexed = draco || accessor >= 0;
    if (indexed) {
        indices = draco ? std::move(draco->indices)
                        : accessors_.indices(accessor, vertices, key + ".indices");
        const auto [low, high] = std::minmax_element(indices.begin(), indices.end());
        first = indices.empty() ? 0 : *low;
        count = indices.empty() ? 0 : *high - first + 1;
        for (std::uint32_t& index : indices) index -= static_cast<std::uint32_t>(first);
    }
    Mesh mesh;
    mesh.name = source.name;
    VertexReader(primitive, source.sets, accessors_, report_, key, first, count).read(mesh);
    accessors_.clear_values();
    if (!indexed) {
        report_.pay(count * sizeof(std::uint32_t), key);
        indices.resize(count);
        std::iota(indices.begin(), indices.end(), 0u);
    }
    // Corners are 31-bit numbers from here on, and a strip has up to three times as many corners as
    // indices.
    constexpr std::size_t kMostIndices = std::numeric_limits<std::int32_t>::max() / 3;
    if (indices.size() > kMostIndices)
        report_.fail(key, fmt::format("at most {} indices", kMostIndices),
                     fmt::format("{}", indices.size()));
    // A strip expands threefold, and meshes without normals to three vertices per triangle.
    report_.pay(indices.size() * 3 * sizeof(std::uint32_t), key);
    mesh.indices =
        triangle_list(std::move(indices), draco ? TINYGLTF_MODE_TRIANGLES : primitive.mode);
    if (mesh.indices.empty()) {
        report_.warn(key + ": has no triangles: it is not drawn");
        return -1;
    }
    if (mesh.tangents.empty()) mesh.tangent_source.emplace();
    scene_.meshes.push_back(std::move(mesh));
    return static_cast<int>(scene_.meshes.size()) - 1;
}

int GltfMeshes::default_material() {
    if (default_material_ < 0) {
        default_material_ = static_cast<int>(scene_.materials.size());
        scene_.materials.emplace_back().name = "default";
    }
    return default_material_;
}

int GltfMeshes::resolve_material(int index, const Mesh& mesh, const Source& source) {
    const bool missing[] = {mesh.texcoord0.empty(), mesh.texcoord1.empty()};
    const auto is_dropped = [&](const TextureUse& use) { return use && missing[use.texcoord]; };
    std::string dropped[2];
    const auto uses = texture_uses(scene_.materials[static_cast<std::size_t>(index)]);
    for (std::size_t i = 0; i < uses.size(); ++i) {
        if (!is_dropped(*uses[i])) continue;
        std::string& names = dropped[uses[i]->texcoord];
        names += fmt::format("{}{}", names.empty() ? "" : ", ", kTextureNames[i]);
    }
    if (dropped[0].empty() && dropped[1].empty()) return index;
    for (int set = 0; set < 2; ++set) {
        if (dropped[set].empty()) continue;
        report_.warn(fmt::format("{} ({}): no TEXCOORD_{}: not used: {}", source.key, mesh.name,
                                 source.sets[static_cast<std::size_t>(set)], dropped[set]));
    }
    const int mask = (missing[0] ? 1 : 0) + (missing[1] ? 2 : 0);
    const auto [copy, fresh] = reduced_materials_.try_emplace({index, mask}, -1);
    if (fresh) {
        copy->second = static_cast<int>(scene_.materials.size());
        scene_.materials.push_back(scene_.materials[static_cast<std::size_t>(index)]);
        for (TextureUse* use : texture_uses(scene_.materials.back()))
            if (is_dropped(*use)) *use = TextureUse();
    }
    return copy->second;
}

void GltfMeshes::finish() {
    std::vector<std::size_t> mended(scene_.meshes.size(), 0);
    parallel_for(mended.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) mended[i] = finish_normals(scene_.meshes[i]);
    });
    for (std::size_t i = 0; i < mended.size(); ++i) {
        if (mended[i] > 0)
            report_.warn(fmt::format("{}: {} vertices had broken normals or tangents; replaced",
                                     scene_.meshes[i].name, mended[i]));
    }
    for (std::string& line : fit_tangents(scene_)) report_.warn(std::move(line));
}

}  // namespace burnish
