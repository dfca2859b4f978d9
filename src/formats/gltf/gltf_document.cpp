#include "formats/gltf/gltf_document.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "burnish/error.hpp"
#include "formats/gltf/gltf_extensions.hpp"
#include "formats/gltf/gltf_schema.hpp"

namespace burnish {
namespace {

using nlohmann::json;

// glTF needs about ten levels. The parsers called later recurse, so the stack sets the limit.
constexpr int kDeepestJson = 64;
// A parsed value takes tens to hundreds of bytes. The largest real files (a hundred thousand nodes
// with matrices) have two million values.
constexpr std::size_t kMostValues = 4'000'000;

// Checks depth and number of values in one pass over the text, before any parser reads it.
void check_nesting(std::string_view text, const GltfReport& report) {
    int depth = 0;
    std::size_t values = 1;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                in_string = false;
            continue;
        }
        if (c == '"') {
            in_string = true;
        } else if (c == '[' || c == '{') {
            if (++depth > kDeepestJson)
                report.fail("JSON", fmt::format("at most {} levels", kDeepestJson),
                            "deeper nesting");
            ++values;
        } else if (c == ']' || c == '}') {
            --depth;
        } else if (c == ',' && ++values > kMostValues) {
            report.fail("JSON", fmt::format("at most {} values", kMostValues), "more");
        }
    }
}

json parse_json(std::string_view text, const GltfReport& report) {
    check_nesting(text, report);
    try {
        return json::parse(text);
    } catch (const json::exception& exception) {
        // Removes the prefix of messages such as "[json.exception.parse_error.101] parse error at
        // line 1, column 2: ...".
        std::string_view reason = exception.what();
        if (const auto end = reason.find("] "); end != std::string_view::npos)
            reason.remove_prefix(end + 2);
        std::string line;
        for (const char c : reason.substr(0, 200)) {
            const auto byte = static_cast<unsigned char>(c);
            line.push_back(byte < 0x20 || byte >= 0x7F ? ' ' : c);
        }
        report.fail("JSON", "well-formed JSON", line);
    }
}

// The checks of the schema come later: nothing is known of the types here.
std::map<std::size_t, std::string> extras_of_materials(const json& root) {
    std::map<std::size_t, std::string> found;
    const auto materials = root.find("materials");
    if (materials == root.end() || !materials->is_array()) return found;
    for (std::size_t i = 0; i < materials->size(); ++i) {
        const json& material = (*materials)[i];
        if (!material.is_object()) continue;
        const auto extras = material.find("extras");
        if (extras == material.end() || !extras->is_object() || !extras->contains("burnish"))
            continue;
        // Texts that are not UTF-8 have been refused by the parser.
        found[i] = extras->at("burnish").dump();
    }
    return found;
}

// Removes values that are never read and could have any size. The depth is checked before.
void prune(json& value) {
    if (value.is_object()) {
        value.erase("extras");
        if (const auto it = value.find("extensions"); it != value.end() && it->is_object()) {
            for (auto extension = it->begin(); extension != it->end();)
                extension = is_gltf_extension_read(extension.key()) ? std::next(extension)
                                                                    : it->erase(extension);
        }
    }
    if (value.is_structured())
        for (json& item : value) prune(item);
}

void check_version(const json& root, const GltfReport& report) {
    const auto& asset = root.at("asset");
    const auto& version = asset.at("version").get_ref<const std::string&>();
    if (!version.starts_with("2.")) report.fail("asset.version", "2.0", shown(version));
    if (const auto it = asset.find("minVersion"); it != asset.end() && *it != "2.0")
        report.fail("asset.minVersion", "2.0", shown(it->get_ref<const std::string&>()));
}

std::vector<std::string> texts(const json& root, const char* key) {
    return root.value(key, std::vector<std::string>());
}

void take_buffers(json& root, GltfDocument& document) {
    const auto it = root.find("buffers");
    if (it == root.end()) return;
    for (const json& entry : *it) {
        GltfBuffer& buffer = document.buffers.emplace_back();
        buffer.byte_length = entry.at("byteLength").get<std::uint64_t>();
        buffer.has_uri = entry.contains("uri");
        buffer.uri = entry.value("uri", "");
        buffer.fallback =
            entry.value("/extensions/EXT_meshopt_compression/fallback"_json_pointer, false);
    }
    root.erase(it);
}

void take_images(json& root, GltfDocument& document, const GltfReport& report) {
    const auto it = root.find("images");
    if (it == root.end()) return;
    for (const json& entry : *it) {
        GltfImage& image = document.images.emplace_back();
        image.uri = entry.value("uri", "");
        image.buffer_view = entry.value("bufferView", -1);
        if (!image.uri.empty() && image.buffer_view >= 0)
            report.fail(fmt::format("images[{}]", document.images.size() - 1),
                        "either uri or bufferView", "both");
    }
    root.erase(it);
}

// WebP and AVIF versions stand before the PNG or JPEG: the file's author prefers them where they can
// be read.
void take_textures(const json& root, GltfDocument& document) {
    const auto it = root.find("textures");
    if (it == root.end()) return;
    for (const json& entry : *it) {
        const std::string key = fmt::format("textures[{}]", document.textures.size());
        GltfTexture& texture = document.textures.emplace_back();
        const json extensions = entry.value("extensions", json::object());
        for (const auto& [name, extension] : extensions.items()) {
            const int source = extension.value("source", -1);
            if (source < 0) continue;
            if (name == "EXT_texture_webp" || name == "EXT_texture_avif")
                texture.versions.push_back(
                    {source, fmt::format("{}.extensions.{}.source", key, name)});
            else if (name == "KHR_texture_basisu" || name == "MSFT_texture_dds")
                texture.unread = name;
        }
        if (const int source = entry.value("source", -1); source >= 0)
            texture.versions.push_back({source, key + ".source"});
    }
}

// tinygltf does not see that primitives are compressed: it refuses indices without a buffer view,
// and a build of it with a decoder would decode them.
void take_draco(json& root, GltfDocument& document) {
    const auto meshes = root.find("meshes");
    if (meshes == root.end()) return;
    for (std::size_t i = 0; i < meshes->size(); ++i) {
        json& primitives = (*meshes)[i]["primitives"];
        for (std::size_t k = 0; k < primitives.size(); ++k) {
            const auto extensions = primitives[k].find("extensions");
            if (extensions == primitives[k].end()) continue;
            const auto it = extensions->find("KHR_draco_mesh_compression");
            if (it == extensions->end()) continue;
            GltfDraco& draco = document.draco[{i, k}];
            draco.buffer_view = it->at("bufferView").get<int>();
            draco.attributes = it->at("attributes").get<std::map<std::string, int>>();
            draco.indices = primitives[k].value("indices", -1);
            primitives[k].erase("indices");
            extensions->erase(it);
        }
    }
}

// Removes animations, skins and morph targets, which are not read.
void drop_motion(json& root, GltfReport& report) {
    if (root.erase("animations") > 0) report.warn("animations are not played");
    if (root.erase("skins") > 0)
        report.warn("skins are not applied: skinned meshes keep their stored shape");
    const auto meshes = root.find("meshes");
    if (meshes == root.end()) return;
    for (json& mesh : *meshes) {
        mesh.erase("weights");
        for (json& primitive : mesh.at("primitives")) {
            if (primitive.erase("targets") > 0)
                report.warn("morph targets are not applied: meshes keep their base shape");
        }
    }
}

std::shared_ptr<tinygltf::Model> parse_model(const json& root, const GltfReport& report) {
    const std::string text = root.dump();
    if (text.size() > std::numeric_limits<unsigned>::max())
        report.fail("JSON", "at most 4 GiB", fmt::format("{} bytes", text.size()));
    auto model = std::make_shared<tinygltf::Model>();
    tinygltf::TinyGLTF parser;
    std::string errors;
    std::string warnings;
    const bool parsed = parser.LoadASCIIFromString(model.get(), &errors, &warnings, text.data(),
                                                   static_cast<unsigned>(text.size()), "");
    if (parsed && errors.empty()) return model;
    report.fail("", "glTF 2.0", shown(errors.substr(0, errors.find('\n'))));
}

}  // namespace

GltfDocument parse_gltf_document(std::string_view json_text, GltfReport& report) {
    json root = parse_json(json_text, report);
    if (!root.is_object()) report.fail("JSON", "an object", "something else");
    GltfDocument document;
    document.extras = extras_of_materials(root);
    prune(root);
    check_gltf_schema(root, report);
    check_version(root, report);
    warn_of_unknown_gltf_keys(root, report);
    check_gltf_extensions(texts(root, "extensionsUsed"), texts(root, "extensionsRequired"), report);
    take_buffers(root, document);
    take_images(root, document, report);
    take_textures(root, document);
    take_draco(root, document);
    drop_motion(root, report);
    document.model = parse_model(root, report);
    return document;
}

}  // namespace burnish
