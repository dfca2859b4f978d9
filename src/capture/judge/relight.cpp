#include "burnish/relight.hpp"

#include <algorithm>
#include <cmath>

#include "burnish/f64.hpp"
#include "core/constants.hpp"
#include "core/parallel.hpp"

namespace burnish {

namespace {

Vec3d normal_of(const TabulatedMaterial& m, std::size_t texel) {
    const float* n = m.normal.pixels.data() + 3 * texel;
    return {static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])};
}

// Transforms directions to the frame of the table: the frame of the sample after the shortest
// rotation from z to the normal, then rotated about the normal by the texel's angle.
class TableFrame {
  public:
    TableFrame(const Vec3d& n, double angle)
        : frame_(f64::frame_shortest_arc(f64::vec3(n[0], n[1], n[2]))),
          cos_(std::cos(angle)),
          sin_(std::sin(angle)) {}

    Vec3d local(const Vec3d& v) const {
        const f64::vec3 d(v[0], v[1], v[2]);
        const double x = f64::dot(frame_.t, d), y = f64::dot(frame_.b, d);
        return {cos_ * x + sin_ * y, cos_ * y - sin_ * x, f64::dot(frame_.n, d)};
    }

  private:
    f64::Frame frame_;
    double cos_, sin_;
};

double table_at(const NdfGrid& grid, const float* table, const Vec3d& h) {
    // From the tangent: the cosine loses the angle's digits near the normal.
    const double theta = std::atan2(std::hypot(h[0], h[1]), h[2]);
    return static_cast<double>(ndf_lookup(grid, table,
                                          static_cast<float>(std::sqrt(theta * (2 / kPi))),
                                          static_cast<float>(std::atan2(h[1], h[0]))));
}

double area_at(const std::vector<float>& areas, const Vec3d& k) {
    return static_cast<double>(ndf_area_lookup(areas.data(), static_cast<float>(k[0]),
                                               static_cast<float>(k[1]), static_cast<float>(k[2])));
}

// F(c) / F(1) of a dielectric
double relative_fresnel(double eta, double cosine) {
    if (eta <= 0.0) return 1.0;
    return f64::fresnel_conductor(eta, 0.0, cosine) / f64::fresnel_conductor(eta, 0.0, 1.0);
}

}  // namespace

Relighter::Relighter(const TabulatedMaterial& material) : material_(material) {
    for (int e = 0; e < material.exemplars; ++e)
        areas_.push_back(ndf_areas(material.grid, material.table(e)));
}

Vec3d Relighter::brdf(std::size_t texel, const Vec3d& to_light, const Vec3d& to_eye) const {
    const TabulatedMaterial& m = material_;
    const std::size_t e = m.exemplar[texel];
    if (e == TabulatedMaterial::kNoExemplar) return {};
    const TableFrame frame(normal_of(m, texel), static_cast<double>(m.angle[texel]));
    const Vec3d i = frame.local(to_light), o = frame.local(to_eye);
    if (i[2] <= 0.0 || o[2] <= 0.0) return {};
    const Vec3d sum = {i[0] + o[0], i[1] + o[1], i[2] + o[2]};
    const double cosine = 0.5 * std::hypot(sum[0], sum[1], sum[2]);
    const double shape = f64::area_brdf(
        relative_fresnel(m.eta, cosine) * table_at(m.grid, m.table(static_cast<int>(e)), sum),
        area_at(areas_[e], i), area_at(areas_[e], o));
    Vec3d rho;
    for (std::size_t c = 0; c < 3; ++c)
        rho[c] = static_cast<double>(m.diffuse.pixels[3 * texel + c]) / kPi +
                 static_cast<double>(m.specular.pixels[3 * texel + c]) * shape;
    return rho;
}

Image Relighter::picture(const Rig& rig, std::size_t light) const {
    const int width = material_.width, height = material_.height;
    const RigLight& lamp = rig.lights[light];
    const RigPlace& eye = lamp.camera ? *lamp.camera : rig.camera;
    Image image(width, height, 3);
    parallel_for(static_cast<std::size_t>(height), 4, [&](std::size_t begin, std::size_t end) {
        for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
            for (int column = 0; column < width; ++column) {
                const std::size_t texel =
                    static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(column);
                if (material_.exemplar[texel] == TabulatedMaterial::kNoExemplar) continue;
                const Vec3d x = sample_point(rig, width, height, column, row);
                const Arrival in = arrival(lamp, x);
                const Vec3d n = normal_of(material_, texel);
                const double cosine =
                    n[0] * in.to_light[0] + n[1] * in.to_light[1] + n[2] * in.to_light[2];
                const Vec3d rho = brdf(texel, in.to_light, direction_to(eye, x));
                for (std::size_t c = 0; c < 3; ++c)
                    image.at(column, row)[c] = static_cast<float>(
                        std::clamp(rho[c] * std::max(cosine, 0.0) * in.irradiance_per_cosine[c],
                                   0.0, f64::kMostValue));
            }
    });
    return image;
}

}  // namespace burnish
