// Writes DIR/<reader>/seed_<n> and DIR/<reader>.dict. Usage: fuzz_seeds DIR
#include "seeds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <span>

#include "burnish/brdf_models.hpp"
#include "burnish/parameters.hpp"
#include "burnish/shading_names.hpp"
#include "core/files.hpp"
#include "jobs/models/eval.hpp"
#include "support/bsdf_writer.hpp"

namespace burnish::fuzz {
namespace {

namespace fs = std::filesystem;

void append(Words& words, std::span<const std::string_view> more) {
    words.insert(words.end(), more.begin(), more.end());
}

const Words kGltfWords = {"accessors",
                          "alphaMode",
                          "alphaCutoff",
                          "asset",
                          "attributes",
                          "BLEND",
                          "buffer",
                          "bufferView",
                          "bufferViews",
                          "buffers",
                          "byteLength",
                          "byteOffset",
                          "byteStride",
                          "camera",
                          "cameras",
                          "children",
                          "COLOR_0",
                          "componentType",
                          "count",
                          "data:;base64,",
                          "doubleSided",
                          "extensions",
                          "extensionsRequired",
                          "extensionsUsed",
                          "EXPONENTIAL",
                          "EXT_mesh_gpu_instancing",
                          "EXT_meshopt_compression",
                          "EXT_texture_avif",
                          "EXT_texture_webp",
                          "fallback",
                          "filter",
                          "images",
                          "indices",
                          "KHR_draco_mesh_compression",
                          "KHR_lights_punctual",
                          "KHR_materials_anisotropy",
                          "KHR_materials_emissive_strength",
                          "KHR_materials_ior",
                          "KHR_materials_unlit",
                          "KHR_mesh_quantization",
                          "KHR_texture_transform",
                          "map.png",
                          "MASK",
                          "material",
                          "materials",
                          "matrix",
                          "mesh",
                          "meshes",
                          "mode",
                          "nodes",
                          "NORMAL",
                          "normalized",
                          "normalTexture",
                          "OCTAHEDRAL",
                          "OPAQUE",
                          "orthographic",
                          "pbrMetallicRoughness",
                          "perspective",
                          "POSITION",
                          "primitives",
                          "QUATERNION",
                          "range",
                          "rotation",
                          "samplers",
                          "scale",
                          "SCALAR",
                          "scene",
                          "scenes",
                          "source",
                          "sparse",
                          "spot",
                          "TANGENT",
                          "targets",
                          "TEXCOORD_0",
                          "TEXCOORD_1",
                          "textures",
                          "translation",
                          "uri",
                          "values",
                          "VEC2",
                          "VEC3",
                          "VEC4",
                          "version",
                          "5120",
                          "5121",
                          "5122",
                          "5123",
                          "5125",
                          "5126",
                          "2147483647",
                          "9223372036854775807",
                          "1e38",
                          "-1",
                          "null",
                          "true"};

const Words kObjWords = {"v ",
                         "vt ",
                         "vn ",
                         "f ",
                         "s off\n",
                         "s 1\n",
                         "g a\n",
                         "o b\n",
                         "usemtl m\n",
                         "mtllib model.mtl\n",
                         "\n#mtl\n",
                         "newmtl m\n",
                         "Kd ",
                         "Ks ",
                         "Ke ",
                         "Ns ",
                         "Ni ",
                         "d ",
                         "Tr ",
                         "Pr ",
                         "Pm ",
                         "aniso ",
                         "anisor ",
                         "illum 2\n",
                         "map_Kd map.png\n",
                         "map_Ke map.png\n",
                         "norm -bm 1 map.png\n",
                         "-s 2 2 2 ",
                         "-o 1 1 1 ",
                         "-clamp on ",
                         "-mm 0 1 ",
                         "//",
                         "1/1/1 ",
                         "-1 ",
                         "nan ",
                         "inf ",
                         "1e39 ",
                         "2147483648 ",
                         "-2147483648 ",
                         "\\\n",
                         "l 1 2\n",
                         "curv ",
                         "vp ",
                         "vw ",
                         "t a 1/1/1 1\n"};

const Words kSceneWords = {
    "format",         "version",        "objects",     "materials", "lights",     "environment",
    "parameters",     "model",          "material",    "translate", "rotate_deg", "scale",
    "type",           "color",          "intensity",   "direction", "position",   "range",
    "inner_cone_deg", "outer_cone_deg", "directional", "point",     "spot",       "builtin:plane",
    "builtin:studio", "none",           "map.png",     "part.obj",  "part.gltf",  "#7a1f2b",
    "1e400",          "-1e-46",         "1e6",         "null",      "true",       "\\u0000",
    "\xEF\xBB\xBF"};

const Words kScratchWords = {"format",
                             "burnish-scratch",
                             "version",
                             "size",
                             "tile_mm",
                             "seed",
                             "wear_mask",
                             "direction_image",
                             "direction_is_double_angle",
                             "layers",
                             "made",
                             "count",
                             "density_per_cm2",
                             "length_mm",
                             "width_mm",
                             "depth_mm",
                             "curvature_per_mm",
                             "taper",
                             "profile",
                             "direction",
                             "angle_deg",
                             "range_deg",
                             "placement",
                             "passes",
                             "uniform:",
                             "normal:",
                             "lognormal:",
                             "round",
                             "burr",
                             "constant",
                             "circular",
                             "radial",
                             "image",
                             "random",
                             "even",
                             "1e308",
                             "-1e9",
                             "null",
                             "true"};

Words scene_words() {
    Words words = kSceneWords;
    for (const Parameter& parameter : parameter_table()) {
        words.emplace_back(parameter.name);
        append(words, parameter.choices);
    }
    return words;
}

Words csv_words() {
    Words words = {"mdf,p0,p1,method,nx,ny,nz,hx,hy,hz\n",
                   "brdf,",
                   "p0,",
                   "p1,",
                   "p2,",
                   "p3,",
                   "p4,",
                   "ix,iy,iz,ox,oy,oz",
                   "smith",
                   "D",
                   "D_proj",
                   "f",
                   "\r\n",
                   "\"\"",
                   "#",
                   "1e308",
                   "1e-320",
                   "-0",
                   "nan",
                   "inf",
                   "0x1p3",
                   "1e-160",
                   "\xEF\xBB\xBF"};
    append(words, mdf_names());
    append(words, method_names());
    append(words, smith_names());
    append(words, brdf_table_names());
    return words;
}

// A table with every model or every method once.
Words csv_seeds() {
    std::string mdf = "mdf,p0,p1,method,nx,ny,nz,hx,hy,hz\n", single = mdf;
    for (const std::string_view name : mdf_names())
        for (const std::string_view method : method_names())
            mdf += fmt::format("{},.1,.4,{},.1,.2,.9,.3,.1,.8\n", name, method);
    std::string brdf = "# models\r\nbrdf,ix,iy,iz,ox,oy,oz,p0,p1,p2,p3,p4,mdf,smith,\"a,b\"\r\n";
    for (const BrdfModel& model : brdf_models()) {
        brdf += fmt::format("{},.1,.2,.9,.3,.1,.8", model.name);
        for (std::size_t i = 0; i < kMostBrdfParameters; ++i)
            brdf += i < model.parameters.size()
                        ? fmt::format(",{}", 0.5 * model.parameters[i].low +
                                                 0.5 * std::min(1.0, model.parameters[i].high))
                        : ",";
        brdf += ",,,\"x\"\"y\"\r\n";
    }
    single += "ggx,.1,.4,follow-grain,0,0,1,0,0,1";
    Words seeds;
    for (const char kind : {'\0', '\2'}) {
        seeds.push_back(kind + mdf);
        seeds.push_back(kind + single);
    }
    for (const char kind : {'\1', '\3'}) {
        seeds.push_back(kind + brdf);
        seeds.push_back(kind +
                        std::string("brdf,ix,iy,iz,ox,oy,oz,p0,p1,p2,mdf,smith\n"
                                    "microfacet,.1,.2,.9,.3,.1,.8,.1,.4,.5,ggx,separable\n"));
    }
    seeds.push_back("\xC0ix,iy,iz,ox,oy,oz,f\n0,0,1,.6,0,.8,2.5\n0,.6,.8,0,0,1.0004,0\n");
    return seeds;
}

Words obj_seeds() {
    const std::string cube =
        "mtllib model.mtl\no cube\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\n"
        "vt 1 1\nvn 0 0 1\nusemtl metal\ns 1\nf 1/1/1 2/2/1 3/3/1 4/1/1\nusemtl cloth of gold\n"
        "s off\nf 1//1 2//1 5//1\nf -1 -2 -3\nl 1 2\n";
    const std::string library =
        "\n#mtl\nnewmtl metal\nKd .1 .2 .3\nKs 1 1 1\nNs 20\nPr .3\nPm 1\naniso .5\nanisor .25\n"
        "map_Kd -s 2 2 1 -o .5 0 0 map.png\nnorm -bm .5 map.png\nmap_Ke map.png\n"
        "newmtl cloth of gold\nKd 1 1 0\nd .5\nKe 0 1 2\n";
    const std::string exported =
        "\n#mtl\nnewmtl metal\nKD 0 0 0\nillum 2\nTf 1 1 1\nmap_Kd C:\\x\\MAP.PNG\n"
        "map_Bump map.png -bm 1\nmap_Pr -imfchan g map.tga\nmap_Pm \"map.png\"\nmap_d map.png\n"
        "newmtl cloth of gold\nbump -s 2 -o .5 map.png\nmap_aniso map.png\nPc .5\n";
    const std::string far =
        "mtllib other.mtl\nv 447321.5 5411826.25 412\nv 447322.5 5411826.25 412\n"
        "v 447321.5 5411827.25 412\nvt 0 0\nf 1/1 2/1 3/1\n";
    return {cube + library, cube + exported, far, cube,
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 \\\n0\nf 1 2 4 3\n"};
}

Words scene_seeds() {
    Words seeds;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::path(BURNISH_SOURCE_DIR) / "examples" / "scenes")) {
        std::string text = read_text_file(entry.path());
        // Nothing that is large (see fuzz_scene.cpp).
        for (const std::string_view name : {"sphere", "cylinder", "torus", "drape"})
            if (const auto at = text.find(name); at != text.npos)
                text.replace(at, name.size(), "plane");
        if (const auto at = text.find("builtin:bumps"); at != text.npos)
            text.replace(at, 13, "map.png");
        seeds.push_back(std::move(text));
    }
    const std::string head = R"({"format":"burnish-scene","version":1,)";
    seeds.push_back(
        head +
        R"("objects":[{"model":"part.obj","material":"a","translate":[1,2,3],"rotate_deg":[4,5,6],)"
        R"("scale":[1,2,3]},{"model":"part.gltf","scale":2}],"materials":{"a":{"alpha_x":0.1,)"
        R"("alpha_y":0.4,"normal_map":"map.png","uv_scale":2,"flip_green":true,"metal":"iron",)"
        R"("oxide":40}},)"
        R"("parameters":{"base_color":[0.1,0.2,0.3],"camera_position":[1,2,3]}})");
    seeds.push_back(
        head +
        R"("objects":[{"model":"builtin:plane"}],"environment":"sky.exr","lights":[{"type":"spot",)"
        R"("position":[1,2,3],"range":4,"direction":[0,0,-1],"inner_cone_deg":5,)"
        R"("outer_cone_deg":30,"color":"#ffeedd","intensity":7},{"type":"point",)"
        R"("position":[0,1,0]},{"type":"directional","direction":[0,-1,0]}]})");
    return seeds;
}

Words scratch_seeds() {
    return {
        R"({"format":"burnish-scratch","version":1,"size":64,"tile_mm":50,"seed":7,"layers":[)"
        R"({"count":10,"length_mm":"lognormal:5:0.6","width_mm":0.1,"depth_mm":"uniform:0.01:0.02",)"
        R"("curvature_per_mm":"normal:0.1:0.01","taper":0.5,"profile":"burr","direction":"radial",)"
        R"("angle_deg":10,"range_deg":20}]})",
        R"({"format":"burnish-scratch","version":1,"wear_mask":"map.png","direction_image":)"
        R"("map.png","direction_is_double_angle":true,"layers":[{"density_per_cm2":3,"profile":"v",)"
        R"("direction":"constant","placement":"even","passes":4}],"made":{"version":"0"}})"};
}

// Small enough for many in a second: isotropic, anisotropic by symmetry, spectral.
Words bsdf_seeds() {
    test::KnownMaterial material;
    material.normals = 6;
    material.samples = 3;
    material.thetas = 2;
    Words seeds = {material.text()};
    material.phis = 3;
    material.symmetry = 4;
    seeds.push_back(material.text());
    material.phis = 1;
    material.wavelengths = {400, 500, 600, 700};
    seeds.push_back(material.text());
    return seeds;
}

const Words kBsdfWords = {"description",
                          "phi_i",
                          "theta_i",
                          "sigma",
                          "ndf",
                          "vndf",
                          "rgb",
                          "spectra",
                          "luminance",
                          "wavelengths",
                          "jacobian",
                          "valid",
                          "version",
                          {"tensor_file\0\1\0", 14},
                          {"\0\0\x80\x7F", 4},      // infinity
                          {"\0\0\xC0\x7F", 4},      // not a number
                          {"\xDB\x0F\xC9\x3F", 4},  // pi / 2
                          {"\0\0\0\x80\0\0\0\0", 8}};

Words wif_seeds() {
    Words seeds;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::path(BURNISH_SOURCE_DIR) / "examples" / "weaves"))
        seeds.push_back(read_text_file(entry.path()));
    seeds.push_back(
        "[WIF]\r\nVersion=1.1\r\n[WEAVING]\nShafts=2\nTreadles=2\nRising Shed=no\nProfile=yes\n"
        "[WARP]\nThreads=2\nColor=1,0,0,0\nUnits=Inches\nSpacing=.1\nThickness=.1\n"
        "[WEFT]\nThreads=2\nUnits=Decipoints\nSpacing=72\n[WARP SPACING]\n1=.2\n"
        "[WEFT THICKNESS]\n2=1.5\n[COLOR PALETTE]\nEntries=1\nRange=-5,5\n[COLOR TABLE]\n"
        "1=0,-5,5\n[THREADING]\n1=1,2\n2=0\n[TIEUP]\n1=1\n2=2\n[TREADLING]\n1=1\n2=1,2\n"
        "[LIFTPLAN]\n1=1\n2=1,2\n[PRIVATE X]\nanything\n");
    // Rows beyond the counts, a repeat, yarns on no shaft, values that are not drawn.
    seeds.push_back(
        "[WIF]\n[WEAVING]\nShafts=2\nTreadles=2\nRising Shed=1\n[WARP]\nThreads=600\nColor=7\n"
        "Spacing=0,2\n[WEFT]\nThreads=6\n[WARP SPACING]\n3=\n[COLOR PALETTE]\nRange=0,1\n"
        "[COLOR TABLE]\n1=0,1,0\n[THREADING]\n2=1\n3=2\n4=1\n5=2\n700=1\n[TIEUP]\n1=1\n2=2\n"
        "3=1,2\n9=x\n[TREADLING]\n2=1\n3=3\n4=1\n5=3\n9=4\n[LIFTPLAN]\n1=0\n2=\n");
    return seeds;
}

const Words kWifWords = {"[WIF]\n",
                         "[CONTENTS]\n",
                         "[TEXT]\nTitle=",
                         "[WEAVING]\n",
                         "[WARP]\n",
                         "[WEFT]\n",
                         "[THREADING]\n",
                         "[TIEUP]\n",
                         "[TREADLING]\n",
                         "[LIFTPLAN]\n",
                         "[COLOR PALETTE]\n",
                         "[COLOR TABLE]\n",
                         "[WARP COLORS]\n",
                         "[WEFT COLORS]\n",
                         "[WARP SPACING]\n",
                         "[WEFT THICKNESS]\n",
                         "Shafts=",
                         "Treadles=",
                         "Rising Shed=",
                         "Threads=",
                         "Threads=4096\n",
                         "Color=",
                         "Entries=",
                         "Form=RGB\n",
                         "Range=0,255\n",
                         "Units=Centimeters\n",
                         "Spacing=",
                         "Thickness=",
                         "4096",
                         "-1",
                         "99999999999999999999",
                         "1e308",
                         "nan",
                         ";",
                         ",,",
                         "yes\n",
                         "\xEF\xBB\xBF",
                         "\xFF\xFE",
                         "\x1A"};

std::string escaped(std::string_view word) {
    std::string text;
    for (const char c : word) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = byte >= 0x20 && byte < 0x7F && c != '"' && c != '\\';
        text += plain ? std::string(1, c) : fmt::format("\\x{:02X}", byte);
    }
    return text;
}

void write(const fs::path& folder, const char* reader, const Words& seeds, const Words& words) {
    fs::create_directories(folder / reader);
    for (std::size_t i = 0; i < seeds.size(); ++i)
        write_text_file(folder / reader / fmt::format("seed_{:02}", i), seeds[i]);
    std::string dictionary;
    for (const std::string& word : words)
        if (!word.empty()) dictionary += '"' + escaped(word) + "\"\n";
    write_text_file(folder / fmt::format("{}.dict", reader), dictionary);
}

}  // namespace
}  // namespace burnish::fuzz

int main(int count, char** arguments) {
    using namespace burnish::fuzz;
    if (count != 2) {
        std::fputs("usage: fuzz_seeds DIR\n", stderr);
        return EXIT_FAILURE;
    }
    try {
        const fs::path folder = arguments[1];
        write(folder, "gltf", gltf_seeds(), kGltfWords);
        write(folder, "obj", obj_seeds(), kObjWords);
        write(folder, "scene", scene_seeds(), scene_words());
        write(folder, "csv", csv_seeds(), csv_words());
        write(folder, "scratch", scratch_seeds(), kScratchWords);
        write(folder, "bsdf", bsdf_seeds(), kBsdfWords);
        write(folder, "tabulated", tabulated_seeds(), tabulated_words());
        write(folder, "image", image_seeds(), image_words());
        write(folder, "wif", wif_seeds(), kWifWords);
        write(folder, "rig", rig_seeds(), rig_words());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "fuzz_seeds: %s\n", error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
