#include "jobs/capture/capture_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "burnish/f32.hpp"
#include "burnish/image_io.hpp"
#include "burnish/load_tabulated.hpp"
#include "burnish/lobe_fit.hpp"
#include "burnish/material_textures.hpp"
#include "burnish/version.hpp"
#include "export/gltf_material_text.hpp"
#include "export/quad_gltf.hpp"
#include "jobs/map_folder.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;

bool is_outside(const TabulatedMaterial& m, std::size_t texel) {
    return m.exemplar[texel] == TabulatedMaterial::kNoExemplar;
}

// Writes the channels of one texel to `to`; 0 outside the mask.
using TexelValue = std::function<void(std::size_t texel, float* to)>;

DataPicture picture_of_texels(const TabulatedMaterial& m, std::vector<std::string> channels,
                              TexelValue value) {
    const std::size_t count = channels.size();
    return picture_of_rows(DataFormat::exr, std::move(channels), m.width, m.height,
                           [&m, count, value = std::move(value)](int begin, int end, float* to) {
                               const auto width = static_cast<std::size_t>(m.width);
                               for (std::size_t t = static_cast<std::size_t>(begin) * width;
                                    t < static_cast<std::size_t>(end) * width; ++t, to += count) {
                                   std::fill(to, to + count, 0.0f);
                                   if (!is_outside(m, t)) value(t, to);
                               }
                           });
}

TexelValue texel_of(const Image& image) {
    return [&image](std::size_t t, float* to) { std::copy_n(image.pixels.data() + 3 * t, 3, to); };
}

DataPicture texture_of(const Image& image) {
    return picture_of_rows(
        DataFormat::png16, kRgb, image.width, image.height,
        [&image](int begin, int end, float* to) {
            std::copy(
                image.at(0, begin),
                image.at(0, begin) + static_cast<std::ptrdiff_t>(end - begin) * 3 * image.width,
                to);
        });
}

struct Textures {
    Image metallic_roughness, normal, anisotropy;
};

std::vector<NamedPicture> pictures_of(const TabulatedMaterial& m, const std::vector<LobeFit>& lobes,
                                      const Textures& textures) {
    std::vector<NamedPicture> all;
    all.push_back({"diffuse.exr", picture_of_texels(m, kRgb, texel_of(m.diffuse))});
    all.push_back({"specular.exr", picture_of_texels(m, kRgb, texel_of(m.specular))});
    all.push_back({"normal.exr", picture_of_texels(m, kRgb, texel_of(m.normal))});
    all.push_back({"grain_angle.exr", picture_of_texels(m, {"Y"}, [&](std::size_t t, float* to) {
                       *to = static_cast<float>(groove_at(m, lobes, t) * 180 / std::numbers::pi);
                   })});
    all.push_back({"alpha.exr", picture_of_texels(m, kRgb, [&](std::size_t t, float* to) {
                       const LobeFit& lobe = lobes[m.exemplar[t]];
                       to[0] = static_cast<float>(lobe.alpha_across);
                       to[1] = static_cast<float>(lobe.alpha_along);
                       to[2] = static_cast<float>(lobe.residual);
                   })});
    all.push_back({"metallic_roughness.png", texture_of(textures.metallic_roughness)});
    all.push_back({"normal.png", texture_of(textures.normal)});
    all.push_back({"anisotropy.png", texture_of(textures.anisotropy)});
    return all;
}

QuadMaterial material_of(const std::string& name, bool masked, float f0) {
    QuadMaterial out;
    out.json = {
        {"name", name},
        {"pbrMetallicRoughness",
         {{"baseColorTexture", {{"index", 0}}}, {"metallicRoughnessTexture", {{"index", 1}}}}},
        {"normalTexture", {{"index", 2}}},
        {"extensions",
         {{"KHR_materials_anisotropy",
           {{"anisotropyStrength", 1.0}, {"anisotropyTexture", {{"index", 3}}}}}}}};
    if (masked) out.json["alphaMode"] = "MASK";
    out.images = {"base_color.png", "metallic_roughness.png", "normal.png", "anisotropy.png"};
    out.extensions = {"KHR_materials_anisotropy"};
    if (f0 != kGltfF0) {
        out.json["extensions"]["KHR_materials_ior"] = {{"ior", ior_of(f0)}};
        out.extensions.emplace_back("KHR_materials_ior");
    }
    return out;
}

SampleQuad quad_of(const TabulatedMaterial& m, const fs::path& material,
                   std::vector<std::string>& warnings) {
    SampleQuad quad;
    quad.name = material.stem().string();
    quad.width_mm = m.width_mm;
    quad.height_mm = m.height_mm;
    if (!(m.width_mm > 0.0 && m.height_mm > 0.0)) {
        quad.width_mm = m.width;
        quad.height_mm = m.height;
        warnings.push_back(fmt::format(
            "{}: does not say how large the sample is; taken as 1 mm a texel", material.string()));
    }
    return quad;
}

// Warns of properties that glTF cannot hold.
void warn_of_losses(const TabulatedMaterial& m, const std::vector<LobeFit>& lobes,
                    const fs::path& material, std::vector<std::string>& warnings) {
    std::size_t texels = 0, differ = 0, bright = 0, other = 0;
    const float f0 = dielectric_f0_of(m);
    for (std::size_t t = 0; t < m.texels(); ++t) {
        if (is_outside(m, t)) continue;
        const float* s = m.specular.pixels.data() + 3 * t;
        ++texels;
        // Half as much more or less is seen.
        const float luminance = f32::luminance(f32::vec3(s[0], s[1], s[2]));
        differ +=
            is_dielectric({s[0], s[1], s[2]}) && (luminance < f0 / 1.5f || luminance > 1.5f * f0);
        bright += std::max({s[0], s[1], s[2]}) > 1.0f;
        // The nearest GGX lobe of a Beckmann lobe has a residual of 0.23.
        other += lobes[m.exemplar[t]].residual > 0.3;
    }
    const auto warn = [&](std::size_t count, const std::string& what) {
        if (count > 0)
            warnings.push_back(fmt::format(
                "{}: {:.2g} % of the texels {}", material.string(),
                100.0 * static_cast<double>(count) / static_cast<double>(texels), what));
    };
    warn(differ,
         fmt::format("are dielectrics whose reflectance is far from {:.2g} %, the one that the "
                     "glTF states for all of them",
                     100 * f0));
    warn(bright, "have a specular color above 1, where the glTF ends");
    warn(other, "have distributions that no GGX lobe comes near; those of the glTF are other ones");
}

}  // namespace

CaptureExportResult capture_export(const CaptureExportRequest& request, const Progress& progress) {
    CaptureExportResult report;
    const auto loaded = load_tabulated(request.material);
    const TabulatedMaterial& m = *loaded;
    const OutputFolder folder(request.output);
    progress.step("fit lobes", 0.0);
    const std::vector<LobeFit> lobes = fit_lobes(m, Mdf::ggx);
    const SampleQuad quad = quad_of(m, request.material, report.warnings);
    // Base color has alpha: 0 outside the mask.
    const bool masked = std::find(m.exemplar.begin(), m.exemplar.end(),
                                  TabulatedMaterial::kNoExemplar) != m.exemplar.end();
    warn_of_losses(m, lobes, request.material, report.warnings);
    const Textures textures = {metallic_roughness_texture(m, lobes), normal_texture(m),
                               anisotropy_texture(m, lobes)};
    const std::map<std::string, std::string> metadata = {
        {"burnish:version", std::string(version())}, {"burnish:command", request.command}};

    std::vector<FileToWrite> others;
    others.push_back({request.output / "material.gltf", [&](const fs::path& path) {
                          write_text_file(
                              path,
                              quad_gltf(quad, material_of(quad.name, masked, dielectric_f0_of(m)),
                                        "material.bin"));
                      }});
    others.push_back({request.output / "material.bin",
                      [&](const fs::path& path) { write_bytes(path, quad_bytes(quad)); }});
    others.push_back({request.output / "base_color.png", [&](const fs::path& path) {
                          write_image(path, base_color_texture(m, masked), metadata);
                      }});
    report.written = write_map_folder(request.output, std::move(others),
                                      pictures_of(m, lobes, textures), metadata, progress);
    return report;
}

}  // namespace burnish
