// Writes index.html and gallery.json: one file each, without scripts or external resources.
#include "papers/gallery_page.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "burnish/version.hpp"
#include "plot/html.hpp"

namespace burnish {
namespace {

std::string_view class_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::borne_out:
            return "borne_out";
        case Verdict::partly:
            return "partly";
        case Verdict::contradicted:
            return "contradicted";
        case Verdict::undecided:
            break;
    }
    return "undecided";
}

std::string badge(Verdict verdict) {
    return fmt::format("<span class=\"verdict {}\">{}</span>", class_of(verdict),
                       verdict_text(verdict));
}

std::string section(const GalleryItem& item) {
    const GalleryPage& page = item.page;
    std::string text = fmt::format(
        "<section id=\"{}\">\n<h2>{}</h2>\n<p>{}</p>\n", item.entry.id,
        escaped_html(page.figure.title),
        html_picture(item.picture, page.figure.title + ": " + std::string(item.entry.claim)));
    if (!item.vector.empty())
        text += fmt::format("<p><a href=\"{}\">as vector graphics</a></p>\n", item.vector);
    text += fmt::format("<dl>\n<dt>Claim</dt><dd>{}</dd>\n<dt>Verdict</dt><dd>{}</dd>\n",
                        escaped_html(item.entry.claim), badge(page.verdict));
    if (!page.measured.empty()) {
        text += "<dt>Measured</dt>\n";
        for (const std::string& line : page.measured)
            text += fmt::format("<dd>{}</dd>\n", escaped_html(line));
    }
    if (!page.remark.empty())
        text += fmt::format("<dt>Remark</dt><dd>{}</dd>\n", escaped_html(page.remark));
    text += "</dl>\n";
    if (!page.commands.empty()) {
        text += "<details><summary>Commands and parameters</summary>\n<pre>";
        for (const std::string& command : page.commands) text += escaped_html(command) + "\n";
        text += "</pre></details>\n";
    }
    return text + "</section>\n";
}

}  // namespace

std::string_view verdict_text(Verdict verdict) {
    switch (verdict) {
        case Verdict::borne_out:
            return "borne out";
        case Verdict::partly:
            return "partly borne out";
        case Verdict::contradicted:
            return "contradicted";
        case Verdict::undecided:
            break;
    }
    return "undecided, too noisy to say";
}

std::string gallery_html(std::span<const GalleryItem> items, const std::string& device,
                         const std::string& command) {
    std::string text =
        "<h1>The papers, figure by figure</h1>\n"
        "<p>K11: Kang &amp; Cho, Plausible and Realtime Rendering of Scratched Metal by Deforming "
        "MDF of "
        "Normal Mapped Anisotropic Surface. K12: Kang &amp; Cho, Rendering Details on Anisotropic "
        "Surfaces with Approximate MDF Rotation. B12: Bell &amp; Teo, slides on Wang et al. 2008. "
        "<em>Claim</em> is what the caption or the text beside it says, <em>verdict</em> what the "
        "measured figures say of it.</p>\n";
    text += fmt::format("<p>Made by Burnish {} with <code>{}</code> on {}.</p>\n", version(),
                        escaped_html(command), escaped_html(device));
    text += "<nav><ul>\n";
    for (const GalleryItem& item : items)
        text += fmt::format("<li><a href=\"#{0}\">{0}</a> {1}</li>\n", item.entry.id,
                            badge(item.page.verdict));
    text += "</ul></nav>\n";
    for (const GalleryItem& item : items) text += section(item);
    return html_page("Burnish: the papers, figure by figure", text);
}

std::string gallery_json(std::span<const GalleryItem> items, const std::string& device,
                         const std::string& command) {
    nlohmann::ordered_json json = {{"format", "burnish-gallery"},
                                   {"version", version()},
                                   {"command", command},
                                   {"device", device}};
    json["figures"] = nlohmann::ordered_json::array();
    for (const GalleryItem& item : items) {
        json["figures"].push_back({{"id", item.entry.id},
                                   {"title", item.page.figure.title},
                                   {"claim", item.entry.claim},
                                   {"verdict", verdict_text(item.page.verdict)},
                                   {"measured", item.page.measured},
                                   {"remark", item.page.remark},
                                   {"commands", item.page.commands},
                                   {"picture", item.picture}});
    }
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace burnish
