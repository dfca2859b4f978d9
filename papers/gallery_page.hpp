// What a figure of the gallery consists of, and the page that shows them. Private to app/gallery*.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "burnish/plot/figure.hpp"
#include "papers/gallery.hpp"

namespace burnish {

// undecided: the figures measured here are too noisy to say.
enum class Verdict { borne_out, partly, contradicted, undecided };
std::string_view verdict_text(Verdict verdict);

// A figure as it was made.
struct GalleryPage {
    plot::Figure figure;                // layout of the original
    std::vector<std::string> commands;  // that make its panels one by one
    std::vector<std::string> measured;  // sentences with figures
    Verdict verdict = Verdict::borne_out;
    std::string remark;  // where the paper is wrong or vague, or what differs here; may be empty
    bool drawn = false;  // all of it is plot: an SVG is worth having
};

// A page with the files that hold it, relative to the folder.
struct GalleryItem {
    GalleryEntry entry;
    GalleryPage page;
    std::string picture;
    std::string vector;  // empty: none
};

std::string gallery_html(std::span<const GalleryItem> items, const std::string& device,
                         const std::string& command);
std::string gallery_json(std::span<const GalleryItem> items, const std::string& device,
                         const std::string& command);

}  // namespace burnish
