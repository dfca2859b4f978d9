#include "formats/gltf/gltf_draco.hpp"

#include <draco/compression/decode.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>

namespace burnish {
namespace {

constexpr const char* kExpected = "Draco data of a mesh";

// Connectivity tables of libdraco take some ten numbers of four bytes for each corner.
constexpr std::uint64_t kTableBytesPerCorner = 40;

// The start of the data, which libdraco trusts when it allocates.
struct Header {
    bool edgebreaker = false;
    std::uint32_t triangles = 0;
    std::uint32_t vertices = 0;  // before vertices are split along seams
};

Header read_header(std::span<const std::byte> bytes, std::string_view key,
                   const GltfReport& report) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    draco::DracoHeader start;
    if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &start).ok())
        report.fail(key, kExpected, "something else");
    if (start.version_major != 2 || start.version_minor != 2)
        report.fail(key, "version 2.2 of Draco's format, which the extension names",
                    fmt::format("{}.{}", start.version_major, start.version_minor));
    if (start.encoder_type != draco::TRIANGULAR_MESH)
        report.fail(key, kExpected, "Draco data of a point cloud");
    if ((start.flags & METADATA_FLAG_MASK) != 0)
        report.fail(key, "Draco data without metadata", "metadata");
    Header header;
    header.edgebreaker = start.encoder_method == draco::MESH_EDGEBREAKER_ENCODING;
    std::uint8_t traversal = 0;
    const bool whole = header.edgebreaker ? buffer.Decode(&traversal) &&
                                                draco::DecodeVarint(&header.vertices, &buffer) &&
                                                draco::DecodeVarint(&header.triangles, &buffer)
                                          : draco::DecodeVarint(&header.triangles, &buffer) &&
                                                draco::DecodeVarint(&header.vertices, &buffer);
    if (!whole) report.fail(key, kExpected, fmt::format("{} bytes", bytes.size()));
    return header;
}

void require_affordable(std::uint64_t bytes, std::string_view key, const GltfReport& report) {
    if (!report.affords(bytes))
        report.fail(key, "no more memory in proportion to the file than uncompressed data take",
                    fmt::format("{} MiB", bytes >> 20));
}

// A decoder of libdraco that stops before it allocates values that the file may not expand to. They
// are freed with the decoded mesh, so that they cost no credit.
template <class Base>
class BoundedDecoder final : public Base {
  public:
    explicit BoundedDecoder(const GltfReport& report) : report_(report) {}
    std::uint64_t bytes() const { return bytes_; }

  private:
    bool DecodeAllAttributes() override {
        const draco::PointCloud& cloud = *this->point_cloud();
        std::uint64_t per_vertex = 0;
        for (int i = 0; i < cloud.num_attributes(); ++i)
            per_vertex +=
                static_cast<std::uint64_t>(cloud.attribute(i)->num_components()) *
                static_cast<std::uint64_t>(draco::DataTypeLength(cloud.attribute(i)->data_type()));
        // Quantized values exist twice: as integers of four bytes and as floats.
        bytes_ = 2 * per_vertex * cloud.num_points();
        return report_.affords(bytes_) && Base::DecodeAllAttributes();
    }

    const GltfReport& report_;
    std::uint64_t bytes_ = 0;
};

template <class Decoder>
std::unique_ptr<draco::Mesh> decode_with(std::span<const std::byte> bytes, std::string_view key,
                                         GltfReport& report) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    auto mesh = std::make_unique<draco::Mesh>();
    const draco::DecoderOptions options;
    Decoder decoder(report);
    std::string reason;
    try {
        const draco::Status status = decoder.Decode(options, &buffer, mesh.get());
        if (!status.ok()) reason = status.error_msg_string();
    } catch (const std::exception& exception) {
        reason = exception.what();
    }
    require_affordable(decoder.bytes(), key, report);
    if (!reason.empty()) report.fail(key, kExpected, fmt::format("corrupt data ({})", reason));
    return mesh;
}

template <class Stored>
void copy_values(const draco::PointAttribute& from, std::size_t vertices, bool normalized,
                 DracoAttribute& to) {
    const auto components = static_cast<std::size_t>(to.components);
    const float scale = normalized && std::numeric_limits<Stored>::is_integer
                            ? 1.0f / static_cast<float>(std::numeric_limits<Stored>::max())
                            : 1.0f;
    for (std::size_t i = 0; i < vertices; ++i) {
        const draco::PointIndex point(static_cast<std::uint32_t>(i));
        const std::uint8_t* item = from.GetAddress(from.mapped_index(point));
        for (std::size_t c = 0; c < components; ++c) {
            Stored value;
            std::memcpy(&value, item + c * sizeof value, sizeof value);
            const float number = scale * static_cast<float>(value);
            // The most negative signed integer lies just below -1 (glTF 3.11).
            to.values[i * components + c] = normalized ? std::max(number, -1.0f) : number;
        }
    }
}

bool copy_any(const draco::PointAttribute& from, std::size_t vertices, bool normalized,
              DracoAttribute& to) {
    switch (from.data_type()) {
        case draco::DT_INT8:
            copy_values<std::int8_t>(from, vertices, normalized, to);
            return true;
        case draco::DT_UINT8:
            copy_values<std::uint8_t>(from, vertices, normalized, to);
            return true;
        case draco::DT_INT16:
            copy_values<std::int16_t>(from, vertices, normalized, to);
            return true;
        case draco::DT_UINT16:
            copy_values<std::uint16_t>(from, vertices, normalized, to);
            return true;
        case draco::DT_UINT32:
            copy_values<std::uint32_t>(from, vertices, normalized, to);
            return true;
        case draco::DT_FLOAT32:
            copy_values<float>(from, vertices, false, to);
            return true;
        default:
            return false;
    }
}

// Whether every vertex has a value: libdraco does not check the map of corrupt data.
bool is_mapped(const draco::PointAttribute& attribute, std::size_t vertices) {
    if (attribute.is_mapping_identity()) return attribute.size() >= vertices;
    if (attribute.indices_map_size() < vertices) return false;
    for (std::size_t i = 0; i < vertices; ++i) {
        const draco::PointIndex point(static_cast<std::uint32_t>(i));
        if (attribute.mapped_index(point).value() >= attribute.size()) return false;
    }
    return true;
}

DracoAttribute read_attribute(const draco::Mesh& mesh, int id, bool normalized,
                              std::string_view key, GltfReport& report) {
    const auto index = mesh.GetAttributeIdByUniqueId(static_cast<std::uint32_t>(id));
    if (index < 0)
        report.fail(key, fmt::format("an attribute of id {} in the compressed data", id), "none");
    const draco::PointAttribute& from = *mesh.attribute(index);
    const std::size_t vertices = mesh.num_points();
    DracoAttribute to;
    to.components = from.num_components();
    report.pay(vertices * static_cast<std::size_t>(to.components) * sizeof(float), key);
    to.values.resize(vertices * static_cast<std::size_t>(to.components));
    if (!is_mapped(from, vertices) || !copy_any(from, vertices, normalized, to))
        report.fail(key, kExpected, fmt::format("corrupt data in attribute {}", id));
    return to;
}

std::vector<std::uint32_t> read_indices(const draco::Mesh& mesh, std::string_view key,
                                        GltfReport& report) {
    const std::size_t triangles = mesh.num_faces();
    report.pay(3 * triangles * sizeof(std::uint32_t), key);
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * triangles);
    for (std::size_t i = 0; i < triangles; ++i) {
        for (const draco::PointIndex& corner :
             mesh.face(draco::FaceIndex(static_cast<std::uint32_t>(i)))) {
            if (corner.value() >= mesh.num_points())
                report.fail(key, kExpected, "corrupt data in its triangles");
            indices.push_back(corner.value());
        }
    }
    return indices;
}

}  // namespace

DracoMesh decode_draco_mesh(std::span<const std::byte> bytes, const DracoExpected& expected,
                            std::string_view key, GltfReport& report) {
    const Header header = read_header(bytes, key, report);
    const std::uint64_t corners = 3 * std::uint64_t{header.triangles};
    if (expected.corners != 0 && corners != expected.corners)
        report.fail(key, fmt::format("{} indices, as the accessor has", expected.corners),
                    fmt::format("{}", corners));
    if (header.vertices > std::max<std::uint64_t>(corners, expected.vertices))
        report.fail(key, kExpected,
                    fmt::format("{} vertices of {} triangles", header.vertices, header.triangles));
    require_affordable(corners * kTableBytesPerCorner, key, report);
    using draco::MeshEdgebreakerDecoder, draco::MeshSequentialDecoder;
    const auto mesh = header.edgebreaker
                          ? decode_with<BoundedDecoder<MeshEdgebreakerDecoder>>(bytes, key, report)
                          : decode_with<BoundedDecoder<MeshSequentialDecoder>>(bytes, key, report);
    if (mesh->num_points() != expected.vertices)
        report.fail(key, fmt::format("{} vertices, as the accessors have", expected.vertices),
                    fmt::format("{}", mesh->num_points()));
    DracoMesh out;
    out.vertices = mesh->num_points();
    for (const auto& [id, normalized] : expected.ids)
        out.attributes.emplace(id, read_attribute(*mesh, id, normalized, key, report));
    out.indices = read_indices(*mesh, key, report);
    return out;
}

}  // namespace burnish
