#include "capture/solve/texels.hpp"

#include <algorithm>

namespace burnish {

Texels::Texels(std::size_t first_pixel, std::size_t pixels, bool with_models)
    : first(first_pixel), count(pixels) {
    for_each_field(with_models, [&](auto field, std::size_t values) {
        (this->*field).assign(values * count, {});
    });
    std::fill(exemplar.begin(), exemplar.end(), TabulatedMaterial::kNoExemplar);
    for (std::size_t p = 0; p < count; ++p) normal[3 * p + 2] = 1.0f;
}

bool Texels::whole(bool with_models) const {
    bool all = true;
    for_each_field(with_models, [&](auto field, std::size_t values) {
        all = all && (this->*field).size() == values * count;
    });
    return all;
}

void Texels::merge(const Texels& part) {
    for_each_field(has_models(), [&](auto field, std::size_t values) {
        std::copy(
            (part.*field).begin(), (part.*field).end(),
            (this->*field).begin() + static_cast<std::ptrdiff_t>(values * (part.first - first)));
    });
}

}  // namespace burnish
