#include "support/picture_checks.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "burnish/display.hpp"
#include "burnish/image_io.hpp"
#include "support/paths.hpp"

namespace burnish::test {
namespace {

// Names of failed pictures: the test's name and a number.
std::string next_name() {
    static std::string last;
    static int number = 0;
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name =
        info == nullptr ? "picture" : std::string(info->test_suite_name()) + "." + info->name();
    std::ranges::replace(name, '/', '_');
    number = name == last ? number + 1 : 1;
    last = name;
    return name + "_" + std::to_string(number);
}

Image difference_of(const Image& a, const Image& b) {
    Image d = a;
    float most = 0.0f;
    for (std::size_t i = 0; i < d.pixels.size(); ++i) {
        d.pixels[i] = std::abs(a.pixels[i] - b.pixels[i]);
        most = std::max(most, d.pixels[i]);
    }
    for (std::size_t i = 0; i < d.pixels.size(); ++i) {
        const bool alpha = d.channels == 4 && i % 4 == 3;
        d.pixels[i] = alpha ? 1.0f : most > 0.0f ? d.pixels[i] / most : 0.0f;
    }
    return d;
}

// Writes the pictures and returns a message with their folder.
std::string keep(const Image& found, const Image& wanted) {
    const std::filesystem::path folder =
        std::filesystem::path(program_path()).parent_path().parent_path() / "failed_pictures";
    const std::string name = next_name();
    try {
        std::filesystem::create_directories(folder);
        const auto write = [&](const char* kind, const Image& image) {
            write_image(folder / (name + kind), to_display(image, 0.0, ToneMap::linear), {});
        };
        write("_found.png", found);
        write("_wanted.png", wanted);
        const bool same_size = found.width == wanted.width && found.height == wanted.height &&
                               found.channels == wanted.channels;
        if (same_size) write("_difference.png", difference_of(found, wanted));
    } catch (const std::exception& error) {
        return std::string("; the pictures could not be written: ") + error.what();
    }
    return "; see " + (folder / name).string() +
           "_found.png, _wanted.png, _difference.png (brightest: the largest difference)";
}

bool same_shape(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height && a.channels == b.channels;
}

}  // namespace

double largest_difference(const Image& a, const Image& b, double floor) {
    double worst = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double x = a.pixels[i];
        const double y = b.pixels[i];
        worst = std::max(worst, std::abs(x - y) / std::max({x, y, floor}));
    }
    return worst;
}

testing::AssertionResult close_pictures(const Image& found, const Image& wanted, double floor,
                                        double tolerance) {
    if (!same_shape(found, wanted))
        return testing::AssertionFailure() << "the pictures differ in size" << keep(found, wanted);
    const double worst = largest_difference(found, wanted, floor);
    if (worst < tolerance) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "the pictures differ by " << worst << ", more than "
                                       << tolerance << keep(found, wanted);
}

testing::AssertionResult equal_pictures(const Image& found, const Image& wanted, double tolerance) {
    if (!same_shape(found, wanted))
        return testing::AssertionFailure() << "the pictures differ in size" << keep(found, wanted);
    double worst = 0;
    std::size_t place = 0;
    for (std::size_t i = 0; i < found.pixels.size(); ++i) {
        const double x = found.pixels[i], y = wanted.pixels[i];
        const double d = std::abs(x - y) / std::max({x, y, 1.0});
        if (d > worst) {
            worst = d;
            place = i;
        }
    }
    if (worst <= tolerance) return testing::AssertionSuccess();
    const std::size_t pixel = place / static_cast<std::size_t>(found.channels);
    const auto width = static_cast<std::size_t>(found.width);
    return testing::AssertionFailure()
           << "the pictures differ by " << worst << " at pixel " << pixel % width << ", "
           << pixel / width << " (" << found.pixels[place] << " and " << wanted.pixels[place] << ")"
           << keep(found, wanted);
}

}  // namespace burnish::test
