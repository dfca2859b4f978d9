// Rigs of captures, the first byte says in which format: what is read must hold, and come back when
// it is written.
#include <cmath>

#include "burnish/rig.hpp"
#include "harness.hpp"

namespace {

using namespace burnish;

bool same(const Vec3d& a, const Vec3d& b, double tolerance) {
    for (std::size_t i = 0; i < 3; ++i)
        if (!(std::abs(a[i] - b[i]) <= tolerance)) return false;
    return true;
}

void check_place(const RigPlace& place) {
    const double size = std::hypot(place.at[0], place.at[1], place.at[2]);
    if (!std::isfinite(size) || !(place.at[2] > 0.0)) fuzz::broken("a place below the sample");
    if (!place.near && !(std::abs(size - 1.0) < 1e-12))
        fuzz::broken("a direction that is not unit");
}

void check(const Rig& rig) {
    if (rig.lights.empty()) fuzz::broken("no lights");
    check_place(rig.camera);
    const Vec3d corner = sample_point(rig, 1000, 1000, 0, 0);
    for (const RigLight& light : rig.lights) {
        check_place(light.place);
        if (light.camera) check_place(*light.camera);
        for (const double value : arrival(light, corner).irradiance_per_cosine)
            if (!(value >= 0.0 && std::isfinite(value))) fuzz::broken("light that is no number");
    }
    for (const std::string& warning : rig.warnings)
        if (warning.empty() || warning.find_first_of("\r\n") != warning.npos)
            fuzz::broken("a warning of no or several lines");
}

void check_written(const Rig& rig) {
    const auto path = fuzz::folder() / "again.json";
    write_rig(path, rig);
    const Rig again = read_rig(path, false);
    if (again.lights.size() != rig.lights.size()) fuzz::broken("other lights when written");
    for (std::size_t i = 0; i < rig.lights.size(); ++i)
        if (!same(again.lights[i].place.at, rig.lights[i].place.at, 1e-14))
            fuzz::broken("a light that moved when it was written");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using burnish::fuzz::Bytes;
    if (size == 0) return 0;
    const char* name = data[0] == 'l' ? "rig.lp" : data[0] == 'd' ? "rig.dome" : "rig.json";
    const auto path = burnish::fuzz::put(name, Bytes(data + 1, size - 1));
    for (const bool needs_images : {false, true})
        burnish::fuzz::expect_answer([&] {
            burnish::is_rig_file(path);
            const burnish::Rig rig = burnish::read_rig(path, needs_images);
            check(rig);
            if (rig.width_mm > 0.0 && rig.lights.size() <= 100) check_written(rig);
        });
    return 0;
}
