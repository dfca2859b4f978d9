// Adding computed columns to a table, row by row, in parallel and in bounded memory. The table
// itself keeps every byte: comments, blank lines, quotes, line ends, columns that no task reads.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/progress.hpp"
#include "core/csv.hpp"

namespace burnish {

// The places of the columns that a task reads, in one table.
struct CsvLayout {
    struct Column {
        std::string_view name;
        std::size_t place;  // kAbsent for an optional column that the table does not have
    };
    static constexpr std::size_t kAbsent = static_cast<std::size_t>(-1);

    std::string file;  // for messages
    std::vector<Column> columns;
    std::size_t field_count = 0;
};

// One row as an evaluator sees it. `column` counts through CsvTask::required and on through
// CsvTask::optional. What cannot be taken throws Error "<file>: line 12, column nx: expected ...,
// found ...".
class CsvRow {
  public:
    CsvRow(const CsvLayout& layout, const CsvRecord& record,
           std::span<const std::string_view> fields)
        : layout_(&layout), record_(&record), fields_(fields) {}

    // Empty when the column is absent.
    std::string_view text(std::size_t column) const;

    // A finite number; float is rounded once, from the decimal text.
    template <typename Float>
    Float number(std::size_t column) const;

    // The index of the text in `names`. For an unknown text the error suggests the nearest name.
    std::size_t choice(std::size_t column, std::span<const std::string_view> names) const;

    [[noreturn]] void fail(std::size_t column, std::string_view expected,
                           std::string_view found) const;

    std::size_t line() const { return record_->line; }

  private:
    const CsvLayout* layout_;
    const CsvRecord* record_;
    std::span<const std::string_view> fields_;
};

struct CsvTask {
    std::span<const std::string_view> required;
    std::span<const std::string_view> optional;
    std::span<const std::string_view> adds;
    // Appends ",value" for each of `adds` to added[i], which belongs to rows[i]; for many rows at
    // once, so that they can be computed together, and from several threads at once. Throws for the
    // first bad row.
    std::function<void(std::span<const CsvRow> rows, std::span<std::string> added)> evaluate;
};

// Calls `visit` for every row of a table in turn, and adds nothing. "-" is the standard input.
// `columns`: those that the table must have; CsvRow counts through them.
void read_csv_rows(const std::string& input, std::span<const std::string_view> columns,
                   const std::function<void(const CsvRow&)>& visit, const Progress& progress);

// "-" is the standard input or output; any other output is written whole or not at all and may be
// the input itself. Of several bad rows the first one is reported.
void add_csv_columns(const std::string& input, const std::string& output, const CsvTask& task,
                     const Progress& progress);

}  // namespace burnish
