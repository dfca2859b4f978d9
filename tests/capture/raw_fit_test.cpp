// A capture of raw camera files against the same sensor data as linear TIFF files.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "burnish/capture_fit.hpp"
#include "burnish/image_io.hpp"
#include "burnish/relight.hpp"
#include "burnish/rig.hpp"
#include "burnish/virtual_sample.hpp"
#include "support/dng_writer.hpp"
#include "support/samples.hpp"

namespace burnish::test {
namespace {

namespace fs = std::filesystem;

constexpr int kSide = 24;  // LibRaw reads no smaller sensor than 22 x 22

// Satin whose grain turns about the middle, under a bar of lights.
struct Sitting {
    VirtualSample sample;
    Rig rig;
    double full = 0.0;  // what a picture shows as 1

    Sitting() {
        VirtualSettings settings;
        settings.width = settings.height = kSide;
        sample = make_virtual_sample("satin", settings);
        rig = make_bar_rig(sample, 6, 6, {});
        for (std::size_t k = 0; k < rig.lights.size(); ++k)
            for (const float v : virtual_picture(sample, rig, k, {}).pixels)
                full = std::max(full, static_cast<double>(v));
        for (RigLight& light : rig.lights)
            for (double& channel : light.intensity) channel /= full;
        rig.intensity_stated = true;
    }
    Image picture(std::size_t k) const { return virtual_picture(sample, rig, k, {}); }
};

void write_dng(const fs::path& path, const Image& picture) {
    const std::vector<std::byte> bytes = dng_of(picture);
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
}

void write_tiff(const fs::path& path, const Image& picture) {
    save(path,
         encode({"", "tiff", "uint16", 3, {"compression=none", "tiff:write_exif=0"}}, picture));
}

// The material of the pictures, written in one of the two ways.
TabulatedMaterial fitted(const Sitting& sitting, const fs::path& folder, bool raw) {
    fs::create_directories(folder);
    Rig rig = sitting.rig;
    for (std::size_t k = 0; k < rig.lights.size(); ++k) {
        const fs::path file = folder / ("p" + std::to_string(k) + (raw ? ".dng" : ".tif"));
        raw ? write_dng(file, sitting.picture(k)) : write_tiff(file, sitting.picture(k));
        rig.lights[k].images = {{file, 1.0}};
        rig.lights[k].where = "lights[" + std::to_string(k) + "]";
    }
    rig.file = folder / "rig.json";
    CaptureFitSettings settings;
    settings.eta = 1.5;
    settings.models = false;
    return fit_capture(rig, folder / "stages", settings);
}

// Root of the mean square of the difference of `a` and `b` over that of `b`.
double difference(const Image& a, const Image& b) {
    double sum = 0.0, whole = 0.0;
    for (std::size_t i = 0; i < b.pixels.size(); ++i) {
        const double d = static_cast<double>(a.pixels[i] - b.pixels[i]);
        sum += d * d;
        whole += static_cast<double>(b.pixels[i]) * static_cast<double>(b.pixels[i]);
    }
    return std::sqrt(sum / whole);
}

TEST(RawFit, IsThatOfTheLinearTiff) {
    const TemporaryFolder folder;
    const Sitting sitting;
    const TabulatedMaterial raw = fitted(sitting, folder.path() / "raw", true);
    const TabulatedMaterial tiff = fitted(sitting, folder.path() / "tiff", false);
    ASSERT_EQ(raw.width, kSide);
    ASSERT_EQ(raw.height, kSide);
    const Relighter of_raw(raw), of_tiff(tiff);
    for (const std::size_t k : {std::size_t{9}, std::size_t{21}}) {
        const Image truth = sitting.picture(k);
        const double raw_error = difference(of_raw.picture(sitting.rig, k), truth);
        const double tiff_error = difference(of_tiff.picture(sitting.rig, k), truth);
        // Two of three samples of a raw file are interpolated between those of the mosaic.
        const Image seen = read_image(folder.path() / "raw" / ("p" + std::to_string(k) + ".dng"));
        const double mosaic = difference(seen, truth);
        std::printf("light %d: raw %.4f, tiff %.4f, mosaic %.4f\n", static_cast<int>(k), raw_error,
                    tiff_error, mosaic);
        EXPECT_LT(raw_error, tiff_error + mosaic + 0.01);
        EXPECT_LT(mosaic, 0.2);
        EXPECT_LT(tiff_error, 0.1);
    }
}

}  // namespace
}  // namespace burnish::test
