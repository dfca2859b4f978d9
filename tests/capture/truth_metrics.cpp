#include "truth_metrics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "burnish/f64.hpp"
#include "burnish/image_io.hpp"
#include "core/constants.hpp"

namespace burnish::test {

namespace {

double median(std::vector<double> values, double share = 0.5) {
    if (values.empty()) return 0.0;
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

double wrapped(double angle, double period) {
    return angle - period * std::round(angle / period);
}

double dot(const Vec3d& a, const Vec3d& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Cosine-weighted L1 distance of an exemplar, with its table rotated by `turn`, to a true
// distribution.
struct Distance {
    double all = 0.0, covered = 0.0, covered_mass = 0.0;
};
Distance distance(const TabulatedMaterial& m, int exemplar, double turn, const VirtualNdf& truth) {
    Distance out;
    constexpr int kRings = 180, kColumns = 360;
    for (int r = 0; r < kRings; ++r) {
        const double theta = (r + 0.5) * (kPi / 2) / kRings;
        const double weight =
            std::cos(theta) * std::sin(theta) * (kPi / 2 / kRings) * (2 * kPi / kColumns);
        const double u = std::sqrt(theta * 2 / kPi);
        const int ring = std::clamp(static_cast<int>(u * m.grid.rings), 0, m.grid.rings - 1);
        for (int c = 0; c < kColumns; ++c) {
            const double phi = 2 * kPi * c / kColumns;
            const double fitted = static_cast<double>(ndf_lookup(
                m.grid, m.table(exemplar), static_cast<float>(u), static_cast<float>(phi - turn)));
            const double d = truth.D({std::sin(theta) * std::cos(phi),
                                      std::sin(theta) * std::sin(phi), std::cos(theta)});
            const double difference = weight * std::abs(fitted - d);
            out.all += difference;
            const double turns = (phi - turn) / (2 * kPi);
            const int column =
                static_cast<int>(std::lround((turns - std::floor(turns)) * m.grid.azimuths)) %
                m.grid.azimuths;
            const auto cell = static_cast<std::size_t>(exemplar * m.grid.cells() +
                                                       ring * m.grid.azimuths + column);
            if (m.origin[cell] == NdfOrigin::extrapolated) continue;
            out.covered += difference;
            out.covered_mass += weight * d;
        }
    }
    return out;
}

}  // namespace

Rig write_stack(const VirtualSample& sample, const Rig& rig, const VirtualCamera& camera,
                const std::filesystem::path& folder) {
    Rig out = rig;
    std::filesystem::create_directories(folder);
    for (std::size_t k = 0; k < rig.lights.size(); ++k) {
        const auto path = folder / fmt::format("{:04}.exr", k);
        write_image(path, virtual_picture(sample, rig, k, camera), {});
        out.lights[k].images = {{path, 1.0}};
    }
    return out;
}

std::vector<ClassMetrics> compare_to_truth(const VirtualSample& sample,
                                           const TabulatedMaterial& m) {
    std::vector<ClassMetrics> out;
    for (std::size_t c = 0; c < sample.ndfs.size(); ++c) {
        ClassMetrics metrics;
        metrics.name = sample.ndfs[c].name;
        // The exemplar's own angle relative to the class's frame: the circular mean of double
        // angles.
        std::map<int, std::pair<double, double>> offset;
        std::map<int, int> members;
        std::vector<double> specular, diffuse;
        for (std::size_t t = 0; t < sample.texels.size(); ++t) {
            if (sample.texels[t].ndf != static_cast<int>(c)) continue;
            const int e = m.exemplar[t];
            const double turn = static_cast<double>(m.angle[t]) - sample.texels[t].grain;
            offset[e].first += std::cos(2 * turn);
            offset[e].second += std::sin(2 * turn);
            ++members[e];
            ++metrics.texels;
            specular.push_back(static_cast<double>(m.specular.pixels[3 * t + 1]) /
                               sample.texels[t].specular[1]);
            diffuse.push_back(static_cast<double>(m.diffuse.pixels[3 * t + 1]) /
                              sample.texels[t].diffuse[1]);
        }
        std::vector<double> errors;
        for (std::size_t t = 0; t < sample.texels.size(); ++t) {
            if (sample.texels[t].ndf != static_cast<int>(c)) continue;
            const auto& o = offset[m.exemplar[t]];
            const double turn = static_cast<double>(m.angle[t]) - sample.texels[t].grain;
            errors.push_back(std::abs(wrapped(turn - 0.5 * std::atan2(o.second, o.first), kPi)) *
                             180 / kPi);
        }
        metrics.angle_median_deg = median(errors);
        metrics.angle_p90_deg = median(errors, 0.9);
        std::vector<double> all, covered;
        for (const auto& [e, o] : offset) {
            // Tries both half turns and takes the better one, since grain is a line.
            Distance best;
            best.all = 1e9;
            for (int half = 0; half < 2; ++half) {
                const Distance d = distance(m, e, 0.5 * std::atan2(o.second, o.first) + half * kPi,
                                            sample.ndfs[c]);
                if (d.all < best.all) best = d;
            }
            for (int k = 0; k < members[e]; ++k) {
                all.push_back(best.all);
                covered.push_back(best.covered / std::max(best.covered_mass, 1e-9));
            }
        }
        metrics.l1_all = median(all);
        metrics.l1_covered = median(covered);
        metrics.specular_ratio = median(specular);
        metrics.diffuse_ratio = median(diffuse);
        out.push_back(metrics);
    }
    return out;
}

std::vector<std::vector<float>> areas_of(const TabulatedMaterial& material) {
    std::vector<std::vector<float>> out;
    for (int e = 0; e < material.exemplars; ++e)
        out.push_back(ndf_areas(material.grid, material.table(e)));
    return out;
}

Vec3d material_brdf(const TabulatedMaterial& m, const std::vector<std::vector<float>>& areas,
                    int column, int row, const Vec3d& to_light, const Vec3d& to_eye) {
    const std::size_t t = static_cast<std::size_t>(row * m.width + column);
    const int e = m.exemplar[t];
    const double a = -static_cast<double>(m.angle[t]);
    const Vec3d i = rotated_about_z(to_light, a), o = rotated_about_z(to_eye, a);
    if (i[2] <= 0.0 || o[2] <= 0.0) return {};
    const Vec3d sum = {i[0] + o[0], i[1] + o[1], i[2] + o[2]};
    const double length = std::sqrt(dot(sum, sum));
    const double theta = std::acos(std::min(sum[2] / length, 1.0));
    const double D = static_cast<double>(
        ndf_lookup(m.grid, m.table(e), static_cast<float>(std::sqrt(theta * 2 / kPi)),
                   static_cast<float>(std::atan2(sum[1], sum[0]))));
    const auto area = [&](const Vec3d& k) {
        return static_cast<double>(
            ndf_area_lookup(areas[static_cast<std::size_t>(e)].data(), static_cast<float>(k[0]),
                            static_cast<float>(k[1]), static_cast<float>(k[2])));
    };
    double fresnel = 1.0;
    if (m.eta > 0.0)
        fresnel = f64::fresnel_conductor(m.eta, 0.0, 0.5 * length) /
                  f64::fresnel_conductor(m.eta, 0.0, 1.0);
    const double shape = fresnel * D / (4.0 * area(i) * area(o));
    Vec3d rho;
    for (std::size_t c = 0; c < 3; ++c)
        rho[c] = static_cast<double>(m.diffuse.pixels[3 * t + c]) / kPi +
                 static_cast<double>(m.specular.pixels[3 * t + c]) * shape;
    return rho;
}

}  // namespace burnish::test
