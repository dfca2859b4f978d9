#include "jobs/trace_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <set>
#include <utility>

#include "burnish/display.hpp"
#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/files.hpp"

namespace burnish {

std::map<std::string, std::string> words_of(const TraceRequest& request, const Stage& stage) {
    std::map<std::string, std::string> words = picture_metadata(request.command, stage);
    const WriteOptions options = write_options(stage.values);
    words["exposure_ev"] = fmt::format("{}", stage.exposure_ev);
    words["tone_map"] = fmt::format("{}", static_cast<int>(stage.tone_map));
    words["bits"] = fmt::format("{}", options.bits);
    words["dither"] = options.dither ? "1" : "0";
    return words;
}

void write_layers(const std::filesystem::path& path, const TraceSums& sums,
                  const Metadata& metadata) {
    std::vector<ImagePart> parts = sums.parts();
    for (const auto& [name, value] : metadata) parts.front().texts[name] = value;
    write_image_parts(path, parts);
}

}  // namespace burnish
