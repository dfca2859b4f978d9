// Prints the largest difference, in 1/255, of the pictures with the same names in two folders, and
// the mean FLIP of those that differ by more than BOUND (1).
// Usage: compare_pictures FOLDER FOLDER [BOUND]. Exits with 1 if a difference is larger than BOUND
// or a picture is missing.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <vector>

#include "burnish/compare.hpp"
#include "burnish/image_io.hpp"

namespace {

namespace fs = std::filesystem;

struct Difference {
    double most = HUGE_VAL;  // in 1/255; infinite where the pictures cannot be compared
    double flip = 0.0;       // mean over the pixels
};

// FLIP takes RGB or RGBA. Gray stands for three equal channels.
burnish::Image in_color(const burnish::Image& image) {
    if (image.channels != 1) return image;
    burnish::Image color(image.width, image.height, 3);
    for (std::size_t i = 0; i < color.pixels.size(); ++i) color.pixels[i] = image.pixels[i / 3];
    return color;
}

Difference difference(const fs::path& a, const fs::path& b, double bound) {
    const burnish::Image one = burnish::read_image(a, {.as_data = true});
    const burnish::Image other = burnish::read_image(b, {.as_data = true});
    if (one.width != other.width || one.height != other.height || one.channels != other.channels)
        return {};
    double most = 0.0;
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
        most = std::max(most, std::abs(static_cast<double>(one.pixels[i]) -
                                       static_cast<double>(other.pixels[i])));
    most *= 255.0;
    if (most <= bound) return {most, 0.0};  // not printed
    return {most, burnish::mean_of(burnish::flip_error(in_color(one), in_color(other)))};
}

int compare(const fs::path& first, const fs::path& second, double bound) {
    std::vector<fs::path> names;
    for (const auto& entry : fs::directory_iterator(first))
        if (entry.path().extension() == ".png") names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    int wrong = 0;
    double most = 0.0;
    for (const fs::path& name : names) {
        const Difference d = fs::exists(second / name)
                                 ? difference(first / name, second / name, bound)
                                 : Difference{};
        most = std::max(most, d.most);
        if (d.most <= bound) continue;
        ++wrong;
        if (std::isinf(d.most))
            std::printf("%s: missing, or of another shape\n", name.c_str());
        else
            std::printf("%s: %g, mean FLIP %.4f\n", name.c_str(), d.most, d.flip);
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
