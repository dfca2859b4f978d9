// Steps shared by rigs of all formats: checks, the caller's overrides, the geometry.
#include "burnish/rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "capture/rig/rig_reading.hpp"
#include "core/files.hpp"
#include "core/utf8.hpp"

namespace burnish {

namespace rig_reading {

double length(const Vec3d& v) {
    return std::hypot(v[0], v[1], v[2]);
}

Vec3d normalized(const Vec3d& v) {
    const double size = length(v);
    // Normalizing a vector that is already unit within rounding would change its last digits at
    // every read.
    if (std::abs(size - 1.0) < 1e-15) return v;
    return {v[0] / size, v[1] / size, v[2] / size};
}

void require_name(const std::string& file, const std::string& where, const std::string& name) {
    for (const char c : name)
        if (static_cast<unsigned char>(c) < 0x20) throw Error(file, where, "a file", shown(name));
}

void fail_missing(const std::string& file, const std::string& where, const std::string& name) {
    throw Error(file, where, "a picture that is there", shown(name));
}

bool is_there(const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error);
}

std::string lower_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

std::filesystem::path Request::picture(const std::string& where, const std::string& name) const {
    require_name(path.string(), where, name);
    return by_order ? path.parent_path() / name : pictures.find(where, name);
}

namespace {

Reading read_any(const std::filesystem::path& path, bool needs_images,
                 const RigOverrides& overrides, PictureFinder& pictures) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        const std::filesystem::path inside = path / "rig.json";
        throw Error(path.string(), "", "a rig file",
                    is_there(inside) ? fmt::format("a folder; {} is one", shown(inside.string()))
                                     : "a folder");
    }
    std::string text = read_text_file(path, kMostBytes);
    const std::string extension = lower_extension(path);
    if (extension == ".lp") text = as_utf8(std::move(text));  // names of pictures, of old programs
    const Request request{
        path, text, needs_images, overrides.camera.has_value(), overrides.by_order, pictures};
    if (extension == ".lp") return read_lp(request);
    if (extension == ".dome") return read_dome(request);
    return read_rig_json(request);
}

// The response of the first picture, for all pictures; warns of a picture of another kind.
RigResponse common_response(Rig& rig) {
    std::optional<RigResponse> usual;
    bool warned = false;
    for (const RigLight& light : rig.lights)
        for (const RigExposure& exposure : light.images) {
            const RigResponse response = usual_response(exposure.image);
            if (!usual) usual = response;
            if (response == *usual || std::exchange(warned, true)) continue;
            rig.warnings.push_back(
                fmt::format("{}: a picture of another kind than the first: all are taken for {}",
                            light.where, *usual == RigResponse::linear ? "linear" : "sRGB"));
        }
    return usual.value_or(RigResponse::linear);
}

// Of pictures with another ending, for which the stated response may be wrong.
void warn_of_responses(const PictureFinder& finder, Rig& rig) {
    const auto other = std::find_if(
        finder.others().begin(), finder.others().end(), [&](const PictureFinder::Named& named) {
            return named.found.other_ending && usual_response(named.path) != rig.response;
        });
    if (other == finder.others().end()) return;
    const bool linear = rig.response == RigResponse::linear;
    rig.warnings.push_back(
        fmt::format("{}: {} is read as {}, the response that is stated for {}; pictures of its "
                    "ending are usually {} (--response)",
                    other->where, shown(other->path.filename().string()),
                    linear ? "linear" : "sRGB", shown(other->name), linear ? "sRGB" : "linear"));
}

void flip_y(Rig& rig) {
    rig.camera.at[1] = -rig.camera.at[1];
    for (RigLight& light : rig.lights) {
        light.place.at[1] = -light.place.at[1];
        light.emission_axis[1] = -light.emission_axis[1];
        if (light.camera) light.camera->at[1] = -light.camera->at[1];
    }
}

// Computes the missing height from the aspect ratio of the first picture. What readers warn of in
// that picture becomes a warning of the rig.
void find_size(Rig& rig, bool needs_images, const RigOverrides& overrides) {
    double height_by_width =
        rig.width_mm > 0.0 && rig.height_mm > 0.0 ? rig.height_mm / rig.width_mm : 0.0;
    if (needs_images) {
        const ImageInfo info = read_image_info(rig.lights.front().images.front().image);
        rig.warnings.insert(rig.warnings.end(), info.warnings.begin(), info.warnings.end());
        const double of_picture = static_cast<double>(info.height) / info.width;
        // A difference of 1 % (one pixel in a hundred) may be rounding of a measured size.
        if (!overrides.width_mm && height_by_width > 0.0 &&
            std::abs(height_by_width / of_picture - 1.0) > 0.01)
            rig.warnings.push_back(fmt::format(
                "the sample is {:g} x {:g} mm, the pictures {} x {} pixels: not the same "
                "proportions",
                rig.width_mm, rig.height_mm, info.width, info.height));
        if (overrides.width_mm || height_by_width == 0.0) height_by_width = of_picture;
    }
    if (height_by_width == 0.0) height_by_width = 1.0;
    if (overrides.width_mm) rig.width_mm = *overrides.width_mm;
    if (overrides.width_mm || rig.height_mm == 0.0) rig.height_mm = rig.width_mm * height_by_width;
}

void require_above(const Rig& rig, const std::string& where, const RigPlace& place,
                   std::string_view what) {
    // A height of at least 0.001 mm keeps 1/r^2 finite everywhere on the sample.
    if (place.near ? place.at[2] >= kSmallest : place.at[2] > 0.0) return;
    throw Error(rig.file.string(), where, fmt::format("{} above the sample (z > 0)", what),
                fmt::format("z = {:g}", place.at[2]));
}

void check_places(const Rig& rig) {
    require_above(rig, "camera", rig.camera, "a camera");
    for (const RigLight& light : rig.lights) {
        require_above(rig, light.where, light.place, "a light");
        if (light.camera) require_above(rig, light.where + ".camera", *light.camera, "a camera");
    }
}

// Throws for a picture that two lights name, which is a mistake; warns of two lights in one place,
// which is harmless.
void check_duplicates(Rig& rig) {
    std::map<std::filesystem::path, std::string> pictures;
    std::map<std::tuple<bool, Vec3d, Vec3d>, std::string> places;
    bool warned = false;
    for (const RigLight& light : rig.lights) {
        for (const RigExposure& exposure : light.images) {
            const auto [first, is_new] = pictures.emplace(exposure.image, light.where);
            if (!is_new)
                throw Error(rig.file.string(), light.where, "a picture of its own",
                            fmt::format("{}, that of {} too",
                                        shown(exposure.image.filename().string()), first->second));
        }
        const RigPlace& camera = light.camera ? *light.camera : rig.camera;
        const auto [first, is_new] =
            places.emplace(std::tuple(light.place.near, light.place.at, camera.at), light.where);
        if (is_new || std::exchange(warned, true)) continue;
        rig.warnings.push_back(
            fmt::format("{}: the light is where that of {} is", light.where, first->second));
    }
}

}  // namespace

}  // namespace rig_reading

// JPEG, PNG and their like hold display values. TIFF and the formats of floats are the usual targets
// of raw converters; raw camera files are linear themselves.
RigResponse usual_response(const std::filesystem::path& picture) {
    const std::string extension = rig_reading::lower_extension(picture);
    const bool linear = extension == ".exr" || extension == ".hdr" || extension == ".tif" ||
                        extension == ".tiff" || is_raw_camera_name(picture);
    return linear ? RigResponse::linear : RigResponse::srgb;
}

Rig read_rig(const std::filesystem::path& path, bool needs_images, const RigOverrides& overrides) {
    using namespace rig_reading;
    PictureFinder pictures(path.parent_path());
    Reading reading = read_any(path, needs_images, overrides, pictures);
    Rig rig = std::move(reading.rig);
    rig.file = path;
    warn_of_others(pictures, rig.warnings);
    if (overrides.by_order || lower_extension(path) == ".dome") {
        take_by_order(needs_images, rig);
    } else {
        settle_missing(pictures, needs_images, overrides.skip_missing, rig);
    }
    rig.response = overrides.response ? *overrides.response
                   : reading.response ? *reading.response
                                      : common_response(rig);
    if (overrides.response || reading.response) warn_of_responses(pictures, rig);
    if (overrides.flip_y) flip_y(rig);
    if (overrides.camera) {
        rig.camera = *overrides.camera;
        if (!rig.camera.near) rig.camera.at = normalized(rig.camera.at);
    }
    if (overrides.intensity) {
        for (RigLight& light : rig.lights)
            for (double& channel : light.intensity) channel *= *overrides.intensity;
        rig.intensity_stated = true;
    }
    check_places(rig);
    check_duplicates(rig);
    find_size(rig, needs_images, overrides);
    warn_of_scale(rig);
    return rig;
}

bool is_rig_file(const std::filesystem::path& path) {
    const std::string extension = rig_reading::lower_extension(path);
    if (extension == ".lp" || extension == ".dome") return true;
    // Enough bytes to contain "format". Broken JSON with "format" counts as a rig, so that the
    // reader reports the JSON error.
    constexpr std::size_t kLookedAt = 65536;
    if (!rig_reading::is_there(path)) return false;
    const std::vector<std::byte> bytes = read_file_head(path, kLookedAt);
    const std::string_view head(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::size_t first = head.find_first_not_of("\xef\xbb\xbf \t\r\n");
    return first != head.npos && head[first] == '{' && head.find("\"burnish-rig\"") != head.npos;
}

Vec3d direction_to(const RigPlace& place, const Vec3d& point_mm) {
    if (!place.near) return place.at;
    return rig_reading::normalized(
        {place.at[0] - point_mm[0], place.at[1] - point_mm[1], place.at[2] - point_mm[2]});
}

Arrival arrival(const RigLight& light, const Vec3d& point_mm) {
    Arrival out{direction_to(light.place, point_mm), light.intensity};
    if (!light.place.near) return out;
    double square = 0.0, cosine = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double away = light.place.at[i] - point_mm[i];
        square += away * away;
        cosine -= light.emission_axis[i] * out.to_light[i];
    }
    const double factor = light.emission_exponent > 0.0
                              ? std::pow(std::max(cosine, 0.0), light.emission_exponent) / square
                              : 1.0 / square;
    for (double& channel : out.irradiance_per_cosine) channel *= factor;
    return out;
}

Vec3d sample_point(const Rig& rig, int width, int height, int column, int row) {
    return {((column + 0.5) / width - 0.5) * rig.width_mm,
            (0.5 - (row + 0.5) / height) * rig.height_mm, 0.0};
}

}  // namespace burnish
