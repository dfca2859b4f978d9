// The exemplars of a sample from some of its points: partial distributions are clustered, then
// exemplars, turns and strengths are solved for in turns from the points' samples themselves,
// exemplars being joined, split and merged on the way (docs/theory/capture-model.md).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "burnish/progress.hpp"
#include "capture/solve/exemplar_solve.hpp"
#include "capture/solve/exemplars.hpp"
#include "capture/solve/point_fit.hpp"

namespace burnish {

// What a worker holds for one pixel after another.
struct PixelWork {
    PointLights lights;
    PointSamples samples;
};

// Everything that makes a pixel's values samples.
struct SampleContext {
    const LightGeometry* geometry = nullptr;
    std::vector<std::uint8_t> keep;  // lights that take part
    NdfGrid grid;
    float spacing_rad = 0.05f;  // of half vectors

    void gather(std::size_t pixel, const Vec3f& normal, const float* values,
                PixelWork& work) const {
        geometry->at(pixel, work.lights);
        gather_samples(work.lights, normal, {values, 3 * geometry->lights()}, keep, grid,
                       work.samples);
    }
};

struct ExemplarSearchSettings {
    int exemplars = 64;         // at most
    std::optional<double> eta;  // none: estimated
    std::uint64_t seed = 1;
    bool normals = false;  // points' normals may tilt
};

inline constexpr float kMostTilt = 0.35f;  // of normals, radians

// Columns to each side in which a matched turn is searched for the best.
inline constexpr float kSearchColumns = 1.5f;

// The tilt of a point's normal that explains its samples best with its exemplar at `fit.shift`,
// from `normal`, at most 20 degrees; gathers the samples anew and refines `fit`.
Vec3f refined_normal(const SampleContext& context, std::size_t pixel, const float* values,
                     float eta, const ExemplarTables& tables, Vec3f normal, PixelWork& work,
                     PointFit& fit);

class ExemplarSearch {
  public:
    // `values`: pixels x lights x 3. Both must outlive the search.
    ExemplarSearch(const SampleContext& context, const std::vector<std::size_t>& pixels,
                   const std::vector<float>& values, const ExemplarSearchSettings& settings,
                   const Progress& progress);

    void run();

    const Exemplars& exemplars() const { return exemplars_; }
    const CompletionReport& completion() const { return completion_; }
    double eta() const { return eta_; }
    double mean_error() const;  // of PointFit::error

  private:
    void solve_partial();
    void solve_round(double eta, bool search);
    void fit_point(std::size_t p, PixelWork& work);
    void solve_tables();
    void centre_exemplars();
    void split_exemplars();
    void merge_exemplars();
    void join_alike(float alike);
    void keep_exemplars(std::vector<bool> alive);  // one at least
    double estimate_eta();
    std::vector<std::vector<std::size_t>> members() const;
    ExemplarTables tables_of(int exemplar) const {
        return {context_.grid, exemplars_.table(exemplar), exemplars_.area(exemplar)};
    }
    const float* values_of(std::size_t point) const {
        return values_.data() + point * 3 * context_.geometry->lights();
    }
    MaskedTables partial() const { return {tables_, weights_, pixels_.size()}; }

    const SampleContext& context_;
    const std::vector<std::size_t>& pixels_;
    const std::vector<float>& values_;
    ExemplarSearchSettings settings_;
    Progress progress_;
    double eta_ = 0.0;
    Exemplars exemplars_;
    CompletionReport completion_;
    // One entry a point.
    std::vector<float> tables_, weights_;
    std::vector<Vec3f> normals_;
    std::vector<PointTurn> turns_;
    std::vector<PointFit> fits_;
    std::vector<std::vector<PointTurn>> candidates_;
    std::vector<std::vector<PointFit>> trials_;  // of each candidate
    std::vector<float> signatures_;              // kSignature.cells() each
};

}  // namespace burnish
