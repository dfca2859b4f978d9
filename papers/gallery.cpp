#include "papers/gallery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "burnish/error.hpp"
#include "burnish/version.hpp"
#include "core/files.hpp"
#include "core/memory.hpp"
#include "core/text.hpp"
#include "papers/gallery_figures.hpp"

namespace burnish {
namespace {

constexpr GalleryFigure kFigures[] = {
    {{"k11-fig1", "K11 Fig 1", "scratched metal can be rendered in real time"}, k11_fig1},
    {{"k11-fig2", "K11 Fig 2",
      "the anisotropic distribution scatters light differently along x and y"},
     k11_fig2},
    {{"k11-fig3", "K11 Fig 3", "e_x and e_y control the anisotropy of the reflectance"}, k11_fig3},
    {{"k11-fig4", "K11 Fig 4", "scratch maps and what they are expected to look like"}, k11_fig4},
    {{"k11-fig5", "K11 Fig 5",
      "under a normal map the anisotropic reflectance is not preserved: it turns isotropic and "
      "distorted"},
     k11_fig5},
    {{"k11-fig6", "K11 Fig 6",
      "Eq 2 gives reasonable lobes for an isotropic distribution and fails for an anisotropic one"},
     k11_fig6},
    {{"k11-fig7", "K11 Fig 7",
      "the deformation takes C to C'; linear interpolation bends the lobe too much at the moved "
      "centre"},
     k11_fig7},
    {{"k11-fig8", "K11 Fig 8", "the smooth interpolation looks more natural than the linear one"},
     k11_fig8},
    {{"k11-fig9", "K11 Fig 9",
      "the deformed distribution keeps the anisotropic reflectance on each bump, without weird "
      "shapes"},
     k11_fig9},
    {{"k11-fig10", "K11 Fig 10",
      "scratch maps are made of pits, seamless, stretched in any direction or in a range of "
      "directions"},
     k11_fig10},
    {{"k11-fig11", "K11 Fig 11", "deforming costs only slightly more than normal mapping"},
     k11_fig11},
    {{"k11-fig12", "K11 Fig 12",
      "only with the deformation do scratches scatter light along the rim of the highlight"},
     k11_fig12},
    {{"k11-fig13", "K11 Fig 13",
      "Ashikhmin-Shirley: deformation reproduces the scattering by scratches, with and without "
      "environment"},
     k11_fig13},
    {{"k11-fig14", "K11 Fig 14",
      "Ward: without environment a normal map is hardly seen; deformation makes scratches visible"},
     k11_fig14},
    {{"k11-fig15", "K11 Fig 15", "close up, the deformation is superior on both models"},
     k11_fig15},
    {{"k12-fig1", "K12 Fig 1", "rotation shows geometric detail more clearly than normal mapping"},
     k12_fig1},
    {{"k12-fig2", "K12 Fig 2", "Eq 2 fails for the anisotropic Ashikhmin-Shirley distribution"},
     k12_fig2},
    {{"k12-fig3", "K12 Fig 3", "Ward's distribution hardly changes under a perturbed normal"},
     k12_fig3},
    {{"k12-fig4", "K12 Fig 4",
      "the rotation takes the distribution to the frame of the perturbed normal"},
     k12_fig4},
    {{"k12-fig5", "K12 Fig 5", "rotated, both distributions keep their anisotropy about the cross"},
     k12_fig5},
    {{"k12-fig6", "K12 Fig 6", "rotation preserves the anisotropic reflectance on each bump"},
     k12_fig6},
    {{"k12-fig7", "K12 Fig 7",
      "the accurate rotation takes 54 microseconds, the approximate one 11"},
     k12_fig7},
    {{"k12-fig8", "K12 Fig 8",
      "the approximate rotation looks almost the same as the accurate one"},
     k12_fig8},
    {{"k12-fig9", "K12 Fig 9",
      "on metallic surfaces rotation expresses the detail of the normal map"},
     k12_fig9},
    {{"k12-fig10", "K12 Fig 10",
      "(a) the weave is hidden where both yarns reflect alike, (b) visible but metallic, (c) "
      "cloth-like"},
     k12_fig10},
    {{"k12-table1", "K12 Table I", "rotation costs 1.56, a normal map 1.55 of Gouraud shading"},
     k12_table1},
    {{"b12-models", "B12, slide of models",
      "Phong, Ward, Lafortune, Cook-Torrance and He differ where they are matched in width"},
     b12_models},
    {{"b12-measured", "B12, measured materials",
      "microfacet models fit measured materials better than Phong and Ward (Ngan et al. 2005)"},
     b12_measured},
};

std::vector<const GalleryFigure*> chosen(const std::vector<std::string>& ids) {
    std::vector<std::string_view> names;
    for (const GalleryFigure& figure : kFigures) names.push_back(figure.entry.id);
    std::vector<bool> wanted(names.size(), ids.empty());
    for (const std::string& id : ids)
        wanted[static_cast<std::size_t>(index_of_name(names, id, "figure", "gallery"))] = true;
    std::vector<const GalleryFigure*> list;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (wanted[i]) list.push_back(&kFigures[i]);
    return list;
}

Progress part_of(const Progress& whole, std::string_view id, std::size_t index, std::size_t count) {
    return whole.with_report([&whole, id, index, count](std::string_view, double done) {
        whole.step(
            id, (static_cast<double>(index) + std::min(done, 0.99)) / static_cast<double>(count));
    });
}

GalleryItem write_item(const GalleryRequest& request, const GalleryEntry& entry, GalleryPage page,
                       std::vector<std::filesystem::path>& written) {
    page.figure.caption = fmt::format("{}Claim: {}. Verdict: {}.", page.figure.caption, entry.claim,
                                      verdict_text(page.verdict));
    GalleryItem item{entry, std::move(page), std::string(entry.id) + ".png", ""};
    std::string commands;
    for (const std::string& command : item.page.commands)
        commands += (commands.empty() ? "" : "; ") + command;
    const plot::Metadata metadata = {{"burnish:version", std::string(version())},
                                     {"burnish:command", request.command},
                                     {"burnish:panels", commands},
                                     {"burnish:figure", std::string(entry.id)}};
    written.push_back(request.output / item.picture);
    plot::write_figure(item.page.figure, written.back(), metadata);
    if (item.page.drawn) {
        item.vector = std::string(entry.id) + ".svg";
        written.push_back(request.output / item.vector);
        plot::write_figure(item.page.figure, written.back(), metadata);
    }
    return item;
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed || !std::filesystem::is_directory(folder))
        throw Error(folder.string(), "", "a folder that can be made",
                    failed ? failed.message() : "a file");
    require_writable(folder / "index.html");
}

}  // namespace

std::span<const GalleryFigure> gallery_figures() {
    return kFigures;
}

std::span<const GalleryEntry> gallery_entries() {
    static const std::vector<GalleryEntry> list = [] {
        std::vector<GalleryEntry> entries;
        for (const GalleryFigure& figure : kFigures) entries.push_back(figure.entry);
        return entries;
    }();
    return list;
}

GalleryReport make_gallery(const GalleryRequest& request, const Progress& progress) {
    const std::vector<const GalleryFigure*> figures = chosen(request.ids);
    make_folder(request.output);
    GalleryReport report;
    keep_freed_memory();  // the cost figures time frames, which must not include page faults
    GalleryStudio studio(request.quick, request.gl_device);
    report.device = studio.context().renderer();
    std::optional<FrameCost> cost;
    std::vector<GalleryItem> items;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const GalleryEntry& entry = figures[i]->entry;
        GalleryTools tools{studio, request, part_of(progress, entry.id, i, figures.size()),
                           report.warnings, cost};
        tools.progress.step("", 0);
        std::optional<GalleryPage> page = figures[i]->make(tools);
        if (page) items.push_back(write_item(request, entry, std::move(*page), report.written));
    }
    const std::filesystem::path json = request.output / "gallery.json";
    const std::filesystem::path html = request.output / "index.html";
    write_text_file(json, gallery_json(items, report.device, request.command));
    write_text_file(html, gallery_html(items, report.device, request.command));
    report.written.insert(report.written.end(), {json, html});
    progress.step("gallery", 1);
    return report;
}

}  // namespace burnish
