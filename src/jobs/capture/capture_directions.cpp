#include "jobs/capture/capture_directions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/constants.hpp"
#include "core/files.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;

// Least angle in degrees between the directions of two balls for a warning: for a distant lamp they
// agree to one degree.
constexpr double kApart = 3.0;
// Least ratio of the second spot's light to the brightest spot's for a warning of two lamps:
// reflections of a room are dimmer.
constexpr double kTwoLamps = 0.5;

enum class Format { json, lp };

Format format_of(const fs::path& output) {
    const std::string extension = output.extension().string();
    if (extension == ".json") return Format::json;
    if (extension == ".lp") return Format::lp;
    throw UsageError("-o", "", "a file name that ends in .json or .lp", shown(output.string()));
}

void check_request(const CaptureDirectionsRequest& r) {
    if (format_of(r.output) == Format::lp && (r.rig.response || r.rig.camera || r.rig.width_mm))
        throw UsageError("-o", "",
                         "a .json file, where --response, --camera or --width-mm is given",
                         "an .lp file, which knows directions alone");
    if (!r.pictures.empty() && r.pictures.size() != r.balls.size())
        throw UsageError("--pictures", "",
                         fmt::format("{}, one for each picture of the ball", r.balls.size()),
                         std::to_string(r.pictures.size()));
    // A picture given twice is a mistake; read_rig would reject the rig.
    for (const auto* list : {&r.balls, &r.pictures}) {
        std::set<fs::path> seen;
        for (const fs::path& path : *list)
            if (!seen.insert(fs::absolute(path).lexically_normal()).second)
                throw Error(path.string(), "", "a picture of one light", "named twice");
    }
}

void require_size(const fs::path& path, int width, int height, int& first_width,
                  int& first_height) {
    if (first_width == 0) {
        first_width = width;
        first_height = height;
    }
    if (width == first_width && height == first_height) return;
    throw Error(path.string(), "",
                fmt::format("{} x {} pixels, as the first picture has", first_width, first_height),
                fmt::format("{} x {}", width, height));
}

double angle_deg(const Vec3d& a, const Vec3d& b) {
    const double chord = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    return 2.0 * std::asin(std::min(chord / 2.0, 1.0)) * kDegreesPerRadian;
}

// The combined result of all balls in one picture.
struct Found {
    Vec3d direction{};                                       // unit, of the picture
    double spread_deg = 0.0, second = 0.0, apart_deg = 0.0;  // the largest of each
};

Found look_at(const Image& image, const std::vector<ProbeCircle>& circles, const fs::path& path) {
    Found out;
    std::vector<Vec3d> directions;
    for (std::size_t k = 0; k < circles.size(); ++k) {
        const std::string name =
            circles.size() == 1 ? path.string() : fmt::format("{}: ball {}", path.string(), k + 1);
        const ProbeLight light = light_from_probe(image, circles[k], name);
        for (const Vec3d& other : directions)
            out.apart_deg = std::max(out.apart_deg, angle_deg(light.direction, other));
        directions.push_back(light.direction);
        for (std::size_t i = 0; i < 3; ++i) out.direction[i] += light.direction[i];
        out.spread_deg = std::max(out.spread_deg, light.spread_deg);
        out.second = std::max(out.second, light.second);
    }
    // The sum is not zero: every z is positive.
    const double size = std::hypot(out.direction[0], out.direction[1], out.direction[2]);
    for (double& value : out.direction) value /= size;
    return out;
}

void warn_of(const Found& found, const fs::path& path, std::vector<std::string>& warnings) {
    if (found.apart_deg > kApart)
        warnings.push_back(fmt::format(
            "{}: the balls' directions are {:.1f} degrees apart, and their mean is taken: the lamp "
            "is near, or an outline is off",
            path.string(), found.apart_deg));
    if (found.second > kTwoLamps)
        warnings.push_back(
            fmt::format("{}: a second spot has {:.0f} % of the light of the brightest: two lamps?",
                        path.string(), 100.0 * found.second));
}

// Warns of outlines that look like diameters or like y counted from the bottom: they would give
// plausible but wrong directions.
void warn_of_outlines(const std::vector<ProbeCircle>& circles, const fs::path& path,
                      const Image& image, std::vector<std::string>& warnings) {
    for (const ProbeCircle& c : circles)
        if (c.x - c.radius < -1.0 || c.y - c.radius < -1.0 || c.x + c.radius > image.width + 1.0 ||
            c.y + c.radius > image.height + 1.0)
            warnings.push_back(fmt::format(
                "{}: the ball's outline ({:g}, {:g}, radius {:g}) leaves the picture of {} x {} "
                "pixels: a diameter, or y from the bottom?",
                path.string(), c.x, c.y, c.radius, image.width, image.height));
}

// The rig except for the directions of its lights.
Rig rig_without_places(const CaptureDirectionsRequest& request,
                       std::vector<std::string>& warnings) {
    Rig rig;
    rig.file = request.output;
    const auto& pictures = request.pictures.empty() ? request.balls : request.pictures;
    int width = 0, height = 0;
    for (const fs::path& path : pictures) {
        const ImageInfo info = read_image_info(path);
        require_size(path, info.width, info.height, width, height);
        // All pictures are of a kind: the first one speaks for them.
        if (rig.lights.empty())
            warnings.insert(warnings.end(), info.warnings.begin(), info.warnings.end());
        RigLight light;
        light.where = fmt::format("lights[{}]", rig.lights.size());
        light.images = {{path, 1.0}};
        rig.lights.push_back(std::move(light));
    }
    rig.response = request.rig.response.value_or(usual_response(pictures.front()));
    if (request.rig.camera) rig.camera = *request.rig.camera;
    rig.width_mm = request.rig.width_mm.value_or(width);
    rig.height_mm = rig.width_mm * height / width;
    if (!request.rig.width_mm && format_of(request.output) == Format::json)
        warnings.push_back(fmt::format("{}: without --width-mm the sample is taken as 1 mm a pixel",
                                       request.output.string()));
    return rig;
}

// Is the ball's picture linear? It has the sample's response if it shows the sample too, else the
// usual response of its file format.
bool linear_ball(const CaptureDirectionsRequest& request, const fs::path& path) {
    const bool same = request.pictures.empty();
    return (same && request.rig.response ? *request.rig.response : usual_response(path)) ==
           RigResponse::linear;
}

}  // namespace

CaptureDirectionsResult capture_directions(const CaptureDirectionsRequest& request,
                                           const Progress& progress) {
    CaptureDirectionsResult report;
    check_request(request);
    require_writable(request.output);
    Rig rig = rig_without_places(request, report.warnings);
    int width = 0, height = 0;
    for (std::size_t k = 0; k < request.balls.size(); ++k) {
        progress.step("directions",
                      static_cast<double>(k) / static_cast<double>(request.balls.size()));
        const fs::path& path = request.balls[k];
        const Image image = read_image(path, {.as_data = linear_ball(request, path)});
        require_size(path, image.width, image.height, width, height);
        if (k == 0) warn_of_outlines(request.circles, path, image, report.warnings);
        const Found found = look_at(image, request.circles, path);
        RigPlace& place = rig.lights[k].place;
        place = {false, from_picture(found.direction, rig.camera.at)};
        if (!(place.at[2] > 0.0))
            throw Error(path.string(), "", "a light above the sample (z > 0)",
                        fmt::format("z = {:.3f}", place.at[2]));
        warn_of(found, path, report.warnings);
        report.lights.push_back({path, place.at, found.spread_deg, found.apart_deg});
    }
    progress.step("directions", 1.0);
    if (format_of(request.output) == Format::lp) {
        write_lp(request.output, rig);
    } else {
        write_rig(request.output, rig);
    }
    report.written.push_back(request.output);
    return report;
}

}  // namespace burnish
