// The flags that `mdf plot` and `brdf plot` share.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "jobs/models/plot.hpp"

namespace CLI {
class App;
}

namespace burnish::cli {

class Session;

// Parse comma-separated lists. They throw UsageError naming the flag, expected and found values.
std::vector<std::string> words_of(const std::string& list);
std::vector<int> indices_of(const std::string& list, std::span<const std::string_view> names,
                            std::string_view kind, const std::string& flag);
std::vector<double> numbers_of(const std::string& list, const std::string& flag, double low,
                               double high);
double number_of(const std::string& text, const std::string& flag, double low, double high);

// -o, --panel, --pixel-ratio.
struct OutputFlags {
    std::string path;
    std::string panel, pixel_ratio;
};
void add_output_flags(CLI::App& command, OutputFlags& flags);
PlotOutput output_of(const OutputFlags& flags, const Session& session);

// The names as text: "disk, grid or profile".
std::string listed(std::span<const std::string_view> names);

// Add the subcommands `plot`.
void add_mdf_plot_command(CLI::App& mdf, Session& session);
void add_brdf_plot_command(CLI::App& brdf, Session& session);

}  // namespace burnish::cli
