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
                         const MaterialAssets& assets, std::vector<std::string>& notes) {
    const bool scratch =
        values.is_set("scratch") && values.boolean("physical_size") && !values.is_set("uv_scale");
    const bool weave = names_one(values, "weave") && values.is_set("weave_yarns_per_cm");
    if (!scratch && !weave) return;
    const auto note = [&](std::string line) {
        if (std::find(notes.begin(), notes.end(), line) == notes.end())
            notes.push_back(std::move(line));
    };
    const std::string name = one_line(scene.materials[material].name);
    const std::optional<double> side = texture_square_side(scene, static_cast<int>(material));
    if (!side) {
        note(fmt::format("{}: no triangle has texture coordinates: {} is not drawn in its size",
                         name, weave ? "the weave" : "the scratch map"));
        return;
    }
    if (scratch) {
        const double tile_mm = assets.scratch(values.text("scratch")).tile_mm;
        if (!(tile_mm > 0.0)) {
            note(fmt::format("{}: {} states no tile_mm: it is not drawn in its size (--uv-scale)",
                             name, shown(values.text("scratch"))));
            return;
        }
        const double scale = held("uv_scale", *side * 1000.0 / tile_mm);
        values.set_value("uv_scale", scale);
        note(
            fmt::format("{}: the texture square is {:.4g} m wide: a tile of {:g} mm repeats {:.4g} "
                        "times (--uv-scale {:.4g})",
                        name, *side, tile_mm, scale, scale));
        return;
    }
    const double per_cm = values.real("weave_yarns_per_cm");
    const double yarns = held("weave_yarns", *side * 100.0 * per_cm);
    values.set_value("weave_yarns", yarns);
    note(
        fmt::format("{}: the texture square is {:.4g} m wide: {:g} yarns a centimeter are {:.4g} "
                    "(--weave-yarns {:.4g})",
                    name, *side, per_cm, yarns, yarns));
}

}  // namespace burnish
