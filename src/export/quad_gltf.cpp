#include "export/quad_gltf.hpp"

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>

#include "burnish/version.hpp"

namespace burnish {

namespace {

using nlohmann::ordered_json;

// Position, normal, tangent, texture coordinates.
constexpr std::size_t kVertexFloats = 3 + 3 + 4 + 2;
constexpr std::size_t kVertices = 4;
constexpr std::array<std::uint16_t, 6> kIndices = {0, 1, 2, 0, 2, 3};
constexpr std::size_t kVertexBytes = kVertexFloats * sizeof(float);
constexpr int kRepeat = 10497, kClampToEdge = 33071;
constexpr int kFloat = 5126, kUnsignedShort = 5123, kArrayBuffer = 34962, kElementBuffer = 34963;

float half_meters(double mm) {
    return static_cast<float>(mm * 0.5e-3);
}

ordered_json accessor(std::size_t offset, const char* type) {
    return {{"bufferView", 0},
            {"byteOffset", offset},
            {"componentType", kFloat},
            {"count", kVertices},
            {"type", type}};
}

ordered_json accessors_of(const SampleQuad& quad) {
    const float x = half_meters(quad.width_mm), y = half_meters(quad.height_mm);
    ordered_json position = accessor(0, "VEC3");
    position["min"] = {-x, -y, 0.0f};
    position["max"] = {x, y, 0.0f};
    return {position,
            accessor(3 * sizeof(float), "VEC3"),
            accessor(6 * sizeof(float), "VEC4"),
            accessor(10 * sizeof(float), "VEC2"),
            {{"bufferView", 1},
             {"componentType", kUnsignedShort},
             {"count", kIndices.size()},
             {"type", "SCALAR"}}};
}

}  // namespace

std::string quad_gltf(const SampleQuad& quad, const QuadMaterial& material,
                      const std::string& buffer) {
    constexpr std::size_t kBytes = kVertices * kVertexBytes;
    ordered_json root;
    root["asset"] = {{"version", "2.0"}, {"generator", "Burnish " + std::string(version())}};
    root["extensionsUsed"] = material.extensions;
    root["scene"] = 0;
    root["scenes"] = {{{"nodes", {0}}}};
    root["nodes"] = {{{"mesh", 0}, {"name", quad.name}}};
    ordered_json attributes = {{"POSITION", 0}, {"NORMAL", 1}};
    if (quad.tangents) attributes["TANGENT"] = 2;
    attributes["TEXCOORD_0"] = 3;
    root["meshes"] = {
        {{"primitives", {{{"attributes", attributes}, {"indices", 4}, {"material", 0}}}}}};
    root["materials"] = ordered_json::array({material.json});
    root["textures"] = ordered_json::array();
    root["images"] = ordered_json::array();
    for (const std::string& image : material.images) {
        root["textures"].push_back({{"sampler", 0}, {"source", root["images"].size()}});
        root["images"].push_back({{"uri", image}});
    }
    // Linear with mip maps.
    const int wrap = material.repeats ? kRepeat : kClampToEdge;
    root["samplers"] = {
        {{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", wrap}, {"wrapT", wrap}}};
    root["accessors"] = accessors_of(quad);
    root["bufferViews"] = {{{"buffer", 0},
                            {"byteLength", kBytes},
                            {"byteStride", kVertexBytes},
                            {"target", kArrayBuffer}},
                           {{"buffer", 0},
                            {"byteOffset", kBytes},
                            {"byteLength", sizeof kIndices},
                            {"target", kElementBuffer}}};
    root["buffers"] = {{{"uri", buffer}, {"byteLength", kBytes + sizeof kIndices}}};
    return root.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::vector<std::byte> quad_bytes(const SampleQuad& quad) {
    const float x = half_meters(quad.width_mm), y = half_meters(quad.height_mm);
    std::vector<float> vertices;
    // Counter-clockwise from the lower left; v runs down the picture.
    const std::array<std::array<float, 4>, kVertices> corners = {
        {{-x, -y, 0.0f, 1.0f}, {x, -y, 1.0f, 1.0f}, {x, y, 1.0f, 0.0f}, {-x, y, 0.0f, 0.0f}}};
    for (const auto& [px, py, u, v] : corners)
        vertices.insert(vertices.end(),
                        {px, py, 0.0f, 0.0f, 0.0f, 1.0f, 1.0f, 0.0f, 0.0f, 1.0f, u, v});
    std::vector<std::byte> out;
    const auto append = [&out](std::span<const std::byte> bytes) {
        out.insert(out.end(), bytes.begin(), bytes.end());
    };
    append(std::as_bytes(std::span(vertices)));
    append(std::as_bytes(std::span(kIndices)));
    return out;
}

}  // namespace burnish
