// Rigs: where the camera and the lights of a capture stood, and what each picture of it is. Read
// from our rig JSON, from `.lp` files and from relight's `.dome` JSON; docs/reference/rig-file.md describes all
// three.
//
// Sample space: z = 0 is the flat sample, +x right, +y up, the origin at the image centre, row 0 at
// the top; lengths in millimetres. A pixel is I = rho (n.i) L cos^m(angle at the LED) / r^2,
// without r^2 for a light given by its direction.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "burnish/api.hpp"

namespace BURNISH_API burnish {

using Vec3d = std::array<double, 3>;

// A point of sample space, or the unit direction towards something far away.
struct RigPlace {
    bool near = false;  // `at` is a position in mm; else a unit direction
    Vec3d at{0.0, 0.0, 1.0};
};

// One picture of a bracket: its pixels are divided by `exposure` (relative to the others').
struct RigExposure {
    std::filesystem::path image;
    double exposure = 1.0;
};

struct RigLight {
    std::vector<RigExposure> images;  // at least one after reading a stack; none in a relight rig
    RigPlace place;
    Vec3d intensity{1.0, 1.0, 1.0};  // rgb, positive
    // Near lights only: cos^exponent of the angle between the axis and the way to the sample.
    Vec3d emission_axis{0.0, 0.0, -1.0};  // unit, the way the light shines
    double emission_exponent = 0.0;       // 0: the same in all directions
    std::optional<RigPlace> camera;       // relight only: its own camera
    std::string where;                    // "lights[3]" or "line 5", for messages
};

enum class RigResponse { linear, srgb };

struct Rig {
    std::filesystem::path file;
    RigResponse response = RigResponse::linear;
    // Are the intensities in the units of the pictures, so that a pixel over them is a reflectance?
    // Else only their ratios hold, and a fit may choose the unit (capture_fit.hpp).
    bool intensity_stated = false;
    double width_mm = 0.0, height_mm = 0.0;  // of the sample; 0 where the file cannot know (.lp)
    RigPlace camera;
    std::optional<std::filesystem::path> mask;   // white: measured
    std::optional<std::filesystem::path> white;  // flat field: pictures are divided by it
    std::vector<RigLight> lights;
    std::vector<std::string> warnings;
    // Which pictures are missing, in a line, and the flags that help; empty: none. Of a rig that
    // needs no pictures: a stack is refused.
    std::string missing;
};

// What the command line may say in place of the file.
struct RigOverrides {
    std::optional<RigResponse> response;
    std::optional<RigPlace> camera;
    // Height follows from the pictures; without them from the proportions of the file, else square.
    std::optional<double> width_mm;
    bool flip_y = false;  // the file's y points down the image: all of its y change sign
    // Positive: multiplies the intensities of all lights, which count as stated then.
    std::optional<double> intensity = std::nullopt;
    // The pictures beside the file are those of its lights, by order (docs/reference/rig-file.md),
    // whatever names the file has.
    bool by_order = false;
    bool skip_missing = false;  // lights whose pictures are missing are left out, with a warning
};

// `needs_images`: every light must name pictures that exist (a stack); else they may be left out (a
// rig to render under). A picture that is not where its name says is looked for in other letter
// case, in the folder of the file and with other endings; a warning says so. A `.dome` names none:
// the pictures beside it are taken by order. Throws Error naming file, place in it, expected and found. What was read holds: at
// least one light, all directions unit, everything above the sample (z > 0), every number finite.
Rig read_rig(const std::filesystem::path& path, bool needs_images,
             const RigOverrides& overrides = {});

// Told by extension (.lp, .dome) or, for JSON, by its "format".
bool is_rig_file(const std::filesystem::path& path);

// What the numbers in a picture of this name usually are: linear for .exr, .hdr, .tif, .tiff and the
// endings of raw camera files.
RigResponse usual_response(const std::filesystem::path& picture);

// Our JSON, file names relative to the folder that `path` is in; written whole or not at all.
// Throws Error when the rig has no size, as one from an .lp file: set it first.
void write_rig(const std::filesystem::path& path, const Rig& rig);

// An .lp file: of each light, given by its direction, one picture. The format knows nothing else.
void write_lp(const std::filesystem::path& path, const Rig& rig);

// How the light of one rig entry arrives at a point of the sample.
struct Arrival {
    Vec3d to_light;               // unit
    Vec3d irradiance_per_cosine;  // L cos^m / r^2 (or L): I = rho (n.i) times this
};
Arrival arrival(const RigLight& light, const Vec3d& point_mm);
Vec3d direction_to(const RigPlace& place, const Vec3d& point_mm);  // unit

// Centre of a pixel on the sample, z = 0; the origin for all of them where the size is not known.
Vec3d sample_point(const Rig& rig, int width, int height, int column, int row);

}  // namespace burnish
