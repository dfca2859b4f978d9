// Measured materials (.bsdf) where `brdf eval` and `brdf plot` take the name of a model.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "burnish/plot/brdf_plot.hpp"
#include "formats/bsdf/rgl_brdf.hpp"

namespace burnish {

// True of names that end in .bsdf.
bool names_measured(std::string_view text);

// f per steradian, linear Rec. 709, `wi` towards the light. The tables are read as they were
// measured: the light is the direction that the file calls incident. RglBrdf::eval calls that one
// `wo`. 0 below the horizon.
RglBrdf::Rgb measured_f(const RglBrdf& brdf, Direction<double> wi, Direction<double> wo);

// Of Rec. 709.
double luminance_of(const RglBrdf::Rgb& rgb);

// Figures leave out directions further from the normal: the tables do not vanish at the horizon as
// they should, and f grows without bound there.
inline constexpr double kMostShownDeg = 85;

// The luminance of f, and its sampler.
plot::MeasuredReflection measured_reflection(std::shared_ptr<const RglBrdf> brdf);

// Files that are read once, from any thread. Throws what RglBrdf::load throws.
class MeasuredFiles {
  public:
    const RglBrdf& at(const std::string& path);

  private:
    std::mutex mutex_;
    std::map<std::string, std::unique_ptr<const RglBrdf>, std::less<>> files_;
};

}  // namespace burnish
