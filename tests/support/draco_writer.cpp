#include "support/draco_writer.hpp"

#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>

#include <stdexcept>

namespace burnish {
namespace {

template <class Item>
int add_attribute(draco::Mesh& mesh, draco::GeometryAttribute::Type type,
                  const std::vector<Item>& items) {
    draco::GeometryAttribute layout;
    layout.Init(type, nullptr, static_cast<std::uint8_t>(Item::length()), draco::DT_FLOAT32, false,
                sizeof(Item), 0);
    const int id = mesh.AddAttribute(layout, true, static_cast<std::uint32_t>(items.size()));
    for (std::size_t i = 0; i < items.size(); ++i)
        mesh.attribute(id)->SetAttributeValue(
            draco::AttributeValueIndex(static_cast<std::uint32_t>(i)), &items[i]);
    return id;
}

}  // namespace

int add_draco_mesh(GlbWriter& writer, const GlbPrimitive& primitive, const DracoOptions& options) {
    draco::Mesh mesh;
    mesh.set_num_points(static_cast<std::uint32_t>(primitive.positions.size()));
    const int position =
        add_attribute(mesh, draco::GeometryAttribute::POSITION, primitive.positions);
    const int normal = add_attribute(mesh, draco::GeometryAttribute::NORMAL, primitive.normals);
    const int texcoord =
        add_attribute(mesh, draco::GeometryAttribute::TEX_COORD, primitive.texcoord0);
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3)
        mesh.AddFace({draco::PointIndex(primitive.indices[i]),
                      draco::PointIndex(primitive.indices[i + 1]),
                      draco::PointIndex(primitive.indices[i + 2])});
    draco::ExpertEncoder encoder(mesh);
    encoder.SetEncodingMethod(options.edgebreaker ? draco::MESH_EDGEBREAKER_ENCODING
                                                  : draco::MESH_SEQUENTIAL_ENCODING);
    if (options.position_bits > 0) {
        encoder.SetAttributeQuantization(position, options.position_bits);
        encoder.SetAttributeQuantization(normal, 10);
        encoder.SetAttributeQuantization(texcoord, 14);
    }
    encoder.SetTrackEncodedProperties(true);
    draco::EncoderBuffer buffer;
    if (!encoder.EncodeToBuffer(&buffer).ok()) throw std::runtime_error("draco: not encoded");

    const int view = writer.add_view(std::as_bytes(std::span(buffer.data(), buffer.size())));
    nlohmann::json attributes, ids;
    const auto add = [&](const char* name, const char* type, int id) {
        attributes[name] = writer.root["accessors"].size();
        ids[name] = mesh.attribute(id)->unique_id();
        writer.root["accessors"].push_back(
            {{"componentType", 5126}, {"count", encoder.num_encoded_points()}, {"type", type}});
    };
    add("POSITION", "VEC3", position);
    add("NORMAL", "VEC3", normal);
    add("TEXCOORD_0", "VEC2", texcoord);
    nlohmann::json part = {
        {"attributes", attributes}, {"indices", writer.root["accessors"].size()}, {"mode", 4}};
    writer.root["accessors"].push_back(
        {{"componentType", 5125}, {"count", 3 * encoder.num_encoded_faces()}, {"type", "SCALAR"}});
    part["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", view}, {"attributes", ids}};
    if (primitive.material >= 0) part["material"] = primitive.material;
    writer.root["meshes"].push_back({{"primitives", {part}}});
    writer.root["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    return static_cast<int>(writer.root["meshes"].size()) - 1;
}

}  // namespace burnish
