// glTF files with everything that the reader reads, each small.
#include <meshoptimizer.h>

#include <array>
#include <span>

#include "burnish/image_io.hpp"
#include "core/files.hpp"
#include "seeds.hpp"
#include "support/draco_writer.hpp"
#include "support/glb_writer.hpp"

namespace burnish::fuzz {
namespace {

using nlohmann::json;

std::string text_of(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string picture(const char* extension, int channels) {
    const TemporaryFolder folder;
    const auto path = folder.path() / (std::string("picture") + extension);
    write_image(path, Image(3, 2, channels, 0.25f), {});
    return text_of(read_file(path));
}

json texture_info(int texture) {
    return {{"index", texture},
            {"texCoord", 1},
            {"extensions",
             {{"KHR_texture_transform",
               {{"offset", {0.1, 0.2}}, {"rotation", 0.5}, {"scale", {2, 3}}, {"texCoord", 0}}}}}};
}

json rich_material(int texture) {
    const json info = texture_info(texture);
    json normal = info, occlusion = info;
    normal["scale"] = 0.5;
    occlusion["strength"] = 0.5;
    return {
        {"name", "rich"},
        {"pbrMetallicRoughness",
         {{"baseColorFactor", {0.5, 0.6, 0.7, 0.8}},
          {"metallicFactor", 0.5},
          {"roughnessFactor", 0.4},
          {"baseColorTexture", info},
          {"metallicRoughnessTexture", info}}},
        {"normalTexture", normal},
        {"occlusionTexture", occlusion},
        {"emissiveTexture", info},
        {"emissiveFactor", {1, 0.5, 0.25}},
        {"alphaMode", "MASK"},
        {"alphaCutoff", 0.3},
        {"doubleSided", true},
        {"extensions",
         {{"KHR_materials_anisotropy",
           {{"anisotropyStrength", 0.6}, {"anisotropyRotation", 1.0}, {"anisotropyTexture", info}}},
          {"KHR_materials_ior", {{"ior", 1.4}}},
          {"KHR_materials_emissive_strength", {{"emissiveStrength", 2.0}}}}}};
}

void add_light_and_camera(json& root) {
    root["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"},
         {"color", {1, 0.9, 0.8}},
         {"intensity", 5},
         {"range", 10},
         {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.5}}}},
        {{"type", "directional"}}};
    root["cameras"] = {
        {{"type", "perspective"},
         {"perspective", {{"yfov", 0.7}, {"znear", 0.1}, {"zfar", 100}, {"aspectRatio", 1.5}}}},
        {{"type", "orthographic"},
         {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 9}}}}};
    const json light = {{"KHR_lights_punctual", {{"light", 0}}}};
    root["nodes"].push_back({{"camera", 0},
                             {"translation", {1, 2, 3}},
                             {"rotation", {0, 0.6, 0, 0.8}},
                             {"scale", {1, 2, 1}},
                             {"extensions", light}});
    root["nodes"].push_back({{"camera", 1},
                             {"children", {1}},
                             {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}});
    root["scenes"][0]["nodes"].push_back(2);
    root["extensionsUsed"] = {"KHR_lights_punctual", "KHR_materials_anisotropy",
                              "KHR_texture_transform"};
}

GlbWriter rich_model() {
    GlbWriter writer;
    const std::string png = picture(".png", 3);
    GlbPrimitive square = unit_square(1, true);
    square.texcoord1 = square.texcoord0;
    square.colors.assign(square.positions.size(), {1.0f, 0.5f, 0.25f, 1.0f});
    square.material =
        writer.add_material(rich_material(writer.add_png(std::as_bytes(std::span(png)))));
    writer.root["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}};
    writer.root["textures"][0]["sampler"] = 0;
    writer.add_node(writer.add_mesh(square));
    add_light_and_camera(writer.root);
    return writer;
}

// Strips and fans, with and without indices.
GlbWriter bare_model(int mode, bool indexed) {
    GlbPrimitive square = unit_square(2, false);
    square.mode = mode;
    if (!indexed) square.indices.clear();
    square.normals.clear();
    GlbWriter writer;
    writer.add_node(writer.add_mesh(square));
    return writer;
}

// Normalised 16-bit positions, 8-bit normals and a sparse part.
GlbWriter quantised_model() {
    GlbWriter writer;
    const std::vector<std::array<std::uint16_t, 4>> positions = {
        {0, 0, 0, 0}, {65535, 0, 0, 0}, {0, 65535, 0, 0}};
    const std::vector<std::array<std::int8_t, 4>> normals(3, {0, 0, 127, 0});
    const std::vector<std::uint8_t> moved = {2, 0, 0, 0};
    json attributes;
    attributes["POSITION"] = writer.add_items(positions, 5123, "VEC3");
    attributes["NORMAL"] = writer.add_items(normals, 5120, "VEC3");
    for (std::size_t i = 0; i < 2; ++i) {
        writer.root["bufferViews"][i]["byteStride"] = i == 0 ? 8 : 4;
        writer.root["accessors"][i]["normalized"] = true;
    }
    const int indices = writer.add_view(std::as_bytes(std::span(moved)));
    writer.root["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
        {"values", {{"bufferView", 0}, {"byteOffset", 8}}}};
    writer.root["meshes"].push_back({{"primitives", {{{"attributes", attributes}}}}});
    writer.root["extensionsUsed"] = {"KHR_mesh_quantization"};
    writer.add_node(0);
    return writer;
}

void compress_view(GlbWriter& writer, std::size_t index, std::span<const unsigned char> packed,
                   std::size_t stride, std::size_t count, const char* mode) {
    const int view = writer.add_view(std::as_bytes(packed));
    json source = writer.root["bufferViews"][static_cast<std::size_t>(view)];
    source["byteStride"] = stride;
    source["count"] = count;
    source["mode"] = mode;
    writer.root["bufferViews"].erase(static_cast<std::size_t>(view));
    writer.root["bufferViews"][index]["extensions"]["EXT_meshopt_compression"] = source;
}

GlbWriter compressed_model() {
    const GlbPrimitive square = unit_square(2, false);
    const std::size_t vertices = square.positions.size(), corners = square.indices.size();
    GlbWriter writer;
    writer.add_node(writer.add_mesh(square));
    std::vector<unsigned char> packed(meshopt_encodeVertexBufferBound(vertices, 12));
    packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), square.positions.data(),
                                             vertices, 12));
    compress_view(writer, 0, packed, 12, vertices, "ATTRIBUTES");
    packed.resize(meshopt_encodeIndexBufferBound(corners, vertices));
    packed.resize(
        meshopt_encodeIndexBuffer(packed.data(), packed.size(), square.indices.data(), corners));
    compress_view(writer, 3, packed, 4, corners, "TRIANGLES");
    writer.root["extensionsUsed"] = {"EXT_meshopt_compression"};
    return writer;
}

// Compressed with Draco, unlit, in instances, with a texture of three versions.
GlbWriter draco_model(bool edgebreaker, int position_bits) {
    GlbWriter writer;
    const std::string png = picture(".png", 3);
    const int texture = writer.add_png(std::as_bytes(std::span(png)));
    writer.root["textures"][0]["extensions"] = {{"EXT_texture_webp", {{"source", 0}}},
                                                {"EXT_texture_avif", {{"source", 0}}},
                                                {"KHR_texture_basisu", {{"source", 0}}}};
    GlbPrimitive square = unit_square(2, false);
    square.material = writer.add_material(
        {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}, {"texCoord", 0}}}}},
         {"extensions",
          {{"KHR_materials_unlit", json::object()},
           {"KHR_materials_anisotropy",
            {{"anisotropy", -0.5},
             {"anisotropyDirection", {1, 0, 0}},
             {"anisotropyDirectionTexture", {{"index", texture}}}}}}}});
    writer.add_node(add_draco_mesh(writer, square, {edgebreaker, position_bits}));
    const std::vector<glm::vec3> places = {{0, 0, 0}, {2, 1, 1}};
    const std::vector<std::array<std::int16_t, 4>> turns = {{0, 0, 23170, 23170}, {0, 0, 0, 32767}};
    json& instances = writer.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"];
    instances["attributes"]["TRANSLATION"] = writer.add_items(places, 5126, "VEC3");
    instances["attributes"]["ROTATION"] = writer.add_items(turns, 5122, "VEC4");
    writer.root["accessors"].back()["normalized"] = true;
    return writer;
}

}  // namespace

std::vector<std::string> gltf_seeds() {
    std::vector<std::string> seeds;
    const std::string positions =
        "data:application/octet-stream;base64,"
        "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    for (const GlbWriter& writer :
         {rich_model(), bare_model(4, true), bare_model(5, true), bare_model(6, false),
          quantised_model(), compressed_model(), draco_model(true, 11), draco_model(false, 11),
          draco_model(true, 0), draco_model(false, 0)})
        seeds.push_back(text_of(writer.glb()));
    GlbWriter plain;
    plain.root["bufferViews"] = {{{"buffer", 0}, {"byteLength", 36}}};
    plain.add_accessor(0, 5126, 3, "VEC3");
    plain.root["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}};
    plain.add_node(0);
    json document = plain.root;
    document["buffers"] = {{{"byteLength", 36}, {"uri", positions}}};
    document["images"] = {{{"uri", "map.png"}}};
    document["textures"] = {{{"source", 0}}};
    document["materials"] = {{{"normalTexture", {{"index", 0}}}}};
    document["meshes"][0]["primitives"][0]["material"] = 0;
    seeds.push_back(document.dump());
    return seeds;
}

}  // namespace burnish::fuzz
