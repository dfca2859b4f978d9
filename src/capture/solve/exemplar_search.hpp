// Finds the exemplars of a sample from some of its points, the training points. It clusters partial
// distributions, then solves alternately for exemplars, rotations and strengths from the points'
// samples. Between rounds, exemplars are joined, split and merged (docs/theory/capture-model.md).
#pragma once

#include <optional>
#include <vector>

#include "burnish/progress.hpp"
#include "capture/solve/exemplar_solve.hpp"
#include "capture/solve/exemplars.hpp"
#include "capture/solve/peak_normal.hpp"
#include "capture/solve/sample_context.hpp"

namespace burnish {

struct ExemplarSearchSettings {
    int exemplars = 64;         // at most
    std::optional<double> eta;  // none: estimated
    std::uint64_t seed = 1;
    // Of the points' normals; unless none, they may tilt.
    NormalStart normals = NormalStart::none;
};

struct FoundExemplars {
    Exemplars exemplars;
    CompletionReport completion;
    double eta = 0.0;
    double mean_error = 0.0;  // mean over the training points of PointFit::error, each at most 1
};

// `pixels`: those of the training points; `values`: pixels x lights x 3, as decoded by the stack.
// Deterministic for a seed, for any number of threads. Throws Interrupted.
FoundExemplars find_exemplars(const SampleContext& context, const std::vector<std::size_t>& pixels,
                              const std::vector<float>& values,
                              const ExemplarSearchSettings& settings, const Progress& progress);

}  // namespace burnish
