// Reads our rig JSON; docs/reference/rig-file.md has the schema.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "burnish/error.hpp"
#include "capture/rig/rig_reading.hpp"
#include "formats/json_text.hpp"

namespace burnish::rig_reading {

namespace {

constexpr std::string_view kFormat = "burnish-rig";
constexpr std::size_t kMostExposures = 64;
constexpr double kHighestExponent = 1000.0;

class Reader {
  public:
    Reader(const Request& request, const nlohmann::json& document)
        : request_(request), file_(request.path.string()), root_(file_, document) {}

    Reading read() {
        constexpr std::array<std::string_view, 9> kKeys = {"format",   "version", "units",
                                                           "response", "sample",  "camera",
                                                           "mask",     "white",   "lights"};
        root_.require_object();
        if (!root_.has("format"))
            throw Error(file_, "format", fmt::format("\"{}\"", kFormat), "none");
        if (root_.at("format").text() != kFormat) root_.at("format").fail(kFormat);
        if (root_.at("version").value() != 1) root_.at("version").fail("1");
        root_.require_object(kKeys);
        if (root_.has("units") && root_.at("units").text() != "mm")
            root_.at("units").fail("\"mm\", the only unit");
        if (root_.has("response")) response_ = read_response(root_.at("response"));
        read_sample(root_.at("sample"));
        if (root_.has("mask")) rig_.mask = read_file(root_.at("mask"));
        if (root_.has("white")) rig_.white = read_file(root_.at("white"));
        read_lights(root_.at("lights"));
        read_camera();
        return {std::move(rig_), response_};
    }

  private:
    static RigResponse read_response(const JsonPlace& place) {
        const std::string name = place.text();
        if (name != "linear" && name != "srgb") place.fail("\"linear\" or \"srgb\"");
        return name == "linear" ? RigResponse::linear : RigResponse::srgb;
    }

    void read_sample(const JsonPlace& place) {
        constexpr std::array<std::string_view, 2> kKeys = {"width", "height"};
        place.require_object(kKeys);
        rig_.width_mm = place.at("width").number(kSmallest, kLargest);
        rig_.height_mm = place.at("height").number(kSmallest, kLargest);
    }

    void read_camera() {
        // A common camera may be missing only if every light has its own or the caller gives one.
        bool all_have = true;
        for (const RigLight& light : rig_.lights) all_have = all_have && light.camera;
        if (!root_.has("camera") && (request_.has_camera || all_have)) return;
        rig_.camera = read_camera(root_.at("camera"));
    }

    RigPlace read_camera(const JsonPlace& place) {
        constexpr std::array<std::string_view, 2> kKeys = {"position", "direction"};
        place.require_object(kKeys);
        return read_place(place);
    }

    std::filesystem::path read_file(const JsonPlace& place) const {
        const std::string name = place.text();
        require_name(file_, place.path(), name);
        std::filesystem::path path = request_.pictures.find_aside(place.path(), name);
        if (request_.needs_images && !is_there(path)) fail_missing(file_, place.path(), name);
        return path;
    }

    std::filesystem::path read_picture(const JsonPlace& place) const {
        return request_.picture(place.path(), place.text());
    }

    Vec3d read_direction(const JsonPlace& place) {
        const Vec3d v = place.double_triple(-kFarthest, kFarthest);
        const double size = length(v);
        if (!(size > kShortest)) place.fail("a direction that is not zero");
        if (size > 2.0)  // [1, 1, 1] is a usual way to write a direction
            rig_.warnings.push_back(fmt::format(
                "{}: a direction of length {:.4g}: is it a position?", place.path(), size));
        return normalized(v);
    }

    RigPlace read_place(const JsonPlace& place) {
        const bool position = place.has("position"), direction = place.has("direction");
        if (position == direction)
            throw Error(file_, place.path(), "either \"position\" or \"direction\"",
                        position ? "both" : "neither");
        if (direction) return {false, read_direction(place.at("direction"))};
        return {true, place.at("position").double_triple(-kFarthest, kFarthest)};
    }

    static Vec3d read_intensity(const JsonPlace& place) {
        if (place.value().is_array()) return place.double_triple(kFaintestLight, kBrightestLight);
        const double all = place.number(kFaintestLight, kBrightestLight);
        return {all, all, all};
    }

    void read_emission(const JsonPlace& place, RigLight& light) {
        for (const char* key : {"emission_axis", "emission_exponent"})
            if (!light.place.near && place.has(key))
                throw Error(file_, fmt::format("{}.{}", place.path(), key),
                            "a light with a position", "a direction");
        if (place.has("emission_exponent"))
            light.emission_exponent = place.at("emission_exponent").number(0.0, kHighestExponent);
        if (!place.has("emission_axis")) return;
        const JsonPlace axis = place.at("emission_axis");
        light.emission_axis = read_direction(axis);
        const Vec3d to_light = direction_to(light.place, {0.0, 0.0, 0.0});
        double cosine = 0.0;
        for (std::size_t i = 0; i < 3; ++i) cosine -= light.emission_axis[i] * to_light[i];
        // For a light below the sample the position is the error, not the axis; check_places
        // reports it.
        if (!(cosine > 0.0) && light.place.at[2] >= kSmallest)
            axis.fail("an axis that points from the light to the sample");
    }

    std::vector<RigExposure> read_images(const JsonPlace& place) const {
        const bool one = place.has("image"), bracket = place.has("exposures");
        if (one && bracket) throw Error(file_, place.path(), "\"image\" or \"exposures\"", "both");
        if (one) return {{read_picture(place.at("image")), 1.0}};
        if (!bracket) {
            if (request_.needs_images && !request_.by_order)
                place.at("image");  // throws: the key is missing
            return {};
        }
        constexpr std::array<std::string_view, 2> kKeys = {"image", "exposure"};
        const JsonPlace list = place.at("exposures");
        list.require_array(kMostExposures);
        if (list.size() == 0) list.fail("at least one exposure");
        std::vector<RigExposure> exposures;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const JsonPlace entry = list.at(i);
            entry.require_object(kKeys);
            exposures.push_back({read_picture(entry.at("image")),
                                 entry.at("exposure").number(kFaintest, kBrightest)});
        }
        return exposures;
    }

    // A light without an intensity among lights that state other ones than 1.
    void warn_of_unstated(const std::vector<std::size_t>& unstated) {
        const bool differ =
            std::any_of(rig_.lights.begin(), rig_.lights.end(), [](const RigLight& light) {
                return light.intensity != Vec3d{1.0, 1.0, 1.0};
            });
        if (unstated.empty() || !differ) return;
        rig_.warnings.push_back(fmt::format(
            "{}: no intensity, which {} of {} lights state: taken as 1{}",
            rig_.lights[unstated.front()].where, rig_.lights.size() - unstated.size(),
            rig_.lights.size(),
            unstated.size() == 1 ? std::string()
                                 : fmt::format("; so are {} more", unstated.size() - 1)));
    }

    void read_lights(const JsonPlace& place) {
        constexpr std::array<std::string_view, 8> kKeys = {
            "image",     "exposures",     "position",          "direction",
            "intensity", "emission_axis", "emission_exponent", "camera"};
        place.require_array(kMostLights);
        if (place.size() == 0) place.fail("at least one light");
        std::vector<std::size_t> unstated;
        for (std::size_t i = 0; i < place.size(); ++i) {
            const JsonPlace entry = place.at(i);
            entry.require_object(kKeys);
            RigLight light;
            light.where = entry.path();
            light.images = read_images(entry);
            light.place = read_place(entry);
            if (entry.has("intensity")) {
                light.intensity = read_intensity(entry.at("intensity"));
                rig_.intensity_stated = true;
            } else {
                unstated.push_back(i);
            }
            read_emission(entry, light);
            if (entry.has("camera")) light.camera = read_camera(entry.at("camera"));
            rig_.lights.push_back(std::move(light));
        }
        warn_of_unstated(unstated);
    }

    const Request& request_;
    std::string file_;
    JsonPlace root_;
    Rig rig_;
    std::optional<RigResponse> response_;
};

}  // namespace

Reading read_rig_json(const Request& request) {
    const std::string file = request.path.string();
    const nlohmann::json document = parse_json(file, request.text);
    return Reader(request, document).read();
}

}  // namespace burnish::rig_reading
