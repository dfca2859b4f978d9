#include "capture/solve/residual_signature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace burnish {

void residual_signature(const ExemplarTables& tables, const PointSamples& samples,
                        const PointFitter& fitter, const PointFit& fit, float* out) {
    const auto cells = static_cast<std::size_t>(kSignature.cells());
    std::vector<float> sum(cells, 0.0f), total(cells, 0.0f);
    const float area_out =
        area_at(tables.areas, samples.out, samples.to_eye[2], area_shift(tables.grid, fit.shift));
    const auto columns = static_cast<float>(tables.grid.azimuths);
    for (std::size_t q = 0; q < samples.size(); ++q) {
        const float b =
            specular_shape(tables, samples, q, fit.shift, fitter.fresnel()[q], area_out);
        const float model =
            samples.received[q] * (fit.diffuse * std::numbers::inv_pi_v<float> + fit.specular * b);
        const float d = std::max(lookup(tables.grid, tables.D, samples.half[q], fit.shift), 1e-6f);
        const float slope = samples.received[q] * fit.specular * b / d;  // of the model by D
        const int ring = samples.half[q].ring * kSignature.rings / tables.grid.rings;
        float turns = (samples.half[q].column - fit.shift) / columns;
        turns -= std::floor(turns);
        const int column =
            static_cast<int>(turns * static_cast<float>(kSignature.azimuths)) % kSignature.azimuths;
        const auto to = static_cast<std::size_t>(ring * kSignature.azimuths + column);
        sum[to] += fitter.weights()[q] * slope * (samples.value[q] - model);
        total[to] += fitter.weights()[q] * slope * slope;
    }
    for (std::size_t i = 0; i < cells; ++i)
        out[i] = total[i] > 0.0f ? sum[i] / std::sqrt(total[i]) : 0.0f;
}

double main_variation(const std::vector<float>& signatures, const std::vector<std::size_t>& members,
                      std::vector<float>& side) {
    const auto cells = static_cast<std::size_t>(kSignature.cells());
    std::vector<double> mean(cells, 0.0), axis(cells), next(cells);
    for (const std::size_t p : members)
        for (std::size_t i = 0; i < cells; ++i)
            mean[i] += static_cast<double>(signatures[p * cells + i]) /
                       static_cast<double>(members.size());
    double variance = 0.0;
    for (const std::size_t p : members)
        for (std::size_t i = 0; i < cells; ++i)
            variance += std::pow(static_cast<double>(signatures[p * cells + i]) - mean[i], 2);
    for (std::size_t i = 0; i < cells; ++i) axis[i] = 1.0 + static_cast<double>(i % 7);
    double along = 0.0;
    side.resize(members.size());
    constexpr int kPowers = 20;
    for (int power = 0; power < kPowers; ++power) {
        const double length =
            std::sqrt(std::inner_product(axis.begin(), axis.end(), axis.begin(), 0.0));
        if (!(length > 0.0)) return 0.0;
        for (double& a : axis) a /= length;
        std::fill(next.begin(), next.end(), 0.0);
        along = 0.0;
        for (std::size_t k = 0; k < members.size(); ++k) {
            const float* s = signatures.data() + members[k] * cells;
            double place = 0.0;
            for (std::size_t i = 0; i < cells; ++i)
                place += (static_cast<double>(s[i]) - mean[i]) * axis[i];
            side[k] = static_cast<float>(place);
            along += place * place;
            for (std::size_t i = 0; i < cells; ++i)
                next[i] += place * (static_cast<double>(s[i]) - mean[i]);
        }
        axis = next;
    }
    return variance > 0.0 ? along / variance : 0.0;
}

}  // namespace burnish
