// The mean lobes of woven cloth (maps/weave/weave_mean.hpp), which take up to half a second to compute.
//
// Threads: one at a time. Lifetime: part of a context (context.hpp): means serve all renderers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "maps/weave/weave_mean.hpp"

namespace burnish::gpu {

class ClothStore {
  public:
    using Means = std::shared_ptr<const ClothMeans>;

    // The full means where they are there. Otherwise they are computed: coarse ones while that is
    // preferred, at first full ones.
    Means require(const ClothLobe& lobe);
    void prefer_coarse(bool coarse) { prefers_coarse_ = coarse; }

    // A lobe of which somebody holds coarse means, while there are no full ones.
    std::optional<ClothLobe> coarse_one() const;
    // Full means that were computed elsewhere, as on another thread.
    void put(const ClothLobe& lobe, ClothMeans full);
    // Rises with each call of put.
    std::uint64_t version() const { return version_; }

  private:
    struct Known {
        ClothLobe lobe;
        WeaveDetail detail;
        std::weak_ptr<const ClothMeans> means;
    };
    Means find(const ClothLobe& lobe, WeaveDetail detail) const;
    Means keep(const ClothLobe& lobe, ClothMeans means);

    // Full means that nobody holds are kept for undo. A pair of tables has 300 kB.
    static constexpr std::size_t kMostKept = 16;
    std::vector<Known> known_;
    std::deque<Means> kept_;  // the latest first
    bool prefers_coarse_ = false;
    std::uint64_t version_ = 0;
};

}  // namespace burnish::gpu
