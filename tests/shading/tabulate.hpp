// The parts of docs/evidence/correctness.md, as text.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace burnish::test {

// A table in Markdown: `cell(row, column)` for each, computed on all cores.
std::string markdown_table(const std::string& corner, const std::vector<std::string>& columns,
                           const std::vector<std::string>& rows,
                           const std::function<std::string(std::size_t, std::size_t)>& cell);

std::string method_tables();  // every distribution under every method
std::string brdf_tables();    // every reflection model

}  // namespace burnish::test
