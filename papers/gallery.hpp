// burnish gallery: the figures of K11 and K12 and the models of B12's slide, made again, each with
// the command and parameters it is made with, what its caption claims and what was measured about
// it.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/progress.hpp"

namespace burnish {

// One figure that can be made. Ids are those of the papers: k11-fig1, k12-table1, b12-models ...
struct GalleryEntry {
    std::string_view id;
    std::string_view title;  // where in the paper, and what is shown
    std::string_view claim;  // of the caption or the text beside it, in our words
};

// In the order of the papers.
std::span<const GalleryEntry> gallery_entries();

struct GalleryRequest {
    std::vector<std::string> ids;  // none: all of them
    std::filesystem::path output;  // a folder, made when it is not there
    bool quick = false;            // small pictures with few samples, few rounds of timing
    int gl_device = -1;            // -1: the first hardware device, else software
    // Folder of measured materials (.bsdf) for b12-measured; empty: that figure is left out with a
    // warning.
    std::filesystem::path measured;
    std::string command;  // for metadata
};

struct GalleryReport {
    std::vector<std::filesystem::path> written;  // index.html last
    std::vector<std::string> warnings;
    std::string device;  // GL_RENDERER
};

// Writes ID.png (and ID.svg, where a figure is all plot), gallery.json with everything measured,
// and index.html, which shows them all and opens from disk. A figure is written when it is done;
// files of figures that were not asked for are left alone and not listed. Throws UsageError for
// unknown ids, Error for what cannot be written.
GalleryReport make_gallery(const GalleryRequest& request, const Progress& progress = {});

}  // namespace burnish
