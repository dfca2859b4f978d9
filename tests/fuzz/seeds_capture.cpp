// Seeds and words of what captures consist of: rigs and tabulated materials.
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "burnish/tabulated_file.hpp"
#include "burnish/tabulated_material.hpp"
#include "core/files.hpp"
#include "seeds.hpp"

namespace burnish::fuzz {

namespace fs = std::filesystem;

// The first letter says which of the formats: fuzz_rig.cpp.
Words rig_seeds() {
    Words seeds;
    const std::string manual =
        read_text_file(fs::path(BURNISH_SOURCE_DIR) / "docs" / "reference" / "rig-file.md");
    const std::size_t start = manual.find("```json\n") + 8;
    seeds.push_back("j" + manual.substr(start, manual.find("```", start) - start));
    seeds.push_back(
        R"(j{"format":"burnish-rig","version":1,"units":"mm","response":"srgb",)"
        R"("sample":{"width":40,"height":40},"mask":"map.png","white":"map.png",)"
        R"("lights":[{"image":"map.png","direction":[0,1,1],"intensity":[1,2,3],)"
        R"("camera":{"direction":[0,0,1]}},{"exposures":[{"image":"sky.exr","exposure":0.5}],)"
        R"("position":[1,2,3],"emission_axis":[0,0,-1],"emission_exponent":2,)"
        R"("camera":{"position":[0,0,9]}}]})");
    seeds.push_back("l2\r\nmap.png 0.6 0 0.8\r\nC:\\a\\sky.exr 0.0 -.6 8e-1\r\n");
    seeds.push_back("l1\na b.jpg 0,577350269 0,577350269 0,577350269\n");
    seeds.push_back(
        R"(d{"label":"a","notes":"","imageWidth":120,"lightConfiguration":"directional",)"
        R"("directions":[[0.6,0,0.8],{"x":0,"y":0,"z":1}]})");
    seeds.push_back(R"(d{"lightConfiguration":"spherical","domeDiameter":600,"verticalOffset":-40,)"
                    R"("directions":[[0,0,1]],"ledAdjust":[[1,2,4]]})");
    seeds.push_back(
        R"(d{"lightConfiguration":"lights3d","positions3d":[[1,2,300]],"lightsCalibration":)"
        R"([{"whiteBalance":{"r":1,"g":1,"b":2},"intensity":0.5,"spatialCalibration":{}}]})");
    return seeds;
}

Words rig_words() {
    return {"burnish-rig",
            "format",
            "version",
            "units",
            "mm",
            "response",
            "linear",
            "srgb",
            "sample",
            "width",
            "height",
            "camera",
            "position",
            "direction",
            "mask",
            "white",
            "lights",
            "image",
            "exposures",
            "exposure",
            "intensity",
            "emission_axis",
            "emission_exponent",
            "lightConfiguration",
            "directional",
            "spherical",
            "lights3d",
            "directions",
            "positions",
            "positions3d",
            "domeDiameter",
            "verticalOffset",
            "imageWidth",
            "ledAdjust",
            "lightsCalibration",
            "whiteBalance",
            "spatialCalibration",
            "map.png",
            "sky.exr",
            "0,577",
            "1e308",
            "1e-308",
            "nan",
            "\\",
            "\xEF\xBB\xBF"};
}

// Two exemplars of a constant table, 1/pi, whose integral of D cos is 1; with and without maps.
Words tabulated_seeds() {
    TabulatedMaterial m;
    m.grid = {4, 6};
    m.exemplars = 2;
    m.D.assign(48, 0.31831F);
    m.origin.assign(48, NdfOrigin::measured);
    m.groove = {0.0F, 1.0F};
    m.width = m.height = 2;
    m.exemplar = {0, 1, TabulatedMaterial::kNoExemplar, 1};
    m.angle = {0.0F, 1.0F, 2.0F, 3.0F};
    m.diffuse = m.specular = m.normal = Image(2, 2, 3);
    for (std::size_t i = 2; i < 12; i += 3) m.normal.pixels[i] = 1;
    const fs::path file = fs::temp_directory_path() / fmt::format("burnish-seed-{}.exr", getpid());
    Words seeds;
    for (int i = 0; i < 2; ++i) {
        write_tabulated_material(file, m);
        seeds.push_back(read_text_file(file));
        m.maps["ward.alpha_x"] = {1, 2, 3, 4};
        m.metadata["source"] = "seed";
    }
    fs::remove(file);
    return seeds;
}

Words tabulated_words() {
    return {"exemplars",
            "texels",
            "maps",
            "tabulated:version",
            "tabulated:rings",
            "tabulated:azimuths",
            "tabulated:exemplars",
            "tabulated:columns",
            "tabulated:eta",
            "chunkCount",
            "dataWindow",
            "displayWindow",
            "scanlineimage",
            "compression",
            "channels",
            "exemplar",
            "angle",
            "diffuse.R"};
}

}  // namespace burnish::fuzz
