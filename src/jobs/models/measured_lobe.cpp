#include "jobs/models/measured_lobe.hpp"

#include <cmath>
#include <utility>

#include "burnish/f64.hpp"
#include "core/constants.hpp"

namespace burnish {

bool names_measured(std::string_view text) {
    return std::filesystem::path(text).extension() == ".bsdf";
}

RglBrdf::Rgb measured_f(const RglBrdf& brdf, Direction<double> wi, Direction<double> wo) {
    return brdf.eval(wo, wi);
}

double luminance_of(const RglBrdf::Rgb& rgb) {
    return f64::luminance(f64::vec3(rgb[0], rgb[1], rgb[2]));
}

plot::MeasuredReflection measured_reflection(std::shared_ptr<const RglBrdf> brdf) {
    const auto& kept = *brdf;
    return {[brdf, &kept](Direction<double> wi, Direction<double> wo) {
                return luminance_of(measured_f(kept, wi, wo));
            },
            [brdf, &kept](Direction<double> wi, std::array<double, 3> xi, double& density) {
                return kept.sample(wi, {xi[0], xi[1]}, density);
            },
            std::cos(kMostShownDeg * kDegree)};
}

const RglBrdf& MeasuredFiles::at(const std::string& path) {
    const std::lock_guard lock(mutex_);
    auto& file = files_[path];
    if (!file) file = std::make_unique<const RglBrdf>(RglBrdf::load(path));
    return *file;
}

}  // namespace burnish
