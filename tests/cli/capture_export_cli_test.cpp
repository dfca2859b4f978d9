// burnish capture export and relight as a person runs them: what the files hold, the direction of
// the glTF's highlight, bad input.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "burnish/image_io.hpp"
#include "burnish/load_model.hpp"
#include "burnish/relight.hpp"
#include "burnish/tabulated_file.hpp"
#include "capture/tabulate_sample.hpp"
#include "core/constants.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

constexpr double kAlong = 0.06, kAcross = 0.35, kRound = 0.25;

// Brushed at `grain`, and round in the last two columns.
VirtualSample brushed(double grain, int width = 12, int height = 8) {
    VirtualSample s;
    s.name = "brushed";
    s.width = width;
    s.height = height;
    s.width_mm = 30.0;
    s.height_mm = 20.0;
    s.ndfs = {{"brushed", {{1.0, Mdf::ggx, kAlong, kAcross, 0.0, 0.0, 0.0}}},
              {"round", {{1.0, Mdf::ggx, kRound, kRound, 0.0, 0.0, 0.0}}}};
    for (int t = 0; t < width * height; ++t) {
        VirtualTexel texel;
        texel.ndf = t % width >= width - 2;
        texel.grain = grain;
        texel.diffuse = {0.1, 0.2, 0.05};
        texel.specular = {0.5, 0.45, 0.4};
        s.texels.push_back(texel);
    }
    return s;
}

std::string write_material(const Folder& folder, const TabulatedMaterial& m) {
    const std::string path = folder.path("material.exr");
    write_tabulated_material(path, m);
    return path;
}

Outcome capture(std::vector<std::string> arguments, const Surroundings& around = {}) {
    arguments.insert(arguments.begin(), "capture");
    return run_burnish(arguments, around);
}

double angle_apart(double a, double b, double period) {
    return std::abs(a - b - period * std::round((a - b) / period));
}

Image data_of(const std::string& path) {
    return read_image(path, {.as_data = true});
}

double value(const Image& image, int column, int row, int channel) {
    return static_cast<double>(image.at(column, row)[channel]);
}

TEST(CaptureExport, WritesTheMapsOfTheMaterial) {
    const Folder folder;
    const double grain = 2.9 + kPi;  // a line: 2.9 of half a turn
    TabulatedMaterial m = tabulated(brushed(grain), {32, 96});
    m.exemplar[0] = TabulatedMaterial::kNoExemplar;
    const std::string out = folder.path("out");
    const Outcome outcome = capture({"export", write_material(folder, m), "-o", out});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    EXPECT_EQ(outcome.complaint, "");
    const Image angle = read_image(out + "/grain_angle.exr");
    const Image alpha = read_image(out + "/alpha.exr");
    EXPECT_NEAR(value(angle, 3, 4, 0), 2.9 * 180 / kPi, 0.02);
    EXPECT_NEAR(value(alpha, 3, 4, 0), kAcross, 1e-3 * kAcross);
    EXPECT_NEAR(value(alpha, 3, 4, 1), kAlong, 1e-3 * kAlong);
    EXPECT_LT(value(alpha, 3, 4, 2), 1e-3);
    EXPECT_NEAR(value(alpha, 11, 4, 0), kRound, 1e-3 * kRound);
    EXPECT_NEAR(value(alpha, 11, 4, 1), kRound, 1e-3 * kRound);
    const auto same = [&](const char* name, const Image& image) {
        const Image written = read_image(out + name);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(value(written, 3, 4, c), value(image, 3, 4, c), 5e-4) << name;  // halves
            EXPECT_EQ(value(written, 0, 0, c), 0.0) << name;  // outside the mask
        }
    };
    same("/diffuse.exr", m.diffuse);
    same("/specular.exr", m.specular);
    same("/normal.exr", m.normal);
    EXPECT_EQ(value(angle, 0, 0, 0), 0.0);
    EXPECT_EQ(value(alpha, 0, 0, 0), 0.0);
    const Image base = data_of(out + "/base_color.png");
    ASSERT_EQ(base.channels, 4);
    EXPECT_EQ(value(base, 0, 0, 3), 0.0);
    EXPECT_EQ(value(base, 1, 0, 3), 1.0);
}

// What a reader of glTF makes of the textures, by the words of its specification.
TEST(CaptureExport, TheTexturesAreTheMaterialInTheWordsOfGltf) {
    const Folder folder;
    const double grain = 0.4;
    TabulatedMaterial m = tabulated(brushed(grain), {32, 96});
    const float lean[] = {0.2f, -0.1f, std::sqrt(0.95f)};
    std::copy_n(lean, 3, m.normal.pixels.begin());
    const std::string out = folder.path("out");
    ASSERT_EQ(capture({"export", write_material(folder, m), "-o", out}).exit_code, 0);
    const Image base = read_image(out + "/base_color.png");
    const Image rough = data_of(out + "/metallic_roughness.png");
    const Image normal = data_of(out + "/normal.png");
    const Image stretch = data_of(out + "/anisotropy.png");
    const double along = std::pow(value(rough, 3, 4, 1), 2);
    const double strength = value(stretch, 3, 4, 2);
    const double across = along + (1 - along) * strength * strength;
    EXPECT_NEAR(along, kAlong, 1e-3 * kAlong);  // codes of 16 bits, and the table
    EXPECT_NEAR(across, kAcross, 1e-3 * kAcross);
    // Across the groove: in tangent space x is the picture's right and y its up.
    const double direction =
        std::atan2(2 * value(stretch, 3, 4, 1) - 1, 2 * value(stretch, 3, 4, 0) - 1);
    EXPECT_LT(angle_apart(direction, grain + kPi / 2, kPi), 1e-3);
    EXPECT_NEAR(value(stretch, 11, 4, 2), 0.0, 0.05);  // round
    // Luminances come back exactly; of colors each is a compromise.
    const double metallic = value(rough, 3, 4, 2);
    double diffuse = 0, specular = 0;
    constexpr double kWeights[] = {0.2126, 0.7152, 0.0722};
    for (int c = 0; c < 3; ++c) {
        diffuse += kWeights[c] * value(base, 3, 4, c) * (1 - metallic);
        specular += kWeights[c] * (0.04 * (1 - metallic) + value(base, 3, 4, c) * metallic);
    }
    // Base color has 8 bits: 0.9 % of white at most.
    EXPECT_NEAR(diffuse, 0.2126 * 0.1 + 0.7152 * 0.2 + 0.0722 * 0.05, 0.005);
    EXPECT_NEAR(specular, 0.2126 * 0.5 + 0.7152 * 0.45 + 0.0722 * 0.4, 0.005);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(2 * value(normal, 0, 0, c) - 1, static_cast<double>(lean[c]), 1e-3);
}

// A dielectric keeps its diffuse color, however dark: as a mixture with a metal of the reflectance 0.08 it
// would turn gray.
TEST(CaptureExport, ADarkRedDielectricStaysRed) {
    const Folder folder;
    TabulatedMaterial m = tabulated(brushed(0.4), {32, 96});
    for (std::size_t t = 0; t < m.texels(); ++t) {
        const float diffuse[] = {0.076f, 0.015f, 0.019f};
        std::copy_n(diffuse, 3, m.diffuse.pixels.begin() + static_cast<std::ptrdiff_t>(3 * t));
        std::fill_n(m.specular.pixels.begin() + static_cast<std::ptrdiff_t>(3 * t), 3, 0.0625f);
    }
    const std::string out = folder.path("out");
    ASSERT_EQ(capture({"export", write_material(folder, m), "-o", out}).exit_code, 0);
    const Image base = read_image(out + "/base_color.png");
    // Half a code of 8 bits at sRGB 0.3 is 0.002 of white.
    EXPECT_NEAR(value(base, 3, 4, 0), 0.076, 0.002);
    EXPECT_NEAR(value(base, 3, 4, 1), 0.015, 0.002);
    EXPECT_NEAR(value(base, 3, 4, 2), 0.019, 0.002);
    EXPECT_EQ(value(data_of(out + "/metallic_roughness.png"), 3, 4, 2), 0.0);
    // By KHR_materials_ior, which is 5/3: ((5/3 - 1) / (5/3 + 1))^2.
    EXPECT_NEAR(load_model(out + "/material.gltf").materials.at(0).dielectric_f0, 0.0625f, 1e-6f);
}

// The axis of the bright part of a picture, degrees counter-clockwise from +x, and how much longer
// it is than wide.
struct Streak {
    double angle_deg = 0, ratio = 0;
};
Streak streak_of(const Image& picture) {
    double peak = 0, sum = 0, mx = 0, my = 0, xx = 0, xy = 0, yy = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) peak = std::max(peak, value(picture, x, y, 1));
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            // Above half of the brightest, so that the edge of the picture cuts nothing.
            const double v = std::max(value(picture, x, y, 1) - 0.5 * peak, 0.0);
            sum += v;
            mx += v * x;
            my += v * -y;
            xx += v * x * x;
            xy += v * x * -y;
            yy += v * y * y;
        }
    mx /= sum;
    my /= sum;
    xx = xx / sum - mx * mx;
    xy = xy / sum - mx * my;
    yy = yy / sum - my * my;
    const double middle = (xx + yy) / 2, apart = std::hypot((xx - yy) / 2, xy);
    return {0.5 * std::atan2(2 * xy, xx - yy) * 180 / kPi,
            std::sqrt((middle + apart) / std::max(middle - apart, 1e-9))};
}

TEST(CaptureExport, TheGltfShinesAlongTheLineOfTheTable) {
    for (const double grain_deg : {0.0, 25.0, 130.0}) {
        const Folder folder;
        VirtualSample sample = brushed(grain_deg * kPi / 180, 8, 8);
        sample.height_mm = 30.0;
        for (VirtualTexel& texel : sample.texels) texel.ndf = 0;
        const std::string material = write_material(folder, tabulated(sample, {64, 256}));
        const std::string out = folder.path("out");
        ASSERT_EQ(capture({"export", material, "-o", out}).exit_code, 0);
        const auto picture = [&](const std::string& name, std::vector<std::string> more) {
            std::vector<std::string> arguments = {
                "render", out + "/material.gltf", "--env", "builtin:black",
                // A lamp beside the eye, straight above the middle, 40 mm away.
                "--light", "point:0,0,0.04", "--camera-position", "0,0,0.06", "--camera-target",
                "0,0,0", "--camera-fov", "27", "--size", "96x96", "--samples", "4", "-o",
                folder.path(name)};
            arguments.insert(arguments.end(), more.begin(), more.end());
            const Outcome outcome = run_burnish(arguments);
            EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
            EXPECT_EQ(outcome.complaint, "");
            return read_image(folder.path(name));
        };
        const Streak lobe = streak_of(picture("lobe.exr", {}));
        const Streak table = streak_of(picture("table.exr", {"--tabulated", material}));
        // Across the groove; pixels are a 50th of the streak.
        EXPECT_LT(angle_apart(lobe.angle_deg, grain_deg + 90, 180), 1.0) << lobe.angle_deg;
        EXPECT_LT(angle_apart(table.angle_deg, grain_deg + 90, 180), 1.0) << table.angle_deg;
        EXPECT_GT(table.ratio, 2.0);
        EXPECT_NEAR(lobe.ratio, table.ratio, 0.1 * table.ratio);
    }
}

TEST(CaptureExport, NamesWhatCannotBe) {
    const Folder folder;
    const std::string material = write_material(folder, tabulated(brushed(0), {8, 16}));
    const std::string out = folder.path("out");
    expect_complaint(capture({"export", folder.path("none.exr"), "-o", out}), 1,
                     {"none.exr", "no such file"});
    expect_complaint(capture({"export", folder.write("a.json", "{}"), "-o", out}), 1,
                     {"a.json", "tabulated material"});
    write_image(folder.path("picture.exr"), Image(4, 4, 3), {});
    expect_complaint(capture({"export", folder.path("picture.exr"), "-o", out}), 1,
                     {"picture.exr", "tabulated material"});
    EXPECT_FALSE(std::filesystem::exists(out));
    expect_complaint(capture({"export", material, "-o", folder.write("file", "")}), 1,
                     {"file", "a folder"});
    expect_complaint(capture({"export", material, "-o", folder.path("no/such")}), 1,
                     {"no/such", "folder"});
    expect_complaint(capture({"export", material}), 2, {"--output"});
    expect_complaint(capture({}), 2, {"capture"});
    // Nothing is left of a write that fails.
    EXPECT_EQ(capture({"export", material, "-o", out}, {.file_size_limit = 2000}).exit_code, 1);
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(CaptureExport, WarnsOfWhatGltfCannotSay) {
    const Folder folder;
    VirtualSample sample = brushed(0);
    // Dielectrics of 0 and 10 %: 5 % on average.
    for (int t = 0; t < 24; ++t) {
        const double f0 = t < 12 ? 0.0 : 0.1;
        sample.texels[static_cast<std::size_t>(t)].specular = {f0, f0, f0};
    }
    for (int t = 24; t < 48; ++t) sample.texels[static_cast<std::size_t>(t)].specular = {2, 2, 2};
    // Two lobes far from one another.
    sample.ndfs[1].lobes = {{0.5, Mdf::beckmann, 0.05, 0.05, 0.0, 0.6, 0.0},
                            {0.5, Mdf::beckmann, 0.05, 0.05, 0.0, -0.6, 0.0}};
    TabulatedMaterial m = tabulated(sample, {32, 96});
    m.width_mm = m.height_mm = 0;
    const Outcome outcome =
        capture({"export", write_material(folder, m), "-o", folder.path("out")});
    EXPECT_EQ(outcome.exit_code, 0);
    expect_parts(
        outcome.complaint,
        {"1 mm a texel", "25 % of the texels are dielectrics whose reflectance is far from 5 %",
         "25 % of the texels have a specular color above 1",
         "17 % of the texels have "
         "distributions"});
}

// ---- relight

struct RelightFolder {
    Folder folder;
    VirtualSample sample = brushed(0.7);
    TabulatedMaterial material = tabulated(sample, {32, 96});
    Rig rig = make_dome_rig(sample, 4, {30.0, 0.0});
    std::string material_path = write_material(folder, material);
    std::string rig_path = folder.path("rig.json"), out = folder.path("out");

    RelightFolder() { write_rig(rig_path, rig); }
};

TEST(CaptureRelight, WritesAStackThatIsTheMaterialUnderTheRig) {
    RelightFolder f;
    f.rig.lights[2].camera = RigPlace{true, {20.0, 0.0, 100.0}};
    write_rig(f.rig_path, f.rig);
    f.material.exemplar[3] = TabulatedMaterial::kNoExemplar;
    write_material(f.folder, f.material);
    const Outcome outcome = capture({"relight", f.material_path, "--rig", f.rig_path, "-o", f.out});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    EXPECT_EQ(outcome.output, f.out + "/rig.json\n" + f.out + "/mask.png\n");
    const Rig written = read_rig(f.out + "/rig.json", true);
    ASSERT_EQ(written.lights.size(), 4u);
    ASSERT_TRUE(written.mask.has_value());
    EXPECT_EQ(written.width_mm, 30.0);
    ASSERT_TRUE(written.lights[2].camera.has_value());
    EXPECT_EQ(written.lights[2].camera->at, f.rig.lights[2].camera->at);
    const TabulatedMaterial read_back = read_tabulated_material(f.material_path);
    const Relighter relighter(read_back);
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_EQ(read_image(written.lights[k].images.at(0).image).pixels,
                  relighter.picture(f.rig, k).pixels)
            << k;
}

TEST(CaptureRelight, ComparesWithAStack) {
    RelightFolder f;
    // No two texels alike, lest the brightest are taken for clipped.
    for (std::size_t t = 0; t < f.material.texels(); ++t)
        for (std::size_t c = 0; c < 3; ++c)
            f.material.diffuse.pixels[3 * t + c] = 0.004f * static_cast<float>(t + 1 + 20 * c);
    write_material(f.folder, f.material);
    ASSERT_EQ(capture({"relight", f.material_path, "--rig", f.rig_path, "-o", f.out}).exit_code, 0);
    // The stack is brighter by a tenth.
    const Rig stack = read_rig(f.out + "/rig.json", true);
    std::vector<double> squares;
    double peak = 0;
    for (const auto& light : stack.lights) {
        Image image = read_image(light.images[0].image);
        squares.push_back(0);
        for (float& v : image.pixels) {
            squares.back() += std::pow(0.1 * static_cast<double>(v), 2);
            v *= 1.1f;
            peak = std::max(peak, static_cast<double>(v));
        }
        write_image(light.images[0].image, image, {});
    }
    const std::string again = f.folder.path("again");
    const Outcome outcome = capture({"relight", f.material_path, "--rig", f.rig_path, "--compare",
                                     f.out + "/rig.json", "-o", again, "--each-light"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    expect_parts(outcome.output, {again + "/rig.json\n" + again + "/compare.csv\n",
                                  "light   samples", "PSNR", "median of 4 lights", "RMSE"});
    std::istringstream csv(contents_of(again + "/compare.csv"));
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line, "light,picture,samples,rmse,psnr");
    for (int k = 0; k < 4; ++k) {
        double rmse = 0, psnr = 0;
        int light = -1, picture = -1, samples = 0;
        std::getline(csv, line);
        ASSERT_EQ(std::sscanf(line.c_str(), "%d,\"%d.exr\",%d,%lf,%lf", &light, &picture, &samples,
                              &rmse, &psnr),
                  5)
            << line;
        EXPECT_EQ(light, k);
        EXPECT_EQ(picture, k);
        EXPECT_EQ(samples, 12 * 8 * 3);
        const double expected = std::sqrt(squares[static_cast<std::size_t>(k)] / samples);
        EXPECT_NEAR(rmse, expected, 1e-5 * expected);  // six digits
        EXPECT_NEAR(psnr, 20 * std::log10(peak / expected), 1e-3);
    }
}

TEST(CaptureRelight, NamesWhatCannotBe) {
    RelightFolder f;
    const auto refused = [&](std::vector<std::string> arguments, int code,
                             const std::vector<std::string>& parts) {
        arguments.insert(arguments.begin(), "relight");
        expect_complaint(capture(arguments), code, parts);
    };
    refused({f.folder.write("no.exr", "no"), "--rig", f.rig_path, "-o", f.out}, 1,
            {"no.exr", "tabulated material"});
    refused({f.material_path, "--rig", f.folder.path("none.json"), "-o", f.out}, 1,
            {"none.json", "no such file"});
    const std::string dark =
        f.folder.write("dark.json", R"({"format": "burnish-rig", "version": 1, "units": "mm",
                         "sample": {"width": 1, "height": 1}, "camera": {"direction": [0, 0, 1]},
                         "lights": []})");
    refused({f.material_path, "--rig", dark, "-o", f.out}, 1, {"dark.json", "lights"});
    refused({f.material_path, "--rig", f.rig_path, "--compare", f.rig_path, "-o", f.out}, 1,
            {"rig.json", "image"});  // a rig without pictures is no stack
    refused({f.material_path, "--rig", f.rig_path, "--each-light", "-o", f.out}, 2, {"--compare"});
    refused({f.material_path, "-o", f.out}, 2, {"--rig"});
    EXPECT_FALSE(std::filesystem::exists(f.out));
    refused({f.material_path, "--rig", f.rig_path, "-o", f.folder.write("file", "")}, 1,
            {"file", "a folder"});

    // Stacks of another size and of another number of lights.
    ASSERT_EQ(capture({"relight", f.material_path, "--rig", f.rig_path, "-o", f.out}).exit_code, 0);
    const std::string stack = f.out + "/rig.json", again = f.folder.path("again");
    Rig fewer = f.rig;
    fewer.lights.pop_back();
    const std::string fewer_path = f.folder.path("fewer.json");
    write_rig(fewer_path, fewer);
    refused({f.material_path, "--rig", fewer_path, "--compare", stack, "-o", again}, 1,
            {"out/rig.json", "lights", "3", "found 4"});
    write_image(f.out + "/0001.exr", Image(6, 4, 3, 0.5f), {});
    refused({f.material_path, "--rig", f.rig_path, "--compare", stack, "-o", again}, 1,
            {"0001.exr", "12 x 8", "6 x 4"});
    EXPECT_FALSE(std::filesystem::exists(again));
}

std::vector<Image> relit(const RelightFolder& f, std::vector<std::string> more,
                         const std::string& name) {
    const std::string out = f.folder.path(name);
    more.insert(more.begin(), {"relight", f.material_path, "-o", out});
    const Outcome outcome = capture(more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
    std::vector<Image> pictures;
    for (const RigLight& light : read_rig(out + "/rig.json", true).lights)
        pictures.push_back(read_image(light.images.at(0).image));
    return pictures;
}

void expect_same(const std::vector<Image>& a, const std::vector<Image>& b, bool same) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(a[k].pixels == b[k].pixels, same) << k;
}

TEST(CaptureRelight, FlagsSayWhatTheRigHasWrong) {
    RelightFolder f;
    for (std::size_t k = 0; k < 2; ++k)  // near ones, whose rays differ over the sample
        for (double& value : f.rig.lights[k].place.at) value *= 90.0;
    f.rig.lights[0].place.near = f.rig.lights[1].place.near = true;
    f.rig.lights[1].emission_axis = {0.0, 0.6, -0.8};
    f.rig.lights[1].emission_exponent = 1.0;
    write_rig(f.rig_path, f.rig);
    const std::vector<Image> right = relit(f, {"--rig", f.rig_path}, "right");

    Rig down = f.rig;  // as a program writes it whose y points down
    down.camera.at[1] *= -1.0;
    for (RigLight& light : down.lights) {
        light.place.at[1] *= -1.0;
        light.emission_axis[1] *= -1.0;
    }
    const std::string down_path = f.folder.path("down.json");
    write_rig(down_path, down);
    expect_same(relit(f, {"--rig", down_path, "--flip-y"}, "flipped"), right, true);
    expect_same(relit(f, {"--rig", down_path}, "down"), right, false);

    Rig beside = f.rig;
    beside.camera.at = {0.0, 0.0, 1.0};
    const std::string beside_path = f.folder.path("beside.json");
    write_rig(beside_path, beside);
    const std::string camera =
        fmt::format("{},{},{}", f.rig.camera.at[0], f.rig.camera.at[1], f.rig.camera.at[2]);
    expect_same(relit(f, {"--rig", beside_path, "--camera", camera}, "moved"), right, true);
}

TEST(CaptureRelight, ComparesWithTheResponseThatIsGiven) {
    RelightFolder f;
    const std::vector<Image> pictures = relit(f, {"--rig", f.rig_path}, "relit");
    Rig stack = f.rig;
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        Image image = pictures[k];
        // sRGB codes of half the light, which nothing clips.
        for (float& value : image.pixels) value = srgb_from_linear(std::min(value / 2, 0.9f));
        stack.lights[k].images = {{f.folder.path(fmt::format("{}.png", k)), 1.0}};
        write_image(stack.lights[k].images[0].image, image, {});
        for (double& value : stack.lights[k].intensity) value = 0.5;
    }
    stack.response = RigResponse::linear;  // a lie
    const std::string path = f.folder.path("stack.json"), out = f.folder.path("again");
    write_rig(path, stack);
    const auto psnr = [&](std::vector<std::string> more) {
        more.insert(more.begin(),
                    {"relight", f.material_path, "--rig", path, "--compare", path, "-o", out});
        const Outcome outcome = capture(more);
        double value = 0.0;
        EXPECT_EQ(
            std::sscanf(outcome.output.c_str() + outcome.output.find("PSNR"), "PSNR %lf", &value),
            1)
            << outcome.output << outcome.complaint;
        return value;
    };
    EXPECT_LT(psnr({}), 20.0);
    EXPECT_GT(psnr({"--response", "srgb"}), 40.0);  // codes of 8 bits: 50 and more
    expect_complaint(
        capture({"relight", f.material_path, "--rig", path, "-o", out, "--response", "gamma"}), 2,
        {"--response", "gamma"});
}

TEST(CaptureRelight, SaysHowTheSizesOfRigAndMaterialDiffer) {
    RelightFolder f;
    f.rig.width_mm *= 2;
    f.rig.height_mm *= 2;
    write_rig(f.rig_path, f.rig);
    const Outcome outcome = capture({"relight", f.material_path, "--rig", f.rig_path, "-o", f.out});
    EXPECT_EQ(outcome.exit_code, 0);
    expect_parts(outcome.complaint, {"rig.json", "60 mm", "30 mm"});
    EXPECT_EQ(read_rig(f.out + "/rig.json", true).width_mm, 30.0);
}

}  // namespace
}  // namespace burnish::test
