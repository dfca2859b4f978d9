// Values of every material parameter, and scenes with every kind of lobe.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "burnish/draft.hpp"
#include "burnish/image_io.hpp"
#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"
#include "burnish/tabulated_file.hpp"
#include "burnish/tabulated_material.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {

// One texel with D = 1/pi.
inline TabulatedMaterial even_table() {
    TabulatedMaterial m;
    m.grid = {4, 8};
    m.exemplars = 1;
    m.D.assign(32, 0.31831F);
    m.origin.assign(32, NdfOrigin::measured);
    m.groove = {0.0F};
    m.width = m.height = 1;
    m.exemplar = {0};
    m.angle = {0.0F};
    m.diffuse = m.specular = m.normal = Image(1, 1, 3);
    m.normal.pixels[2] = 1;
    return m;
}

// Files for parameters that name files, two of each kind: "flat0.png", "scratch0/", "table0.exr"
// ...
class ValueSamples {
  public:
    ValueSamples() {
        for (const char* number : {"0", "1"}) {
            const std::string n = number;
            write_image(folder_ / ("flat" + n + ".png"), Image(4, 4, 3, 0.5f), {});
            std::filesystem::create_directory(folder_ / ("scratch" + n));
            for (const char* map : {"/normal.png", "/anisotropy.png"})
                write_image(folder_ / ("scratch" + n + map), Image(4, 4, 3, 0.5f), {});
            std::filesystem::create_directory(folder_ / ("maps" + n));
            write_image(folder_ / ("maps" + n + "/color.png"), Image(4, 4, 3, 0.5f), {});
            write_tabulated_material(folder_ / ("table" + n + ".exr"), even_table());
        }
    }

    // Value 0 or 1 of the parameter: two different values, neither the default.
    ParameterValue value(const Parameter& p, int which) const {
        const float part = which == 0 ? 0.25f : 0.5f;
        switch (p.kind) {
            case ParameterKind::real:
                return p.low + static_cast<double>(part) * (std::min(p.high, 10.0) - p.low);
            case ParameterKind::boolean:
                return which == 0;
            case ParameterKind::choice:
                return ParameterChoice{static_cast<int>(p.choices.size()) - 1 - which};
            case ParameterKind::color:
            case ParameterKind::vector:
                return glm::vec3(part, 0.5f * part, 0.1f);
            default:
                return text(p.name, which);
        }
    }

    // The values of `p` alone, or with the parameter that it belongs to.
    ParameterValues values(const Parameter& p, int which) const {
        ParameterValues values;
        if (!p.belongs_to.empty())
            values.set_value(p.belongs_to, value(*find_parameter(p.belongs_to), 0));
        if (p.name == "physical_size") values.set_value("scratch", text("scratch", 0));
        values.set_value(p.name, value(p, which));
        return values;
    }

  private:
    std::string text(std::string_view name, int which) const {
        const std::string n = which == 0 ? "0" : "1";
        if (name == "weave") return which == 0 ? "plain" : "satin-5";
        if (name.ends_with("_map")) return (folder_ / ("flat" + n + ".png")).string();
        if (name == "maps") return (folder_ / ("maps" + n)).string();
        if (name == "scratch") return (folder_ / ("scratch" + n)).string();
        return (folder_ / ("table" + n + ".exr")).string();
    }

    ScratchFolder folder_;
};

// A triangle with one material of each kind of lobe; value 0 of every parameter changes some of
// them.
inline Scene scene_of_all_lobes() {
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.name = "triangle";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.tangents.assign(3, {1, 0, 0, 1});
    mesh.texcoord0 = {{0, 0}, {1, 0}, {0, 1}};
    mesh.indices = {0, 1, 2};
    Texture texture{"own", 1, 1, 3, TexelType::u8, ColorSpace::linear, {}};
    texture.texels.assign(3, std::byte{128});
    scene.textures.push_back(texture);
    Material m;
    m.base_color = {0.1f, 0.2f, 0.3f, 0.4f};
    m.metallic = 0.7f;
    for (TextureUse* use : {&m.base_color_texture, &m.metallic_roughness_texture, &m.normal_texture,
                            &m.anisotropy_texture}) {
        use->texture = 0;
        use->transform[0][0] = 3.0f;
    }
    m.normal_scale = 0.5f;
    m.normal_filter = NormalFilter::mips;
    m.mdf = Mdf::ward;
    m.anisotropy_rotation = 0.2f;
    Cloth cloth;
    cloth.draft = std::make_shared<Draft>(builtin_draft("twill-2-1"));
    const auto table = std::make_shared<const TabulatedMaterial>(even_table());
    for (const MaterialLobe& lobe :
         {MaterialLobe(GltfLobe{0.3f, 0.4f}), MaterialLobe(AlphaLobe{{0.1f, 0.3f}}),
          MaterialLobe(cloth), MaterialLobe(Tabulated{table, "own.exr"})}) {
        m.lobe = lobe;
        scene.materials.push_back(m);
        scene.instances.push_back(
            {0, static_cast<int>(scene.materials.size()) - 1, glm::mat4(1.0f)});
    }
    return scene;
}

}  // namespace burnish::test
