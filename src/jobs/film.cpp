#include "jobs/film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include "burnish/error.hpp"
#include "core/files.hpp"
#include "core/run_program.hpp"
#include "jobs/render.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

struct FilmFormat {
    std::string_view extension, encoder, muxer;
    bool subsampled;  // chroma 4:2:0, of limited range
    std::vector<std::string> options;
};

// Qualities at which a film of smooth gradients shows no blocks: within two codes of the pictures.
const std::array<FilmFormat, 3>& film_formats() {
    static const std::array<FilmFormat, 3> kFormats{
        {{".mp4",
          "libx264",
          "mp4",
          true,
          {"-preset", "medium", "-crf", "14", "-movflags", "+faststart"}},
         {".webm",
          "libvpx-vp9",
          "webm",
          true,
          {"-crf", "16", "-b:v", "0", "-deadline", "good", "-cpu-used", "2", "-row-mt", "1"}},
         {".apng", "apng", "apng", false, {"-plays", "0", "-pred", "mixed"}}}};
    return kFormats;
}

const FilmFormat* film_format_of(const fs::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    const auto& all = film_formats();
    const auto found = std::ranges::find(all, extension, &FilmFormat::extension);
    return found == all.end() ? nullptr : &*found;
}

// As ffmpeg reads names of numbered pictures: absolute, so that nothing before a colon is a protocol,
// and a percent sign of the name's own doubled.
std::string pattern_of(const fs::path& pictures) {
    const auto literal = [](const std::string& text) {
        std::string doubled;
        for (const char c : text) doubled += c == '%' ? std::string("%%") : std::string(1, c);
        return doubled;
    };
    const fs::path whole = fs::absolute(pictures);
    return literal((whole.parent_path() / whole.stem()).string()) + "_%04d" +
           literal(whole.extension().string());
}

// The pictures are sRGB with the primaries of BT.709: the matrix that makes luma of them, and the tags
// that say so. `setparams` tags the frames, which newer releases of ffmpeg take for the film's; the
// options tag the film.
std::string filters_of(const FilmRequest& request) {
    std::string filters;
    if (film_is_padded(request))
        filters =
            fmt::format("pad={}:{},format=gbrp,fillborders=right={}:bottom={}:mode=smear,",
                        request.width + request.width % 2, request.height + request.height % 2,
                        request.width % 2, request.height % 2);
    return filters +
           "scale=in_range=full:out_range=limited:out_color_matrix=bt709:"
           "flags=bicubic+accurate_rnd+full_chroma_int+full_chroma_inp,format=yuv420p,"
           "setparams=range=limited:color_primaries=bt709:color_trc=iec61966-2-1:colorspace=bt709";
}

std::vector<std::string> words_of(const FilmRequest& request, const FilmFormat& format,
                                  const fs::path& to) {
    std::vector<std::string> words = {"ffmpeg",
                                      "-hide_banner",
                                      "-nostdin",
                                      "-nostats",
                                      "-v",
                                      "error",
                                      "-progress",
                                      "pipe:1",
                                      "-y",
                                      "-f",
                                      "image2",
                                      "-framerate",
                                      std::to_string(request.fps),
                                      "-start_number",
                                      std::to_string(request.first),
                                      "-i",
                                      pattern_of(film_pictures(request.output)),
                                      "-frames:v",
                                      std::to_string(request.count)};
    const auto add = [&](std::initializer_list<std::string> more) {
        words.insert(words.end(), more);
    };
    if (format.subsampled)
        add({"-vf", filters_of(request), "-color_range", "tv", "-colorspace", "bt709",
             "-color_primaries", "bt709", "-color_trc", "iec61966-2-1"});
    else
        add({"-pix_fmt", request.alpha ? "rgba" : "rgb24"});
    add({"-c:v", std::string(format.encoder)});
    words.insert(words.end(), format.options.begin(), format.options.end());
    add({"-metadata", "comment=" + request.comment, "-f", std::string(format.muxer),
         fs::absolute(to).string()});
    return words;
}

// The number in the last line "frame=12" of what "-progress" prints; none: no such line.
std::optional<int> frame_in(std::string_view text) {
    constexpr std::string_view kKey = "frame=";
    const std::size_t at = text.rfind(kKey);
    int frame = 0;
    if (at == text.npos) return std::nullopt;
    const char* begin = text.data() + at + kKey.size();
    if (std::from_chars(begin, text.data() + text.size(), frame).ec != std::errc{})
        return std::nullopt;
    return frame;
}

}  // namespace

bool is_film(const fs::path& path) {
    return film_format_of(path) != nullptr;
}

bool film_holds_alpha(const fs::path& path) {
    const FilmFormat* format = film_format_of(path);
    return format != nullptr && !format->subsampled;
}

BackgroundKind film_background(const fs::path& film, BackgroundKind asked) {
    const bool lost = asked == BackgroundKind::transparent && !film_holds_alpha(film);
    return lost ? BackgroundKind::color : asked;
}

fs::path film_pictures(const fs::path& film) {
    const std::string stem = film.stem().string();
    return film.parent_path() / (stem + "_frames") / (stem + ".png");
}

void require_film_maker(const fs::path& film) {
    const std::string encoder(film_format_of(film)->encoder);
    const std::array<std::string, 6> words = {"ffmpeg", "-hide_banner", "-v",
                                              "error",  "-h",           "encoder=" + encoder};
    std::string printed;
    const auto result = run_program(words, [&](std::string_view more) { printed += more; });
    const std::string pictures = film.stem().string() + ".png";
    if (!result)
        throw Error(film.string(), "", "the program ffmpeg (package ffmpeg), which makes films",
                    "none in PATH; -o " + pictures + " writes numbered pictures without it");
    if (printed.find("Encoder " + encoder) == printed.npos)
        throw Error(film.string(), "", "an ffmpeg with the encoder " + encoder,
                    "one without it; -o " + pictures + " writes numbered pictures");
}

bool film_is_padded(const FilmRequest& request) {
    return film_format_of(request.output)->subsampled &&
           (request.width % 2 != 0 || request.height % 2 != 0);
}

void make_film(const FilmRequest& request, const Progress& progress) {
    const FilmFormat& format = *film_format_of(request.output);
    write_file_whole(request.output, [&](const fs::path& temporary) {
        double done = 0;
        progress.step("film", done);
        const auto result =
            run_program(words_of(request, format, temporary), [&](std::string_view printed) {
                if (const auto frame = frame_in(printed))
                    done = static_cast<double>(*frame) / static_cast<double>(request.count);
                progress.step("film", done);
            });
        progress.throw_if_cancelled();
        if (result && result->exit_code == 0) return;
        std::string said = result ? result->messages.substr(0, result->messages.find('\n')) : "";
        if (said.empty()) said = result ? fmt::format("exit code {}", result->exit_code) : "none";
        throw Error(request.output.string(), "", "a film made by ffmpeg",
                    fmt::format("{}; the pictures stay in {}", shown(one_line(said)),
                                film_pictures(request.output).parent_path().string()));
    });
}

void remove_film_pictures(const FilmRequest& request) {
    const fs::path pictures = film_pictures(request.output);
    std::error_code error;
    for (int i = 0; i < request.count; ++i)
        fs::remove(numbered(pictures, request.first + i), error);
    fs::remove(pictures.parent_path(), error);
}

}  // namespace burnish
