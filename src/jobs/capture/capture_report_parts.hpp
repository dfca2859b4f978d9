// The parts of a capture's page. Private to capture_report*.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "burnish/coverage.hpp"
#include "burnish/lobe_fit.hpp"
#include "burnish/plot/figure.hpp"
#include "burnish/tabulated_material.hpp"
#include "capture/judge/held_out.hpp"
#include "capture/stack/image_stack.hpp"
#include "jobs/capture/capture_report.hpp"

namespace burnish::report {

// A picture file of the folder, in display values.
struct Picture {
    std::string name;
    Image image;
};
using Pictures = std::vector<Picture>;

struct ExemplarEntry {
    int index = 0;
    double share = 0.0;  // of the texels that have an exemplar
    LobeFit lobe;        // the nearest GGX
    // Of the hemisphere's solid angle: extrapolated, completed, measured, as NdfOrigin.
    std::array<double, 3> known{};
    plot::Rgb color;  // in the map of exemplars
    std::string picture;
};

struct MapEntry {
    std::string title, text, picture;
};

// A photographed or predicted picture of a light; a photograph has no `psnr` and `difference`.
struct Shot {
    std::string title, picture, difference;
    double psnr = 0.0;
};

struct LightEntry {
    std::size_t light = 0;
    std::string rank, source;  // "brightest"; the file of its first picture
    double elevation = 0.0, azimuth = 0.0;
    double white = 0.0;  // radiance that is shown as white
    std::vector<Shot> shots;
};

struct Page {
    const CaptureReportRequest* request = nullptr;
    const TabulatedMaterial* material = nullptr;
    StackCensus census;
    std::size_t lights = 0;
    std::string rig_text;  // of describe_rig
    std::string coverage;  // picture
    RigCoverage rig_coverage;
    std::vector<ExemplarEntry> exemplars;  // most used first
    std::vector<MapEntry> maps;
    std::string held_out_text;  // which lights judge, and whether the fit used them
    std::vector<HeldOutError> errors;
    double peak = 0.0;  // of the judging lights: the reference of PSNR
    std::vector<LightEntry> compared;
    std::vector<std::pair<std::string, std::string>> renderings;  // title, picture
    std::string device;
    std::vector<std::string> notes;  // missing parts, and warnings
};

// ---- capture_report_pictures.cpp

// Enlarges a small picture by an integer factor and averages a large one; linear or display values.
Image at_viewing_size(const Image& image);

Picture coverage_picture(const RigCoverage& coverage, const std::vector<std::uint8_t>& keep);
// The used exemplars, most used first; at most kMostExemplars of them get pictures.
inline constexpr std::size_t kMostExemplars = 16;
void add_exemplars(const TabulatedMaterial& m, const std::vector<LobeFit>& lobes, Page& page,
                   Pictures& pictures);
void add_maps(const TabulatedMaterial& m, const std::vector<LobeFit>& lobes, Page& page,
              Pictures& pictures);

// ---- capture_report_compare.cpp

// Lights with keep 0 judge the fit: three of them in pictures, all of them in numbers.
void add_comparison(const ImageStack& stack, const Rig& rig, const TabulatedMaterial& m,
                    const std::vector<std::uint8_t>& keep, Page& page, Pictures& pictures,
                    const Progress& progress);

// ---- capture_report_render.cpp

void add_renderings(const CaptureReportRequest& request, Page& page, Pictures& pictures,
                    const Progress& progress);

// ---- capture_report_page.cpp

std::string page_html(const Page& page);

}  // namespace burnish::report
