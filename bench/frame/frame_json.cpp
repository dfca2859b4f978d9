// Writes the result of `burnish bench frame` as JSON: every sample, with medians and spreads.
#include <nlohmann/json.hpp>

#include "bench/frame/frame_cost.hpp"
#include "bench/frame/frame_papers.hpp"
#include "burnish/version.hpp"

namespace burnish {

namespace {

using nlohmann::ordered_json;

constexpr double kMilli = 1e3;

ordered_json json_of(const std::optional<double>& value) {
    return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json json_of(const Estimated& e, double scale = 1.0) {
    if (!e) return nullptr;
    return {
        {"median", scale * e->median}, {"spread", scale * e->spread}, {"error", scale * e->error}};
}

// The estimates by each of the three clocks.
template <typename Estimator>
ordered_json by_clock(const Estimator& estimator, double scale = 1.0) {
    return {{"wall", json_of(estimator(Clock::wall), scale)},
            {"cpu", json_of(estimator(Clock::cpu), scale)},
            {"device", json_of(estimator(Clock::device), scale)}};
}

ordered_json samples_json(const TechniqueCost& cost) {
    ordered_json list = ordered_json::array();
    for (std::size_t i = 0; i < cost.samples.size(); ++i) {
        for (std::size_t round = 0; round < cost.samples[i].size(); ++round) {
            const FrameSample& s = cost.samples[i][round];
            list.push_back({{"technique", cost.subjects[i].name},
                            {"round", round},
                            {"place", s.place},
                            {"frames", s.frames},
                            {"wall_s", s.times.wall_s},
                            {"cpu_s", s.times.cpu_s},
                            {"device_s", json_of(s.times.device_s)}});
        }
    }
    return list;
}

ordered_json technique_json(const FrameCaseCost& of, const TechniqueCost& cost) {
    ordered_json out = {{"name", cost.technique.name}};
    out["k12_table1"] = json_of(k12_cost(cost.technique.name));
    out["against_gouraud"] = by_clock([&](Clock c) { return of.against_gouraud(cost, c); });
    out["against_normal_map"] = by_clock([&](Clock c) { return cost.against("normal-map", c); });
    out["frame_ms"] = by_clock([&](Clock c) { return of.frame_s(cost, c); }, kMilli);
    out["samples"] = samples_json(cost);
    return out;
}

ordered_json rotation_json(const FrameCaseCost& of) {
    if (of.rotation.samples.empty()) return nullptr;
    ordered_json out = {{"k12_fig7_us",
                         {{"accurate", 1e6 * kK12AccurateRotation},
                          {"approximate", 1e6 * kK12ApproximateRotation}}},
                        {"unit", "microseconds a frame"}};
    constexpr double kMicro = 1e6;
    const auto between = [&](std::size_t a, std::size_t b) {
        return by_clock([&](Clock c) { return difference(of.rotation.samples, a, b, c); }, kMicro);
    };
    out["approximate_minus_normal_map"] = between(1, 0);
    out["exact_minus_normal_map"] = between(2, 0);
    out["exact_minus_approximate"] = between(2, 1);
    out["samples"] = samples_json(of.rotation);
    return out;
}

ordered_json case_json(const FrameCaseCost& of) {
    ordered_json out = {{"width", of.asked.width},
                        {"height", of.asked.height},
                        {"triangles", of.triangles},
                        {"covered_pixels", of.covered_pixels},
                        {"techniques", ordered_json::array()}};
    for (const TechniqueCost& cost : of.costs)
        out["techniques"].push_back(technique_json(of, cost));
    out["rotation"] = rotation_json(of);
    return out;
}

ordered_json timer_json(const TimerVerdict& timer) {
    ordered_json probes = ordered_json::array();
    for (const TimerProbe& p : timer.probes)
        probes.push_back(
            {{"frames", p.frames}, {"wall_s", p.wall_s}, {"device_s", json_of(p.device_s)}});
    return {{"usable", timer.usable}, {"reason", timer.reason}, {"probes", probes}};
}

ordered_json subject_json() {
    const FrameSubject s = frame_subject();
    return {{"mesh", s.mesh},
            {"material", s.material},
            {"normal_map", s.normal_map},
            {"light", s.light},
            {"environment", s.environment},
            {"tabulated", s.tabulated},
            {"image_light_samples", s.image_light_samples}};
}

ordered_json load_json(double load) {
    return load < 0 ? ordered_json(nullptr) : ordered_json(load);
}

}  // namespace

std::string frame_cost_json(const FrameCost& cost) {
    ordered_json out = {{"format", "burnish-frame-cost"},
                        {"version", version()},
                        {"command", cost.command},
                        {"date", cost.date}};
    out["machine"] = {{"processor", cost.processor},
                      {"threads", cost.threads},
                      {"load_average_before", load_json(cost.load_before)},
                      {"load_average_after", load_json(cost.load_after)}};
    out["gl"] = {{"device", cost.device}, {"driver", cost.driver}, {"software", cost.software}};
    out["timer_queries"] = timer_json(cost.timer);
    out["clock"] = cost.clock() == Clock::device ? "device" : "wall";
    out["rounds"] = cost.rounds;
    out["sample_s"] = cost.sample_s;
    out["warnings"] = cost.warnings;
    out["scene"] = subject_json();
    out["cases"] = ordered_json::array();
    for (const FrameCaseCost& of : cost.cases) out["cases"].push_back(case_json(of));
    // Driver names may not be UTF-8: invalid bytes are replaced.
    return out.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace burnish
