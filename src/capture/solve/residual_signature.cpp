#include "capture/solve/residual_signature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

namespace burnish {

void residual_signature(const ExemplarTables& tables, const PointSamples& samples,
                        const PointFitter& fitter, const PointFit& fit, Signature& out) {
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

double main_variation(const std::vector<const Signature*>& signatures, std::vector<float>& place) {
    constexpr std::size_t kCells = std::tuple_size_v<Signature>;
    // Enough iterations for the share of the variance to converge to two digits.
    constexpr int kPowers = 20;
    std::vector<double> mean(kCells, 0.0), axis(kCells), next(kCells);
    for (const Signature* s : signatures)
        for (std::size_t i = 0; i < kCells; ++i)
            mean[i] += static_cast<double>((*s)[i]) / static_cast<double>(signatures.size());
    double variance = 0.0;
    for (const Signature* s : signatures)
        for (std::size_t i = 0; i < kCells; ++i)
            variance += std::pow(static_cast<double>((*s)[i]) - mean[i], 2);
    // Any start vector works that is not orthogonal to the component.
    for (std::size_t i = 0; i < kCells; ++i) axis[i] = 1.0 + static_cast<double>(i % 7);
    double along = 0.0;
    place.resize(signatures.size());
    for (int power = 0; power < kPowers; ++power) {
        const double length =
            std::sqrt(std::inner_product(axis.begin(), axis.end(), axis.begin(), 0.0));
        if (!(length > 0.0)) return 0.0;
        for (double& a : axis) a /= length;
        std::fill(next.begin(), next.end(), 0.0);
        along = 0.0;
        for (std::size_t k = 0; k < signatures.size(); ++k) {
            const Signature& s = *signatures[k];
            double at = 0.0;
            for (std::size_t i = 0; i < kCells; ++i)
                at += (static_cast<double>(s[i]) - mean[i]) * axis[i];
            place[k] = static_cast<float>(at);
            along += at * at;
            for (std::size_t i = 0; i < kCells; ++i)
                next[i] += at * (static_cast<double>(s[i]) - mean[i]);
        }
        axis = next;
    }
    return variance > 0.0 ? along / variance : 0.0;
}

}  // namespace burnish
