#include "gpu/device/cloth_store.hpp"

#include <utility>

namespace burnish::gpu {

ClothStore::Means ClothStore::find(const ClothLobe& lobe, WeaveDetail detail) const {
    for (const Known& known : known_)
        if (known.detail == detail && known.lobe == lobe)
            if (Means means = known.means.lock()) return means;
    return nullptr;
}

ClothStore::Means ClothStore::keep(const ClothLobe& lobe, ClothMeans means) {
    std::erase_if(known_, [](const Known& known) { return known.means.expired(); });
    auto kept = std::make_shared<const ClothMeans>(std::move(means));
    known_.push_back({lobe, kept->detail, kept});
    if (kept->detail == WeaveDetail::coarse) return kept;
    kept_.push_front(kept);
    if (kept_.size() > kMostKept) kept_.pop_back();
    return kept;
}

ClothStore::Means ClothStore::require(const ClothLobe& lobe) {
    if (Means full = find(lobe, WeaveDetail::full)) return full;
    if (!prefers_coarse_) return keep(lobe, cloth_means(lobe, WeaveDetail::full));
    if (Means coarse = find(lobe, WeaveDetail::coarse)) return coarse;
    return keep(lobe, cloth_means(lobe, WeaveDetail::coarse));
}

std::optional<ClothLobe> ClothStore::coarse_one() const {
    for (const Known& known : known_)
        if (known.detail == WeaveDetail::coarse && !known.means.expired() &&
            !find(known.lobe, WeaveDetail::full))
            return known.lobe;
    return std::nullopt;
}

void ClothStore::put(const ClothLobe& lobe, ClothMeans full) {
    if (!find(lobe, WeaveDetail::full)) keep(lobe, std::move(full));
    ++version_;
}

}  // namespace burnish::gpu
