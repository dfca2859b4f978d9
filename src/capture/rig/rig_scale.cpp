// Warns of rigs whose numbers are in another unit than the format's, or in several.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "capture/rig/rig_reading.hpp"

namespace burnish::rig_reading {

namespace {

// Sides of a sample in mm that are usual: smaller ones need a microscope, larger ones are walls.
constexpr double kUsualSmallest = 1.0, kUsualLargest = 1e4;
constexpr const char* kOfMeters =
    "lengths are millimeters and are used as stated; multiply all of them by 1000 if they are in "
    "meters";

// The distance from the middle of the sample, if it is less than half its width; else 0.
double too_near(const Rig& rig, const RigPlace& place) {
    const double distance = place.near ? length(place.at) : 0.0;
    return distance < 0.5 * rig.width_mm ? distance : 0.0;
}

void warn_of_size(Rig& rig) {
    const double least = std::min(rig.width_mm, rig.height_mm);
    const double most = std::max(rig.width_mm, rig.height_mm);
    if (!(least > 0.0) || (least >= kUsualSmallest && most <= kUsualLargest)) return;
    rig.warnings.push_back(fmt::format(
        "sample: {:g} x {:g} mm: {}", rig.width_mm, rig.height_mm,
        least < kUsualSmallest
            ? kOfMeters
            : "lengths are millimeters and are used as stated; divide all of them by 1000 if they "
              "are in micrometers"));
}

void warn_of_near_cameras(Rig& rig) {
    const auto warn = [&](const std::string& where, const RigPlace& camera) {
        const double distance = too_near(rig, camera);
        if (distance > 0.0)
            rig.warnings.push_back(
                fmt::format("{}: {:.3g} mm from the middle of a sample that is {:g} mm wide: {}",
                            where, distance, rig.width_mm, kOfMeters));
        return distance > 0.0;
    };
    if (warn("camera", rig.camera)) return;
    for (const RigLight& light : rig.lights)
        if (light.camera && warn(light.where + ".camera", *light.camera)) return;
}

void warn_of_near_lights(Rig& rig) {
    const RigLight* nearest = nullptr;
    double least = rig.width_mm;
    std::size_t count = 0;
    for (const RigLight& light : rig.lights) {
        const double distance = too_near(rig, light.place);
        if (!(distance > 0.0)) continue;
        ++count;
        if (distance >= least) continue;
        least = distance;
        nearest = &light;
    }
    if (nearest != nullptr)
        rig.warnings.push_back(fmt::format(
            "{}: the light is {:.3g} mm from the middle of a sample that is {:g} mm wide, and {} "
            "nearer than half that width: {}",
            nearest->where, least, rig.width_mm,
            count == 1 ? std::string("no other is")
                       : fmt::format("{} of {} are", count, rig.lights.size()),
            kOfMeters));
}

}  // namespace

void warn_of_scale(Rig& rig) {
    warn_of_size(rig);
    warn_of_near_cameras(rig);
    warn_of_near_lights(rig);
    const auto near = static_cast<std::size_t>(
        std::count_if(rig.lights.begin(), rig.lights.end(),
                      [](const RigLight& light) { return light.place.near; }));
    if (near > 0 && near < rig.lights.size() && !rig.intensity_stated)
        rig.warnings.push_back(fmt::format(
            "lights: {} have a position and {} a direction, and none states its intensity: each is "
            "taken as 1, which at a distance of r mm arrives as 1 / r^2, and from a direction as "
            "1; \"intensity\" states them",
            near, rig.lights.size() - near));
}

}  // namespace burnish::rig_reading
