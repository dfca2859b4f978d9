// Measured materials of the RGL database (".bsdf"): Dupuy & Jakob, "An Adaptive Parameterization
// for Efficient Material Acquisition and Rendering", ACM TOG 37(6), 2018. A file holds reflectance
// for a few incident directions, on a grid in a unit square. The warp of the visible normals of a
// measured distribution maps the square to the hemisphere. Field names and conventions follow the
// authors' reader rgl-epfl/brdf-loader (BSD-3; no code of it).
//
//   theta_i, phi_i   the incident directions, radians; at most two azimuths: isotropic
//   ndf              D(h); u = sqrt(2 theta / pi) along x, (phi + pi) / (2 pi) along y
//   sigma            projected area of the distribution by direction, in the same square
//   vndf             density of visible normals in the same square, for each incident direction
//   luminance        density in the square that the warp of vndf starts from
//   rgb | spectra    f cos(theta_o) over D / (4 sigma) where `jacobian` is 1; spectra with
//                    `wavelengths` in nm
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

    // Per steradian, without the cosine, linear Rec. 709, >= 0 (measured colors outside the gamut
    // are clamped); 0 below the horizon. Unit directions, z the normal. The tables are read with
    // `wo` as the direction that the file calls incident, so the result is only as reciprocal as
    // the measurements are exact. The cosine in the denominator is at least 1e-6, because tables
    // need not vanish at the horizon.
    Rgb eval(Direction<double> wi, Direction<double> wo) const;

    // Draws `wi` for a given `wo`, xi uniform in [0, 1). The density is per solid angle. A draw may
    // lie below the horizon, where eval is 0 but the density is that of the draw. Draws towards
    // which no facet can reflect have density 0; reject them.
    Direction<double> sample(Direction<double> wo, std::array<double, 2> xi, double& density) const;
    double pdf(Direction<double> wi, Direction<double> wo) const;

    // The measured microfacet distribution and its projected area, scaled in the file so that sigma
    // at the normal is 1. phi has no effect for isotropic files.
    double ndf(double theta, double phi) const;
    double sigma(double theta, double phi) const;

    // The normal at a position in the unit square of the parameterization, by the warp of vndf
    // without the luminance. For showing the parameterization itself.
    Direction<double> normal_at(Direction<double> wo, std::array<double, 2> square,
                                double& density) const;
    std::array<double, 2> square_of(Direction<double> h, Direction<double> wo) const;

    bool isotropic() const { return isotropic_; }
    // 1, 2 or 4: azimuths cover the full circle, half of it (the rest by a half turn) or a quarter
    // (the rest by mirroring).
    int symmetry() const { return symmetry_; }
    std::span<const double> theta_i() const { return grid_.theta(); }  // radians, increasing
    std::span<const double> phi_i() const { return grid_.phi(); }
    const std::string& description() const { return description_; }
    std::size_t wavelengths() const { return wavelengths_; }  // 0: the file has rgb
    std::array<double, 2> wavelength_range_nm() const { return wavelength_range_; }
    std::size_t samples_per_side() const { return rgb_[0].columns(); }

  private:
    struct Given;  // an incident direction with its place in the tables
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
