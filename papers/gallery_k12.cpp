// Surfaces of K12: Fig 1, 6, 8, 9, 10.
#include <fmt/format.h>

#include <algorithm>

#include "burnish/plot/panels.hpp"
#include "papers/gallery_figures.hpp"
#include "papers/gallery_measures.hpp"
#include "plot/sheet.hpp"

namespace burnish {
namespace {

constexpr double kPanelSide = 260;

// (a, b) normal mapping and (c, d) rotation, on Ward's and on Ashikhmin and Shirley's surface.
GalleryPage two_by_two(GalleryTools& tools, const PictureSpec& scene, const std::string& title) {
    GalleryPage page;
    page.figure.title = title;
    plot::PanelRow simple{"normal mapping", {}, {}}, improved{"MDF rotation", {}, {}};
    for (const bool is_ward : {true, false}) {
        const PictureSpec spec = scene.with(is_ward ? ward_surface() : shirley_surface());
        const Image mask = tools.studio.mask(spec, kPanelSide, tools.progress);
        const MethodShots shot{tools, spec, kPanelSide};
        const Picture mapped = shot("normal-map"), turned = shot("rotate-approx"),
                      truth = shot("follow-grain");
        const char* name = is_ward ? "Ward" : "Ashikhmin-Shirley";
        simple.panels.push_back(
            rendered(page, mapped, fmt::format("({}) {}", is_ward ? 'a' : 'b', name), kPanelSide));
        improved.panels.push_back(
            rendered(page, turned, fmt::format("({}) {}", is_ward ? 'c' : 'd', name), kPanelSide));
        const double a = correlation(mapped.linear, truth.linear, mask);
        const double c = correlation(turned.linear, truth.linear, mask);
        page.measured.push_back(
            fmt::format("{}: correlation with the lobe that follows the grain {:.2f} "
                        "under normal-map, {:.2f} under rotate-approx",
                        name, a, c));
        if (!(c > 0.9 && c > a + 0.05)) page.verdict = Verdict::partly;
    }
    page.figure.rows = {simple, improved};
    return page;
}

}  // namespace

std::optional<GalleryPage> k12_fig1(GalleryTools& tools) {
    const PictureSpec scene{"builtin:torus",
                            {{"normal_map", "builtin:bumps"}, {"uv_scale", "2"}},
                            "builtin:studio",
                            {}};
    return two_by_two(tools, scene, "K12 Fig 1: improved normal mapping");
}

std::optional<GalleryPage> k12_fig6(GalleryTools& tools) {
    const PictureSpec scene{
        "builtin:sphere", {{"normal_map", "builtin:bumps"}}, "builtin:studio", {}};
    return two_by_two(tools, scene, "K12 Fig 6: illusory bumps");
}

std::optional<GalleryPage> k12_fig9(GalleryTools& tools) {
    const PictureSpec scene{"builtin:drape",
                            {{"normal_map", "builtin:bumps"}, {"uv_scale", "3"}},
                            "builtin:studio",
                            {}};
    return two_by_two(tools, scene, "K12 Fig 9: metallic surfaces");
}

std::optional<GalleryPage> k12_fig8(GalleryTools& tools) {
    GalleryPage page;
    page.figure.title = "K12 Fig 8: accurate and approximate rotation";
    for (const bool is_ward : {false, true}) {
        const PictureSpec spec = PictureSpec{
            "builtin:sphere",
            {{"normal_map", "builtin:bumps"}},
            "builtin:studio",
            {}}.with(is_ward ? ward_surface() : shirley_surface());
        const Image mask = tools.studio.mask(spec, kPanelSide, tools.progress);
        const Picture exact =
            tools.studio.picture(spec.with("method", "rotate-exact"), kPanelSide, tools.progress);
        const Picture approx =
            tools.studio.picture(spec.with("method", "rotate-approx"), kPanelSide, tools.progress);
        const float gain = difference_gain(exact.display, {approx.display});
        plot::PanelRow row{is_ward ? "Ward" : "Ashikhmin-Shirley", {}, {}};
        row.panels = {rendered(page, exact, is_ward ? "" : "(a) accurate", kPanelSide),
                      rendered(page, approx, is_ward ? "" : "(b) approximate", kPanelSide),
                      plot::picture_panel(difference_image(exact.display, approx.display, gain),
                                          fmt::format("difference x{:g}", gain), kPanelSide)};
        page.figure.rows.push_back(std::move(row));
        const double rms = rmse(approx.display, exact.display);
        page.measured.push_back(
            fmt::format("{}: rms difference {:.4f} of the display range, {:.2f} of the radiance",
                        is_ward ? "Ward" : "Ashikhmin-Shirley", rms,
                        relative_difference(approx.linear, exact.linear, mask)));
        // One step of an 8-bit picture is 0.004.
        if (!is_ward && rms > 0.004) page.verdict = Verdict::contradicted;
        if (is_ward && rms > 0.02) page.verdict = Verdict::partly;
    }
    page.remark =
        "With the corrected signs the approximate matrix is diag(s, s, 1) times the exact one: for "
        "Ashikhmin and Shirley's lobe, which asks only for the azimuth and the height of h, they "
        "are "
        "the same; Ward's lobe is widened by 1/s.";
    return page;
}

std::optional<GalleryPage> k12_fig10(GalleryTools& tools) {
    // Yarns of one color without diffuse light: only the lobe shows the weave.
    const PictureSpec cloth = PictureSpec{
        "builtin:drape",
        {{"weave", "plain"},
         {"weave_yarns", "40"},
         {"weave_twist", "0"},
         {"weave_fuzz", "0"},
         {"metallic", "1"}},
        "builtin:studio",
        {}}.with(shirley_surface());
    const double side = 1.4 * kPanelSide;
    const Image mask = tools.studio.mask(cloth, side, tools.progress);
    const Picture flat = tools.studio.picture(
        cloth.with({{"weave_crimp", "0"}, {"weave_bulge", "0"}}), side, tools.progress);
    const MethodShots shot{tools, cloth, side};
    const Picture mapped = shot("normal-map"), turned = shot("rotate-approx");
    GalleryPage page;
    page.figure.title = "K12 Fig 10: woven fabric";
    page.figure.rows = {{"",
                         {rendered(page, flat, "(a) e_x and e_y swapped by the yarn", side),
                          rendered(page, mapped, "(b) and normals of the yarns", side),
                          rendered(page, turned, "(c) and the distribution rotated", side)},
                         {}}};
    // The window is about two yarns wide.
    const int window = mask.width / 26;
    const double hidden[] = {flat_share(flat.linear, mask, window),
                             flat_share(mapped.linear, mask, window),
                             flat_share(turned.linear, mask, window)};
    const double peaks[] = {concentration(flat.linear, mask), concentration(mapped.linear, mask),
                            concentration(turned.linear, mask)};
    page.measured = {
        fmt::format(
            "the weave is hidden on {:.0f} % of the cloth in (a), {:.0f} % in (b), {:.0f} % "
            "in (c): squares of two yarns that vary by less than 25 %",
            100 * hidden[0], 100 * hidden[1], 100 * hidden[2]),
        fmt::format(
            "brightest hundredth over the mean: {:.1f} in (a), {:.1f} in (b), {:.1f} in (c)",
            peaks[0], peaks[1], peaks[2])};
    if (!(hidden[0] > 4 * hidden[1] && hidden[0] > 4 * hidden[2]))
        page.verdict = Verdict::contradicted;
    else if (!(peaks[2] < 0.95 * peaks[1]))
        page.verdict = Verdict::partly;
    return page;
}

}  // namespace burnish
