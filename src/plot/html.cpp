#include "plot/html.hpp"

#include <fmt/format.h>

namespace burnish {
namespace {

// Classes: .verdict and its four colors, .numbers (a table of names and numbers), .cards (figures
// in a grid), .shots (a table of pictures of one size), .swatch (a color before a word), .notes.
constexpr std::string_view kStyle = R"(
body { font: 16px/1.5 system-ui, sans-serif; max-width: 80rem; margin: 2rem auto; padding: 0 1rem; color: #1c1c1c; background: #fff; }
h1, h2, h3 { line-height: 1.2; }
section { border-top: 1px solid #ccc; padding: 1rem 0 2rem; }
img { max-width: 100%; height: auto; }
dt { font-weight: 600; margin-top: .5rem; }
dd { margin: 0; }
pre { background: #f4f4f2; padding: .75rem; overflow-x: auto; font-size: .85rem; white-space: pre-wrap; }
table { border-collapse: collapse; }
figure { margin: 0; }
figcaption { font-size: .9rem; }
nav ul { columns: 3; padding-left: 1.2rem; }
@media (max-width: 45rem) { nav ul { columns: 1; } }
.verdict { display: inline-block; padding: 0 .5rem; border-radius: .25rem; }
.borne_out { background: #d7ecd9; } .partly { background: #fbeec4; } .contradicted { background: #f6d4cf; }
.undecided { background: #e4e4e4; }
.numbers th, .numbers td { padding: .2rem .9rem .2rem 0; text-align: left; border-bottom: 1px solid #ddd; }
.numbers td.n { text-align: right; font-variant-numeric: tabular-nums; }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(24rem, 1fr)); gap: 1.5rem; }
.swatch { display: inline-block; width: .9em; height: .9em; border-radius: .2em; vertical-align: -.08em; margin-right: .4em; }
.shots { width: 100%; table-layout: fixed; margin-bottom: 2rem; }
.shots th, .shots td { padding: .2rem; text-align: center; vertical-align: top; font-weight: 400; }
.shots th { font-weight: 600; }
.shots img { width: 100%; image-rendering: pixelated; }
.notes { background: #fbf3d9; padding: .5rem 1rem .5rem 2rem; }
)";

}  // namespace

std::string escaped_html(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string html_page(std::string_view title, std::string_view body) {
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
        escaped_html(title), kStyle, body);
}

std::string html_picture(std::string_view file, std::string_view alt, int width_px) {
    const std::string width = width_px > 0 ? fmt::format(" width=\"{}\"", width_px) : "";
    return fmt::format("<a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\"{2} loading=\"lazy\"></a>",
                       escaped_html(file), escaped_html(alt), width);
}

}  // namespace burnish
