// The cache file of a stack: reused while it is valid, written again when it is not, and never left
// incomplete.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "stack_support.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;
using test::ScratchFolder;

constexpr int kWidth = 12, kHeight = 7;

struct Capture {
    ScratchFolder folder;
    Rig rig;
    fs::path cache;

    Capture() {
        for (std::uint32_t k = 0; k < 3; ++k)
            write_image(folder / picture(k), test::random_picture(kWidth, kHeight, 1 + k, k), {});
        rig = test::rig_of(folder, {picture(0), picture(1), picture(2)});
        cache = folder / "stack.cache";
    }
    static std::string picture(std::uint32_t k) { return "p" + std::to_string(k) + ".exr"; }
    std::vector<float> samples() const { return test::all_samples(ImageStack(rig, cache, {})); }
    // The inode number: a cache that is written again is another file under the same name.
    ino_t number() const {
        struct stat found {};
        EXPECT_EQ(::stat(cache.c_str(), &found), 0);
        return found.st_ino;
    }
    // A hard link keeps the old file's inode number from being reused.
    void hold() const { fs::create_hard_link(cache, folder / "held"); }
};

TEST(StackCache, IsUsedAgainWhenNothingChanged) {
    const Capture c;
    const std::vector<float> first = c.samples();
    const ino_t number = c.number();
    c.hold();
    const fs::file_time_type time = fs::last_write_time(c.cache);
    EXPECT_EQ(c.samples(), first);
    EXPECT_EQ(c.number(), number);
    EXPECT_EQ(fs::last_write_time(c.cache), time);
    const ImageStack stack(c.rig, c.cache, {});
    EXPECT_EQ(stack.mask().size(), static_cast<std::size_t>(kWidth * kHeight));
    EXPECT_GT(stack.census().brightest, 2.5);
}

// A valid cache needs no pictures, which may be offline by then; it holds all results of reading
// them.
TEST(StackCache, CensusAndMaskComeFromIt) {
    Capture c;
    Image mask(kWidth, kHeight, 1, 1.0f);
    mask.at(3, 2)[0] = 0;
    write_image(c.folder / "m.png", mask, {});
    c.rig.mask = c.folder / "m.png";
    const ImageStack made(c.rig, c.cache, {});
    const ImageStack used(c.rig, c.cache, {});
    EXPECT_EQ(made.mask(), used.mask());
    EXPECT_EQ(made.identity(), used.identity());
    EXPECT_EQ(made.census().brightest, used.census().brightest);
    EXPECT_EQ(made.census().black_share, used.census().black_share);
    EXPECT_EQ(made.band_pixels(), used.band_pixels());
    EXPECT_EQ(used.mask()[2 * kWidth + 3], 0);
}

TEST(StackCache, IsMadeAnewWhenAPictureChanges) {
    const Capture c;
    const std::vector<float> first = c.samples();
    const std::uint64_t identity = ImageStack(c.rig, c.cache, {}).identity();
    c.hold();
    const ino_t number = c.number();
    const fs::path changed = c.folder / Capture::picture(1);
    const auto time = fs::last_write_time(changed);
    const Image other = test::random_picture(kWidth, kHeight, 2, 77);
    write_image(changed, other, {});
    fs::last_write_time(changed, time + std::chrono::seconds(10));
    const std::vector<float> second = c.samples();
    EXPECT_NE(c.number(), number);
    EXPECT_NE(ImageStack(c.rig, c.cache, {}).identity(), identity);
    for (std::size_t i = 0; i < second.size(); ++i) {
        if (i / 3 % 3 != 1) {
            EXPECT_EQ(second[i], first[i]) << i;
            continue;
        }
        const auto value = static_cast<double>(other.pixels[i / 9 * 3 + i % 3]);
        EXPECT_NEAR(static_cast<double>(second[i]), value, test::coding_error(value, 2)) << i;
    }
}

// Every member of the rig that affects the samples changes the stack's identity.
TEST(StackCache, IsMadeAnewWhenTheRigChanges) {
    const Capture c;
    write_image(c.folder / "m.png", Image(kWidth, kHeight, 1, 1.0f), {});
    write_image(c.folder / "w.exr", Image(kWidth, kHeight, 3, 1.0f), {});
    std::vector<Rig> rigs(7, c.rig);
    rigs[1].lights.pop_back();
    std::swap(rigs[2].lights[0], rigs[2].lights[1]);
    rigs[3].lights[0].images[0].exposure = 2;
    rigs[4].mask = c.folder / "m.png";
    rigs[5].white = c.folder / "w.exr";
    rigs[6].lights[2].images.push_back({c.folder / Capture::picture(1), 0.5});
    std::set<std::uint64_t> identities;
    for (const Rig& rig : rigs) identities.insert(ImageStack(rig, c.cache, {}).identity());
    EXPECT_EQ(identities.size(), rigs.size());
    // The last cache written is not used for another rig.
    const ImageStack short_stack(rigs[1], c.cache, {});
    EXPECT_EQ(short_stack.lights(), 2u);
    EXPECT_EQ(c.samples().size(), static_cast<std::size_t>(kWidth * kHeight * 9));
}

TEST(StackCache, BrokenOnesAreMadeAnew) {
    const Capture c;
    const std::vector<float> first = c.samples();
    const auto size = fs::file_size(c.cache);
    for (const std::uintmax_t kept :
         {size - 1, size / 2, std::uintmax_t{100}, std::uintmax_t{9}, std::uintmax_t{0}}) {
        fs::resize_file(c.cache, kept);
        EXPECT_EQ(c.samples(), first) << kept;
        EXPECT_EQ(fs::file_size(c.cache), size) << kept;
    }
    std::ofstream(c.cache, std::ios::binary) << std::string(5000, 'x');
    EXPECT_EQ(c.samples(), first);
    std::fstream file(c.cache, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(0);
    file << "not one of ours";
    file.close();
    EXPECT_EQ(c.samples(), first);
}

// A cache with impossible sizes in its header is rejected.
TEST(StackCache, AbsurdHeadsAreNotBelieved) {
    const Capture c;
    const std::vector<float> first = c.samples();
    const std::string absurd[] = {std::string("\xff\xff\xff\xff\xff\xff\xff\x7f", 8),
                                  std::string(8, '\0')};
    for (const std::string& bytes : absurd) {
        for (int at = 0; at < 80; at += 8) {
            std::fstream file(c.cache, std::ios::binary | std::ios::in | std::ios::out);
            file.seekp(at);
            file.write(bytes.data(), 8);
            file.close();
            std::vector<float> again;
            ASSERT_NO_THROW(again = c.samples()) << at;
            EXPECT_EQ(again.size(), first.size()) << at;
            fs::remove(c.cache);
            ASSERT_EQ(c.samples(), first) << at;
        }
    }
}

// Every failure names the file and leaves the folder unchanged.
TEST(StackCache, FailuresLeaveNothingBehind) {
    const auto fails = [](const Capture& c, const Rig& rig, const std::string& name) {
        const auto before = test::files_in(c.rig.file.parent_path());
        const std::string line = test::error_line([&] { ImageStack(rig, c.cache, {}); });
        EXPECT_NE(line.find(name), line.npos) << line;
        EXPECT_EQ(test::files_in(c.rig.file.parent_path()), before) << name;
    };
    {
        const Capture c;
        write_image(c.folder / "p1.exr", Image(kWidth - 1, kHeight, 3, 1.0f), {});
        fails(c, c.rig, "p1.exr");
    }
    {
        const Capture c;
        fs::resize_file(c.folder / "p2.exr", fs::file_size(c.folder / "p2.exr") / 2);
        fails(c, c.rig, "p2.exr");
    }
    {
        const Capture c;
        fs::remove(c.folder / "p2.exr");
        fails(c, c.rig, "p2.exr");
    }
    {
        const Capture c;
        c.folder.write("p0.exr", "no picture");
        fails(c, c.rig, "p0.exr");
    }
    {
        Capture c;
        c.rig.white = c.folder / "w.exr";
        write_image(*c.rig.white, Image(kWidth, kHeight + 1, 3, 1.0f), {});
        fails(c, c.rig, "w.exr");
        write_image(*c.rig.white, Image(kWidth, kHeight, 3, 0.0f), {});
        fails(c, c.rig, "w.exr");
    }
    {
        const Capture c;  // the second picture of a bracket has another size
        Rig rig = c.rig;
        write_image(c.folder / "long.exr", Image(kWidth, kHeight + 2, 3, 1.0f), {});
        rig.lights[1].images.push_back({c.folder / "long.exr", 2});
        fails(c, rig, "long.exr");
    }
    {
        Capture c;  // NaN is an invalid sample
        Image picture = test::random_picture(kWidth, kHeight, 1, 4);
        picture.pixels[5] = std::numeric_limits<float>::quiet_NaN();
        write_image(c.folder / "p1.exr", picture, {});
        fails(c, c.rig, "p1.exr");
    }
}

TEST(StackCache, AnOldOneOutlivesAFailure) {
    const Capture c;
    c.samples();
    const std::string old = test::files_in(c.rig.file.parent_path()).count("stack.cache")
                                ? std::to_string(fs::file_size(c.cache))
                                : "";
    fs::resize_file(c.folder / "p2.exr", 50);
    test::error_line([&] { ImageStack(c.rig, c.cache, {}); });
    EXPECT_EQ(std::to_string(fs::file_size(c.cache)), old);
}

TEST(StackCache, FoldersThatCannotBeWrittenAreNamed) {
    Capture c;
    for (const fs::path& cache : {c.folder / "nowhere/stack.cache", c.folder / "p0.exr/stack.cache",
                                  fs::path("/proc/stack.cache")}) {
        const std::string line = test::error_line([&] { ImageStack(c.rig, cache, {}); });
        EXPECT_NE(line.find("stack.cache"), line.npos) << line;
    }
    fs::create_directory(c.folder / "folder");
    const std::string line = test::error_line([&] { ImageStack(c.rig, c.folder / "folder", {}); });
    EXPECT_NE(line.find("folder"), line.npos) << line;
    EXPECT_FALSE(fs::exists(c.folder / "nowhere"));
}

// Ctrl-C during reading.
TEST(StackCache, InterruptionsLeaveNothingBehind) {
    const Capture c;
    const auto before = test::files_in(c.rig.file.parent_path());
    int steps = 0;
    const Progress progress([&](std::string_view, double) {
        if (++steps == 2) throw Interrupted();
    });
    EXPECT_THROW(ImageStack(c.rig, c.cache, progress), Interrupted);
    EXPECT_EQ(test::files_in(c.rig.file.parent_path()), before);
}

}  // namespace
}  // namespace burnish
