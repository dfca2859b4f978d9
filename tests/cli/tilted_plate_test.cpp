// Where the highlight is seen: pictures of a plate that only its normal map tilts, under one
// directional light, against the mirror direction and against pictures of a plate that lies tilted.
// (tests/shading/highlight_test.cpp asks the formulas; here are the files, the tangents, the
// normal map, the lights and the renderer as well.)
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <optional>

#include "burnish/image_io.hpp"
#include "pictures.hpp"
#include "support/glb_writer.hpp"

namespace burnish::test {
namespace {

using glm::dvec3;

dvec3 direction(double theta_deg, double phi_deg) {
    const double theta = glm::radians(theta_deg), phi = glm::radians(phi_deg);
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

double degrees_between(dvec3 a, dvec3 b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

// "AZIMUTH,ELEVATION" of a direction: azimuth 0 is +z, 90 degrees is +x, +y is up.
double azimuth_deg(dvec3 d) {
    return glm::degrees(std::atan2(d.x, d.z));
}
double elevation_deg(dvec3 d) {
    return glm::degrees(std::asin(std::clamp(d.y, -1.0, 1.0)));
}

enum class Groove { along_x, along_y };  // along the axis of the smaller alpha

// The square [-1, 1]^2 in the plane of normal n, whose points `place` gives, as a GLB with the
// tangent `tangent`.
template <typename Place>
std::vector<std::byte> plate_glb(dvec3 n, dvec3 tangent, const Place& place) {
    GlbPrimitive plate;
    for (const glm::dvec2 p : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        plate.positions.emplace_back(place(p));
        plate.normals.emplace_back(n);
        plate.tangents.emplace_back(glm::vec3(tangent), 1.0f);
        plate.texcoord0.emplace_back(0.5 + 0.5 * p.x, 0.5 - 0.5 * p.y);
    }
    plate.indices = {0, 1, 2, 0, 2, 3};
    GlbWriter writer;
    writer.add_node(writer.add_mesh(plate));
    return writer.glb();
}

// Tilted as a height field z(x, y): the grooves of a surface that is pushed up and down stay above
// where they were.
std::vector<std::byte> sheared_plate(dvec3 n, Groove groove) {
    const dvec3 carried = groove == Groove::along_x ? dvec3(1, 0, -n.x / n.z)
                                                    : glm::cross(dvec3(0, 1, -n.y / n.z), n);
    return plate_glb(n, glm::normalize(carried),
                     [&](glm::dvec2 p) { return dvec3(p, -(n.x * p.x + n.y * p.y) / n.z); });
}

// Turned as a rigid body by the shortest arc from z to n.
std::vector<std::byte> turned_plate(dvec3 n) {
    const dvec3 axis = glm::cross(dvec3(0, 0, 1), n);
    const auto turn = [&](dvec3 v) {  // Rodrigues; |axis| is the sine of the angle, n.z its cosine
        return n.z * v + glm::cross(axis, v) + axis * (glm::dot(axis, v) / (1.0 + n.z));
    };
    return plate_glb(n, turn({1, 0, 0}), [&](glm::dvec2 p) { return turn(dvec3(p, 0.0)); });
}

std::vector<std::byte> flat_plate() {
    return turned_plate({0, 0, 1});
}

// A plate in front of a far camera in direction `wo`, and what it shows under one light.
class Plate {
  public:
    Plate(std::vector<std::byte> glb, const std::optional<dvec3>& mapped_normal, dvec3 wo,
          std::string_view method, Groove groove = Groove::along_x) {
        const bool along_x = groove == Groove::along_x;
        const std::string model = folder_.write("plate.glb", glb).string();
        Settings settings = {{"alpha_x", along_x ? "0.1" : "0.5"},
                             {"alpha_y", along_x ? "0.5" : "0.1"},
                             {"metallic", "1"},
                             {"method", std::string(method)},
                             {"samples", "1"},
                             {"width", "8"},
                             {"height", "8"},
                             {"camera_fov", "1"},
                             {"camera_distance", "20"},
                             {"background", "transparent"},
                             {"camera_azimuth", fmt::format("{}", azimuth_deg(wo))},
                             {"camera_elevation", fmt::format("{}", elevation_deg(wo))}};
        if (mapped_normal) {
            // Floats: the step of 8 bits is 0.45 degrees, and what is looked for is 0.25.
            Image map(1, 1, 3);
            for (int c = 0; c < 3; ++c)
                map.at(0, 0)[c] = static_cast<float>(0.5 + 0.5 * (*mapped_normal)[c]);
            const auto path = folder_.path() / "normal.exr";
            write_image(path, map, {});
            settings.emplace_back("normal_map", path.string());
        }
        stage_ = stage_of(model, "none", {}, settings);
    }

    // Mean of the picture; the plate fills all of it.
    double brightness(dvec3 wi) {
        stage_.scene.lights = {
            parse_light(fmt::format("{},{},1", azimuth_deg(wi), elevation_deg(wi)))};
        const Image picture = picture_of(stage_);
        double sum = 0;
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 0; x < picture.width; ++x) {
                EXPECT_EQ(picture.at(x, y)[3], 1.0f) << "the plate does not fill the picture";
                sum += picture.at(x, y)[1];
            }
        }
        return sum / (picture.width * picture.height);
    }

  private:
    TemporaryFolder folder_;
    Stage stage_;
};

// A direction at (angle, turn) from `center`.
dvec3 around(dvec3 center, double angle_deg, double turn_deg) {
    const dvec3 x = glm::normalize(glm::cross(dvec3(0.3, 0.9, 0.1), center));
    const dvec3 y = glm::cross(center, x);
    const dvec3 d = direction(angle_deg, turn_deg);
    return d.x * x + d.y * y + d.z * center;
}

// Scans lights within 75 degrees of `guess`, then walks uphill from the best of them with ever
// shorter steps, down to 1/20 of a degree. `guess` itself is not tried.
dvec3 brightest(Plate& plate, dvec3 guess) {
    dvec3 best;
    double best_value = -1;
    const auto try_ring = [&](dvec3 center, double angle_deg, double first_deg) {
        bool better = false;
        constexpr int kLights = 8;
        for (int i = 0; i < kLights; ++i) {
            const dvec3 wi = around(center, angle_deg, first_deg + 360.0 * i / kLights);
            const double value = plate.brightness(wi);
            if (value <= best_value) continue;
            best_value = value;
            best = wi;
            better = true;
        }
        return better;
    };
    for (const double angle : {7.0, 25.0, 45.0, 75.0}) try_ring(guess, angle, angle);
    double turn = 0;  // so that no direction is never looked in
    for (double step = 5; step > 0.05; step *= 0.5) {
        while (try_ring(best, step, turn += 13)) {
        }
    }
    return best;
}

// An angle found, kept in the test's report.
void note(const std::string& name, double degrees) {
    std::string key = name;
    std::replace(key.begin(), key.end(), '-', '_');
    testing::Test::RecordProperty(key, fmt::format("{:.3f}", degrees));
}

class TiltedPlate : public testing::TestWithParam<double> {
  protected:
    // Off both axes of the lobe.
    dvec3 normal() const { return direction(GetParam(), 35); }
};

TEST_P(TiltedPlate, SeenAlongTheMappedNormalIsBrightestInTheMirrorDirection) {
    BURNISH_REQUIRE_GL();
    const dvec3 n = normal();
    for (const std::string_view method :
         {"gram-schmidt", "rotate-exact", "rotate-approx", "rotate-arc", "follow-grain",
          "deform-linear", "deform-smooth"}) {
        Plate plate(flat_plate(), n, n, method);
        const double miss = degrees_between(brightest(plate, n), n);
        note(std::string(method), miss);
        EXPECT_LT(miss, 1.0) << method;
    }
}

// What today's engines do (docs/theory/methods.md): the highlight is where nothing mirrors, 2.2, 2.1
// and 1.8 times the tilt away for 15, 30 and 45 degrees.
TEST_P(TiltedPlate, NormalMapMissesTheMirrorDirection) {
    BURNISH_REQUIRE_GL();
    Plate plate(flat_plate(), normal(), normal(), "normal-map");
    const double miss = degrees_between(brightest(plate, normal()), normal());
    note("normal-map", miss);
    EXPECT_GT(miss, GetParam());
}

// A real plate, and where it is brightest.
struct Real {
    Real(const std::vector<std::byte>& glb, dvec3 wo, Groove groove, dvec3 guess)
        : plate(glb, {}, wo, "none", groove), peak(brightest(plate, guess)) {}
    Plate plate;
    dvec3 peak;
};

// The largest of the differences of brightness between two plates over lights around `center`,
// against the brightest. Below the flat plate's horizon the renderer lets no light through,
// whatever the normal map says; the tilted plate's is another.
double largest_difference(Plate& a, Plate& b, dvec3 center) {
    double largest = 0, brightest_value = 0;
    for (const double angle : {0.0, 3.0, 10.0, 25.0}) {
        for (double turn = 20; turn < 380; turn += 90) {
            const dvec3 wi = around(center, angle, turn);
            if (wi.z < 0.05) continue;
            const double value = a.brightness(wi);
            largest = std::max(largest, std::abs(value - b.brightness(wi)));
            brightest_value = std::max(brightest_value, value);
        }
    }
    return largest / brightest_value;
}

// Which real plate a method stands for: rotate-arc one that is turned, follow-grain one whose
// grooves are carried; a projected bitangent (rotate-exact) carries grooves along x, a projected
// tangent (gram-schmidt) those along y. Not only the peaks agree, the pictures do, but for
// rotate-approx, whose axes are not normalised (0.6, 2.9 and 5.7 % of the peak found).
TEST_P(TiltedPlate, FromAnotherSideItIsThePlateThatLiesTilted) {
    BURNISH_REQUIRE_GL();
    const dvec3 n = normal();
    const dvec3 wo = direction(30, 80);  // the mirror direction is above the flat plate, too
    const dvec3 mirror = 2.0 * glm::dot(n, wo) * n - wo;
    for (const Groove groove : {Groove::along_x, Groove::along_y}) {
        Real sheared(sheared_plate(n, groove), wo, groove, mirror);
        Real turned(turned_plate(n), wo, groove, mirror);
        const auto expect_like = [&](std::string_view method, Real& real) {
            Plate mapped(flat_plate(), n, wo, method, groove);
            const double apart = degrees_between(brightest(mapped, mirror), real.peak);
            const double difference = largest_difference(real.plate, mapped, mirror);
            note(fmt::format("{}_{}", method, groove == Groove::along_x ? "x" : "y"), apart);
            EXPECT_LT(apart, 0.25) << method;
            EXPECT_LT(difference, method == "rotate-approx" ? 0.08 : 0.002) << method;
        };
        expect_like("follow-grain", sheared);
        expect_like("rotate-arc", turned);
        if (groove == Groove::along_x) {
            expect_like("rotate-exact", sheared);
            expect_like("rotate-approx", sheared);
        } else {
            expect_like("gram-schmidt", sheared);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Degrees, TiltedPlate, testing::Values(15.0, 30.0, 45.0));

}  // namespace
}  // namespace burnish::test
