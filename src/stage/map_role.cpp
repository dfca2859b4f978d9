#include "stage/map_role.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, kMapRoles> kNames = {"base color",
                                                            "normal",
                                                            "DirectX normal",
                                                            "roughness",
                                                            "glossiness",
                                                            "metallic",
                                                            "occlusion",
                                                            "anisotropy",
                                                            "height",
                                                            "emissive",
                                                            "opacity",
                                                            "occlusion-roughness-metallic",
                                                            "metallic-occlusion-smoothness",
                                                            "metallic-roughness",
                                                            "metallic-smoothness",
                                                            "occlusion-roughness"};

struct Word {
    std::string_view text;
    MapRole role;
};

// Words of ambientCG, Poly Haven, cgbookcase, Substance, Unity, Unreal, and of burnish's own folders.
// Several words of a name are compared as one: "Base_Color", "nor_gl", "AmbientOcclusion".
constexpr Word kWords[] = {
    {"basecolor", MapRole::base_color},
    {"basecolour", MapRole::base_color},
    {"albedo", MapRole::base_color},
    {"color", MapRole::base_color},
    {"colour", MapRole::base_color},
    {"col", MapRole::base_color},
    {"diffuse", MapRole::base_color},
    {"diff", MapRole::base_color},
    {"diffusecolor", MapRole::base_color},
    {"albedotransparency", MapRole::base_color},
    {"basecolortransparency", MapRole::base_color},
    {"basecoloralpha", MapRole::base_color},
    {"bc", MapRole::base_color},
    {"normal", MapRole::normal},
    {"normals", MapRole::normal},
    {"normalgl", MapRole::normal},
    {"normalogl", MapRole::normal},
    {"normalopengl", MapRole::normal},
    {"norgl", MapRole::normal},
    {"nor", MapRole::normal},
    {"norm", MapRole::normal},
    {"nrm", MapRole::normal},
    {"n", MapRole::normal},
    {"normaldx", MapRole::normal_directx},
    {"normaldirectx", MapRole::normal_directx},
    {"nordx", MapRole::normal_directx},
    {"roughness", MapRole::roughness},
    {"rough", MapRole::roughness},
    {"rgh", MapRole::roughness},
    {"r", MapRole::roughness},
    {"glossiness", MapRole::glossiness},
    {"gloss", MapRole::glossiness},
    {"smoothness", MapRole::glossiness},
    {"metallic", MapRole::metallic},
    {"metalness", MapRole::metallic},
    {"metal", MapRole::metallic},
    {"met", MapRole::metallic},
    {"mtl", MapRole::metallic},
    {"m", MapRole::metallic},
    {"ambientocclusion", MapRole::occlusion},
    {"occlusion", MapRole::occlusion},
    {"ao", MapRole::occlusion},
    {"orm", MapRole::orm},
    {"arm", MapRole::orm},
    {"occlusionroughnessmetallic", MapRole::orm},
    {"maskmap", MapRole::mask_map},
    {"ord", MapRole::occlusion_roughness},
    {"ordp", MapRole::occlusion_roughness},
    {"metallicsmoothness", MapRole::metallic_smoothness},
    {"metalsmoothness", MapRole::metallic_smoothness},
    {"metalnesssmoothness", MapRole::metallic_smoothness},
    {"metallicgloss", MapRole::metallic_smoothness},
    {"metallicglossmap", MapRole::metallic_smoothness},
    {"metallicglossiness", MapRole::metallic_smoothness},
    {"metallicroughness", MapRole::metallic_roughness},
    {"metalnessroughness", MapRole::metallic_roughness},
    {"metalroughness", MapRole::metallic_roughness},
    {"metalrough", MapRole::metallic_roughness},
    {"roughnessmetallic", MapRole::metallic_roughness},
    {"roughnessmetalness", MapRole::metallic_roughness},
    {"anisotropy", MapRole::anisotropy},
    {"height", MapRole::height},
    {"displacement", MapRole::height},
    {"disp", MapRole::height},
    {"bump", MapRole::height},
    {"emissive", MapRole::emissive},
    {"emission", MapRole::emissive},
    {"emit", MapRole::emissive},
    {"opacity", MapRole::opacity},
    {"alpha", MapRole::opacity},
    {"mask", MapRole::opacity},
};

// Packed maps that are not read, whose last word alone would state a role.
constexpr std::string_view kUnreadPacked[] = {
    "specularsmoothness", "specularglossiness",  "speculargloss",    "albedosmoothness",
    "albedoglossiness",   "basecolorsmoothness", "diffusesmoothness"};

char lower(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::optional<MapRole> role_of_word(std::string_view text) {
    for (const Word& word : kWords)
        if (word.text == text) return word.role;
    return std::nullopt;
}

}  // namespace

std::string_view map_role_name(MapRole role) {
    return kNames[static_cast<std::size_t>(role)];
}

std::optional<MapPacking> packing_of(MapRole role) {
    switch (role) {
        case MapRole::orm:
            return MapPacking{0, 1, -1, 2};
        case MapRole::mask_map:  // Unity's HDRP; blue masks details
            return MapPacking{1, -1, 3, 0};
        case MapRole::metallic_roughness:  // glTF
            return MapPacking{-1, 1, -1, 2};
        case MapRole::metallic_smoothness:  // Unity
            return MapPacking{-1, -1, 3, 0};
        case MapRole::occlusion_roughness:  // Megascans; blue is a displacement
            return MapPacking{0, 1, -1, -1};
        default:
            return std::nullopt;
    }
}

std::vector<std::string> words_of_name(const fs::path& file) {
    std::vector<std::string> words;
    const std::string name = file.stem().string();
    char before = '_';
    for (const char c : name) {
        const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
        const bool capital = c >= 'A' && c <= 'Z', small = before >= 'a' && before <= 'z';
        if (letter) {
            const bool starts = std::isalnum(static_cast<unsigned char>(before)) == 0;
            if (starts || (capital && small)) words.emplace_back();
            words.back().push_back(lower(c));
        }
        before = c;
    }
    return words;
}

bool is_size_word(const std::string& word) {
    const bool number = !word.empty() && is_digit(word.front());
    const std::size_t end = std::min(word.find_first_not_of("0123456789"), word.size());
    const std::string_view rest = std::string_view(word).substr(end);
    return number && (rest.empty() || rest == "k" || rest == "bit" || rest == "px");
}

std::optional<MapRole> map_role_of(const fs::path& file) {
    std::vector<std::string> words = words_of_name(file);
    while (!words.empty() && is_size_word(words.back())) words.pop_back();
    // The longest run of last words that is a role: "base", "color" before "color". Libraries put a
    // resolution, or a kind of normal map ("nor_gl_2k"), behind the role.
    for (std::size_t first = words.size() > 3 ? words.size() - 3 : 0; first < words.size();
         ++first) {
        std::string joined;
        for (std::size_t i = first; i < words.size(); ++i) joined += words[i];
        if (std::find(std::begin(kUnreadPacked), std::end(kUnreadPacked), joined) !=
            std::end(kUnreadPacked))
            return std::nullopt;
        // One letter is a role behind another word alone, as in "T_Rock_N".
        if (joined.size() == 1 && words.size() == 1) return std::nullopt;
        const auto role = role_of_word(joined);
        if (role == MapRole::normal && words.front() == "t" && !joined.ends_with("gl"))
            return MapRole::normal_directx;
        if (role) return role;
    }
    return std::nullopt;
}

}  // namespace burnish
