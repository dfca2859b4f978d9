// Build step: writes the assembled stages, in both dialects and in variants of every kind, into the
// folder argv[1] for glslang to check.
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "burnish/f32.hpp"
#include "gpu/device/shader_source.hpp"
#include "gpu/draw/surface_variant.hpp"

namespace burnish::gpu {
namespace {

SurfaceVariant with_everything() {
    SurfaceVariant v;
    v.method = Method::follow_grain;
    v.lobe_from_texture = v.base_color_map = v.metallic_roughness_map = v.normal_map = true;
    v.occlusion_map = v.emissive_map = v.anisotropy_map = v.turned = true;
    v.lights = 16;
    v.position = true;
    v.image_light = 1;
    v.shadow_maps = 24;
    v.visibility = true;
    return v;
}

// Coats, sheen and specular factors over every kind of surface, under every light.
void add_layered(std::vector<SurfaceVariant>& list) {
    for (int image_light = 0; image_light < 4; ++image_light) {
        for (int kind = 0; kind < 4; ++kind) {
            SurfaceVariant v = kind == 0 ? with_everything() : SurfaceVariant();
            v.method = Method::follow_grain;
            v.normal_map = kind == 1;
            v.cloth = kind == 2;
            v.tabulated = kind == 3;
            v.turned = kind > 1;
            v.metal = kind == 1;
            v.compensated = kind < 2;
            if (kind == 3) v.brdf = Brdf::microfacet_separable;
            v.lights = 2;
            v.image_light = image_light;
            v.coat = (kind + image_light) % 3 != 0;
            v.sheen = (kind + image_light) % 3 != 1;
            v.coat_tint = v.coat && kind % 2 == 0;
            v.coat_normal_map = v.coat && image_light % 2 == 1;
            v.coat_normal_moments = v.coat_normal_map && kind == 0;
            v.coat_normal_map_xy = v.coat_normal_map && kind == 1;
            v.coat_map = v.coat_roughness_map = v.coat && kind == 0;
            v.sheen_color_map = v.sheen_roughness_map = v.sheen && kind == 0;
            v.specular_factors = kind != 1;
            v.specular_map = v.specular_color_map = kind == 0;
            v.uv_per_texture = kind == 0 && image_light == 2;
            list.push_back(v);
            if (image_light != 1) continue;
            v.view = v.furnace = true;
            list.push_back(v);
        }
    }
}

// Every method with one lobe, every lobe with one method, and both values of every switch.
std::vector<SurfaceVariant> variants() {
    std::vector<SurfaceVariant> list;
    for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
        SurfaceVariant v;
        v.method = static_cast<Method>(method);
        v.normal_map = true;
        v.normal_moments = method % 2 == 1;
        v.conserve = method % 2 == 0;
        v.compensated = method % 3 != 0;
        v.lights = 1;
        v.image_light = 1;
        list.push_back(v);
        v.image_light = 3;
        list.push_back(v);
        v.image_light = method % 2;
        v.area_lights = 1 + method % 2;
        v.shadow_maps = method % 3;
        v.lights = method % 2;
        v.area_textures = method % 2 == 0;
        v.position = true;
        list.push_back(v);
    }
    for (int brdf = 0; brdf < static_cast<int>(brdf_names().size()); ++brdf) {
        for (int mdf = 0; mdf < static_cast<int>(mdf_names().size()); ++mdf) {
            SurfaceVariant v;
            v.brdf = static_cast<Brdf>(brdf);
            v.mdf = static_cast<Mdf>(mdf);
            v.image_light = mdf;
            v.lights = mdf;
            v.conductor = v.metal = mdf % 2 == 1;
            v.compensated = f32::brdf_masks(brdf);
            v.area_lights = mdf > 1 ? mdf : 0;
            v.position = true;
            v.fresnel_curve = v.conductor && brdf % 2 == 0;
            list.push_back(v);
        }
    }
    for (const Brdf brdf : {Brdf::microfacet, Brdf::ashikhmin_shirley, Brdf::lafortune}) {
        for (int image_light = 0; image_light < 4; ++image_light) {
            SurfaceVariant v;
            v.brdf = brdf;
            v.method = Method::follow_grain;
            v.cloth = v.turned = true;
            v.cloth_colors = v.metal = image_light % 2 == 1;
            v.lights = image_light;
            v.image_light = image_light;
            v.view = image_light == 3;
            v.visibility = image_light > 1;
            v.area_lights = image_light > 1 ? 1 : 0;
            v.position = true;
            list.push_back(v);
            if (image_light != 1) continue;
            v.view = v.furnace = true;
            list.push_back(v);
        }
    }
    for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
        SurfaceVariant v = method % 2 == 0 ? with_everything() : SurfaceVariant();
        v.method = static_cast<Method>(method);
        v.tabulated = v.turned = true;
        v.lobe_from_texture = v.base_color_map = v.metallic_roughness_map = false;
        v.anisotropy_map = false;
        v.image_light = method % 2 == 0 ? 1 : 0;
        v.lights = method;
        v.area_lights = method % 3;
        v.area_textures = method == 1;
        v.position = true;
        v.uv_per_texture = method == 4;
        v.view = method == 6;
        v.furnace = v.view && v.image_light == 1;
        list.push_back(v);
    }
    SurfaceVariant v = with_everything();
    list.push_back(v);
    for (int mdf = 0; mdf < static_cast<int>(mdf_names().size()); ++mdf) {
        v.mdf = static_cast<Mdf>(mdf);
        v.normal_moments = true;
        list.push_back(v);
    }
    v.view = true;
    list.push_back(v);
    v.furnace = true;
    list.push_back(v);
    v.view = v.furnace = false;
    v.normal_moments = false;
    v.uv_per_texture = v.vertex_color = v.normal_map_xy = true;
    v.alpha_mode = AlphaMode::mask;
    list.push_back(v);
    v.alpha_mode = AlphaMode::blend;
    v.image_light = 2;
    list.push_back(v);
    v.image_light = 3;
    list.push_back(v);
    add_layered(list);
    return list;
}

class Writer {
  public:
    explicit Writer(std::filesystem::path folder) : folder_(std::move(folder)) {}

    void write(ShaderDialect dialect, const std::string& defines, const std::string& stage) {
        const bool es = dialect == ShaderDialect::es300;
        const std::filesystem::path file =
            folder_ / ((es ? "es_" : "gl_") + std::to_string(count_++) + "_" + stage);
        std::ofstream out(file, std::ios::binary);
        out << assemble_stage(dialect, defines, "shaders/" + stage).text;
        out.close();
        if (!out) throw std::runtime_error("cannot write " + file.string());
    }

  private:
    std::filesystem::path folder_;
    int count_ = 0;
};

// The stages that are compiled with #defines, and their #defines; other stages are compiled
// without.
const std::map<std::string, std::vector<std::string>> kDefines = {
    {"ground.vert",
     {"#define LIGHTS 0\n#define POSITION\n", "#define LIGHTS 2\n#define POSITION\n"}},
    {"ground.frag",
     {"#define LIGHTS 0\n#define POSITION\n", "#define LIGHTS 2\n#define POSITION\n"}},
    {"ground_add.frag",
     {"#define LIGHTS 0\n#define POSITION\n", "#define LIGHTS 2\n#define POSITION\n"}},
    {"stand_in.frag",
     {"#define LIGHTS 16\n#define LIGHT_COUNT_AT_RUN_TIME\n#define POSITION\n",
      "#define LIGHTS 16\n#define LIGHT_COUNT_AT_RUN_TIME\n#define POSITION\n#define "
      "LIT_BY_ENVIRONMENT\n"}},
    {"gouraud.vert",
     {"#define LIGHTS 0\n", "#define LIGHTS 2\n", "#define LIGHTS 2\n#define POSITION\n"}},
    {"gbuffer.frag",
     {"", "#define SHAPE\n", "#define VISIBILITY\n",
      "#define POSITION\n#define SHAPE\n#define DOUBLE_SIDED\n"}},
};

bool is_of_variants(const std::string& stage) {
    return stage == "surface.frag" || stage == "surface.vert" || stage == "resolve.frag";
}

// All stages of shaders/. A new stage needs no entry here.
std::vector<std::string> stages() {
    std::vector<std::string> names;
    for (const ShaderText& text : shader_texts()) {
        const std::string name(text.name.substr(text.name.rfind('/') + 1));
        if (name.ends_with(".vert") || name.ends_with(".frag")) names.push_back(name);
    }
    return names;
}

void write_all(Writer& writer) {
    for (const ShaderDialect dialect : {ShaderDialect::gl330, ShaderDialect::es300}) {
        for (const SurfaceVariant& v : variants()) {
            writer.write(dialect, v.defines(), "surface.frag");
            writer.write(dialect, v.defines(), "surface.vert");
            if (v.can_resolve()) writer.write(dialect, v.defines(), "resolve.frag");
        }
        for (const std::string& stage : stages()) {
            if (is_of_variants(stage)) continue;
            const auto found = kDefines.find(stage);
            if (found == kDefines.end()) {
                writer.write(dialect, "", stage);
                continue;
            }
            for (const std::string& defines : found->second) writer.write(dialect, defines, stage);
        }
    }
}

}  // namespace
}  // namespace burnish::gpu

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: assemble_shaders <folder>\n";
        return 2;
    }
    try {
        burnish::gpu::Writer writer{argv[1]};
        burnish::gpu::write_all(writer);
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
    return 0;
}
