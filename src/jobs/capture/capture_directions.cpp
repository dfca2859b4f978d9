#include "jobs/capture/capture_directions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "capture/rig/rig_pictures.hpp"
#include "core/constants.hpp"
#include "core/files.hpp"
#include "core/find_file.hpp"
#include "core/text.hpp"

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
    if (format_of(r.output) == Format::lp && (r.rig.camera || r.rig.width_mm))
        throw UsageError("-o", "", "a .json file, where --camera or --width-mm is given",
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
    if (request.rig.response && format_of(request.output) == Format::lp)
        warnings.push_back(
            fmt::format("{}: an .lp file cannot hold --response: give it to capture fit, too",
                        request.output.string()));
    return rig;
}

bool linear_ball(const CaptureDirectionsRequest& request, const fs::path& path) {
    const RigResponse usual = usual_response(path);
    if (request.ball_response) return *request.ball_response == RigResponse::linear;
    const bool alike =
        request.pictures.empty() || usual_response(request.pictures.front()) == usual;
    return (alike ? request.rig.response.value_or(usual) : usual) == RigResponse::linear;
}

// Pictures that are not there under other letter case or with another ending.
class GivenPictures {
  public:
    fs::path find(const fs::path& path) {
        std::error_code error;
        if (fs::exists(path, error)) return path;
        const fs::path folder = path.parent_path();
        auto& finder = finders_.try_emplace(folder, folder, kSearch).first->second;
        const FoundFile found = finder.find(path.filename().string());
        if (!found) return path;
        if (count_++ == 0)
            first_ = fmt::format("{}: {} is taken for it ({})", path.string(),
                                 shown(found.path.filename().string()), difference_of(found));
        return found.path;
    }
    void warn(std::vector<std::string>& warnings) const {
        if (count_ == 0) return;
        warnings.push_back(first_ +
                           (count_ > 1 ? fmt::format("; so are {} more", count_ - 1) : ""));
    }

  private:
    static inline const FileSearch kSearch{rig_reading::all_endings(), {}, false};
    std::map<fs::path, FileFinder> finders_;
    std::string first_;
    std::size_t count_ = 0;
};

// Shells sort p10 before p2: two lists in that order may stand for different lights if only one
// of them pads its numbers.
void warn_of_orders(const CaptureDirectionsRequest& request, std::vector<std::string>& warnings) {
    const auto by_bytes = [](const std::vector<fs::path>& list) {
        return std::is_sorted(list.begin(), list.end());
    };
    const auto unnatural = [](const std::vector<fs::path>& list) {
        return std::adjacent_find(list.begin(), list.end(), [](const auto& a, const auto& b) {
            return natural_less(b.filename().string(), a.filename().string());
        });
    };
    const auto ball = unnatural(request.balls), picture = unnatural(request.pictures);
    const bool one = (ball == request.balls.end()) != (picture == request.pictures.end());
    if (request.pictures.empty() || !one || !by_bytes(request.balls) || !by_bytes(request.pictures))
        return;
    const fs::path& first = ball == request.balls.end() ? *picture : *ball;
    const fs::path& next = ball == request.balls.end() ? *(picture + 1) : *(ball + 1);
    warnings.push_back(fmt::format(
        "{} is given before {}, while the {} are in the order of their numbers: the k-th picture "
        "of the ball is taken with the k-th of the sample all the same",
        shown(first.filename().string()), shown(next.filename().string()),
        ball == request.balls.end() ? "pictures of the ball" : "--pictures"));
}

// The Exif orientation of a picture, 1 to 8; 1: as stored.
int orientation_of(const ImageInfo& info) {
    const auto found = info.metadata.find("Orientation");
    const int value = found == info.metadata.end() ? 1 : std::atoi(found->second.c_str());
    return value >= 1 && value <= 8 ? value : 1;
}

constexpr std::array<const char*, 9> kTurns = {"",
                                               "",
                                               "mirrored left to right",
                                               "turned by 180 degrees",
                                               "mirrored top to bottom",
                                               "mirrored about the diagonal from the top left",
                                               "turned by 90 degrees clockwise",
                                               "mirrored about the diagonal from the top right",
                                               "turned by 90 degrees counter-clockwise"};

// Where a point that a viewer shows at (x, y) is stored, in a picture of these stored sizes.
ProbeCircle stored_circle(int orientation, const ProbeCircle& shown, double width, double height) {
    const auto [x, y, radius] = shown;
    switch (orientation) {
        case 2:
            return {width - x, y, radius};
        case 3:
            return {width - x, height - y, radius};
        case 4:
            return {x, height - y, radius};
        case 5:
            return {y, x, radius};
        case 6:
            return {y, height - x, radius};
        case 7:
            return {width - y, height - x, radius};
        case 8:
            return {width - y, x, radius};
        default:
            return shown;
    }
}

// What an orientation other than 1 means for the outlines; empty for 1.
std::string orientation_text(const ImageInfo& info, const std::vector<ProbeCircle>& circles) {
    const int orientation = orientation_of(info);
    if (orientation == 1) return {};
    std::string outlines;
    for (const ProbeCircle& c : circles) {
        const ProbeCircle stored = stored_circle(orientation, c, info.width, info.height);
        outlines += fmt::format("{}--ball {:g},{:g},{:g} of a viewer is --ball {:g},{:g},{:g} here",
                                outlines.empty() ? "" : ", ", c.x, c.y, c.radius, stored.x,
                                stored.y, stored.radius);
    }
    return fmt::format(
        "Exif orientation {}: viewers show the picture {}, but its pixels are taken as stored, {} "
        "x {}: {}",
        orientation, kTurns[static_cast<std::size_t>(orientation)], info.width, info.height,
        outlines);
}

void warn_of_orientation(const CaptureDirectionsRequest& request,
                         std::vector<std::string>& warnings) {
    std::size_t count = 0;
    std::string first;
    for (const fs::path& path : request.balls) {
        const std::string text = orientation_text(read_image_info(path), request.circles);
        if (text.empty()) continue;
        if (count++ == 0) first = fmt::format("{}: {}", path.string(), text);
    }
    if (count == 0) return;
    warnings.push_back(first + (count > 1 ? fmt::format(" (and {} more)", count - 1) : ""));
}

// look_at, with the orientation in the message of a ball that shows no highlight.
Found look_at_stored(const Image& image, const std::vector<ProbeCircle>& circles,
                     const fs::path& path) {
    try {
        return look_at(image, circles, path);
    } catch (const Error& error) {
        const std::string text = orientation_text(read_image_info(path), circles);
        if (text.empty()) throw;
        throw Error(fmt::format("{}; {}", error.what(), text));
    }
}

}  // namespace

CaptureDirectionsResult capture_directions(const CaptureDirectionsRequest& given,
                                           const Progress& progress) {
    CaptureDirectionsResult report;
    CaptureDirectionsRequest request = given;
    GivenPictures finder;
    for (auto* list : {&request.balls, &request.pictures})
        for (fs::path& path : *list) path = finder.find(path);
    finder.warn(report.warnings);
    check_request(request);
    require_writable(request.output);
    warn_of_orders(request, report.warnings);
    warn_of_orientation(request, report.warnings);
    Rig rig = rig_without_places(request, report.warnings);
    int width = 0, height = 0;
    for (std::size_t k = 0; k < request.balls.size(); ++k) {
        progress.step("directions",
                      static_cast<double>(k) / static_cast<double>(request.balls.size()));
        const fs::path& path = request.balls[k];
        const Image image = read_image(path, {.as_data = linear_ball(request, path)});
        require_size(path, image.width, image.height, width, height);
        if (k == 0) warn_of_outlines(request.circles, path, image, report.warnings);
        const Found found = look_at_stored(image, request.circles, path);
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
