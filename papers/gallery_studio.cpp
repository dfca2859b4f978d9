#include "papers/gallery_studio.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "burnish/context.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "burnish/shading_names.hpp"
#include "burnish/stage.hpp"
#include "core/text.hpp"

namespace burnish {
namespace {

// Background of a lamp-lit picture on a white page: dark gray, so that the model's outline is
// visible.
constexpr std::string_view kDarkness = "#484848";

std::string quoted(const std::string& word) {
    return word.find_first_of(" *?$&|;<>()#'\"") == std::string::npos ? word : "'" + word + "'";
}

std::string command_of(const PictureSpec& spec, int pixels, int samples) {
    std::string text = "burnish render " + quoted(spec.input);
    for (const auto& [name, value] : spec.parameters) {
        if (name == "width" || name == "height" || name == "samples") continue;
        text += fmt::format(" {} {}", flag_of(name), quoted(value));
    }
    if (spec.environment == "none")
        text += fmt::format(" --background color --background-color '{}'", kDarkness);
    text += " --env " + quoted(spec.environment);
    for (const std::string& light : spec.lights) text += " --light " + quoted(light);
    return text + fmt::format(" --size {}x{} --samples {} -o OUT.png", pixels, pixels, samples);
}

// The specification without the method: pictures with equal keys differ only in their materials.
std::string key_of(const PictureSpec& spec, int pixels) {
    std::string key = fmt::format("{}|{}|{}", spec.input, spec.environment, pixels);
    for (const std::string& light : spec.lights) key += "|" + light;
    for (const auto& [name, value] : spec.parameters)
        if (name != "method") key += fmt::format("|{}={}", name, value);
    return key;
}

Method method_of(const PictureSpec& spec) {
    Method method = Method::follow_grain;
    for (const auto& [name, value] : spec.parameters)
        if (name == "method")
            method =
                static_cast<Method>(index_of_name(method_names(), value, "method", "--method"));
    return method;
}

}  // namespace

PictureSpec PictureSpec::with(std::string name, std::string value) const {
    return with({{std::move(name), std::move(value)}});
}

PictureSpec PictureSpec::with(const std::vector<std::pair<std::string, std::string>>& more) const {
    PictureSpec copy = *this;
    for (const auto& [name, value] : more) {
        const auto found = std::find_if(copy.parameters.begin(), copy.parameters.end(),
                                        [&key = name](const auto& p) { return p.first == key; });
        if (found != copy.parameters.end())
            found->second = value;
        else
            copy.parameters.emplace_back(name, value);
    }
    return copy;
}

struct GalleryStudio::Set {
    std::string key, environment;
    Stage stage;
};

GalleryStudio::GalleryStudio(bool quick, int gl_device)
    : quick_(quick), context_(gl_device), renderer_(context_) {}
GalleryStudio::~GalleryStudio() = default;

GalleryStudio::Set& GalleryStudio::set_for(const PictureSpec& spec, double side) {
    const int pixels = static_cast<int>(side * (quick_ ? 1.0 : 2.0));
    const std::string key = key_of(spec, pixels);
    if (!set_ || set_->key != key) {
        StageRequest request;
        request.input = spec.input;
        request.environment = spec.environment;
        request.lights = spec.lights;
        ParameterValues& values = request.values;
        values.set("width", std::to_string(pixels), "gallery");
        values.set("height", std::to_string(pixels), "gallery");
        values.set("samples", quick_ ? "4" : "32", "gallery");
        values.set("background_color", kDarkness, "gallery");
        if (spec.environment == "none") values.set("background", "color", "gallery");
        for (const auto& [name, value] : spec.parameters) values.set(name, value, "gallery");
        auto set = std::make_unique<Set>(Set{key, spec.environment, set_stage(request)});
        renderer_.set_scene(set->stage.scene);
        if (!set_ || set_->environment != set->environment) {
            const Environment& environment = set->stage.environment;
            renderer_.set_environment(environment.radiance.empty() ? nullptr : &environment);
        }
        set_ = std::move(set);
    }
    for (Material& material : set_->stage.scene.materials) material.method = method_of(spec);
    renderer_.set_materials(set_->stage.scene.materials);
    return *set_;
}

Picture GalleryStudio::picture(const PictureSpec& spec, double side, const Progress& progress) {
    Set& set = set_for(spec, side);
    const Stage& stage = set.stage;
    Picture picture;
    picture.linear = renderer_.render(stage.camera, stage.settings, progress);
    const Image shown = to_display(picture.linear, stage.exposure_ev, stage.tone_map);
    picture.display = Image(shown.width, shown.height, 3);
    for (std::size_t i = 0; i < picture.display.pixels.size(); ++i)
        picture.display.pixels[i] = shown.pixels[i / 3 * 4 + i % 3];
    picture.command = command_of(spec, stage.settings.width, stage.settings.samples);
    return picture;
}

Image GalleryStudio::mask(const PictureSpec& spec, double side, const Progress& progress) {
    Set& set = set_for(spec, side);
    RenderSettings options = set.stage.settings;
    options.background = BackgroundKind::transparent;
    options.image_light = ImageLight::off;
    options.samples = 4;
    const Image picture = renderer_.render(set.stage.camera, options, progress);
    Image mask(picture.width, picture.height, 1);
    for (std::size_t i = 0; i < mask.pixels.size(); ++i) mask.pixels[i] = picture.pixels[4 * i + 3];
    return mask;
}

double GalleryStudio::frame_seconds() {
    constexpr int kFrames = 4;
    return renderer_.time_frames(set_->stage.camera, set_->stage.settings, kFrames) / kFrames;
}

}  // namespace burnish
