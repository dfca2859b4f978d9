// Measured materials of the RGL database (".bsdf"): Dupuy & Jakob, "An Adaptive Parameterization
// for Efficient Material Acquisition and Rendering", ACM TOG 37(6), 2018. A file holds, for a few
// incident directions, reflectance on a grid in the square that the visible microfacet normals of a
// measured distribution warp to the hemisphere. Field names and conventions after the authors'
// reader rgl-epfl/brdf-loader (BSD-3; no code of it).
//
//   theta_i, phi_i        the incident directions, radians; at most two azimuths: isotropic
//   ndf                   D(h), sigma: its area seen from a direction; u = sqrt(2 theta / pi) along
//   x,
//                         (phi + pi) / (2 pi) along y
//   vndf                  density of visible normals in the same square, for each incident
//   direction luminance             density in the square that the warp of vndf starts from rgb |
//   spectra         f cos(theta_o) over D / (4 sigma) where `jacobian` is 1; spectra with
//                         `wavelengths` in nm
//
// The published evaluation code returns f cos(theta_o); here `eval` is f itself.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>

#include "burnish/mdf.hpp"
#include "formats/bsdf/bilinear_warp.hpp"
#include "formats/bsdf/tensor_file.hpp"

namespace burnish {

class RglBrdf {
  public:
    using Rgb = std::array<double, 3>;

    // Throws Error: file, field, expected, found.
    static RglBrdf load(const std::filesystem::path& path);
    explicit RglBrdf(const TensorFile& file);

    // Per steradian, without the cosine, linear Rec. 709, none below 0 (measured colours outside
    // the gamut are cut); 0 below the horizon. Unit directions, z the normal. The tables are read
    // with `wo` as the direction that the file calls incident, so measurements are reciprocal only
    // as far as they are exact. Within 1e-6 of the horizon the cosine that is divided by is held at
    // 1e-6: tables need not vanish there.
    Rgb eval(Direction<double> wi, Direction<double> wo) const;

    // Draws `wi` for a given `wo`, xi uniform in [0, 1). Density per solid angle. A draw may lie
    // below the horizon, where eval is 0 and the density is still the one of the draws; those
    // towards which no facet can reflect have density 0 and are thrown away.
    Direction<double> sample(Direction<double> wo, std::array<double, 2> xi, double& density) const;
    double pdf(Direction<double> wi, Direction<double> wo) const;

    // The measured microfacet distribution, scaled in the file so that sigma at the normal is 1,
    // and its projected area. phi does not matter for isotropic files.
    double ndf(double theta, double phi) const;
    double sigma(double theta, double phi) const;

    // Where samples stand for a place in the unit square of the parameterisation, as the tables
    // have it: the grid of vndf without the luminance. For looking at the parameterisation itself.
    Direction<double> normal_at(Direction<double> wo, std::array<double, 2> square,
                                double& density) const;
    std::array<double, 2> square_of(Direction<double> h, Direction<double> wo) const;

    bool isotropic() const { return isotropic_; }
    // 1, 2 or 4: azimuths cover the full circle, half of it (the rest by a half turn) or a quarter
    // (the rest by mirrors).
    int symmetry() const { return symmetry_; }
    std::span<const double> theta_i() const { return grid_.theta(); }  // radians, rising
    std::span<const double> phi_i() const { return grid_.phi(); }
    const std::string& description() const { return description_; }
    std::size_t wavelengths() const { return wavelengths_; }  // 0: the file holds rgb
    std::array<double, 2> wavelength_range_nm() const { return wavelength_range_; }
    std::size_t samples_per_side() const { return rgb_[0].columns(); }

  private:
    struct Given;  // an incident direction, looked up
    Given given(Direction<double> wo) const;
    Rgb reflected(const Given& at, const Warped& start, double u, double v) const;
    void read_directions(const TensorFile& file);
    void read_distribution(const TensorFile& file);
    void read_color(const TensorFile& file, const TensorField& field,
                    std::span<const std::array<double, 3>> weights, std::size_t channels);
    void read_reflectance(const TensorFile& file);

    std::string description_;
    SliceGrid grid_;
    BilinearTable ndf_, sigma_;
    BilinearWarp vndf_, luminance_;
    std::array<BilinearTable, 3> rgb_;
    bool isotropic_ = true, jacobian_ = true;
    int symmetry_ = 1;
    std::size_t wavelengths_ = 0;
    std::array<double, 2> wavelength_range_{};
};

}  // namespace burnish
