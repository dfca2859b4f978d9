#include "jobs/capture/capture_simulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/version.hpp"
#include "core/constants.hpp"
#include "core/files.hpp"
#include "jobs/map_folder.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;
using Metadata = std::map<std::string, std::string>;

// Default clipping level of integer pictures, in units of the radiance of a white diffuser.
constexpr double kUsualClip = 4.0;

Rig rig_of(const CaptureSimulateRequest& request, const VirtualSample& sample) {
    if (request.rig == "bar")
        return make_bar_rig(sample, request.leds, request.steps, request.placing);
    if (request.rig == "dome") return make_dome_rig(sample, request.dome_lights, request.placing);
    if (!is_rig_file(request.rig))
        throw UsageError("--rig", "", "bar, dome or a rig file", shown(request.rig));
    Rig rig = read_rig(request.rig, false);
    rig.file.clear();
    rig.intensity_stated = true;  // the pictures are made with them
    rig.mask.reset();
    rig.white.reset();
    rig.width_mm = sample.width_mm;
    rig.height_mm = sample.height_mm;
    return rig;
}

const char* extension_of(StackFormat format) {
    return format == StackFormat::exr ? ".exr" : ".png";
}

// Encodes values of 0 to 1 and writes them.
void write_codes(const fs::path& temporary, const std::string& name, Image image,
                 StackFormat format, const Metadata& metadata) {
    if (format == StackFormat::png8) {
        for (float& value : image.pixels) value = srgb_from_linear(value);
        write_image(temporary, image, metadata);
        return;
    }
    DataPicture picture = picture_of_rows(
        DataFormat::png16, kRgb, image.width, image.height,
        [&image](int begin, int end, float* to) {
            const float* from = image.at(0, begin);
            std::copy_n(from, static_cast<std::ptrdiff_t>(end - begin) * image.width * 3, to);
        });
    picture.metadata = metadata;
    write_data_picture(temporary, picture, name, [](double) {});
}

std::string truth_json(const CaptureSimulateRequest& request, const VirtualSample& sample) {
    nlohmann::ordered_json out;
    out["format"] = "burnish-virtual-sample";
    out["version"] = 1;
    out["material"] = sample.name;
    out["size"] = {sample.width, sample.height};
    out["size_mm"] = {sample.width_mm, sample.height_mm};
    out["eta"] = sample.eta;
    out["noise"] = request.camera.noise;
    out["seed"] = request.camera.seed;
    for (const VirtualNdf& ndf : sample.ndfs) {
        nlohmann::ordered_json lobes;
        for (const VirtualLobe& lobe : ndf.lobes)
            lobes.push_back({{"weight", lobe.weight},
                             {"mdf", name_of(lobe.mdf)},
                             {"alpha_along", lobe.alpha_x},
                             {"alpha_across", lobe.alpha_y},
                             {"turn_deg", lobe.rotation * kDegreesPerRadian},
                             {"lean", {lobe.lean_x, lobe.lean_y}}});
        out["distributions"].push_back({{"name", ndf.name}, {"lobes", lobes}});
    }
    out["made"] = {{"version", version()}, {"command", request.command}};
    return out.dump(2) + "\n";
}

// A three-channel picture of value(texel) for every texel.
Image truth_map(const VirtualSample& sample,
                const std::function<Vec3d(const VirtualTexel&)>& value) {
    Image image(sample.width, sample.height, 3);
    for (std::size_t t = 0; t < sample.texels.size(); ++t) {
        const Vec3d v = value(sample.texels[t]);
        for (std::size_t c = 0; c < 3; ++c) image.pixels[3 * t + c] = static_cast<float>(v[c]);
    }
    return image;
}

void add_truth(const CaptureSimulateRequest& request, const VirtualSample& sample,
               const Metadata& metadata, std::vector<FileToWrite>& files) {
    const fs::path folder = request.output / "truth";
    const auto add = [&](const char* name, const std::function<Vec3d(const VirtualTexel&)>& value) {
        files.push_back({folder / name, [&sample, &metadata, value](const fs::path& path) {
                             write_image(path, truth_map(sample, value), metadata);
                         }});
    };
    const auto gray = [](double v) { return Vec3d{v, v, v}; };
    add("class.exr", [gray](const VirtualTexel& t) { return gray(t.ndf); });
    add("grain_angle_deg.exr", [gray](const VirtualTexel& t) {
        const double turns = t.grain / std::numbers::pi;
        return gray(180.0 * (turns - std::floor(turns)));
    });
    add("diffuse.exr", [](const VirtualTexel& t) { return t.diffuse; });
    add("specular.exr", [](const VirtualTexel& t) { return t.specular; });
    add("normal.exr", [](const VirtualTexel& t) { return t.normal; });
    files.push_back({folder / "truth.json", [&](const fs::path& path) {
                         write_text_file(path, truth_json(request, sample));
                     }});
}

// The written rig: its pictures, and intensities in the units of their codes.
Rig written_rig(const CaptureSimulateRequest& request, const Rig& rig, double level) {
    Rig out = rig;
    out.response = request.format == StackFormat::png8 ? RigResponse::srgb : RigResponse::linear;
    for (std::size_t k = 0; k < out.lights.size(); ++k) {
        out.lights[k].images = {
            {request.output / "images" / fmt::format("{:04}{}", k, extension_of(request.format)),
             1.0}};
        for (double& intensity : out.lights[k].intensity) intensity /= level;
    }
    return out;
}

}  // namespace

CaptureSimulateResult capture_simulate(const CaptureSimulateRequest& request,
                                       const Progress& progress) {
    CaptureSimulateResult report;
    const VirtualSample sample = make_virtual_sample(request.preset, request.sample);
    const Rig rig = rig_of(request, sample);
    VirtualCamera camera = request.camera;
    const bool coded = request.format != StackFormat::exr;
    if (coded && camera.clip <= 0.0) camera.clip = kUsualClip;
    const double level = coded ? camera.clip * white_level(sample, rig) : 1.0;
    const Rig written = written_rig(request, rig, level);
    const Metadata metadata = {{"burnish:version", std::string(version())},
                               {"burnish:command", request.command}};

    const OutputFolder folder(request.output);
    const OutputFolder images(request.output / "images"), truth(request.output / "truth");
    // The first file is renamed to its final name last: if rig.json exists, the stack is complete.
    std::vector<FileToWrite> files;
    files.push_back(
        {request.output / "rig.json", [&](const fs::path& path) { write_rig(path, written); }});
    add_truth(request, sample, metadata, files);
    for (const FileToWrite& file : files) report.written.push_back(file.path);
    const std::size_t count = rig.lights.size();
    for (std::size_t k = 0; k < count; ++k) {
        const fs::path& name = written.lights[k].images.front().image;
        files.push_back(
            {name, [&, k, name](const fs::path& path) {
                 progress.step("pictures", static_cast<double>(k) / static_cast<double>(count));
                 Image image = virtual_picture(sample, rig, k, camera);
                 if (!coded) return write_image(path, image, metadata);
                 for (float& value : image.pixels) value /= static_cast<float>(level);
                 write_codes(path, name.string(), std::move(image), request.format, metadata);
             }});
    }
    write_files_whole(files);
    report.pictures = count;
    return report;
}

}  // namespace burnish
