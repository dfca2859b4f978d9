#include "jobs/info/info_measured.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "burnish/error.hpp"
#include "core/constants.hpp"
#include "formats/bsdf/rgl_brdf.hpp"
#include "formats/bsdf/tensor_file.hpp"

namespace burnish {
namespace {

std::string angles_text(std::span<const double> angles) {
    std::vector<std::string> words;
    for (const double angle : angles) words.push_back(fmt::format("{:.1f}", angle / kDegree));
    return fmt::format("{}", fmt::join(words, ", "));
}

// Albedo for light from `wo`, by the material's own sampling on a grid.
RglBrdf::Rgb albedo(const RglBrdf& brdf, Direction<double> wo) {
    constexpr int kSide = 32;
    RglBrdf::Rgb sum{};
    for (int i = 0; i < kSide * kSide; ++i) {
        double density = 0;
        const auto wi = brdf.sample(
            wo, {(i % kSide + 0.5) / kSide, (static_cast<double>(i / kSide) + 0.5) / kSide},
            density);
        if (!(wi.z > 0 && density > 0)) continue;
        const RglBrdf::Rgb f = brdf.eval(wi, wo);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += f[c] * wi.z / density / (kSide * kSide);
    }
    return sum;
}

std::string describe_material(const RglBrdf& brdf) {
    std::string text = fmt::format("  {}, {}\n", brdf.description(),
                                   brdf.isotropic() ? "isotropic" : "anisotropic");
    text += fmt::format("  incident directions at {} degrees\n", angles_text(brdf.theta_i()));
    if (!brdf.isotropic()) {
        text += fmt::format("  and azimuths {}{}\n", angles_text(brdf.phi_i()),
                            brdf.symmetry() > 1 ? ", the rest by symmetry" : "");
    }
    text += brdf.wavelengths() == 0
                ? std::string("  color: linear red, green, blue\n")
                : fmt::format("  color: {} wavelengths, {:g} to {:g} nm\n", brdf.wavelengths(),
                              brdf.wavelength_range_nm()[0], brdf.wavelength_range_nm()[1]);
    for (const double degrees : {0.0, 45.0, 75.0}) {
        const double theta = degrees * kDegree;
        const auto rgb =
            albedo(brdf, {std::sin(theta) * std::cos(brdf.phi_i().front()),
                          std::sin(theta) * std::sin(brdf.phi_i().front()), std::cos(theta)});
        text += fmt::format("  reflects {:.3f} {:.3f} {:.3f} of the light at {:g} degrees\n",
                            rgb[0], rgb[1], rgb[2], degrees);
    }
    text += fmt::format("  microfacet distribution: {:.4g} at the normal\n", brdf.ndf(0, 0));
    return text;
}

}  // namespace

std::string describe_measured(const std::string& path) {
    const TensorFile file = TensorFile::load(path);
    const bool material = file.find("vndf") && file.find("luminance");
    std::string text = fmt::format(
        "{}: {}\n", path, material ? "measured material (RGL tensor file)" : "tensor file");
    if (material) text += describe_material(RglBrdf(file));
    for (const TensorField& field : file.fields()) {
        text += fmt::format("  field {}: {}, {}, {} bytes\n", one_line(field.name),
                            name_of(field.type), field.shape_text(), field.bytes());
    }
    return text;
}

}  // namespace burnish
