#include "report.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <thread>

namespace burnish::bench {

namespace {

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    const double place = share * static_cast<double>(values.size() - 1);
    const auto low = static_cast<std::size_t>(place);
    const std::size_t high = std::min(low + 1, values.size() - 1);
    return values[low] + (place - static_cast<double>(low)) * (values[high] - values[low]);
}

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

}  // namespace

double median(std::vector<double> values) {
    return quantile(std::move(values), 0.5);
}

double half_quartile_distance(std::vector<double> values) {
    return 0.5 * (quantile(values, 0.75) - quantile(values, 0.25));
}

std::string to_markdown(const Report& report) {
    std::string text = fmt::format(
        "# Budgets and what was reached\n\n{:%Y-%m-%d}, {}, {} threads; GL: {}\n\n"
        "Ratios are medians over interleaved pairs of one run; the spread is half the distance "
        "between the quartiles.\n\n"
        "| work | budget | reached | spread | |\n|---|---|---|---|---|\n",
        fmt::localtime(std::time(nullptr)), processor(), std::thread::hardware_concurrency(),
        report.device);
    for (const Row& row : report.rows) {
        const std::string budget =
            row.budget > 0 ? fmt::format("<= {:.2f} {}", row.budget, row.unit) : "reported";
        const std::string verdict = row.budget <= 0             ? ""
                                    : row.reached <= row.budget ? "met"
                                                                : "**missed**";
        text += fmt::format("| {} | {} | {:.3f} {} | {:.3f} | {} |\n", row.work, budget,
                            row.reached, row.unit, row.spread, verdict);
    }
    return text;
}

}  // namespace burnish::bench
