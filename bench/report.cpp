#include "report.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <thread>

#include "core/machine.hpp"

namespace burnish::bench {

std::string to_markdown(const Report& report) {
    std::string text = fmt::format(
        "# Budgets and what was reached\n\n{:%Y-%m-%d}, {}, {} threads; GL: {}\n\n"
        "Ratios are medians over interleaved pairs of one run; the spread is half the distance "
        "between the quartiles.\n\n"
        "| work | budget | reached | spread | |\n|---|---|---|---|---|\n",
        fmt::localtime(std::time(nullptr)), processor_name(), std::thread::hardware_concurrency(),
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
