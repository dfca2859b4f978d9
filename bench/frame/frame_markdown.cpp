// Writes the result of `burnish bench frame` as Markdown: a table for each case, with the papers'
// figures.
#include <fmt/format.h>

#include <cmath>

#include "bench/frame/frame_cost.hpp"
#include "bench/frame/frame_papers.hpp"
#include "burnish/version.hpp"

namespace burnish {

namespace {

std::string number(const Estimated& e, double scale = 1.0) {
    return e ? fmt::format("{:.2f}", scale * e->median) : "-";
}

std::string with_spread(const Estimated& e) {
    return e ? fmt::format("{:.2f} ± {:.2f}", e->median, e->spread) : "-";
}

// A technique without samples is the unit and has no spread.
std::string of_gouraud(const FrameCaseCost& of, const TechniqueCost& cost, Clock clock) {
    const Estimated e = of.against_gouraud(cost, clock);
    return cost.samples.empty() ? number(e) : with_spread(e);
}

std::string of_normal_map(const TechniqueCost& cost, Clock clock) {
    const Estimated e = cost.against("normal-map", clock);
    return cost.technique.name == "normal-map" ? number(e) : with_spread(e);
}

std::string row_of(const FrameCaseCost& of, const TechniqueCost& cost, Clock clock) {
    const std::optional<double> paper = k12_cost(cost.technique.name);
    const Estimated frame = of.frame_s(cost, clock);
    const std::string pixel =
        frame && of.covered_pixels > 0
            ? fmt::format("{:.1f}", 1e9 * frame->median / static_cast<double>(of.covered_pixels))
            : "-";
    return fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", cost.technique.name,
                       of_gouraud(of, cost, clock), number(of.against_gouraud(cost, Clock::cpu)),
                       of_normal_map(cost, clock), number(cost.against("normal-map", Clock::cpu)),
                       number(frame, 1e3), pixel, paper ? fmt::format("{:.2f}", *paper) : "");
}

// Is the difference larger than two standard errors of the median?
bool resolved(const Estimate& e) {
    return std::abs(e.median) > 2.0 * e.error;
}

std::string rotation_row(const FrameCaseCost& of, const char* what, std::size_t subject,
                         std::size_t base, double paper_s, Clock clock) {
    const Estimated e = difference(of.rotation.samples, subject, base, clock);
    if (!e) return "";
    const double pixels = static_cast<double>(of.covered_pixels);
    const std::string pixel = pixels > 0 ? fmt::format("{:.2f} ± {:.2f}", 1e9 * e->median / pixels,
                                                       1e9 * e->error / pixels)
                                         : "-";
    return fmt::format("| {} | {:.0f} ± {:.0f} | {} | {} | {:.0f} |\n", what, 1e6 * e->median,
                       1e6 * e->error, pixel, resolved(*e) ? "yes" : "no", 1e6 * paper_s);
}

std::string rotation_table(const FrameCaseCost& of, Clock clock) {
    if (of.rotation.samples.empty()) return "";
    return "\nK12 Fig 7: what a rotation adds to a frame (± the standard error of the median; "
           "resolved: more than two of them).\n\n"
           "| | microseconds a frame | ns a covered pixel | resolved | K12, microseconds |\n"
           "|---|---|---|---|---|\n" +
           rotation_row(of, "rotate-approx - normal-map", 1, 0, kK12ApproximateRotation, clock) +
           rotation_row(of, "rotate-exact - normal-map", 2, 0, kK12AccurateRotation, clock) +
           rotation_row(of, "rotate-exact - rotate-approx", 2, 1,
                        kK12AccurateRotation - kK12ApproximateRotation, clock);
}

std::string case_text(const FrameCaseCost& of, Clock clock) {
    std::string text = fmt::format(
        "\n## {} x {}, {} triangles\n\n{} pixels ({:.0f} %) are covered.\n\n"
        "| technique | of Gouraud | CPU | of normal-map | CPU | ms a frame | ns a covered pixel | "
        "K12 Table I, of Gouraud |\n|---|---|---|---|---|---|---|---|\n",
        of.asked.width, of.asked.height, of.triangles, of.covered_pixels,
        100.0 * static_cast<double>(of.covered_pixels) /
            (static_cast<double>(of.asked.width) * of.asked.height));
    for (const TechniqueCost& cost : of.costs) text += row_of(of, cost, clock);
    return text + rotation_table(of, clock);
}

std::string load_text(const FrameCost& cost) {
    if (cost.load_before < 0) return "unknown";
    return fmt::format("{:.1f} before, {:.1f} after", cost.load_before, cost.load_after);
}

std::string clock_text(const FrameCost& cost) {
    if (cost.timer.usable)
        return "Times are the device's own (its timer queries passed the check); CPU is processor "
               "time of all threads.";
    return fmt::format(
        "Times are by the wall clock, between two glFinish; CPU is processor time of all threads. "
        "The device's timer queries are not used: {}.",
        cost.timer.reason);
}

}  // namespace

std::string frame_cost_markdown(const FrameCost& cost) {
    std::string text = fmt::format(
        "# What a frame costs\n\n"
        "- device: {} ({})\n- machine: {}, {} threads, load average {}\n- date: {}\n"
        "- burnish {}: `{}`\n\n{}\n\n"
        "Ratios are medians over {} rounds, in which the technique, normal-map and Gouraud shading "
        "are drawn by turns, ± half the distance between the quartiles. The first frames of each, "
        "in which shaders are compiled, do not count.\n",
        cost.device, cost.driver, cost.processor, cost.threads, load_text(cost), cost.date,
        version(), cost.command, clock_text(cost), cost.rounds);
    for (const std::string& warning : cost.warnings) text += "\nNote: " + warning + ".\n";
    const FrameSubject s = frame_subject();
    text += fmt::format(
        "\nScene: {}, {}, normal map {}, {}; image light: {}, {} samples by importance; "
        "tabulated: {}. K11 Fig 11 "
        "gives no figures in the text we hold; it says that {}.\n",
        s.mesh, s.material, s.normal_map, s.light, s.environment, s.image_light_samples,
        s.tabulated, kK11Figure11);
    for (const FrameCaseCost& of : cost.cases) text += case_text(of, cost.clock());
    return text;
}

}  // namespace burnish
