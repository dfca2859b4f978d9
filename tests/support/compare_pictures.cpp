// Prints the largest difference, in 1/255, of the pictures with the same names in two folders.
// Usage: compare_pictures FOLDER FOLDER [BOUND]. Exits with 1 if a difference is larger than BOUND
// (1) or a picture is missing.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <vector>

#include "burnish/image_io.hpp"

namespace {

namespace fs = std::filesystem;

double difference(const fs::path& a, const fs::path& b) {
    const burnish::Image one = burnish::read_image(a, {.as_data = true});
    const burnish::Image other = burnish::read_image(b, {.as_data = true});
    if (one.width != other.width || one.height != other.height || one.channels != other.channels)
        return HUGE_VAL;
    double most = 0.0;
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
        most = std::max(most, std::abs(static_cast<double>(one.pixels[i]) -
                                       static_cast<double>(other.pixels[i])));
    return 255.0 * most;
}

int compare(const fs::path& first, const fs::path& second, double bound) {
    std::vector<fs::path> names;
    for (const auto& entry : fs::directory_iterator(first))
        if (entry.path().extension() == ".png") names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    int wrong = 0;
    double most = 0.0;
    for (const fs::path& name : names) {
        const double d =
            fs::exists(second / name) ? difference(first / name, second / name) : HUGE_VAL;
        most = std::max(most, d);
        if (d <= bound) continue;
        ++wrong;
        std::printf("%s: %g\n", name.c_str(), d);
    }
    std::printf("%zu pictures, %d differ by more than %g/255; most: %g/255\n", names.size(), wrong,
                bound, most);
    return wrong > 0 || names.empty() ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr, "usage: compare_pictures FOLDER FOLDER [BOUND]\n");
        return 2;
    }
    try {
        return compare(argv[1], argv[2], argc > 3 ? std::atof(argv[3]) : 1.0);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "compare_pictures: %s\n", error.what());
        return 1;
    }
}
