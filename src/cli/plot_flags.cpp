#include "cli/plot_flags.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "burnish/error.hpp"
#include "cli/session.hpp"
#include "core/text.hpp"

namespace burnish::cli {

std::vector<std::string> words_of(const std::string& list) {
    std::vector<std::string> words;
    for (std::size_t start = 0; start <= list.size();) {
        const std::size_t comma = std::min(list.find(',', start), list.size());
        words.push_back(list.substr(start, comma - start));
        start = comma + 1;
    }
    return words;
}

std::vector<int> indices_of(const std::string& list, std::span<const std::string_view> names,
                            std::string_view kind, const std::string& flag) {
    std::vector<int> indices;
    for (const std::string& word : words_of(list))
        indices.push_back(index_of_name(names, word, kind, flag));
    return indices;
}

double number_of(const std::string& text, const std::string& flag, double low, double high) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, status] = std::from_chars(text.data(), end, value);
    // Written so that NaN is refused.
    if (status != std::errc{} || stop != end || !(value >= low && value <= high))
        throw UsageError(flag, "", fmt::format("a number from {:.10g} to {:.10g}", low, high),
                         shown(text));
    return value;
}

std::vector<double> numbers_of(const std::string& list, const std::string& flag, double low,
                               double high) {
    std::vector<double> numbers;
    for (const std::string& word : words_of(list))
        numbers.push_back(number_of(word, flag, low, high));
    return numbers;
}

void add_output_flags(CLI::App& command, OutputFlags& flags) {
    command.add_option("-o,--output", flags.path, "picture to write: .png or .svg")
        ->required()
        ->type_name("FILE");
    command.add_option("--panel", flags.panel, "width of a panel [px] (100 to 4000)")
        ->type_name("NUMBER");
    command
        .add_option("--pixel-ratio", flags.pixel_ratio,
                    "of .png: pixels for each px of the page (0.5 to 8; default 2)")
        ->type_name("NUMBER");
}

PlotOutput output_of(const OutputFlags& flags, const Session& session) {
    PlotOutput output;
    output.path = flags.path;
    output.command = session.command_line();
    if (!flags.panel.empty()) output.panel_px = number_of(flags.panel, "--panel", 100, 4000);
    if (!flags.pixel_ratio.empty())
        output.pixel_ratio = number_of(flags.pixel_ratio, "--pixel-ratio", 0.5, 8);
    return output;
}

std::string listed(std::span<const std::string_view> names) {
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace burnish::cli
