#include "burnish/weave_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/large_pages.hpp"
#include "core/parallel.hpp"
#include "image/large_image.hpp"
#include "maps/weave/weave_cells.hpp"

namespace burnish {

namespace {

constexpr int kLeastSide = 16, kMostSide = 16384;
constexpr int kLeastTexelsAYarn = 4;

// The yarn under a row or column of texels, and the distance from its middle.
struct Place {
    int yarn = 0;  // on the tile
    float offset = 0.0f;
};

std::vector<Place> places(int texels, int yarns, bool upwards) {
    std::vector<Place> out(static_cast<std::size_t>(texels));
    for (int i = 0; i < texels; ++i) {
        const int from_start = upwards ? texels - 1 - i : i;
        const double at = (from_start + 0.5) * yarns / texels;
        const int yarn = std::min(static_cast<int>(at), yarns - 1);
        out[static_cast<std::size_t>(i)] = {yarn, static_cast<float>(at - yarn - 0.5)};
    }
    return out;
}

std::vector<f32::WeaveCell> cells_of(const Draft& draft) {
    std::vector<f32::WeaveCell> cells;
    cells.reserve(draft.warp_up.size());
    for (int pick = 0; pick < draft.picks; ++pick)
        for (int end = 0; end < draft.ends; ++end) cells.push_back(weave_cell(draft, end, pick));
    return cells;
}

class Baker {
  public:
    Baker(const WeaveMapSettings& settings, WeaveMaps& maps)
        : settings_(settings),
          maps_(maps),
          columns_(places(maps.width, maps.ends, false)),
          rows_(places(maps.height, maps.picks, true)),
          cells_(cells_of(settings.draft)) {}

    void bake_row(int y) const {
        const Place row = rows_[static_cast<std::size_t>(y)];
        const auto ends = static_cast<std::size_t>(settings_.draft.ends);
        const f32::WeaveCell* cells =
            cells_.data() + static_cast<std::size_t>(row.yarn % settings_.draft.picks) * ends;
        const auto yarn_mm = static_cast<float>(settings_.yarn_mm);
        float* height = maps_.heights.at(0, y);
        float* normal = maps_.normals.at(0, y);
        float* direction = maps_.direction.at(0, y);
        std::uint16_t* yarn = maps_.yarns.data() +
                              static_cast<std::size_t>(y) * static_cast<std::size_t>(maps_.width);
        for (const Place& column : columns_) {
            const f32::WeaveCell& cell = cells[static_cast<std::size_t>(column.yarn) % ends];
            const f32::WeavePoint point =
                f32::weave_point(cell, settings_.shape, column.offset, row.offset);
            const bool there = point.cover > 0.0f, warp = point.warp > 0.5f;
            // A hole is flat, at the depth of the lowest yarns.
            *height++ = yarn_mm * (there ? point.height : -settings_.shape.crimp);
            *normal++ = there ? point.n.x : 0.0f;
            *normal++ = there ? point.n.y : 0.0f;
            const f32::vec2 f = point.fiber;
            *direction++ = there ? f.x * f.x - f.y * f.y : 0.0f;
            *direction++ = there ? 2.0f * f.x * f.y : 0.0f;
            *yarn++ = static_cast<std::uint16_t>(
                !there ? 0 : 1 + (warp ? column.yarn : maps_.ends + row.yarn));
        }
    }

  private:
    const WeaveMapSettings& settings_;
    WeaveMaps& maps_;
    std::vector<Place> columns_, rows_;
    std::vector<f32::WeaveCell> cells_;
};

void require(bool good, std::string_view where, std::string_view key, std::string_view expected,
             const std::string& found) {
    if (!good) throw UsageError(where, key, expected, found);
}

const std::uint16_t* yarns_of_row(const WeaveMaps& maps, int y) {
    return maps.yarns.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(maps.width);
}

}  // namespace

std::uint64_t weave_map_memory(const WeaveMapSettings& settings) {
    constexpr std::uint64_t kBytesATexel = 5 * sizeof(float) + sizeof(std::uint16_t);
    constexpr std::uint64_t kRest = 16 << 20;  // cells, strips of images
    return static_cast<std::uint64_t>(settings.width) *
               static_cast<std::uint64_t>(settings.height) * kBytesATexel +
           kRest;
}

void check_weave_map_settings(const WeaveMapSettings& settings, std::string_view where) {
    check_draft(settings.draft, where);
    const auto side = [&](int texels, int yarns, int repeats, const char* key, const char* of) {
        require(texels >= kLeastSide && texels <= kMostSide, where, key,
                fmt::format("{} to {} texels", kLeastSide, kMostSide), fmt::format("{}", texels));
        require(repeats >= 1, where, "repeats", "1 or more", fmt::format("{}", repeats));
        require(static_cast<std::int64_t>(yarns) * repeats * kLeastTexelsAYarn <= texels, where,
                key, fmt::format("at least {} texels for each of the {}", kLeastTexelsAYarn, of),
                fmt::format("{} texels for {} x {} of them", texels, repeats, yarns));
    };
    side(settings.width, settings.draft.ends, settings.repeats_u, "width", "ends");
    side(settings.height, settings.draft.picks, settings.repeats_v, "height", "picks");
    require(settings.yarn_mm >= 0.001 && settings.yarn_mm <= 1000.0, where, "yarn_mm",
            "a number from 0.001 to 1000", fmt::format("{:g}", settings.yarn_mm));
}

WeaveMaps bake_weave(const WeaveMapSettings& settings, std::uint64_t memory_limit,
                     const Progress& progress) {
    check_weave_map_settings(settings, "weave maps");
    const std::uint64_t needed = weave_map_memory(settings);
    if (needed > memory_limit)
        throw Error("weave maps", fmt::format("size {}x{}", settings.width, settings.height),
                    fmt::format("{:.1f} MB of free memory", static_cast<double>(needed) / 1e6),
                    fmt::format("{:.1f} MB", static_cast<double>(memory_limit) / 1e6));
    WeaveMaps maps;
    maps.width = settings.width;
    maps.height = settings.height;
    maps.ends = settings.ends();
    maps.picks = settings.picks();
    progress.step("weave", 0.0);
    maps.heights = image_on_large_pages(maps.width, maps.height, 1);
    maps.normals = image_on_large_pages(maps.width, maps.height, 2);
    maps.direction = image_on_large_pages(maps.width, maps.height, 2);
    maps.yarns.resize(static_cast<std::size_t>(maps.width) * static_cast<std::size_t>(maps.height));
    const Baker baker(settings, maps);
    // Cancellation takes effect between these steps only.
    constexpr int kStep = 512;
    for (int from = 0; from < maps.height; from += kStep) {
        progress.step("weave", static_cast<double>(from) / maps.height);
        const int rows = std::min(kStep, maps.height - from);
        parallel_for(static_cast<std::size_t>(rows), 8, [&](std::size_t begin, std::size_t end) {
            for (std::size_t y = begin; y < end; ++y) baker.bake_row(from + static_cast<int>(y));
        });
    }
    progress.step("weave", 1.0);
    return maps;
}

void weave_normal_rows(const WeaveMaps& maps, int begin, int end, float* to) {
    const float* from = maps.normals.at(0, begin);
    for (int i = 0; i < (end - begin) * maps.width; ++i, from += 2) {
        *to++ = 0.5f + 0.5f * from[0];
        *to++ = 0.5f + 0.5f * from[1];
        *to++ =
            0.5f + 0.5f * std::sqrt(std::max(1.0f - from[0] * from[0] - from[1] * from[1], 0.0f));
    }
}

void weave_direction_rows(const WeaveMaps& maps, int begin, int end, float* to) {
    const float* from = maps.direction.at(0, begin);
    for (int i = 0; i < (end - begin) * maps.width; ++i, from += 2) {
        *to++ = 0.5f + 0.5f * from[0];
        *to++ = 0.5f + 0.5f * from[1];
        *to++ = from[0] == 0.0f && from[1] == 0.0f ? 0.0f : 1.0f;
    }
}

void weave_stretch_rows(const WeaveMaps& maps, float strength, int begin, int end, float* to) {
    const float* line = maps.direction.at(0, begin);
    const std::uint16_t* yarn = yarns_of_row(maps, begin);
    for (int i = 0; i < (end - begin) * maps.width; ++i, line += 2, ++yarn) {
        const bool there = *yarn != 0, warp = there && *yarn <= maps.ends;
        float angle = 0.5f * std::atan2(line[1], line[0]);
        // Fibers of the warp point up, of the weft to the right: arrows agree within a family.
        if (warp && angle < 0.0f) angle += std::numbers::pi_v<float>;
        *to++ = there ? 0.5f - 0.5f * std::sin(angle) : 1.0f;
        *to++ = there ? 0.5f + 0.5f * std::cos(angle) : 0.5f;
        *to++ = there ? strength : 0.0f;
    }
}

glm::vec3 weave_yarn_color(const WeaveMaps& maps, const WeaveMapSettings& settings, int yarn) {
    if (yarn == 0) return glm::vec3(0.0f);
    const Draft& draft = settings.draft;
    const bool warp = yarn <= maps.ends;
    const std::vector<glm::vec3>& colors = warp ? draft.warp_colors : draft.weft_colors;
    if (colors.empty()) return warp ? settings.warp_color : settings.weft_color;
    const int number = warp ? yarn - 1 : yarn - 1 - maps.ends;
    return colors[static_cast<std::size_t>(number) % colors.size()];
}

void weave_color_rows(const WeaveMaps& maps, const WeaveMapSettings& settings, int begin, int end,
                      float* to) {
    std::vector<glm::vec3> colors;  // by yarn number
    for (int yarn = 0; yarn <= maps.ends + maps.picks; ++yarn) {
        const glm::vec3 c = weave_yarn_color(maps, settings, yarn);
        colors.emplace_back(srgb_from_linear(c.x), srgb_from_linear(c.y), srgb_from_linear(c.z));
    }
    const std::uint16_t* from = yarns_of_row(maps, begin);
    for (int i = 0; i < (end - begin) * maps.width; ++i) {
        const glm::vec3& c = colors[*from++];
        for (const float value : {c.x, c.y, c.z}) *to++ = value;
    }
}

void weave_id_rows(const WeaveMaps& maps, const WeaveMapSettings& settings, int begin, int end,
                   float* to) {
    const Draft& draft = settings.draft;
    const std::vector<Place> columns = places(maps.width, maps.ends, false);
    const std::vector<Place> rows = places(maps.height, maps.picks, true);
    for (int y = begin; y < end; ++y) {
        const int pick = rows[static_cast<std::size_t>(y)].yarn % draft.picks;
        const std::uint16_t* from = yarns_of_row(maps, y);
        for (const Place& column : columns) {
            const int yarn = *from++;
            const bool there = yarn != 0, warp = there && yarn <= maps.ends;
            const int number = warp ? yarn - 1 : yarn - 1 - maps.ends;
            const float count = static_cast<float>(warp ? maps.ends : maps.picks);
            const bool upper = draft.is_warp_up(column.yarn % draft.ends, pick) == warp;
            *to++ = !there ? 0.0f : warp ? 1.0f : 0.5f;
            *to++ = there ? (static_cast<float>(number) + 0.5f) / count : 0.0f;
            *to++ = there && upper ? 1.0f : 0.0f;
        }
    }
}

}  // namespace burnish
