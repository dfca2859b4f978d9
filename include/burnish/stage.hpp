// Setting the stage: from names of files and values of parameters to a scene, an environment, a
// camera and render settings.
//
// Threads: functions may be called from any thread. Lifetime: what they return refers to nothing
// else.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/display.hpp"
#include "burnish/image_io.hpp"
#include "burnish/layered_materials.hpp"
#include "burnish/parameters.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/scene.hpp"
#include "burnish/scene_file.hpp"

namespace BURNISH_API burnish {

// What is to be seen, and in which light.
struct StageRequest {
    std::string input;                // model, scene file or builtin:<name>
    std::string environment;          // "": the scene file's, else builtin:studio; "none"
    std::vector<std::string> lights;  // --light words (see parse_light); empty: the file's lights
    ParameterValues values;           // they win over the scene file's parameters
};

inline constexpr std::string_view kDefaultEnvironment = "builtin:studio";

// A plain value, but for `materials`, which knows the textures that it has appended to `scene`.
struct Stage {
    Scene scene;
    // What the input is, for those who write it as a scene file again: objects, values, environment,
    // hidden parts. Of its scene it has lights and warnings alone, and no layers (`materials` has them).
    SceneFile file;
    LayeredMaterials materials;  // materials.apply(scene, values): the scene under other values
    Environment environment;     // empty radiance: none
    ParameterValues values;      // everything that was set, for metadata
    Camera camera;
    RenderSettings settings;
    double exposure_ev = 0;
    ToneMap tone_map = ToneMap::khronos_neutral;

    // The mesh of every instance of the scene, those too that are hidden there (a mesh of -1).
    std::vector<int> shown_meshes;

    // The parts of scene.warnings, for those who change a stage; those of the input's readers are
    // file.scene.warnings.
    struct Warnings {
        std::vector<std::string> materials, normal_maps, environment, values;
    } warnings;
};

// `all_around`: a framed camera keeps its distance for a full turn. Throws UsageError for values
// that contradict each other, Error for files that cannot be read or drawn.
Stage set_stage(const StageRequest& request, bool all_around = false);

// What the values of the groups render and environment ask for.
RenderSettings render_settings(const ParameterValues& values);
// RenderSettings::robust_limit of a picture that is displayed with these values: the radiance that the
// exposure makes 2, or 0 where the robust mean is switched off. render_settings leaves it 0.
float robust_limit(const ParameterValues& values);
// How a displayed picture is written.
WriteOptions write_options(const ParameterValues& values);

// A light in one word: "AZIMUTH,ELEVATION[,INTENSITY]" (degrees, as the camera's; a directional
// light of that many lux) or "point:X,Y,Z[,INTENSITY]" (metres, candela). Throws UsageError.
Light parse_light(std::string_view word);

// The camera that the parameters ask for, or one that frames the scene.
Camera place_camera(const Scene& scene, const ParameterValues& values, double aspect,
                    bool all_around = false);

}  // namespace burnish
