// The contents of a gallery figure, and the page of all figures. Private to papers/gallery*.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "burnish/plot/figure.hpp"
#include "papers/gallery.hpp"

namespace burnish {

// undecided: the measurements are too noisy.
enum class Verdict { borne_out, partly, contradicted, undecided };
std::string_view verdict_text(Verdict verdict);

// A finished figure.
struct GalleryPage {
    plot::Figure figure;                // layout of the original
    std::vector<std::string> commands;  // one for each panel
    std::vector<std::string> measured;  // sentences with figures
    Verdict verdict = Verdict::borne_out;
    std::string remark;  // an error of the paper or a difference of this figure; may be empty
    bool drawn = false;  // consists of plots only: an SVG is written
};

// A page with its files, relative to the folder.
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
