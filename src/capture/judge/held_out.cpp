#include "capture/judge/held_out.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "burnish/compare.hpp"
#include "burnish/f64.hpp"
#include "burnish/relight.hpp"
#include "capture/model/parametric_fit.hpp"
#include "capture/model/parametric_maps.hpp"
#include "capture/stack/light_geometry.hpp"
#include "core/parallel.hpp"

namespace burnish {

namespace {

// Pixels of a tile. The sums of tiles are merged in order, so that results do not depend on the
// number of threads.
constexpr std::size_t kTile = 64;

// Errors of luminance over the valid samples.
struct Sums {
    std::vector<SquaredError> errors;  // of the material, then of each analytic model
    double peak = 0.0;                 // the brightest photographed sample

    explicit Sums(std::size_t models) : errors(models) {}
    void merge(const Sums& other) {
        for (std::size_t m = 0; m < errors.size(); ++m) errors[m].merge(other.errors[m]);
        peak = std::max(peak, other.peak);
    }
};

class HeldOut {
  public:
    HeldOut(const ImageStack& stack, const Rig& rig, const TabulatedMaterial& material,
            const std::vector<std::uint8_t>& keep)
        : stack_(stack),
          material_(material),
          relighter_(material),
          geometry_(rig, stack.width(), stack.height()),
          models_(parametric_maps(material)) {
        for (std::size_t k = 0; k < keep.size(); ++k)
            if (!keep[k]) lights_.push_back(k);
    }

    const std::vector<ParametricMaps>& models() const { return models_; }
    bool empty() const { return lights_.empty(); }

    Sums tile(const StackBand& band, std::size_t begin, std::size_t end) const {
        Sums sums(1 + models_.size());
        std::vector<float> values((end - begin) * 3 * stack_.lights());
        stack_.decode(band, begin, end - begin, values.data());
        PointLights lights;
        for (std::size_t k = begin; k < end; ++k) {
            const std::size_t t = band.first + k;
            if (material_.exemplar[t] == TabulatedMaterial::kNoExemplar) continue;
            geometry_.at(t, lights);
            point(t, lights, values.data() + (k - begin) * 3 * stack_.lights(), sums);
        }
        return sums;
    }

  private:
    void point(std::size_t t, const PointLights& lights, const float* values, Sums& sums) const {
        const float* n = material_.normal.pixels.data() + 3 * t;
        const NormalFrame local({n[0], n[1], n[2]});
        const Vec3f o = local(lights.to_eye[0], lights.to_eye[1], lights.to_eye[2]);
        std::vector<ParametricFit> fits;
        for (const ParametricMaps& m : models_) fits.push_back(m.lobe(t));
        for (const std::size_t k : lights_) {
            const float* v = values + 3 * k;
            if (std::isinf(v[0]) || std::isinf(v[1]) || std::isinf(v[2])) continue;
            const Vec3f i = local(lights.x[k], lights.y[k], lights.z[k]);
            if (i[2] < kLeastLightCosine) continue;
            const Vec3d rho = relighter_.brdf(
                t,
                {static_cast<double>(lights.x[k]), static_cast<double>(lights.y[k]),
                 static_cast<double>(lights.z[k])},
                {static_cast<double>(lights.to_eye[0]), static_cast<double>(lights.to_eye[1]),
                 static_cast<double>(lights.to_eye[2])});
            const f64::vec3 light(static_cast<double>(i[2] * lights.received[0][k]),
                                  static_cast<double>(i[2] * lights.received[1][k]),
                                  static_cast<double>(i[2] * lights.received[2][k]));
            const double truth = f64::luminance(f64::vec3(
                static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])));
            const double received = f64::luminance(light);
            const double ours =
                f64::luminance(f64::vec3(light.x * rho[0], light.y * rho[1], light.z * rho[2]));
            sums.peak = std::max(sums.peak, truth);
            sums.errors[0].add(ours - truth);
            for (std::size_t m = 0; m < models_.size(); ++m) {
                const float b = parametric_shape(models_[m].model, fits[m],
                                                 static_cast<float>(material_.eta), i, o);
                const double rho_m =
                    static_cast<double>((*models_[m].diffuse)[t]) / std::numbers::pi +
                    static_cast<double>((*models_[m].specular)[t] * b);
                sums.errors[m + 1].add(received * rho_m - truth);
            }
        }
    }

    const ImageStack& stack_;
    const TabulatedMaterial& material_;
    Relighter relighter_;
    LightGeometry geometry_;
    std::vector<ParametricMaps> models_;
    std::vector<std::size_t> lights_;
};

}  // namespace

std::vector<HeldOutError> held_out_errors(const ImageStack& stack, const Rig& rig,
                                          const TabulatedMaterial& material,
                                          const std::vector<std::uint8_t>& keep,
                                          const Progress& progress) {
    const HeldOut work(stack, rig, material, keep);
    if (work.empty()) return {};
    Sums total(1 + work.models().size());
    for (std::size_t b = 0; b < stack.bands(); ++b) {
        progress.step("held-out lights",
                      static_cast<double>(b) / static_cast<double>(stack.bands()));
        const StackBand band = stack.load(b);
        std::vector<Sums> tiles((band.pixels + kTile - 1) / kTile, Sums(total.errors.size()));
        parallel_for(band.pixels, kTile, [&](std::size_t begin, std::size_t end) {
            tiles[begin / kTile] = work.tile(band, begin, end);
        });
        for (const Sums& tile : tiles) total.merge(tile);
    }
    std::vector<HeldOutError> out;
    for (std::size_t m = 0; m < total.errors.size(); ++m) {
        const SquaredError& error = total.errors[m];
        out.push_back({m == 0 ? "tabulated" : work.models()[m - 1].name, error.count, total.peak,
                       error.rmse(),
                       error.count > 0 ? psnr(error.rmse(), total.peak)
                                       : std::numeric_limits<double>::quiet_NaN()});
    }
    return out;
}

}  // namespace burnish
