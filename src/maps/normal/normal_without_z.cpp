#include "maps/normal/normal_without_z.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "burnish/error.hpp"

namespace burnish {
namespace {

// n = 2 c - 1 of a stored channel.
template <typename Stored>
double axis_of(Stored stored) {
    if constexpr (std::is_same_v<Stored, float>) return 2.0 * stored - 1.0;
    return 2.0 * stored / std::numeric_limits<Stored>::max() - 1.0;
}

// How far z may be from the root of 1 - x^2 - y^2 by rounding: three steps of z, and what a step of x
// and y moves it where z is small.
template <typename Stored>
double z_tolerance(double z) {
    const double step = std::is_same_v<Stored, float>
                            ? 1e-5  // maps are made from 16-bit ones at best
                            : 2.0 / static_cast<double>(std::numeric_limits<Stored>::max());
    return step * (3.0 + 2.0 / std::max(z, 0.05));
}

template <typename Stored>
bool lacks_z(const Texture& map) {
    const auto channels = static_cast<std::size_t>(map.channels);
    const std::size_t texels = map.texels.size() / (channels * sizeof(Stored));
    bool any = false, varies = false, consistent = true;
    Stored first[3] = {};
    for (std::size_t i = 0; i < texels; ++i) {
        Stored rgb[3];
        std::memcpy(rgb, map.texels.data() + i * channels * sizeof(Stored), sizeof rgb);
        if (rgb[0] == Stored{0} && rgb[1] == Stored{0} && rgb[2] == Stored{0}) continue;
        if (!any) std::copy_n(rgb, 3, first);
        any = true;
        if (!(rgb[2] == first[2])) return false;
        varies = varies || rgb[0] != first[0] || rgb[1] != first[1];
        const double x = axis_of(rgb[0]), y = axis_of(rgb[1]);
        const double z = std::sqrt(std::max(1.0 - x * x - y * y, 0.0));
        consistent = consistent && std::abs(axis_of(rgb[2]) - z) <= z_tolerance<Stored>(z);
    }
    return varies && !consistent;
}

bool lacks_z(const Texture& map) {
    switch (map.type) {
        case TexelType::u8:
            return lacks_z<std::uint8_t>(map);
        case TexelType::u16:
            return lacks_z<std::uint16_t>(map);
        case TexelType::f32:
            return lacks_z<float>(map);
    }
    return false;
}

}  // namespace

std::optional<Texture> normal_map_without_z(const Texture& map) {
    if (map.channels < 3 || !lacks_z(map)) return std::nullopt;
    Texture xy = map;
    xy.channels = 2;
    const std::size_t from = map.texels.size() / (static_cast<std::size_t>(map.width) *
                                                  static_cast<std::size_t>(map.height));
    const std::size_t to = from / static_cast<std::size_t>(map.channels) * 2;
    xy.texels.resize(map.texels.size() / from * to);
    for (std::size_t i = 0; i * to < xy.texels.size(); ++i)
        std::memcpy(xy.texels.data() + i * to, map.texels.data() + i * from, to);
    return xy;
}

std::string normal_without_z_warning(std::string_view name) {
    return fmt::format(
        "{}: a normal map whose blue is the same everywhere: it holds x and y, and z is taken from "
        "them",
        one_line(std::string(name)));
}

}  // namespace burnish
