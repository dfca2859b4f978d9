// `make bench`: measures the costs that have budgets and writes both side by side.
// Usage: burnish_bench OUT.md [PART...], with the parts frames, area-lights, cloth, layers, edits, image-light, loading,
// first-picture, scratches, weaves, distributions, capture, visibility and traces.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "core/memory.hpp"
#include "report.hpp"

namespace {

using burnish::bench::Report;

constexpr std::pair<const char*, void (*)(Report&)> kParts[] = {
    {"frames", burnish::bench::measure_frames},
    {"area-lights", burnish::bench::measure_area_lights},
    {"cloth", burnish::bench::measure_cloth},
    {"layers", burnish::bench::measure_layers},
    {"edits", burnish::bench::measure_edits},
    {"image-light", burnish::bench::measure_image_light},
    {"loading", burnish::bench::measure_loading},
    {"first-picture", burnish::bench::measure_first_picture},
    {"scratches", burnish::bench::measure_scratches},
    {"weaves", burnish::bench::measure_weaves},
    {"distributions", burnish::bench::measure_distributions},
    {"capture", burnish::bench::measure_capture},
    {"visibility", burnish::bench::measure_visibility},
    {"traces", burnish::bench::measure_traces},
};

}  // namespace

int main(int argc, char** argv) {
    burnish::keep_freed_memory();
    if (argc > 1 && argv[1][0] == '-') {  // an option, not a file
        std::fprintf(stderr, "usage: burnish_bench [OUT.md [PART...]], parts:");
        for (const auto& part : kParts) std::fprintf(stderr, " %s", part.first);
        std::fprintf(stderr, "\n");
        return 2;
    }
    try {
        const std::vector<std::string> chosen(argv + std::min(argc, 2), argv + argc);
        Report report;
        for (const auto& [name, measure] : kParts) {
            if (chosen.empty() || std::find(chosen.begin(), chosen.end(), name) != chosen.end()) {
                measure(report);
            }
        }
        const std::string text = to_markdown(report);
        std::fputs(text.c_str(), stdout);
        if (argc > 1) std::ofstream(argv[1]) << text;
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "burnish_bench: %s\n", error.what());
        return 1;
    }
}
