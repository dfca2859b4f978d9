// Writes index.html, without scripts or external resources.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "burnish/version.hpp"
#include "core/text.hpp"
#include "jobs/capture/capture_report_parts.hpp"
#include "jobs/info/info_scene.hpp"
#include "plot/html.hpp"

namespace burnish::report {

namespace {

std::string percent(double share) {
    return fmt::format("{:.0f} %", 100.0 * share);
}

std::string row(const std::string& name, const std::string& value) {
    return fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", escaped_html(name),
                       escaped_html(value));
}

std::string stack_section(const Page& page) {
    const TabulatedMaterial& m = *page.material;
    std::string text = "<section id=\"stack\">\n<h2>The stack</h2>\n<table class=\"numbers\">\n";
    text +=
        row("pictures", fmt::format("{} x {} pixels, {} lights", m.width, m.height, page.lights));
    text += row("clipped", fmt::format("{:.2g} % of the samples", 100 * page.census.clipped_share));
    text += row("black", fmt::format("{:.2g} % of the samples", 100 * page.census.black_share));
    text += row("brightest sample", fmt::format("{:.4g}", page.census.brightest));
    text += row(
        "material",
        fmt::format("{}, {} of {} rings x {} azimuths, {}",
                    m.width_mm > 0 ? fmt::format("{:g} x {:g} mm", m.width_mm, m.height_mm)
                                   : std::string("size not known"),
                    plural(static_cast<std::size_t>(m.exemplars), "exemplar"), m.grid.rings,
                    m.grid.azimuths,
                    m.eta > 0 ? fmt::format("index {:.3g}", m.eta) : std::string("no Fresnel")));
    text += "</table>\n<pre>" + escaped_html(page.rig_text) + "</pre>\n";
    text += "<p>" + html_picture(page.coverage, "half vectors on a disc of tilt and azimuth", 456) +
            "</p>\n";
    return text + fmt::format(
                      "<p>Tilt from the normal grows evenly from the centre, 0, to the rim, 90 "
                      "degrees. Covered: within {:.1f} degrees of a half vector, {} of the "
                      "hemisphere; {} when the points' grain turns all the way round.</p>\n"
                      "</section>\n",
                      page.rig_coverage.center.reach, percent(page.rig_coverage.center.covered),
                      percent(page.rig_coverage.center.covered_turned));
}

std::string exemplar_card(const ExemplarEntry& e) {
    const auto byte = [](double v) { return std::lround(255 * std::min(std::max(v, 0.0), 1.0)); };
    return fmt::format(
        "<figure>{}\n<figcaption><span class=\"swatch\" style=\"background:#{:02x}{:02x}{:02x}\">"
        "</span><strong>Exemplar {}</strong>, {:.3g} % of the texels. Nearest GGX: alpha {:.3f} "
        "along, {:.3f} across the groove, which is at {:.0f} degrees in the table; {:.2f} away. "
        "Of the hemisphere {} measured, {} completed, {} extrapolated.</figcaption></figure>\n",
        html_picture(e.picture, fmt::format("exemplar {} as measured and completed", e.index)),
        byte(e.color.r), byte(e.color.g), byte(e.color.b), e.index, 100 * e.share,
        e.lobe.alpha_along, e.lobe.alpha_across, e.lobe.groove * 180 / std::numbers::pi,
        e.lobe.residual, percent(e.known[2]), percent(e.known[1]), percent(e.known[0]));
}

std::string exemplar_section(const Page& page) {
    std::string text =
        "<section id=\"exemplars\">\n<h2>Exemplars</h2>\n"
        "<p>Each distribution of microfacet normals D(h) before and after completion, on one "
        "logarithmic scale for all. Left: the cells that were measured; hatched, those completed "
        "from other exemplars, and plain grey, those extrapolated. Right: the whole table. The "
        "distance from the centre goes with the root of the tilt, so that peaks can be seen; "
        "circles at 10, 30 and 60 degrees; red marks at the ends of the groove. The GGX lobe is "
        "0 away where it is the same and 1 where it has nothing in common with the "
        "table.</p>\n<div class=\"cards\">\n";
    std::size_t others = 0;
    double share = 0.0;
    for (const ExemplarEntry& e : page.exemplars) {
        if (!e.picture.empty()) {
            text += exemplar_card(e);
            continue;
        }
        ++others;
        share += e.share;
    }
    text += "</div>\n";
    if (others > 0)
        text += fmt::format("<p>And {} more, which {:.2g} % of the texels have.</p>\n", others,
                            100 * share);
    return text + "</section>\n";
}

std::string map_section(const Page& page) {
    std::string text = "<section id=\"maps\">\n<h2>Maps</h2>\n<div class=\"cards\">\n";
    for (const MapEntry& map : page.maps)
        text += fmt::format(
            "<figure>{}\n<figcaption><strong>{}.</strong> {}</figcaption></figure>\n",
            html_picture(map.picture, map.title), escaped_html(map.title), escaped_html(map.text));
    return text + "</div>\n</section>\n";
}

std::string light_table(const LightEntry& light) {
    std::string text = fmt::format(
        "<h3>The {} light: {}</h3>\n<p>Light {}, {:.0f} degrees over the sample at azimuth {:.0f}; "
        "white is {:.3g} in all of these; PSNR is relative to the brightest sample of the real "
        "picture.</p>\n<table class=\"shots\">\n<tr>",
        light.rank, escaped_html(light.source), light.light, light.elevation, light.azimuth,
        light.white);
    for (const Shot& shot : light.shots) text += "<th>" + escaped_html(shot.title) + "</th>";
    text += "</tr>\n<tr>";
    for (const Shot& shot : light.shots)
        text += fmt::format("<td>{}{}</td>",
                            html_picture(shot.picture, light.rank + " light, " + shot.title),
                            shot.difference.empty() ? std::string("<br>as photographed")
                                                    : fmt::format("<br>{:.1f} dB", shot.psnr));
    text += "</tr>\n<tr>";
    for (const Shot& shot : light.shots)
        text += "<td>" +
                (shot.difference.empty()
                     ? std::string("differences: orange too bright, blue too dark, white none; "
                                   "full color at 25 % of white")
                     : html_picture(shot.difference, shot.title + " minus real")) +
                "</td>";
    return text + "</tr>\n</table>\n";
}

std::string comparison_section(const Page& page) {
    std::string text =
        "<section id=\"comparison\">\n<h2>Comparison</h2>\n<p>" + escaped_html(page.held_out_text) +
        " Errors are of luminance, over samples that are not clipped; the peak of PSNR in this "
        "table is the "
        "brightest of them, " +
        fmt::format("{:.3g}", page.peak) +
        ". The other models were fitted to each texel's luminance; their pictures have the hues of "
        "the material.</p>\n<table class=\"numbers\">\n<tr><th>model</th><th>PSNR</th><th>RMSE"
        "</th></tr>\n";
    for (const HeldOutError& e : page.errors)
        text += fmt::format(
            "<tr><td>{}</td><td class=\"n\">{:.1f} dB</td><td class=\"n\">{:.3g}</td></tr>\n",
            escaped_html(e.model), e.psnr, e.rmse);
    text += "</table>\n";
    for (const LightEntry& light : page.compared) text += light_table(light);
    return text + "</section>\n";
}

std::string render_section(const Page& page) {
    std::string text = "<section id=\"renderings\">\n<h2>Renderings</h2>\n";
    if (page.renderings.empty()) return text + "<p>None: see the notes.</p>\n</section>\n";
    text += fmt::format(
        "<p>Two directional lamps, no environment, 8 samples a pixel, on {}.</p>\n"
        "<div class=\"cards\">\n",
        escaped_html(page.device));
    for (const auto& [what, file] : page.renderings)
        text += fmt::format("<figure>{}\n<figcaption>{}</figcaption></figure>\n",
                            html_picture(file, "the material on " + what), escaped_html(what));
    return text + "</div>\n</section>\n";
}

}  // namespace

std::string page_html(const Page& page) {
    std::string text = fmt::format("<h1>{}</h1>\n<p>Made by Burnish {} with <code>{}</code>.</p>\n",
                                   escaped_html(page.request->material.filename().string()),
                                   version(), escaped_html(page.request->command));
    for (const auto& [name, value] : page.material->metadata)
        text +=
            fmt::format("<p>{}: <code>{}</code></p>\n", escaped_html(name), escaped_html(value));
    if (!page.notes.empty()) {
        text += "<ul class=\"notes\">\n";
        for (const std::string& note : page.notes) text += "<li>" + escaped_html(note) + "</li>\n";
        text += "</ul>\n";
    }
    text += stack_section(page) + exemplar_section(page) + map_section(page);
    text += comparison_section(page) + render_section(page);
    return html_page("Burnish: a capture", text);
}

}  // namespace burnish::report
