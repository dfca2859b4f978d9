#include "capture/solve/capture_fit.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "burnish/coverage.hpp"
#include "burnish/error.hpp"
#include "capture/solve/texel_fit.hpp"
#include "capture/stack/stage_file.hpp"
#include "core/constants.hpp"
#include "formats/tabulated/tabulated_parts.hpp"

namespace burnish {

namespace {

// Version of the method. Raise it if the same settings give other numbers or if the layout of a
// stage changes: stages of other versions are computed again.
constexpr int kMethodVersion = 6;
// Interval between writes of finished bands: an interruption loses at most this time and one band.
constexpr std::chrono::seconds kSaveEvery{20};
// Training points of the trial of normals where a flat fit leaves much unexplained: enough for a few
// exemplars, a sixteenth of the usual number.
constexpr std::size_t kTrialPoints = 512;

// Calls use(member) for every member that the stage of exemplars stores.
template <typename Found, typename Report, typename Use>
void for_each_of_exemplar_stage(Found& exemplars, Report& report, Use use) {
    use(exemplars.count);
    use(exemplars.D);
    use(exemplars.weights);
    use(exemplars.areas);
    use(exemplars.origin);
    use(report.completion);
    use(report.training_points);
    use(report.exemplars);
    use(report.eta);
    use(report.training_error);
    use(report.start);
    use(report.tilted_error);
}

bool is_whole(const Exemplars& found) {
    const std::size_t count = static_cast<std::size_t>(std::max(found.count, 0));
    const std::size_t cells = count * static_cast<std::size_t>(found.grid.cells());
    return count > 0 && found.D.size() == cells && found.weights.size() == cells &&
           found.origin.size() == cells &&
           found.areas.size() == count * static_cast<std::size_t>(kAreaGrid.cells());
}

std::vector<LobeFit> lobes_of(const Exemplars& exemplars) {
    std::vector<LobeFit> out;
    out.reserve(static_cast<std::size_t>(exemplars.count));
    for (int e = 0; e < exemplars.count; ++e)
        out.push_back(fit_lobe(exemplars.grid, exemplars.table(e), Mdf::ggx));
    return out;
}

void add_model_maps(const Texels& texels, TabulatedMaterial& m) {
    const auto names = parametric_model_names();
    const std::size_t numbers = names.size() * kModelNumbers.size();
    for (std::size_t k = 0; k < numbers; ++k) {
        std::vector<float>& map = m.maps[fmt::format("{}.{}", names[k / kModelNumbers.size()],
                                                     kModelNumbers[k % kModelNumbers.size()])];
        map.resize(m.texels());
        for (std::size_t t = 0; t < map.size(); ++t) map[t] = texels.models[t * numbers + k];
    }
}

}  // namespace

std::vector<std::uint8_t> fitted_lights(std::size_t lights, int hold_out) {
    std::vector<std::uint8_t> keep(lights, 1);
    if (hold_out < 2) return keep;
    const auto n = static_cast<std::size_t>(hold_out);
    for (std::size_t k = n / 2; k < lights; k += n) keep[k] = 0;
    return keep;
}

CaptureFit::CaptureFit(const Rig& rig, const CaptureFitSettings& settings,
                       const std::filesystem::path& stages, const Progress& progress)
    : rig_(rig), settings_(settings), stages_(stages), progress_(progress) {
    std::error_code error;
    std::filesystem::create_directories(stages, error);
    if (error) throw Error(stages.string(), "", "a folder that can be made", error.message());
    stack_ =
        std::make_unique<ImageStack>(rig, stages / "pictures.bin", progress, settings.band_bytes);
    start();
}

CaptureFit::CaptureFit(const Rig& rig, std::span<const Image> pictures, const Image& mask,
                       const CaptureFitSettings& settings, const Progress& progress)
    : rig_(rig), settings_(settings), progress_(progress) {
    stack_ =
        std::make_unique<ImageStack>(images_of(rig, pictures, mask), progress, settings.band_bytes);
    start();
}

void CaptureFit::start() {
    if (rig_.width_mm > 0.0 && rig_.height_mm <= 0.0)
        rig_.height_mm = rig_.width_mm * stack_->height() / stack_->width();
    context_.keep = fitted_lights(stack_->lights(), settings_.hold_out);
    report_.level = light_level(*stack_, rig_, context_.keep);
    multiply_intensities(rig_, report_.level.intensity);
    geometry_ = std::make_unique<LightGeometry>(rig_, stack_->width(), stack_->height());
    context_.geometry = geometry_.get();
    context_.grid = settings_.grid;
    report_.census = stack_->census();
    report_.spacing_deg = point_coverage(rig_, {0.0, 0.0, 0.0}).spacing;
    context_.spacing_rad = static_cast<float>(report_.spacing_deg * kDegree);
}

CaptureFit::~CaptureFit() = default;

FoundExemplars CaptureFit::search(const TrainingPoints& points, NormalStart start,
                                  std::optional<double> eta) const {
    return burnish::find_exemplars(
        context_, points.pixels, points.values,
        {.exemplars = settings_.exemplars, .eta = eta, .seed = settings_.seed, .normals = start},
        progress_);
}

FoundExemplars CaptureFit::search_tilted(const TrainingPoints& points, std::optional<double> eta,
                                         NormalStart& start) const {
    start = NormalStart::shading;
    FoundExemplars found = search(points, start, eta);
    if (std::sqrt(found.mean_error) <= kMuchUnexplained) return found;
    FoundExemplars other = search(points, NormalStart::highlight, eta);
    if (other.mean_error >= found.mean_error) return found;
    start = NormalStart::highlight;
    return other;
}

void CaptureFit::find_exemplars() {
    if (load_exemplars()) return;
    const TrainingPoints points = training_points(*stack_, settings_.training_points, progress_);
    report_.start = NormalStart::none;
    FoundExemplars found = settings_.normals ? search_tilted(points, settings_.eta, report_.start)
                                             : search(points, NormalStart::none, settings_.eta);
    exemplars_ = std::move(found.exemplars);
    report_.completion = found.completion;
    report_.training_points = static_cast<int>(points.pixels.size());
    report_.exemplars = exemplars_.count;
    report_.eta = found.eta;
    report_.training_error = std::sqrt(found.mean_error);
    if (!settings_.normals && report_.training_error > kTriedUnexplained) {
        NormalStart ignored;
        const TrainingPoints few = some_of(points, kTrialPoints, stack_->lights());
        report_.tilted_error = std::sqrt(search_tilted(few, found.eta, ignored).mean_error);
    }
    save_exemplars();
}

TexelFitter CaptureFit::texel_fitter() const {
    return TexelFitter(context_, *stack_, exemplars_, lobes_of(exemplars_),
                       {.normals = report_.start,
                        .models = settings_.models,
                        .eta = report_.eta,
                        .training_error = report_.training_error});
}

void CaptureFit::fit_texels() {
    texels_.emplace(0, stack_->pixels(), settings_.models);
    TexelFitter fitter = texel_fitter();
    auto saved = std::chrono::steady_clock::now();
    for (std::size_t b = load_texels(); b < stack_->bands(); ++b) {
        progress_.step("texels", static_cast<double>(b) / static_cast<double>(stack_->bands()));
        fitter.fit(stack_->load(b), progress_, *texels_);
        const auto now = std::chrono::steady_clock::now();
        if (now - saved < kSaveEvery && b + 1 < stack_->bands()) continue;
        save_texels(b + 1);
        saved = now;
    }
}

Texels CaptureFit::fit_bands(std::size_t first, std::size_t last) {
    const std::size_t begin = first * stack_->band_pixels();
    const std::size_t end = std::min(last * stack_->band_pixels(), stack_->pixels());
    Texels texels(begin, end - begin, settings_.models);
    TexelFitter fitter = texel_fitter();
    for (std::size_t b = first; b < last; ++b) {
        progress_.step("texels",
                       static_cast<double>(b - first) / static_cast<double>(last - first));
        fitter.fit(stack_->load(b), progress_, texels);
    }
    return texels;
}

void CaptureFit::take_texels(Texels texels) {
    if (texels.first != 0 || texels.count != stack_->pixels() || !texels.whole(settings_.models))
        throw Error("the texels of all bands of the stack are needed");
    texels_ = std::move(texels);
}

double CaptureFit::unexplained() const {
    if (!texels_) return report_.training_error;
    double sum = 0.0, count = 0.0;
    for (std::size_t p = 0; p < texels_->count; ++p) {
        if (texels_->exemplar[p] == TabulatedMaterial::kNoExemplar) continue;
        sum += static_cast<double>(texels_->error[p]);
        ++count;
    }
    return std::sqrt(sum / std::max(count, 1.0));
}

TabulatedMaterial CaptureFit::material() const {
    TabulatedMaterial m;
    m.grid = settings_.grid;
    m.exemplars = exemplars_.count;
    m.D = exemplars_.D;
    m.origin = exemplars_.origin;
    for (const LobeFit& lobe : lobes_of(exemplars_))
        m.groove.push_back(static_cast<float>(lobe.groove));
    m.eta = report_.eta;
    m.width = stack_->width();
    m.height = stack_->height();
    m.width_mm = rig_.width_mm;
    m.height_mm = rig_.height_mm;
    m.exemplar = texels_->exemplar;
    m.angle = texels_->angle;
    const auto image = [&](const std::vector<float>& values) {
        Image out(m.width, m.height, 3);
        out.pixels = values;
        return out;
    };
    // Single pixels may be brighter than the file's colors by any factor: broken ones of a sensor.
    const auto colors = [&](const std::vector<float>& values) {
        Image out = image(values);
        for (float& value : out.pixels) value = std::min(value, kMostColor);
        return out;
    };
    m.diffuse = colors(texels_->diffuse);
    m.specular = colors(texels_->specular);
    m.normal = image(texels_->normal);
    m.maps["fit.error"] = texels_->error;
    if (texels_->has_models()) add_model_maps(*texels_, m);
    record_level(report_.level, rig_, m.metadata);
    return m;
}

// ---- files kept between runs

std::uint64_t CaptureFit::identity() const {
    Identity id;
    id.add(kMethodVersion);
    id.add(stack_->identity());
    id.add(settings_.grid.rings);
    id.add(settings_.grid.azimuths);
    id.add(settings_.exemplars);
    id.add(settings_.eta.value_or(-1.0));
    id.add(settings_.seed);
    id.add(settings_.hold_out);
    id.add(settings_.training_points);
    id.add(settings_.normals);
    id.add(settings_.models);
    return id.value();
}

// The texels depend on the exemplars; the number of finished bands depends on the size of a band.
std::uint64_t CaptureFit::texel_identity() const {
    Identity id;
    id.add(identity());
    id.add(stack_->band_pixels());
    id.add_bytes(exemplars_.D.data(), exemplars_.D.size() * sizeof(float));
    return id.value();
}

void CaptureFit::save_exemplars() const {
    if (stages_.empty()) return;
    StageWriter writer(identity());
    for_each_of_exemplar_stage(exemplars_, report_, [&](const auto& field) { writer.put(field); });
    writer.write(stages_ / "exemplars.bin");
}

bool CaptureFit::load_exemplars() {
    if (stages_.empty()) return false;
    StageReader reader(stages_ / "exemplars.bin", identity());
    Exemplars found;
    CaptureFitReport report = report_;
    found.grid = settings_.grid;
    for_each_of_exemplar_stage(found, report, [&](auto& field) { reader.get(field); });
    if (!reader.good() || !is_whole(found)) return false;
    exemplars_ = std::move(found);
    report_ = report;
    return true;
}

void CaptureFit::save_texels(std::size_t bands) const {
    if (stages_.empty()) return;
    StageWriter writer(texel_identity());
    writer.put(static_cast<std::uint64_t>(bands));
    Texels::for_each_field(settings_.models,
                           [&](auto field, std::size_t) { writer.put((*texels_).*field); });
    writer.write(stages_ / "texels.bin");
}

// Loads the texels of an earlier run and returns the number of its finished bands.
std::size_t CaptureFit::load_texels() {
    if (stages_.empty()) return 0;
    StageReader reader(stages_ / "texels.bin", texel_identity());
    std::uint64_t bands = 0;
    Texels found;
    found.count = stack_->pixels();
    reader.get(bands);
    Texels::for_each_field(settings_.models,
                           [&](auto field, std::size_t) { reader.get(found.*field); });
    if (!reader.good() || bands > stack_->bands() || !found.whole(settings_.models)) return 0;
    texels_ = std::move(found);
    return bands;
}

// ---- the functions of burnish/capture_fit.hpp

namespace {

TabulatedMaterial fitted(CaptureFit&& fit) {
    fit.find_exemplars();
    fit.fit_texels();
    return fit.material();
}

}  // namespace

TabulatedMaterial fit_capture(const Rig& rig, std::span<const Image> pictures, const Image& mask,
                              const CaptureFitSettings& settings, const Progress& progress) {
    return fitted(CaptureFit(rig, pictures, mask, settings, progress));
}

TabulatedMaterial fit_capture(const Rig& rig, const std::filesystem::path& stages,
                              const CaptureFitSettings& settings, const Progress& progress) {
    return fitted(CaptureFit(rig, settings, stages, progress));
}

}  // namespace burnish
