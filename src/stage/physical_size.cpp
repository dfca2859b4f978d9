#include "stage/physical_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "burnish/error.hpp"
#include "scene/geometry/texture_scale.hpp"

namespace burnish {
namespace {

// The value held to the range of its parameter.
double held(std::string_view name, double value) {
    const Parameter& p = *find_parameter(name);
    return std::clamp(value, p.low, p.high);
}

}  // namespace

void apply_physical_size(ParameterValues& values, const Scene& scene, std::size_t material,
                         const MaterialAssets& assets, SizeNotes& notes) {
    const auto note = [&](std::string line) {
        const auto known = std::find_if(notes.begin(), notes.end(),
                                        [&](const auto& entry) { return entry.first == line; });
        std::string name = one_line(scene.materials[material].name);
        if (known == notes.end())
            notes.push_back({std::move(line), {std::move(name)}});
        else
            known->second.push_back(std::move(name));
    };
    const bool scratch = values.is_set("scratch") && values.boolean("physical_size");
    const bool weave = names_one(values, "weave") && values.is_set("weave_yarns_per_cm");
    if (!scratch && !weave) return;
    if (scratch && values.is_set("uv_scale"))
        return note("physical_size: uv_scale is set beside it and holds: nothing changes");
    if (weave && values.is_set("weave_yarns"))
        note("weave_yarns: weave_yarns_per_cm is set beside it and holds");
    const std::optional<double> side = texture_square_side(scene, static_cast<int>(material));
    if (!side)
        return note(fmt::format("no triangle has texture coordinates: {} is not drawn in its size",
                                weave ? "the weave" : "the scratch map"));
    if (scratch) {
        const double tile_mm = assets.scratch(values.text("scratch")).tile_mm;
        if (!(tile_mm > 0.0))
            return note(
                fmt::format("{} states no tile_mm: it is not drawn in its size (--uv-scale)",
                            shown(values.text("scratch"))));
        const double scale = held("uv_scale", *side * 1000.0 / tile_mm);
        values.set_value("uv_scale", scale);
        return note(
            fmt::format("the texture square is {:.4g} m wide: a tile of {:g} mm repeats {:.4g} "
                        "times (--uv-scale {:.4g})",
                        *side, tile_mm, scale, scale));
    }
    const double per_cm = values.real("weave_yarns_per_cm");
    const double yarns = held("weave_yarns", *side * 100.0 * per_cm);
    values.set_value("weave_yarns", yarns);
    note(
        fmt::format("the texture square is {:.4g} m wide: {:g} yarns a centimeter are {:.4g} "
                    "(--weave-yarns {:.4g})",
                    *side, per_cm, yarns, yarns));
}

std::vector<std::string> lines_of(const SizeNotes& notes) {
    std::vector<std::string> lines;
    for (const auto& [line, names] : notes) {
        const std::string others =
            names.size() == 1 ? "" : fmt::format(" and {} others", names.size() - 1);
        lines.push_back(fmt::format("{}{}: {}", names.front(), others, line));
    }
    return lines;
}

}  // namespace burnish
