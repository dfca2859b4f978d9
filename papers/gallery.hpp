// burnish gallery: reproduces the figures of K11 and K12 and the models of B12's slide. Each figure
// comes with its command and parameters, the claim of its caption and the measurements that test
// the claim.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/progress.hpp"

namespace burnish {

// A figure that the gallery can make. Ids are those of the papers: k11-fig1, k12-table1, b12-models
// ...
struct GalleryEntry {
    std::string_view id;
    std::string_view title;  // its number in the paper and its subject
    std::string_view claim;  // of the caption or the text beside it, paraphrased
};

// In the order of the papers.
std::span<const GalleryEntry> gallery_entries();

struct GalleryRequest {
    std::vector<std::string> ids;  // none: all of them
    std::filesystem::path output;  // a folder, created if it is missing
    bool quick = false;            // small pictures with few samples, few rounds of timing
    int gl_device = -1;            // -1: the first hardware device, else software
    // Folder of measured materials (.bsdf) for b12-measured; empty: that figure is omitted with a
    // warning.
    std::filesystem::path measured;
    std::string command;  // for metadata
};

struct GalleryReport {
    std::vector<std::filesystem::path> written;  // index.html last
    std::vector<std::string> warnings;
    std::string device;  // GL_RENDERER
};

// Writes ID.png (and ID.svg if a figure consists of plots only), gallery.json with all
// measurements, and index.html, which shows all figures and opens from disk. Each figure is written
// as soon as it is done. Files of other figures stay unchanged and are not listed. Throws
// UsageError for unknown ids, Error for files that cannot be written.
GalleryReport make_gallery(const GalleryRequest& request, const Progress& progress = {});

}  // namespace burnish
