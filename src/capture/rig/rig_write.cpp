// Writes our rig JSON and .lp files.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "burnish/error.hpp"
#include "burnish/rig.hpp"
#include "capture/rig/rig_reading.hpp"
#include "core/files.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string relative_to(const fs::path& folder, const fs::path& file) {
    const fs::path base = fs::absolute(folder).lexically_normal();
    const fs::path whole = fs::absolute(file).lexically_normal();
    const fs::path relative = whole.lexically_relative(base);
    return (relative.empty() ? whole : relative).generic_string();
}

ordered_json place_of(const RigPlace& place) {
    return {{place.near ? "position" : "direction", place.at}};
}

ordered_json light_of(const RigLight& light, bool intensity_stated, const fs::path& folder) {
    ordered_json out = ordered_json::object();
    if (light.images.size() == 1 && light.images[0].exposure == 1.0) {
        out["image"] = relative_to(folder, light.images[0].image);
    } else {
        for (const RigExposure& exposure : light.images)
            out["exposures"].push_back(
                {{"image", relative_to(folder, exposure.image)}, {"exposure", exposure.exposure}});
    }
    out.update(place_of(light.place));
    const Vec3d& rgb = light.intensity;
    if (rgb[0] != rgb[1] || rgb[0] != rgb[2]) {
        out["intensity"] = rgb;
    } else if (intensity_stated || rgb[0] != 1.0) {
        out["intensity"] = rgb[0];
    }
    if (light.place.near && light.emission_exponent > 0.0) {
        out["emission_axis"] = light.emission_axis;
        out["emission_exponent"] = light.emission_exponent;
    }
    if (light.camera) out["camera"] = place_of(*light.camera);
    return out;
}

// Writes one line for each light, so that two files can be compared line by line.
std::string text_of(const fs::path& path, const Rig& rig) {
    const fs::path folder = fs::absolute(path).parent_path();
    ordered_json head = {{"format", "burnish-rig"},
                         {"version", 1},
                         {"units", "mm"},
                         {"response", rig.response == RigResponse::linear ? "linear" : "srgb"},
                         {"sample", {{"width", rig.width_mm}, {"height", rig.height_mm}}},
                         {"camera", place_of(rig.camera)}};
    if (rig.mask) head["mask"] = relative_to(folder, *rig.mask);
    if (rig.white) head["white"] = relative_to(folder, *rig.white);
    std::string text = "{\n";
    for (const auto& [key, value] : head.items())
        text += fmt::format("  \"{}\": {},\n", key, value.dump());
    text += "  \"lights\": [\n";
    for (std::size_t i = 0; i < rig.lights.size(); ++i)
        text +=
            fmt::format("    {}{}\n", light_of(rig.lights[i], rig.intensity_stated, folder).dump(),
                        i + 1 < rig.lights.size() ? "," : "");
    return text + "  ]\n}\n";
}

}  // namespace

void write_rig(const fs::path& path, const Rig& rig) {
    if (!(rig.width_mm > 0.0 && rig.height_mm > 0.0))
        throw Error(path.string(), "sample", "a sample with a size", "none");
    std::string text;
    try {
        text = text_of(path, rig);
    } catch (const nlohmann::json::exception&) {  // JSON strings must be UTF-8
        throw Error(path.string(), "lights", "names of pictures in UTF-8", "other bytes");
    }
    write_text_file(path, text);
}

void write_lp(const fs::path& path, const Rig& rig) {
    const fs::path folder = fs::absolute(path).parent_path();
    std::string text = fmt::format("{}\n", rig.lights.size());
    for (const RigLight& light : rig.lights) {
        if (light.place.near || light.images.size() != 1)
            throw Error(path.string(), light.where, "a direction and one picture",
                        "something else");
        const std::string name = relative_to(folder, light.images[0].image);
        // A newline would end the entry, and readers trim blanks at both ends of a name.
        rig_reading::require_name(path.string(), light.where, name);
        if (name.empty() || name.front() == ' ' || name.back() == ' ')
            throw Error(path.string(), light.where, "a name without blanks at its ends",
                        shown(name));
        const Vec3d& d = light.place.at;
        text += fmt::format("{} {:.8f} {:.8f} {:.8f}\n", name, d[0], d[1], d[2]);
    }
    write_text_file(path, text);
}

}  // namespace burnish
