#include "capture/model/parametric_maps.hpp"

#include <algorithm>
#include <numbers>

#include "burnish/f64.hpp"
#include "core/constants.hpp"
#include "core/parallel.hpp"

namespace burnish {

namespace {

// The color of luminance 1 that has the same ratios of channels; gray for black.
Vec3d tint_of(const float* rgb) {
    const f64::vec3 color(static_cast<double>(rgb[0]), static_cast<double>(rgb[1]),
                          static_cast<double>(rgb[2]));
    const double luminance = f64::luminance(color);
    // 1e-9 is below the smallest half float, 6e-8: files hold nothing between it and black.
    if (!(luminance > 1e-9)) return {1.0, 1.0, 1.0};
    return {color.x / luminance, color.y / luminance, color.z / luminance};
}

}  // namespace

ParametricFit ParametricMaps::lobe(std::size_t texel) const {
    ParametricFit fit;
    fit.alpha_along = (*along)[texel];
    fit.alpha_across = (*across)[texel];
    fit.groove = (*groove_deg)[texel] * static_cast<float>(kDegree);
    return fit;
}

std::vector<ParametricMaps> parametric_maps(const TabulatedMaterial& material) {
    std::vector<ParametricMaps> out;
    const auto names = parametric_model_names();
    for (std::size_t k = 0; k < names.size(); ++k) {
        const auto find = [&](const char* what) -> const std::vector<float>* {
            const auto found = material.maps.find(std::string(names[k]) + "." + what);
            return found == material.maps.end() ? nullptr : &found->second;
        };
        const ParametricMaps maps = {static_cast<ParametricModel>(k),
                                     std::string(names[k]),
                                     find("alpha_along"),
                                     find("alpha_across"),
                                     find("groove_deg"),
                                     find("diffuse"),
                                     find("specular")};
        if (maps.along && maps.across && maps.groove_deg && maps.diffuse && maps.specular)
            out.push_back(maps);
    }
    return out;
}

Image parametric_picture(const TabulatedMaterial& material, const ParametricMaps& maps,
                         const Rig& rig, std::size_t light) {
    const int width = material.width, height = material.height;
    const RigLight& lamp = rig.lights[light];
    const RigPlace& eye = lamp.camera ? *lamp.camera : rig.camera;
    Image image(width, height, 3);
    parallel_for(material.texels(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            if (material.exemplar[t] == TabulatedMaterial::kNoExemplar) continue;
            const auto column = static_cast<int>(t % static_cast<std::size_t>(width));
            const auto row = static_cast<int>(t / static_cast<std::size_t>(width));
            const Vec3d x = sample_point(rig, width, height, column, row);
            const Arrival in = arrival(lamp, x);
            const float* n = material.normal.pixels.data() + 3 * t;
            const NormalFrame local({n[0], n[1], n[2]});
            const Vec3f i = local(in.to_light), o = local(direction_to(eye, x));
            if (i[2] <= 0.0f || o[2] <= 0.0f) continue;
            const auto shape = static_cast<double>(
                parametric_shape(maps.model, maps.lobe(t), static_cast<float>(material.eta), i, o));
            const Vec3d diffuse = tint_of(material.diffuse.pixels.data() + 3 * t);
            const Vec3d specular = tint_of(material.specular.pixels.data() + 3 * t);
            for (std::size_t c = 0; c < 3; ++c) {
                const double rho =
                    static_cast<double>((*maps.diffuse)[t]) * diffuse[c] / std::numbers::pi +
                    static_cast<double>((*maps.specular)[t]) * specular[c] * shape;
                image.pixels[3 * t + c] = static_cast<float>(rho * static_cast<double>(i[2]) *
                                                             in.irradiance_per_cosine[c]);
            }
        }
    });
    return image;
}

}  // namespace burnish
