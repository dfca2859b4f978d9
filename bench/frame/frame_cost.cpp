#include "bench/frame/frame_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "burnish/context.hpp"
#include "burnish/error.hpp"
#include "core/files.hpp"
#include "core/machine.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;

// Factor of rounds for the rotations, which differ by nanoseconds per pixel.
constexpr int kRotationRounds = 2;

using Names = std::vector<std::string_view>;

// The techniques measured together with a technique, itself last.
Names subjects_of(std::string_view technique) {
    if (technique == "gouraud") return {};
    if (technique == "normal-map") return {"gouraud", "normal-map"};
    return {"gouraud", "normal-map", technique};
}

bool asked_for(const FrameCostRequest& request, std::string_view name) {
    return std::any_of(request.techniques.begin(), request.techniques.end(),
                       [&](const Technique& t) { return t.name == name; });
}

// A part of the whole measurement and its weight.
struct Part {
    TechniqueCost* cost;
    int rounds;
    double weight() const { return static_cast<double>(cost->subjects.size()) * (rounds + 1); }
};

TechniqueCost unmeasured(std::string_view technique, const Names& subjects) {
    TechniqueCost cost{technique_named(technique, ""), {}, {}};
    for (const std::string_view name : subjects) cost.subjects.push_back(technique_named(name, ""));
    return cost;
}

// The costs to measure in a case, without samples; the bases come first.
FrameCaseCost unmeasured(const FrameCostRequest& request, const FrameCase& frame_case) {
    FrameCaseCost cost;
    cost.asked = frame_case;
    for (const Technique& t : techniques()) {
        const bool base = t.name == "gouraud" || t.name == "normal-map";
        if (base || asked_for(request, t.name))
            cost.costs.push_back(unmeasured(t.name, subjects_of(t.name)));
    }
    const bool both = asked_for(request, "rotate-approx") && asked_for(request, "rotate-exact");
    cost.rotation = unmeasured(
        "rotate-exact", both ? Names{"normal-map", "rotate-approx", "rotate-exact"} : Names{});
    return cost;
}

std::vector<Part> parts_of(FrameCaseCost& cost, int rounds) {
    std::vector<Part> parts;
    for (TechniqueCost& one : cost.costs)
        if (!one.subjects.empty()) parts.push_back({&one, rounds});
    if (!cost.rotation.subjects.empty())
        parts.push_back({&cost.rotation, kRotationRounds * rounds});
    return parts;
}

std::string stage_of(const FrameCaseCost& cost) {
    return fmt::format("{}x{}, {} triangles", cost.asked.width, cost.asked.height,
                       cost.asked.triangles);
}

void measure(FrameBench& bench, const FrameCostRequest& request, FrameCaseCost& cost,
             const std::function<void(double)>& tick) {
    const std::vector<Part> parts = parts_of(cost, request.rounds);
    double total = 0, done = 0;
    for (const Part& part : parts) total += part.weight();
    for (const Part& part : parts) {
        std::vector<const Technique*> subjects;
        for (const Technique& t : part.cost->subjects) subjects.push_back(&t);
        InterleaveOptions options;
        options.rounds = part.rounds;
        options.sample_s = request.sample_s;
        part.cost->samples = bench.interleave(
            subjects, options, [&](double share) { tick((done + share * part.weight()) / total); });
        done += part.weight();
    }
}

void require_sound(const FrameCostRequest& request) {
    const auto within = [](const char* key, int value, int low, int high) {
        if (value >= low && value <= high) return;
        throw UsageError(key, "", fmt::format("{} to {}", low, high), std::to_string(value));
    };
    if (request.cases.empty()) throw UsageError("bench frame", "", "one case or more", "none");
    within("--pairs", request.rounds, 3, 1000);
    for (const FrameCase& c : request.cases) {
        within("--size", c.width, 16, 16384);
        within("--size", c.height, 16, 16384);
        within("--triangles", c.triangles, 100, 4000000);
    }
    if (request.output.empty()) return;
    if (request.output.extension() != ".json")
        throw UsageError(request.output.string(), "", "a name that ends in .json",
                         shown(request.output.extension().string()));
    for (const char* extension : {".json", ".md", ".svg"})
        require_writable(fs::path(request.output).replace_extension(extension));
}

void warn_of_load(FrameCost& cost) {
    // On an idle machine one thread submits and the software renderer uses all threads.
    if (cost.load_before <= 0.5 * cost.threads) return;
    cost.warnings.push_back(fmt::format(
        "the machine was busy before the measurement (load {:.1f} on {} threads): trust ratios, "
        "and their spread",
        cost.load_before, cost.threads));
}

bool any_image_light(const FrameCostRequest& request) {
    return std::any_of(request.techniques.begin(), request.techniques.end(),
                       [](const Technique& t) { return t.lit_by_image(); });
}

// Checks the timer with Gouraud shading: one pass over the picture, for which llvmpipe's timer
// fails.
TimerVerdict timer_of(FrameBench& bench) {
    const Technique& gouraud = technique_named("gouraud", "");
    return check_timer([&](int frames) { return bench.time(gouraud, frames); });
}

FrameCost about_machine(const FrameCostRequest& request, const gpu::Context& context) {
    FrameCost cost;
    cost.device = context.renderer();
    cost.driver = context.version();
    cost.software = context.is_software();
    cost.processor = processor_name();
    cost.threads = std::max(1u, std::thread::hardware_concurrency());
    cost.load_before = load_average();
    cost.date = utc_time();
    cost.command = request.command;
    cost.rounds = request.rounds;
    cost.sample_s = request.sample_s;
    cost.warnings = context.warnings();
    warn_of_load(cost);
    return cost;
}

}  // namespace

std::vector<FrameCase> default_frame_cases(bool quick) {
    if (quick) return {{4096, 1280, 720}, {102400, 1280, 720}};
    return {{4096, 1280, 720},    {16384, 1280, 720},   {102400, 1280, 720}, {400000, 1280, 720},
            {1000000, 1280, 720}, {102400, 1920, 1080}, {102400, 3840, 2160}};
}

FrameCostRequest default_frame_request(bool quick) {
    FrameCostRequest request;
    request.cases = default_frame_cases(quick);
    request.techniques = {techniques().begin(), techniques().end()};
    if (quick) {
        request.rounds = 7;
        request.sample_s = 0.025;
    }
    return request;
}

std::optional<std::size_t> TechniqueCost::place_of(std::string_view name) const {
    for (std::size_t i = 0; i < subjects.size(); ++i)
        if (subjects[i].name == name) return i;
    return std::nullopt;
}

Estimated TechniqueCost::against(std::string_view base, Clock clock) const {
    const std::optional<std::size_t> place = place_of(base);
    if (!place || samples.empty()) return std::nullopt;
    return ratio(samples, samples.size() - 1, *place, clock);
}

Estimated TechniqueCost::frame_s(Clock clock) const {
    if (samples.empty()) return std::nullopt;
    return seconds_a_frame(samples, samples.size() - 1, clock);
}

Estimated FrameCaseCost::against_gouraud(const TechniqueCost& cost, Clock clock) const {
    if (!cost.samples.empty()) return cost.against("gouraud", clock);
    return frame_s(cost, clock) ? Estimated(Estimate{1.0, 0.0, 0.0}) : std::nullopt;
}

Estimated FrameCaseCost::frame_s(const TechniqueCost& cost, Clock clock) const {
    if (!cost.samples.empty()) return cost.frame_s(clock);
    for (const TechniqueCost& other : costs)
        if (other.technique.name == "normal-map" && !other.samples.empty())
            return seconds_a_frame(other.samples, *other.place_of("gouraud"), clock);
    return std::nullopt;
}

void FrameCost::distrust_silent_timer() {
    if (!timer.usable) return;
    const auto silent = [](const TechniqueCost& cost) {
        for (const std::vector<FrameSample>& of_subject : cost.samples)
            for (const FrameSample& sample : of_subject)
                if (!(sample.times.device_s.value_or(0.0) > 0.0)) return true;
        return false;
    };
    for (const FrameCaseCost& of : cases) {
        if (!silent(of.rotation) && std::none_of(of.costs.begin(), of.costs.end(), silent))
            continue;
        timer.usable = false;
        timer.reason = fmt::format("it gave no time for some frames of {}", stage_of(of));
        return;
    }
}

FrameCost measure_frame_cost(const FrameCostRequest& request, const Progress& progress) {
    require_sound(request);
    gpu::Context context(request.gl_device);
    for (const FrameCase& c : request.cases) require_size(context, c);
    FrameCost cost = about_machine(request, context);
    const auto count = static_cast<double>(request.cases.size());
    for (const FrameCase& frame_case : request.cases) {
        cost.cases.push_back(unmeasured(request, frame_case));
        FrameCaseCost& last = cost.cases.back();
        const std::string stage = stage_of(last);
        const double before = static_cast<double>(cost.cases.size() - 1);
        progress.step(stage, before / count);
        FrameBench bench(context, frame_case, any_image_light(request));
        last.triangles = bench.triangles();
        last.covered_pixels = bench.covered_pixels();
        if (cost.cases.size() == 1) cost.timer = timer_of(bench);
        measure(bench, request, last,
                [&](double share) { progress.step(stage, (before + share) / count); });
    }
    cost.load_after = load_average();
    cost.distrust_silent_timer();
    progress.step(stage_of(cost.cases.back()), 1.0);
    return cost;
}

FrameCostReport bench_frame(const FrameCostRequest& request, const Progress& progress) {
    FrameCostReport report;
    report.cost = measure_frame_cost(request, progress);
    if (request.output.empty()) return report;
    const auto text = [&](const char* extension, std::string contents) {
        const fs::path path = fs::path(request.output).replace_extension(extension);
        report.written.push_back(path);
        return FileToWrite{path, [contents = std::move(contents)](const fs::path& temporary) {
                               write_text_file(temporary, contents);
                           }};
    };
    const std::vector<FileToWrite> files = {text(".json", frame_cost_json(report.cost)),
                                            text(".md", frame_cost_markdown(report.cost)),
                                            text(".svg", frame_cost_svg(report.cost))};
    write_files_whole(files);
    return report;
}

}  // namespace burnish
