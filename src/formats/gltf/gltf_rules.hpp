// The shape of glTF's JSON as far as it is read, as tables: every key with its kind.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace burnish {

enum class GltfKind {
    any,
    object,
    objects,  // an array of objects
    text,
    texts,
    boolean,
    number,   // a number within the range of float
    numbers,  // an array of `count` numbers, of any length when 0
    index,    // 0 .. 2^31-1: indices, enumerants, and other values that tinygltf stores in an int
    indices,
    index_map,
    size,  // 0 .. 2^63-1
    list,
};

struct GltfRule {
    std::string_view where;  // path of the object; "[]" after a name: every item of that array
    std::string_view key;
    GltfKind kind;
    bool required = false;
    std::size_t count = 0;
};

// Parents precede their children.
std::span<const GltfRule> gltf_rules();

// The paths of all textureInfo objects, and the rules of each, relative to it.
std::span<const std::string_view> gltf_texture_infos();
std::span<const GltfRule> gltf_texture_info_rules();

}  // namespace burnish
