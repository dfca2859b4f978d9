// Films of turntables: with ffmpeg where it is there, else with a program that stands for it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/run_program.hpp"
#include "jobs/film.hpp"
#include "jobs/turntable_request.hpp"
#include "support/program.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {
namespace {

namespace fs = std::filesystem;

bool has_ffmpeg() {
    const std::array<std::string, 2> words = {"ffmpeg", "-version"};
    return run_program(words).has_value();
}

// PATH, until the end of the test.
class SearchPath {
  public:
    explicit SearchPath(const std::string& path) : before_(std::getenv("PATH")) {
        setenv("PATH", path.c_str(), 1);
    }
    ~SearchPath() { setenv("PATH", before_.c_str(), 1); }

  private:
    std::string before_;
};

// A program `ffmpeg` of one's own, which has the encoder libx264.
SearchPath with_ffmpeg(const ScratchFolder& folder, const std::string& does) {
    fs::create_directory(folder / "bin");
    const fs::path file = folder.write(
        "bin/ffmpeg",
        "#!/bin/sh\ncase \"$*\" in *encoder=*) echo Encoder libx264; exit 0;; esac\n" + does);
    fs::permissions(file, fs::perms::owner_all);
    return SearchPath((folder / "bin").string() + ":/usr/bin:/bin");
}

// The pictures of a film as ffmpeg decodes them.
std::vector<Image> decoded(const fs::path& film, const ScratchFolder& folder, int count) {
    const std::vector<std::string> words = {
        "ffmpeg",      "-v",          "error",
        "-i",          film.string(), "-fps_mode",
        "passthrough", "-y",          (folder / "decoded_%d.png").string()};
    const auto result = run_program(words);
    EXPECT_EQ(result->exit_code, 0) << result->messages;
    std::vector<Image> pictures;
    for (int i = 1; i <= count; ++i)
        pictures.push_back(
            read_image(folder / ("decoded_" + std::to_string(i) + ".png"), {.as_data = true}));
    return pictures;
}

struct Difference {
    double mean[3] = {};  // of a channel, in codes of 255
    double median = 0;    // of the magnitude, over all channels
    double rms = 0;       // over all channels
};

// Over the pixels that both have.
Difference difference(const Image& a, const Image& b) {
    std::vector<double> all;
    Difference d;
    const int width = std::min(a.width, b.width), height = std::min(a.height, b.height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double codes = 255.0 * (static_cast<double>(a.at(x, y)[c]) -
                                              static_cast<double>(b.at(x, y)[c]));
                d.mean[c] += codes / (width * height);
                all.push_back(std::abs(codes));
                d.rms += codes * codes / (3.0 * width * height);
            }
    d.rms = std::sqrt(d.rms);
    std::ranges::nth_element(all, all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2));
    d.median = all[all.size() / 2];
    return d;
}

// A colored cloth; odd sides.
RenderRequest film_request(const fs::path& output) {
    RenderRequest request = turntable_request(
        "builtin:drape", output, 5,
        {{"base_color", "0.8,0.2,0.1"}, {"metallic", "0"}, {"width", "101"}, {"height", "75"}});
    return request;
}

TEST(TurntableFilm, KeepsTheColorsOfItsPictures) {
    if (!has_ffmpeg()) GTEST_SKIP() << "no ffmpeg";
    for (const std::string name : {"t.mp4", "t.webm", "t.apng"}) {
        const ScratchFolder folder;
        RenderRequest request = film_request(folder / name);
        request.keep_frames = true;
        request.frames = FrameRange{1, 4};  // a part of a turn is a film, too
        const RenderReport report = render(request);
        ASSERT_EQ(report.written.size(), 5u);
        EXPECT_EQ(report.written.back(), folder / name);
        const bool subsampled = name != "t.apng";
        EXPECT_EQ(!report.notes.empty(), subsampled);
        const std::vector<Image> film = decoded(folder / name, folder, 4);
        for (int i = 0; i < 4; ++i) {
            const Image& found = film[static_cast<std::size_t>(i)];
            EXPECT_EQ(found.width, subsampled ? 102 : 101);
            EXPECT_EQ(found.height, subsampled ? 76 : 75);
            const Image drawn =
                read_image(numbered(film_pictures(folder / name), i + 1), {.as_data = true});
            const Difference d = difference(found, drawn);
            if (!subsampled) {
                EXPECT_EQ(d.median + std::abs(d.mean[0]), 0) << name;
            }
            // Luma has 219 codes for 255: half a code of its own and of each chroma, at the weights of
            // the matrix, are 2 codes. A wrong matrix or range shifts this red by 6 and more.
            EXPECT_LE(d.median, 2) << name << " " << i;
            for (const double mean : d.mean) EXPECT_LT(std::abs(mean), 1.5) << name << " " << i;
            // Frames that follow differ: none is shown twice, none is left out.
            const Image next = read_image(
                numbered(film_pictures(folder / name), i == 3 ? 1 : i + 2), {.as_data = true});
            const Difference other = difference(found, next);
            EXPECT_GT(other.rms, 2 * d.rms) << name << " " << i;
        }
    }
}

TEST(TurntableFilm, SaysInItsTagsWhatItsColorsAre) {
    if (!has_ffmpeg()) GTEST_SKIP() << "no ffmpeg";
    const ScratchFolder folder;
    for (const std::string name : {"t.mp4", "t.webm"}) {
        render(film_request(folder / name));
        const std::vector<std::string> words = {
            "ffprobe",
            "-v",
            "error",
            "-show_entries",
            "stream=pix_fmt,color_range,color_space,color_transfer,color_primaries,r_frame_rate",
            "-of",
            "default=noprint_wrappers=1",
            (folder / name).string()};
        std::string tags;
        ASSERT_TRUE(run_program(words, [&](std::string_view more) { tags += more; }));
        expect_parts(tags,
                     {"pix_fmt=yuv420p", "color_range=tv", "color_space=bt709",
                      "color_transfer=iec61966-2-1", "color_primaries=bt709", "r_frame_rate=24/1"});
    }
}

TEST(TurntableFilm, DeletesItsPicturesAndNothingElse) {
    const ScratchFolder folder;
    const SearchPath path =
        with_ffmpeg(folder, "for word in \"$@\"; do last=$word; done; echo film > \"$last\"\n");
    RenderRequest request = film_request(folder / "t.mp4");
    EXPECT_EQ(render(request).written, std::vector<fs::path>{folder / "t.mp4"});
    EXPECT_TRUE(fs::exists(folder / "t.mp4"));
    EXPECT_FALSE(fs::exists(folder / "t_frames"));

    fs::create_directory(folder / "t_frames");
    folder.write("t_frames/notes.txt", "mine");
    render(request);
    EXPECT_TRUE(fs::exists(folder / "t_frames/notes.txt"));
    EXPECT_FALSE(fs::exists(folder / "t_frames/t_0000.png"));

    // Pictures that were there may have taken hours, elsewhere too.
    request.keep_frames = true;
    EXPECT_EQ(render(request).written.size(), 6u);
    request.keep_frames = false;
    request.resume = true;
    const RenderReport resumed = render(request);
    EXPECT_EQ(resumed.written, std::vector<fs::path>{folder / "t.mp4"});
    EXPECT_EQ(resumed.device, "");  // nothing was drawn
    EXPECT_TRUE(fs::exists(folder / "t_frames/t_0004.png"));
}

TEST(TurntableFilm, AFilmThatFailsLeavesTheOldOneAndThePictures) {
    const ScratchFolder folder;
    const SearchPath path =
        with_ffmpeg(folder, "echo 'Conversion failed!' >&2; echo more >&2; exit 1\n");
    folder.write("t.mp4", "the old film");
    const std::string line = error_line([&] { render(film_request(folder / "t.mp4")); });
    expect_parts(line, {"t.mp4: expected a film made by ffmpeg", "Conversion failed!",
                        "the pictures stay in", "t_frames"});
    EXPECT_EQ(line.find("more"), std::string::npos);
    EXPECT_EQ(contents_of((folder / "t.mp4").string()), "the old film");
    EXPECT_TRUE(fs::exists(folder / "t_frames/t_0004.png"));
}

TEST(TurntableFilm, IsInterruptedWhileFfmpegRuns) {
    const ScratchFolder folder;
    const SearchPath path = with_ffmpeg(folder, "exec sleep 60\n");
    const CancelToken token;
    const auto cancel = [&](std::string_view stage, double) {
        if (stage == "film") token.cancel();
    };
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THROW(render(film_request(folder / "t.mp4"), Progress(cancel, token)), Interrupted);
    // Without the cancel it takes a minute.
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(40));
    EXPECT_FALSE(fs::exists(folder / "t.mp4"));
    EXPECT_TRUE(fs::exists(folder / "t_frames/t_0004.png"));
}

TEST(TurntableFilm, AMissingFfmpegIsSaidBeforeAnythingIsDrawn) {
    const ScratchFolder folder;
    {
        const SearchPath path((folder / "").string());
        expect_parts(
            error_line([&] { render(film_request(folder / "t.mp4")); }),
            {"t.mp4: expected the program ffmpeg (package ffmpeg)", "none in PATH", "-o t.png"});
    }
    const SearchPath path = with_ffmpeg(folder, "exit 1\n");
    expect_parts(error_line([&] { render(film_request(folder / "t.webm")); }),
                 {"t.webm: expected an ffmpeg with the encoder libvpx-vp9"});
    EXPECT_FALSE(fs::exists(folder / "t_frames"));
}

TEST(TurntableFilm, TransparencyIsKeptOrReplacedByAColor) {
    if (!has_ffmpeg()) GTEST_SKIP() << "no ffmpeg";
    const ScratchFolder folder;
    const auto corner = [&](const std::string& name) {
        RenderRequest request = film_request(folder / name);
        request.stage.values.set("background", "transparent", "");
        request.stage.values.set("background_color", "1,1,1", "");
        request.stage.values.set("tone_map", "linear", "");
        const RenderReport report = render(request);
        const bool warned = std::ranges::any_of(report.warnings, [](const std::string& line) {
            return line.starts_with("--background transparent");
        });
        EXPECT_EQ(warned, name != "t.apng");
        const Image image = decoded(folder / name, folder, 1).front();
        return image.channels == 4 ? image.at(0, 0)[3] : image.at(0, 0)[0];
    };
    EXPECT_EQ(corner("t.apng"), 0.0f);
    EXPECT_GT(corner("t.mp4"), 0.98f);
}

}  // namespace
}  // namespace burnish::test
