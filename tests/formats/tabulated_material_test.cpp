// Files of tabulated materials: round trips, and errors for broken or hostile files.
#include "burnish/tabulated_material.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <random>

#include "burnish/f64.hpp"
#include "burnish/image_io.hpp"
#include "burnish/rgl_material.hpp"
#include "burnish/tabulated_file.hpp"
#include "core/constants.hpp"
#include "core/files.hpp"
#include "image/image_parts.hpp"
#include "support/bsdf_writer.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {
namespace {

// Colors that half floats represent exactly.
float color_of(int i) {
    return static_cast<float>(i % 17) / 32.0F;
}

std::vector<float> ggx_table(const NdfGrid& grid, double alpha_x, double alpha_y) {
    const f64::Lobe lobe = f64::lobe_from_alpha(f64::kMdfGgx, alpha_x, alpha_y);
    const f64::Perturbation p = f64::perturb_make(f64::kMethodNone, {0, 0, 1}, true, false);
    std::vector<float> table;
    for (int r = 0; r < grid.rings; ++r) {
        for (int a = 0; a < grid.azimuths; ++a) {
            const double theta = static_cast<double>(grid.theta(r)),
                         phi = 2 * kPi * a / grid.azimuths;
            table.push_back(static_cast<float>(
                f64::lobe_D(lobe, p,
                            {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                             std::cos(theta)})));
        }
    }
    const double mass = ndf_mass(grid, table.data());
    for (float& D : table) D = static_cast<float>(static_cast<double>(D) / mass);
    return table;
}

TabulatedMaterial sample_material(int exemplars = 5, NdfGrid grid = {16, 24}) {
    TabulatedMaterial m;
    m.grid = grid;
    m.exemplars = exemplars;
    for (int e = 0; e < exemplars; ++e) {
        const std::vector<float> table = ggx_table(grid, 0.3 + 0.1 * (e % 5), 0.6);
        m.D.insert(m.D.end(), table.begin(), table.end());
        m.groove.push_back(0.1F * static_cast<float>(e % 30));
    }
    for (std::size_t i = 0; i < m.D.size(); ++i) m.origin.push_back(static_cast<NdfOrigin>(i % 3));
    m.eta = 1.45;
    m.width = 7;
    m.height = 3;
    m.width_mm = 21.5;
    m.height_mm = 9.25;
    m.diffuse = Image(7, 3, 3);
    m.specular = Image(7, 3, 3);
    m.normal = Image(7, 3, 3);
    for (int i = 0; i < 21; ++i) {
        m.exemplar.push_back(i == 4 ? TabulatedMaterial::kNoExemplar
                                    : static_cast<std::uint16_t>(i % exemplars));
        m.angle.push_back(0.3F * static_cast<float>(i) - 3.0F);
        const double tilt = 0.02 * i;
        float* n = m.normal.at(i % 7, i / 7);
        n[0] = static_cast<float>(std::sin(tilt));
        n[2] = static_cast<float>(std::cos(tilt));
    }
    for (int i = 0; i < 63; ++i) {
        m.diffuse.pixels[static_cast<std::size_t>(i)] = color_of(i);
        m.specular.pixels[static_cast<std::size_t>(i)] = color_of(5 * i + 1);
    }
    m.maps["ward.alpha_x"] = std::vector<float>(21, 0.123F);
    m.maps["ward.alpha_x"][20] = -7.5F;
    m.maps["visible"] = std::vector<float>(21, 1.0F);
    m.metadata = {{"burnish:command", "made by a test, \"quoted\""}, {"residual", "0.031"}};
    return m;
}

void expect_equal(const TabulatedMaterial& a, const TabulatedMaterial& b) {
    EXPECT_EQ(a.grid, b.grid);
    EXPECT_EQ(a.exemplars, b.exemplars);
    EXPECT_EQ(a.D, b.D);
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_EQ(a.groove, b.groove);
    EXPECT_EQ(a.eta, b.eta);
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.width_mm, b.width_mm);
    EXPECT_EQ(a.height_mm, b.height_mm);
    EXPECT_EQ(a.exemplar, b.exemplar);
    EXPECT_EQ(a.angle, b.angle);
    EXPECT_EQ(a.diffuse.pixels, b.diffuse.pixels);
    EXPECT_EQ(a.specular.pixels, b.specular.pixels);
    EXPECT_EQ(a.normal.pixels, b.normal.pixels);
    EXPECT_EQ(a.maps, b.maps);
    EXPECT_EQ(a.metadata, b.metadata);
}

TEST(TabulatedMaterialFile, WhatIsWrittenComesBack) {
    const ScratchFolder folder;
    const TabulatedMaterial m = sample_material();
    write_tabulated_material(folder / "m.exr", m);
    EXPECT_TRUE(is_tabulated_material(folder / "m.exr"));
    const TabulatedMaterial read = read_tabulated_material(folder / "m.exr");
    expect_equal(read, m);
    EXPECT_EQ(read.table(1)[3], m.D[static_cast<std::size_t>(m.grid.cells()) + 3]);
    // A second round trip: the material that was read is written unchanged.
    write_tabulated_material(folder / "again.exr", read);
    expect_equal(read_tabulated_material(folder / "again.exr"), m);
}

TEST(TabulatedMaterialFile, ManyExemplarsLieBesideOneAnother) {
    const ScratchFolder folder;
    // One row would be 96,000 pixels wide, one column 48,000 high.
    TabulatedMaterial m = sample_material(1, {48, 96});
    m.exemplars = 1000;
    const std::vector<float> one = m.D;
    m.D.clear();
    for (int e = 0; e < m.exemplars; ++e) {
        m.D.insert(m.D.end(), one.begin(), one.end());
        m.D[m.D.size() - one.size()] = 1.0F + 1e-3F * static_cast<float>(e);
    }
    m.origin.assign(m.D.size(), NdfOrigin::completed);
    m.groove.assign(1000, 0.5F);
    m.exemplar[3] = 999;
    write_tabulated_material(folder / "m.exr", m);
    const TabulatedMaterial read = read_tabulated_material(folder / "m.exr");
    expect_equal(read, m);
    // Any viewer shows the parts. The image reader takes the first picture's leading channels only
    // when they are colors, and these are not.
    EXPECT_TRUE(is_image_file(folder / "m.exr"));
    const auto parts = read_image_parts(folder / "m.exr");
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_EQ(parts[0].name, "exemplars");
    EXPECT_EQ(parts[1].name, "texels");
    EXPECT_EQ(parts[2].name, "maps");
    EXPECT_LE(parts[0].width, 32768);
    EXPECT_LE(parts[0].height, 32768);
}

TEST(TabulatedMaterialFile, OtherFilesAreNone) {
    const ScratchFolder folder;
    write_image(folder / "plain.exr", Image(4, 4, 3, 0.5F), {});
    EXPECT_FALSE(is_tabulated_material(folder / "plain.exr"));
    EXPECT_FALSE(is_tabulated_material(folder.write("text.exr", "tabulated:version")));
    EXPECT_FALSE(is_tabulated_material(folder / "missing.exr"));
    EXPECT_NE(error_line([&] { read_tabulated_material(folder / "plain.exr"); }).find("exemplars"),
              std::string::npos);
    EXPECT_NE(error_line([&] { read_tabulated_material(folder / "missing.exr"); }).find("missing"),
              std::string::npos);
}

// Each invalid material is rejected on writing, with its place in the error, and leaves no file.
TEST(TabulatedMaterialFile, FaultsAreNamed) {
    const ScratchFolder folder;
    struct Fault {
        const char* word;
        void (*make)(TabulatedMaterial&);
    };
    const Fault faults[] = {
        {"D", [](TabulatedMaterial& m) { m.D[7] = -0.5F; }},
        {"D", [](TabulatedMaterial& m) { m.D[7] = std::numeric_limits<float>::quiet_NaN(); }},
        {"exemplar 1",
         [](TabulatedMaterial& m) {
             for (int i = 0; i < m.grid.cells(); ++i)
                 m.D[static_cast<std::size_t>(m.grid.cells() + i)] *= 1.05F;
         }},
        {"exemplar", [](TabulatedMaterial& m) { m.exemplar[2] = 5; }},
        {"angle", [](TabulatedMaterial& m) { m.angle[2] = INFINITY; }},
        {"diffuse", [](TabulatedMaterial& m) { m.diffuse.pixels[8] = -1; }},
        {"specular", [](TabulatedMaterial& m) { m.specular.pixels[8] = 1e6F; }},
        {"normal", [](TabulatedMaterial& m) { m.normal.pixels[2] = -1; }},
        {"normal", [](TabulatedMaterial& m) { m.normal.pixels[0] = 0.5F; }},
        {"maps", [](TabulatedMaterial& m) { m.maps["visible"].pop_back(); }},
        {"origin", [](TabulatedMaterial& m) { m.origin.pop_back(); }},
        {"groove", [](TabulatedMaterial& m) { m.groove.clear(); }},
        {"eta", [](TabulatedMaterial& m) { m.eta = 0.5; }},
        {"rings", [](TabulatedMaterial& m) { m.grid.rings = 0; }},
        {"exemplars", [](TabulatedMaterial& m) { m.exemplars = 70000; }},
        {"cells",
         [](TabulatedMaterial& m) {
             m.exemplars = 60000, m.grid = {64, 128};
         }},
        {"width", [](TabulatedMaterial& m) { m.width = -1; }}};
    for (const Fault& fault : faults) {
        TabulatedMaterial m = sample_material();
        fault.make(m);
        const std::string line =
            error_line([&] { write_tabulated_material(folder / "bad.exr", m); });
        EXPECT_NE(line.find(fault.word), std::string::npos) << line;
        EXPECT_FALSE(std::filesystem::exists(folder / "bad.exr")) << line;
    }
}

// Files that our writer never makes.
TEST(TabulatedMaterialFile, HostilePartsAreRefused) {
    const ScratchFolder folder;
    write_tabulated_material(folder / "good.exr", sample_material());
    using Parts = std::vector<ImagePart>;
    const Parts good = read_image_parts(folder / "good.exr");
    const auto drop = [](ImagePart& part, const std::string& channel) {
        std::erase_if(part.channels, [&](const ImageChannel& c) { return c.name == channel; });
    };
    const auto line_of = [&](const std::function<void(Parts&)>& change) {
        Parts parts = good;
        change(parts);
        write_image_parts(folder / "bad.exr", parts);
        return error_line([&] { read_tabulated_material(folder / "bad.exr"); });
    };
    const auto expect_word = [&](const char* word, const std::function<void(Parts&)>& change) {
        const std::string line = line_of(change);
        EXPECT_NE(line.find(word), std::string::npos) << line;
    };
    expect_word("version", [](Parts& p) { p[0].integers["tabulated:version"] = 2; });
    expect_word("rings", [](Parts& p) { p[0].integers["tabulated:rings"] = 2000000000; });
    expect_word("rings", [](Parts& p) { p[0].integers["tabulated:rings"] = -1; });
    expect_word("pixels", [](Parts& p) { p[0].integers["tabulated:rings"] = 15; });
    expect_word("azimuths", [](Parts& p) { p[0].integers.erase("tabulated:azimuths"); });
    expect_word("exemplars", [](Parts& p) { p[0].integers["tabulated:exemplars"] = 65535; });
    expect_word("columns", [](Parts& p) { p[0].integers["tabulated:columns"] = 0; });
    expect_word("eta", [](Parts& p) { p[0].reals.erase("tabulated:eta"); });
    expect_word("texels", [](Parts& p) { p.erase(p.begin() + 1); });
    expect_word("D", [&](Parts& p) { drop(p[0], "D"); });
    expect_word("angle", [&](Parts& p) { drop(p[1], "angle"); });
    expect_word("normal.Z", [&](Parts& p) { drop(p[1], "normal.Z"); });
    expect_word("exemplar", [](Parts& p) { p[1].channels[1].values.at(0) = 2.5F; });
    expect_word("origin", [](Parts& p) {
        for (ImageChannel& c : p[0].channels)
            if (c.name == "origin") c.values.at(0) = 7;
    });
    expect_word("maps", [](Parts& p) {
        p[2].width = 1;
        p[2].height = 1;
        for (ImageChannel& c : p[2].channels) c.values.resize(1);
    });
}

// Files truncated or changed at any byte give an error of one line or the material.
TEST(TabulatedMaterialFile, BrokenBytesAreSurvived) {
    const ScratchFolder folder;
    write_tabulated_material(folder / "good.exr", sample_material());
    const std::vector<std::byte> good = read_file(folder / "good.exr");
    const auto expect_answer = [&](std::span<const std::byte> bytes) {
        write_bytes(folder / "bad.exr", bytes);
        try {
            const TabulatedMaterial m = read_tabulated_material(folder / "bad.exr");
            EXPECT_EQ(m.exemplar.size(), m.texels());
            return true;
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            return false;
        }
    };
    for (std::size_t length = 0; length < good.size(); length += 1 + good.size() / 97)
        EXPECT_FALSE(expect_answer(std::span(good).first(length))) << length;
    for (unsigned seed = 0; seed < 200; ++seed) {
        std::mt19937 random(seed);
        std::vector<std::byte> bytes = good;
        for (int flips = 1 + static_cast<int>(random() % 6); flips > 0; --flips) {
            const std::size_t range = random() % 2 == 0 ? bytes.size() : 2000;
            bytes[random() % std::min(range, bytes.size())] =
                static_cast<std::byte>(random() & 0xff);
        }
        SCOPED_TRACE(seed);
        expect_answer(bytes);
    }
}

TEST(TabulatedMaterialFile, ABsdfIsOneExemplar) {
    const ScratchFolder folder;
    KnownMaterial known;
    known.surface = {0.2, 0.5};
    known.phis = 9;
    folder.write("known.bsdf", known.text());
    const TabulatedMaterial m = tabulated_from_bsdf(folder / "known.bsdf");
    EXPECT_EQ(m.exemplars, 1);
    EXPECT_EQ(m.texels(), 1U);
    EXPECT_NEAR(ndf_mass(m.grid, m.table(0)), 1, 1e-5);
    const double peak = known.surface.D({0, 0, 1});
    for (const double theta : {0.05, 0.3, 0.8}) {
        for (const double phi : {0.0, 0.7, 1.6, 3.0, -1.2}) {
            const double exact =
                known.surface.D({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                 std::cos(theta)});
            const double read = static_cast<double>(
                ndf_lookup(m.grid, m.table(0), ndf_u(static_cast<float>(std::cos(theta))),
                           static_cast<float>(phi)));
            // The file has a grid of 64 nodes a side over the square.
            EXPECT_NEAR(read, exact, 0.02 * peak) << theta << " " << phi;
        }
    }
    // Narrow along x: the groove runs along y.
    EXPECT_NEAR(static_cast<double>(m.groove[0]), known.surface.alpha_x < 0.5 ? 0.0 : 1.57, 4);
    write_tabulated_material(folder / "known.exr", m);
    expect_equal(read_tabulated_material(folder / "known.exr"), m);
}

}  // namespace
}  // namespace burnish::test
