// SVG files: well-formed, with labels as text, metadata, and no harm from what was typed.
#include <gtest/gtest.h>

#include <algorithm>

#include "burnish/plot/brdf_plot.hpp"
#include "burnish/plot/figure.hpp"
#include "burnish/plot/mdf_plot.hpp"
#include "xml_check.hpp"

namespace burnish::plot {
namespace {

using test::parse_xml;
using test::XmlElement;

Figure two_methods() {
    MdfSubject a;
    a.n = tilted_normal(30, 40);
    MdfSubject b = a;
    b.method = Method::deform_smooth;
    const MdfSubject both[] = {a, b};
    const ColorBar bar = disk_bar(both, ScaleKind::linear);
    Figure figure;
    figure.title = "e_{x} = 200 & <more>";
    figure.rows = {{"row label",
                    {disk_panel(a, bar.scale, "none"), disk_panel(b, bar.scale, "deform-smooth")},
                    bar}};
    figure.caption = "a caption";
    figure.legend = {{"legend entry", series_color(0)}};
    return figure;
}

std::string texts_of(const std::vector<XmlElement>& elements) {
    std::string all;
    for (const XmlElement& e : elements)
        if (e.name == "text") all += e.text + "\n";
    return all;
}

const XmlElement* find(const std::vector<XmlElement>& elements, const std::string& name) {
    const auto found = std::find_if(elements.begin(), elements.end(),
                                    [&](const XmlElement& e) { return e.name == name; });
    return found == elements.end() ? nullptr : &*found;
}

TEST(Svg, IsXmlAndHoldsTheLabelsAsText) {
    const auto elements =
        parse_xml(figure_svg(two_methods(), {{"burnish:command", "burnish mdf"}}));
    const std::string texts = texts_of(elements);
    for (const char* label : {"none", "deform-smooth", "row label", "a caption", "legend entry",
                              "& <more>", "hx", "hy", "linear", "D [1/sr] (K11 Eq 1)"})
        EXPECT_NE(texts.find(label), std::string::npos) << label;
    const XmlElement* root = find(elements, "svg");
    ASSERT_TRUE(root);
    EXPECT_EQ(root->attributes.at("xmlns"), "http://www.w3.org/2000/svg");
    EXPECT_EQ(find(elements, "title")->text, "e_x = 200 & <more>");
    EXPECT_EQ(find(elements, "desc")->text, "a caption");
    EXPECT_EQ(find(elements, "burnish:command")->text, "burnish mdf");
    EXPECT_TRUE(find(elements, "image"));
}

TEST(Svg, SurvivesWhatWasTyped) {
    Figure figure = two_methods();
    figure.title = std::string("bad \xFF\xC0\x80 bytes \xED\xA0\x80 \x01 ]]> <!-- _{ ^{");
    const std::string hostile = "burnish '\xF5' \"<&>\" \n\t \x7F --> \xEF\xBF\xBF";
    const auto elements = parse_xml(
        figure_svg(figure, {{"burnish:command", hostile}, {"a b<", "c"}, {"burnish:1 x", "d"}}));
    EXPECT_NE(find(elements, "burnish:command")->text.find("\"<&>\""), std::string::npos);
    int entries = 0;
    for (const XmlElement& e : elements) entries += e.name == "burnish:entry" ? 1 : 0;
    EXPECT_EQ(entries, 2);
    // The same in a picture: nothing but not to fail.
    EXPECT_GT(draw_figure(figure, 1).image.width, 0);
}

TEST(Svg, EveryKindOfPanelIsXml) {
    MdfSubject s;
    s.method = Method::deform_linear;
    s.n = tilted_normal(30, 40);
    const BrdfModel& model = brdf_models().front();
    const BrdfSubject brdf{&model, {200, 10, 1}, "ashikhmin-shirley"};
    const std::vector<BrdfSubject> brdfs = {brdf};
    const MdfSubject subjects[] = {s};
    const std::string labels[] = {"deform-linear"};
    const Scale scale = scale_to(ScaleKind::log, 7.5);
    Figure figure;
    figure.rows.push_back({"", grid_panels(s, scale, {-0.25, 0.45})});
    figure.rows.push_back({"",
                           {profile_panel(subjects, labels, ProfileLine::along_x, scale, "p"),
                            polar_panel({brdfs, 45, 0, {}, ScaleKind::log, {}}, "polar"),
                            surface_panel(brdf, 45, 0, ScaleKind::linear, {}, "surface"),
                            albedo_panel(brdfs, 0, "albedo"),
                            bar_panel({{{.label = "bar", .value = 3}}, "ms"}, "bars")}});
    const std::string texts = texts_of(parse_xml(figure_svg(figure, {})));
    for (const char* label : {"original D", "C\u2032", "p\u2032", "R", "light", "surface", "albedo",
                              "angle of incidence", "f [1/sr], log", "60\u00b0", "bar"})
        EXPECT_NE(texts.find(label), std::string::npos) << label;
}

}  // namespace
}  // namespace burnish::plot
