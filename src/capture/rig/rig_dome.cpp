// .dome files of relight: the lights of a dome, without pictures. docs/reference/rig-file.md lists
// the keys.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/shading_names.hpp"
#include "capture/rig/rig_reading.hpp"
#include "core/text.hpp"
#include "formats/json_text.hpp"

namespace burnish::rig_reading {

namespace {

constexpr std::array<std::string_view, 3> kKinds = {"directional", "spherical", "lights3d"};
// All keys without a warning: those that are read and those that do not describe the light.
constexpr std::array<std::string_view, 13> kKeys = {
    "lightConfiguration", "directions",        "positions",  "positions3d",
    "positionsSphere",    "domeDiameter",      "imageWidth", "verticalOffset",
    "ledAdjust",          "lightsCalibration", "label",      "notes",
    "lightSource"};

// [x, y, z] or {"x": .., "y": .., "z": ..}
Vec3d triple(const JsonPlace& place, const std::array<const char*, 3>& names, double low,
             double high) {
    if (!place.value().is_object()) return place.double_triple(low, high);
    Vec3d v{};
    for (std::size_t i = 0; i < 3; ++i) v[i] = place.at(names[i]).number(low, high);
    return v;
}

class Reader {
  public:
    Reader(const Request& request, const nlohmann::json& document)
        : file_(request.path.string()), root_(file_, document) {}

    Reading read() {
        root_.require_object();
        warn_of_unknown_keys();
        if (has("imageWidth")) rig_.width_mm = root_.at("imageWidth").number(0.0, kLargest);
        if (rig_.width_mm < kSmallest) rig_.width_mm = 0.0;  // unknown: relight writes 0
        read_lights();
        read_colors();
        return {std::move(rig_), {}};
    }

  private:
    bool has(std::string_view key) const {
        return root_.has(key) && !root_.at(key).value().is_null();
    }

    // Unknown keys only warn: other programs add keys of their own.
    void warn_of_unknown_keys() {
        for (const std::string& key : root_.keys()) {
            if (std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end()) continue;
            const std::string_view nearest = nearest_name(kKeys, key);
            rig_.warnings.push_back(
                nearest.empty() ? fmt::format("unknown key {} is passed over", shown(key))
                                : fmt::format("unknown key {} is passed over; did you mean '{}'?",
                                              shown(key), nearest));
        }
    }

    std::string kind() const {
        if (!has("lightConfiguration")) return has("directions") ? "directional" : "lights3d";
        const JsonPlace place = root_.at("lightConfiguration");
        std::string name = place.text();
        if (std::find(kKinds.begin(), kKinds.end(), name) == kKinds.end())
            place.fail("directional, spherical or lights3d");
        return name;
    }

    void read_lights() {
        const std::string kind = this->kind();
        if (kind == "lights3d") {
            read_list(has("positions3d") ? "positions3d" : "positions", true);
        } else if (kind == "spherical") {
            read_list("directions", false);
            onto_the_sphere();
        } else {
            read_list("directions", false);
        }
    }

    void read_list(const char* key, bool near) {
        const JsonPlace list = root_.at(key);
        list.require_array(kMostLights);
        if (list.size() == 0) list.fail("at least one light");
        for (std::size_t i = 0; i < list.size(); ++i) {
            const JsonPlace entry = list.at(i);
            RigLight light;
            light.where = entry.path();
            light.place = {near, triple(entry, {"x", "y", "z"}, -kFarthest, kFarthest)};
            if (!near) {
                const double size = length(light.place.at);
                if (!(std::abs(size - 1.0) <= kNearlyUnit)) entry.fail("a direction of length 1");
                light.place.at = normalized(light.place.at);
            }
            rig_.lights.push_back(std::move(light));
        }
    }

    // Moves the lights from directions onto the dome's sphere. The directions start at the origin,
    // the middle of the picture; the sphere's center c is `verticalOffset` above it: |t d - c| = r
    // for t > 0.
    void onto_the_sphere() {
        const double radius = 0.5 * root_.at("domeDiameter").number(kSmallest, kLargest);
        const double offset =
            has("verticalOffset") ? root_.at("verticalOffset").number(-kFarthest, kFarthest) : 0.0;
        if (!(std::abs(offset) < radius))
            root_.at("verticalOffset").fail("less than half of domeDiameter");
        for (RigLight& light : rig_.lights) {
            Vec3d& d = light.place.at;
            const double along = d[2] * offset;
            const double t = along + std::sqrt(along * along + radius * radius - offset * offset);
            for (double& x : d) x *= t;
            light.place.near = true;
        }
    }

    // Both keys hold factors that correct a picture to uniform light; intensities are their
    // inverses.
    void read_colors() {
        for (const char* key : {"ledAdjust", "lightsCalibration"}) {
            if (!has(key)) continue;
            const JsonPlace list = root_.at(key);
            list.require_array(kMostLights);
            if (list.size() == 0) continue;
            if (list.size() != rig_.lights.size())
                throw Error(file_, list.path(), fmt::format("{} entries", rig_.lights.size()),
                            fmt::format("{}", list.size()));
            for (std::size_t i = 0; i < list.size(); ++i)
                correct(rig_.lights[i], list.at(i), key == std::string_view("ledAdjust"));
        }
    }

    void correct(RigLight& light, const JsonPlace& place, bool plain) {
        constexpr std::array<const char*, 3> kColors = {"r", "g", "b"};
        Vec3d factors{1.0, 1.0, 1.0};
        if (plain) {
            factors = triple(place, kColors, kFaintest, kBrightest);
        } else {
            place.require_object();
            if (place.has("whiteBalance"))
                factors = triple(place.at("whiteBalance"), kColors, kFaintest, kBrightest);
            if (place.has("intensity"))
                for (double& factor : factors)
                    factor *= place.at("intensity").number(kFaintest, kBrightest);
            if (place.has("spatialCalibration") && !warned_of_grid_) {
                warned_of_grid_ = true;
                rig_.warnings.emplace_back(
                    "spatialCalibration is passed over: light falls off as 1/r^2");
            }
        }
        for (std::size_t i = 0; i < 3; ++i) {
            light.intensity[i] /= factors[i];
            if (!(light.intensity[i] >= kFaintest && light.intensity[i] <= kBrightest))
                place.fail("a correction that leaves a light");
        }
    }

    std::string file_;
    JsonPlace root_;
    Rig rig_;
    bool warned_of_grid_ = false;
};

}  // namespace

Reading read_dome(const Request& request) {
    const std::string file = request.path.string();
    const nlohmann::json document = parse_json(file, request.text);
    return Reader(request, document).read();
}

}  // namespace burnish::rig_reading
