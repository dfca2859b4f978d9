// `make bench`: measures the budgets and writes them beside what was reached.
// Usage: burnish_bench OUT.md
#include <cstdio>
#include <exception>
#include <fstream>

#include "report.hpp"

int main(int argc, char** argv) {
    try {
        burnish::bench::Report report;
        burnish::bench::measure_frames(report);
        burnish::bench::measure_image_light(report);
        burnish::bench::measure_loading(report);
        burnish::bench::measure_first_picture(report);
        burnish::bench::measure_scratches(report);
        burnish::bench::measure_distributions(report);
        const std::string text = to_markdown(report);
        std::fputs(text.c_str(), stdout);
        if (argc > 1) std::ofstream(argv[1]) << text;
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "burnish_bench: %s\n", error.what());
        return 1;
    }
}
