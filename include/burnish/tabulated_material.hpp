// Materials measured by `burnish capture fit`: exemplar distributions, and for every texel which
// exemplar it has, turned by how much, with diffuse and specular colour. docs/reference/tabulated-file.md
// describes the file: a multi-part OpenEXR whose parts any viewer of OpenEXR shows.
//
// Threads and lifetime: plain values; copies are independent, and any number of threads may read
// one.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/image.hpp"
#include "burnish/ndf_grid.hpp"

namespace BURNISH_API burnish {

// How a cell of an exemplar is known.
enum class NdfOrigin : std::uint8_t {
    extrapolated = 0,  // beyond what any pair of camera and light reaches
    completed = 1,     // from other points, turned
    measured = 2       // by points that were put into this exemplar as they stand
};

struct TabulatedMaterial {
    NdfGrid grid;
    int exemplars = 0;
    std::vector<float> D;           // exemplars x rings x azimuths, each Int D (n.h) dw = 1
    std::vector<NdfOrigin> origin;  // likewise
    // The first axis of each exemplar's groove, radians counter-clockwise from +x of its table, in
    // [0, pi): the direction in which the distribution is narrowest across.
    std::vector<float> groove;
    double eta =
        1.5;  // Fresnel's: rho_s = specular F(i.h)/F(1) D / (4 g g); 0: no Fresnel, F = F(1)

    // Texels, row 0 at the top, all width x height.
    int width = 0, height = 0;
    double width_mm = 0.0, height_mm = 0.0;
    std::vector<std::uint16_t> exemplar;  // index; kNoExemplar: outside the mask
    std::vector<float> angle;             // radians: the table is turned by this, counter-clockwise
    Image diffuse;                        // 3 channels: albedo, rho_d = diffuse / pi
    Image specular;                       // 3 channels: k_s F(1)
    Image normal;                         // 3 channels, unit, sample space

    // Further per-texel maps by name ("ward.alpha_x" ...), one channel each: for people and export.
    std::map<std::string, std::vector<float>> maps;
    std::map<std::string, std::string> metadata;

    static constexpr std::uint16_t kNoExemplar = 0xffff;
    const float* table(int index) const {
        return D.data() + static_cast<std::ptrdiff_t>(index) * grid.cells();
    }
    std::size_t texels() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
};

}  // namespace burnish
