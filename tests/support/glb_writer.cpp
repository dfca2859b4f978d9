#include "glb_writer.hpp"

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>

#include "burnish/image_io.hpp"
#include "core/files.hpp"

namespace burnish {
namespace {

using nlohmann::json;

void append(std::vector<std::byte>& out, std::span<const std::byte> bytes) {
    out.insert(out.end(), bytes.begin(), bytes.end());
}

void append_word(std::vector<std::byte>& out, std::size_t word) {
    for (int i = 0; i < 4; ++i) out.push_back(static_cast<std::byte>((word >> (8 * i)) & 0xFF));
}

void pad(std::vector<std::byte>& out, char filler) {
    while (out.size() % 4 != 0) out.push_back(static_cast<std::byte>(filler));
}

std::vector<std::byte> png_of(const Image& image) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "image.png";
    write_image(path, image, {});
    return read_file(path);
}

}  // namespace

GlbWriter::GlbWriter() {
    root = {
        {"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", json::array()}}}}};
    for (const char* key :
         {"accessors", "bufferViews", "images", "materials", "meshes", "nodes", "textures"})
        root[key] = json::array();
}

int GlbWriter::add_view(std::span<const std::byte> bytes) {
    pad(binary_, '\0');
    root["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}});
    append(binary_, bytes);
    return static_cast<int>(root["bufferViews"].size()) - 1;
}

int GlbWriter::add_accessor(int view, int component, std::size_t count, const char* type) {
    root["accessors"].push_back(
        {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
    return static_cast<int>(root["accessors"].size()) - 1;
}

int GlbWriter::add_mesh(const GlbPrimitive& primitive) {
    json out = {{"mode", primitive.mode}, {"attributes", json::object()}};
    json& attributes = out["attributes"];
    if (!primitive.positions.empty())
        attributes["POSITION"] = add_items(primitive.positions, 5126, "VEC3");
    if (!primitive.normals.empty())
        attributes["NORMAL"] = add_items(primitive.normals, 5126, "VEC3");
    if (!primitive.tangents.empty())
        attributes["TANGENT"] = add_items(primitive.tangents, 5126, "VEC4");
    if (!primitive.texcoord0.empty())
        attributes["TEXCOORD_0"] = add_items(primitive.texcoord0, 5126, "VEC2");
    if (!primitive.texcoord1.empty())
        attributes["TEXCOORD_1"] = add_items(primitive.texcoord1, 5126, "VEC2");
    if (!primitive.colors.empty())
        attributes["COLOR_0"] = add_items(primitive.colors, 5126, "VEC4");
    if (!primitive.indices.empty()) out["indices"] = add_items(primitive.indices, 5125, "SCALAR");
    if (primitive.material >= 0) out["material"] = primitive.material;
    root["meshes"].push_back({{"primitives", json::array({out})}});
    return static_cast<int>(root["meshes"].size()) - 1;
}

int GlbWriter::add_node(int mesh) {
    const int node = static_cast<int>(root["nodes"].size());
    root["nodes"].push_back({{"mesh", mesh}});
    root["scenes"][0]["nodes"].push_back(node);
    return node;
}

int GlbWriter::add_png(std::span<const std::byte> png) {
    root["images"].push_back({{"bufferView", add_view(png)}, {"mimeType", "image/png"}});
    root["textures"].push_back({{"source", root["images"].size() - 1}});
    return static_cast<int>(root["textures"].size()) - 1;
}

int GlbWriter::add_material(const json& material) {
    root["materials"].push_back(material);
    return static_cast<int>(root["materials"].size()) - 1;
}

std::vector<std::byte> GlbWriter::glb() const {
    json document = root;
    if (!binary_.empty() && !document.contains("buffers"))
        document["buffers"] = {{{"byteLength", binary_.size()}}};
    const std::string text = document.dump();
    std::vector<std::byte> json_chunk;
    append(json_chunk, std::as_bytes(std::span(text)));
    pad(json_chunk, ' ');
    std::vector<std::byte> binary_chunk = binary_;
    pad(binary_chunk, '\0');

    std::vector<std::byte> out;
    append_word(out, 0x46546C67);
    append_word(out, 2);
    append_word(out, 12 + 8 + json_chunk.size() + 8 + binary_chunk.size());
    append_word(out, json_chunk.size());
    append_word(out, 0x4E4F534A);
    append(out, json_chunk);
    append_word(out, binary_chunk.size());
    append_word(out, 0x004E4942);
    append(out, binary_chunk);
    return out;
}

std::string GlbWriter::gltf(const std::string& buffer_uri) const {
    json document = root;
    document["buffers"] = {{{"byteLength", binary_.size()}, {"uri", buffer_uri}}};
    return document.dump(1);
}

TemporaryFolder::TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "burnish-test-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path TemporaryFolder::write(const std::string& name,
                                             std::span<const std::byte> bytes) const {
    const auto file_path = path_ / name;
    std::filesystem::create_directories(file_path.parent_path());
    std::ofstream file(file_path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    return file_path;
}

std::filesystem::path TemporaryFolder::write(const std::string& name, std::string_view text) const {
    return write(name, std::as_bytes(std::span(text.data(), text.size())));
}

std::vector<std::byte> png_gradient(int width, int height) {
    Image image(width, height, 3);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            float* texel = image.at(x, y);
            texel[0] = static_cast<float>(x % 256) / 255.0f;
            texel[1] = static_cast<float>(y % 256) / 255.0f;
            texel[2] = static_cast<float>((x + y) % 256) / 255.0f;
        }
    }
    return png_of(image);
}

std::vector<std::byte> png_noise(int width, int height, unsigned seed) {
    // A smooth ramp with two bits of noise compresses about as well as a painted texture.
    Image image(width, height, 3);
    std::minstd_rand random(seed + 1);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const auto noise = static_cast<int>(random() >> 8) & 3;
                image.at(x, y)[c] = static_cast<float>(64 + (x + c * y) / 64 + noise) / 255.0f;
            }
        }
    }
    return png_of(image);
}

GlbPrimitive unit_square(int cells, bool with_tangents) {
    GlbPrimitive square;
    const auto step = 1.0f / static_cast<float>(cells);
    for (int y = 0; y <= cells; ++y) {
        for (int x = 0; x <= cells; ++x) {
            const glm::vec2 p(static_cast<float>(x) * step, static_cast<float>(y) * step);
            square.positions.emplace_back(p, 0.0f);
            square.normals.emplace_back(0.0f, 0.0f, 1.0f);
            square.texcoord0.emplace_back(p.x, 1.0f - p.y);
            if (with_tangents) square.tangents.emplace_back(1.0f, 0.0f, 0.0f, 1.0f);
        }
    }
    const auto row = static_cast<std::uint32_t>(cells + 1);
    for (std::uint32_t y = 0; y + 1 < row; ++y) {
        for (std::uint32_t x = 0; x + 1 < row; ++x) {
            const std::uint32_t a = y * row + x;
            for (const std::uint32_t i : {a, a + 1, a + row, a + 1, a + row + 1, a + row})
                square.indices.push_back(i);
        }
    }
    return square;
}

}  // namespace burnish
