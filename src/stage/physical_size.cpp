#include "stage/physical_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <optional>

#include "burnish/error.hpp"
#include "burnish/tabulated_material.hpp"
#include "scene/geometry/texture_scale.hpp"
#include "stage/map_textures.hpp"

namespace burnish {
namespace {

// Texture squares whose quartiles differ by less are of one size to the eye.
constexpr double kEven = 1.1;

// Beyond this length, in meters, a model is likelier to be a thing in millimeters or centimeters than
// a building on which scratches or yarns are drawn.
constexpr double kLongModel = 20.0;

void add_size_line(SizeLines& lines, std::string line, const std::string& material) {
    const auto known = std::find_if(lines.begin(), lines.end(),
                                    [&](const auto& entry) { return entry.first == line; });
    if (known == lines.end())
        lines.push_back({std::move(line), {one_line(material)}});
    else
        known->second.push_back(one_line(material));
}

// What has a size beside the weave: a name for messages and the width of its tile, 0: not stated.
struct StatedTile {
    std::string what;
    double mm = 0.0;
    std::string remedy;  // a flag that states the size
};

std::optional<StatedTile> tile_of(const ParameterValues& values, const MaterialAssets& assets) {
    const bool by_its_own = values.boolean("physical_size");
    if (values.is_set("scratch") && by_its_own) {
        const std::string name = values.text("scratch");
        return StatedTile{shown(name), assets.scratch(name).tile_mm, "--uv-scale"};
    }
    const bool maps = names_maps(values) || names_one(values, "normal_map");
    if (maps && values.is_set("maps_tile_mm"))
        return StatedTile{"maps_tile_mm", values.real("maps_tile_mm"), ""};
    if (!by_its_own) return std::nullopt;
    if (names_one(values, "tabulated")) {
        const std::string name = values.text("tabulated");
        return StatedTile{shown(name), assets.tabulated(name)->width_mm, "--uv-scale"};
    }
    if (!maps) return std::nullopt;
    const std::string name =
        names_one(values, "maps") ? shown(values.text("maps")) : std::string("the map");
    return StatedTile{name, names_maps(values) ? assets.maps(values).tile_mm : 0.0,
                      "--maps-tile-mm states it"};
}

// Four digits or more, never 1e+05.
std::string plain(double number) {
    return std::abs(number) >= 1000.0 ? fmt::format("{:.0f}", number)
                                      : fmt::format("{:.4g}", number);
}

// Applies sizes to one material.
class Sizer {
  public:
    Sizer(ParameterValues& values, const Scene& scene, std::size_t material, SizeReport& report)
        : values_(values),
          square_(texture_square(scene, static_cast<int>(material))),
          name_(scene.materials[material].name),
          report_(report) {}

    void size_tile(const StatedTile& tile) {
        if (values_.is_set("uv_scale"))
            return warn("uv_scale is set and holds: the physical size changes nothing");
        if (!(tile.mm > 0.0))
            return warn(
                fmt::format("{} states no width of its tile: it is not drawn in its size ({})",
                            tile.what, tile.remedy));
        if (!square_) return warn(without_coordinates("the map"));
        const double wanted = square_->side * 1000.0 / tile.mm;
        const double scale = set("uv_scale", wanted);
        const double mm = tile.mm * wanted / scale;
        note(
            fmt::format("the texture square is {} m wide: a tile of {} mm repeats {} times "
                        "(--uv-scale {}){}",
                        plain(square_->side), plain(mm), plain(scale), plain(scale),
                        spread(mm * square_->low / square_->side,
                               mm * square_->high / square_->side, "a tile is", "mm wide")));
    }

    void size_weave() {
        if (values_.is_set("weave_yarns"))
            warn("weave_yarns: weave_yarns_per_cm is set beside it and holds");
        if (!square_) return warn(without_coordinates("the weave"));
        const double wanted = square_->side * 100.0 * values_.real("weave_yarns_per_cm");
        const double yarns = set("weave_yarns", wanted);
        const double per_cm = yarns / (square_->side * 100.0);
        note(fmt::format(
            "the texture square is {} m wide: {} yarns a centimeter are {} (--weave-yarns {}){}",
            plain(square_->side), plain(per_cm), plain(yarns), plain(yarns),
            spread(per_cm * square_->side / square_->high, per_cm * square_->side / square_->low,
                   "there are", "yarns a centimeter")));
    }

  private:
    void warn(std::string line) { add_size_line(report_.warnings, std::move(line), name_); }
    void note(std::string line) { add_size_line(report_.notes, std::move(line), name_); }

    static std::string without_coordinates(std::string_view what) {
        return fmt::format("no triangle has texture coordinates: {} is not drawn in its size",
                           what);
    }

    // Sets the parameter to the value that its range allows, and returns it.
    double set(std::string_view name, double wanted) {
        const Parameter& p = *find_parameter(name);
        const double value = std::clamp(wanted, p.low, p.high);
        values_.set_value(name, value);
        if (value != wanted)
            warn(
                fmt::format("{}: {} is needed for the physical size, {} to {} are possible: {} is "
                            "drawn, {} times as large as asked for",
                            name, plain(wanted), plain(p.low), plain(p.high), plain(value),
                            plain(wanted / value)));
        return value;
    }

    // Of a mesh whose texture density varies: what the size is over the middle half of its area.
    std::string spread(double low, double high, std::string_view before,
                       std::string_view after) const {
        if (square_->high < kEven * square_->low) return "";
        return fmt::format(
            "; this holds on average: over the middle half of the area {} {:.3g} to {:.3g} {}",
            before, low, high, after);
    }

    ParameterValues& values_;
    std::optional<TextureSquare> square_;
    std::string name_;
    SizeReport& report_;
};

std::vector<std::string> lines_of(const SizeLines& sizes) {
    std::vector<std::string> lines;
    for (const auto& [line, names] : sizes) {
        const std::string others =
            names.size() == 1 ? "" : fmt::format(" and {} others", names.size() - 1);
        lines.push_back(fmt::format("{}{}: {}", names.front(), others, line));
    }
    return lines;
}

}  // namespace

void apply_physical_size(ParameterValues& values, const Scene& scene, std::size_t material,
                         const MaterialAssets& assets, SizeReport& report) {
    const std::optional<StatedTile> tile = tile_of(values, assets);
    const bool weave = names_one(values, "weave") && values.is_set("weave_yarns_per_cm");
    if (!tile && !weave) return;
    Sizer sizer(values, scene, material, report);
    if (tile) sizer.size_tile(*tile);
    if (weave) sizer.size_weave();
}

void append_sizes(const SizeReport& report, const Scene& scene, Remarks& remarks) {
    for (std::string& line : lines_of(report.warnings)) remarks.warnings.push_back(std::move(line));
    if (report.notes.empty()) return;
    for (std::string& line : lines_of(report.notes)) remarks.notes.push_back(std::move(line));
    const Bounds bounds = bounds_of(scene);
    const glm::vec3 size = bounds.high - bounds.low;
    const auto across = static_cast<double>(std::max({size.x, size.y, size.z}));
    if (across > kLongModel) {
        remarks.warnings.push_back(
            fmt::format("physical sizes take the model's unit as the meter (glTF says so, OBJ says "
                        "nothing): it "
                        "is {:.4g} m long; if its unit is the millimeter or the centimeter, give "
                        "it a \"scale\" "
                        "of 0.001 or 0.01 in a scene file",
                        across));
    } else {
        remarks.notes.push_back(fmt::format(
            "physical sizes take the model's unit as the meter: it is {:.4g} m long", across));
    }
}

}  // namespace burnish
